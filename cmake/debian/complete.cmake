# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# CPack runs this between installing and packing: what Debian wants of packages and other installations do not need.
set(installed ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/Unspecified${CPACK_PACKAGING_INSTALL_PREFIX})
set(python ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/python${CPACK_PACKAGING_INSTALL_PREFIX})
set(changelog ${installed}/share/doc/hardball/changelog.Debian)

# SOURCE_DATE_EPOCH, if set, is the time.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${changelog}
"hardball (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
configure_file(${CMAKE_CURRENT_LIST_DIR}/lintian-overrides ${installed}/share/lintian/overrides/hardball COPYONLY)
file(GLOB_RECURSE plugins ${installed}/lib/hardball/*.so ${installed}/lib/*/hardball/*.so)
file(GLOB_RECURSE shared ${installed}/lib/*.so.?)
file(GLOB_RECURSE archives ${installed}/lib/*.a)
file(GLOB_RECURSE modules ${python}/lib/*.so)
execute_process(COMMAND strip --strip-debug --remove-section=.comment --enable-deterministic-archives
                        ${archives} ${shared} ${plugins} ${installed}/bin/hardball
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND gzip -9nf ${changelog} ${installed}/share/man/man1/hardball.1 COMMAND_ERROR_IS_FATAL ANY)
if(modules)
  execute_process(COMMAND strip --strip-unneeded --remove-section=.comment --remove-section=.note ${modules} COMMAND_ERROR_IS_FATAL ANY)
  # Its documents are those of the package that it depends on.
  file(MAKE_DIRECTORY ${python}/share/doc)
  file(CREATE_LINK hardball ${python}/share/doc/python3-hardball SYMBOLIC)
endif()

# add_libraries(COMPONENT ROOT ARGUMENT...): dpkg-shlibdeps finds on what the files depend in the component that is installed
# under the root; its arguments.
macro(add_libraries component root)
  set(description ${CPACK_TOPLEVEL_DIRECTORY}/description)
  file(WRITE ${description}/debian/control "Source: hardball\n\nPackage: hardball\nArchitecture: any\n")
  # It looks for the folder of a package.
  file(MAKE_DIRECTORY ${root}/DEBIAN)
  execute_process(COMMAND dpkg-shlibdeps -O ${ARGN} WORKING_DIRECTORY ${description} OUTPUT_VARIABLE libraries
                  COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${root}/DEBIAN)
  foreach(relation Depends Suggests)
    if(libraries MATCHES "shlibs:${relation}=([^\n]+)")
      string(TOUPPER CPACK_DEBIAN_${component}_PACKAGE_${relation} variable)
      string(PREPEND ${variable} "${CMAKE_MATCH_1}, ")
    endif()
  endforeach()
endmacro()
# The program and the shared library depend on the libraries that they link, and do without those that only plug-ins
# link.
add_libraries(Unspecified ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/Unspecified -dDepends ${installed}/bin/hardball ${shared}
              -dSuggests ${plugins})
if(modules)
  add_libraries(python ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/python -dDepends ${modules})
endif()
