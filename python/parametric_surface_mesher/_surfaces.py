# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces, and curves in their domains."""
from __future__ import annotations

import os
from typing import Any, Callable, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._errors import sentences
from ._formula import read_formula, trace
from ._functions import CalledFunction, agrees, with_given_derivatives

Range = Tuple[float, float]
Point2 = Tuple[float, float]
LoopLike = Union["Curve", Sequence["Curve"], Sequence[Point2], np.ndarray]
SurfaceLike = Union["Surface", str, Callable[..., Any]]


class Surface:
    """A parametric surface: a point in space for each pair of parameters (u, v).

    The argument is one of these:

    - a text, ``Surface("u, v, exp(-5*(u*u + v*v))")``: three coordinates, with commas between, in Python's syntax and with the functions
      of its module ``math``. Definitions may come first: ``"r = 2 + cos(v); r*cos(u), r*sin(u), sin(v)"``.
    - a function, ``Surface(lambda u, v: (u, v, np.exp(-5*(u*u + v*v))))``, that returns three coordinates. It is called once
      with symbols, which NumPy's functions and arithmetic turn into a formula; then it costs no more than a text.
      A function that does something else, for instance looks up a table, is called for each point: with arrays and complex numbers if
      it bears them, so that its derivatives are exact; else its derivatives are differences. ``how`` tells which it is.
      ``derivatives`` may be a second function, which returns the five derivatives by u, v, uu, uv and vv.

    ``domain`` is the rectangle ``((u_min, u_max), (v_min, v_max))`` of its parameters, for functions that are not defined elsewhere.

    >>> hill = Surface("u, v, exp(-5*(u*u + v*v))")
    >>> hill(0, 0)
    array([0., 0., 1.])
    """

    def __init__(self, function: Union[str, Callable[..., Any]], derivatives: Optional[Callable[..., Any]] = None,
                 domain: Optional[Tuple[Range, Range]] = None):
        self.domain: Optional[Tuple[Range, Range]] = None if domain is None else checked_rectangle(domain)
        ranges = self.domain or ((0.0, 1.0), (0.0, 1.0))
        if isinstance(function, str):
            self.how = "formula"
            self._core = _core.Surface.formula(read_formula(function, ("u", "v"), 3))
            return
        if not callable(function):
            raise TypeError(f"a surface is made from a text or a function, not from {type(function).__name__}")
        if derivatives is not None:
            self.how = "given derivatives"
            called = CalledFunction(function, ranges, 3)
            self._core = _core.Surface.function(called.point, with_given_derivatives(function, derivatives, 5))
            return
        formula = trace(function, ("u", "v"), 3)
        if formula is not None:
            core = _core.Surface.formula(formula)
            if agrees(lambda u, v: core.jet(u, v)[0], function, ranges):
                self.how, self._core = "formula", core
                return
        called = CalledFunction(function, ranges, 3)
        self.how = called.kind
        self._core = _core.Surface.function(called.point, called.jet)

    @classmethod
    def _of_core(cls, core: _core.Surface, how: str) -> "Surface":
        result = cls.__new__(cls)
        result._core, result.how = core, how
        domain = core.domain
        result.domain = None if domain is None else ((domain[0], domain[1]), (domain[2], domain[3]))
        return result

    @classmethod
    def bezier(cls, control_points: Any) -> "Surface":
        """A Bezier surface over ((0, 1), (0, 1)), from an array of control points with the shape (n, m, 3).

        The first index goes along u, the second along v. The degrees are n - 1 and m - 1, at most 25.
        """
        points = _control_net(control_points)
        n, m, _ = points.shape
        with sentences():
            return cls._of_core(_core.Surface.bezier(n - 1, m - 1, _rows(points)), "Bezier")

    @classmethod
    def nurbs(cls, control_points: Any, degrees: Tuple[int, int], knots: Optional[Tuple[Sequence[float], Sequence[float]]] = None,
              weights: Any = None) -> "Surface":
        """A B-spline surface, or a NURBS surface if there are weights.

        ``control_points`` has the shape (n, m, 3), ``weights`` (n, m). Each of the two knot vectors has as many entries as there are
        control points in its direction, plus the degree and 1; by default they are uniform over (0, 1) with ends of full multiplicity.
        """
        points = _control_net(control_points)
        n, m, _ = points.shape
        for degree, number, direction in ((degrees[0], n, "u"), (degrees[1], m, "v")):
            if number <= degree:
                raise ValueError(f"the degree {degree} in {direction} needs at least {degree + 1} control points in this direction, not "
                                 f"{number}")
        if knots is None:
            knots = (_uniform_knots(n, degrees[0]), _uniform_knots(m, degrees[1]))
        weight_list: List[float] = []
        if weights is not None:
            weight_array = np.asarray(weights, dtype=float)
            if weight_array.shape != (n, m):
                raise ValueError(f"the weights have the shape {weight_array.shape}, the control points {(n, m)}")
            weight_list = weight_array.T.reshape(-1).tolist()
        knots_u, knots_v = ([float(knot) for knot in one] for one in knots)
        with sentences():
            core = _core.Surface.b_spline(degrees[0], degrees[1], knots_u, knots_v, _rows(points), weight_list)
        return cls._of_core(core, "NURBS")

    def __call__(self, u: float, v: float) -> np.ndarray:
        """The point at (u, v)."""
        return np.array(self._core.jet(u, v)[0])

    def derivatives(self, u: float, v: float) -> np.ndarray:
        """The derivatives by u, v, uu, uv and vv at (u, v), as an array of shape (5, 3)."""
        return np.array(self._core.jet(u, v)[1:])

    def __repr__(self) -> str:
        return f"<Surface: {self.how}{'' if self.domain is None else f' over {self.domain}'}>"


def read_bezier_patches(path: Union[str, "os.PathLike[str]"]) -> List[Surface]:
    """Reads a file of Bezier patches, such as the Utah teapot's, in the format .bpt."""
    with sentences():
        return [Surface._of_core(core, "Bezier") for core in _core.Surface.read_bezier_patches(os.fspath(path))]


class Curve:
    """A curve in the domain of a surface: the pair (u, v) for each t from ``begin`` to ``end``.

    ``function`` is a text, ``Curve("cos(t), sin(t)", 0, 2*np.pi)``, or a function of t. Segments, arcs and circles have functions of their
    own. Curves that follow each other make a loop: the boundary of a domain, or of a hole.
    """

    def __init__(self, function: Union[str, Callable[..., Any]], begin: float, end: float):
        formula = read_formula(function, ("t",), 2) if isinstance(function, str) else trace(function, ("t",), 2)
        with sentences():
            if formula is not None:
                self._core = _core.Curve.formula(formula, begin, end)
            elif callable(function):
                self._core = _core.Curve.function(CalledFunction(function, ((begin, end),), 2).jet, begin, end)
            else:
                raise TypeError(f"a curve is made from a text or a function, not from {type(function).__name__}")

    @classmethod
    def _of_core(cls, core: _core.Curve) -> "Curve":
        result = cls.__new__(cls)
        result._core = core
        return result

    @classmethod
    def segment(cls, source: Point2, target: Point2) -> "Curve":
        """The segment between two points of the domain, for t from 0 to 1."""
        return cls._of_core(_core.Curve.segment(point2(source), point2(target)))

    @classmethod
    def arc(cls, center: Point2, radius: float, begin: float, end: float) -> "Curve":
        """An arc between two angles, in radians."""
        with sentences():
            return cls._of_core(_core.Curve.arc(point2(center), radius, begin, end))

    @classmethod
    def circle(cls, center: Point2, radius: float) -> "Curve":
        """A circle, which is a loop by itself."""
        with sentences():
            return cls._of_core(_core.Curve.circle(point2(center), radius))

    @property
    def source(self) -> Point2:
        """The point where it begins."""
        u, v = self._core.source
        return u, v

    @property
    def target(self) -> Point2:
        """The point where it ends."""
        u, v = self._core.target
        return u, v


def checked_rectangle(domain: Any) -> Tuple[Range, Range]:
    try:
        (u_min, u_max), (v_min, v_max) = domain
        result = ((float(u_min), float(u_max)), (float(v_min), float(v_max)))
    except (TypeError, ValueError):
        raise ValueError(f"a rectangle of parameters is ((u_min, u_max), (v_min, v_max)), not {domain!r}") from None
    if not (result[0][0] < result[0][1] and result[1][0] < result[1][1]):
        raise ValueError(f"the rectangle {result} of parameters is empty: each range goes from a smaller to a larger number")
    return result


def point2(point: Any) -> List[float]:
    try:
        u, v = point
        return [float(u), float(v)]
    except (TypeError, ValueError):
        raise ValueError(f"a point of the domain is (u, v), two numbers, not {point!r}") from None


def _control_net(control_points: Any) -> np.ndarray:
    points = np.asarray(control_points, dtype=float)
    if points.ndim != 3 or points.shape[2] != 3:
        raise ValueError(f"control points are an array of the shape (n, m, 3), not {points.shape}")
    return points


def _rows(points: np.ndarray) -> List[List[float]]:
    """The control points in rows: those of the first v first, in the order of growing u."""
    return points.transpose(1, 0, 2).reshape(-1, 3).tolist()


def _uniform_knots(n: int, degree: int) -> List[float]:
    inner = np.linspace(0, 1, max(n - degree + 1, 2))
    return [0.0] * degree + inner.tolist() + [1.0] * degree
