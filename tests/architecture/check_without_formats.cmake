# The readers and writers of files compile without HDF5 and zlib, and then need neither. What is the same with them
# and without them, by its CMakeLists.txt, is looked at where it was built: BUILD_DIR.
execute_process(
  COMMAND
    "${CMAKE_COMMAND}" -S "${ROOT}" -B "${WORK_DIR}" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON
    -DMICROSLIP_WITH_HDF5=OFF -DMICROSLIP_WITH_MAT=OFF -DMICROSLIP_BUILD_APPS=OFF
    -DMICROSLIP_BUILD_TESTS=OFF -DMICROSLIP_BUILD_BENCH=OFF -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_Hdf5Library=ON COMMAND_ERROR_IS_FATAL ANY
  OUTPUT_QUIET)
set(targets "")
set(objects "")
file(GLOB_RECURSE lists RELATIVE "${ROOT}" "${ROOT}/src/microslip/io/CMakeLists.txt" "${ROOT}/src/microslip/documents/CMakeLists.txt")
foreach(list IN LISTS lists)
  file(READ "${ROOT}/${list}" content)
  if(content MATCHES "microslip_add_folder\\([ \n]*([a-z0-9_/]+)")
    string(REPLACE "/" "_" target "microslip_folder_${CMAKE_MATCH_1}")
    cmake_path(GET list PARENT_PATH folder)
    if(content MATCHES "MICROSLIP_WITH_(HDF5|MAT)")
      list(APPEND targets ${target})
    else()
      file(GLOB_RECURSE built "${BUILD_DIR}/${folder}/CMakeFiles/${target}.dir/*.o")
      list(APPEND objects ${built})
    endif()
  endif()
endforeach()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK_DIR}" --target ${targets}
                        COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(GLOB_RECURSE built "${WORK_DIR}/src/microslip/*.o")
execute_process(COMMAND nm --undefined-only ${objects} ${built} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT built OR NOT symbols MATCHES "microslip" OR symbols MATCHES " (H5[A-Z]|inflate|deflate|gz)")
  message(FATAL_ERROR "wrong symbols are asked for: ${CMAKE_MATCH_0}")
endif()
