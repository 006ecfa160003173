# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the libraries so that find_package(hardball) provides the targets hardball::hardball, hardball::c and
# hardball::c_static, and pkg-config knows them; the program with its manual and completions; scenarios and the pages about them.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/hardball)
set(pkg_config_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(installed_libraries hardball_library)
if(HARDBALL_C)
  list(APPEND installed_libraries hardball_c hardball_c_static)
endif()
install(TARGETS ${installed_libraries} EXPORT hardball LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(CODE "set(source \"${PROJECT_SOURCE_DIR}\")
set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")")
install(SCRIPT cmake/install_headers.cmake)
install(EXPORT hardball NAMESPACE hardball:: FILE hardballConfig.cmake DESTINATION ${package_folder})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/hardballConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hardballConfigVersion.cmake DESTINATION ${package_folder})

# A shared library knows what it needs.
set(libraries "-lhardball")
if(NOT BUILD_SHARED_LIBS AND NOT HARDBALL_ZSTD_SOURCE)
  string(APPEND libraries " -lzstd")
endif()
set(validation "")
if(HARDBALL_VALIDATE)
  set(validation " -DHARDBALL_VALIDATE=1")
endif()
set(address "")
if(PROJECT_HOMEPAGE_URL)
  set(address "\nURL: ${PROJECT_HOMEPAGE_URL}")
endif()
file(RELATIVE_PATH prefix_from_here /${pkg_config_folder} /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/hardball.pc.in ${PROJECT_BINARY_DIR}/hardball.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/hardball.pc DESTINATION ${pkg_config_folder})
if(HARDBALL_C)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/hardball-c.pc.in ${PROJECT_BINARY_DIR}/hardball-c.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/hardball-c.pc DESTINATION ${pkg_config_folder})
  install(FILES ${PROJECT_SOURCE_DIR}/c/hardball.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()

file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
file(GLOB scenarios CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/scenarios/*)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian/copyright ${pages} DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${scenarios} DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)

# install_printed(FOLDER NAME ARGUMENTS): installs what the program prints when it is given the arguments.
set(printed ${PROJECT_BINARY_DIR}/printed)
file(MAKE_DIRECTORY ${printed})
function(install_printed folder name arguments)
  install(CODE "execute_process(COMMAND \"$<TARGET_FILE:hardball_program>\" ${arguments}
    OUTPUT_FILE \"${printed}/${name}\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES ${printed}/${name} DESTINATION ${folder})
endfunction()

if(TARGET hardball_program)
  install(TARGETS hardball_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install_printed(${CMAKE_INSTALL_MANDIR}/man1 hardball.1 manual)
  install_printed(${CMAKE_INSTALL_DATADIR}/bash-completion/completions hardball "completion bash")
  install_printed(${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions _hardball "completion zsh")
  install_printed(${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d hardball.fish "completion fish")
endif()
if(TARGET hardball_mpi)
  install(TARGETS hardball_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/hardball)
endif()

# The Python package, for distributions: `cmake --install BUILD --component python`.
if(TARGET hardball_python)
  set(HARDBALL_PYTHON_INSTALL_FOLDER lib/python3/dist-packages CACHE STRING "Where a Python looks for packages, below the prefix")
  set(python_folder ${HARDBALL_PYTHON_INSTALL_FOLDER}/hardball)
  file(GLOB modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/hardball/*.py)
  install(TARGETS hardball_python LIBRARY DESTINATION ${python_folder} COMPONENT python EXCLUDE_FROM_ALL)
  install(FILES ${modules} ${PROJECT_SOURCE_DIR}/python/hardball/live_view.js ${PROJECT_SOURCE_DIR}/python/hardball/py.typed ${HARDBALL_PYTHON_FOLDER}/hardball/_hardball.pyi
          DESTINATION ${python_folder} COMPONENT python EXCLUDE_FROM_ALL)
  install(FILES ${scenarios} DESTINATION ${python_folder}/scenario_files COMPONENT python EXCLUDE_FROM_ALL)
endif()
