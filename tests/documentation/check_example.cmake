# Fails unless README.md holds examples/cpp/identify.cpp to the letter.
cmake_minimum_required(VERSION 3.25)
file(READ "${ROOT}/README.md" readme)
file(READ "${ROOT}/examples/cpp/identify.cpp" example)
string(FIND "${readme}" "```cpp\n${example}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "README.md does not show examples/cpp/identify.cpp as it is")
endif()
