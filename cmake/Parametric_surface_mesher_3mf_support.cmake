# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Defines the target Parametric_surface_mesher::3mf_support, if version 1 of the library lib3mf is found: what CGAL/IO/write_element_3MF.h
# needs. The library comes without a config package.

find_path(LIB3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(LIB3MF_LIBRARY NAMES 3MF)
if(LIB3MF_INCLUDE_DIR AND LIB3MF_LIBRARY AND NOT TARGET Parametric_surface_mesher::3mf_support)
  add_library(Parametric_surface_mesher::3mf_support INTERFACE IMPORTED)
  set_target_properties(Parametric_surface_mesher::3mf_support PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${LIB3MF_INCLUDE_DIR}"
    INTERFACE_INCLUDE_DIRECTORIES "${LIB3MF_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS CGAL_PARAMETRIC_SURFACE_MESHER_USE_3MF
    INTERFACE_LINK_LIBRARIES "${LIB3MF_LIBRARY}")
endif()
