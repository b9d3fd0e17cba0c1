// SPDX-License-Identifier: MIT
#include "support/rigs.hpp"

#include <cstddef>
#include <string>

namespace microslip::testing {

Rig reference_rig() {
  Rig rig;
  rig.structure = RigBeam{.length = 0.583,
                          .width = 0.040,
                          .thickness = 0.005,
                          .youngs_modulus = 2.07e11,
                          .mass_density = 7850.0};
  rig.contact = {.rod_radius = 0.030, .stiffness = 1.7e5};
  rig.loss_factor = {0.0028, 0.0018, 0.0011};
  rig.masses = {{0.55, 0.030}, {0.35, 0.010}, {0.18, 0.010}};
  rig.excitation = {.position = 0.55, .shape = {}, .channel = "force"};
  rig.accelerometers = {{0.55, {}, "acc1"}, {0.35, {}, "acc2"}, {0.18, {}, "acc3"}};
  rig.vibrometer = RigVibrometer{.channel = "ldv"};
  rig.test = RigTest{.response_from = 0.294,
                     .response_to = 39.24,
                     .count = 90,
                     .sampling_rate = 8192.0,
                     .duration = 1.0};
  return rig;
}

Rig unseen_rig() {
  Rig rig = reference_rig();
  rig.structure = RigBeam{.length = 0.56,
                          .width = 0.030,
                          .thickness = 0.0045,
                          .youngs_modulus = 2.0e11,
                          .mass_density = 7800.0};
  rig.contact = {.rod_radius = 0.025, .stiffness = 9.0e4};
  rig.loss_factor = {0.004, 0.0025, 0.0015};
  rig.masses = {{0.52, 0.020}, {0.30, 0.008}, {0.15, 0.008}};
  rig.excitation.position = 0.52;
  rig.accelerometers = {{0.52, {}, "acc1"}, {0.30, {}, "acc2"}, {0.15, {}, "acc3"}};
  return rig;
}

Joint unseen_joint() {
  PiecewiseLinearPart part{.slip_force = {0, 3, 6, 10, 15, 20, 26, 32, 40, 50},
                           .density = {6, 9, 14, 17, 15, 10, 8, 9, 7, 0}};
  double area = 0.0;
  for (std::size_t i = 1; i < part.density.size(); ++i) {
    area += 0.5 * (part.slip_force[i] - part.slip_force[i - 1]) *
            (part.density[i] + part.density[i - 1]);
  }
  for (double& value : part.density) value /= area;
  return Joint(9.0e4, SlipDensity({part}));
}

Recording reference_recording(int level) {
  const std::string name = "level_" + std::to_string(level) + ".csv";
  const ReferenceTable table(std::string(MICROSLIP_TEST_DATA) + "/reference_recordings/" + name);
  Recording recording;
  recording.source = name;
  recording.axis.step = table["time [s]"][1];
  recording.channels = {{"force", kForce, table["force [N]"], {}, {}},
                        {"acc1", kAcceleration, table["acc1 [m/s^2]"], {}, {}},
                        {"acc2", kAcceleration, table["acc2 [m/s^2]"], {}, {}},
                        {"acc3", kAcceleration, table["acc3 [m/s^2]"], {}, {}},
                        {"ldv", kLength, table["ldv [m]"], {}, {}}};
  return recording;
}

}  // namespace microslip::testing
