// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/io/csv_writer.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/observe/levels.hpp"
#include "support/force_records.hpp"

/// @file
/// Inputs that the program takes.

namespace microslip::cli_test {

/// Part of the stiffness never slips; macro-slip ends at 40 N.
inline const std::string kJointText = R"({
  "schema": "microslip.joint/1",
  "stiffness_N_per_m": 1.7e5,
  "density": [
    {"type": "uniform", "from_N": 0, "to_N": 20, "weight": 0.4},
    {"type": "piecewise_linear", "slip_force_N": [5, 25, 40], "density_per_N": [0, 0.02, 0]}
  ]
}
)";

inline Joint sample_joint() { return parse_joint(kJointText, "joint.json").joint; }

/// Levels of that joint: 20 amplitudes from 10 to 200 µm, D with a scatter of some 0.3 %.
inline Levels sample_levels() {
  constexpr int kLevels = 20;
  const Joint joint = sample_joint();
  Levels levels;
  for (int i = 1; i <= kLevels; ++i) {
    const double amplitude = 1e-5 * i;
    levels.amplitude.push_back(amplitude);
    levels.dissipation.push_back(dissipation(joint, amplitude) * (1.0 + 0.004 * std::sin(7.0 * i)));
  }
  return levels;
}

inline std::string sample_levels_text() { return levels_table(sample_levels()).str(); }

/// Force and displacement of that joint on a random path of up to 240 µm.
inline ForceRecord sample_record(std::uint64_t seed = 1) {
  const std::vector<double> path = testing::random_motion(3000, 2.4e-4, seed);
  return testing::simulated_record(sample_joint(), path, seed, {});
}

/// As CSV.
inline std::string record_text(const ForceRecord& record,
                               const std::string& header = "time [s],u [um],f [N]") {
  std::string text = header + "\n";
  for (std::size_t i = 0; i < record.size(); ++i) {
    text += fmt::format("{:.6f},{:.9g},{:.9g}\n", record.time_step * static_cast<double>(i),
                        1e6 * record.displacement[i], record.force[i]);
  }
  return text;
}

/// A decay as an accelerometer would see it: damping falls with the amplitude and the frequency
/// rises.
struct SampleDecay {
  double rate = 2000.0;     ///< Hz
  double duration = 2.0;    ///< s
  double amplitude = 1e-4;  ///< of the displacement at time 0, m
  double frequency = 50.0;  ///< at time 0, Hz
  double damping = 0.01;    ///< at time 0, of the acceleration
};

/// Acceleration a e^{u} cos φ of u̇ = −δe^{u}, so e^{u} = 1/(1 + δt), and ω̇ = ω·0.01·δe^{u}.
inline std::string sample_decay_text(const SampleDecay& decay = {}) {
  const double omega = 2.0 * 3.14159265358979 * decay.frequency;
  const double delta = decay.damping * omega;
  std::vector<double> time;
  std::vector<double> acceleration;
  for (int i = 0; i < static_cast<int>(decay.rate * decay.duration); ++i) {
    const double t = i / decay.rate;
    const double s = 1.0 + delta * t;
    const double phase = omega * (t + 0.01 * (s * std::log(s) - s + 1.0) / delta);
    time.push_back(t);
    acceleration.push_back(decay.amplitude * omega * omega / s * std::cos(phase));
  }
  CsvWriter writer;
  writer.add_numbers("time", kTime, time);
  writer.add_numbers("acc1", kAcceleration, acceleration);
  return writer.str();
}

constexpr double kSampleStiffness = 1.7e5;  // N/m

}  // namespace microslip::cli_test
