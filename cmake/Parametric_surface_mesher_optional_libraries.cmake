# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Looks for the optional libraries, and defines a target for each that is found: Parametric_surface_mesher::Open_cascade_support,
# ::Med_support, ::Page_support, ::3mf_support, and CGAL::TBB_support. What needs a library is left out without it.

# (Its config package accepts no other version than the one asked for.)
find_package(OpenCASCADE QUIET)
foreach(library Open_cascade Med Page 3mf)
  include(${CMAKE_CURRENT_LIST_DIR}/Parametric_surface_mesher_${library}_support.cmake)
endforeach()
find_package(TBB QUIET)
include(CGAL_TBB_support)
