# Compiles SOURCE with COMPILER and OPTIONS and looks at the object: which symbols it leaves to the linker, and whether the
# rung has a branch.
separate_arguments(options UNIX_COMMAND "${OPTIONS}")

execute_process(COMMAND ${COMPILER} ${options} -O2 -c ${SOURCE} -o ${OUTPUT}.o RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${SOURCE} does not compile")
endif()

execute_process(COMMAND nm -u ${OUTPUT}.o OUTPUT_VARIABLE undefined RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "nm cannot read ${OUTPUT}.o")
endif()
string(REGEX MATCHALL "[^ \n]+" words "${undefined}")
foreach(word ${words})
  if(NOT word MATCHES "^(U|memcpy|memmove|memset)$")
    message(FATAL_ERROR "the program needs ${word} from a library")
  endif()
endforeach()

# The names of branches are the processor's; the rung is looked at where tests usually run.
if(NOT CMAKE_HOST_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  return()
endif()
execute_process(COMMAND objdump -d --no-show-raw-insn ${OUTPUT}.o OUTPUT_VARIABLE assembly RESULT_VARIABLE failed)
string(REGEX MATCH "<self_hold>:\n[^<]*" rung "${assembly}")
if(failed OR rung STREQUAL "")
  message(FATAL_ERROR "the rung is not in ${OUTPUT}.o")
endif()
if(rung MATCHES "\tj[a-z]+|\tcall|\tcmov")
  message(FATAL_ERROR "the rung has a branch:\n${rung}")
endif()
