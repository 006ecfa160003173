# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Configures, builds and runs the project embedded/ under SCRATCH, with the library in SOURCE as a part of it, SHARED or
# static, its sources alone or in UNITY, BY add_subdirectory or FetchContent.
macro(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endmacro()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/embedded -B ${SCRATCH} -G ${GENERATOR} -D HARDBALL_SOURCE=${SOURCE}
    -D BY=${BY} -D BUILD_SHARED_LIBS=${SHARED} -D CMAKE_BUILD_TYPE=None -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_CXX_FLAGS=-O0 -D HARDBALL_UNITY=${UNITY})
run(${CMAKE_COMMAND} --build ${SCRATCH} --parallel 2)
run(${SCRATCH}/consumer)
run(${CMAKE_COMMAND} -D PROGRAM=${SCRATCH}/save_and_load -D EXPECTED=${SOURCE}/examples/expected/save_and_load.txt
    -P ${SOURCE}/cmake/compare_output.cmake)
if(BY STREQUAL "FetchContent")
  run(${CMAKE_COMMAND} -D PROGRAM=${SCRATCH}/fetch_content/my_game
      -D EXPECTED=${SOURCE}/examples/expected/fetch_content.txt -P ${SOURCE}/cmake/compare_output.cmake)
endif()
