// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/model_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "microslip/workflow/predict/model_text.hpp"

namespace microslip {

std::optional<SteadyVibration> vibration_near(const HarmonicBalance& balance, const Target& first,
                                              const Target& second,
                                              std::span<const SteadyVibration* const> starts,
                                              std::size_t mode, std::string& failure) {
  for (const SteadyVibration* start : starts) {
    if (start == nullptr) continue;
    VibrationResult found = balance.solve(first, second, *start);
    if (found.summary.converged()) return std::move(found.vibration);
  }
  VibrationResult found = balance.solve(first, second, mode);
  if (found.summary.converged()) return std::move(found.vibration);
  if (failure.empty()) {
    failure = fmt::format("{} and {}: {}", describe(first), describe(second), found.summary.reason);
  }
  return std::nullopt;
}

std::size_t nearest_mode(const JointedStructure& structure, double angular_frequency) {
  const std::vector<double> stuck = structure.stuck_frequencies();
  std::size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < stuck.size(); ++i) {
    if (!(stuck[i] > 0.0)) continue;  // rigid
    const double miss = std::abs(std::log(stuck[i] / angular_frequency));
    if (miss < best) {
      best = miss;
      nearest = i;
    }
  }
  return nearest;
}

HarmonicBalanceOptions options_of_draws(HarmonicBalanceOptions options) {
  constexpr double kDrawTolerance = 1e-8;
  options.accuracy = 0.0;
  options.frequencies.clear();
  options.tolerance = std::max(options.tolerance, kDrawTolerance);
  return options;
}

std::vector<Warning> motion_warnings(const HarmonicBalance& balance, const ModelFile& model,
                                     Quantity kept, ResponseCurve motions) {
  if (motions.points.empty()) return {};
  (void)add_truncation(balance, model, kept, motions);
  add_model_warnings(model, motions);
  return std::move(motions.warnings);
}

}  // namespace microslip
