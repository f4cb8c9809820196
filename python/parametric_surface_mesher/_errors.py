# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences of the compiled part, in the words of Python."""
from __future__ import annotations

import contextlib
import re
from typing import Iterator

from . import _core


class MeshingError(RuntimeError):
    """Input that cannot be read or meshed. The message names the place, and what to change."""


# Options of the program `mesh_cad` that are no arguments of the function.
ONLY_OF_PROGRAM = ("out", "picture", "json", "quiet", "help", "list", "list-faces", "binary", "node-parameters", "page", "version")


def renamed(sentence: str) -> str:
    """Options are named as arguments: --max-edge is max_edge. Those that only the program has are named as its own."""
    def name(match: "re.Match[str]") -> str:
        option = match.group(1)
        return f"the program's --{option}" if option in ONLY_OF_PROGRAM else option.replace("-", "_")
    sentence = sentence.replace("; --help lists the options", "; help(mesh_cad) lists the arguments")
    sentence = re.sub(r"^option '--([a-z-]+)' does not take any arguments", r"--\1 must be True or False", sentence)
    return re.sub(r"--([a-z]+(?:-[a-z]+)*)", name, sentence)


@contextlib.contextmanager
def sentences() -> Iterator[None]:
    """Raises what the compiled part raises as MeshingError, with one sentence."""
    try:
        yield
    except MemoryError:
        raise MemoryError("the memory is too small for this mesh; choose a larger max_edge or min_edge") from None
    except _core.CoreError as error:
        raise MeshingError(renamed(str(error))) from None
