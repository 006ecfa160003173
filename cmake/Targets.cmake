# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Options of every target that we compile. Nothing here affects users of the library.
function(hardball_compile_strictly target)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
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

# hardball_add_room(NAME room USES lower rooms...): the target hardball_<room>, alias hardball::<room>, of all
# sources in the room's folder. A header-only room is an INTERFACE library.
function(hardball_add_room)
  cmake_parse_arguments(PARSE_ARGV 0 room "" "NAME" "USES")
  set(target hardball_${room_NAME})
  file(GLOB sources CONFIGURE_DEPENDS ${room_NAME}/*.cpp)
  if(sources)
    set(scope PUBLIC)
    add_library(${target} STATIC ${sources})
    hardball_compile_strictly(${target})
  else()
    set(scope INTERFACE)
    add_library(${target} INTERFACE)
  endif()
  add_library(hardball::${room_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room_NAME})
  if(sources)
    # So that shared libraries, such as the Python module, can contain it.
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  hardball_compile_exactly(${target} ${scope})
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM room_USES PREPEND hardball_)
  target_link_libraries(${target} ${scope} ${room_USES})
endfunction()
