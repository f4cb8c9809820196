# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Defines the target Parametric_surface_mesher::Open_cascade_support, after find_package(OpenCASCADE), as CGAL defines those
# of its optional libraries: what the headers with open_cascade in their names need.

if(OpenCASCADE_FOUND AND OpenCASCADE_VERSION VERSION_LESS 7.5)
  set(OpenCASCADE_FOUND FALSE)
endif()
if(OpenCASCADE_FOUND AND NOT TARGET Parametric_surface_mesher::Open_cascade_support)
  # since version 7.8 the readers of files have other names
  if(TARGET TKDESTEP)
    set(open_cascade_targets TKDESTEP TKDEIGES)
  else()
    set(open_cascade_targets TKXDESTEP TKXDEIGES TKSTEP TKSTEPBase TKIGES)
  endif()
  # The writer of .glb files, which are in the package of the readers.
  foreach(name TKDEGLTF TKRWMesh)
    if(TARGET ${name})
      list(APPEND open_cascade_targets ${name})
    endif()
  endforeach()
  # TKPrim and TKFillet are for users who make shapes.
  list(APPEND open_cascade_targets TKFillet TKPrim TKOffset TKBool TKBO TKXCAF TKLCAF TKCAF TKCDF TKXSBase TKShHealing TKTopAlgo
    TKBRep TKGeomAlgo TKGeomBase TKG3d TKG2d TKMath TKernel)
  # Shared libraries are linked as files. As targets, they bring along all that they are linked with themselves, such as fontconfig and
  # oneTBB, which are not among the packages that Debian installs with them.
  set(open_cascade_libraries "")
  foreach(target IN LISTS open_cascade_targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL SHARED_LIBRARY)
      list(APPEND open_cascade_libraries $<TARGET_LINKER_FILE:${target}>)
    else()
      list(APPEND open_cascade_libraries ${target})
    endif()
  endforeach()
  add_library(Parametric_surface_mesher::Open_cascade_support INTERFACE IMPORTED)
  set_target_properties(Parametric_surface_mesher::Open_cascade_support PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${OpenCASCADE_INCLUDE_DIR}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenCASCADE_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS CGAL_PARAMETRIC_SURFACE_MESHER_USE_OPEN_CASCADE
    INTERFACE_LINK_LIBRARIES "${open_cascade_libraries}")
  unset(open_cascade_targets)
  unset(open_cascade_libraries)
endif()
