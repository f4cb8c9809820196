# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Draws a result of CalculiX as a picture: the bent part, coloured by the von Mises stress. Displacements are drawn larger than they are,
# by a factor (1 if none is given). Needs python3-matplotlib.
#
#   python3 draw_result.py solid.frd solid.png 5
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from read_frd import check_frd, read_frd

# By the number of a kind of element in the file: its name, its nodes, and those of them at the corners of triangles on its outside.
TETRAHEDRON, WEDGE = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)), ((0, 2, 1), (3, 4, 5))
KINDS = {"2": ("wedge", 6), "5": ("wedge", 6), "6": ("tetra10", 10)}
SIDES = {"2": WEDGE, "5": WEDGE, "6": TETRAHEDRON}
VIEWER = np.array((0.5, -0.7, 0.5))


def outer_triangles(elements):
    """Sides that one element has alone."""
    sides = {}
    for kind, nodes in elements:
        for side in SIDES[kind]:
            corners = [nodes[i] for i in side]
            sides.setdefault(frozenset(corners), []).append(corners)
    return [corners[0] for corners in sides.values() if len(corners) == 1]


def main():
    points, elements, values = read_frd(sys.argv[1])
    check_frd(sys.argv[1], elements, values, KINDS, ["STRESS", "DISP"])
    factor = float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
    triangles = outer_triangles(elements)
    places = np.array([[np.array(points[n]) + factor * np.array(values["DISP"][n]) for n in t] for t in triangles])
    xx, yy, zz, xy, yz, zx = np.moveaxis(np.array([[values["STRESS"][n] for n in t] for t in triangles]), 2, 0)
    stress = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + zx**2)).mean(axis=1)

    depth = VIEWER / np.linalg.norm(VIEWER)
    right = np.cross((0, 0, 1), depth)
    right /= np.linalg.norm(right)
    up = np.cross(depth, right)
    normals = np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])
    cosines = normals @ (depth + 0.4 * up) / np.linalg.norm(normals, axis=1)  # light comes from above the viewer
    order = [i for i in np.argsort((places @ depth).mean(axis=1)) if normals[i] @ depth > 0]  # what is far is painted first
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, stress.max()), "YlOrRd")
    colors = scale.to_rgba(stress)
    colors[:, :3] *= (0.6 + 0.4 * np.clip(cosines, 0, 1))[:, None]
    lines = 0.75 * colors[:, :3]  # opaque: between polygons without lines the background shows
    figure, ax = plt.subplots(figsize=(8, 4.5))
    ax.add_collection(PolyCollection(np.stack((places @ right, places @ up), axis=2)[order], facecolors=colors[order],
                                     edgecolors=lines[order], linewidths=0.4))
    ax.autoscale()
    ax.set_aspect("equal")
    ax.axis("off")
    figure.colorbar(scale, ax=ax, label="von Mises stress", shrink=0.7)
    figure.savefig(sys.argv[2], dpi=110, bbox_inches="tight")


main()
