# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# The target "package" makes Debian packages of what is installed: hardball and, of the component python if it is built,
# python3-hardball. Configure with -DCMAKE_INSTALL_PREFIX=/usr.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hardball)
set(CPACK_PACKAGE_VENDOR "The Hardball authors")
set(CPACK_PACKAGE_CONTACT "The Hardball authors <hardball@packages.invalid>")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/complete.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME hardball)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The shared library of the C API: programs that link it depend on this package, and the loader finds it.
if(HARDBALL_C)
  get_target_property(abi hardball_c SOVERSION)
  file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "libhardball_c ${abi} hardball\n")
  file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What the library links, to which the script above adds what the program needs.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_DEPENDS libzstd-dev)
# The program opens a browser, and mpirun starts several processes of it, for which the script adds MPI; the library is
# for a compiler.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "xdg-utils, openmpi-bin, g++, cmake, pkg-config")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact event-driven collision detection among moving spheres")
set(CPACK_DEBIAN_UNSPECIFIED_DESCRIPTION
"Hardball finds every collision among many moving spheres, exactly and in
order, by going from event to event (Kim, Guibas and Shin 1997). It simulates
gases, crystals, granular media and mixtures of hard spheres or discs, between
walls of many shapes, and gives the same history, bit for bit, whatever affects
its speed.
.
This package has the program with its viewer, scenarios to start from, and the
C++20 library, static, with its headers, and the library for C, shared.")

# The module is for one version of Python.
if(TARGET hardball_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  get_directory_property(minor DIRECTORY ${PROJECT_SOURCE_DIR}/python DEFINITION Python_VERSION_MINOR)
  math(EXPR next "${minor} + 1")
  set(python "python3 (>= 3.${minor}~), python3 (<< 3.${next}~)")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-hardball)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "${python}, python3-numpy, hardball (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst
      ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"Hardball finds every collision among many moving spheres, exactly and in
order. This package is for Python, with NumPy: simulations, measures,
packings, queries, and what the program reads and writes.")
endif()
include(CPack)
