# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Defines the target Parametric_surface_mesher_programs, after that of the package. PARAMETRIC_SURFACE_MESHER_DATA_DIR is the folder with
# the data of the examples.

# What tests, examples and benchmarks are compiled with, and users are not.
add_library(Parametric_surface_mesher_programs INTERFACE)
target_link_libraries(Parametric_surface_mesher_programs INTERFACE Parametric_surface_mesher::Parametric_surface_mesher)
target_compile_definitions(Parametric_surface_mesher_programs INTERFACE
  PARAMETRIC_SURFACE_MESHER_VERSION="${Parametric_surface_mesher_VERSION}"
  PARAMETRIC_SURFACE_MESHER_DATA_DIR="${PARAMETRIC_SURFACE_MESHER_DATA_DIR}")
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(Parametric_surface_mesher_programs INTERFACE -Wall -Wextra -Wshadow)
  if(PARAMETRIC_SURFACE_MESHER_SANITIZE)
    set(sanitize -fsanitize=${PARAMETRIC_SURFACE_MESHER_SANITIZE})
    # -Og compiles in 0.6 of the time of -O1 here, and runs as fast. Checking each pointer for null and alignment would take
    # as long again to compile; the address sanitizer stops at what is read or written through a null pointer, too.
    # g++ 12 takes the sanitizers' code in CGAL's file readers for uses of uninitialized values.
    target_compile_options(Parametric_surface_mesher_programs INTERFACE
      ${sanitize} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1 -Og -Wno-maybe-uninitialized)
    if(PARAMETRIC_SURFACE_MESHER_SANITIZE MATCHES "undefined")
      target_compile_options(Parametric_surface_mesher_programs INTERFACE -fno-sanitize=null,alignment)
    endif()
    target_link_options(Parametric_surface_mesher_programs INTERFACE ${sanitize})
  endif()
endif()
