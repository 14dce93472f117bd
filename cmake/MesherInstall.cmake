# Where `cmake --install` puts things, below the prefix.
include(GNUInstallDirs)
set(CMAKE_INSTALL_DOCDIR "${CMAKE_INSTALL_DATAROOTDIR}/doc/mesher")

# One folder holds the workbench and the Python package, as in the build folder; where others look for them stand links.
set(MESHER_INSTALL_MODULE_DIRECTORY "lib/mesher/Mod/Mesher")
set(MESHER_INSTALL_PYTHON_DIRECTORY "lib/python3/dist-packages" CACHE STRING
  "Folder below the prefix where Python looks for packages")

# `cmake --install` takes what is built, and does not build the tests before.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

# mesher_install_link(TARGET LINK): a relative symbolic link, both paths below the prefix.
function(mesher_install_link target link)
  cmake_path(GET link PARENT_PATH folder)
  cmake_path(GET link FILENAME name)
  cmake_path(RELATIVE_PATH target BASE_DIRECTORY "${folder}" OUTPUT_VARIABLE relative)
  string(MAKE_C_IDENTIFIER "${folder}" place)
  set(made "${CMAKE_BINARY_DIR}/links/${place}/${name}")
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/links/${place}")
  file(CREATE_LINK "${relative}" "${made}" SYMBOLIC)
  install(FILES "${made}" DESTINATION "${folder}")
endfunction()

install(FILES README.md CHANGELOG.md LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY Resources/demos DESTINATION "${CMAKE_INSTALL_DATADIR}/mesher")
