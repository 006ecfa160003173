# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the public headers, hardball/*.hpp under `source`, and the headers of rooms that they reach, to `destination`.
cmake_minimum_required(VERSION 3.22)

file(GLOB reached RELATIVE ${source} ${source}/hardball/*.hpp)
set(left ${reached})
while(left)
  list(POP_FRONT left header)
  file(STRINGS ${source}/${header} includes REGEX "^#include \"hardball/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" include "${include}")
    if(NOT include IN_LIST reached)
      list(APPEND reached ${include})
      list(APPEND left ${include})
    endif()
  endforeach()
endwhile()
foreach(header IN LISTS reached)
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${source}/${header} DESTINATION ${destination}/${folder})
endforeach()
