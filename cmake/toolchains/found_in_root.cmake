# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# What the tool chains of other machines have in common: libraries and headers come from the folder that
# tests/platforms/make_root.sh fills, and from nowhere else. Needs `platform`, the name of the tool chain.
set(CMAKE_C_COMPILER ${platform}-gcc)
set(CMAKE_CXX_COMPILER ${platform}-g++)
set(platform_root ${CMAKE_CURRENT_LIST_DIR}/../../build/platforms/${platform}/root)
get_filename_component(platform_root ${platform_root} ABSOLUTE)
set(CMAKE_FIND_ROOT_PATH ${platform_root} /usr/${platform})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${platform_root}/lib/pkgconfig)
# Programs that contain all they need run without a copy of the other system.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${platform_root}/lib")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-L${platform_root}/lib")
