# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangle meshes of formulas, Bezier and NURBS patches, and CAD files.

    import parametric_surface_mesher as psm

    mesh = psm.mesh_surface("u, v, exp(-5*(u*u + v*v))", ((-1, 1), (-1, 1)))    # a formula
    mesh = psm.mesh_surface(my_function, ((0, 1), (0, 1)), max_edge=0.1)        # a function, with NumPy
    mesh = psm.mesh_cad("part.step")                                            # a CAD file
    mesh.points, mesh.triangles, mesh.report                                    # arrays, and what was met
    mesh.save("part.msh"); mesh.plot()                                          # for solvers; for the eye

Triangles have angles of at least 30 degrees, in practice 38 on most surfaces; the boundary, and what patches share, is divided once, so
that meshes fit together; what could not be met is in ``mesh.report``. Where to read on: ``help(psm.mesh_surface)``,
``help(psm.mesh_cad)``, ``help(psm.Mesh)``, ``help(psm.Surface)``, ``help(psm.Model)``.
"""
import importlib.util as _util

if _util.find_spec(__name__ + "._core") is None:
    import pathlib as _pathlib
    import sys as _sys
    _built = ", ".join(path.name for path in _pathlib.Path(__file__).parent.glob("_core.*.so")) or "none"
    raise ImportError(f"{_sys.executable} finds no compiled part of parametric_surface_mesher that fits it (there is: {_built}); start the "
                      "Python that it was built for, or build it with -DPython3_EXECUTABLE=... for this one")

from . import _core
from ._errors import MeshingError
from ._formula import FormulaError
from ._mesh import Group, Mesh, MeshingInterrupted
from ._model import Model, mesh_patches, mesh_surface
from ._surfaces import Curve, Surface, read_bezier_patches

__all__ = ["Curve", "FormulaError", "Group", "Mesh", "MeshingError", "MeshingInterrupted", "Model", "Surface", "mesh_patches",
           "mesh_surface", "read_bezier_patches"]

if hasattr(_core, "mesh_cad"):
    from ._cad import mesh_cad
    __all__.append("mesh_cad")
else:
    def mesh_cad(*arguments, **options):  # type: ignore[misc]
        """Would mesh a CAD file, but the module was built without Open CASCADE."""
        raise MeshingError("the module was built without Open CASCADE, so that it cannot read CAD files; install that (Debian: "
                           "libocct-data-exchange-dev), configure and build again")
