// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion_result.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr std::string_view kUnchangedResult = "Take a result of invert(), unchanged.";

void check_count_of(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(fmt::format("number of values of {} in the result", what),
                   static_cast<double>(length), fmt::format("must be {}", expected),
                   std::string(kUnchangedResult));
}

}  // namespace

void InversionResult::check() const {
  if (chosen >= path.size() || slip_force.empty() || fitted_dissipation.empty()) {
    throw InputError("result of the inversion", "empty", "must not be empty",
                     std::string(kUnchangedResult));
  }
  check_count_of("density", density.size(), slip_force.size());
  check_count_of("slip_force in the posterior", posterior.slip_force.size(), slip_force.size());
  if (fitted_secant_stiffness.empty()) return;
  check_count_of("fitted_secant_stiffness", fitted_secant_stiffness.size(),
                 fitted_dissipation.size());
}

}  // namespace microslip
