// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/virtual_record.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/rig/reduction/channel_harmonics.hpp"
#include "microslip/rig/reduction/cycle_reduction.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr std::uint64_t kStreams = std::uint64_t{1} << 16U;  // of a record

/// Channels of one record, over the same points; the mean is the real part of harmonic 0.
class Sampler {
 public:
  Sampler(const RigTest& test, double angular_frequency, std::uint64_t seed, std::uint64_t record)
      : points_(static_cast<std::size_t>(std::llround(test.duration * test.sampling_rate))),
        step_(angular_frequency / test.sampling_rate),
        seed_(seed),
        first_stream_(kStreams * record) {
    phase_ = 2.0 * std::numbers::pi * RandomStream(seed_, first_stream_).uniform();
  }

  void add(const std::string& name, const Dimension& dimension, const Harmonics& harmonics,
           double noise) {
    const std::uint64_t stream = first_stream_ + 1 + channels_.size();
    Channel& channel = channels_.emplace_back();
    channel.name = name;
    channel.dimension = dimension;
    channel.values.reserve(points_);
    RandomStream random(seed_, stream);
    for (std::size_t i = 0; i < points_; ++i) {
      const double exact = value(harmonics, phase_ + step_ * static_cast<double>(i));
      channel.values.push_back(noise > 0.0 ? exact + noise * random.normal() : exact);
    }
  }

  [[nodiscard]] std::vector<Channel> channels() && { return std::move(channels_); }

 private:
  /// Σ Re(c_n zⁿ) by Horner's rule.
  static double value(const Harmonics& harmonics, double angle) {
    const Complex z = std::polar(1.0, angle);
    Complex sum = 0.0;
    for (std::size_t n = harmonics.size(); n-- > 1;) sum = (sum + harmonics[n]) * z;
    return harmonics[0].real() + sum.real();
  }

  std::size_t points_;
  double step_;  // of the phase
  std::uint64_t seed_;
  std::uint64_t first_stream_;
  double phase_ = 0.0;
  std::vector<Channel> channels_;
};

}  // namespace

Recording virtual_record(const Rig& rig, const StickState& state, const DrivenVibration& driven,
                         std::uint64_t seed, std::uint64_t record) {
  if (!rig.test) throw InputError("test", "none", "must be given for a virtual record");
  check_rig(rig);
  const std::vector<Harmonics> harmonics =
      channel_harmonics(driven.vibration, driven.force, rig, state, signal_layout(rig, true));
  const RigNoise noise = rig.noise.value_or(RigNoise{});
  Sampler sampler(*rig.test, driven.vibration.angular_frequency, seed, record);
  sampler.add(rig.excitation.channel, kForce, harmonics[0], noise.force);
  for (std::size_t j = 0; j < rig.accelerometers.size(); ++j) {
    sampler.add(rig.accelerometers[j].channel, kAcceleration, harmonics[1 + j], noise.acceleration);
  }
  if (rig.vibrometer) {
    sampler.add(rig.vibrometer->channel, kLength, harmonics.back(), noise.vibrometer);
  }
  Recording recording;
  recording.axis.step = 1.0 / rig.test->sampling_rate;
  recording.channels = std::move(sampler).channels();
  return recording;
}

std::uint64_t record_number(const VirtualLevel& level, bool before_control) {
  return 2 * (level.number - 1) + (before_control ? 1 : 0);
}

}  // namespace microslip
