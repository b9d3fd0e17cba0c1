# Compiles consumer/main.cpp with nothing but what pkg-config says.
# Arguments: PREFIX, LIB_DIR, SHARED, VERSION, SOURCE_DIR, WORK_DIR, CXX_COMPILER, CXX_FLAGS.

find_program(PKG_CONFIG pkg-config)
if(NOT PKG_CONFIG)
  message("SKIPPED: no pkg-config")
  return()
endif()

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")
set(ENV{PKG_CONFIG_PATH} "${PREFIX}/${LIB_DIR}/pkgconfig")

function(ask result)
  execute_process(
    COMMAND "${PKG_CONFIG}" ${ARGN} microslip
    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

ask(version --modversion)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config says version '${version}', not ${VERSION}")
endif()

# Who links the shared library needs none of the libraries behind it.
ask(libraries --libs)
ask(private --print-requires-private)
if(libraries MATCHES "hdf5|tbb|fmt" OR (SHARED AND private))
  message(FATAL_ERROR "Needed in public: ${libraries}; in private: ${private}")
endif()

if(SHARED)
  ask(flags --cflags --libs)
  set(ENV{LD_LIBRARY_PATH} "${PREFIX}/${LIB_DIR}")
else()
  ask(flags --static --cflags --libs)
endif()
message(STATUS "pkg-config: ${flags}")
separate_arguments(flags UNIX_COMMAND "${CXX_FLAGS} ${flags}")
set(consumer "${WORK_DIR}/consumer")
execute_process(
  COMMAND "${CXX_COMPILER}" -std=c++20 "${SOURCE_DIR}/consumer/main.cpp" -o "${consumer}" ${flags}
          COMMAND_ERROR_IS_FATAL ANY)
include("${SOURCE_DIR}/run_consumer.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
