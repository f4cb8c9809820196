# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Reads the results of CalculiX. The scripts beside it use it.


def read_frd(file_name):
    """Returns the points by number of node, the elements, and the values.

    An element is a pair of the number of its kind and the list of its nodes. The values are a dictionary for each name, as "STRESS": by number of node, the list
    of components. Of several steps the last one counts.
    """
    points, elements, values, block = {}, [], {}, ""
    with open(file_name) as file:
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
                elements.append((line.split()[2], []))
            elif block == "3C" and key == "-2":
                elements[-1][1].extend(int(node) for node in line.split()[1:])
            elif block and key == "-1":
                # Columns of fixed width, with no space between where a number is negative.
                numbers = [float(line[i : i + 12]) for i in range(13, len(line) - 1, 12)]
                (points if block == "2C" else values[block])[int(line[3:13])] = numbers
    return points, elements, values


def check_frd(file_name, elements, values, kinds, names):
    """Ends the program with a sentence if there are elements of other kinds, or some values are missing."""
    for kind, _ in elements:
        if kind not in kinds:
            raise SystemExit(f"{file_name}: elements of the kind {kind} are not read, but those of the kinds {', '.join(kinds)}")
    for name in names:
        if not values.get(name):
            raise SystemExit(f"{file_name}: there are no values {name} at the nodes")
