# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes displacements and von Mises stresses of a result of CalculiX as .vtu, for ParaView. Needs python3-meshio.
#
#   python3 frd_to_vtu.py solid.frd solid.vtu
import sys

import meshio
import numpy as np

# By the number of a kind of element in the file: its name, and how many of its nodes are written. Shells are wedges there.
KINDS = {"2": ("wedge", 6), "5": ("wedge", 6), "6": ("tetra10", 10)}

points, nodes_of_elements, values, block = {}, {}, {}, ""
with open(sys.argv[1]) as file:
    for line in file:
        key = line.split()[0]
        if key in ("2C", "3C"):
            block = key
        elif key == "-4":
            block = line.split()[1]
            values[block] = {}
        elif key == "-3":
            block = ""
        elif block == "3C" and key == "-1":
            nodes = []
            nodes_of_elements.setdefault(line.split()[2], []).append(nodes)
        elif block == "3C" and key == "-2":
            nodes += [int(node) for node in line.split()[1:]]
        elif block and key == "-1":
            # Columns of fixed width, with no space between where a number is negative.
            numbers = [float(line[i : i + 12]) for i in range(13, len(line) - 1, 12)]
            (points if block == "2C" else values[block])[int(line[3:13])] = numbers

index = {node: i for i, node in enumerate(points)}
cells = []
for kind, elements in nodes_of_elements.items():
    name, number_of_nodes = KINDS[kind]
    cells.append((name, [[index[node] for node in nodes[:number_of_nodes]] for nodes in elements]))
xx, yy, zz, xy, yz, zx = np.array([values["STRESS"][node] for node in points]).T
point_data = {
    "displacement": np.array([values["DISP"][node] for node in points]),
    "von Mises": np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + zx**2)),
}
meshio.Mesh(list(points.values()), cells, point_data=point_data).write(sys.argv[2])
