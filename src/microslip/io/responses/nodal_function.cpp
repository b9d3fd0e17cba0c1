// SPDX-License-Identifier: MIT
#include "microslip/io/responses/nodal_function.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdlib>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kFreedoms = static_cast<std::int64_t>(kNodalDirections);

DegreeOfFreedom freedom_of(const UffPoint& point, std::string_view what,
                           const NodalFunction& function) {
  const std::int64_t direction = std::abs(point.direction);
  if (point.node >= 1 && direction >= 1 && direction <= kFreedoms) {
    return {point.node, static_cast<NodalDirection>(direction - 1)};
  }
  throw InputError(fmt::format("{} of {}", what, function.name),
                   fmt::format("node {}, direction {}", point.node, point.direction),
                   "must have a node, 1 or more, and a direction, 1 to 6 or -1 to -6",
                   function.point_remedy);
}

std::string freedom_text(const DegreeOfFreedom& freedom) {
  return fmt::format("node {} {}", freedom.node,
                     kNodalDirectionNames[static_cast<std::size_t>(freedom.direction)]);
}

bool is_turn(const DegreeOfFreedom& freedom) { return freedom.direction >= NodalDirection::kTurnX; }

/// How often the motion is differentiated; the radian may be written or not.
int derivatives_of(const FrequencyResponse& response, const NodalFunction& function) {
  if (!function.dimension) {
    throw InputError(response.name, "without unit", function.unit_rule, function.unit_remedy);
  }
  const Dimension motion = is_turn(response.response) ? kDimensionless : kLength;
  const Dimension force = is_turn(response.reference) ? kEnergy : kForce;
  Dimension rest = *function.dimension * force / motion;
  rest.angle = 0;
  for (const int derivatives : {0, 1, 2}) {
    if (rest == kTime.power(-derivatives)) return derivatives;
  }
  throw InputError(response.name, fmt::format("in {}", si_unit(*function.dimension)),
                   "must be a displacement, velocity or acceleration over a force");
}

void check_content(const FrequencyResponse& response) {
  const std::vector<double>& frequency = response.frequency;
  if (frequency.size() < 2) {
    throw InputError(response.name, fmt::format("{} lines above 0 Hz", frequency.size()),
                     "must have at least two");
  }
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    if (!std::isfinite(response.values[i].real()) || !std::isfinite(response.values[i].imag())) {
      throw InputError(fmt::format("{} at {:.6g} Hz", response.name, frequency[i]),
                       "not a number, or infinite", "must be finite");
    }
    if (i > 0 && !(frequency[i] > frequency[i - 1])) {
      throw InputError(response.name,
                       fmt::format("{:.6g} Hz after {:.6g} Hz", frequency[i], frequency[i - 1]),
                       "must rise in frequency");
    }
  }
}

}  // namespace

std::string NodalFunction::full_name() const {
  return fmt::format("{} ({} by a force at {})", name,
                     freedom_text(freedom_of(response, "response", *this)),
                     freedom_text(freedom_of(reference, "reference", *this)));
}

FrequencyResponse frequency_response(const NodalFunction& function) {
  FrequencyResponse response{.name = function.full_name(),
                             .response = freedom_of(function.response, "response", function),
                             .reference = freedom_of(function.reference, "reference", function)};
  if (function.imaginary.empty()) {
    throw InputError(response.name, "real", "must be complex: a response has a phase");
  }
  const bool backwards = (function.response.direction < 0) != (function.reference.direction < 0);
  if (function.axis.dimension != kFrequency) {
    throw InputError(response.name, fmt::format("over {}", dimension_name(function.axis.dimension)),
                     "must be over frequency");
  }
  response.derivatives = derivatives_of(response, function);
  for (std::size_t i = 0; i < function.values.size(); ++i) {
    const double frequency = function.axis.at(i);
    if (!(frequency > 0.0)) continue;
    const std::complex<double> value(function.values[i], function.imaginary[i]);
    response.frequency.push_back(frequency);
    response.values.push_back(backwards ? -value : value);
  }
  check_content(response);
  return response;
}

}  // namespace microslip
