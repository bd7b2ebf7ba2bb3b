# LADDERC_BIN_LINK: the presets build in folders of their own and all leave build/bin, a link to the programs built last; so the
# compiler is build/bin/ladderc whatever the preset.
if(NOT LADDERC_BIN_LINK)
  return()
endif()
# Not a step after linking ladderc: the link must follow this build folder even where there is nothing to link anew.
add_custom_target(ladderc_bin_link ALL
  COMMAND ${CMAKE_COMMAND} -E create_symlink ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} ${LADDERC_BIN_LINK}
  COMMENT "" VERBATIM)
add_dependencies(ladderc_bin_link ladderc)
