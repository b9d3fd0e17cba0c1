// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <numbers>
#include <vector>

#include "friction_rod.hpp"
#include "largest_error.hpp"
#include "low_passed_noise.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/joint/jenkins_network.hpp"
#include "rk4_sliders.h"

/// @file march() against an explicit scheme of fourth order in C with 100 sliders a joint, under
/// the same random force, each with the longest steps that leave an error of 1e-4, march() with
/// half as long ones where those are faster.

namespace microslip::bench {
namespace {

constexpr double kSeconds = 10.0;
constexpr double kError = 1e-4;      // of the displacement at the tip, over its largest
constexpr double kTolerance = 1e-6;  // of the equations of a step: well below the error
constexpr std::size_t kSliders = 100;
constexpr std::size_t kFiner = 16;  // how many times shorter the steps of the truth are

/// A structure as rk4_march() takes it, with its joints in elements.
class InSliders {
 public:
  explicit InSliders(const JointedStructure& structure) {
    const auto modes = structure.linear().modes();
    const auto shape = structure.linear().shape("tip");
    drive_.assign(shape.begin(), shape.end());
    for (const Mode& mode : modes) {
      stiffness_.push_back(mode.angular_frequency * mode.angular_frequency);
      damping_.push_back(mode.loss_factor * mode.angular_frequency);
    }
    constexpr std::size_t kFilled = (kSliders + RK4_LANES - 1) / RK4_LANES * RK4_LANES;
    for (const StructuralJoint& joint : structure.joints()) {
      shapes_.insert(shapes_.end(), joint.shape.begin(), joint.shape.end());
      const JenkinsNetwork network = JenkinsNetwork::discretise(joint.joint, kSliders);
      elastic_.push_back(network.elastic_stiffness());
      const std::size_t filled = elastic_.size() * kFilled;
      kappa_.insert(kappa_.end(), network.stiffness().begin(), network.stiffness().end());
      slip_.insert(slip_.end(), network.slip_displacement().begin(),
                   network.slip_displacement().end());
      kappa_.resize(filled, 0.0);
      slip_.resize(filled, 0.0);
    }
    plain_ = {modes.size(),  elastic_.size(), kFilled,       stiffness_.data(), damping_.data(),
              drive_.data(), shapes_.data(),  kappa_.data(), slip_.data(),      elastic_.data()};
  }
  InSliders(const InSliders&) = delete;
  InSliders& operator=(const InSliders&) = delete;

  /// The displacement at the tip, with so many steps from sample to sample.
  [[nodiscard]] std::vector<double> march(rk4_marching& march, const LoadHistory& loads,
                                          std::size_t steps) const {
    std::vector<double> displacement(loads.time.size());
    const double spacing = loads.time[1] - loads.time[0];
    if (march(&plain_, loads.forces[0].force.data(), loads.time.size(), spacing, steps,
              displacement.data()) != 0) {
      displacement.assign(displacement.size(), NAN);
    }
    return displacement;
  }

 private:
  std::vector<double> stiffness_;
  std::vector<double> damping_;
  std::vector<double> drive_;
  std::vector<double> shapes_;
  std::vector<double> kappa_;
  std::vector<double> slip_;
  std::vector<double> elastic_;
  rk4_structure plain_{};
};

using Marching = std::function<std::vector<double>(std::size_t steps)>;

/// The fewest steps from sample to sample that leave no more than the error allowed.
struct Fewest {
  std::size_t steps;
  double error;
  std::vector<double> exact;  ///< with steps kFiner times shorter
};

/// Halves steps until the error is small enough, then bisects between the last two.
Fewest fewest_steps(const Marching& march) {
  constexpr std::size_t kMost = 1024;
  std::size_t enough = 1;
  for (; enough < kMost; enough *= 2) {  // against twice as many, which is nearly as good
    if (largest_error(march(enough), march(2 * enough)) <= kError) break;
  }
  Fewest fewest{enough, 0.0, march(kFiner * enough)};
  fewest.error = largest_error(march(enough), fewest.exact);
  while (!(fewest.error <= kError) && fewest.steps < kMost) {
    fewest.error = largest_error(march(fewest.steps *= 2), fewest.exact);
  }
  std::size_t too_few = fewest.steps / 2;
  while (fewest.steps - too_few > 1) {
    const std::size_t middle = (fewest.steps + too_few) / 2;
    const double error = largest_error(march(middle), fewest.exact);
    if (error <= kError) {
      fewest.steps = middle;
      fewest.error = error;
    } else {
      too_few = middle;
    }
  }
  return fewest;
}

/// Processor time, s.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Half as long ones where they take less time: they need not be cut where long ones must.
Fewest faster_steps(const Marching& march, Fewest fewest) {
  const auto seconds = [&](std::size_t steps) {
    const double start = processor_seconds();
    benchmark::DoNotOptimize(march(steps).data());
    return processor_seconds() - start;
  };
  if (seconds(2 * fewest.steps) < seconds(fewest.steps)) {
    fewest.steps *= 2;
    fewest.error = largest_error(march(fewest.steps), fewest.exact);
  }
  return fewest;
}

/// Counters: the time of rk4 over that of march(), compiled plainly and for this processor; steps
/// from sample to sample and errors of both, each against itself with steps kFiner times shorter;
/// the energy balance of march(); what 100 sliders leave of the density; time of a step.
/// @param state  modes, joints and samples of the force a second.
void march_against_rk4(benchmark::State& state) {
  const JointedStructure structure = friction_rod(static_cast<std::size_t>(state.range(0)),
                                                  static_cast<std::size_t>(state.range(1)));
  const auto rate = static_cast<double>(state.range(2));
  const LoadHistory loads = low_passed_noise(kSeconds, rate);
  const InSliders sliders(structure);
  const Marching rk4 = [&](std::size_t steps) { return sliders.march(rk4_march, loads, steps); };
  const Marching native = [&](std::size_t steps) {
    return sliders.march(rk4_march_native, loads, steps);
  };
  const auto options = [&](std::size_t steps) {
    return MarchOptions{.step = 1.0 / (rate * static_cast<double>(steps)),
                        .points = {"tip"},
                        .tolerance = kTolerance,
                        .estimate_error = false};
  };
  const Marching own = [&](std::size_t steps) {
    return march(structure, loads, options(steps)).points[0].displacement;
  };
  const Fewest of_rk4 = fewest_steps(rk4);
  const Fewest of_march = faster_steps(own, fewest_steps(own));

  double march_seconds = 0.0;
  double rk4_seconds = 0.0;
  double native_seconds = 0.0;
  for (auto _ : state) {
    const double start = processor_seconds();
    benchmark::DoNotOptimize(own(of_march.steps).data());
    const double middle = processor_seconds();
    state.PauseTiming();
    march_seconds += middle - start;
    benchmark::DoNotOptimize(rk4(of_rk4.steps).data());
    const double later = processor_seconds();
    benchmark::DoNotOptimize(native(of_rk4.steps).data());
    rk4_seconds += later - middle;
    native_seconds += processor_seconds() - later;
    state.ResumeTiming();
  }
  const auto counted = [&](const char* name, double value) { state.counters[name] = value; };
  counted("rk4_ratio", rk4_seconds / march_seconds);
  counted("rk4_native_ratio", native_seconds / march_seconds);
  counted("rk4_steps", static_cast<double>(of_rk4.steps));
  counted("rk4_error", of_rk4.error);
  counted("march_steps", static_cast<double>(of_march.steps));
  counted("march_error", of_march.error);
  counted("march_imbalance", march(structure, loads, options(of_march.steps)).energy.imbalance());
  counted("sliders_error", largest_error(of_rk4.exact, of_march.exact));
  const double all = kSeconds * rate * static_cast<double>(state.iterations());
  counted("rk4_ns_a_step", 1e9 * rk4_seconds / (all * static_cast<double>(of_rk4.steps)));
  counted("march_ns_a_step", 1e9 * march_seconds / (all * static_cast<double>(of_march.steps)));
}
BENCHMARK(march_against_rk4)
    ->ArgNames({"modes", "joints", "rate"})
    ->Args({6, 2, 1000})
    ->Args({20, 10, 1000})
    ->Args({20, 10, 4096})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
