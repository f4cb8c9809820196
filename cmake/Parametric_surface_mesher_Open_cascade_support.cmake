# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Defines the target Parametric_surface_mesher::Open_cascade_support, after find_package(OpenCASCADE), as CGAL defines those
# of its optional libraries: what the headers with open_cascade in their names need.

if(OpenCASCADE_FOUND AND OpenCASCADE_VERSION VERSION_LESS 7.5)
  set(OpenCASCADE_FOUND FALSE)
endif()
if(OpenCASCADE_FOUND AND NOT TARGET Parametric_surface_mesher::Open_cascade_support)
  add_library(Parametric_surface_mesher::Open_cascade_support INTERFACE IMPORTED)
  # since version 7.8 the readers of files have other names
  if(TARGET TKDESTEP)
    set(open_cascade_readers TKDESTEP TKDEIGES)
  else()
    set(open_cascade_readers TKXDESTEP TKXDEIGES TKSTEP TKSTEPBase TKIGES)
  endif()
  # The writer of .glb files, which are in the package of the readers.
  foreach(name TKDEGLTF TKRWMesh)
    if(TARGET ${name})
      list(APPEND open_cascade_readers ${name})
    endif()
  endforeach()
  set_target_properties(Parametric_surface_mesher::Open_cascade_support PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OpenCASCADE_INCLUDE_DIR}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenCASCADE_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS CGAL_PARAMETRIC_SURFACE_MESHER_USE_OPEN_CASCADE
    INTERFACE_LINK_LIBRARIES "${open_cascade_readers};TKOffset;TKBool;TKBO;TKXCAF;TKLCAF;TKCAF;TKCDF;TKXSBase;TKShHealing;TKTopAlgo;TKBRep;TKGeomAlgo;TKGeomBase;TKG3d;TKG2d;TKMath;TKernel")
  unset(open_cascade_readers)
endif()
