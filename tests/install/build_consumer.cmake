# Configures, builds and runs the project `consumer`, which knows nothing but find_package(microslip).
# Arguments: CONFIG, PREFIX, SOURCE_DIR, WORK_DIR, GENERATOR, CXX_COMPILER, CXX_FLAGS.

file(REMOVE_RECURSE "${WORK_DIR}")

# The compiler and its flags are handed on because a sanitized library needs a sanitized program.
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -S "${SOURCE_DIR}/consumer" -B "${WORK_DIR}" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" "-DCMAKE_PREFIX_PATH=${PREFIX}"
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}" --config "${CONFIG}"
                        COMMAND_ERROR_IS_FATAL ANY)

find_program(
  consumer consumer
  PATHS "${WORK_DIR}" "${WORK_DIR}/${CONFIG}"
  NO_DEFAULT_PATH REQUIRED)
include("${SOURCE_DIR}/run_consumer.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
