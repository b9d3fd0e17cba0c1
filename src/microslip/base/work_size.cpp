// SPDX-License-Identifier: MIT
#include "microslip/base/work_size.hpp"

#include <fmt/format.h>

#include "microslip/base/error.hpp"

namespace microslip {

std::size_t most_kept(double bytes_each) {
  return static_cast<std::size_t>(kMostMemory / bytes_each);
}

void check_memory(std::string_view what, double count, double bytes_each, std::string_view remedy) {
  if (count <= static_cast<double>(most_kept(bytes_each))) return;
  throw InputError(
      what, count,
      fmt::format("must be {} at most: each takes {:.0f} bytes here, and the limit is 1 GiB",
                  most_kept(bytes_each), bytes_each),
      remedy);
}

void check_steps(std::string_view what, double count, std::string_view made_of,
                 std::string_view remedy) {
  if (count <= kMostTimeSteps) return;
  throw InputError(what, count,
                   fmt::format("must be {:g} at most, which take an hour or more; these are {}",
                               kMostTimeSteps, made_of),
                   remedy);
}

}  // namespace microslip
