# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Defines the target Parametric_surface_mesher::Page_support, if three.js is found: what CGAL/IO/write_HTML.h needs. The library is part of
# the pages that are written, and not needed to look at them. Versions 111 to 147 have the files that are looked for.

find_path(THREE_JS_DIR NAMES examples/js/lines/LineSegments2.js
  PATH_SUFFIXES share/javascript/three share/nodejs/three lib/node_modules/three
  PATHS ${CMAKE_SOURCE_DIR}/node_modules/three
  DOC "Folder of three.js, with three.min.js or build/three.min.js, and examples/js/")
if(THREE_JS_DIR AND NOT TARGET Parametric_surface_mesher::Page_support)
  set(page_header ${CMAKE_CURRENT_BINARY_DIR}/Parametric_surface_mesher_page/Parametric_surface_mesher_page_source.h)
  execute_process(COMMAND ${CMAKE_COMMAND} -DTHREE_JS_DIR=${THREE_JS_DIR} -DOUTPUT=${page_header}
      -P ${CMAKE_CURRENT_LIST_DIR}/make_mesh_page_source.cmake
    RESULT_VARIABLE page_result ERROR_VARIABLE page_error)
  if(page_result EQUAL 0)
    add_library(Parametric_surface_mesher::Page_support INTERFACE IMPORTED)
    get_filename_component(page_include_dir ${page_header} DIRECTORY)
    set_target_properties(Parametric_surface_mesher::Page_support PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${page_include_dir}"
      INTERFACE_COMPILE_DEFINITIONS CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE)
    # Configure again, which makes the header, when a file of the page changes.
    file(GLOB page_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/../page/* ${CMAKE_CURRENT_LIST_DIR}/page/*)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_sources} ${CMAKE_CURRENT_LIST_DIR}/make_mesh_page_source.cmake)
    unset(page_include_dir)
    unset(page_sources)
  else()
    message(STATUS "three.js in ${THREE_JS_DIR} is of no use for pages: ${page_error}")
  endif()
  unset(page_header)
  unset(page_result)
  unset(page_error)
endif()
