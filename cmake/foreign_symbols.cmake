# Run as a script: fails if an object of kernels defines a function that another object could define too. Compiled for
# a processor that has more instructions, it could take the place of the ordinary one, and crash the others.
execute_process(COMMAND ${NM} -C --defined-only ${OBJECT} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
set(found FALSE)
foreach(symbol IN LISTS symbols)
  if(symbol MATCHES " [WVu] ")
    set(found TRUE)
    # Besides what bears the name of its instruction set there may be a pointer, with sanitizers, but no function.
    if(NOT symbol MATCHES "N_AVX2|N_AVX3|N_SCALAR|kernels_for_|DW.ref.__gxx_personality_v0")
      message(SEND_ERROR "another object may define this, too: ${symbol}")
    endif()
  endif()
endforeach()
if(NOT found)
  message(SEND_ERROR "no weak symbol at all in ${OBJECT}: the check sees nothing")
endif()
