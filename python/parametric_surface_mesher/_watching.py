# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What meshing has in common for formulas and files: sizes, progress, and interrupts."""
from __future__ import annotations

import numbers
import signal
import threading
from typing import Any, Callable, Optional, Tuple, Union

from ._errors import sentences
from ._formula import read_formula, trace

Size = Union[str, float, Callable[[float, float, float], float]]
Progress = Callable[[str, int], Optional[bool]]


def size_for_core(size: Optional[Size]) -> Any:
    """A text, and a function that is a formula, are compiled; another function is called for each point."""
    if size is None:
        return None
    if isinstance(size, (int, float)):
        size = repr(float(size))
    if isinstance(size, str):
        return read_formula(size, ("x", "y", "z"), 1)
    if not callable(size):
        raise TypeError("size: a wanted edge length is a number, or a text or a function of (x, y, z)")
    return trace(size, ("x", "y", "z"), 1) or size


def handles_interrupts() -> bool:
    """Whether Ctrl-C would raise KeyboardInterrupt here."""
    return threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) is signal.default_int_handler


def run(mesh: Callable[..., Tuple[Any, bool]], what: Any, progress: Optional[Progress], size: Any,
        time_limit: Optional[float]) -> Tuple[Any, bool]:
    """Calls a meshing function of the compiled part; returns the mesh, and whether it was interrupted."""
    if time_limit is not None and not (isinstance(time_limit, numbers.Real) and time_limit >= 0):
        raise ValueError(f"time_limit: {time_limit!r} must be a number of seconds that is at least 0")
    if progress is not None and not callable(progress):
        raise TypeError("progress: it must be a function of the name of a phase and a number of vertices")
    with sentences():
        return mesh(what, progress, size, time_limit, handles_interrupts())
