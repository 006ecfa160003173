# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(platform x86_64-w64-mingw32)
set(CMAKE_RC_COMPILER ${platform}-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR ${CMAKE_CURRENT_LIST_DIR}/../../tests/platforms/wine.sh)
include(${CMAKE_CURRENT_LIST_DIR}/found_in_root.cmake)
# Those of GCC whose threads and mutexes are the standard library's.
set(CMAKE_C_COMPILER ${platform}-gcc-posix)
set(CMAKE_CXX_COMPILER ${platform}-g++-posix)
