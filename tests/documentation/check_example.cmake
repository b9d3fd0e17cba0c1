# Fails unless docs/cpp.md holds examples/cpp/identify.cpp to the letter.
cmake_minimum_required(VERSION 3.25)
file(READ "${ROOT}/docs/cpp.md" page)
file(READ "${ROOT}/examples/cpp/identify.cpp" example)
string(FIND "${page}" "```cpp\n${example}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "docs/cpp.md does not show examples/cpp/identify.cpp as it is")
endif()
