#!/usr/bin/env python3
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what compare_with_cgal_mesher has measured.

Usage: plot_comparison.py FILE.json FOLDER

FILE.json is written by `compare_with_cgal_mesher --json FILE.json`. Three pictures go to FOLDER:
    comparison_angles.png      the smallest angles of the triangles, mesher by mesher
    comparison_distance.png    triangles against distance from the surface
    comparison_rim.png         each mesh of the tin at its upper rim

Needs Matplotlib and Pillow, which it brings along (Debian: python3-matplotlib, for /usr/bin/python3).
"""
import json
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from PIL import Image

OWN = "make_parametric_surface_mesh"
MARKERS = "osv^Dx"
SHAPE_OF_ANGLES = "torus"
VIEW = np.array((1.0, -0.35, 0.75))  # from the rim to the viewer
RIM = np.array((1.0, 0.0, 1.0))
RADIUS_OF_VIEW = 0.22
DOTS_PER_INCH = 100


def title(mesher):
    return "this package" if mesher == OWN else mesher.replace(", ", ",\n")


def colors(meshers):
    """A colour for each mesher, the same in all pictures."""
    palette = plt.get_cmap("tab10")
    return {mesher: palette(i) for i, mesher in enumerate(meshers)}


def panels(number):
    """A grid of so many equal panels, three in a row."""
    columns = min(3, number)
    rows = -(-number // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3 * columns, 2.6 * rows), squeeze=False, sharex=True, sharey=True)
    axes = list(axes.flat)
    for ax in axes[number:]:
        ax.set_visible(False)
    return figure, axes[:number]


def save(figure, folder, name, place=(0, 0, 1, 1)):
    """Fits all panels into a place of the figure, and saves it with few colours: a tenth of the size."""
    path = os.path.join(folder, name)
    figure.tight_layout(rect=place)
    figure.savefig(path, dpi=DOTS_PER_INCH)
    plt.close(figure)
    Image.open(path).convert("RGB").quantize(48, dither=Image.Dither.NONE).save(path, optimize=True)


def first_size(runs):
    """The runs with the first number of triangles that was asked for."""
    sizes = [run["value"] for run in runs if run["target"] == "triangles"]
    return [run for run in runs if run["target"] == "triangles" and run["value"] == sizes[0]]


def plot_angles(runs, folder):
    chosen = [run for run in first_size(runs) if run["shape"] == SHAPE_OF_ANGLES]
    figure, axes = panels(len(chosen))
    for ax, run in zip(axes, chosen):
        counts = np.array(run["smallest_angles"])
        share = 100 * counts / counts.sum()
        ax.bar(np.arange(len(counts)) + 0.5, share, width=1, color=colors([r["mesher"] for r in chosen])[run["mesher"]])
        ax.axvline(30, color="black", linewidth=0.8, linestyle=":")
        ax.set_title(title(run["mesher"]), fontsize=9)
        ax.set_xlim(0, 60)
    for ax in axes[-3:]:
        ax.set_xlabel("smallest angle in degrees", fontsize=8)
    for ax in axes[::3]:
        ax.set_ylabel("% of the triangles", fontsize=8)
    save(figure, folder, "comparison_angles.png")


def plot_distance(runs, folder):
    series = [run for run in runs if run["target"] == "series"]
    shapes = list(dict.fromkeys(run["shape"] for run in series))
    meshers = list(dict.fromkeys(run["mesher"] for run in series))
    figure, axes = plt.subplots(1, len(shapes), figsize=(3.2 * len(shapes), 4.4), sharey=True, squeeze=False)
    for ax, shape in zip(axes.flat, shapes):
        for mesher, marker in zip(meshers, MARKERS):
            points = sorted((run["distance"], run["triangles"]) for run in series if (run["shape"], run["mesher"]) == (shape, mesher))
            ax.loglog(*zip(*points), marker=marker, markersize=4, linewidth=2 if mesher == OWN else 1,
                      color=colors(meshers)[mesher], label=title(mesher).replace("\n", " "))
        ax.set_title(shape, fontsize=9)
        ax.set_xlabel("distance from the surface", fontsize=8)
        ax.grid(True, which="major", linewidth=0.3)
    axes.flat[0].set_ylabel("triangles", fontsize=8)
    figure.legend(*axes.flat[0].get_legend_handles_labels(), loc="lower center", ncol=3, fontsize=8)
    save(figure, folder, "comparison_distance.png", (0, 0.13, 1, 1))


def projected(triangles):
    """Those that face the viewer, in the plane of the picture, the farthest first, with how bright they are."""
    depth = VIEW / np.linalg.norm(VIEW)
    right = np.cross((0, 0, 1), depth)
    right /= np.linalg.norm(right)
    up = np.cross(depth, right)
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    outward = np.sign(np.einsum("ij,ij->i", normals, triangles.mean(axis=1) - (0, 0, 0.5)))
    normals *= (outward / np.linalg.norm(normals, axis=1))[:, None]
    faces_viewer = normals @ depth > 0
    triangles, normals = triangles[faces_viewer] - RIM, normals[faces_viewer]
    order = np.argsort((triangles @ depth).mean(axis=1))
    light = np.array((0.5, -0.3, 0.8)) / np.linalg.norm((0.5, -0.3, 0.8))
    return np.stack((triangles @ right, triangles @ up), axis=2)[order], np.clip(normals @ light, 0, 1)[order]


def plot_rim(details, folder):
    figure, axes = panels(len(details))
    for ax, detail in zip(axes, details):
        polygons, brightness = projected(np.array(detail["triangles"]).reshape(-1, 3, 3))
        shades = 0.45 + 0.5 * brightness[:, None] * np.array((0.8, 0.95, 1.0))
        ax.add_collection(PolyCollection(polygons, facecolors=np.clip(shades, 0, 1), edgecolors="#203040", linewidths=0.4))
        ax.set_xlim(-RADIUS_OF_VIEW, RADIUS_OF_VIEW)
        ax.set_ylim(-0.8 * RADIUS_OF_VIEW, 0.8 * RADIUS_OF_VIEW)
        ax.set_aspect("equal")
        ax.set_xticks([])
        ax.set_yticks([])
        ax.set_title(title(detail["mesher"]), fontsize=9)
    save(figure, folder, "comparison_rim.png")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        comparison = json.load(file)
    plot_angles(comparison["runs"], sys.argv[2])
    plot_distance(comparison["runs"], sys.argv[2])
    meshers = list(dict.fromkeys(detail["mesher"] for detail in comparison["details"]))
    plot_rim(comparison["details"][:len(meshers)], sys.argv[2])


if __name__ == "__main__":
    main()
