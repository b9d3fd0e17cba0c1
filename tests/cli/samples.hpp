// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "microslip/base/units.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/io/cells/csv_writer.hpp"
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

Joint sample_joint();

/// Levels of that joint: 20 amplitudes from 10 to 200 µm, D with a scatter of some 0.3 %.
Levels sample_levels();

std::string sample_levels_text();

/// Force and displacement of that joint on a random path of up to 240 µm.
ForceRecord sample_record(std::uint64_t seed = 1);

/// As CSV.
std::string record_text(const ForceRecord& record,
                        const std::string& header = "time [s],u [um],f [N]");

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
std::string sample_decay_text(const SampleDecay& decay = {});

constexpr double kSampleStiffness = 1.7e5;  // N/m

}  // namespace microslip::cli_test
