# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""CAD files in Python."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import parametric_surface_mesher as psm

# Part of a Debian package (occt-misc).
LINKRODS = pathlib.Path("/usr/share/opencascade/data/step/linkrods.step")


@unittest.skipUnless(hasattr(psm._core, "mesh_cad"), "built without Open CASCADE")
class Errors(unittest.TestCase):
    def test_are_sentences(self):
        for source, options, error, hint in (
                ("not_there.step", {}, psm.MeshingError, "cannot open"), ("x.txt", {}, psm.MeshingError, "cannot open"),
                (b"hello", {}, psm.MeshingError, "neither a STEP"), (b"ISO-10303-21;\nnothing", {}, psm.MeshingError, "STEP"),
                (b"DBRep_DrawableShape\n", {}, psm.MeshingError, "BREP"), (17, {}, TypeError, "neither a path"),
                ("x.step", {"max_edge": -1}, psm.MeshingError, "^max_edge: "),
                ("x.step", {"maxedge": 1}, TypeError, "no argument 'maxedge'"),
                ("x.step", {"out": "y"}, TypeError, "no argument 'out'"),
                ("x.step", {"detail": 1, "keep_detail": True}, psm.MeshingError, "keep_detail"),
                ("x.step", {"size": "x +"}, psm.FormulaError, "cannot be read"),
                ("x.step", {"faces": []}, ValueError, "^faces: it is empty"),
                ("x.step", {"heal": "yes"}, psm.MeshingError, "^heal must be True or False"),
                (b"ISO-10303-21;\nnothing", {}, psm.MeshingError, "cannot read the given shape.step")):
            with self.assertRaisesRegex(error, hint, msg=f"{source!r} {options}"):
                psm.mesh_cad(source, **options)

    def test_help_lists_the_options(self):
        for option in ("max_edge", "sphere_size", "self_intersections", "keep_detail"):
            self.assertIn(f"    {option}\n", psm.mesh_cad.__doc__)


@unittest.skipUnless(hasattr(psm._core, "mesh_cad") and LINKRODS.exists(), "no Open CASCADE, or no CAD file")
class Cad_file(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = psm.mesh_cad(LINKRODS, fineness="coarse")

    def test_arrays_and_report(self):
        mesh = self.mesh
        self.assertTrue(mesh.report["closed"] and mesh.is_whole)
        self.assertEqual(mesh.report["triangles"], len(mesh))
        self.assertEqual(set(mesh.face_ids), set(range(1, 38)))
        self.assertEqual(set(mesh.part_ids), {1})
        self.assertEqual(mesh.uv.shape, (len(mesh), 3, 2))
        self.assertEqual(len(mesh.edges), len(mesh.edge_ids))
        self.assertLessEqual(mesh.edge_ids.max(), mesh.report["edges"])
        self.assertEqual(mesh.names["parts"], {1: "the product name"})
        np.testing.assert_array_equal(mesh.triangles_of("the product name"), np.arange(len(mesh)))
        self.assertEqual(len(mesh.triangles_of(3)), (mesh.face_ids == 3).sum())
        with self.assertRaisesRegex(KeyError, "the product name"):
            mesh.triangles_of("nothing")
        with self.assertRaisesRegex(psm.MeshingError, "listed by the program's --list"):
            psm.mesh_cad(LINKRODS, faces="nothing")
        json.dumps(mesh.report)

    def test_summary_is_for_people(self):
        summary = self.mesh.summary()
        self.assertRegex(summary, r"^\S+: 'the product name', 1 solid, 37 faces; 5\.02 x 1\.5 x 2 mm\n")
        self.assertRegex(summary, r"\n  angles: minimum \S+, mean \S+ degrees; none below 10\n")
        self.assertRegex(summary, r"\n  note: \d+ triangles are below 30 degrees: the fixed boundary leaves no better point\n")
        self.assertTrue(summary.endswith("  verdict: nothing is wrong with the mesh\n"), summary)
        self.assertIn("(growth)", summary)  # the argument, not the option
        self.assertGreater(self.mesh.report["seconds"]["meshing"], 0)

    def test_measuring_may_be_left_out(self):
        mesh = psm.mesh_cad(LINKRODS, fineness="coarse", no_measure=True)
        self.assertIsNone(mesh.report["distance"])
        self.assertIn("distance from the shape: not measured", mesh.summary())
        self.assertIn("not measured", mesh._table())
        self.assertTrue(mesh.is_whole)
        np.testing.assert_array_equal(mesh.points, self.mesh.points)

    def test_bytes_give_the_same(self):
        of_bytes = psm.mesh_cad(LINKRODS.read_bytes(), fineness="coarse")
        np.testing.assert_array_equal(self.mesh.points, of_bytes.points)
        np.testing.assert_array_equal(self.mesh.triangles, of_bytes.triangles)

    def test_shapes_of_other_libraries(self):
        brep = self.mesh.brep()

        class Shape:  # as in CadQuery
            def exportBrep(self, stream):
                stream.write(brep)

        class Workplane:
            def __init__(self, *values):
                self.values = values

            def vals(self):
                return list(self.values)

        class Assembly:
            def toCompound(self):
                return Shape()

        class Shape_of_freecad:
            def exportBrepToString(self):
                return brep.decode()
        for shape in (Shape(), Workplane(Shape()), Assembly(), Shape_of_freecad()):
            self.assertEqual(psm.mesh_cad(shape, fineness="coarse", faces=[1]).report["faces"], 37)
        with self.assertRaisesRegex(psm.MeshingError, "no shape"):
            psm.mesh_cad(Workplane("a vector"))

    def test_brep_comes_back_and_can_be_meshed(self):
        brep = self.mesh.brep()
        self.assertIn(b"PolygonOnTriangulations", brep)
        again = psm.mesh_cad(brep, fineness="coarse")
        self.assertEqual(again.report["faces"], 37)
        self.assertTrue(again.report["closed"])

    def test_all_formats(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("off", "obj", "ply", "stl", "vtu", "msh", "msh2", "inp", "bdf", "unv", "glb", "brep"):
                path = pathlib.Path(folder, "rods." + ending)
                self.mesh.save(path)
                self.assertGreater(path.stat().st_size, 1000, ending)
            self.mesh.save(os.path.join(folder, "b.stl"), binary=True)
            self.mesh.save(os.path.join(folder, "p.msh"), node_parameters=True)
            with self.assertRaisesRegex(psm.MeshingError, "must end in"):
                self.mesh.save(os.path.join(folder, "rods.xyz"))

    def test_options(self):
        some = psm.mesh_cad(LINKRODS, fineness="coarse", faces=[1, 4], face_size={4: 0.003}, unit="CM", threads=2,
                            self_intersections="ignore")
        self.assertEqual(set(some.face_ids), {1, 4})
        self.assertGreater(len(some.triangles_of(4)), 2 * len(self.mesh.triangles_of(4)))
        place = self.mesh.points[self.mesh.triangles[0]].mean(axis=0)
        with_points = psm.mesh_cad(LINKRODS, fineness="coarse", faces="1", parts=[1], point=[place, tuple(place + 0.01)],
                                   local_size="face:1:0.05")
        self.assertEqual([name for name in with_points.groups if name.startswith("point_")], ["point_1", "point_2"])
        curved = psm.mesh_cad(LINKRODS, fineness="coarse", order=2)
        self.assertEqual(curved.report["order"], 2)

    def test_sizes(self):
        low, high = self.mesh.points.min(axis=0), self.mesh.points.max(axis=0)
        d = float(np.linalg.norm(high - low))
        for unit, scale in (("MM", 1.0), ("CM", 0.1)):
            size = f"{0.005 * d * scale} + 0.3*abs(x - {low[0] * scale})"
            fine = psm.mesh_cad(LINKRODS, fineness="coarse", unit=unit, size=size)
            called = psm.mesh_cad(LINKRODS, fineness="coarse", unit=unit,
                                  size=lambda x, y, z: float(0.005 * d * scale + 0.3 * abs(float(x) - low[0] * scale)))
            self.assertGreater(len(fine), 1.2 * len(self.mesh))
            self.assertEqual(len(fine), len(called))

    def test_progress_and_errors_of_functions(self):
        phases = set()
        psm.mesh_cad(LINKRODS, fineness="coarse", progress=lambda phase, n: phases.add(phase))
        self.assertLessEqual({"division", "measuring"}, phases)
        stopped = psm.mesh_cad(LINKRODS, progress=lambda phase, n: phase != "triangulation")
        self.assertTrue(stopped.report["stopped"] and stopped.report["closed"])
        self.assertTrue(psm.mesh_cad(LINKRODS, time_limit=0).report["stopped"])

        def size(x, y, z):
            raise RuntimeError("no size")
        with self.assertRaisesRegex(RuntimeError, "^no size$"):
            psm.mesh_cad(LINKRODS, size=size)

    @unittest.skipUnless(os.name == "posix", "signals")
    def test_interrupt_gives_a_valid_mesh(self):
        program = ("import parametric_surface_mesher as psm\n"
                   "told = []\n"
                   "def progress(phase, n):\n"
                   "    if phase == 'refinement' and not told:\n"
                   "        told.append(1); print('ready', flush=True)\n"
                   "try:\n"
                   f"    psm.mesh_cad({str(LINKRODS)!r}, max_edge=0.004, progress=progress)\n"
                   "except KeyboardInterrupt as interrupt:\n"
                   "    print(interrupt.mesh.report['stopped'], interrupt.mesh.report['closed'])\n")
        process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "ready\n")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=60)[0], "True True\n")


if __name__ == "__main__":
    unittest.main()
