# Arguments: BUILD_DIR, CONFIG, WORK_DIR, CONSUMER_DIR, GENERATOR, CXX_COMPILER, CXX_FLAGS.

set(prefix "${WORK_DIR}/prefix")
set(consumer_build "${WORK_DIR}/consumer")
file(REMOVE_RECURSE "${WORK_DIR}")

execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}"
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# The compiler and its flags are handed on because a sanitized library needs a sanitized program.
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${consumer_build}" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" "-DCMAKE_PREFIX_PATH=${prefix}"
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  COMMAND_ERROR_IS_FATAL ANY)

execute_process(COMMAND "${CMAKE_COMMAND}" --build "${consumer_build}" --config "${CONFIG}"
                        COMMAND_ERROR_IS_FATAL ANY)

find_program(consumer consumer PATHS "${consumer_build}" "${consumer_build}/${CONFIG}"
             NO_DEFAULT_PATH REQUIRED)
execute_process(
  COMMAND "${consumer}"
  OUTPUT_VARIABLE printed
  COMMAND_ERROR_IS_FATAL ANY)

message(STATUS "The consumer printed: ${printed}")
if(NOT printed MATCHES "^dissipation = [0-9.e+-]+ J\n$")
  message(FATAL_ERROR "Expected 'dissipation = <number> J'.")
endif()
