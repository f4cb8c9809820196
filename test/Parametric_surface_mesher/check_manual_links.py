#!/usr/bin/env python3
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds links of the manual to files and places that do not exist, pictures that no page shows, and paths of the machine that it was
made on.

Usage: check_manual_links.py FOLDER FORBIDDEN_TEXT FOLDER_OF_PICTURES
"""
import html.parser
import os
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.places, self.links = set(), []
        with open(path, encoding="utf-8") as file:
            self.text = file.read()
        self.feed(self.text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places.update(values[name] for name in ("id", "name") if values.get(name))
        self.links.extend(values[name] for name in ("href", "src") if values.get(name))


def main():
    folder, forbidden, pictures = sys.argv[1:]
    pages = {name: Page(os.path.join(folder, name)) for name in sorted(os.listdir(folder)) if name.endswith(".html")}
    faults = [name + " has " + forbidden for name, page in pages.items() if forbidden in page.text]
    shown = {os.path.basename(link) for page in pages.values() for link in page.links}
    faults += [name + " is shown nowhere" for name in sorted(os.listdir(pictures)) if name not in shown]
    for name, page in pages.items():
        for link in page.links:
            url = urllib.parse.urlsplit(link)
            target = urllib.parse.unquote(url.path) or name
            if url.scheme or url.netloc or target.startswith("mathjax/"):
                continue
            if not os.path.exists(os.path.join(folder, target)):
                faults.append(name + ": no file " + target)
            elif url.fragment and target in pages and url.fragment not in pages[target].places:
                faults.append(name + ": no place " + link)
    print("\n".join(faults) or "%d pages, all links are good" % len(pages))
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
