// SPDX-License-Identifier: MIT
#include "microslip/joint/covered_range.hpp"

#include <fmt/format.h>

#include "microslip/base/units.hpp"

namespace microslip {
std::optional<Warning> beyond_identification(const Joint& joint, double amplitude,
                                             std::optional<double> covered_to) {
  constexpr double kBeyond = 1.02;
  if (!covered_to) return std::nullopt;
  const double reached = joint.stiffness() * amplitude;
  if (!(reached > kBeyond * *covered_to)) return std::nullopt;
  return Warning{
      "beyond_identification",
      fmt::format(
          "the joint moves by {}, {:.3g} times the {} of the highest level it was identified from; "
          "slip beyond that is not identified. Identify it with higher levels.",
          length_text(amplitude), reached / *covered_to,
          length_text(*covered_to / joint.stiffness()))};
}

}  // namespace microslip
