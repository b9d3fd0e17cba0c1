// SPDX-License-Identifier: MIT
#include "support/slider_records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip::testing {
namespace {

/// Steps of the path between samples: turns lie on them, and so beside samples.
constexpr std::size_t kFine = 16;

double logit(double q) { return std::log(q / (1.0 - q)) / 1.702; }

class PathBuilder {
 public:
  explicit PathBuilder(std::size_t quarter) : quarter_(static_cast<double>(quarter)) {}

  /// At the speed of one A a quarter.
  void go(double to) {
    const double from = path_.back();
    const double steps = std::round(std::abs(to - from) * quarter_);
    for (double i = 1.0; i <= steps; ++i) path_.push_back(from + (to - from) * i / steps);
  }
  void hold() { path_.insert(path_.end(), static_cast<std::size_t>(quarter_), path_.back()); }
  void sine() {
    for (double i = 1.0; i <= 4.0 * quarter_; ++i) {
      path_.push_back(std::sin(std::numbers::pi / 2.0 * i / quarter_));
    }
  }
  std::vector<double> take() && { return std::move(path_); }

 private:
  double quarter_;  // steps
  std::vector<double> path_ = {0.0};
};

std::vector<double> path_of(Motion motion, std::size_t per_cycle) {
  PathBuilder path(per_cycle * kFine / 4);
  const int cycles = motion == Motion::kGrowingTriangles ? 5 : 3;
  for (int c = 1; c <= cycles; ++c) {
    if (motion == Motion::kSines) {
      path.sine();
      continue;
    }
    const bool holds = motion == Motion::kRampsWithHolds;
    const double to = motion == Motion::kGrowingTriangles ? c / 5.0 : holds && c == 2 ? 0.6 : 1.0;
    path.go(to);
    if (holds) path.hold();
    path.go(-to);
    if (holds) path.hold();
    path.go(0.0);
  }
  if (motion == Motion::kGrowingTriangles) path.go(1.0);
  return std::move(path).take();
}

}  // namespace

std::vector<double> Sliders::forces_on(const std::vector<double>& path) const {
  std::vector<double> stretch(slip_displacement.size(), 0.0);
  std::vector<double> force;
  double before = path.front();
  for (const double u : path) {
    double sum = elastic * u;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      stretch[i] = std::clamp(stretch[i] + u - before, -slip_displacement[i], slip_displacement[i]);
      sum += stiffness[i] * stretch[i];
    }
    before = u;
    force.push_back(sum);
  }
  return force;
}

Sliders sliders_of(const std::string& name, double elastic,
                   const std::function<double(double)>& quantile, std::size_t count) {
  Sliders all{name, {}, {}, elastic};
  const auto n = static_cast<double>(count);
  for (double i = 0.5; i < n; ++i) {
    all.slip_displacement.push_back(quantile(i / n));
    all.stiffness.push_back((1.0 - elastic) / n);
  }
  return all;
}

std::vector<Sliders> all_sliders() {
  return {sliders_of("even", 0.2, [](double q) { return 0.8 * q; }),
          sliders_of("even beyond", 0.2, [](double q) { return 1.5 * q; }),
          sliders_of("power -0.5", 0.1, [](double q) { return 1.2 * q * q; }),
          sliders_of("power -0.3", 0.1, [](double q) { return 0.9 * std::pow(q, 1.0 / 0.7); }),
          sliders_of(
              "one", 0.1, [](double) { return 0.3; }, 1),
          sliders_of("three", 0.15, [](double q) { return q < 0.3   ? 0.1
                                                          : q < 0.6 ? 0.35
                                                                    : 0.7; }),
          sliders_of("band", 0.3, [](double q) { return 0.2 + 0.4 * q; }),
          sliders_of("lognormal", 0.2, [](double q) { return 0.25 * std::exp(0.5 * logit(q)); }),
          sliders_of("bump", 0.2, [](double q) { return std::abs(0.5 + 0.1 * logit(q)); }),
          sliders_of("exponential", 0.05, [](double q) { return -0.3 * std::log(1.0 - q); }),
          sliders_of("ramp", 0.2, [](double q) { return 0.8 * std::sqrt(q); }),
          sliders_of("two populations", 0.25,
                     [](double q) { return q < 0.5 ? 0.05 + 0.2 * q : 0.4 + 0.6 * (q - 0.5); })};
}

ForceRecord record_of(const Sliders& sliders, Motion motion, const SliderRecord& how) {
  const std::vector<double> path = path_of(motion, how.per_cycle);
  const std::vector<double> force = sliders.forces_on(path);
  const auto [low, high] = std::ranges::minmax(force);
  RandomStream random(how.seed, 79);
  ForceRecord record;
  record.time_step = 1e-3;
  const auto add = [&](double u, double f) {
    const double of_path = how.path_noise * random.normal();
    const double of_force = how.force_noise * std::max(-low, high) * random.normal();
    record.displacement.push_back(kSliderAmplitude * (u + of_path));
    record.force.push_back(kSliderStiffness * kSliderAmplitude * (f + of_force));
  };
  add(0.0, 0.0);
  for (std::size_t i = how.between == 0 ? kFine : how.between; i < path.size(); i += kFine) {
    add(path[i], force[i]);
  }
  return record;
}

}  // namespace microslip::testing
