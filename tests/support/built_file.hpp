// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string>

namespace microslip::test {

/// Path of a program or a folder of the build: the value of the environment variable `variable`,
/// else `of_this_build`. The sanitized build sets it: it links these same objects, but runs
/// programs of its own.
inline std::string built_file(const char* variable, const char* of_this_build) {
  const char* other = std::getenv(variable);
  return other != nullptr ? other : of_this_build;
}

}  // namespace microslip::test
