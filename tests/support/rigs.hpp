// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/rig/setup/rig.hpp"
#include "microslip/signal/recording/recording.hpp"
#include "support/reference_csv.hpp"

/// @file Rigs whose joint is known, and records of them.

namespace microslip::testing {

/// A steel beam that slides on a rod; accelerometers `acc1` (at the exciter) to `acc3`, vibrometer
/// `ldv`.
Rig reference_rig();

/// The rig of tests/data/unseen_rig.csv: nothing in the project was tuned to it.
Rig unseen_rig();

/// The joint of that rig.
Joint unseen_joint();

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
Recording reference_recording(int level);

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
