// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/base/random.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/tables/csv.hpp"

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
double noisy(double value, double sigma, RandomStream& random);

/// The table of `frf` as a stepped sine: force and acceleration are read with 0.3 % and 0.1 % of
/// noise at each step, and the phase is that of the acceleration.
std::string noisy_sweep(const std::string& response, RandomStream& random);

/// The table of `march` as the record of an accelerometer with noise, a standard deviation in m/s².
std::string noisy_record(const std::string& history, double noise, RandomStream& random);

}  // namespace microslip::test
