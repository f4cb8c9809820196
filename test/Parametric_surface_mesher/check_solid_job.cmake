# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Walks the way of the page "From STEP to Solver" with a block that Gmsh makes: its mesh is filled with curved tetrahedra by
# Gmsh, and CalculiX has to find the load in the reaction forces.
#
#   cmake -DMESH_CAD=<program> -DSCRIPT_DIR=<examples>/solver -DWORK_DIR=<folder for files> -P check_solid_job.cmake

cmake_minimum_required(VERSION 3.16)

find_program(gmsh gmsh)
find_program(ccx ccx)
find_program(awk awk)
if(NOT gmsh OR NOT ccx OR NOT awk)
  message("Skipped: Gmsh, CalculiX or awk is not installed")
  return()
endif()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})

# run(COMMAND ... [OUTPUT_FILE ...]): in the folder of the files; an error if it fails
macro(run)
  execute_process(${ARGV} WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "status ${status} of: ${ARGV}\n${output}")
  endif()
endmacro()

# A block of 10 x 20 x 30 with a bore along x.
file(WRITE ${WORK_DIR}/block.geo "SetFactory(\"OpenCASCADE\");
Box(1) = {0, 0, 0, 10, 20, 30};
Cylinder(2) = {-1, 10, 20, 12, 0, 0, 5};
BooleanDifference(3) = {Volume{1}; Delete;}{Volume{2}; Delete;};
")
run(COMMAND ${gmsh} block.geo -0 -o block.step)
run(COMMAND ${MESH_CAD} block.step --fineness coarse --max-edge 5 --order 2 --out block.msh)

# The part is the only group of faces that has another name.
file(STRINGS ${WORK_DIR}/block.msh groups REGEX "^2 [0-9]+ \"")
list(FILTER groups EXCLUDE REGEX "\"face_")
string(REGEX MATCH "^2 ([0-9]+)" ignored "${groups}")
file(WRITE ${WORK_DIR}/volume.geo "Merge \"block.msh\";
Surface Loop(1) = Physical Surface {${CMAKE_MATCH_1}};
Volume(1) = {1};
Physical Volume(\"solid\") = {1};
Mesh.ElementOrder = 2;
Mesh.OptimizeThreshold = 0.5;
Mesh.SaveGroupsOfNodes = 1;
")
run(COMMAND ${gmsh} volume.geo -3 -o volume.inp)
if(output MATCHES "jac. < 0")
  message(FATAL_ERROR "tetrahedra are folded:\n${output}")
endif()
run(COMMAND ${awk} -v face=face_3 -f ${SCRIPT_DIR}/solid.awk volume.inp OUTPUT_FILE solid_mesh.inp)

file(WRITE ${WORK_DIR}/solid.inp "*INCLUDE, INPUT=solid_mesh.inp
*MATERIAL, NAME=STEEL
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=VOLUME1, MATERIAL=STEEL
*BOUNDARY
FACE_4, 1, 3
*STEP
*STATIC
*DSLOAD
PRESSED, P, 2.
*NODE FILE
U
*EL FILE
S
*NODE PRINT, NSET=FACE_4, TOTALS=ONLY
RF
*END STEP
")
run(COMMAND ${ccx} solid)

# 2 on the upper side, which measures 200; the lower side bears it.
file(READ ${WORK_DIR}/solid.dat forces)
if(NOT forces MATCHES " (4\\.00000[0-9]|3\\.99999[0-9])E\\+02\n")
  message(FATAL_ERROR "the reaction should be 400:\n${forces}")
endif()

execute_process(COMMAND python3 -c "import meshio" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(status EQUAL 0)
  run(COMMAND python3 ${SCRIPT_DIR}/frd_to_vtu.py solid.frd solid.vtu)
  run(COMMAND python3 -c "import meshio\nprint(meshio.read('solid.vtu').point_data['von Mises'].min() >= 0)")
  if(NOT output MATCHES "True")
    message(FATAL_ERROR "solid.vtu is not as it should be: ${output}")
  endif()
endif()

# The loop: shorter edges where the stress varies.
execute_process(COMMAND python3 --version RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(status EQUAL 0)
  run(COMMAND python3 ${SCRIPT_DIR}/sizes_of_stress.py solid.frd sizes.msh --share 0.05 --shortest 0.5 --longest 5)
  run(COMMAND ${MESH_CAD} block.step --fineness coarse --max-edge 5 --json before.json)
  run(COMMAND ${MESH_CAD} block.step --fineness coarse --max-edge 5 --size-field sizes.msh --json after.json)
  foreach(name before after)
    file(STRINGS ${WORK_DIR}/${name}.json line REGEX "^  \"triangles\": ")
    string(REGEX MATCH "[0-9]+" triangles_${name} "${line}")
  endforeach()
  math(EXPR many "3 * ${triangles_before} / 2")
  if(NOT triangles_after GREATER many)
    message(FATAL_ERROR "${triangles_after} triangles with the lengths of sizes.msh, and ${triangles_before} without them")
  endif()
endif()
