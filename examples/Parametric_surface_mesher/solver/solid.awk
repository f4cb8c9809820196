# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes a mesh for CalculiX of an .inp file in which Gmsh has written ten-node tetrahedra: nodes, sets of nodes and
# tetrahedra are kept, triangles and lines are not. The sides of tetrahedra all nodes of which are in one set of nodes are
# appended as the surface PRESSED.
#
#   awk -v face=face_37 -f solid.awk volume.inp > solid_mesh.inp
BEGIN {
  FS = ", *"
  # The corners and mid-side nodes of the sides S1 to S4.
  split("1 2 3 5 6 7  1 2 4 5 9 8  2 3 4 6 10 9  1 3 4 7 10 8", node_of_side, " ")
}
/^\*/ {
  are_tetrahedra = /C3D10/
  is_kept = are_tetrahedra || /^\*NODE/ || /^\*NSET/
  is_set_of_face = $0 == "*NSET,NSET=" face
}
is_kept { print }
/^\*/ { next }
are_tetrahedra { tetrahedra[++number_of_tetrahedra] = $0 }
is_set_of_face {
  for (i = 1; i <= NF; ++i)
    if ($i != "") is_on_face[$i]
}
END {
  print "*SURFACE, NAME=PRESSED"
  for (t = 1; t <= number_of_tetrahedra; ++t) {
    split(tetrahedra[t], numbers)
    for (side = 0; side < 4; ++side) {
      for (i = 1; i <= 6 && numbers[1 + node_of_side[6 * side + i]] in is_on_face; ++i);
      if (i > 6) {
        print numbers[1] ", S" side + 1
        ++number_of_sides
      }
    }
  }
  if (!number_of_sides) {
    print "solid.awk: no tetrahedron has a side on \"" face "\"" > "/dev/stderr"
    exit 1
  }
}
