# cmake -P emit_program.cmake -- FOLDER LADDERC LIST OPTIONS...: writes the C++ of a list, and the two files that a build compiles.
#
# How many files a program has depends on its length, which a build tool wants to know before; so these two include whatever was
# written.
set(words)
set(seen FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(seen)
    list(APPEND words ${CMAKE_ARGV${i}})
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(seen TRUE)
  endif()
endforeach()
list(POP_FRONT words folder ladderc list)

execute_process(COMMAND ${ladderc} emit ${words} -o ${folder} ${list} OUTPUT_VARIABLE written RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${list} was not compiled")
endif()

set(program "// The files that ladderc wrote for ${list}.\n")
set(symbols "${program}")
string(REPLACE "\n" ";" written "${written}")
foreach(path ${written})
  get_filename_component(name ${path} NAME)
  if(name MATCHES "\\.symbols\\.cpp$")
    string(APPEND symbols "#include \"${name}\"\n")
  elseif(name MATCHES "\\.cpp$")
    string(APPEND program "#include \"${name}\"\n")
  endif()
endforeach()
file(WRITE ${folder}/all_program.cpp "${program}")
file(WRITE ${folder}/all_symbols.cpp "${symbols}")
