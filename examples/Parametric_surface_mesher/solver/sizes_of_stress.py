# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes wanted edge lengths for mesh_cad --size-field, from the stresses of a result of CalculiX. In each element, the von Mises stress may
# vary by a share of the largest one there is. Elements are tetrahedra, or triangles (*EL FILE, OUTPUT=2D), of first or second order.
#
#   python3 sizes_of_stress.py solid.frd sizes.msh --share 0.1 --shortest 0.5 --longest 5
import argparse
import math

from read_frd import check_frd, read_frd

# By the number of a kind of element in the result: the number of its corners, and the number of its kind for Gmsh.
KINDS = {"3": (4, 4), "6": (4, 4), "7": (3, 2), "8": (3, 2)}

parser = argparse.ArgumentParser()
parser.add_argument("result")
parser.add_argument("sizes")
parser.add_argument("--share", type=float, default=0.1, help="of the largest stress, by which the stress may vary in an element")
parser.add_argument("--shortest", type=float, required=True, help="wanted edge length; that of --min-edge or more")
parser.add_argument("--longest", type=float, required=True, help="wanted edge length; that of --max-edge")
arguments = parser.parse_args()


def von_mises(xx, yy, zz, xy, yz, zx):
    return math.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (xy**2 + yz**2 + zx**2))


points, elements, values = read_frd(arguments.result)
check_frd(arguments.result, elements, values, KINDS, ["STRESS"])
stresses = {node: von_mises(*components) for node, components in values["STRESS"].items()}

largest_stress = max(stresses.values())
if largest_stress == 0:
    raise SystemExit(f"{arguments.result}: there is no stress")
lengths = dict.fromkeys(points, arguments.longest)
for kind, nodes in elements:
    corners = nodes[: KINDS[kind][0]]
    of_element = [stresses[node] for node in corners]
    variation = (max(of_element) - min(of_element)) / largest_stress
    sides = [math.dist(points[a], points[b]) for i, a in enumerate(corners) for b in corners[:i]]
    if variation > 0:
        length = sum(sides) / len(sides) * arguments.share / variation
        for node in corners:
            lengths[node] = max(min(lengths[node], length), arguments.shortest)

with open(arguments.sizes, "w") as file:
    file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n")
    file.writelines(f"{node} {x!r} {y!r} {z!r}\n" for node, (x, y, z) in points.items())
    file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
    for i, (kind, nodes) in enumerate(elements):
        number_of_corners, kind_of_gmsh = KINDS[kind]
        file.write(f"{i + 1} {kind_of_gmsh} 2 0 1 {' '.join(map(str, nodes[:number_of_corners]))}\n")
    file.write(f'$EndElements\n$NodeData\n1\n"size"\n1\n0.0\n3\n0\n1\n{len(lengths)}\n')
    file.writelines(f"{node} {length!r}\n" for node, length in lengths.items())
    file.write("$EndNodeData\n")
