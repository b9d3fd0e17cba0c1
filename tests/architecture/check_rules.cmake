# Checks the rules of the house in every file under ROOT/src/microslip that no compiler checks:
#   - an installed header (PUBLIC in the CMakeLists.txt of its folder) includes no other library, so that a
#     user of the package needs nothing else;
#   - only io touches files, and documents, which are files by io; workflow may look which there are;
#   - only base/execution names the library of threads, and base/attended_work a thread;
#   - headers are included from where they are, in apps, bench, examples and tests, too;
#   - nothing prints (but io, which may write to standard output on request), ends the process, or
#     draws from a generator other than base/random.
# Which folder may include which is kept by the build itself, see cmake/MicroslipHouse.cmake.
# Prints file:line and the rule for each offence and fails if there is one.

cmake_minimum_required(VERSION 3.25)

string(
  JOIN "|" disk
  "# *include *<(fstream|fcntl.h|unistd.h|dirent.h|sys/stat.h|sys/mman.h)>"
  "std::(basic_)?[io]?fstream"
  "(^|[^A-Za-z0-9_])(fopen|freopen|tmpfile|mkstemp|popen) *\\(")
string(JOIN "|" look "# *include *<filesystem>" "std::filesystem")
string(JOIN "|" print "# *include *<(iostream|print|syncstream)>" "std::(cout|cerr|clog)"
       "(^|[^A-Za-z0-9_])(stdout|stderr|printf|puts|putchar|perror) *[;,()]" "fmt::print *\\( *\"")
string(JOIN "|" end "(^|[^A-Za-z0-9_.>])(abort|exit|_exit|quick_exit|terminate) *\\(" "std::(system|raise)")
string(JOIN "|" random "# *include *<random>" "std::(random_device|mt19937|rand|srand)"
       "(^|[^A-Za-z0-9_:.>])s?rand *\\(")

string(JOIN "|" threads "# *include *<(oneapi/|tbb/|thread>|future>|execution>|omp.h>|pthread)" "(^|[^A-Za-z0-9_])tbb::"
       "std::(jthread|thread|async|execution)" "# *pragma +omp +parallel")

# Exceptions that may end a process: a copy of this process that it started itself.
set(may_end src/microslip/io/hdf5/reading_worker.cpp src/microslip/io/bytes/child_process.cpp)

set(offences 0)
function(offend file number text)
  message("${file}:${number}: ${text}")
  math(EXPR count "${offences} + 1")
  set(offences ${count} PARENT_SCOPE)
endfunction()

# Headers that the folders install, as they are written in includes.
set(installed microslip/base/version.hpp)
file(
  GLOB lists
  RELATIVE "${ROOT}/src"
  "${ROOT}/src/microslip/*/CMakeLists.txt" "${ROOT}/src/microslip/*/*/CMakeLists.txt")
list(FILTER lists EXCLUDE REGEX "^microslip/bindings/")
foreach(list IN LISTS lists)
  file(READ "${ROOT}/src/${list}" headers)
  string(FIND "${headers}" " PUBLIC" from)
  if(from EQUAL -1)
    continue()
  endif()
  string(SUBSTRING "${headers}" ${from} -1 headers)
  string(REGEX REPLACE " (INTERNAL|PRIVATE).*" "" headers "${headers}")
  string(REGEX MATCHALL "[a-z_0-9]+\\.hpp" headers "${headers}")
  cmake_path(GET list PARENT_PATH folder)
  list(TRANSFORM headers PREPEND "${folder}/")
  list(APPEND installed ${headers})
endforeach()

file(
  GLOB_RECURSE files
  RELATIVE "${ROOT}"
  "${ROOT}/src/microslip/*.hpp" "${ROOT}/src/microslip/*.cpp")
list(SORT files)

foreach(file IN LISTS files)
  if(NOT file MATCHES "^src/microslip/([a-z_]+)/")
    offend("${file}" 1 "a source lies in one of the folders of src/microslip")
    continue()
  endif()
  set(folder "${CMAKE_MATCH_1}")

  string(REPLACE "src/" "" name "${file}")
  set(is_installed FALSE)
  if(name IN_LIST installed)
    set(is_installed TRUE)
  endif()

  # A list of lines: what is special to CMake lists has no part in the rules.
  file(READ "${ROOT}/${file}" content)
  string(REGEX REPLACE "[][;\\]" "," content "${content}")
  string(REPLACE "\n" ";" lines "${content}")

  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    string(REGEX REPLACE "//.*$" "" code "${line}")
    if(code STREQUAL "")
      continue()
    endif()

    if(line MATCHES "^ *# *include *[<\"]([^>\"]+)[>\"]")
      set(included "${CMAKE_MATCH_1}")
      if(included MATCHES "^microslip/")
        if(is_installed AND NOT included IN_LIST installed)
          offend("${file}" ${number} "an installed header includes only such: ${included}")
        endif()
      elseif(line MATCHES "include *\"")
        offend("${file}" ${number} "write the include of ${included} from microslip/ on")
      elseif(is_installed AND included MATCHES "[/.]" AND NOT included MATCHES "^sys/")
        offend("${file}" ${number} "an installed header includes no other library: ${included}")
      endif()
    endif()
    if(NOT folder MATCHES "^(io|documents)$" AND code MATCHES "${disk}")
      offend("${file}" ${number} "only io touches files: ${code}")
    endif()
    if(NOT folder MATCHES "^(io|documents|workflow)$" AND code MATCHES "${look}")
      offend("${file}" ${number} "only io touches files: ${code}")
    endif()
    if(NOT folder STREQUAL "io" AND code MATCHES "${print}")
      offend("${file}" ${number} "the library never prints: ${code}")
    endif()
    if(code MATCHES "${end}" AND NOT file IN_LIST may_end)
      offend("${file}" ${number} "the library never ends the process: ${code}")
    endif()
    if(code MATCHES "${threads}" AND NOT name MATCHES "^microslip/base/(attended_work|execution)\\.")
      offend("${file}" ${number} "threads come from base/execution and base/attended_work alone: ${code}")
    endif()
    if(code MATCHES "${random}")
      offend("${file}" ${number} "random numbers come from base/random alone: ${code}")
    endif()
  endforeach()
endforeach()

# Who links the library finds public headers where they were before, too; that is for others.
file(
  GLOB_RECURSE users
  RELATIVE "${ROOT}"
  "${ROOT}/apps/*.[ch]pp" "${ROOT}/bench/*.[ch]pp" "${ROOT}/examples/*.[ch]pp" "${ROOT}/tests/*.[ch]pp")
list(FILTER users EXCLUDE REGEX "^tests/install/")
foreach(file IN LISTS users)
  file(STRINGS "${ROOT}/${file}" includes REGEX "^ *# *include *\"microslip/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*$" "\\1" included "${include}")
    if(NOT EXISTS "${ROOT}/src/${included}" AND NOT included STREQUAL "microslip/base/version.hpp")
      file(STRINGS "${ROOT}/${file}" lines)
      list(FIND lines "${include}" number)
      math(EXPR number "${number} + 1")
      offend("${file}" ${number} "include headers from where they are: ${included}")
    endif()
  endforeach()
endforeach()

list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "No source under ${ROOT}/src/microslip.")
endif()
if(offences GREATER 0)
  message(FATAL_ERROR "${offences} offence(s) against the rules of the house.")
endif()
message(STATUS "${count} files keep the rules of the house.")
