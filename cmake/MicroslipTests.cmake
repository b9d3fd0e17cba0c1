# microslip_discover_suites(<target> <prefix> [<property> <value>]...): after each build of an executable of
# GoogleTest, one ctest a suite, <prefix><suite> (cmake/list_suites.cmake). The tests of a suite run in one process: what they share is
# made once, and under the sanitizers, where a process takes a fifth of a second to start, that counts.
#
# scripts/run_tests counts the tests in what they print, and names those that skipped themselves.
function(microslip_discover_suites target prefix)
  set(list "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(
    TARGET ${target}
    POST_BUILD
    COMMAND
      "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${target}>" "-DPREFIX=${prefix}" "-DLIST=${list}"
      "-DPROPERTIES=${ARGN}" -P "${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake"
    BYPRODUCTS "${list}"
    COMMENT "Suites of ${target}"
    VERBATIM)
  # Before the first build there is no list; as with gtest_discover_tests() a missing program is then a
  # failing test.
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
  file(
    WRITE "${include}"
    "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n  add_test(${prefix}not_built not_built)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()

# microslip_set_suite_properties(<suite> <property> <value>...): set_tests_properties() of a suite with its
# prefix, which is not known before the build; of one of parameters, of each of its tests.
function(microslip_set_suite_properties suite)
  string(MAKE_C_IDENTIFIER "${suite}" file)
  set(include "${CMAKE_CURRENT_BINARY_DIR}/${file}_properties.cmake")
  list(JOIN ARGN "]==] [==[" properties)
  file(
    WRITE "${include}"
    "if(DEFINED [==[tests_of_${suite}]==])\n"
    "  set_tests_properties(\${tests_of_${suite}} PROPERTIES [==[${properties}]==])\n"
    "endif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${include}")
endfunction()
