# The package of the Debian that it is built on: tools/package.sh, or `cpack --config build/release/CPackConfig.cmake`.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mesher)
set(CPACK_PACKAGE_CONTACT "The Mesher developers <mesher@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Delaunay meshes directly from exact CAD geometry")
set(CPACK_PACKAGE_DESCRIPTION
  "Meshes solids with tetrahedra and faces with triangles, by Delaunay refinement of
their exact surfaces: a program, a package for Python, and a workbench for FreeCAD.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

# It fits that release only, and the next release's is the newer one.
cmake_host_system_information(RESULT debian_release QUERY DISTRIB_VERSION_ID)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
if(debian_release)
  string(APPEND CPACK_DEBIAN_PACKAGE_RELEASE "~deb${debian_release}")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries and their least versions are read off the binaries.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
if(MESHER_WITH_PYTHON)
  # An extension module belongs to one minor version of Python.
  execute_process(
    COMMAND "${PYTHON_EXECUTABLE}" -c "import sys; print('%d %d' % sys.version_info[:2])"
    OUTPUT_VARIABLE python_version OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(python_version)
  list(GET python_version 0 major)
  list(GET python_version 1 minor)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= ${major}.${minor}), python3 (<< ${major}.${next}), python3-numpy")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
    "${CMAKE_SOURCE_DIR}/packaging/debian/postinst" "${CMAKE_SOURCE_DIR}/packaging/debian/prerm")
endif()
if(MESHER_WITH_FREECAD)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "freecad (>= 0.20)")
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "calculix-ccx")
endif()
install(FILES packaging/debian/copyright DESTINATION "${CMAKE_INSTALL_DOCDIR}")
include(CPack)
