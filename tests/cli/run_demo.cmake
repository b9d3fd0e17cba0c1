# Runs `microslip demo --out demo` in FOLDER, which is emptied first, and leaves there what it printed, in
# summary.txt.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(
  COMMAND "${PROGRAM}" demo --out demo
  WORKING_DIRECTORY "${FOLDER}"
  OUTPUT_FILE "${FOLDER}/summary.txt" COMMAND_ERROR_IS_FATAL ANY)
