// SPDX-License-Identifier: MIT
#include "microslip/identify/check_result.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/identify/inversion_model.hpp"

namespace microslip {
namespace {

constexpr std::string_view kRemedy = "Take a result of invert(), unchanged.";

void check_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(fmt::format("number of values of {} in the result", what),
                   static_cast<double>(length), fmt::format("must be {}", expected), kRemedy);
}

}  // namespace

void check_result(const InversionResult& result) {
  const bool has_model = result.model && result.model->chosen < result.model->path.size();
  if (!has_model || result.levels.size() == 0 || result.slip_force.empty()) {
    throw InputError("result of the inversion", "empty", "must be one that was found", kRemedy);
  }
  const std::size_t levels = result.levels.size();
  check_length("dissipation", result.levels.dissipation.size(), levels);
  check_length("fitted_dissipation", result.fitted_dissipation.size(), levels);
  if (!result.scatter_is_relative) {
    check_length("dissipation_std", result.levels.dissipation_std.size(), levels);
  }
  check_length("density", result.density.size(), result.slip_force.size());
}

}  // namespace microslip
