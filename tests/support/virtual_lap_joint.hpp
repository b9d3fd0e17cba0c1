// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/csv.hpp"

/// @file
/// A beam with a lap joint whose first mode and joint are known, and its tests as they would be
/// recorded.

namespace microslip::test {

/// As rig.toml: the drive point moves as the joint does, k is 0.78 of the stiffness of the mode.
inline const std::string kLapRig = R"(schema = "microslip.rig/1"
[modes]
frequency_Hz = [80.0]
excitation = [0.7]
joint = [0.7]
[damping]
loss_factor = [0.002]
[excitation]
channel = "force"
[[accelerometer]]
channel = "acceleration"
shape = [0.7]
)";

/// The same as model.toml.
inline const std::string kLapModel = R"(schema = "microslip.model/1"
[structure]
frequency_Hz = [80.0]
loss_factor = [0.002]
static_attachments = 0
[[structure.point]]
name = "drive"
shape = [0.7]
[[joint]]
file = "joint.json"
shape = [0.7]
spring_in_modes_N_per_m = 4e5
[excitation]
point = "drive"
[[accelerometer]]
channel = "acceleration"
point = "drive"
)";

/// joint.json of the true joint, whose losses rise with A^3.2.
inline const std::string kLapJoint = R"({
  "schema": "microslip.joint/1", "stiffness_N_per_m": 4e5,
  "density": [{"type": "power_law", "coefficient": 0.0002, "exponent": 0.2, "from_N": 0, "to_N": 150}]
}
)";

/// A value with noise of a relative standard deviation.
inline double noisy(double value, double sigma, RandomStream& random) {
  return value * (1.0 + sigma * random.normal());
}

/// What `frf` wrote as a stepped sine: force and acceleration are read with 0.3 % and 0.1 % of
/// noise at each step, and the phase is that of the acceleration.
inline std::string noisy_sweep(const std::string& response, RandomStream& random) {
  const CsvTable table(response, "frf.csv");
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  const std::vector<double> force = table.numbers("force", kForce);
  const std::vector<double> acceleration = table.numbers("acceleration", kAcceleration);
  const std::vector<double> lag = table.numbers("phase", kAngle);
  std::string text = "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n";
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    text += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g}\n", frequency[i],
                        noisy(force[i], 0.003, random), noisy(acceleration[i], 0.001, random),
                        std::numbers::pi - lag[i]);
  }
  return text;
}

/// What `march` wrote as the record of an accelerometer with noise, a standard deviation in m/s².
inline std::string noisy_record(const std::string& history, double noise, RandomStream& random) {
  const CsvTable table(history, "march.csv");
  const std::vector<double> time = table.numbers("time", kTime);
  const std::vector<double> acceleration = table.numbers("acceleration", kAcceleration);
  std::string text = "time [s],acceleration [m/s^2]\n";
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {  // the last row is off the raster
    text += fmt::format("{:.12g},{:.9g}\n", time[i], acceleration[i] + noise * random.normal());
  }
  return text;
}

}  // namespace microslip::test
