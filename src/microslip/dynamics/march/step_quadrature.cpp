// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/step_quadrature.hpp"

#include "microslip/dynamics/march/step_cubic.hpp"

namespace microslip {
namespace {

/// A load over the first part of a step: its value and slope at the end of the part, and its excess
/// in the middle of the part over the cubic through the ends of that.
struct PartialLoad {
  double value;
  double slope;  // over the share of the step
  double middle;
};

/// The part of p_m 16x²(1 − x)² with p_m = 1.
PartialLoad bump_until(double share) {
  const auto bump = [](double x) { return 16.0 * x * x * (1.0 - x) * (1.0 - x); };
  const double slope = 32.0 * share * (1.0 - share) * (1.0 - 2.0 * share);
  const double cubic = 0.5 * bump(share) - 0.125 * share * slope;
  return {bump(share), slope, bump(0.5 * share) - cubic};
}

/// The part of the cubic with these values and slopes, over the share, at the ends of the step.
PartialLoad cubic_until(double share, const StepCubic& cubic) {
  return {cubic.value(share), cubic.slope(share), 0.0};
}

}  // namespace

StepQuadrature::StepQuadrature(std::span<const Mode> modes)
    : modes_(modes.begin(), modes.end()),
      part_(modes),
      weights_(padded(modes.size()) * kInnerPoints * kKinds, 0.0),
      groups_(padded(modes.size()) / kLanes) {}

void StepQuadrature::set_length(double length) {
  if (length == length_) return;
  length_ = length;
  for (std::size_t point = 0; point < kInnerPoints; ++point) {
    const double share = kInnerPoint[point];
    part_.set_length(share * length);
    const PartialLoad start = cubic_until(share, {1.0, 0.0, 0.0, 0.0, 1.0});
    const PartialLoad start_slope = cubic_until(share, {0.0, length, 0.0, 0.0, 1.0});
    const PartialLoad end = cubic_until(share, {0.0, 0.0, 1.0, 0.0, 1.0});
    const PartialLoad end_slope = cubic_until(share, {0.0, 0.0, 0.0, length, 1.0});
    const PartialLoad bump = bump_until(share);
    for (std::size_t group = 0; group < groups_; ++group) {
      const double* by = part_.data() + group * StepWeights::kKinds * kLanes;
      double* to = weights_.data() + (group * kInnerPoints + point) * kKinds * kLanes;
      for (std::size_t j = 0; j < kLanes; ++j) {
        const auto of = [&](StepWeights::Kind kind) { return by[kind * kLanes + j]; };
        const auto response = [&](const PartialLoad& load) {
          return of(StepWeights::kC1) * load.value + of(StepWeights::kD1) * load.slope / length +
                 of(StepWeights::kCM) * load.middle;
        };
        to[kE21 * kLanes + j] = of(StepWeights::kE21);
        to[kE22 * kLanes + j] = of(StepWeights::kE22);
        to[kC0 * kLanes + j] = of(StepWeights::kC0) + response(start);
        to[kD0 * kLanes + j] = of(StepWeights::kD0) + response(start_slope);
        to[kC1 * kLanes + j] = response(end);
        to[kD1 * kLanes + j] = response(end_slope);
        to[kCM * kLanes + j] = response(bump);
      }
    }
    for (std::size_t i = 0; i < modes_.size(); ++i) {
      const double angle = modes_[i].angular_frequency * 0.5 * share * length;
      weights_[((i / kLanes * kInnerPoints + point) * kKinds + kOfBreakpoints) * kLanes +
               i % kLanes] =
          length * impulse_response(0.5 * modes_[i].loss_factor * angle, angle * angle).slope;
    }
  }
}

}  // namespace microslip
