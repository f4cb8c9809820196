# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For the folders of examples, tests and benchmarks, where the package is a part of CGAL's source tree (see scripts/add_to_cgal_tree.sh):
# defines the targets that CMakeLists.txt of the package's top level defines elsewhere. The headers are among those of CGAL.
# PARAMETRIC_SURFACE_MESHER_DATA_DIR is the folder with the data of the examples.

find_package(CGAL REQUIRED)
find_package(Eigen3 CONFIG REQUIRED)
find_package(Boost REQUIRED)
include(${CMAKE_CURRENT_LIST_DIR}/Parametric_surface_mesher_optional_libraries.cmake)
if(NOT TARGET Parametric_surface_mesher)
  add_library(Parametric_surface_mesher INTERFACE)
  add_library(Parametric_surface_mesher::Parametric_surface_mesher ALIAS Parametric_surface_mesher)
  target_compile_features(Parametric_surface_mesher INTERFACE cxx_std_17)
  target_link_libraries(Parametric_surface_mesher INTERFACE CGAL::CGAL Eigen3::Eigen Boost::headers)
  target_compile_definitions(Parametric_surface_mesher INTERFACE CGAL_EIGEN3_ENABLED)
  set(Parametric_surface_mesher_VERSION ${CGAL_VERSION})
  include(${CMAKE_CURRENT_LIST_DIR}/Parametric_surface_mesher_programs.cmake)
endif()
