# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures by other libraries, if they are installed."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional

import numpy as np

if TYPE_CHECKING:
    from ._mesh import Mesh


def _values(mesh: "Mesh", color_by: Optional[str]) -> Optional[np.ndarray]:
    if color_by is None:
        return None
    if color_by == "face":
        return mesh.face_ids
    if color_by == "part":
        return mesh.part_ids
    if color_by == "angle":
        return mesh.angles().min(axis=1)
    raise ValueError(f"color_by: '{color_by}' must be 'face', 'part' or 'angle'")


def to_pyvista(mesh: "Mesh") -> Any:
    try:
        import pyvista  # type: ignore
    except ImportError:
        raise ImportError("PyVista is not installed; 'pip install pyvista' gets it") from None
    cells = np.hstack([np.full((len(mesh.triangles), 1), 3), mesh.triangles])
    result = pyvista.PolyData(mesh.points, cells.reshape(-1))
    result.cell_data["face_id"] = mesh.face_ids
    result.cell_data["part_id"] = mesh.part_ids
    return result


def plot(mesh: "Mesh", color_by: Optional[str], show: bool, options: Dict[str, Any]) -> Any:
    values = _values(mesh, color_by)
    try:
        import pyvista  # type: ignore
    except ImportError:
        return _plot_with_matplotlib(mesh, values, color_by, show, options)
    plotter = pyvista.Plotter(off_screen=None if show else True)
    options = {"show_edges": True, "color": None if values is not None else "lightgray", **options}
    plotter.add_mesh(to_pyvista(mesh), scalars=values, **options)
    if len(mesh.edges) > 0:
        lines = np.hstack([np.full((len(mesh.edges), 1), 2), mesh.edges])
        plotter.add_mesh(pyvista.PolyData(mesh.points, lines=lines.reshape(-1)), color="black", line_width=3)
    if show:
        plotter.show()
    return plotter


def _plot_with_matplotlib(mesh: "Mesh", values: Optional[np.ndarray], color_by: Optional[str], show: bool, options: Dict[str, Any]) -> Any:
    try:
        import matplotlib.pyplot as plt  # type: ignore
    except ImportError:
        raise ImportError("plot() needs PyVista or Matplotlib; 'pip install pyvista' or the Debian package python3-matplotlib gets "
                          "one") from None
    axes = plt.figure().add_subplot(projection="3d")
    options = {"edgecolor": "black", "linewidth": 0.2, "color": "lightgray", **options}
    if values is not None:
        options.pop("color")
        options.setdefault("cmap", "viridis")
    surface = axes.plot_trisurf(mesh.points[:, 0], mesh.points[:, 1], mesh.points[:, 2], triangles=mesh.triangles, **options)
    if values is not None:
        surface.set_array(values)
        labels = {"face": "number of the face", "part": "number of the part", "angle": "smallest angle (degrees)"}
        axes.figure.colorbar(surface, ax=axes, label=labels[str(color_by)], shrink=0.6)
    axes.set_box_aspect(np.maximum(np.ptp(mesh.points, axis=0), 1e-9 * np.ptp(mesh.points)))
    if show:
        plt.show()
    return axes
