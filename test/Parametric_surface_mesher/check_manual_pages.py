# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks at three pages of the manual in a browser: whether their pictures and formulas are shown, and whether they fit into the window.

    python3 check_manual_pages.py <folder of the manual's pages>
"""

import os
import sys
import unittest

from browser import Browser_test, run_tests

FOLDER = sys.argv[1]
WIDTH, HEIGHT = 1200, 800
HAS_MATHJAX = os.path.exists(os.path.join(FOLDER, "mathjax", "MathJax.js"))


class Manual(Browser_test):
    WINDOW = (WIDTH, HEIGHT)

    def open(self, name):
        self.browser.open(os.path.join(FOLDER, name + ".html"))
        self.assertGreater(len(self.browser.screenshot(0, 0, WIDTH, HEIGHT).colors()), 20, "the page is blank")
        broken = self.browser.evaluate("[...document.images].filter(i => i.naturalWidth === 0).map(i => i.src)")
        self.assertEqual(broken, [], "pictures that are not shown")

    def text(self):
        return self.browser.evaluate("document.querySelector('.contents').innerText")

    def wait_for_formulas(self):
        self.browser.wait_for("window.MathJax && MathJax.Hub && MathJax.isReady && !MathJax.Hub.queue.pending")

    def test_first_page(self):
        self.open("index")
        self.assertGreater(self.browser.evaluate("document.querySelectorAll('.contents img').length"), 0)
        self.assertIn("mesh_cad", self.text())
        widest = self.browser.evaluate(
            "Math.max(...[...document.querySelectorAll('.contents img')].map(i => i.getBoundingClientRect().right))")
        self.assertLessEqual(widest, WIDTH)

    @unittest.skipUnless(HAS_MATHJAX, "MathJax is not there")
    def test_method_has_formulas(self):
        self.open("PkgParametricSurfaceMesherMethod")
        self.wait_for_formulas()
        self.assertGreater(self.browser.evaluate("document.querySelectorAll('.MathJax, .MathJax_SVG, .MathJax_CHTML').length"), 10)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.MathJax_Error, .merror').length"), 0)
        for source in ("\\(", "\\frac", "\\sqrt"):
            self.assertNotIn(source, self.text())

    def test_reference(self):
        self.open("classCGAL_1_1Parametric__surface__mesh__criteria")
        for name in ("set_max_edge", "set_distance", "set_detail"):
            self.assertIn(name, self.text())


if __name__ == "__main__":
    run_tests()
