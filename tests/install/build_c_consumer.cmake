# Builds and runs the project `c_consumer`, which knows nothing but find_package(microslip COMPONENTS c), and the
# same program with nothing but what pkg-config says.
# Arguments: CONFIG, PREFIX, LIB_DIR, VERSION, SOURCE_DIR, WORK_DIR, GENERATOR, C_COMPILER, C_FLAGS, CXX_COMPILER,
# CXX_FLAGS.

file(REMOVE_RECURSE "${WORK_DIR}")

function(run program)
  execute_process(
    COMMAND "${program}"
    OUTPUT_VARIABLE printed
    COMMAND_ERROR_IS_FATAL ANY)
  if(NOT printed STREQUAL "microslip ${VERSION}: 3.75 N\n")
    message(FATAL_ERROR "The consumer printed '${printed}'.")
  endif()
endfunction()

execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -S "${SOURCE_DIR}/c_consumer" -B "${WORK_DIR}" -G "${GENERATOR}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_C_FLAGS=${C_FLAGS}"
    "-DCMAKE_PREFIX_PATH=${PREFIX}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}" --config "${CONFIG}" OUTPUT_QUIET
                        COMMAND_ERROR_IS_FATAL ANY)
find_program(
  consumer consumer
  PATHS "${WORK_DIR}" "${WORK_DIR}/${CONFIG}"
  NO_DEFAULT_PATH REQUIRED)
run("${consumer}")

# C++ of the oldest standard that has enumerations of int.
separate_arguments(cxx_flags UNIX_COMMAND "${CXX_FLAGS}")
execute_process(
  COMMAND "${CXX_COMPILER}" -x c++ -std=c++11 -Wall -Wextra -pedantic -Werror ${cxx_flags}
          "-I${PREFIX}/include" -fsyntax-only "${SOURCE_DIR}/c_consumer/main.c" COMMAND_ERROR_IS_FATAL ANY)

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  set(ENV{PKG_CONFIG_PATH} "${PREFIX}/${LIB_DIR}/pkgconfig")
  set(ENV{LD_LIBRARY_PATH} "${PREFIX}/${LIB_DIR}")
  execute_process(
    COMMAND "${PKG_CONFIG}" --cflags --libs microslip-c
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${C_FLAGS} ${flags}")
  execute_process(
    COMMAND "${C_COMPILER}" -std=c99 -Wall -Wextra -pedantic -Werror "${SOURCE_DIR}/c_consumer/main.c" -o
            "${WORK_DIR}/by_pkg_config" ${flags} COMMAND_ERROR_IS_FATAL ANY)
  run("${WORK_DIR}/by_pkg_config")
endif()
file(REMOVE_RECURSE "${WORK_DIR}")
