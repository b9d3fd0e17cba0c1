# The checks must find what is wrong, name the line, and stay silent on what is right.
# Arguments: CHECK, CHECK_LISTS, WORK_DIR.

cmake_minimum_required(VERSION 3.25)

# expect(<name> <script> <file> <content> <pattern>): the script, run on a tree that holds the file,
# prints the pattern and fails; with an empty pattern it succeeds.
function(expect name script file content pattern)
  set(root "${WORK_DIR}/${name}")
  file(REMOVE_RECURSE "${root}")
  file(WRITE "${root}/src/microslip/base/CMakeLists.txt" "listed: listed.cpp # comment.cpp\n")
  file(WRITE "${root}/src/microslip/joint/CMakeLists.txt" " PUBLIC installed.hpp\n PRIVATE a.cpp\n")
  file(WRITE "${root}/src/microslip/io/CMakeLists.txt" "add_subdirectory(uff)\n")
  file(WRITE "${root}/src/microslip/io/uff/CMakeLists.txt" " PUBLIC installed.hpp\n PRIVATE listed.cpp\n")
  file(WRITE "${root}/${file}" "${content}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" "-DROOT=${root}" -P "${script}"
    RESULT_VARIABLE status
    OUTPUT_VARIABLE printed
    ERROR_VARIABLE printed)
  if(pattern STREQUAL "")
    if(NOT status EQUAL 0)
      message(SEND_ERROR "${name}: must pass, but printed\n${printed}")
    endif()
  elseif(status EQUAL 0)
    message(SEND_ERROR "${name}: must fail, but passed")
  elseif(NOT printed MATCHES "${pattern}")
    message(SEND_ERROR "${name}: must print '${pattern}', but printed\n${printed}")
  endif()
endfunction()

set(src src/microslip)

expect(clean "${CHECK}" ${src}/identify/a.cpp
       "// std::cout, fopen(\n#include \"microslip/joint/joint.hpp\"\nint a[] = {1; 2};\n" "")
expect(io_writes "${CHECK}" ${src}/io/a.cpp "#include <fstream>\nstd::ofstream out;\n" "")
expect(relative "${CHECK}" ${src}/joint/a.cpp "#include \"../io/csv.hpp\"\n" "joint/a.cpp:1: write")
expect(exposed "${CHECK}" ${src}/joint/installed.hpp "#include <vector>\n#include <Eigen/Core>\n"
       "joint/installed.hpp:2: an installed header includes no other library: Eigen/Core")
expect(exposed_in_c "${CHECK}" ${src}/joint/installed.hpp "#include <zlib.h>\n"
       "joint/installed.hpp:1: an installed header includes no other library: zlib.h")
expect(exposed_by_another "${CHECK}" ${src}/joint/installed.hpp "#include \"microslip/joint/a.hpp\"\n"
       "joint/installed.hpp:1: an installed header includes only such: microslip/joint/a.hpp")
expect(exposed_below "${CHECK}" ${src}/io/uff/installed.hpp "#include <Eigen/Core>\n"
       "io/uff/installed.hpp:1: an installed header includes no other library: Eigen/Core")
expect(version "${CHECK}" ${src}/joint/installed.hpp "#include \"microslip/base/version.hpp\"\n" "")
expect(private "${CHECK}" ${src}/joint/a.hpp "#include <Eigen/Core>\n" "")
expect(stream "${CHECK}" ${src}/report/a.cpp "\n#include <fstream>\n"
       "report/a.cpp:2: only io touches files")
expect(fopen "${CHECK}" ${src}/joint/a.cpp "\n\nauto f = std::fopen(name, mode);\n"
       "joint/a.cpp:3: only io touches files")
expect(filesystem "${CHECK}" ${src}/base/a.hpp "namespace fs = std::filesystem;\n"
       "base/a.hpp:1: only io touches files")
expect(workflow_looks "${CHECK}" ${src}/workflow/a.cpp "namespace fs = std::filesystem;\n" "")
expect(workflow_reads "${CHECK}" ${src}/workflow/a.cpp "std::ifstream file;\n"
       "workflow/a.cpp:1: only io touches files")
expect(prints "${CHECK}" ${src}/joint/a.cpp "std::cout << 1;\n" "joint/a.cpp:1: the library never prints")
expect(prints_to_stream "${CHECK}" ${src}/joint/a.cpp "fmt::print(stderr, text);\n"
       "joint/a.cpp:1: the library never prints")
expect(aborts "${CHECK}" ${src}/io/a.cpp "std::abort();\n" "io/a.cpp:1: the library never ends")
expect(ends_its_child "${CHECK}" ${src}/io/hdf5/reading_worker.cpp "_exit(0);\n" "")
expect(draws "${CHECK}" ${src}/joint/a.cpp "std::mt19937 generator;\n" "joint/a.cpp:1: random numbers")
expect(threads "${CHECK}" ${src}/rig/a.cpp "#include <tbb/parallel_for.h>\n"
       "rig/a.cpp:1: threads come from base/execution and base/attended_work alone")
expect(threads_at_home "${CHECK}" ${src}/base/execution.cpp "#include <tbb/parallel_for.h>\n" "")
expect(stray "${CHECK}" ${src}/a.cpp "\n" "src/microslip/a.cpp:1: a source lies in")
expect(former_place "${CHECK}" tests/joint/a.cpp "#include <vector>\n#include \"microslip/joint/gone.hpp\"\n"
       "tests/joint/a.cpp:2: include headers from where they are: microslip/joint/gone.hpp")
expect(empty "${CHECK}" README.md "\n" "No source under")

expect(listed "${CHECK_LISTS}" ${src}/base/listed.cpp "\n" "")
expect(unlisted "${CHECK_LISTS}" ${src}/base/forgotten.hpp "\n"
       "src/microslip/base/forgotten.hpp: not named")
expect(listed_below "${CHECK_LISTS}" ${src}/io/uff/listed.cpp "\n" "")
expect(unlisted_below "${CHECK_LISTS}" ${src}/io/uff/forgotten.cpp "\n"
       "src/microslip/io/uff/forgotten.cpp: not named")
expect(listed_in_comment "${CHECK_LISTS}" ${src}/base/comment.cpp "\n"
       "src/microslip/base/comment.cpp: not named")
