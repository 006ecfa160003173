# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# Installs the library so that find_package(hardball) provides the target hardball::hardball, and pkg-config knows it;
# the program with its manual and completions; scenarios and the pages about them.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/hardball)
set(pkg_config_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

install(TARGETS ${HARDBALL_LIBRARY_TARGETS} EXPORT hardball ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/hardball DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")
install(EXPORT hardball NAMESPACE hardball:: FILE hardballConfig.cmake DESTINATION ${package_folder})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/hardballConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/hardballConfigVersion.cmake DESTINATION ${package_folder})

# A linker wants a library before those that it uses: rooms from the highest floor down, then those of others.
set(libraries "")
set(others "")
foreach(target IN LISTS HARDBALL_LIBRARY_TARGETS)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    string(PREPEND libraries "-l${target} ")
    get_target_property(used ${target} LINK_LIBRARIES)
    list(FILTER used EXCLUDE REGEX "^hardball_|NOTFOUND$")
    list(APPEND others ${used})
  endif()
endforeach()
list(REMOVE_DUPLICATES others)
foreach(other IN LISTS others)
  string(APPEND libraries "-l${other} ")
endforeach()
string(STRIP "${libraries}" libraries)
set(validation "")
if(HARDBALL_VALIDATE)
  set(validation " -DHARDBALL_VALIDATE=1")
endif()
file(RELATIVE_PATH prefix_from_here /${pkg_config_folder} /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/hardball.pc.in ${PROJECT_BINARY_DIR}/hardball.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/hardball.pc DESTINATION ${pkg_config_folder})

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
