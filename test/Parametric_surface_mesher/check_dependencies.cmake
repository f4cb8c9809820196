# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if package_info/Parametric_surface_mesher/dependencies lists other packages of CGAL than those that the headers
# include. The package of a header of CGAL is in its $URL$ line.
#
#   cmake -DSOURCE_DIR=<top level> -DCGAL_INCLUDE_DIR=<folder that contains CGAL/> -P check_dependencies.cmake

cmake_minimum_required(VERSION 3.16)

file(STRINGS ${SOURCE_DIR}/package_info/Parametric_surface_mesher/dependencies listed)

# Surface_mesh is filled by its own functions, and included by users who pass one.
set(found Parametric_surface_mesher Surface_mesh)
file(GLOB_RECURSE headers ${SOURCE_DIR}/include/CGAL/*.h)
foreach(header IN LISTS headers)
  file(STRINGS ${header} includes REGEX "^#include <CGAL/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include <([^>]*)>.*" "\\1" included "${include}")
    if(EXISTS ${SOURCE_DIR}/include/${included})
      continue()
    endif()
    if(NOT EXISTS ${CGAL_INCLUDE_DIR}/${included})
      message(SEND_ERROR "${header} includes ${included}, which is not in ${CGAL_INCLUDE_DIR}")
      continue()
    endif()
    file(STRINGS ${CGAL_INCLUDE_DIR}/${included} url LIMIT_COUNT 1 REGEX "\\$URL: .*/cgal/blob/[^/]*/[A-Za-z0-9_]*/")
    string(REGEX REPLACE ".*/cgal/blob/[^/]*/([A-Za-z0-9_]*)/.*" "\\1" package "${url}")
    list(APPEND found ${package})
    if(NOT package IN_LIST listed)
      message(SEND_ERROR "${header} includes ${included} of ${package}, which is not in the list of dependencies")
    endif()
  endforeach()
endforeach()

foreach(package IN LISTS listed)
  if(NOT package IN_LIST found)
    message(SEND_ERROR "${package} is in the list of dependencies, but no header includes it")
  endif()
endforeach()
