// SPDX-License-Identifier: MIT
#include "microslip/joint/path.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length != expected) {
    throw InputError(fmt::format("length of {}", what), static_cast<double>(length),
                     fmt::format("must be that of the displacements, {}", expected));
  }
}

}  // namespace

void refuse_displacement(std::string_view name, double x) {
  throw InputError(std::string(name), x,
                   std::isfinite(x) ? fmt::format("must be from {} to {} m", -kFarthestDisplacement,
                                                  kFarthestDisplacement)
                                    : "must be finite");
}

void check_path(std::span<const double> x, std::span<const double> force) {
  check_length("force", force.size(), x.size());
  bool good = true;  // without an early end the loop is done several samples at a time
  for (const double value : x) good &= can_be_followed(value);
  if (good) return;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!can_be_followed(x[i])) refuse_displacement(fmt::format("displacement[{}]", i), x[i]);
  }
}

void check_path(std::span<const double> x, std::span<const double> normal_load,
                std::span<const double> force) {
  check_path(x, force);
  check_length("normal_load", normal_load.size(), x.size());
  for (std::size_t i = 0; i < normal_load.size(); ++i) {
    if (!(std::isfinite(normal_load[i]) && normal_load[i] >= 0.0)) {
      throw InputError(
          fmt::format("normal_load[{}]", i), normal_load[i], "must be 0 or more, and finite",
          "Give the normal load as a ratio to that at which the joint was identified.");
    }
  }
}

}  // namespace microslip
