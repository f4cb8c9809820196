# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Defines the target Parametric_surface_mesher::Med_support, if the MED library is found: what CGAL/IO/write_MED.h needs. The
# library comes without a config package, and its header includes those of HDF5, which may include those of MPI.

find_path(MED_INCLUDE_DIR med.h)
find_path(MED_HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial hdf5/openmpi hdf5/mpich)
find_path(MED_MPI_INCLUDE_DIR mpi.h PATH_SUFFIXES mpi PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/openmpi/include)
find_library(MED_LIBRARY NAMES medC)
if(MED_INCLUDE_DIR AND MED_HDF5_INCLUDE_DIR AND MED_LIBRARY AND NOT TARGET Parametric_surface_mesher::Med_support)
  set(med_include_dirs ${MED_INCLUDE_DIR} ${MED_HDF5_INCLUDE_DIR})
  if(MED_MPI_INCLUDE_DIR)
    list(APPEND med_include_dirs ${MED_MPI_INCLUDE_DIR})
  endif()
  add_library(Parametric_surface_mesher::Med_support INTERFACE IMPORTED)
  set_target_properties(Parametric_surface_mesher::Med_support PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${med_include_dirs}"
    INTERFACE_INCLUDE_DIRECTORIES "${med_include_dirs}"
    INTERFACE_COMPILE_DEFINITIONS CGAL_PARAMETRIC_SURFACE_MESHER_USE_MED
    INTERFACE_LINK_LIBRARIES "${MED_LIBRARY}")
  unset(med_include_dirs)
endif()
