// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/rig.hpp"
#include "microslip/signal/recording.hpp"
#include "support/reference_csv.hpp"

/// @file Rigs whose joint is known, and records of them.

namespace microslip::testing {

/// A steel beam that slides on a rod; accelerometers `acc1` (at the exciter) to `acc3`, vibrometer
/// `ldv`.
inline Rig reference_rig() {
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

/// The rig of tests/data/unseen_rig.csv: nothing in the project was tuned to it.
inline Rig unseen_rig() {
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

/// The joint of that rig.
inline Joint unseen_joint() {
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

/// How a record is taken.
struct Sampling {
  double rate = 4096.0;  // Hz
  std::size_t points = 2048;
  double force_noise = 0.002;         // N, standard deviation of a sample
  double acceleration_noise = 0.005;  // m/s²
  double vibrometer_noise = 2e-8;     // m
};

/// A noisy recording of the reference rig by another program, tests/data/reference_recordings;
/// level 1 to 6.
inline Recording reference_recording(int level) {
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

/// The levels of a rig that another program solved: a row of Fourier coefficients each.
class SolvedRig {
 public:
  explicit SolvedRig(const std::string& file)
      : table_(file),
        frequency(table_["frequency [Hz]"]),
        amplitude(table_["amplitude [m]"]),
        dissipation(table_["dissipation [J]"]),
        input_energy(table_["input_energy [J]"]) {
    add("force", kForce, "[N]");
    for (const char* name : {"acc1", "acc2", "acc3"}) add(name, kAcceleration, "[m/s^2]");
    add("ldv", kLength, "[m]");
  }

  [[nodiscard]] std::size_t size() const { return frequency.size(); }

  /// A noisy record of a level, its phase drawn too. The same for the same seed.
  [[nodiscard]] Recording record(std::size_t level, const Sampling& sampling,
                                 std::uint64_t seed) const {
    RandomStream random(seed, level);
    const double phase = 2.0 * std::numbers::pi * random.uniform();
    Recording recording;
    recording.source = "level_" + std::to_string(level + 1);
    recording.axis.step = 1.0 / sampling.rate;
    for (const Signal& signal : signals_) {
      const double noise = signal.dimension == kForce          ? sampling.force_noise
                           : signal.dimension == kAcceleration ? sampling.acceleration_noise
                                                               : sampling.vibrometer_noise;
      Channel& channel = recording.channels.emplace_back();
      channel.name = signal.name;
      channel.dimension = signal.dimension;
      for (std::size_t i = 0; i < sampling.points; ++i) {
        const double angle =
            phase + 2.0 * std::numbers::pi * frequency[level] * recording.axis.at(i);
        channel.values.push_back(value(signal, level, angle) + noise * random.normal());
      }
    }
    return recording;
  }

 private:
  struct Signal {
    std::string name;
    Dimension dimension;
    std::vector<double> mean;                                 // a level
    std::vector<std::vector<std::complex<double>>> harmonic;  // [n − 1][level]
  };

  void add(const std::string& name, const Dimension& dimension, const std::string& unit) {
    constexpr int kHarmonics = 9;
    Signal signal{name, dimension, table_[name + "_re0 " + unit], {}};
    for (int n = 1; n <= kHarmonics; ++n) {
      const auto& real = table_[name + "_re" + std::to_string(n) + " " + unit];
      const auto& imaginary = table_[name + "_im" + std::to_string(n) + " " + unit];
      auto& harmonic = signal.harmonic.emplace_back();
      for (std::size_t i = 0; i < real.size(); ++i) harmonic.emplace_back(real[i], imaginary[i]);
    }
    signals_.push_back(signal);
  }

  static double value(const Signal& signal, std::size_t level, double angle) {
    double sum = signal.mean[level];
    for (std::size_t n = 1; n <= signal.harmonic.size(); ++n) {
      sum +=
          (signal.harmonic[n - 1][level] * std::polar(1.0, static_cast<double>(n) * angle)).real();
    }
    return sum;
  }

  ReferenceTable table_;
  std::vector<Signal> signals_;

 public:
  std::vector<double> frequency;     ///< Hz
  std::vector<double> amplitude;     ///< of the joint, m
  std::vector<double> dissipation;   ///< of the joint, J
  std::vector<double> input_energy;  ///< J
};

}  // namespace microslip::testing
