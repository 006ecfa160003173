# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Options of every target that we compile. Nothing here affects users of the library.
function(hardball_compile_strictly target)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # Most of the time is spent reading headers.
  if(HARDBALL_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 20)
  endif()
  # A tenth of the compiler's time would go into collecting the garbage of units that fit into memory without it.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-heapsize=524288")
  endif()
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # A square root is one instruction: we never read errno.
    target_compile_options(${target} PRIVATE -fno-math-errno)
    target_compile_options(${target} PRIVATE
      -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion
      $<$<BOOL:${HARDBALL_WERROR}>:-Werror>)
    # GCC 12 warns of the standard library's own string concatenation (GCC bug 105651).
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      target_compile_options(${target} PRIVATE -Wno-restrict)
    endif()
  endif()
endfunction()

# Options on which results depend, for the library and all code that includes its headers: no multiplication and
# addition may be contracted into one rounding, or the same run would differ between compilers.
function(hardball_compile_exactly target scope)
  target_compile_features(${target} ${scope} cxx_std_20)
  target_compile_options(${target} ${scope} $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
  if(HARDBALL_VALIDATE)
    target_compile_definitions(${target} ${scope} HARDBALL_VALIDATE=1)
  endif()
endfunction()

# hardball_include_as_installed(TARGET): whoever links the library includes its headers by the path "hardball/...".
function(hardball_include_as_installed target)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()

# Options of code in which runs spend little time: it compiles in two thirds of the time. Histories do not depend on it.
set(hardball_cold_options)
if(EMSCRIPTEN)
  set(hardball_cold_options $<$<CONFIG:Release,RelWithDebInfo>:-Oz>)
elseif(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(hardball_cold_options $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
endif()

# hardball_contain_libraries(TARGET): a program or module that needs no library but those of C, for wheels.
function(hardball_contain_libraries target)
  if(HARDBALL_SELF_CONTAINED)
    target_link_options(${target} PRIVATE -static-libstdc++ -static-libgcc -Wl,--exclude-libs,ALL -Wl,--gc-sections -s)
  endif()
endfunction()

# hardball_add_units(TARGET SOURCE...): objects of the library.
function(hardball_add_units target)
  add_library(${target} OBJECT ${ARGN})
  hardball_compile_strictly(${target})
  hardball_compile_exactly(${target} PUBLIC)
  hardball_include_as_installed(${target})
  # So that shared libraries, such as the Python module, can contain it; users see what is marked by HARDBALL_EXPORT.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# hardball_say_version(TARGET SOURCE): the source, one of the target, knows version, kind of build and commit of the program. The
# commit is read at each build; if it is another, this source is compiled again.
function(hardball_say_version target source)
  set(folder ${PROJECT_BINARY_DIR}/commit)
  if(NOT TARGET hardball_commit)
    add_custom_target(hardball_commit BYPRODUCTS ${folder}/commit.hpp
                      COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D HEADER=${folder}/commit.hpp
                              -P ${PROJECT_SOURCE_DIR}/cmake/commit.cmake VERBATIM)
  endif()
  add_dependencies(${target} hardball_commit)
  set_source_files_properties(${source} PROPERTIES COMPILE_DEFINITIONS
                              "HARDBALL_VERSION=\"${PROJECT_VERSION}\";HARDBALL_BUILD_TYPE=\"$<CONFIG>\""
                              INCLUDE_DIRECTORIES ${folder})
endfunction()
