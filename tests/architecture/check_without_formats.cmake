# The folder io compiles without HDF5 and zlib, and then asks for neither.
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -S "${ROOT}" -B "${WORK_DIR}" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON
    -DMICROSLIP_WITH_HDF5=OFF -DMICROSLIP_WITH_MAT=OFF -DMICROSLIP_BUILD_APPS=OFF
    -DMICROSLIP_BUILD_TESTS=OFF -DMICROSLIP_BUILD_BENCH=OFF -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_Hdf5Library=ON COMMAND_ERROR_IS_FATAL ANY
  OUTPUT_QUIET)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}" --target microslip_folder_io
                        COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(GLOB_RECURSE objects "${WORK_DIR}/src/microslip/io/*.o")
execute_process(COMMAND nm --undefined-only ${objects} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES "microslip" OR symbols MATCHES " (H5[A-Z]|inflate|deflate|gz)")
  message(FATAL_ERROR "wrong symbols are asked for: ${CMAKE_MATCH_0}")
endif()
