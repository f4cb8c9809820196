# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the package, and configures the examples and small projects with it, as users do. BUILD_DIR: of the package;
# SOURCE_DIR: of the package; WORK_DIR: is made anew; HAS_OPEN_CASCADE: whether Open CASCADE was found
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/user)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}\n${errors}")
  endif()
endfunction()

# `sentence`: a regular expression that the error has, empty if there is none
function(configure_user components sentence)
  file(WRITE ${WORK_DIR}/user/CMakeLists.txt "cmake_minimum_required(VERSION 3.16)\nproject(User CXX)\n"
    "find_package(Parametric_surface_mesher REQUIRED COMPONENTS ${components})\n"
    "add_executable(user user.cpp)\nif(TARGET Parametric_surface_mesher::Open_cascade_support)\n"
    "target_link_libraries(user Parametric_surface_mesher::Open_cascade_support)\nendif()\n")
  file(WRITE ${WORK_DIR}/user/user.cpp "int main() {}\n")
  file(REMOVE_RECURSE ${WORK_DIR}/user_build)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK_DIR}/user -B ${WORK_DIR}/user_build -DCMAKE_BUILD_TYPE=Release
    -G "Unix Makefiles" -DCMAKE_PREFIX_PATH=${WORK_DIR}/installed RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
  if(sentence STREQUAL "" AND NOT status EQUAL 0)
    message(FATAL_ERROR "Components ${components}: ${errors}")
  endif()
  string(REGEX REPLACE "[ \n]+" " " errors "${errors}")
  if(NOT sentence STREQUAL "" AND NOT errors MATCHES "${sentence}")
    message(FATAL_ERROR "Components ${components}: '${sentence}' is not in: ${errors}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/installed --component parametric-surface-mesher-dev)
foreach(file share/pkgconfig/parametric_surface_mesher.pc include/CGAL/make_parametric_surface_mesh.h)
  if(NOT EXISTS ${WORK_DIR}/installed/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
configure_user("" "")
configure_user("Nothing" "Nothing: there is no such component")
if(HAS_OPEN_CASCADE)
  configure_user("Open_cascade" "")
  # Open CASCADE's own targets would ask for fontconfig and oneTBB, which Debian does not install with them.
  file(STRINGS ${WORK_DIR}/user_build/CMakeFiles/user.dir/link.txt link_line)
  if(link_line MATCHES "fontconfig|libtbb" OR NOT link_line MATCHES "TKernel")
    message(FATAL_ERROR "A program with CAD files is linked by: ${link_line}")
  endif()
else()
  configure_user("Open_cascade" "Open_cascade: Open CASCADE 7.5 or later is not found")
endif()
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/examples/Parametric_surface_mesher -B ${WORK_DIR}/examples -DCMAKE_PREFIX_PATH=${WORK_DIR}/installed)

# Programs and the Python module are installed if they were built, and the module as a whole.
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/all)
file(GLOB_RECURSE module ${WORK_DIR}/all/*/parametric_surface_mesher/__init__.py)
file(GLOB_RECURSE compiled ${WORK_DIR}/all/*/parametric_surface_mesher/_core.*.so ${WORK_DIR}/all/*/parametric_surface_mesher/_core.*.pyd)
if(module AND NOT compiled OR compiled AND NOT module)
  message(FATAL_ERROR "Only a part of the Python module is installed: ${module} ${compiled}")
endif()
