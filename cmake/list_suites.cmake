# Writes LIST, a file of ctest with one test for each suite of PROGRAM, for microslip_discover_suites(). A suite
# of parameters takes long, so each of its tests stands alone. For microslip_set_suite_properties(), the variable
# tests_of_<PREFIX><suite> names the tests of a suite.
execute_process(
  COMMAND "${PROGRAM}" --gtest_list_tests
  OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)

function(append_test name)
  list(JOIN PROPERTIES "]==] [==[" properties)
  string(APPEND tests "add_test([==[${PREFIX}${name}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${ARGV1}]==])\n"
         "set_tests_properties([==[${PREFIX}${name}]==] PROPERTIES [==[${properties}]==])\n")
  string(APPEND tests "list(APPEND [==[tests_of_${PREFIX}${suite}]==] [==[${PREFIX}${name}]==])\n")
  set(tests "${tests}" PARENT_SCOPE)
endfunction()

# "Marching." or "Random/Marching.", and below it, indented, "Test" or "Test/0  # GetParam() = …".
set(tests "")
string(REGEX MATCHALL "[^\n]+" lines "${output}")
foreach(line IN LISTS lines)
  if(line MATCHES "^([A-Za-z0-9_/]+)\\.")
    set(suite "${CMAKE_MATCH_1}")
    if(NOT suite MATCHES "/")
      append_test("${suite}" "${suite}.*")
    endif()
  elseif(suite MATCHES "/" AND line MATCHES "^  ([A-Za-z0-9_/]+)")
    append_test("${suite}.${CMAKE_MATCH_1}" "${suite}.${CMAKE_MATCH_1}")
  endif()
endforeach()
if(tests STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()
file(WRITE "${LIST}" "${tests}")
