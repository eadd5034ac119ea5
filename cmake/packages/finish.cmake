# What Debian wants of each package that a plain installation has not; cpack runs this before it packs.
# Without them packages would depend on no library.
foreach(program dpkg-shlibdeps file)
  find_program(found_${program} ${program})
  if(NOT found_${program})
    message(FATAL_ERROR "Debian packages need ${program} (apt-get install dpkg-dev file)")
  endif()
endforeach()
file(READ ${CPACK_KNUCKLE_SOURCE}/LICENSE license)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]+)" ignored "${license}")
set(holder ${CMAKE_MATCH_1})
string(REGEX REPLACE "^.*\n(Permission is)" "\\1" license "${license}")
string(REGEX REPLACE "\n$" "" license "${license}")
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license "${license}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)   # of SOURCE_DATE_EPOCH, where that is set
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})

function(compress)
  if(ARGN)
    execute_process(COMMAND gzip -9n ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} name)
  set(package ${CPACK_DEBIAN_${name}_PACKAGE_NAME})
  set(usr ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(doc ${usr}/share/doc/${package})
  file(REMOVE ${doc}/LICENSE)   # is in `copyright`
  file(WRITE ${doc}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: knuckle

Files: *
Copyright: ${holder}
License: Expat

License: Expat
 ${license}
")
  file(WRITE ${doc}/changelog.Debian "knuckle (${version}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}; CHANGELOG.md in the package knuckle says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(GLOB pages ${usr}/share/man/man1/*.1)
  compress(${doc}/changelog.Debian ${pages})
  # Debian's own packages have modules in one folder for all versions; the module's name says which it is for.
  file(GLOB modules ${usr}/lib/python3.*/dist-packages)
  if(modules)
    file(MAKE_DIRECTORY ${usr}/lib/python3)
    file(RENAME ${modules} ${usr}/lib/python3/dist-packages)
    cmake_path(GET modules PARENT_PATH emptied)
    file(REMOVE_RECURSE ${emptied})
  endif()
  # What lintian is not to say, with the reasons.
  set(overrides)
  foreach(whose all ${package})
    set(file ${CMAKE_CURRENT_LIST_DIR}/${whose}.lintian-overrides)
    if(EXISTS ${file})
      file(READ ${file} text)
      string(REPLACE "PACKAGE:" "${package}:" text "${text}")
      string(APPEND overrides "${text}")
    endif()
  endforeach()
  file(WRITE ${usr}/share/lintian/overrides/${package} "${overrides}")
endforeach()
