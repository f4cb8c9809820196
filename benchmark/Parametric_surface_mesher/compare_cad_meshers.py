#!/usr/bin/env python3
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles per second of processor time of mesh_cad, Gmsh and Netgen on the same CAD files, in one run.

Usage: compare_cad_meshers.py MESH_CAD FILE...

MESH_CAD is the program. Gmsh and Netgen are those of the Python interpreter (Debian: python3-gmsh, python3-netgen, for
/usr/bin/python3); one that is missing is left out. Sizes are between diagonal/1000 and diagonal/20 for all; Gmsh has 20
elements per turn, Netgen a grading of 0.3 and 2 elements per edge and curvature radius (its smallest size cannot be set
from Python). mesh_cad runs with its defaults and, for each of the others, with the bounds of the deviation that make it give
as many triangles, within a few percent if that can be: the ratios are to these runs. Reading the file is not counted;
making a model of the shape that was read is, but for Netgen, which does both at once. Netgen reads STEP files only: Gmsh
converts others. Each run has a process of its own and 120 seconds. The times are the least ones of three runs by turns, and of
as many as take three seconds if these are short; what takes more than ten seconds runs once.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

LIMIT = 120
REPEATS = 3
ENOUGH = 3
LONG = 10


def cpu():
    return time.process_time()


def run_gmsh(name, diagonal):
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    gmsh.model.occ.importShapes(name)
    start = cpu()
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", diagonal / 20)
    gmsh.option.setNumber("Mesh.MeshSizeMin", diagonal / 1000)
    gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", 20)
    gmsh.option.setNumber("Mesh.CharacteristicLengthFromCurvature", 20)
    gmsh.option.setNumber("Mesh.MinimumElementsPerTwoPi", 20)
    gmsh.model.mesh.generate(2)
    seconds = cpu() - start
    types, tags, _ = gmsh.model.mesh.getElements(2)
    return sum(len(t) for t in tags), seconds


def step_file(name, folder):
    if name.endswith((".step", ".stp")):
        return name
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.occ.importShapes(name)
    gmsh.model.occ.synchronize()
    result = os.path.join(folder, "shape.step")
    gmsh.write(result)
    gmsh.finalize()
    return result


def run_netgen(name, diagonal):
    import netgen.NgOCC as occ
    import netgen.meshing as meshing
    with tempfile.TemporaryDirectory() as folder:
        geometry = occ.LoadOCCGeometry(step_file(name, folder))
    parameters = meshing.MeshingParameters(maxh=diagonal / 20, grading=0.3, segmentsperedge=2, curvaturesafety=2,
                                           perfstepsend=meshing.MeshingStep.MESHSURFACE, optsteps2d=3)
    start = cpu()
    mesh = occ.GenerateMesh(geometry, parameters)
    seconds = cpu() - start
    return len(mesh.Elements2D()), seconds


def run_mesh_cad(program, name, options):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "numbers.json")
        subprocess.run([program, name, "--quiet", "--json", out] + options, check=False)
        with open(out) as f:
            numbers = json.load(f)
    return numbers["triangles"], numbers["seconds"]["model"] + numbers["seconds"]["meshing"], numbers["diagonal"]


def in_process(mesher, name, diagonal):
    """Runs this script again for one mesher and file; returns (triangles, seconds) or the reason why not."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))
    done = subprocess.run([sys.executable, __file__, "--run", mesher, name, repr(diagonal)], preexec_fn=limit,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    last = done.stdout.strip().split("\n")[-1].split()
    if done.returncode == 0 and len(last) == 3 and last[0] == "result":
        return int(last[1]), float(last[2])
    return "time-out" if done.returncode < 0 else "failed"


def has(module):
    return subprocess.run([sys.executable, "-c", "import " + module], stderr=subprocess.DEVNULL, check=False).returncode == 0


def least(runs):
    """Calls each of `runs` by turns; returns the results with the least seconds."""
    results = [[run()] for run in runs]

    def is_done(done):
        seconds = [] if isinstance(done[0], str) else [result[1] for result in done]
        return not seconds or max(seconds) > LONG or (len(seconds) >= REPEATS and sum(seconds) > ENOUGH)

    while not all(map(is_done, results)):
        for done, run in zip(results, runs):
            if not is_done(done):
                done.append(run())
    return [done[0] if isinstance(done[0], str) else min(done, key=lambda result: result[1]) for done in results]


def describe(result):
    return result if isinstance(result, str) else "%d, %.2f s, %.1fk/s" % (result[0], result[1], result[0] / result[1] / 1e3)


def bounds(coarseness):
    """The options of mesh_cad for edges that deviate more than by default; with 1 it has its defaults."""
    return ["--gamma", repr(0.05 * coarseness), "--relative-distance", repr(0.0005 * coarseness ** 2)]


def coarseness_for(program, name, number):
    """With which mesh_cad gives about that many triangles, by bisection of the logarithm."""
    low, high = math.log(0.3), math.log(8)
    best = (math.inf, 1.0)
    for _ in range(8):
        middle = (low + high) / 2 if best[0] < math.inf else 0.0
        error = math.log(run_mesh_cad(program, name, bounds(math.exp(middle)))[0] / number)
        best = min(best, (abs(error), math.exp(middle)))
        if abs(error) < 0.03:
            break
        low, high = (middle, high) if error > 0 else (low, middle)
    return best[1]


def rates(run, other):
    """Triangles per second of `run` over those of `other`."""
    return "%.1f" % (run[0] / run[1] * other[1] / other[0])


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    if sys.argv[1] == "--run":
        run = {"gmsh": run_gmsh, "netgen": run_netgen}[sys.argv[2]]
        print("result %d %.6f" % run(sys.argv[3], float(sys.argv[4])))
        return
    program, files = sys.argv[1], sys.argv[2:]
    others = [mesher for mesher, module in (("gmsh", "gmsh"), ("netgen", "netgen.NgOCC")) if has(module)]
    print("| model | mesh_cad |" + "".join(" %s | mesh_cad, as many | times %s |" % (other, other) for other in others))
    print("|---|---:|" + "---:|" * (3 * len(others)))
    for name in files:
        diagonal = run_mesh_cad(program, name, [])[2]
        runs = [lambda: run_mesh_cad(program, name, [])[:2]]
        for other in others:
            first = in_process(other, name, diagonal)
            has_failed = isinstance(first, str)
            options = [] if has_failed else bounds(coarseness_for(program, name, first[0]))
            runs.append(lambda other=other, first=first, has_failed=has_failed:
                        first if has_failed else in_process(other, name, diagonal))
            runs.append(lambda options=options: run_mesh_cad(program, name, options)[:2])
        results = least(runs)
        columns = [describe(results[0])]
        for other, own in zip(results[1::2], results[2::2]):
            columns += [other, "-", "-"] if isinstance(other, str) else [describe(other), describe(own), rates(own, other)]
        print("| %s | %s |" % (os.path.basename(name), " | ".join(columns)), flush=True)


if __name__ == "__main__":
    main()
