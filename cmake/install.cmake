# Installation, and how the binary finds the levels: first relative to itself, so that the installed
# tree can be moved; else in the source tree that it was built from.
include(GNUInstallDirs)
file(RELATIVE_PATH carom_levels_from_binary
  ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/carom/levels)

# Of the whole library, since a unit of CAROM_UNITY cannot hold files with definitions of their own.
target_compile_definitions(carom_command PRIVATE
  CAROM_LEVELS_FROM_BINARY="${carom_levels_from_binary}"
  CAROM_SOURCE_LEVELS="${PROJECT_SOURCE_DIR}/levels" CAROM_VERSION="${PROJECT_VERSION}")

install(TARGETS carom RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT local)
# In Debian's package. The way from there to the levels is the same.
install(TARGETS carom RUNTIME DESTINATION games COMPONENT package EXCLUDE_FROM_ALL)
install(DIRECTORY levels/ DESTINATION ${CMAKE_INSTALL_DATADIR}/carom/levels COMPONENT data
  FILES_MATCHING PATTERN "*.level" PATTERN "*.table" PATTERN "*.list")
install(FILES docs/carom.6 DESTINATION ${CMAKE_INSTALL_MANDIR}/man6 COMPONENT data)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT data
  FILES_MATCHING PATTERN "*.md" PATTERN "*.vim")
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT data)
