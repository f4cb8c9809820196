# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of several faces, and the functions that mesh surfaces."""
from __future__ import annotations

from typing import Any, Callable, List, Optional, Sequence, Tuple

import numpy as np

from . import _core
from ._errors import sentences
from ._mesh import Mesh
from ._surfaces import Curve, LoopLike, Point2, Range, Surface, SurfaceLike, checked_rectangle, point2
from ._watching import Progress, Size, run, size_for_core


class Model:
    """Faces that share edges: surfaces with loops of edges, which are divided once, so that the meshes of faces fit together.

    Most models come from ``Model.joined()``. Others are made by hand, of vertices, edges between them, and faces, whose loops tell for each
    edge its curve in the domain of the face. All uses of an edge give the same point of space at the same parameter of their curves.

    >>> model = Model()
    >>> below, above = model.add_vertex((1, 0, 0)), model.add_vertex((1, 0, 1.5))
    >>> bottom, top, seam = model.add_edge(below, below), model.add_edge(above, above), model.add_edge(below, above)
    >>> turn = 2*np.pi
    >>> side = model.add_face("cos(u), sin(u), v", [[
    ...     (bottom, Curve.segment((0, 0), (turn, 0))), (seam, Curve.segment((turn, 0), (turn, 1.5))),
    ...     (top, Curve.segment((0, 1.5), (turn, 1.5)), "reversed"), (seam, Curve.segment((0, 0), (0, 1.5)), "reversed")]])
    >>> lid = model.add_face("u, v, 1.5", [[(top, Curve("cos(2*pi*t), sin(2*pi*t)", 0, 1))]])
    >>> mesh = model.mesh(max_edge=0.2)
    """

    def __init__(self) -> None:
        self._core = _core.SurfaceModel()
        self._kinds: List[str] = []

    @classmethod
    def joined(cls, surfaces: Sequence[SurfaceLike], domains: Optional[Sequence[Tuple[Range, Range]]] = None,
               tolerance: float = 0) -> "Model":
        """The model of surfaces over rectangles.

        Sides that are the same curve in space become one edge, so that the mesh has no crack there.
        ``domains`` has the rectangle of each surface; it is not needed for surfaces that have one, such as Bezier patches. Two
        sides of one surface may be the same, too: it is closed then, like a torus. ``tolerance`` is how far apart points may be
        that are to be one; by default 1e-9 of the diagonal.
        """
        if len(surfaces) == 0:
            raise ValueError("the list of surfaces is empty")
        if domains is not None and len(domains) != len(surfaces):
            raise ValueError(f"there are {len(surfaces)} surfaces, but {len(domains)} domains: give a pair of ranges for each surface")
        made = [_surface(surface, None if domains is None else domains[i]) for i, surface in enumerate(surfaces)]
        rectangles = []
        for i, surface in enumerate(made):
            domain = surface.domain if domains is None else domains[i]
            if domain is None:
                raise ValueError(f"surface {i + 1} has no domain: give 'domains', a pair of ranges for each surface")
            (u_min, u_max), (v_min, v_max) = checked_rectangle(domain)
            rectangles.append([u_min, u_max, v_min, v_max])
        result = cls.__new__(cls)
        with sentences():
            result._core = _core.SurfaceModel.joined([surface._core for surface in made], rectangles, tolerance)
        result._kinds = [surface.how for surface in made]
        return result

    @classmethod
    def patch(cls, surface: SurfaceLike, boundary: LoopLike, holes: Sequence[LoopLike] = ()) -> "Model":
        """The model of one surface, over the domain inside a loop, without the holes."""
        made = _surface(surface, None)
        _check_holes(holes)
        result = cls.__new__(cls)
        with sentences():
            result._core = _core.SurfaceModel.patch(made._core, [_loop(loop) for loop in (boundary, *holes)])
        result._kinds = [made.how]
        return result

    def add_vertex(self, point: Sequence[float]) -> int:
        """Adds a point in space; returns its index."""
        try:
            x, y, z = point
            return self._core.add_vertex([float(x), float(y), float(z)])
        except (TypeError, ValueError):
            raise ValueError(f"a vertex is a point (x, y, z), three numbers, not {point!r}") from None

    def add_edge(self, source: int, target: int, *, collapsed: bool = False, max_edge: float = 0) -> int:
        """Adds an edge between two vertices; returns its index. A collapsed one is a point, such as a pole."""
        _check_index(source, "the source of an edge", "add_vertex()")
        _check_index(target, "the target of an edge", "add_vertex()")
        with sentences():
            return self._core.add_edge(source, target, collapsed, max_edge)

    def add_face(self, surface: SurfaceLike, loops: Sequence[Sequence[tuple]], *, reversed: bool = False, max_edge: float = 0) -> int:
        """Adds a face; returns its index.

        Each loop is a list of pairs ``(edge, curve)``, or ``(edge, curve, "reversed")`` where the loop runs from the end of the
        edge to its beginning. The outer loop comes first. Faces are turned with ``orient()``, or by ``reversed``.
        """
        made = _surface(surface, None)
        uses: List[List[Tuple[int, bool, _core.Curve]]] = []
        for loop in loops:
            uses.append([])
            for use in loop:
                if (not isinstance(use, (tuple, list)) or len(use) not in (2, 3) or not isinstance(use[1], Curve)
                        or (len(use) == 3 and use[2] not in ("reversed", "forward"))):
                    raise ValueError("loops are lists of (edge, curve) or (edge, curve, 'reversed'), with a Curve in the domain of the "
                                     f"face, not of {use!r}")
                _check_index(use[0], "an edge of a loop", "add_edge()")
                uses[-1].append((use[0], len(use) == 3 and use[2] == "reversed", use[1]._core))
        self._kinds.append(made.how)
        return self._core.add_face(made._core, uses, reversed, max_edge)

    def add_hole(self, face: int, loop: LoopLike) -> None:
        """Cuts a hole into a face."""
        with sentences():
            self._core.add_hole(face, _loop(loop))

    def orient(self) -> None:
        """Turns faces so that neighbours face to the same side, and closed models outward."""
        with sentences():
            self._core.orient_faces()

    def set_tolerance(self, tolerance: float) -> None:
        """Sets how far apart in space the uses of an edge may be."""
        with sentences():
            self._core.set_tolerance(tolerance)

    @property
    def number_of_vertices(self) -> int:
        return self._core.numbers[0]

    @property
    def number_of_edges(self) -> int:
        return self._core.numbers[1]

    @property
    def number_of_faces(self) -> int:
        return self._core.numbers[2]

    def mesh(self, *, size: Optional[Size] = None, progress: Optional[Progress] = None, time_limit: Optional[float] = None,
             **criteria: Any) -> Mesh:
        """Meshes the model. The arguments are those of ``mesh_surface()``, from ``max_edge`` on."""
        core, is_interrupted = run(self._core.mesh, _criteria(criteria), progress, size_for_core(size), time_limit)
        kinds = sorted(set(self._kinds))
        return Mesh._finished(core, {"surfaces": kinds}, is_interrupted)

    def __repr__(self) -> str:
        return f"<Model: {self.number_of_faces} faces, {self.number_of_edges} edges, {self.number_of_vertices} vertices>"


def mesh_surface(surface: SurfaceLike, domain: Any = None, *, holes: Sequence[LoopLike] = (),
                 derivatives: Optional[Callable[..., Any]] = None, closed: Optional[bool] = None,
                 max_edge: Optional[float] = None, min_edge: Optional[float] = None, gamma: Optional[float] = None,
                 distance: Optional[float] = None, angle: Optional[float] = None, size: Optional[Size] = None,
                 growth: Optional[float] = None, closeness: Optional[float] = None, size_factor: Optional[float] = None,
                 sweeps: Optional[int] = None, self_intersections: str = "ignore", threads: int = 1,
                 progress: Optional[Progress] = None, time_limit: Optional[float] = None) -> Mesh:
    """Meshes a surface over a part of its domain.

    >>> import parametric_surface_mesher as psm
    >>> mesh = psm.mesh_surface("u, v, exp(-5*(u*u + v*v))", ((-1, 1), (-1, 1)))
    >>> mesh.points.shape, mesh.triangles.shape     # doctest: +SKIP
    ((1290, 3), (2430, 3))
    >>> mesh.save("hill.vtu")                       # doctest: +SKIP

    surface
        A text, a function of (u, v), or a ``Surface``: see ``help(Surface)``.
    domain
        A rectangle, ``((u_min, u_max), (v_min, v_max))``; or a loop: a list of three or more points, a ``Curve`` that closes, such as
        ``Curve.circle((0, 0), 1)``, or a list of curves. A surface with a domain of its own, such as a Bezier patch, needs none.
    holes
        Loops that are cut out. A hole around the middle of a rectangle, where the surface is not finite, needs ``closed=False``.
    derivatives
        For a function that is no formula: another one that returns its derivatives by u, v, uu, uv and vv.
    closed
        Over a rectangle, sides that are the same curve in space become one, and sides that are a point are no sides: a torus is
        closed, and so is a sphere. ``False`` keeps all four sides.

    What the mesh is to be like; lengths are those in space:

    max_edge
        The wanted edge length where nothing else asks for shorter edges. Default: 1/20 of the diagonal of the boundary.
    min_edge
        Edges are not divided below this length. Default: 1/200 of ``max_edge``.
    gamma
        The largest ratio of arc height to length of an edge. Default: 0.05; 0.1 are about 8 edges around a circle, 0.05 are 16.
    distance
        The largest distance between surface and triangles. Default: none.
    angle
        The smallest angle of triangles, in degrees. Default: 30.
    size
        The wanted edge length at a point: a function of (x, y, z), or a text such as ``"0.1 + 0.2*sqrt(x*x + y*y)"``.
    growth, closeness, size_factor, sweeps
        As in the manual: how fast edges grow away from the boundary; the length of boundary edges as a multiple of the width of
        a face; the size of triangles relative to edges; sweeps that improve triangles.
    self_intersections
        ``"refine"``, ``"report"`` or ``"ignore"``: triangles that pass through each other.

    threads
        The number of threads; the mesh is the same. Functions that are no formulas are called by one thread at a time.
    progress
        A function that is called with the name of the phase and a number of vertices; if it returns ``False`` meshing stops.
    time_limit
        Seconds after which meshing stops. A mesh that was stopped is valid; ``mesh.report["stopped"]`` tells.

    Returns a ``Mesh``. What triangles could not meet is in ``mesh.report["unmet_by"]``. Input that cannot be meshed raises
    ``MeshingError`` with a sentence that tells the place. Ctrl-C raises ``MeshingInterrupted``, a
    ``KeyboardInterrupt`` whose ``mesh`` is the valid mesh of that moment.
    """
    rectangle = _rectangle_in(domain)
    made = _surface(surface, rectangle, derivatives)
    if domain is None:
        rectangle = made.domain
        if rectangle is None:
            raise ValueError("the surface has no domain of its own: give one, for example ((0, 1), (0, 1))")
    if rectangle is None:
        model = Model.patch(made, domain, holes)
    elif closed is False:
        model = Model.patch(made, _corners(rectangle), holes)
    else:
        model = Model.joined([made], [rectangle])
        _check_holes(holes)
        for hole in holes:
            model.add_hole(0, hole)
    return model.mesh(max_edge=max_edge, min_edge=min_edge, gamma=gamma, distance=distance, angle=angle, size=size, growth=growth,
                      closeness=closeness, size_factor=size_factor, sweeps=sweeps, self_intersections=self_intersections,
                      threads=threads, progress=progress, time_limit=time_limit)


def mesh_patches(surfaces: Sequence[SurfaceLike], domains: Optional[Sequence[Tuple[Range, Range]]] = None, *, tolerance: float = 0,
                 **criteria: Any) -> Mesh:
    """Meshes surfaces over rectangles, joined where their sides are the same curve: ``Model.joined(...).mesh(...)``.

    ``mesh.face_ids`` tells for each triangle the number of its surface, from 1. The other arguments are those of
    ``mesh_surface()``, from ``max_edge`` on.
    """
    return Model.joined(surfaces, domains, tolerance).mesh(**criteria)


_CRITERIA = ("max_edge", "min_edge", "gamma", "angle", "distance", "detail", "growth", "closeness", "size_factor", "sweeps",
             "self_intersections", "threads")


def _criteria(given: dict) -> _core.Criteria:
    result = _core.Criteria()
    for name, value in given.items():
        if name not in _CRITERIA:
            raise TypeError(f"'{name}' is no criterion; there are {', '.join(_CRITERIA)}, size, progress and time_limit")
        if value is not None:
            if name == "threads" and isinstance(value, int) and not 1 <= value <= 1024:
                raise ValueError("threads: the number must be at least 1 and at most 1024")
            try:
                setattr(result, name, value)
            except TypeError:
                kind = {"sweeps": "a whole number that is at least 0", "threads": "a whole number that is at least 1",
                        "self_intersections": "'refine', 'report' or 'ignore'"}.get(name, "a number")
                raise TypeError(f"{name}: {value!r} must be {kind}") from None
    return result


def _check_index(index: Any, what: str, source: str) -> None:
    if not isinstance(index, (int, np.integer)) or index < 0:
        raise ValueError(f"{what} is an index that {source} has returned, not {index!r}")


def _surface(surface: SurfaceLike, domain: Optional[Tuple[Range, Range]], derivatives: Optional[Callable[..., Any]] = None) -> Surface:
    if isinstance(surface, Surface):
        if derivatives is not None:
            raise TypeError("derivatives are given with the Surface itself")
        return surface
    return Surface(surface, derivatives, domain)


def _rectangle_in(domain: Any) -> Optional[Tuple[Range, Range]]:
    """The domain, if it is a pair of ranges."""
    if not hasattr(domain, "__len__") or isinstance(domain, str) or len(domain) != 2 or any(isinstance(side, Curve) for side in domain):
        return None
    return checked_rectangle(domain)


def _corners(rectangle: Tuple[Range, Range]) -> List[Point2]:
    (u_min, u_max), (v_min, v_max) = rectangle
    return [(u_min, v_min), (u_max, v_min), (u_max, v_max), (u_min, v_max)]


def _check_holes(holes: Any) -> None:
    if isinstance(holes, (Curve, str)) or not hasattr(holes, "__iter__"):
        raise ValueError("holes: they are a list of loops, in brackets even if there is one")


def _loop(loop: LoopLike) -> List[_core.Curve]:
    if isinstance(loop, Curve):
        return [loop._core]
    try:
        if len(loop) > 0 and all(isinstance(curve, Curve) for curve in loop):
            return [curve._core for curve in loop]  # type: ignore[union-attr]
        points = [point2(point) for point in loop]
    except (TypeError, ValueError):
        points = []
    if len(points) < 3:
        raise ValueError("a domain is a rectangle ((u_min, u_max), (v_min, v_max)) or a loop, and a loop is a list of three or more points "
                         "(u, v), a Curve that closes, or a list of Curves, each beginning where the one before ends; neither is "
                         f"{loop!r}")
    return [_core.Curve.segment(points[i], points[(i + 1) % len(points)]) for i in range(len(points))]
