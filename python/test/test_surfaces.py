# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas, functions, patches and models in Python."""
import doctest
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import parametric_surface_mesher as psm

HILL = "u, v, exp(-5*(u*u + v*v))"
SQUARE = ((-1, 1), (-1, 1))
TURN = 2 * math.pi


def hill(u, v):
    return u, v, np.exp(-5 * (u * u + v * v))


def is_closed(mesh):
    """Whether each edge of a triangle is that of another one, in the other direction."""
    sides = {tuple(t[[i, (i + 1) % 3]]) for t in mesh.triangles for i in range(3)}
    return all((b, a) in sides for a, b in sides)


class Formulas(unittest.TestCase):
    def test_text_gives_arrays(self):
        mesh = psm.mesh_surface(HILL, SQUARE)
        self.assertEqual(mesh.points.shape[1:], (3,))
        self.assertEqual(mesh.triangles.shape[1:], (3,))
        self.assertEqual(mesh.uv.shape, (len(mesh), 3, 2))
        self.assertEqual(set(mesh.face_ids), {1})
        self.assertLess(mesh.triangles.max(), len(mesh.points))
        np.testing.assert_allclose(mesh.points[:, 2], np.exp(-5 * (mesh.points[:, :2] ** 2).sum(axis=1)), atol=1e-14)
        np.testing.assert_array_equal(mesh.points[mesh.triangles][:, :, :2], mesh.uv)
        self.assertGreater(mesh.report["min_angle"], 30)
        self.assertAlmostEqual(mesh.angles().min(), mesh.report["min_angle"])
        self.assertEqual(mesh.report["triangles"], len(mesh))

    def test_function_is_compiled(self):
        text = psm.mesh_surface(HILL, SQUARE, max_edge=0.1)
        function = psm.mesh_surface(hill, SQUARE, max_edge=0.1)
        self.assertEqual(function.report["surfaces"], ["formula"])
        np.testing.assert_array_equal(text.points, function.points)
        np.testing.assert_array_equal(text.triangles, function.triangles)

    def test_what_numpy_does_is_compiled(self):
        functions = [
            lambda u, v: np.array([u, v, np.where(u > 0, u ** 3, 0) + np.hypot(u, 2)]),
            lambda u, v: np.stack([u, v, np.arctan2(u, 2 + v) + np.square(v)]),
            lambda u, v: (u, v, np.maximum(u, v) + abs(u) - (-v) + 2 ** u + np.power(3 + u, v)),
            lambda u, v: (u, v, np.float64(2) * u + np.zeros_like(u)),
            lambda u, v: [np.dot(np.array([1.0, 2.0]), np.array([u, v])), v, np.log1p(u * u) / (1 + v * v)],
        ]
        for function in functions:
            surface = psm.Surface(function)
            for u, v in ((0.3, -0.4), (-0.2, 0.6)):
                np.testing.assert_allclose(surface(u, v), [float(x) for x in function(u, v)], rtol=1e-14)
        for function in functions[:4]:
            self.assertEqual(psm.Surface(function).how, "formula")

    def test_derivatives_of_all_functions(self):
        for name in ("sqrt", "cbrt", "exp", "exp2", "expm1", "log", "log2", "log10", "log1p", "sin", "cos", "tan", "sinh", "cosh", "tanh",
                     "asin", "acos", "atan", "asinh", "atanh", "erf", "abs", "square", "radians", "degrees"):
            surface = psm.Surface(f"u, v, {name}(0.2 + u*v) + acosh(2 + u)")
            k, (u, v) = 1e-4, (0.5, 0.6)
            d = surface.derivatives(u, v)
            np.testing.assert_allclose(d[0], (surface(u + k, v) - surface(u - k, v)) / (2 * k), rtol=1e-5, atol=1e-6, err_msg=name)
            np.testing.assert_allclose(d[2], (surface(u + k, v) - 2 * surface(u, v) + surface(u - k, v)) / k ** 2, rtol=1e-3, atol=1e-5)
            mixed = (surface(u + k, v + k) - surface(u + k, v - k) - surface(u - k, v + k) + surface(u - k, v - k)) / (4 * k * k)
            np.testing.assert_allclose(d[3], mixed, rtol=1e-3, atol=1e-5, err_msg=name)

    def test_text_with_definitions_and_conditions(self):
        torus = psm.mesh_surface("r = 2 + cos(v); r*cos(u), r*sin(u), sin(v)", ((0, TURN), (0, TURN)), max_edge=0.4)
        self.assertTrue(torus.report["closed"] and is_closed(torus))
        step = psm.Surface("u, v, u**2 if u > 0 and v <= 1 else -u")
        np.testing.assert_allclose(step(2, 0)[2], 4)
        np.testing.assert_allclose(step(-2, 0)[2], 2)
        np.testing.assert_allclose(step(2, 3)[2], -2)

    def test_function_that_is_called(self):
        table_x = np.linspace(-1, 1, 41)
        table_y = np.cos(2 * table_x)

        def bent(u, v):  # looks up a table, which is no formula
            u, v = np.broadcast_arrays(np.asarray(u, float), np.asarray(v, float))
            return u, v, u * u * 0 + v + 0 * np.interp(u, table_x, table_y)

        def curved(u, v):
            return u, v, math.exp(-u * u - v * v)

        def analytic(u, v):  # objects to symbols, not to complex numbers
            if isinstance(u, psm._formula.Symbol):
                raise TypeError
            return u, v, np.exp(-u * u - v * v)

        for function, how in ((curved, "differences"), (bent, "differences"), (analytic, "complex steps")):
            surface = psm.Surface(function)
            self.assertEqual(surface.how, how)
            mesh = psm.mesh_surface(function, SQUARE, max_edge=0.3)
            self.assertEqual(mesh.report["surfaces"], [how])
            self.assertGreater(mesh.report["min_angle"], 30)
        exact = psm.Surface("u, v, exp(-u*u - v*v)").derivatives(0.3, 0.4)
        np.testing.assert_allclose(psm.Surface(analytic).derivatives(0.3, 0.4), exact, atol=1e-8)
        np.testing.assert_allclose(psm.Surface(curved).derivatives(0.3, 0.4), exact, atol=1e-6)

    def test_given_derivatives(self):
        def derivatives(u, v):
            return (1, 0, 2 * u), (0, 1, 0), (0, 0, 2), (0, 0, 0), (0, 0, 0)

        def function(u, v):
            return float(u), v, u * u
        mesh = psm.mesh_surface(function, SQUARE, derivatives=derivatives, max_edge=0.3)
        self.assertEqual(mesh.report["surfaces"], ["given derivatives"])
        with self.assertRaisesRegex(TypeError, "must return 5 vectors"):
            psm.mesh_surface(function, SQUARE, derivatives=lambda u, v: derivatives(u, v)[:2], max_edge=0.3)
        with self.assertRaises(psm.MeshingError):  # they contradict the function
            psm.mesh_surface(function, SQUARE, derivatives=lambda u, v: ((1, 0, 9), *derivatives(u, v)[1:]), max_edge=0.3)

    def test_domains(self):
        disk = psm.mesh_surface("u, v, 0", psm.Curve.circle((0, 0), 1), max_edge=0.1)
        self.assertAlmostEqual(disk.report["area"], math.pi, delta=0.02)
        ring = psm.mesh_surface("u, v, 0", [psm.Curve("cos(t), sin(t)", 0, math.pi), psm.Curve.arc((0, 0), 1, math.pi, TURN)],
                                holes=[psm.Curve(lambda t: (0.5 * np.cos(t), 0.5 * np.sin(t)), 0, TURN)], max_edge=0.1)
        self.assertAlmostEqual(ring.report["area"], 0.75 * math.pi, delta=0.02)
        triangle = psm.mesh_surface("u, v, 0", [(0, 0), (2, 0), (0, 2)], holes=[[(0.3, 0.3), (0.6, 0.3), (0.3, 0.6)]])
        self.assertAlmostEqual(triangle.report["area"], 2 - 0.045)
        sphere = psm.mesh_surface("cos(v)*cos(u), cos(v)*sin(u), sin(v)", ((0, TURN), (-math.pi / 2, math.pi / 2)))
        self.assertTrue(is_closed(sphere))
        # Around a pole, points of the surface are close to other triangles than those over which they are in the domain.
        near = psm.mesh_surface("cos(v)*cos(u), cos(v)*sin(u), sin(v)", ((0, TURN), (-math.pi / 2, math.pi / 2)), distance=0.001)
        self.assertTrue(near.is_whole, near.summary())
        with_hole = psm.mesh_surface("cos(v)*cos(u), cos(v)*sin(u), sin(v)", ((0, TURN), (-math.pi / 2, math.pi / 2)),
                                     holes=[psm.Curve.circle((2, 0), 0.5)])
        self.assertFalse(with_hole.report["closed"])
        self.assertLess(with_hole.report["area"], sphere.report["area"] - 0.5)
        cut = psm.mesh_surface("cos(u), sin(u), v", ((0, TURN), (0, 1)), closed=False)
        tube = psm.mesh_surface("cos(u), sin(u), v", ((0, TURN), (0, 1)))
        self.assertGreater(len(np.unique(cut.edge_ids)), len(np.unique(tube.edge_ids)))

    def test_errors_are_sentences(self):
        for text, hint in (("u, v", "3 values"), ("u, v, w", "'w'"), ("u, v, sin(u", "never closed"), ("u, v, u^2", r"\*\*"),
                           ("u, v, sin", "call it"), ("u, v, __import__('os')", "not one of"), ("u, v, u.real", "no arithmetic"),
                           ("u, v, sin(u, v)", "takes 1"), ("", "3 values"), ("import os", "no arithmetic"), ("u, v, (1, 2)", "3 values")):
            with self.assertRaisesRegex(psm.FormulaError, hint, msg=text):
                psm.mesh_surface(text, SQUARE)
        for options, error in ((dict(max_edge=-1), psm.MeshingError), (dict(angle=70), psm.MeshingError), (dict(max_edge="x"), TypeError),
                               (dict(self_intersections="x"), ValueError), (dict(size=lambda x, y, z: -1.0), psm.MeshingError)):
            with self.assertRaises(error, msg=str(options)):
                psm.mesh_surface(HILL, SQUARE, **options)
        with self.assertRaisesRegex(psm.MeshingError, "not finite|finite"):
            psm.mesh_surface("u, v, log(u)", SQUARE)
        with self.assertRaisesRegex(psm.MeshingError, "open"):
            psm.mesh_surface("u, v, 0", [psm.Curve.segment((0, 0), (1, 0)), psm.Curve.segment((1, 1), (0, 0))])
        for domain in (((1, 0), (0, 1)), ((0, 1),), [(0, 0), (1, 1)], "square"):
            with self.assertRaises(ValueError, msg=str(domain)):
                psm.mesh_surface(HILL, domain)
        with self.assertRaisesRegex(TypeError, "3 coordinates"):
            psm.mesh_surface(lambda u, v: (u, v), SQUARE)
        with self.assertRaises(ValueError):
            psm.mesh_surface(HILL)
        with self.assertRaisesRegex(TypeError, "no criterion"):
            psm.Model.joined([HILL], [SQUARE]).mesh(maxedge=1)
        with self.assertRaisesRegex(psm.FormulaError, "nested too deeply"):
            psm.mesh_surface("u, v, " + " + ".join(["u"] * 5000), SQUARE)

    def test_errors_of_what_is_not_a_formula_are_sentences(self):
        circle, zero = psm.Curve.circle((0, 0), 0.5), (0, 0, 0)
        for action, error, hint in (
                (lambda: psm.Curve(3, 0, 1), TypeError, "^a curve is made from"),
                (lambda: psm.Curve.segment((0, 0, 1), (1, 1)), ValueError, r"is \(u, v\)"),
                (lambda: psm.mesh_surface(HILL, 3), ValueError, "^a domain is a rectangle .* a loop is"),
                (lambda: psm.mesh_surface(HILL, (-1, 1, -1, 1)), ValueError, "rectangle \\(\\(u_min, u_max\\), \\(v_min, v_max\\)\\)"),
                (lambda: psm.mesh_surface(HILL, SQUARE, holes=circle), ValueError, "^holes: "),
                (lambda: psm.mesh_surface(HILL, SQUARE, threads=0), ValueError, "^threads: "),
                (lambda: psm.mesh_surface(HILL, SQUARE, sweeps=2.5), TypeError, "^sweeps: 2.5 must be a whole number"),
                (lambda: psm.mesh_surface(HILL, SQUARE, time_limit="1"), ValueError, "^time_limit: "),
                (lambda: psm.mesh_surface(HILL, SQUARE, progress=3), TypeError, "^progress: "),
                (lambda: psm.mesh_surface(HILL, SQUARE, size=lambda x, y, z: "small"), TypeError, "^size: .* 'small'$"),
                (lambda: psm.mesh_surface("u, v, log(u*u + v*v)", SQUARE), psm.MeshingError, r"^patch 1: .* \(0, 0\)$"),
                (lambda: psm.mesh_surface(lambda u, v: (u, v, 1j * float(u)), SQUARE), TypeError, "real numbers"),
                (lambda: psm.mesh_surface(lambda u, v: (u, v, float(u)), SQUARE, derivatives=lambda u, v: ((1, 0),) + 4 * (zero,)),
                 TypeError, "3 coordinates, but one has 2"),
                (lambda: psm.mesh_patches([], []), ValueError, "empty"),
                (lambda: psm.mesh_patches([HILL, HILL], [SQUARE]), ValueError, "2 surfaces, but 1 domains"),
                (lambda: psm.mesh_patches([HILL], [SQUARE], tolerance=-1), psm.MeshingError, "tolerance"),
                (lambda: psm.Surface.nurbs(np.zeros((3, 3, 3)), (5, 2)), ValueError, "at least 6 control points"),
                (lambda: psm.Model().add_vertex((1, 2)), ValueError, r"\(x, y, z\)"),
                (lambda: psm.Model().add_edge(-1, 0), ValueError, "add_vertex"),
                (lambda: psm.Model().add_face(HILL, [[(0, "a curve")]]), ValueError, "with a Curve"),
                (lambda: psm.Model().add_face(HILL, [(0, circle)]), ValueError, "with a Curve")):
            with self.assertRaisesRegex(error, hint):
                action()

    def test_errors_of_functions_come_back(self):
        def broken(u, v):
            if u > 0.5:
                raise KeyError("u is too large")
            return float(u), v, 0.0
        with self.assertRaisesRegex(KeyError, "too large"):
            psm.mesh_surface(broken, SQUARE)

        def size(x, y, z):
            raise RuntimeError("no size")
        with self.assertRaisesRegex(RuntimeError, "^no size$"):
            psm.mesh_surface(HILL, SQUARE, size=size)


class Watching(unittest.TestCase):
    def test_sizes(self):
        coarse = psm.mesh_surface(HILL, SQUARE, max_edge=0.2)
        for size in ("0.01 + 0.05*sqrt(x*x + y*y)", lambda x, y, z: 0.01 + 0.05 * np.sqrt(x * x + y * y),
                     lambda x, y, z: 0.01 + 0.05 * math.hypot(x, y)):
            fine = psm.mesh_surface(HILL, SQUARE, max_edge=0.2, size=size)
            self.assertGreater(len(fine), 2 * len(coarse))
            centres = fine.points[fine.triangles].mean(axis=1)
            self.assertGreater((np.hypot(centres[:, 0], centres[:, 1]) < 0.2).mean(), 0.1)

    def test_progress_is_told_and_can_stop(self):
        calls = []
        psm.mesh_surface(HILL, SQUARE, progress=lambda phase, n: calls.append((phase, n)))
        self.assertLessEqual({"refinement", "measuring"}, {phase for phase, _ in calls})
        mesh = psm.mesh_surface(HILL, SQUARE, max_edge=0.005, progress=lambda phase, n: n < 2000)
        self.assertTrue(mesh.report["stopped"])
        self.assertLess(len(mesh), 50000)
        with self.assertRaises(ZeroDivisionError):
            psm.mesh_surface(HILL, SQUARE, progress=lambda phase, n: 1 / 0)

    def test_time_limit(self):
        mesh = psm.mesh_surface(HILL, SQUARE, max_edge=0.002, time_limit=0.2)
        self.assertTrue(mesh.report["stopped"])
        self.assertGreater(mesh.report["area"], 3.99)  # that of the square

    def test_threads_make_no_difference(self):
        one = psm.mesh_surface(HILL, SQUARE, max_edge=0.02)
        two = psm.mesh_surface(HILL, SQUARE, max_edge=0.02, threads=2)
        np.testing.assert_array_equal(one.points, two.points)
        np.testing.assert_array_equal(one.triangles, two.triangles)

    def test_two_threads_of_python_mesh_at_the_same_time(self):
        results = []

        def run():
            results.append(len(psm.mesh_surface(lambda u, v: (float(u), v, math.sin(u)), SQUARE, max_edge=0.2)))
        threads = [threading.Thread(target=run) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
        self.assertEqual(len(results), 3)
        self.assertEqual(len(set(results)), 1)

    @unittest.skipUnless(os.name == "posix", "signals")
    def test_interrupt_gives_a_valid_mesh(self):
        program = ("import parametric_surface_mesher as psm, sys\n"
                   "told = []\n"
                   "def progress(phase, n):\n"
                   "    if n > 1000 and not told:\n"
                   "        told.append(1); print('ready', flush=True)\n"
                   "try:\n"
                   "    psm.mesh_surface('u, v, sin(9*u)', ((-1, 1), (-1, 1)), max_edge=0.0005, progress=progress)\n"
                   "except KeyboardInterrupt as interrupt:\n"
                   "    mesh = interrupt.mesh\n"
                   "    print(mesh.report['stopped'], len(mesh) == mesh.report['triangles'], mesh.report['area'] > 9, flush=True)\n"
                   "    import time\n"
                   "    try:\n"
                   "        print('waiting', flush=True); time.sleep(20)\n"  # the handler of Python is back
                   "    except KeyboardInterrupt:\n"
                   "        print('again')\n")
        process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "ready\n")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.stdout.readline(), "True True True\n")
        self.assertEqual(process.stdout.readline(), "waiting\n")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.communicate(timeout=30)[0], "again\n")


class Patches(unittest.TestCase):
    def test_bezier_and_nurbs(self):
        x, y = np.meshgrid(np.linspace(0, 3, 4), np.linspace(0, 2, 3), indexing="ij")
        net = np.stack([x, y, np.sin(x) * y], axis=-1)
        bezier = psm.Surface.bezier(net)
        np.testing.assert_array_equal(bezier(0, 0), net[0, 0])
        np.testing.assert_array_equal(bezier(1, 0), net[3, 0])
        np.testing.assert_array_equal(bezier(0, 1), net[0, 2])
        spline = psm.Surface.nurbs(net, (3, 2))
        np.testing.assert_allclose(spline(0.3, 0.7), bezier(0.3, 0.7))
        mesh = psm.mesh_surface(spline, max_edge=0.3)
        self.assertGreater(mesh.report["min_angle"], 30)
        with self.assertRaisesRegex(ValueError, "shape"):
            psm.Surface.bezier([[1, 2, 3]])
        with self.assertRaises(psm.MeshingError):
            psm.Surface.nurbs(net, (3, 2), ([0, 1], [0, 1]))

    def test_weights_make_a_cylinder(self):
        s = math.sqrt(0.5)
        net = np.array([[(1, 0, z) for z in (0, 2)], [(1, 1, z) for z in (0, 2)], [(0, 1, z) for z in (0, 2)]], dtype=float)
        quarter = psm.Surface.nurbs(net, (2, 1), weights=[[1, 1], [s, s], [1, 1]])
        self.assertAlmostEqual(np.hypot(*quarter(0.3, 0.5)[:2]), 1)

    def test_teapot(self):
        surfaces = psm.read_bezier_patches(os.path.join(os.environ["EXAMPLES_DATA_DIR"], "teapot.bpt"))
        mesh = psm.mesh_patches(surfaces, max_edge=0.3)
        self.assertEqual(set(mesh.face_ids), set(range(1, len(surfaces) + 1)))
        self.assertGreater(len(mesh.triangles_of(1)), 0)
        with self.assertRaisesRegex(psm.MeshingError, "cannot open"):
            psm.read_bezier_patches("not_there.bpt")

    def test_model_by_hand(self):
        model = psm.Model()
        below, above = model.add_vertex((1, 0, 0)), model.add_vertex((1, 0, 1.5))
        bottom, top, seam = model.add_edge(below, below), model.add_edge(above, above), model.add_edge(below, above)
        segment = psm.Curve.segment
        model.add_face("cos(u), sin(u), v", [[(bottom, segment((0, 0), (TURN, 0))), (seam, segment((TURN, 0), (TURN, 1.5))),
                                              (top, segment((0, 1.5), (TURN, 1.5)), "reversed"),
                                              (seam, segment((0, 0), (0, 1.5)), "reversed")]])
        circle = psm.Curve("cos(2*pi*t), sin(2*pi*t)", 0, 1)
        model.add_face("u, v, 0", [[(bottom, circle)]])
        model.add_face(lambda u, v: (u, v, 1.5), [[(top, circle)]])
        model.orient()
        mesh = model.mesh(max_edge=0.2)
        self.assertTrue(is_closed(mesh))
        self.assertEqual(set(mesh.face_ids), {1, 2, 3})
        self.assertEqual(model.number_of_faces, 3)
        corners = mesh.points[mesh.triangles]
        volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
        self.assertAlmostEqual(volume, 1.5 * math.pi, delta=0.1)
        with self.assertRaises(psm.MeshingError):
            model.add_edge(0, 17)
        with self.assertRaises(ValueError):
            psm.Model().mesh()


class Files(unittest.TestCase):
    def test_all_formats(self):
        mesh = psm.mesh_surface(HILL, SQUARE, max_edge=0.3)
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("off", "obj", "ply", "stl", "vtu", "msh", "msh2", "inp", "bdf", "unv"):
                path = os.path.join(folder, "hill." + ending)
                mesh.save(path)
                self.assertGreater(os.path.getsize(path), 1000, ending)
            mesh.save(os.path.join(folder, "binary.stl"), binary=True)
            with self.assertRaisesRegex(psm.MeshingError, "must end in"):
                mesh.save(os.path.join(folder, "hill.xyz"))
            for name in ("hill.off", "hill.html"):
                with self.assertRaisesRegex(psm.MeshingError, "cannot write|three.js", msg=name):
                    mesh.save(os.path.join(folder, "no", name))
            with self.assertRaisesRegex(psm.MeshingError, "^brep: "):
                mesh.brep()

    def test_notebooks_and_pictures(self):
        mesh = psm.mesh_surface(HILL, SQUARE, max_edge=0.3)
        self.assertIn("<", mesh._repr_html_())
        self.assertIn("<table>", mesh._table())
        try:
            self.assertIn("<html", mesh.page())
            self.assertIn("<iframe", mesh._repr_html_())
        except psm.MeshingError as error:
            self.assertIn("three.js", str(error))
        self.assertIn("triangles", repr(mesh))
        self.assertRegex(mesh.summary(), r"^mesh of 1 face; 2 x 2 x \S+\n  \d+ triangles, \d+ vertices, open: it has 1 border\n  angles: minimum ")
        self.assertTrue(mesh.summary().endswith("  verdict: all is well\n"), mesh.summary())
        coarse = psm.mesh_surface(HILL, SQUARE, max_edge=0.5, min_edge=0.4, distance=0.01)
        self.assertIn("a smaller min_edge lets them be divided", coarse.summary())
        self.assertIn("WRONG: the mesh is much farther from the surface than allowed", coarse.summary())
        self.assertFalse(coarse.is_whole)
        try:
            import matplotlib
        except ImportError:
            self.skipTest("no Matplotlib")
        matplotlib.use("Agg")
        mesh.plot("angle", show=False)
        mesh.plot(show=False)

    def test_help_teaches(self):
        for thing in (psm.mesh_surface, psm.mesh_patches, psm.Surface, psm.Model, psm.Curve, psm.Mesh, psm.Mesh.save):
            self.assertGreater(len(thing.__doc__), 80, thing)
        names = {"np": np, "psm": psm, "Curve": psm.Curve}
        results = [doctest.testmod(module, extraglobs=names) for module in (psm._surfaces, psm._model)]
        self.assertEqual([result.failed for result in results], [0, 0])
        self.assertGreater(sum(result.attempted for result in results), 5)


if __name__ == "__main__":
    unittest.main()
