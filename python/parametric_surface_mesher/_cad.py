# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of CAD files, and of shapes of other Python libraries."""
from __future__ import annotations

import io
import numbers
import os
import tempfile
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._errors import ONLY_OF_PROGRAM, MeshingError
from ._mesh import Mesh
from ._watching import Progress, Size, run, size_for_core

# Options that the program takes several times.
_REPEATED = ("parts", "sphere-size", "local-size", "point")


def mesh_cad(source: Any, *, fineness: Optional[str] = None, max_edge: Optional[float] = None, min_edge: Optional[float] = None,
             gamma: Optional[float] = None, elements_per_turn: Optional[float] = None, distance: Optional[float] = None,
             relative_distance: Optional[float] = None, angle: Optional[float] = None, size: Optional[Size] = None,
             growth: Optional[float] = None, face_size: Optional[Mapping[Union[int, str], float]] = None,
             edge_size: Optional[Mapping[Union[int, str], float]] = None, local_size: Union[None, str, Sequence[str]] = None,
             parts: Union[None, str, int, Sequence[Union[str, int]]] = None,
             faces: Union[None, str, Iterable[Union[int, str]]] = None, unit: Optional[str] = None, order: Optional[int] = None,
             conformal: bool = False, threads: Optional[int] = None, progress: Optional[Progress] = None,
             time_limit: Optional[float] = None, **options: Any) -> Mesh:
    arguments: Dict[str, Any] = dict(
        fineness=fineness, max_edge=max_edge, min_edge=min_edge, gamma=gamma, elements_per_turn=elements_per_turn, distance=distance,
        relative_distance=relative_distance, angle=angle, growth=growth, face_size=face_size, edge_size=edge_size, local_size=local_size,
        parts=parts, faces=faces, unit=unit, order=order, conformal=conformal, threads=threads, **options)
    words = _words(arguments)
    size_in_core = size_for_core(size)
    with tempfile.TemporaryDirectory(prefix="mesh_cad_") as folder:
        path = _file_of(source, folder)
        try:
            core, is_interrupted = run(_core.mesh_cad, [*words, "--", path], progress, size_in_core, time_limit)
        except MeshingError as error:
            # The user does not know the file that was written for bytes or a shape.
            raise MeshingError(str(error).replace(os.path.join(folder, ""), "the given ")) from None
    return Mesh._finished(core, {}, is_interrupted)


_DOCUMENTATION = """Meshes a CAD file, or a shape of CadQuery, build123d, FreeCAD or pythonOCC.

    >>> import parametric_surface_mesher as psm
    >>> mesh = psm.mesh_cad("part.step")                     # doctest: +SKIP
    >>> mesh = psm.mesh_cad("part.step", max_edge=2, fineness="coarse", face_size={{3: 0.5}})   # doctest: +SKIP
    >>> mesh.save("part.inp")                                # doctest: +SKIP

    ``source`` is one of these:

    - the path of a STEP, IGES or BREP file;
    - the contents of such a file, as ``bytes``;
    - a shape, ``Workplane`` or ``Assembly`` of CadQuery, a shape of build123d or FreeCAD, or a ``TopoDS_Shape`` of pythonOCC or OCP.

    It needs no options: sizes follow from the model's extent and curvature. Lengths are in millimetres, or in ``unit``.

    size
        The wanted edge length at a point: a function of (x, y, z), or a text such as ``"0.1 + 0.2*sqrt(x*x + y*y)"``.
    progress
        A function that is called with the name of the phase and a number of vertices; if it returns ``False`` meshing stops.
    time_limit
        Seconds after which meshing stops. A mesh that was stopped is valid; ``mesh.report["stopped"]`` tells.

    The other arguments are the options of the program ``mesh_cad``, with underscores. Lists and dicts stand for the lists of the
    program: ``faces=[1, 4, 7]``, ``face_size={{3: 0.5}}``, ``parts=["bolt", 2]``, ``local_size=["point:0,0,5:0.1"]``,
    ``point=[(0, 0, 5)]``.

{options}

    Returns a ``Mesh``. ``mesh.report`` has what ``--json`` writes, ``mesh.summary()`` what the program prints; ``mesh.is_whole``
    tells whether nothing is wrong with the mesh. A face that cannot be meshed is left out, and in ``mesh.report["left_out"]``.
    Input that cannot be read or meshed raises ``MeshingError``. Ctrl-C raises ``MeshingInterrupted``,
    a ``KeyboardInterrupt`` whose ``mesh`` is the valid mesh of that moment.
    """


def _described_options() -> str:
    import textwrap
    lines: List[str] = []
    for name, description in _core.cad_options():
        if name not in ONLY_OF_PROGRAM:
            lines.append("    " + name.replace("-", "_"))
            lines += textwrap.wrap(description.replace("--", ""), 110, initial_indent="        ", subsequent_indent="        ")
    return "\n".join(lines)


mesh_cad.__doc__ = _DOCUMENTATION.format(options=_described_options())


def _words(arguments: Mapping[str, Any]) -> List[str]:
    """Arguments as options of the program."""
    result: List[str] = []
    known = {name for name, _ in _core.cad_options()}
    for name, value in arguments.items():
        option = name.replace("_", "-")
        if value is None or (value is False and option in known):
            continue
        if option not in known or option in ONLY_OF_PROGRAM:
            raise TypeError(f"mesh_cad() has no argument '{name}'; help(mesh_cad) lists them")
        if isinstance(value, (list, tuple, Mapping)) and len(value) == 0:
            raise ValueError(f"{name}: it is empty; leave it out, or give at least one entry")
        if value is True:
            result.append(f"--{option}")
        elif option in _REPEATED:
            result += [f"--{option}={_text(item)}" for item in _items(value)]
        else:
            result.append(f"--{option}={_text(value)}")
    return result


def _items(value: Any) -> List[Any]:
    """The items of a list; a text, a number and the coordinates of a point are one item."""
    if isinstance(value, str) or not isinstance(value, Iterable) or all(isinstance(item, numbers.Number) for item in value):
        return [value]
    return list(value)


def _text(value: Any) -> str:
    if isinstance(value, Mapping):
        return ",".join(f"{number}:{float(length)!r}" for number, length in value.items())
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, str) or not isinstance(value, Iterable):
        return str(value)
    return ",".join(str(item) for item in value)


def _file_of(source: Any, folder: str) -> str:
    """The path of a file with the shape, which is written into `folder` if there is none."""
    if isinstance(source, (str, os.PathLike)):
        return os.fspath(source)
    data = bytes(source) if isinstance(source, (bytes, bytearray, memoryview)) else _brep_of(source)
    path = os.path.join(folder, "shape" + _ending_of(data))
    with open(path, "wb") as file:
        file.write(data)
    return path


def _ending_of(data: bytes) -> str:
    begin = data[:200].lstrip()
    if begin.startswith(b"ISO-10303-21"):
        return ".step"
    if begin.startswith((b"DBRep_DrawableShape", b"CASCADE Topology")):
        return ".brep"
    if len(data) > 80 and data[72:73] in b"SC" and data[73:80].strip().isdigit():
        return ".iges"
    raise MeshingError("the bytes are neither a STEP, an IGES nor a BREP file: the first ones are " + repr(data[:20]))


def _brep_of(shape: Any) -> bytes:
    """A shape of another library in Open CASCADE's format."""
    if hasattr(shape, "toCompound"):  # an assembly of CadQuery
        shape = shape.toCompound()
    elif hasattr(shape, "vals") and callable(shape.vals):  # a workplane of CadQuery
        shapes = [value for value in shape.vals() if hasattr(value, "exportBrep")]
        if not shapes:
            raise MeshingError("the workplane has no shape")
        if len(shapes) > 1:
            from cadquery import Compound  # type: ignore
            shape = Compound.makeCompound(shapes)
        else:
            shape = shapes[0]
    if hasattr(shape, "exportBrep"):
        stream = io.BytesIO()
        shape.exportBrep(stream)
        return stream.getvalue()
    if hasattr(shape, "exportBrepToString"):  # a shape of FreeCAD
        return shape.exportBrepToString().encode()
    return _brep_of_open_cascade(getattr(shape, "wrapped", shape))


def _brep_of_open_cascade(shape: Any) -> bytes:
    module = type(shape).__module__
    if module.startswith("OCP"):
        from OCP.BRepTools import BRepTools  # type: ignore
        stream = io.BytesIO()
        BRepTools.Write_s(shape, stream)
        return stream.getvalue()
    if module.startswith("OCC."):
        from OCC.Core.BRepTools import breptools  # type: ignore
        return breptools.WriteToString(shape).encode()
    raise TypeError(f"{type(shape).__name__} is neither a path, the bytes of a file, nor a shape of CadQuery, build123d, FreeCAD or "
                    "pythonOCC")
