#!/usr/bin/env python3
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two builds of the package side by side: time of meshing and shape of the triangles, by turns in one run.

Usage: compare_builds.py [--repeats N] [--sizes N1,N2,...] [--csv FILE] BEFORE AFTER [CAD_FILE...]

BEFORE and AFTER are build directories with the programs mesh_patch and, for CAD files, mesh_cad. The ten sample surfaces are
meshed with about N1, N2, ... triangles (50000 and 500000), with frontal points and with circumcentres, and each CAD file with
default options. Each run has a process of its own; the two builds take turns, and the one that begins changes. The time is the
one that the programs tell for meshing (for CAD files: for the model and the meshing), the median of the runs, and the ratio
the median of the ratios of neighbouring runs. Shapes are those of the last run. At the end are the means.
"""
import argparse
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

AREAS = {"flat": 1, "bend": 2, "peak": 4.4795539, "hole": 4.9190438, "cap": 2.2214415, "sphere": 12.566371,
         "torus": 11.843525, "cyl": 12.566371, "skew": 13.124706, "stretch": 1.0923835}
PLACEMENTS = ("frontal", "circumcenter")
PROGRAMS = os.path.join("examples", "Parametric_surface_mesher")
SHAPES = (("min_angle", "smallest angle"), ("mean_min_angle", "mean smallest angle"), ("mean_radius_ratio", "2r/R"))
LIMIT = 300  # seconds for a run


def run(build, program, arguments):
    """The numbers of one run, or None if it fails."""
    with tempfile.TemporaryDirectory() as folder:
        numbers = os.path.join(folder, "numbers.json")
        command = [os.path.join(build, PROGRAMS, program), *arguments, "--quiet", "--json", numbers]
        try:
            subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=LIMIT, check=False)
            with open(numbers) as file:
                result = json.load(file)
        except (OSError, ValueError, subprocess.TimeoutExpired):
            return None
    seconds = result["seconds"]
    result["time"] = seconds["meshing"] + seconds.get("model", 0)
    return result


def compare(builds, program, arguments, repeats):
    """Runs both builds by turns; returns their last numbers, their median times, and the median ratio of the times."""
    times, last = ([], []), [None, None]
    for repeat in range(repeats):
        for i in ((0, 1), (1, 0))[repeat % 2]:
            last[i] = run(builds[i], program, arguments)
            if last[i] is None:
                return last, (math.nan, math.nan), math.nan
            times[i].append(last[i]["time"])
    ratio = statistics.median(after / before for before, after in zip(*times))
    return last, tuple(statistics.median(t) for t in times), ratio


def cases(arguments):
    for size in arguments.sizes:
        for placement in PLACEMENTS:
            for name, area in AREAS.items():
                edge = math.sqrt(4 * area / (math.sqrt(3) * size))
                yield f"{placement} {size}", name, "mesh_patch", [name, "--max-edge", repr(edge), "--placement", placement]
    for file in arguments.cad_files:
        yield "CAD", os.path.basename(file), "mesh_cad", [file]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--sizes", type=lambda text: [int(n) for n in text.split(",") if n], default=[50000, 500000])
    parser.add_argument("--csv")
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("cad_files", nargs="*")
    arguments = parser.parse_args()
    builds = (arguments.before, arguments.after)
    rows, groups = [], {}
    print(f"{'case':32} {'triangles':>19} {'ms':>17} {'ratio':>6} {'smallest angle':>15} {'mean':>13} {'2r/R':>15}")
    for group, name, program, options in cases(arguments):
        (before, after), times, ratio = compare(builds, program, options, arguments.repeats)
        label = f"{name} {group}"
        if before is None or after is None:
            print(f"{label:32} " + ", ".join(w + " fails" for w, r in zip(("before", "after"), (before, after)) if r is None))
            continue
        pairs = [(before[key], after[key]) for key, _ in SHAPES]
        groups.setdefault(group, []).append((ratio, pairs))
        rows.append([label, before["triangles"], after["triangles"], *times, ratio, *sum(pairs, ())])
        print(f"{label:32} {before['triangles']:9} {after['triangles']:9} {1e3 * times[0]:8.1f} {1e3 * times[1]:8.1f} {ratio:6.3f}"
              f" {pairs[0][0]:7.2f} {pairs[0][1]:7.2f} {pairs[1][0]:6.2f} {pairs[1][1]:6.2f} {pairs[2][0]:7.4f} {pairs[2][1]:7.4f}",
              flush=True)
    print("\nMeans: ratio of the times (geometric) and the largest; differences of the shapes")
    for group, results in groups.items():
        ratios = [ratio for ratio, _ in results]
        differences = [statistics.mean(pairs[i][1] - pairs[i][0] for _, pairs in results) for i in range(len(SHAPES))]
        print(f"{group:24} {statistics.geometric_mean(ratios):.3f} {max(ratios):.3f}  "
              + ", ".join(f"{title} {difference:+.4f}" for (_, title), difference in zip(SHAPES, differences)))
    if arguments.csv:
        with open(arguments.csv, "w") as file:
            for row in rows:
                file.write(",".join(str(cell) for cell in row) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
