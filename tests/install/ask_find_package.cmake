# Configures the project `requests` with a prefix of its own: it takes the program out of it.
# Arguments: PREFIX, VERSION, HAS_PROGRAM, HAS_C, SOURCE_DIR, WORK_DIR, GENERATOR, CXX_COMPILER.

file(REMOVE_RECURSE "${WORK_DIR}")
file(COPY "${PREFIX}/" DESTINATION "${WORK_DIR}/prefix")
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -S "${SOURCE_DIR}/requests" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DINSTALLED_PREFIX=${WORK_DIR}/prefix" "-DINSTALLED_VERSION=${VERSION}"
    "-DINSTALLED_PROGRAM=${HAS_PROGRAM}" "-DINSTALLED_C=${HAS_C}"
  COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE "${WORK_DIR}")
