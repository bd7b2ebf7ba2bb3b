# find_package(ladderc): the compiler and the runtime of this installation.
#
#   ladderc::ladderc   the compiler, for commands of your own
#   ladderc::core      the headers that generated programs need; nothing to link
#   ladderc::hosted    the runtime of PC programs: main loop, scenarios, devices by name
#
#   ladderc_add_program(TARGET LIST [FAMILY id] [MODEL name] [PARAMETERS file] [NAMESPACE name] [OPTIONS ...])
#
# adds the static library TARGET with the program of the list, for `#include "<list>.h"`, and TARGET_symbols with its names for hosts
# that look at devices by name. The list is compiled in the build, whenever it, its parameters or ladderc changed. OPTIONS go to
# `ladderc emit`.
get_filename_component(ladderc_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
set(ladderc_package_folder ${CMAKE_CURRENT_LIST_DIR})

if(NOT TARGET ladderc::ladderc)
  find_package(Threads REQUIRED)
  add_executable(ladderc::ladderc IMPORTED GLOBAL)
  set_target_properties(ladderc::ladderc PROPERTIES IMPORTED_LOCATION ${ladderc_prefix}/bin/ladderc)

  add_library(ladderc::core INTERFACE IMPORTED GLOBAL)
  target_include_directories(ladderc::core INTERFACE ${ladderc_prefix}/include)
  target_compile_features(ladderc::core INTERFACE cxx_std_17)

  add_library(ladderc::hosted STATIC IMPORTED GLOBAL)
  set_target_properties(ladderc::hosted PROPERTIES IMPORTED_LOCATION ${ladderc_prefix}/lib/libladder_hosted.a)
  target_link_libraries(ladderc::hosted INTERFACE ladderc::core Threads::Threads)
endif()

function(ladderc_add_program target list)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "" "FAMILY;MODEL;PARAMETERS;NAMESPACE" "OPTIONS")
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR
      "ladderc_add_program(${target}): '${ARG_UNPARSED_ARGUMENTS}' is none of FAMILY, MODEL, PARAMETERS, NAMESPACE, OPTIONS")
  endif()
  get_filename_component(list ${list} ABSOLUTE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}.ladderc)
  set(arguments ${ARG_OPTIONS})
  set(inputs ${list})
  if(ARG_FAMILY)
    list(APPEND arguments --family=${ARG_FAMILY})
  endif()
  if(ARG_MODEL)
    list(APPEND arguments --model=${ARG_MODEL})
  endif()
  if(ARG_PARAMETERS)
    get_filename_component(parameters ${ARG_PARAMETERS} ABSOLUTE)
    list(APPEND arguments --parameters=${parameters})
    list(APPEND inputs ${parameters})
  endif()
  if(ARG_NAMESPACE)
    list(APPEND arguments --namespace=${ARG_NAMESPACE})
  endif()

  add_custom_command(OUTPUT ${folder}/all_program.cpp ${folder}/all_symbols.cpp
    COMMAND ${CMAKE_COMMAND} -P ${ladderc_package_folder}/emit_program.cmake --
            ${folder} $<TARGET_FILE:ladderc::ladderc> ${list} ${arguments}
    DEPENDS ${inputs} $<TARGET_FILE:ladderc::ladderc> ${ladderc_package_folder}/emit_program.cmake
    COMMENT "Compiling ${list}" VERBATIM)
  add_library(${target} STATIC ${folder}/all_program.cpp)
  target_include_directories(${target} PUBLIC ${folder})
  target_link_libraries(${target} PUBLIC ladderc::core)
  add_library(${target}_symbols STATIC ${folder}/all_symbols.cpp)
  target_link_libraries(${target}_symbols PUBLIC ${target})
endfunction()
