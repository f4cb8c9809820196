# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The mesh that all functions return."""
from __future__ import annotations

import contextlib
import html
import json
import os
import tempfile
from typing import Any, Dict, List, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._errors import MeshingError, renamed, sentences


class Group(NamedTuple):
    """What is called by one name: vertices (dimension 0), edges (1), faces (2) or parts (3), by their numbers from 1."""

    dimension: int
    numbers: np.ndarray


class Mesh:
    """A triangle mesh of surfaces, as NumPy arrays, with what is known about it.

    ``points``       coordinates, of shape (n, 3)
    ``triangles``    three indices of points each, (m, 3), counterclockwise seen from outside
    ``face_ids``     for each triangle the number, from 1, of the face that it lies on
    ``part_ids``     for each triangle the number of its part in an assembly, from 1; 0 if it has none
    ``uv``           the parameters of the corners of each triangle on the surface of its face, (m, 3, 2)
    ``edges``        those sides of triangles that lie on edges of the model, (k, 2)
    ``edge_ids``     for each of these the number of that edge, from 1
    ``groups``       what the file has names for: a dict of ``Group``; see also ``triangles_of()``
    ``report``       what meshing did, and what it could not do, as plain data

    ``save()`` writes files for solvers, viewers and printers, ``plot()`` shows the mesh.
    """

    def __init__(self, core: Any, notes: Optional[Dict[str, Any]] = None):
        self._core = core
        arrays = core.arrays()
        self.points: np.ndarray = arrays["points"]
        self.triangles: np.ndarray = arrays["triangles"]
        self.face_ids: np.ndarray = arrays["face_ids"]
        self.part_ids: np.ndarray = arrays["part_ids"]
        self.uv: np.ndarray = arrays["uv"]
        self.edges: np.ndarray = arrays["edges"]
        self.edge_ids: np.ndarray = arrays["edge_ids"]
        self.groups: Dict[str, Group] = {name: Group(dimension, numbers) for name, dimension, numbers in arrays["groups"]}
        self.report: Dict[str, Any] = json.loads(core.json())
        self.report.update(notes or {})

    @classmethod
    def _finished(cls, core: Any, notes: Dict[str, Any], is_interrupted: bool) -> "Mesh":
        mesh = cls(core, notes)
        if is_interrupted:
            raise MeshingInterrupted(mesh)
        return mesh

    def __len__(self) -> int:
        """The number of triangles."""
        return len(self.triangles)

    def __repr__(self) -> str:
        state = "closed" if self.report["closed"] else "open"
        stopped = ", stopped before it was done" if self.report["stopped"] else ""
        return (f"<Mesh: {len(self.points)} points, {len(self.triangles)} triangles, {state}, smallest angle "
                f"{self.report['min_angle']:.1f} degrees{stopped}>")

    @property
    def is_whole(self) -> bool:
        """Whether nothing is wrong with the mesh: what is wrong is marked so in ``summary()``."""
        return self._core.is_whole

    @property
    def _is_of_cad_file(self) -> bool:
        return isinstance(self._core, getattr(_core, "MeshedCadFile", ()))

    @property
    def names(self) -> Dict[str, Dict[int, str]]:
        """The names in the CAD file of ``"parts"``, ``"solids"``, ``"faces"``, ``"edges"`` and ``"vertices"``, by their numbers from 1."""
        result: Dict[str, Dict[int, str]] = {
            "parts": {part["number"]: part["instance"] or part["name"] for part in self.report.get("parts", [])}}
        for kind, key in (("solids", "solid_names"), ("faces", "face_names"), ("edges", "edge_names"), ("vertices", "vertex_names")):
            result[kind] = {int(number): name for number, name in self.report.get(key, {}).items()}
        return result

    def triangles_of(self, group: Union[str, int]) -> np.ndarray:
        """The indices of the triangles of a face, by its number, or of a group of faces or parts, by its name."""
        if isinstance(group, (int, np.integer)):
            return np.flatnonzero(self.face_ids == group)
        if group not in self.groups:
            known = ", ".join(sorted(self.groups)) or "none"
            raise KeyError(f"there is no group '{group}'; there are: {known}")
        dimension, numbers = self.groups[group]
        if dimension < 2:
            raise ValueError(f"'{group}' is a group of {'edges' if dimension == 1 else 'vertices'}, which have no triangles")
        return np.flatnonzero(np.isin(self.face_ids if dimension == 2 else self.part_ids, numbers))

    def angles(self) -> np.ndarray:
        """The three angles of each triangle, in degrees, of shape (m, 3)."""
        corners = self.points[self.triangles]
        result = np.empty(self.triangles.shape)
        for i in range(3):
            a, b = corners[:, (i + 1) % 3] - corners[:, i], corners[:, (i + 2) % 3] - corners[:, i]
            cross = np.linalg.norm(np.cross(a, b), axis=1)
            result[:, i] = np.degrees(np.arctan2(cross, np.einsum("ij,ij->i", a, b)))
        return result

    def save(self, path: Union[str, "os.PathLike[str]"], *, binary: bool = False, node_parameters: bool = False) -> None:
        """Writes the mesh into a file, whose ending tells the format.

        For solvers, with groups and names: ``.msh`` (Gmsh 4.1; ``.msh2``: 2.2), ``.inp`` (Abaqus, CalculiX), ``.bdf`` (Nastran),
        ``.unv``, ``.vtu`` (ParaView), and of CAD files ``.med``, if that was built. For viewers and printers: ``.stl``,
        ``.ply``, ``.off``, ``.obj``, and of CAD files ``.glb``, ``.3mf``, if that was built, and ``.brep`` as ``brep()`` does. For
        browsers: ``.html``, the page of ``page()``. ``binary`` is for ``.stl``, ``.ply`` and ``.off``; ``node_parameters`` writes where on
        the CAD model nodes lie, into ``.msh`` and ``.vtu``. The file appears when it is complete.
        """
        if os.fspath(path).lower().endswith(".html"):
            _write_whole(os.fspath(path), self.page())
            return
        with sentences():
            if self._is_of_cad_file:
                self._core.save(os.fspath(path), binary, node_parameters)
            elif node_parameters:
                raise ValueError("node_parameters: only meshes of CAD files have them")
            else:
                self._core.save(os.fspath(path), binary)

    def brep(self) -> bytes:
        """The shape of a CAD file in Open CASCADE's format, in millimetres, with this mesh as its triangulation.

        So its writers of STL and glTF, and viewers, take this mesh in place of their own:
        ``cadquery.Shape.importBrep(io.BytesIO(mesh.brep()))``.
        """
        if not self._is_of_cad_file:
            raise MeshingError("brep: this mesh has no shape of Open CASCADE; only meshes of mesh_cad() have one")
        with tempfile.TemporaryDirectory(prefix="mesh_cad_") as folder:
            path = os.path.join(folder, "shape.brep")
            self.save(path)
            with open(path, "rb") as file:
                return file.read()

    def summary(self) -> str:
        """A few lines for people: what the mesh is like, what is wrong with it, and what is good to know."""
        return renamed(self._core.summary())

    def plot(self, color_by: Optional[str] = None, *, show: bool = True, **options: Any) -> Any:
        """Shows the mesh with PyVista or, if that is not installed, with Matplotlib; returns the plotter or the axes.

        ``color_by`` is ``"face"``, ``"part"`` or ``"angle"`` (the smallest angle of each triangle). ``show=False`` only makes the picture.
        Other arguments go to ``add_mesh()`` of PyVista, or ``plot_trisurf()`` of Matplotlib.
        """
        from . import _plot
        return _plot.plot(self, color_by, show, options)

    def to_pyvista(self) -> Any:
        """The mesh as ``pyvista.PolyData``, with the numbers of faces and parts as data of its cells."""
        from . import _plot
        return _plot.to_pyvista(self)

    def page(self) -> str:
        """A page to look at in a browser, as HTML: the mesh can be turned and cut, and shows what was not met.

        ``save("part.html")`` writes it.
        """
        with sentences():
            return self._core.page()

    def _repr_html_(self) -> str:
        """What a notebook shows: the page, if there is one, else a table."""
        try:
            page = self.page()
        except MeshingError:
            return self._table()
        return f"<iframe srcdoc=\"{html.escape(page)}\" style=\"width: 100%; height: 600px; border: 0\"></iframe>"

    def _table(self) -> str:
        distance = self.report["distance"]
        rows: List[tuple] = [
            ("points", len(self.points)), ("triangles", len(self.triangles)), ("faces", len(np.unique(self.face_ids))),
            ("closed", "yes" if self.report["closed"] else "no"), ("smallest angle", f"{self.report['min_angle']:.1f}°"),
            ("mean of smallest angles", f"{self.report['mean_min_angle']:.1f}°"),
            ("distance from the surfaces", "not measured" if distance is None else f"{distance:.3g}"),
            ("triangles that do not meet all criteria", sum(unmet["triangles"] for unmet in self.report["unmet_by"]))]
        if self.report["stopped"]:
            rows.append(("stopped", "before it was done"))
        cells = "".join(f"<tr><th style='text-align:left'>{html.escape(str(name))}</th><td>{html.escape(str(value))}</td></tr>"
                        for name, value in rows)
        return f"<table>{cells}</table>"


class MeshingInterrupted(KeyboardInterrupt):
    """Meshing was interrupted by Ctrl-C. ``mesh`` is the mesh of that moment: valid, but not as fine as was asked for.

    At the prompt of Python the exception is in ``sys.last_value``, so that ``sys.last_value.mesh`` is that mesh.
    """

    def __init__(self, mesh: Mesh):
        super().__init__("meshing was interrupted; the attribute 'mesh' of this exception (sys.last_value.mesh) is the valid mesh so far: "
                         f"{mesh!r}")
        self.mesh = mesh


def _write_whole(path: str, text: str) -> None:
    """Writes a file that appears when it is complete."""
    unfinished = path + ".part"
    try:
        with open(unfinished, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(unfinished, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            os.remove(unfinished)
        raise MeshingError(f"cannot write {path}: {error.strerror}") from None
