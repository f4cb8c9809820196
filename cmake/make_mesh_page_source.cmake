# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the header that CGAL/IO/write_HTML.h includes: the page without its mesh, as strings. The files of the folder page/ and of three.js
# take the places of their names between @ in page.html.
#
#   cmake -DTHREE_JS_DIR=<folder with three.min.js and examples/js/> -DOUTPUT=<header> -P make_mesh_page_source.cmake

cmake_minimum_required(VERSION 3.16)

set(page_dir ${CMAKE_CURRENT_LIST_DIR}/page) # installed
if(NOT EXISTS ${page_dir})
  set(page_dir ${CMAKE_CURRENT_LIST_DIR}/../page)
endif()

file(READ ${page_dir}/page.html page)
string(REGEX MATCHALL "@[A-Za-z0-9_.]+@" marks "${page}")
foreach(mark IN LISTS marks)
  if(mark STREQUAL "@MESH@")
    continue()
  endif()
  string(REPLACE "@" "" name "${mark}")
  find_file(file ${name} NO_CACHE NO_DEFAULT_PATH
    PATHS ${page_dir} ${THREE_JS_DIR} ${THREE_JS_DIR}/build ${THREE_JS_DIR}/examples/js/controls ${THREE_JS_DIR}/examples/js/lines)
  if(NOT file)
    message(FATAL_ERROR "${name} is not found in ${page_dir} or ${THREE_JS_DIR}")
  endif()
  file(READ ${file} text)
  if(text MATCHES "[^\t\r\n -~]")
    message(FATAL_ERROR "${file} contains characters that are not ASCII")
  endif()
  string(REPLACE "</script" "<\\/script" text "${text}")
  string(REPLACE "${mark}" "${text}" page "${page}")
  unset(file)
endforeach()

# A string literal for each few thousand characters: some compilers take no longer ones.
set(length_of_literal 12000)
function(add_strings name text)
  set(result "static const char* const ${name}[] = {\n")
  string(LENGTH "${text}" length)
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} ${length_of_literal} piece)
    string(APPEND result "R\"page~(${piece})page~\",\n")
    math(EXPR begin "${begin} + ${length_of_literal}")
  endwhile()
  set(strings "${strings}${result}};\n" PARENT_SCOPE)
endfunction()

string(FIND "${page}" "@MESH@" place)
string(SUBSTRING "${page}" 0 ${place} before_mesh)
math(EXPR place "${place} + 6")
string(SUBSTRING "${page}" ${place} -1 after_mesh)
set(strings "")
add_strings(before_mesh "${before_mesh}")
add_strings(after_mesh "${after_mesh}")

set(guard CGAL_PARAMETRIC_SURFACE_MESHER_PAGE_SOURCE_H)
file(WRITE ${OUTPUT}.new "// Made by make_mesh_page_source.cmake. three.js is under the MIT licence, https://threejs.org/license
#ifndef ${guard}
#define ${guard}

namespace CGAL { namespace Parametric_surface_mesher { namespace internal { namespace page_source {

${strings}
} } } } // namespace

#endif // ${guard}
")
configure_file(${OUTPUT}.new ${OUTPUT} COPYONLY) # leaves it alone if it is the same
