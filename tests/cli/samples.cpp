// SPDX-License-Identifier: MIT
#include "cli/samples.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace microslip::cli_test {

Joint sample_joint() { return parse_joint(kJointText, "joint.json").joint; }

Levels sample_levels() {
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

std::string sample_levels_text() { return levels_table(sample_levels()).str(); }

ForceRecord sample_record(std::uint64_t seed) {
  const std::vector<double> path = testing::random_motion(3000, 2.4e-4, seed);
  return testing::simulated_record(sample_joint(), path, seed, {});
}

std::string record_text(const ForceRecord& record, const std::string& header) {
  std::string text = header + "\n";
  for (std::size_t i = 0; i < record.size(); ++i) {
    text += fmt::format("{:.6f},{:.9g},{:.9g}\n", record.time_step * static_cast<double>(i),
                        1e6 * record.displacement[i], record.force[i]);
  }
  return text;
}

std::string sample_decay_text(const SampleDecay& decay) {
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

}  // namespace microslip::cli_test
