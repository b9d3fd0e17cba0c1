// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/coarse_march.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/dynamics/structure/density_corners.hpp"

namespace microslip {
namespace {

/// The difference of two marches with h and 2h over the error of that with h is 2ᵖ − 1 for the
/// order p: 15 where the density is smooth between its atoms, 7 where it jumps inside of a step or
/// is nearly as steep as 1/f* after reversals. Which of them rules depends on the motion: their
/// geometric mean, 10.2, rounded, is off by a factor of 1.5 at most.
constexpr double kDifferenceOverError = 10.0;
constexpr double kDifferenceOverErrorOfSecondOrder = 3.0;  // p = 2
/// Lengths of intervals that differ by no more are the same: rounding of the time axis.
constexpr double kSameLength = 1e-9;

}  // namespace

std::size_t EvenSteps::count(double length, double longest, bool in_pairs) {
  const double pieces = in_pairs ? 2.0 : 1.0;
  return static_cast<std::size_t>(
      pieces * std::max(1.0, std::ceil(length / (pieces * longest) * (1.0 - kSameLength))));
}

void EvenSteps::set(double length, std::size_t count) {
  const double step = length / static_cast<double>(count);
  if (std::abs(step - weights_.length()) > kSameLength * step) weights_.set_length(step);
}

CoarseMarch::CoarseMarch(const JointedStructure& structure, const LoadHistory& loads,
                         const MarchOptions& options)
    : state_(structure, marched_joints(structure, loads, options.elements), options, 2.0),
      steps_(structure),
      second_order_(!loads.normal_loads.empty() || has_many_atoms(structure)) {
  for (const std::string& point : options.points) {
    shapes_.push_back(structure.linear().shape(point));
  }
  differences_.resize(shapes_.empty() ? structure.joints().size() : shapes_.size());
}

void CoarseMarch::start(const MarchLoads& acting, const InitialState& start) {
  acting.set(0, state_.loads());
  state_.start(start);
  for (std::size_t p = 0; acting.at_rest() && p < differences_.size(); ++p) {
    Difference& d = differences_[p];
    d.rest = shapes_.empty() ? state_.joint(p).displacement() : moved(state_, p);
    d.largest = MarchEnergy::kLeastOfRest * std::abs(d.rest);
  }
}

void CoarseMarch::set(const MarchLoads& acting, std::size_t interval, double length,
                      std::size_t count) {
  acting.set(interval, state_.loads());
  steps_.set(length, count);
}

void CoarseMarch::take(const MarchState& fine) {
  if (failed_) return;
  failed_ = !steps_.take(state_);
  if (!failed_) compare(fine);
}

std::optional<double> CoarseMarch::error() const {
  if (failed_ || !compared_) return std::nullopt;
  double worst = 0.0;
  for (const Difference& d : differences_) {
    if (d.difference > 0.0) worst = std::max(worst, d.difference / d.largest);
  }
  return worst / (second_order_ ? kDifferenceOverErrorOfSecondOrder : kDifferenceOverError);
}

double CoarseMarch::moved(const MarchState& state, std::size_t point) const {
  double w = 0.0;
  for (std::size_t i = 0; i < shapes_[point].size(); ++i) {
    w += shapes_[point][i] * state.displacement()[i];
  }
  return w;
}

void CoarseMarch::compare(const MarchState& fine) {
  compared_ = true;
  for (std::size_t p = 0; p < differences_.size(); ++p) {
    double w = 0.0;
    double miss = 0.0;
    if (shapes_.empty()) {
      w = fine.joint(p).displacement();
      miss = w - state_.joint(p).displacement();
    } else {
      for (std::size_t i = 0; i < shapes_[p].size(); ++i) {
        w += shapes_[p][i] * fine.displacement()[i];
        miss += shapes_[p][i] * (fine.displacement()[i] - state_.displacement()[i]);
      }
    }
    Difference& d = differences_[p];
    d.difference = std::max(d.difference, std::abs(miss));
    d.largest = std::max(d.largest, std::abs(w - d.rest));
  }
}

}  // namespace microslip
