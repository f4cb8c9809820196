# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Fails if an internal header includes one from a room that comes after its own. The rooms and their order are those of the
# table in doc/Parametric_surface_mesher/Architecture.txt.
#
#   cmake -DSOURCE_DIR=<top level> -P check_rooms.cmake

cmake_minimum_required(VERSION 3.16)

get_filename_component(SOURCE_DIR "${SOURCE_DIR}" ABSOLUTE)
set(internal CGAL/Parametric_surface_mesher/internal)

function(report text)
  message(SEND_ERROR "${text}")
endfunction()

file(STRINGS ${SOURCE_DIR}/doc/Parametric_surface_mesher/Architecture.txt rows REGEX "^\\| [a-z_]+ \\|")
set(rooms "")
foreach(row IN LISTS rows)
  string(REGEX REPLACE "^\\| ([a-z_]+) \\|.*" "\\1" room "${row}")
  if(NOT room STREQUAL "room")
    list(APPEND rooms ${room})
  endif()
endforeach()

file(GLOB entries RELATIVE ${SOURCE_DIR}/include/${internal} ${SOURCE_DIR}/include/${internal}/*)
foreach(entry IN LISTS entries)
  if(NOT entry IN_LIST rooms)
    report("internal/${entry} is no room of Architecture.txt")
  endif()
endforeach()

set(number_of_headers 0)
foreach(room IN LISTS rooms)
  list(FIND rooms ${room} own_place)
  file(GLOB headers RELATIVE ${SOURCE_DIR}/include/${internal} ${SOURCE_DIR}/include/${internal}/${room}/*.h)
  if(NOT headers)
    report("the room ${room} of Architecture.txt is empty or missing")
  endif()
  foreach(header IN LISTS headers)
    math(EXPR number_of_headers "${number_of_headers} + 1")
    file(STRINGS ${SOURCE_DIR}/include/${internal}/${header} includes REGEX "^#include <${internal}/")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^#include <${internal}/([^>]*)>.*" "\\1" included "${include}")
      string(REGEX REPLACE "/.*" "" room_of_included "${included}")
      list(FIND rooms "${room_of_included}" place)
      if(place EQUAL -1 OR place GREATER own_place)
        report("${header} includes ${included}, from a room after its own")
      endif()
      if(NOT EXISTS ${SOURCE_DIR}/include/${internal}/${included})
        report("${header} includes ${included}, which does not exist")
      endif()
    endforeach()
  endforeach()
endforeach()
message(STATUS "${number_of_headers} headers looked at")
