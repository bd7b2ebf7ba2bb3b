# cmake --install: ladderc, the runtime's headers and library, and the CMake package with which other projects use them. The compiler
# looks for include/ and lib/ beside its own folder, so that the installed tree can be moved as a whole.
include(CMakePackageConfigHelpers)

set(LADDERC_PACKAGE_FOLDER lib/cmake/ladderc)
install(TARGETS ladderc RUNTIME DESTINATION bin)
install(TARGETS ladder_hosted ARCHIVE DESTINATION lib)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/include/ladder ${PROJECT_SOURCE_DIR}/runtime/hosted/include/ladder
  DESTINATION include FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/ladderc)

write_basic_package_version_file(${PROJECT_BINARY_DIR}/ladderc-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/package/ladderc-config.cmake ${PROJECT_SOURCE_DIR}/cmake/package/emit_program.cmake
  ${PROJECT_BINARY_DIR}/ladderc-config-version.cmake DESTINATION ${LADDERC_PACKAGE_FOLDER})
