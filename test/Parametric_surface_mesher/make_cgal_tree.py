#!/usr/bin/env python3
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a folder with the layout of CGAL's git tree, a folder for each package, of a release of CGAL or of what is installed of it.

Each header is linked into the folder of its package, which its line with $URL$ names. The files of CMake are those of the release. There is
nothing else in the tree: no tests, examples and manuals of CGAL. A tree that an earlier call made is made anew.

Usage: make_cgal_tree.py INCLUDE_FOLDER FOLDER_OF_CGALConfig.cmake FOLDER_OF_MODULES NEW_TREE
"""
import pathlib
import re
import shutil
import sys

MAINTAINER = "made by make_cgal_tree.py\n"
URL = re.compile(rb"\$URL: .*/cgal/blob/[^/]*/([A-Za-z0-9_]*)/")


def package_of(header):
    with open(header, "rb") as file:
        match = URL.search(file.read(4000))
    return match.group(1).decode() if match else "Installation"


def link_headers(include, tree):
    for header in sorted((include / "CGAL").rglob("*")):
        if header.is_file():
            link = tree / package_of(header) / "include" / header.relative_to(include)
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(header)


def main():
    include, config, modules, tree = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    if tree.exists():
        if (tree / "Installation/package_info/Installation/maintainer").read_text() != MAINTAINER:
            sys.exit(f"{tree} exists, and was not made by this program")
        shutil.rmtree(tree)
    link_headers(include, tree)
    for package in tree.iterdir():
        info = package / "package_info" / package.name
        info.mkdir(parents=True)
        (info / "maintainer").write_text(MAINTAINER)
    shutil.copytree(modules, tree / "Installation/cmake/modules")
    new_config = tree / "Installation/lib/cmake/CGAL"
    new_config.mkdir(parents=True)
    for file in config.glob("CGALConfig*.cmake"):
        shutil.copy(file, new_config)
    # As in the git tree.
    (tree / "CGALConfig.cmake").write_text("include(${CMAKE_CURRENT_LIST_DIR}/Installation/lib/cmake/CGAL/CGALConfig.cmake)\n")


if len(sys.argv) != 5:
    sys.exit(__doc__)
main()
