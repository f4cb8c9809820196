# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes displacements and von Mises stresses of a result of CalculiX as .vtu, for ParaView. Needs python3-meshio.
#
#   python3 frd_to_vtu.py solid.frd solid.vtu
import sys

import meshio
import numpy as np

from read_frd import check_frd, read_frd

# By the number of a kind of element in the file: its name, and how many of its nodes are written. Shells are wedges there.
KINDS = {"2": ("wedge", 6), "5": ("wedge", 6), "6": ("tetra10", 10)}

points, elements, values = read_frd(sys.argv[1])
check_frd(sys.argv[1], elements, values, KINDS, ["STRESS", "DISP"])
nodes_of_elements = {}
for kind, nodes in elements:
    nodes_of_elements.setdefault(kind, []).append(nodes)
index = {node: i for i, node in enumerate(points)}
cells = []
for kind, of_kind in nodes_of_elements.items():
    name, number_of_nodes = KINDS[kind]
    cells.append((name, [[index[node] for node in nodes[:number_of_nodes]] for nodes in of_kind]))
xx, yy, zz, xy, yz, zx = np.array([values["STRESS"][node] for node in points]).T
point_data = {
    "displacement": np.array([values["DISP"][node] for node in points]),
    "von Mises": np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + zx**2)),
}
meshio.Mesh(list(points.values()), cells, point_data=point_data).write(sys.argv[2])
