# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the build folder BUILD under SCRATCH, then configures, builds and runs the project consumer/ with it, and
# builds and runs its only file by the flags of pkg-config. Of the headers of rooms, those are installed that it reaches.
# Where the C API was built, an example in C is built in these two ways, and statically.
macro(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endmacro()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${SCRATCH}/prefix)
if(EXISTS ${SCRATCH}/prefix/include/hardball/engine/engine.hpp)
  message(FATAL_ERROR "A header is installed that no public header reaches")
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=${CONFIG} "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)

file(GLOB_RECURSE description ${SCRATCH}/prefix/hardball.pc)
cmake_path(GET description PARENT_PATH folder)
run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} pkg-config --cflags --libs hardball OUTPUT_VARIABLE options)
separate_arguments(options UNIX_COMMAND "${FLAGS} ${CMAKE_CURRENT_LIST_DIR}/consumer/main.cpp ${options}")
run(${COMPILER} ${options} -o ${SCRATCH}/built_by_pkg_config)
run(${SCRATCH}/built_by_pkg_config)

file(GLOB_RECURSE description ${SCRATCH}/prefix/hardball-c.pc)
if(NOT description)
  return()
endif()
set(examples ${CMAKE_CURRENT_LIST_DIR}/../../examples)
set(game ${examples}/game_loop.c)
macro(run_game program)
  run(${CMAKE_COMMAND} -D PROGRAM=${program} -D EXPECTED=${examples}/expected/game_loop.txt
      -P ${CMAKE_CURRENT_LIST_DIR}/../../cmake/compare_output.cmake)
endmacro()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer_c -B ${SCRATCH}/build_c -G ${GENERATOR} -D GAME=${game}
    -D CMAKE_C_COMPILER=${C_COMPILER} -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build_c)
run_game(${SCRATCH}/build_c/game)

run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} pkg-config --cflags --libs hardball-c OUTPUT_VARIABLE options)
separate_arguments(options UNIX_COMMAND "-std=c99 ${game} ${options} -Wl,-rpath,${folder}/..")
run(${C_COMPILER} ${options} -o ${SCRATCH}/game_by_pkg_config)
run_game(${SCRATCH}/game_by_pkg_config)
run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} pkg-config --cflags --libs --static hardball-c
    OUTPUT_VARIABLE options)
string(REPLACE "-lhardball_c" "-l:libhardball_c.a" options "${options}")
separate_arguments(options UNIX_COMMAND "-std=c99 ${game} ${options}")
run(${C_COMPILER} ${options} -o ${SCRATCH}/static_game_by_pkg_config)
run_game(${SCRATCH}/static_game_by_pkg_config)
