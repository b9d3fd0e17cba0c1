# Checks the rules of the house in every file under ROOT/src/microslip:
#   - a folder includes only the folders its line below names;
#   - an installed header (one of FILE_SET HEADERS) includes no other library and no header that is
#     not installed, so that a user of the package needs nothing else;
#   - only io touches files;
#   - nothing prints (but io, which may be told to write to standard output), ends the process, or
#     draws from a generator other than base/random.
# Prints file:line and the rule for each offence and fails if there is one.

cmake_minimum_required(VERSION 3.25)

# Folder, then all it may include.
set(base_may_include base)
set(joint_may_include base joint)
set(structure_may_include base structure)
set(signal_may_include base signal)
set(identify_may_include base joint identify)
set(dynamics_may_include base joint structure dynamics)
set(rig_may_include base joint structure signal identify dynamics rig)
set(io_may_include base joint structure signal identify dynamics rig io)
set(report_may_include base joint structure identify dynamics signal rig report)

string(
  JOIN "|" disk
  "# *include *<(fstream|filesystem|fcntl.h|unistd.h|dirent.h|sys/stat.h|sys/mman.h)>"
  "std::(basic_)?[io]?fstream"
  "std::filesystem"
  "(^|[^A-Za-z0-9_])(fopen|freopen|tmpfile|mkstemp|popen) *\\(")
string(JOIN "|" print "# *include *<(iostream|print|syncstream)>" "std::(cout|cerr|clog)"
       "(^|[^A-Za-z0-9_])(stdout|stderr|printf|puts|putchar|perror) *[;,()]" "fmt::print *\\( *\"")
string(JOIN "|" end "(^|[^A-Za-z0-9_.>])(abort|exit|_exit|quick_exit|terminate) *\\(" "std::(system|raise)")
string(JOIN "|" random "# *include *<random>" "std::(random_device|mt19937|rand|srand)"
       "(^|[^A-Za-z0-9_:.>])s?rand *\\(")

# What may end a process all the same: the copy of this process that it started itself.
set(may_end src/microslip/io/reading_process.cpp)

set(offences 0)
function(offend file number text)
  message("${file}:${number}: ${text}")
  math(EXPR count "${offences} + 1")
  set(offences ${count} PARENT_SCOPE)
endfunction()

# What src/microslip/CMakeLists.txt installs, as it is written in includes.
set(installed microslip/base/version.hpp)
if(EXISTS "${ROOT}/src/microslip/CMakeLists.txt")
  file(READ "${ROOT}/src/microslip/CMakeLists.txt" list)
  string(REGEX MATCH "FILE_SET HEADERS[^)]*" list "${list}")
  string(REGEX MATCHALL "[a-z_0-9]+/[a-z_0-9]+\\.hpp" list "${list}")
  list(TRANSFORM list PREPEND microslip/)
  list(APPEND installed ${list})
endif()

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
  if(NOT DEFINED ${folder}_may_include)
    offend("${file}" 1 "the folder ${folder} has no line in check_arrows.cmake")
    continue()
  endif()

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
      if(included MATCHES "^microslip/([a-z_]+)/")
        if(NOT CMAKE_MATCH_1 IN_LIST ${folder}_may_include)
          offend("${file}" ${number} "${folder} must not include ${included}")
        endif()
        if(is_installed AND NOT included IN_LIST installed)
          offend("${file}" ${number} "an installed header includes only such: ${included}")
        endif()
      elseif(line MATCHES "include *\"")
        offend("${file}" ${number} "write the include of ${included} from microslip/ on")
      elseif(is_installed AND included MATCHES "/" AND NOT included MATCHES "^sys/")
        offend("${file}" ${number} "an installed header includes no other library: ${included}")
      endif()
    endif()
    if(NOT folder STREQUAL "io" AND code MATCHES "${disk}")
      offend("${file}" ${number} "only io touches files: ${code}")
    endif()
    if(NOT folder STREQUAL "io" AND code MATCHES "${print}")
      offend("${file}" ${number} "the library never prints: ${code}")
    endif()
    if(code MATCHES "${end}" AND NOT file IN_LIST may_end)
      offend("${file}" ${number} "the library never ends the process: ${code}")
    endif()
    if(code MATCHES "${random}")
      offend("${file}" ${number} "random numbers come from base/random alone: ${code}")
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
