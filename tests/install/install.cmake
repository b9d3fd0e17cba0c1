# Installs the build into PREFIX as it is after a move: what is installed knows no path of its own.
# Arguments: BUILD_DIR, CONFIG, PREFIX.

file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}.staged")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix
          "${PREFIX}.staged" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${PREFIX}.staged" "${PREFIX}")
