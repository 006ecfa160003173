# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# The target "package" makes a Debian package of what is installed. Configure with -DCMAKE_INSTALL_PREFIX=/usr.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hardball)
set(CPACK_PACKAGE_VENDOR "The Hardball authors")
set(CPACK_PACKAGE_CONTACT "The Hardball authors <hardball@packages.invalid>")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/complete.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The shared library of the C API: programs that link it depend on this package, and the loader finds it.
if(HARDBALL_C)
  get_target_property(abi hardball_c SOVERSION)
  file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "libhardball_c ${abi} hardball\n")
  file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()
# What the library links, to which the script above adds what the program needs.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libzstd-dev)
# The program opens a browser, and mpirun starts several processes of it, for which the script adds MPI; the library is
# for a compiler.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "xdg-utils, openmpi-bin, g++, cmake, pkg-config")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact event-driven collision detection among moving spheres")
set(CPACK_PACKAGE_DESCRIPTION
"Hardball finds every collision among many moving spheres, exactly and in
order, by going from event to event (Kim, Guibas and Shin 1997). It simulates
gases, crystals, granular media and mixtures of hard spheres or discs, between
walls of many shapes, and gives the same history, bit for bit, whatever affects
its speed.
.
This package has the program with its viewer, scenarios to start from, and the
C++20 library, static, with its headers, and the library for C, shared.")
include(CPack)
