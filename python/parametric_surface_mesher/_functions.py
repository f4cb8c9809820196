# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions that have to be called: values and derivatives of what is not a formula."""
from __future__ import annotations

import warnings
from typing import Any, Callable, List, Optional, Sequence, Tuple

import numpy as np

Values = np.ndarray  # one row for each coordinate, one column for each place

# Steps as shares of the extent of a parameter. That for differences of exact first derivatives is the cube root of the rounding error.
# Differences of values have the error of rounding over the square of the step, and that of the formula, which grows with its fourth
# power; their step is between both.
_STEP_OF_COMPLEX = 6e-6
_STEP_OF_DIFFERENCES = 1e-3
_IMAGINARY_STEP = 1e-30


class CalledFunction:
    """A function of one or two parameters, with its first two derivatives.

    It is called with arrays if it bears that, with complex numbers if it bears those: then first derivatives are exact, and second ones are
    differences of them. Otherwise derivatives are differences of values.
    """

    def __init__(self, function: Callable[..., Any], ranges: Sequence[Tuple[float, float]], number_of_results: int):
        self.function = function
        self.n = len(ranges)
        self.number_of_results = number_of_results
        self.extents = [float(b - a) for a, b in ranges]
        generator = np.random.default_rng(0)
        places = np.array([a + (b - a) * generator.uniform(0.1, 0.9, 3) for a, b in ranges])
        self.is_vectorized = self._bears_arrays(places)
        self.bears_complex = self._bears_complex(places)

    @property
    def kind(self) -> str:
        return "complex steps" if self.bears_complex else "differences"

    def point(self, *parameters: float) -> List[float]:
        return real_numbers(self._checked(self.function(*parameters)), "the function")

    def jet(self, *parameters: float) -> List[List[float]]:
        """The value, the first and the second derivatives: by u, v, uu, uv and vv, or by t and tt."""
        return self._complex_jet(parameters) if self.bears_complex else self._difference_jet(parameters)

    def _checked(self, result: Any) -> Any:
        if not hasattr(result, "__len__") or len(result) != self.number_of_results:
            found = f"{len(result)} values" if hasattr(result, "__len__") else repr(result)
            raise TypeError(f"the function must return {self.number_of_results} coordinates, but returned {found}")
        return result

    def _values(self, places: np.ndarray) -> Values:
        """The values of the function at places, which are columns."""
        if self.is_vectorized:
            result = self._checked(self.function(*places))
            return np.array([np.broadcast_to(row, places.shape[1:]) for row in result])
        return np.array([self._checked(self.function(*place)) for place in places.T.tolist()]).T

    def _bears_arrays(self, places: np.ndarray) -> bool:
        one_by_one = np.array([self.point(*place) for place in places.T.tolist()]).T
        self.is_vectorized = True
        try:
            return bool(np.allclose(self._values(places), one_by_one, rtol=1e-9, equal_nan=True))
        except Exception:  # whatever it objects to
            return False

    def _bears_complex(self, places: np.ndarray) -> bool:
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                for place in places.T:
                    exact, differences = self._complex_jet(place), self._difference_jet(place)
                    if not np.allclose(exact, differences, rtol=1e-3, atol=1e-3 * np.abs(differences).max()):
                        return False
            return True
        except Exception:  # whatever it objects to
            return False

    def _complex_jet(self, parameters: Sequence[float]) -> List[List[float]]:
        n, steps = self.n, [_STEP_OF_COMPLEX * extent for extent in self.extents]
        place = np.array(parameters, dtype=complex)
        columns = [place]
        for i in range(n):
            imaginary = np.zeros(n, dtype=complex)
            imaginary[i] = 1j * _IMAGINARY_STEP
            columns.append(place + imaginary)
            for j in range(i, n):
                real = np.zeros(n, dtype=complex)
                real[j] = steps[j]
                columns += [place + imaginary + real, place + imaginary - real]
        values = self._values(np.array(columns).T)
        slopes = values.imag / _IMAGINARY_STEP

        def second(column: int, j: int) -> List[float]:
            return ((slopes[:, column] - slopes[:, column + 1]) / (2 * steps[j])).tolist()

        point = values[:, 0].real.tolist()
        if n == 1:
            return [point, slopes[:, 1].tolist(), second(2, 0)]
        return [point, slopes[:, 1].tolist(), slopes[:, 6].tolist(), second(2, 0), second(4, 1), second(7, 1)]

    def _difference_jet(self, parameters: Sequence[float]) -> List[List[float]]:
        n, steps = self.n, [_STEP_OF_DIFFERENCES * extent for extent in self.extents]
        place = np.array(parameters, dtype=float)
        columns = [place]
        for i in range(n):
            step = np.zeros(n)
            step[i] = steps[i]
            columns += [place + step, place - step, place + 2 * step, place - 2 * step]
        if n == 2:
            for k in (1, 2):
                for signs in ((k, k), (k, -k), (-k, k), (-k, -k)):
                    columns.append(place + np.array(signs) * steps)
        f = self._values(np.array(columns).T)

        def first(c: int, h: float) -> np.ndarray:
            return (8 * (f[:, c] - f[:, c + 1]) - (f[:, c + 2] - f[:, c + 3])) / (12 * h)

        def second(c: int, h: float) -> np.ndarray:
            return (16 * (f[:, c] + f[:, c + 1]) - (f[:, c + 2] + f[:, c + 3]) - 30 * f[:, 0]) / (12 * h * h)

        if n == 1:
            jet = [f[:, 0], first(1, steps[0]), second(1, steps[0])]
        else:
            def mixed(c: int, k: int) -> np.ndarray:
                return (f[:, c] - f[:, c + 1] - f[:, c + 2] + f[:, c + 3]) / (4 * k * k * steps[0] * steps[1])
            jet = [f[:, 0], first(1, steps[0]), first(5, steps[1]),
                   second(1, steps[0]), (4 * mixed(9, 1) - mixed(13, 2)) / 3, second(5, steps[1])]
        return [row.tolist() for row in jet]


def with_given_derivatives(function: Callable[..., Any], derivatives: Callable[..., Any],
                           number_of_derivatives: int) -> Callable[..., List[List[float]]]:
    """The value and the derivatives that another function returns."""
    def jet(*parameters: float) -> List[List[float]]:
        given = derivatives(*parameters)
        if not hasattr(given, "__len__") or len(given) != number_of_derivatives:
            found = f"{len(given)} values" if hasattr(given, "__len__") else repr(given)
            raise TypeError(f"the function of derivatives must return {number_of_derivatives} vectors, but returned {found}")
        point = real_numbers(function(*parameters), "the function")
        vectors = [real_numbers(vector, "the function of derivatives") for vector in given]
        for vector in vectors:
            if len(vector) != len(point):
                raise TypeError(f"the function of derivatives must return vectors with {len(point)} coordinates, but one has {len(vector)}")
        return [point, *vectors]
    return jet


def real_numbers(coordinates: Any, source: str) -> List[float]:
    try:
        return [float(x) for x in coordinates]
    except (TypeError, ValueError):
        raise TypeError(f"{source} must return real numbers, but returned {coordinates!r}") from None


def agrees(program_values: Callable[..., Sequence[float]], function: Callable[..., Any], ranges: Sequence[Tuple[float, float]]) -> bool:
    """Whether a formula that was made from a function gives what the function does, at some places."""
    generator = np.random.default_rng(1)
    for _ in range(5):
        place = [float(a + (b - a) * generator.uniform()) for a, b in ranges]
        try:
            called: Optional[np.ndarray] = np.array([float(x) for x in function(*place)])
        except Exception:  # a function that only takes arrays, or fails there
            called = None
        if called is not None and not np.allclose(program_values(*place), called, rtol=1e-9, atol=1e-12, equal_nan=True):
            return False
    return True
