# LADDERC_COMPILER_LINK: the presets build in folders of their own and all leave build/bin/ladderc, a link to the ladderc built last.
if(NOT LADDERC_COMPILER_LINK)
  return()
endif()
get_filename_component(folder ${LADDERC_COMPILER_LINK} DIRECTORY)
# Not a step after linking ladderc: the link must follow this build folder even where there is nothing to link anew.
add_custom_target(ladderc_compiler_link ALL
  COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
  COMMAND ${CMAKE_COMMAND} -E create_symlink $<TARGET_FILE:ladderc> ${LADDERC_COMPILER_LINK}
  COMMENT "" VERBATIM)
add_dependencies(ladderc_compiler_link ladderc)
