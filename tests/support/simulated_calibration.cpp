// SPDX-License-Identifier: MIT
#include "support/simulated_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace microslip::testing {

CalibrationResult SimulatedTest::calibrated(const CalibrationOptions& options) const {
  return calibrate(given, sought, "p1", levels, options);
}

SimulatedTest simulated(const JointedStructure& truth, std::size_t modes, double from, double to,
                        int count, std::uint64_t seed) {
  std::vector<StructuralJoint> stuck(truth.joints().begin(), truth.joints().end());
  std::vector<std::size_t> sought;
  for (std::size_t j = 0; j < stuck.size(); ++j) {
    stuck[j].joint = Joint(stuck[j].joint.stiffness(), SlipDensity());
    sought.push_back(j);
  }
  SimulatedTest test{
      truth,  JointedStructure(truth.linear(), stuck, {Excitation{"p1"}}, truth.damping()),
      sought, {},
      {},     {}};
  test.amplitude.resize(stuck.size());
  test.loss.resize(stuck.size());
  std::vector<double> responses;
  for (int i = 0; i < count; ++i)
    responses.push_back(from * std::pow(to / from, i / (count - 1.0)));
  RandomStream random(seed, 0);
  const HarmonicBalance balance(truth, {"p1"}, {.harmonics = 7});
  for (std::size_t mode = 0; mode < modes; ++mode) {
    const ResponseCurve curve = balance.backbone(responses, mode);
    for (const SteadyVibration& point : curve.points) {
      test.levels.mode.push_back(mode);
      test.levels.displacement.push_back(point.response);
      test.levels.frequency.push_back(point.frequency());
      double sum = 0.0;
      for (std::size_t j = 0; j < stuck.size(); ++j) {
        test.amplitude[j].push_back(point.joints[j].amplitude);
        test.loss[j].push_back(point.joints[j].dissipation);
        sum += point.joints[j].dissipation;
      }
      test.levels.dissipation.push_back(sum * (1.0 + kLossNoise * random.normal()));
    }
  }
  return test;
}

double worst_error(const CalibrationResult& found, const SimulatedTest& test, std::size_t joint,
                   bool loss, double share) {
  double worst = 0.0;
  for (std::size_t i = 0; i < test.levels.size(); ++i) {
    double all = 0.0;
    for (const std::vector<double>& of_joint : test.loss) all += of_joint[i];
    if (loss && test.loss[joint][i] < share * all) continue;
    const JointAtLevel& at = found.levels[i].joints[joint];
    const double error = loss ? at.dissipation.value / test.loss[joint][i] - 1.0
                              : at.amplitude / test.amplitude[joint][i] - 1.0;
    worst = std::max(worst, std::abs(error));
  }
  return worst;
}

Joint tent(double k, double top, double share) {
  return {k, SlipDensity({PiecewiseLinearPart{{0.0, 0.4 * top, top},
                                              {0.2 / top, 2.0 * share / top, 0.0}}})};
}

void give_deviations(double displacement, SimulatedTest& test) {
  ModalLevels& levels = test.levels;
  levels.dissipation_std.clear();
  levels.frequency_std.clear();
  levels.displacement_std.clear();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels.dissipation_std.push_back(kLossNoise * levels.dissipation[i]);
    levels.frequency_std.push_back(2e-5 * levels.frequency[i]);
    levels.displacement_std.push_back(displacement * levels.displacement[i]);
  }
}

double loss_coverage(const CalibrationResult& found, const SimulatedTest& test, std::size_t joint) {
  double held = 0.0;
  for (std::size_t i = 0; i < test.levels.size(); ++i) {
    const Estimate& band = found.levels[i].joints[joint].dissipation;
    const double a = test.amplitude[joint][i];
    const double work = test.truth.joints()[joint].joint.stiffness() * a * a;
    const bool none = std::abs(test.loss[joint][i]) < 1e-13 * work;  // but for rounding
    const double loss = none ? 0.0 : test.loss[joint][i];
    held += loss >= band.lower && loss <= band.upper ? 1.0 : 0.0;
  }
  return held / static_cast<double>(test.levels.size());
}

void scatter_losses(const std::vector<double>& clean, std::uint64_t seed, SimulatedTest& test) {
  RandomStream random(seed, 0);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    test.levels.dissipation[i] = clean[i] * (1.0 + kLossNoise * random.normal());
  }
}

std::vector<double> clean_losses(const SimulatedTest& test) {
  std::vector<double> sum(test.levels.size(), 0.0);
  for (const std::vector<double>& of_joint : test.loss) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += of_joint[i];
  }
  return sum;
}

JointedStructure lap_and_other(const Joint& lap, const Joint& other) {
  return chain_structure({3.0, 2.0, 2.5}, {5e5, 4e5, 7e5, 2e5},
                         {{"lap", 0, 1, lap}, {"other", 1, 2, other}}, 0.004,
                         {lap.stiffness(), other.stiffness()});
}

}  // namespace microslip::testing
