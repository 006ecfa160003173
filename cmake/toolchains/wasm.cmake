# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# WebAssembly, by Emscripten: the compiler of Debian, or the one that EMSCRIPTEN names.
set(emscripten $ENV{EMSCRIPTEN})
if(NOT emscripten)
  set(emscripten /usr/share/emscripten)
endif()
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)
# Without its own fetch, by which node cannot read the module from a file.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1MB")
# Headers of libraries that are not compiled.
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
foreach(language C CXX)
  set(CMAKE_${language}_FLAGS_INIT "-msimd128 -fwasm-exceptions")
endforeach()
