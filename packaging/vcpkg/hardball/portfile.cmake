# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# The static library in C++, from the clone that this port is in.
get_filename_component(SOURCE_PATH ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)

vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS -DHARDBALL_APPS=OFF -DHARDBALL_C=OFF -DHARDBALL_TESTS=OFF
                      -DHARDBALL_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/hardball)
vcpkg_fixup_pkgconfig()

# The zstd of vcpkg is in none of the folders that linkers search.
set(config ${CURRENT_PACKAGES_DIR}/share/hardball/hardballConfig.cmake)
vcpkg_replace_string(${config} "LINK_ONLY:zstd>" "LINK_ONLY:zstd::libzstd>")
file(READ ${config} targets)
file(WRITE ${config} "include(CMakeFindDependencyMacro)\nfind_dependency(zstd)\n${targets}")

file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)
