# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Configures the package as where libraries are missing: what is needed is asked for in a sentence, and so is what a program needs by
# whoever builds that program. SOURCE_DIR: of the package; WORK_DIR: is made anew
file(REMOVE_RECURSE ${WORK_DIR})

# configure(PACKAGE...): without these packages; sets `status` and `output`
macro(configure)
  set(options "")
  foreach(package ${ARGN})
    list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
  file(REMOVE_RECURSE ${WORK_DIR}/build)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build ${options}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
endmacro()

macro(expect sentence)
  if(NOT output MATCHES "${sentence}")
    message(FATAL_ERROR "'${sentence}' is not in:\n${output}")
  endif()
endmacro()

macro(expect_no_target target sentence)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/build --target ${target}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  expect("${sentence}[^\n]*Please install what is missing")
  if(status EQUAL 0)
    message(FATAL_ERROR "${target} seems to be built")
  endif()
endmacro()

configure(CGAL Eigen3)
expect("Not found: CGAL 5.5 or later .*, Eigen 3 ")
if(status EQUAL 0)
  message(FATAL_ERROR "Without CGAL it is configured")
endif()

configure(GTest nlohmann_json)
expect("GoogleTest is not found")
expect_no_target(mesh_patch "nlohmann_json is not found")
expect_no_target(parametric_surface_mesher_python "nlohmann_json is not found")

configure(OpenCASCADE pybind11)
expect_no_target(mesh_cad "Open CASCADE 7.5 or later is not found")
expect_no_target(parametric_surface_mesher_python "pybind11")
