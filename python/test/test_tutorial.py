# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The snippets of the page "Meshing in Python", one after the other."""
import os
import pathlib
import re
import shutil
import tempfile
import unittest

import parametric_surface_mesher as psm

PAGE = pathlib.Path(__file__).parents[2] / "doc" / "Parametric_surface_mesher" / "Python.txt"
LINKRODS = pathlib.Path("/usr/share/opencascade/data/step/linkrods.step")


class Tutorial(unittest.TestCase):
    def test_snippets(self):
        snippets = re.findall(r"^~~~\{\.py\}\n(.*?)^~~~$", PAGE.read_text(), flags=re.MULTILINE | re.DOTALL)
        self.assertGreater(len(snippets), 10)
        has_cad = hasattr(psm._core, "mesh_cad") and LINKRODS.exists()
        names = {}
        old_folder = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                if has_cad:
                    shutil.copy(LINKRODS, "part.step")
                for snippet in snippets:
                    if has_cad or "part.step" not in snippet:
                        with self.subTest(snippet=snippet):
                            exec(compile(snippet, str(PAGE), "exec"), names)
            finally:
                os.chdir(old_folder)


if __name__ == "__main__":
    unittest.main()
