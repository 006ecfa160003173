# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the library so that find_package(hardball) provides the target hardball::hardball.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/hardball)

install(TARGETS ${HARDBALL_LIBRARY_TARGETS} EXPORT hardball ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/hardball DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")
install(EXPORT hardball NAMESPACE hardball:: FILE hardballConfig.cmake DESTINATION ${package_folder})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/hardballConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hardballConfigVersion.cmake DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(TARGET hardball_program)
  install(TARGETS hardball_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
