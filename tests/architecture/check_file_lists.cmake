# Checks that each C++ file under ROOT is named in the CMakeLists.txt that builds it, so that no
# source is left out of the library and no test is left unrun. The consumer in tests/install is a
# project of its own, and tests/fuzz has its own list.

cmake_minimum_required(VERSION 3.25)

set(missing 0)
file(
  GLOB folders
  RELATIVE "${ROOT}"
  "${ROOT}/src/microslip/*" "${ROOT}/src/microslip/*/*")
list(REMOVE_ITEM folders src/microslip/bindings)
foreach(folder IN LISTS folders ITEMS apps/microslip apps/microslip-mpi bench tests tests/fuzz)
  if(NOT EXISTS "${ROOT}/${folder}/CMakeLists.txt")
    continue()
  endif()
  file(READ "${ROOT}/${folder}/CMakeLists.txt" list)
  string(REGEX REPLACE "#[^\n]*" "" list "${list}")
  string(REGEX REPLACE "[ \t\r\n()\"]+" ";" list "${list}")
  file(
    GLOB_RECURSE files
    RELATIVE "${ROOT}/${folder}"
    "${ROOT}/${folder}/*.cpp" "${ROOT}/${folder}/*.hpp")
  foreach(file IN LISTS files)
    # Headers are listed where they are installed from.
    if(file MATCHES "^install/" OR (folder STREQUAL "tests" AND file MATCHES "^fuzz/") OR (file MATCHES "\\.hpp$" AND NOT folder MATCHES "^src/"))
      continue()
    endif()
    if(folder MATCHES "^src/" AND file MATCHES "^([^/]+)/" AND EXISTS "${ROOT}/${folder}/${CMAKE_MATCH_1}/CMakeLists.txt")
      continue() # of that folder
    endif()
    if(NOT file IN_LIST list)
      message("${folder}/${file}: not named in ${folder}/CMakeLists.txt")
      math(EXPR missing "${missing} + 1")
    endif()
  endforeach()
endforeach()

if(missing GREATER 0)
  message(FATAL_ERROR "${missing} file(s) are not built.")
endif()
