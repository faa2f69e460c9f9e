# `cmake --build build/release --target package` makes a Debian package. It needs dpkg-dev and file.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The carom project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "pool, pinball and a physics laboratory in a terminal")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
# All but `local`, the program in /usr/local/bin: the package has it in /usr/games.
set(CPACK_COMPONENTS_ALL package data)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION games)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS ncurses-term)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Balls, edges and flippers with physics that is the same on every machine, to the last bit.\n Games of pool and pinball, levels in a small language, and tools to measure solvers.")
include(CPack)
