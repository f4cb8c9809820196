# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks at pages of meshes in a browser: whether they load, draw, are coloured, can be cut, and a click picks the right face.

    python3 check_page.py <program mesh_patch> <folder for files>
"""

import os
import subprocess
import sys

from browser import Browser_test, run_tests

PROGRAM, FOLDER = sys.argv[1:3]
# A part of the view without title, tools and panel.
VIEW = (120, 90, 500, 480)


def make_page(name, *arguments):
    path = os.path.join(FOLDER, name + ".html")
    subprocess.run((PROGRAM, *arguments, "--page", path, "--quiet"), check=True)
    return path


class Page(Browser_test):
    def open(self, name, *arguments):
        self.browser.open(make_page(name, *arguments))
        self.browser.wait_for("!!window.meshPage || !document.getElementById('failure').hidden")
        self.assertEqual(self.browser.evaluate("document.getElementById('failure').textContent"), "")
        # Triangles of a face that are seen from in front, at places where nothing lies above the view.
        self.browser.evaluate("""window.seen = face => {
            const page = meshPage, view = page.view, found = [];
            for (let t = page.mesh.begins[face]; t < page.mesh.begins[face + 1]; ++t) {
              const p = page.mesh.positions;
              const corner = i => { const v = 3 * page.mesh.triangles[3 * t + i]; return new THREE.Vector3(p[v], p[v + 1], p[v + 2]); };
              const [a, b, c] = [corner(0), corner(1), corner(2)], normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
              const middle = a.clone().add(b).add(c).divideScalar(3), place = view.placeOf(middle);
              const isFree = document.elementFromPoint(place.x, place.y) === view.canvas;
              const isInFront = normal.dot(view.camera.position.clone().sub(middle).normalize()) > 0.2;
              if (isFree && isInFront) found.push({ triangle: t, x: place.x, y: place.y });
            }
            return found[Math.floor(found.length / 2)];
          }""")

    def view(self):
        return self.browser.screenshot(*VIEW)

    def test_draws_and_has_colours(self):
        self.open("box", "box", "--max-edge", "0.1")
        self.assertGreater(len(self.view().colors()), 100)
        names = self.browser.evaluate("meshPage.colorings.map(c => c.name)")
        for name in ("one colour", "face", "smallest angle", "2r/R", "distance from the surface", "curvature", "what was not met"):
            self.assertIn(name, names)
        # On a box nothing is curved, so that only these differ.
        pictures = []
        for name in ("one colour", "face", "smallest angle"):
            self.browser.evaluate("meshPage.byId('coloring').value = '%s'; meshPage.byId('coloring')"
                                  ".dispatchEvent(new Event('change'))" % name)
            pictures.append(self.view())
        for i in range(3):
            for k in range(i):
                self.assertGreater(pictures[i].difference(pictures[k]), 0.1)
        self.assertEqual(self.browser.errors, [])

    def test_a_click_picks_the_face(self):
        self.open("box", "box", "--max-edge", "0.1")
        clicked = 0
        for face in range(6):
            seen = self.browser.evaluate("seen(%d)" % face)
            if not seen:  # it is behind
                continue
            clicked += 1
            self.browser.click(seen["x"], seen["y"])
            self.assertEqual(self.browser.evaluate("meshPage.selected"), seen["triangle"])
            text = self.browser.evaluate("document.getElementById('selection').innerText")
            self.assertIn("face\t%d" % (face + 1), text)
            self.assertEqual(self.browser.evaluate("document.getElementById('domain-title').textContent"), "Domain of face %d" % (face + 1))
            self.browser.evaluate("document.getElementById('domain-close').click()")
        self.assertEqual(clicked, 3)
        self.assertEqual(self.browser.errors, [])

    def test_hides_faces(self):
        self.open("box", "box", "--max-edge", "0.1")
        seen = next(filter(None, (self.browser.evaluate("seen(%d)" % face) for face in range(6))))
        whole = self.view()
        self.browser.click(seen["x"], seen["y"])
        self.browser.evaluate("[...document.querySelectorAll('.actions button')].find(b => b.textContent === 'Hide face').click()")
        self.assertGreater(self.view().difference(whole), 0.05)
        self.assertNotEqual(self.browser.evaluate("meshPage.view.pick(%f, %f)" % (seen["x"], seen["y"])), seen["triangle"])
        self.browser.evaluate("document.getElementById('show-all').click()")
        self.browser.mouse("mouseMoved", 5, 5)
        self.browser.wait_for("meshPage.hovered < 0 && !meshPage.waiting")
        self.assertEqual(self.view().difference(whole), 0)
        self.assertEqual(self.browser.errors, [])

    def test_the_domain_is_beside_it(self):
        self.open("peak", "peak", "--max-edge", "0.15", "--gamma", "0.25")
        self.browser.evaluate("meshPage.select(100, null)")
        box = self.browser.evaluate("(b => [b.left, b.top, b.width, b.height])(meshPage.byId('domain').getBoundingClientRect())")
        picture = self.browser.screenshot(*box)
        self.assertGreater(len(picture.colors()), 20)
        self.assertTrue(any(r > 180 and g < 110 for r, g, *_ in picture.colors()), "there is no ellipse")
        # A triangle under the mouse, the largest one, is marked in both views.
        x, y, triangle = self.browser.evaluate("""(() => { const d = meshPage.domain, corners = t => [0, 1, 2].map(i => d.place(3 * t + i));
            const area = ([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            let largest = 0;
            for (let t = 0; t < meshPage.mesh.size; ++t) if (area(corners(t)) > area(corners(largest))) largest = t;
            const p = new THREE.Vector3(), box = d.canvas.getBoundingClientRect();
            for (const c of corners(largest)) p.add(new THREE.Vector3(...c, 0));
            p.divideScalar(3).project(d.camera);
            return [box.left + 0.5 * (p.x + 1) * box.width, box.top + 0.5 * (1 - p.y) * box.height, largest]; })()""")
        self.browser.mouse("mouseMoved", x, y)
        self.browser.wait_for("meshPage.hovered === %d" % triangle)
        self.assertEqual(self.browser.evaluate("meshPage.view.hovered.geometry.drawRange.start"), 3 * triangle)
        # The ellipse runs through the corners of its triangle.
        error = self.browser.evaluate("""(() => { const d = meshPage.domain, ends = d.ellipseEnds(%d);
            const distance = p => {
              let least = Infinity;
              for (let i = 0; i < ends.length; i += 3) least = Math.min(least, Math.hypot(ends[i] - p[0], ends[i + 1] - p[1]));
              return least;
            };
            const size = Math.hypot(ends[0] - ends[108], ends[1] - ends[109]);
            return Math.max(...[0, 1, 2].map(i => distance(d.place(%d + i)))) / size; })()""" % (triangle, 3 * triangle))
        self.assertLess(error, 0.05)
        self.assertEqual(self.browser.errors, [])

    def test_cuts_and_finds(self):
        self.open("torus", "torus", "--max-edge", "0.2")
        whole = self.view()
        self.browser.evaluate("const axis = meshPage.byId('section-axis'); axis.value = 'z'; axis.dispatchEvent(new Event('change'))")
        cut = self.view()
        self.assertGreater(cut.difference(whole), 0.05)
        self.assertTrue(self.browser.evaluate("meshPage.view.section.cap.visible"))
        before = self.browser.evaluate("meshPage.view.camera.position.toArray()")
        self.browser.evaluate("document.querySelector('.finding').click()")
        self.browser.wait_for("!meshPage.view.flight")
        self.assertNotEqual(self.browser.evaluate("meshPage.view.camera.position.toArray()"), before)
        worst = self.browser.evaluate("meshPage.mesh.scalars[0].data[meshPage.selected] - Math.min(...meshPage.mesh.scalars[0].data)")
        self.assertEqual(worst, 0)
        self.assertEqual(self.browser.errors, [])


if __name__ == "__main__":
    os.makedirs(FOLDER, exist_ok=True)
    run_tests()
