# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Compiles compile_errors.cpp with the macro CASE, and fails unless the compiler refuses it with SENTENCE in an error, and
# has not much more to say. COMPILER; INCLUDES: folders, separated by '|'
string(REPLACE "|" ";-I" flags "-I${INCLUDES}")
execute_process(
  COMMAND ${COMPILER} -std=c++17 -fsyntax-only -DCGAL_EIGEN3_ENABLED ${flags} -D${CASE} ${CMAKE_CURRENT_LIST_DIR}/compile_errors.cpp
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(LENGTH "${output}" length)
if(result EQUAL 0)
  message(FATAL_ERROR "${CASE} compiles")
elseif(NOT output MATCHES "error:[^\n]*${SENTENCE}")
  message(FATAL_ERROR "no error has the sentence '${SENTENCE}':\n${output}")
elseif(length GREATER 5000)
  message(FATAL_ERROR "the errors have ${length} characters:\n${output}")
endif()
