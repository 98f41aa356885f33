# SPDX-License-Identifier: LGPL-2.1-or-later
# What other systems ask of an installed rollfem: a pkg-config file, a list for removing it, a Debian package
# (cmake --preset package && cmake --build --preset package --target package).
file(RELATIVE_PATH prefix_from_here /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/rollfem_c.pc.in rollfem_c.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rollfem_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES cmake/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/rollfem)

# Relative to the prefix, so that the tree can be moved; folders of rollfem alone as a whole, with what Python
# compiles in them. CMake's own list is that of the last installation from a build, wherever that went.
install(CODE [[
  set(installed)
  foreach(file ${CMAKE_INSTALL_MANIFEST_FILES})
    file(RELATIVE_PATH file "${CMAKE_INSTALL_PREFIX}" "${file}")
    string(REGEX REPLACE "/rollfem/.*" "/rollfem" file "${file}")
    list(APPEND installed "${file}")
  endforeach()
  list(REMOVE_DUPLICATES installed)
  list(JOIN installed "\n" installed)
  file(WRITE "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/rollfem/installed.txt" "${installed}\n")
]])

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The rollfem developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "rolling contact of wheel and rail")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Contact patch, pressure, creep forces and subsurface stress of a railway wheel
on its rail, by half-spaces, finite elements, a hybrid of both and simplified theories; program, Python module, C and
C++ libraries.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-numpy, python3-h5py")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib")
if(ROLLFEM_PYTHON)
  string(REGEX MATCH "python[0-9.]+" python "${ROLLFEM_PYTHON_DIR}")
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", ${python}")
endif()
if(ROLLFEM_FEM)
  # Beside the reference BLAS, which makes the factorisation ten times slower.
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libopenblas0-pthread")
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "openmpi-bin")
endif()
include(CPack)
