# Runs the program `consumer` and checks what it prints.

execute_process(
  COMMAND "${consumer}"
  OUTPUT_VARIABLE printed
  COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "The consumer printed: ${printed}")
if(NOT printed MATCHES "^area = [0-9.]+\nabsent\\.h5: [^\n]+\n$")
  message(FATAL_ERROR "Expected 'area = <number>' and a complaint about absent.h5.")
endif()
