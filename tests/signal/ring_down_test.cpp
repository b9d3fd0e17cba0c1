// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/ring_down.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "signal/decays.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"

namespace microslip::ring_down_test {
namespace {

using testing::JointedMode;
using testing::sampled;
using testing::ViscousMode;
using testing::with_noise;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kRate = 5000.0;  // Hz

/// By the number of derivatives of displacement.
constexpr Dimension kMeasured[] = {kLength, kVelocity, kAcceleration};

bool warns_of(const RingDown& decay, const std::string& code) {
  return std::ranges::find(decay.warnings, code, &Warning::code) != decay.warnings.end();
}

/// Largest relative deviations from a viscous mode.
void expect_viscous(const RingDown& decay, const ViscousMode& mode, double tolerance) {
  ASSERT_GT(decay.size(), 5U);
  const double z = mode.damping_ratio;
  for (std::size_t i = 0; i < decay.size(); ++i) {
    const double a = mode.amplitude * std::exp(-mode.decay() * (decay.time[i] - mode.start));
    EXPECT_NEAR(decay.amplitude[i] / a, 1.0, tolerance) << i;
    EXPECT_NEAR(decay.frequency[i] * kTwoPi / mode.damped_omega(), 1.0, tolerance) << i;
    EXPECT_NEAR(decay.damping_ratio[i] * std::sqrt(1.0 - z * z) / z, 1.0, tolerance) << i;
    // D = πcω_d A² with c = 2mδ.
    const double loss = kTwoPi * mode.decay() * mode.damped_omega() * a * a;
    EXPECT_NEAR(decay.loss[i] / loss, 1.0, 4.0 * tolerance) << i;
  }
}

TEST(RingDown, IsExactForAViscousMode) {
  for (const double damping : {0.001, 0.01, 0.04}) {
    const ViscousMode mode{.damping_ratio = damping};
    for (int n = 0; n <= 2; ++n) {
      const RingDown decay =
          ring_down(sampled({mode}, n, kRate, 2.0), kRate, kMeasured[static_cast<std::size_t>(n)]);
      // The model is exact; the fit stops at steps of 1e−8 in ln A, over a decay of 0.04 a window.
      expect_viscous(decay, mode, 1e-6);
      EXPECT_TRUE(decay.summary.converged()) << decay.summary.full();
      EXPECT_TRUE(decay.warnings.empty());
    }
  }
}

TEST(RingDown, StandardDeviationsAreThoseOfRepeatedMeasurements) {
  MICROSLIP_STUDY();
  const ViscousMode mode{.damping_ratio = 0.008};
  const std::vector<double> clean = sampled({mode}, 2, kRate, 2.0);
  double sum[3] = {};
  double count = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const RingDown decay = ring_down(with_noise(clean, 0.02, seed), kRate, kAcceleration);
    for (std::size_t i = 0; i < decay.size(); ++i) {
      const double a = mode.amplitude * std::exp(-mode.decay() * decay.time[i]);
      const double f = mode.damped_omega() / kTwoPi;
      const double z = mode.decay() / mode.damped_omega();
      sum[0] += std::pow((decay.amplitude[i] - a) / decay.amplitude_std[i], 2);
      sum[1] += std::pow((decay.frequency[i] - f) / decay.frequency_std[i], 2);
      sum[2] += std::pow((decay.damping_ratio[i] - z) / decay.damping_ratio_std[i], 2);
      count += 1.0;
    }
  }
  // Some 40 × 6 independent values: their rms is known to 5 %, the noise of each record to 10 %.
  for (const double s : sum) {
    EXPECT_LT(std::sqrt(s / count), 1.3);
    EXPECT_GT(std::sqrt(s / count), 1.0 / 1.3);
  }
}

TEST(RingDown, KeepsOtherModesOut) {
  const ViscousMode mode{.damping_ratio = 0.005};
  const ViscousMode above{.frequency = 66.0, .damping_ratio = 0.004, .amplitude = 0.8e-4};
  const ViscousMode below{.frequency = 31.0, .damping_ratio = 0.006, .amplitude = 0.5e-4};
  const ViscousMode far{.frequency = 210.0, .damping_ratio = 0.003, .amplitude = 0.5e-4};
  const std::vector<double> signal = sampled({mode, above, below, far}, 0, kRate, 3.0);
  RingDownOptions options;
  options.frequency = 50.0;
  const RingDown found = ring_down(signal, kRate, kLength, options);
  // Leakage through the taper of a mode of equal amplitude six lines away, see decay_window.hpp.
  expect_viscous(found, mode, 5e-3);
  EXPECT_TRUE(warns_of(found, "other_peaks"));

  options.band = {{36.0, 62.0}};
  const RingDown banded = ring_down(signal, kRate, kLength, options);
  expect_viscous(banded, mode, 5e-3);
  EXPECT_TRUE(banded.warnings.empty());
}

// A fifth of the stiffness is the joint's; released at 1.1 of the displacement where macro-slip
// begins.
JointedMode jointed_mode() {
  const double k = std::pow(kTwoPi * 50.0, 2);
  return {.joint = Joint::four_parameter(0.5 * 0.2 * k * 1e-4, 0.2 * k, -0.5, 0.5),
          .mass = 1.0,
          .viscosity = 2.0 * 0.0005 * kTwoPi * 50.0,
          .stiffness = 0.8 * k,
          .release = 1e-4};
}

double dissipation_of(const JointedMode& mode, double a, double frequency) {
  return dissipation(mode.joint, a) +
         std::numbers::pi * mode.viscosity * kTwoPi * frequency * a * a;
}

constexpr double kJointRate = 20480.0;

TEST(RingDown, GivesTheDissipationOfAJointWithoutNoise) {
  const JointedMode mode = jointed_mode();
  for (int n = 0; n <= 2; ++n) {
    const RingDown decay = ring_down(mode.sampled(n, kJointRate, 1.5, 5), kJointRate,
                                     kMeasured[static_cast<std::size_t>(n)]);
    ASSERT_LT(decay.amplitude.back(), 0.1 * decay.amplitude.front());
    for (std::size_t i = 0; i < decay.size(); ++i) {
      const double a = decay.amplitude[i];
      // Terms of the order ζ = 0.01 cancel in the derivation; what is left is that of the
      // harmonics. With δ − ω̇/(2ω) in place of δ − 2ω̇/ω it would be 3.5 %.
      EXPECT_NEAR(mode.mass * decay.loss[i] / dissipation_of(mode, a, decay.frequency[i]), 1.0,
                  0.003)
          << i;
      const double k = mode.stiffness + secant_stiffness(mode.joint, a);
      EXPECT_NEAR(mode.mass * std::pow(kTwoPi * decay.frequency[i], 2) / k, 1.0, 5e-4) << i;
    }
  }
}

/// Largest relative error of D over a decade of amplitude, and over the standard deviation.
struct DecadeError {
  double relative = 0.0;
  double normalised = 0.0;
};

DecadeError error_over_a_decade(const JointedMode& mode, const RingDown& decay) {
  EXPECT_LT(decay.amplitude.back(), 0.1 * decay.amplitude.front());
  DecadeError worst;
  for (std::size_t i = 0; i < decay.size(); ++i) {
    const double a = decay.amplitude[i];
    if (a < 0.1 * decay.amplitude.front()) break;
    const double d = dissipation_of(mode, a, decay.frequency[i]);
    worst.relative = std::max(worst.relative, std::abs(mode.mass * decay.loss[i] / d - 1.0));
    worst.normalised = std::max(worst.normalised, std::abs(mode.mass * decay.loss[i] - d) /
                                                      (mode.mass * decay.loss_std[i]));
  }
  return worst;
}

// 40 dB: noise with a standard deviation of 1 % of the first amplitude, 10 % of the last.
TEST(RingDown, GivesTheDissipationWithin2PercentAt40Decibels) {
  const JointedMode mode = jointed_mode();
  for (int n = 0; n <= 2; ++n) {
    const std::vector<double> clean = mode.sampled(n, kJointRate, 2.0, 5);
    for (std::uint64_t seed = 1; seed <= test::draws_of(5); ++seed) {
      const RingDown decay = ring_down(with_noise(clean, 0.01, seed), kJointRate,
                                       kMeasured[static_cast<std::size_t>(n)]);
      const DecadeError worst = error_over_a_decade(mode, decay);
      EXPECT_LT(worst.relative, 0.02) << n << ", seed " << seed;
      test::record_largest("dissipation [1]", worst.relative);
      EXPECT_LT(worst.normalised, 4.0) << n << ", seed " << seed;
    }
  }
}

TEST(RingDown, GivesTheDissipationWithin6PercentAt30Decibels) {
  const JointedMode mode = jointed_mode();
  const std::vector<double> clean = mode.sampled(2, kJointRate, 4.0, 5);
  for (std::uint64_t seed = 1; seed <= test::draws_of(5); ++seed) {
    const RingDown decay = ring_down(with_noise(clean, 0.03162, seed), kJointRate, kAcceleration);
    const DecadeError worst = error_over_a_decade(mode, decay);
    EXPECT_LT(worst.relative, 0.06) << seed;  // three of the standard deviations at the end, 2 %
    EXPECT_LT(worst.normalised, 4.0) << seed;
  }
}

TEST(RingDown, BeginsAfterTheImpact) {
  const ViscousMode mode{.damping_ratio = 0.01, .start = 0.437};
  std::vector<double> signal = sampled({mode}, 2, kRate, 3.0);
  const auto impact = static_cast<std::size_t>(mode.start * kRate) + 1;
  const double peak = mode.omega() * mode.omega() * mode.amplitude;
  for (std::size_t i = 0; i < 10; ++i) signal[impact + i] += 20.0 * peak;  // 2 ms
  const RingDown decay = ring_down(with_noise(signal, 1e-5, 1), kRate, kAcceleration);
  EXPECT_GT(decay.from, mode.start + 0.002);
  EXPECT_LT(decay.from, mode.start + 5.0 / mode.frequency);
  EXPECT_NEAR(decay.damping_ratio.front() / mode.damping_ratio, 1.0, 0.01);
}

/// Largest relative difference between what two results of equal levels say.
double difference(const RingDown& a, const RingDown& b) {
  double most = 0.0;
  for (const auto column : {&RingDown::time, &RingDown::amplitude, &RingDown::frequency,
                            &RingDown::damping_ratio, &RingDown::loss, &RingDown::window}) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      most = std::max(most, std::abs((a.*column)[i] / (b.*column)[i] - 1.0));
    }
  }
  return most;
}

TEST(RingDown, TakesAnOffsetForNoPartOfTheDecay) {
  MICROSLIP_OF_RELEASE_ALONE();
  for (const double start : {0.0, 0.437}) {  // without and with what comes before the trigger
    const ViscousMode mode{.damping_ratio = 0.01, .start = start};
    for (int n = 0; n <= 2; ++n) {
      const Dimension& measured = kMeasured[static_cast<std::size_t>(n)];
      const std::vector<double> plain = with_noise(sampled({mode}, n, kRate, 3.0), 1e-3, 4);
      const RingDown expected = ring_down(plain, kRate, measured);
      ASSERT_GT(expected.size(), 5U);
      EXPECT_LT(expected.from, start + 5.0 / mode.frequency);
      for (const double offset : {1.0, -1.0, 100.0}) {
        if (offset != 100.0 && !test::in_studies()) continue;  // the largest tells most
        std::vector<double> signal = plain;
        const double peak = std::pow(mode.omega(), n) * mode.amplitude;
        for (double& y : signal) y += offset * peak;
        const RingDown decay = ring_down(signal, kRate, measured);
        ASSERT_EQ(decay.size(), expected.size()) << n << ", " << offset;
        // Samples are rounded to 1e−14 of the amplitude; each fit stops at steps of 1e−8.
        EXPECT_LT(difference(decay, expected), 1e-6) << n << ", " << offset;
      }
    }
  }
}

Recording recording_of(std::vector<double> values, const Dimension& dimension) {
  return {.source = "hit.csv",
          .axis = {.dimension = kTime, .start = -0.5, .step = 1.0 / kRate, .values = {}},
          .channels = {{"acc1", dimension, std::move(values), {}, {}}},
          .attributes = {}};
}

TEST(RingDown, FindsTheBlowInTheRecordAsItIs) {
  // A filter for the mode would ring before the blow, a quarter of a second after the record
  // begins.
  const ViscousMode mode{.damping_ratio = 0.01, .start = 0.25};
  const ViscousMode above{
      .frequency = 400.0, .damping_ratio = 0.005, .amplitude = 1e-5, .start = 0.25};
  const std::vector<double> signal = with_noise(sampled({mode, above}, 2, kRate, 3.0), 1e-4, 1);
  const RingDown decay =
      ring_down(recording_of(signal, kAcceleration), "acc1", {.frequency = 50.0});
  EXPECT_EQ(decay.start_by, DecayStart::kBlow);
  ASSERT_TRUE(decay.blow.has_value());
  EXPECT_NEAR(*decay.blow, -0.25, 0.003);
  EXPECT_GE(decay.from, *decay.blow);
  // 1.5 periods of the line that was found: half a line of 5000 Hz/2¹⁵ beside 50 Hz makes 5e−5 s.
  EXPECT_NEAR(decay.start, *decay.blow + 1.5 / 50.0, 1e-4);
  for (std::size_t i = 0; i < decay.size(); ++i) {
    EXPECT_NEAR(decay.damping_ratio[i], mode.damping_ratio, 3.0 * decay.damping_ratio_std[i]);
  }
}

TEST(RingDown, BeginsWithTheRecordWhereNothingComesBefore) {
  const ViscousMode mode{.damping_ratio = 0.01};
  const RingDown decay =
      ring_down(with_noise(sampled({mode}, 2, kRate, 2.0), 1e-3, 1), kRate, kAcceleration);
  EXPECT_EQ(decay.start_by, DecayStart::kRecord);
  EXPECT_FALSE(decay.blow.has_value());
  EXPECT_EQ(decay.start, 0.0);
  EXPECT_NEAR(decay.damping_ratio.front(), mode.damping_ratio,
              4.0 * decay.damping_ratio_std.front());
}

TEST(RingDown, SaysThatABandLosesTheMode) {
  // The softening mode rises from 46.5 to 50.2 Hz: in that band the windows are too long to see
  // where it begins, and its edge is too near for the end.
  const JointedMode softening{.joint = Joint::four_parameter(2.0, 4e4, -0.5, 0.5),
                              .mass = 1.0,
                              .viscosity = 0.3,
                              .stiffness = 6e4,
                              .release = 1e-4};
  const std::vector<double> signal = softening.sampled(0, kRate, 6.0, 20);
  const RingDown free = ring_down(signal, kRate, kLength);
  EXPECT_FALSE(warns_of(free, "band_loses_mode"));
  const RingDown banded = ring_down(signal, kRate, kLength, {.band = {{42.0, 51.0}}});
  EXPECT_FALSE(banded.summary.converged());
  EXPECT_LT(1.5 * banded.time.back(), free.time.back());
  const auto hint = std::ranges::find(banded.warnings, "band_loses_mode", &Warning::code);
  ASSERT_NE(hint, banded.warnings.end());
  EXPECT_NE(hint->text.find("With the band"), std::string::npos) << hint->text;
}

TEST(RingDown, CountsWhatLeaksInAmongItsDeviations) {
  // A neighbour 8 Hz above, as strong and as lasting, at several phases.
  std::size_t covered = 0;
  std::size_t all = 0;
  for (const double phase : {0.0, 0.8, 1.6, 2.4}) {
    const ViscousMode mode{.damping_ratio = 0.004};
    const ViscousMode near{
        .frequency = 58.0, .damping_ratio = 0.004, .amplitude = 0.7e-4, .phase = phase};
    const std::vector<double> clean = sampled({mode, near}, 0, kRate, 4.0);
    const RingDown decay =
        ring_down(with_noise(clean, 1e-3, 5), kRate, kLength, {.frequency = 50.0});
    for (std::size_t i = 0; i < decay.size(); ++i) {
      const double off = std::abs(decay.damping_ratio[i] - mode.damping_ratio);
      if (off <= 2.0 * decay.damping_ratio_std[i]) ++covered;
      ++all;
    }
    EXPECT_TRUE(warns_of(decay, "other_peaks"));
  }
  EXPECT_GE(static_cast<double>(covered), 0.95 * static_cast<double>(all));
}

TEST(RingDown, SaysWhereTheFrequencyMoves) {
  const JointedMode softening{.joint = Joint::four_parameter(2.0, 4e4, -0.5, 0.5),
                              .mass = 1.0,
                              .viscosity = 0.3,
                              .stiffness = 6e4,
                              .release = 1e-4};
  EXPECT_TRUE(warns_of(ring_down(softening.sampled(2, kRate, 2.0, 20), kRate, kAcceleration),
                       "frequency_moves"));
  EXPECT_FALSE(warns_of(ring_down(sampled({ViscousMode{}}, 2, kRate, 2.0), kRate, kAcceleration),
                        "frequency_moves"));
}

/// A second sensor with `ratio` times the motion; to both a noise of their own, a share of the
/// motion.
Recording two_sensors(const std::vector<double>& motion, double ratio, double noise,
                      std::uint64_t seed = 1) {
  Recording recording = recording_of(with_noise(motion, noise, seed), kAcceleration);
  std::vector<double> other = motion;
  for (double& y : other) y *= ratio;
  recording.channels.push_back({"acc2", kAcceleration, with_noise(other, noise, seed + 1), {}, {}});
  return recording;
}

const std::vector<std::string> kBoth{"acc1", "acc2"};

TEST(RingDown, ReducesSeveralSensorsTogether) {
  const ViscousMode mode{.damping_ratio = 0.008};
  const Recording recording = two_sensors(sampled({mode}, 2, kRate, 2.0), -0.4, 0.01);
  const RingDown both = ring_down(recording, kBoth);
  ASSERT_EQ(both.sensors.size(), 2U);
  EXPECT_EQ(both.sensors[1].name, "acc2");
  EXPECT_NEAR(both.sensors[1].ratio, 0.4, 0.01);
  EXPECT_FALSE(warns_of(both, "shape_moves"));
  EXPECT_FALSE(warns_of(both, "sensors_differ"));
  for (std::size_t i = 0; i < both.size(); ++i) {
    const double a = mode.amplitude * std::exp(-mode.decay() * (both.time[i] + 0.5));
    EXPECT_NEAR(both.amplitude[i] / a, 1.0, 4.0 * both.amplitude_std[i] / a);
    EXPECT_NEAR(both.damping_ratio[i], mode.damping_ratio, 4.0 * both.damping_ratio_std[i]);
  }
}

TEST(RingDown, KnowsDampingBetterBySensorsThatAgree) {
  MICROSLIP_OF_RELEASE_ALONE();
  const ViscousMode mode{.damping_ratio = 0.008};
  const std::vector<double> motion = sampled({mode}, 2, kRate, 2.0);
  const std::uint64_t records = test::draws_of(10, 3);
  double deviations = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (std::uint64_t record = 0; record < records; ++record) {
    const Recording recording = two_sensors(motion, -0.4, 0.01, 2 * record + 2);
    const RingDown both = ring_down(recording, kBoth);
    const RingDown one = ring_down(recording, "acc1");
    EXPECT_FALSE(warns_of(both, "sensors_differ")) << record;
    EXPECT_FALSE(warns_of(both, "shape_moves")) << record;
    deviations += both.damping_ratio_std.front() / one.damping_ratio_std.front() /
                  static_cast<double>(records);
    for (std::size_t i = 0; i < both.size(); ++i) {
      const double off = both.damping_ratio[i] - mode.damping_ratio;
      squares += std::pow(off / both.damping_ratio_std[i], 2);
      count += 1.0;
    }
  }
  // Of two as good as each other 1/√2. In a single record it may be anything up to that of one: by
  // chance the two differ by more than their deviations, and s² counts it.
  EXPECT_NEAR(deviations, std::numbers::sqrt2 / 2.0, test::bound_of(0.1));
  // Some 10 × 5 independent values: their rms is known to 10 %.
  EXPECT_LT(std::sqrt(squares / count), test::bound_of(1.3));
  EXPECT_GT(std::sqrt(squares / count), test::least_of(1.0 / 1.5));
}

/// D/A² constant up to 0.1 of the first amplitude, above it growing: a kink that windows round off.
std::vector<double> decay_with_a_kink(double rate, double duration) {
  constexpr int kSteps = 20;  // of the midpoint rule, a sample
  const double omega = kTwoPi * 50.0;
  const auto damping = [](double a) { return a <= 0.1 ? 0.003 : 0.003 + 0.012 * (1.0 - 0.1 / a); };
  std::vector<double> signal(static_cast<std::size_t>(rate * duration));
  const double h = 1.0 / (rate * kSteps);
  double a = 1.0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] = a * std::cos(omega * static_cast<double>(i) / rate);
    for (int k = 0; k < kSteps; ++k) {
      const double middle = a - 0.5 * h * damping(a) * omega * a;
      a -= h * damping(middle) * omega * middle;
    }
  }
  return signal;
}

TEST(RingDown, KnowsWhatSensorsShareNoBetterByTheirNumber) {
  MICROSLIP_OF_RELEASE_ALONE();
  // Where a window rounds D(A) off, it does so at every sensor: six that see the same, with a noise
  // of 1e−5 each, are no more informative than one without noise.
  const std::vector<double> motion = decay_with_a_kink(kRate, 6.0);
  const RingDown one = ring_down(with_noise(motion, 1e-9, 1), kRate, kLength, {.from = 0.0});
  Recording recording = recording_of({}, kLength);
  recording.channels.clear();
  recording.axis.start = 0.0;
  std::vector<std::string> names;
  for (std::uint64_t k = 0; k < 6; ++k) {
    names.push_back("ldv" + std::to_string(k));
    recording.channels.push_back({names.back(), kLength, with_noise(motion, 1e-5, k + 1), {}, {}});
  }
  const RingDown six = ring_down(recording, names, {.from = 0.0});
  // By their own noise the two walks take slightly other windows: the means over the decay count.
  const auto mean_of = [](const std::vector<double>& deviation, const std::vector<double>& value) {
    double sum = 0.0;
    for (std::size_t i = 0; i < value.size(); ++i) sum += deviation[i] / value[i];
    return sum / static_cast<double>(value.size());
  };
  const auto over_one = [&](const auto deviation, const auto value) {
    return mean_of(six.*deviation, six.*value) / mean_of(one.*deviation, one.*value);
  };
  EXPECT_GE(over_one(&RingDown::damping_ratio_std, &RingDown::damping_ratio), 1.0);
  EXPECT_GE(over_one(&RingDown::loss_std, &RingDown::loss), 1.0);
  EXPECT_GE(over_one(&RingDown::frequency_std, &RingDown::frequency), 1.0);
  EXPECT_GE(over_one(&RingDown::amplitude_std, &RingDown::amplitude), 1.0);
  for (std::size_t i = 0; i < six.size(); ++i) {
    EXPECT_GT(six.loss_std[i], 0.0015 * six.loss[i]) << i;  // what first harmonics are off by
  }
}

TEST(RingDown, CountsABeatAmongTheDeviationsOfFrequency) {
  // A neighbour 10 % above, a hundredth of it, that lasts longer: the shortest windows, which the
  // decay's noise asks for, do not part the two.
  std::size_t frequencies = 0;
  std::size_t amplitudes = 0;
  std::size_t all = 0;
  for (const double phase : {0.0, 0.8, 1.6, 2.4}) {
    const ViscousMode mode{.damping_ratio = 0.008};
    const ViscousMode near{
        .frequency = 55.0, .damping_ratio = 0.0064, .amplitude = 1e-6, .phase = phase};
    const RingDown decay = ring_down(with_noise(sampled({mode, near}, 0, kRate, 2.0), 1e-4, 3),
                                     kRate, kLength, {.frequency = 50.0});
    for (std::size_t i = 0; i < decay.size(); ++i) {
      const double a = mode.amplitude * std::exp(-mode.decay() * decay.time[i]);
      const double f = mode.damped_omega() / kTwoPi;
      if (std::abs(decay.frequency[i] - f) <= 2.0 * decay.frequency_std[i]) ++frequencies;
      if (std::abs(decay.amplitude[i] - a) <= 2.0 * decay.amplitude_std[i]) ++amplitudes;
      ++all;
    }
  }
  EXPECT_GE(static_cast<double>(frequencies), 0.9 * static_cast<double>(all)) << all;
  EXPECT_GE(static_cast<double>(amplitudes), 0.8 * static_cast<double>(all)) << all;
}

/// Of the stronger of two modes: the worst error over the standard deviation.
double worst_off(const RingDown& decay, const ViscousMode& mode) {
  const double f = mode.damped_omega() / kTwoPi;
  const double z = mode.decay() / mode.damped_omega();
  double worst = 0.0;
  for (std::size_t i = 0; i < decay.size(); ++i) {
    const double a = mode.amplitude * std::exp(-mode.decay() * decay.time[i]);
    worst = std::max({worst, std::abs(decay.damping_ratio[i] - z) / decay.damping_ratio_std[i],
                      std::abs(decay.frequency[i] - f) / decay.frequency_std[i],
                      std::abs(decay.amplitude[i] - a) / decay.amplitude_std[i]});
  }
  return worst;
}

std::size_t count_flagged(const RingDown& decay, const std::string& code) {
  return static_cast<std::size_t>(std::ranges::count_if(decay.flags, [&](const std::string& flags) {
    return (" " + flags + " ").find(" " + code + " ") != std::string::npos;
  }));
}

TEST(RingDown, TellsOfAModeThatBeatsWithIt) {
  struct Case {
    double damping, apart, share, damping_of_other;
  };
  for (const Case& c : {Case{0.002, 0.002, 0.2, 0.0014}, Case{0.005, 0.005, 0.2, 0.005},
                        Case{0.005, 0.01, 0.05, 0.0075}, Case{0.005, 0.02, 0.5, 0.0035},
                        Case{0.01, 0.04, 0.2, 0.01}}) {
    for (const double noise : {1e-4, 3e-3}) {
      if (noise < 3e-3 && !test::in_studies()) continue;  // it hides most
      const ViscousMode mode{.damping_ratio = c.damping};
      const ViscousMode other{.frequency = 50.0 * (1.0 + c.apart),
                              .damping_ratio = c.damping_of_other,
                              .amplitude = c.share * 1e-4,
                              .phase = 1.1};
      const std::vector<double> signal =
          with_noise(sampled({mode, other}, 2, kRate, 6.0 / mode.decay()), noise, 3);
      const RingDown decay = ring_down(signal, kRate, kAcceleration);
      const auto beats = std::ranges::find(decay.warnings, "beats", &Warning::code);
      ASSERT_NE(beats, decay.warnings.end()) << c.damping << ", " << c.apart << ", " << noise;
      EXPECT_GT(3 * count_flagged(decay, "beats"), decay.size()) << c.apart << ", " << noise;
      EXPECT_LT(worst_off(decay, mode), 3.0) << c.apart << ", " << noise;
    }
  }
}

TEST(RingDown, TellsOfASteadyTone) {
  MICROSLIP_OF_RELEASE_ALONE();  // the next one has a tone too
  for (const double apart : {0.0, 0.003, 0.01}) {
    for (const double share : {0.003, 0.03}) {
      if ((apart == 0.003 || share == 0.03) && !test::in_studies()) continue;  // shown better
      const ViscousMode mode{.damping_ratio = 0.005};
      const ViscousMode tone{.frequency = 50.0 * (1.0 + apart),
                             .damping_ratio = 0.0,
                             .amplitude = share * 1e-4,
                             .phase = 1.1};
      const RingDown decay =
          ring_down(with_noise(sampled({mode, tone}, 2, kRate, 8.0 / mode.decay()), 1e-3, 3), kRate,
                    kAcceleration);
      const auto found = std::ranges::find(decay.warnings, "steady_tone", &Warning::code);
      ASSERT_NE(found, decay.warnings.end()) << apart << ", " << share;
      EXPECT_GE(count_flagged(decay, "steady_tone"), 1U);
      EXPECT_LT(worst_off(decay, mode), 3.0) << apart << ", " << share;
    }
  }
}

TEST(RingDown, TellsOfAModeThatHardlyDecaysFromATone) {
  // Both are over the whole decay the same; before the blow the tone alone is there.
  for (const bool steady : {true, false}) {
    const ViscousMode mode{.damping_ratio = 0.006, .start = 0.4};
    const ViscousMode other{.frequency = 50.3,
                            .damping_ratio = 0.0,
                            .amplitude = 1e-6,
                            .start = steady ? 0.0 : mode.start};
    const RingDown decay =
        ring_down(with_noise(sampled({mode, other}, 2, kRate, 4.5), 1e-4, 3), kRate, kAcceleration);
    EXPECT_EQ(decay.start_by, DecayStart::kBlow);
    EXPECT_TRUE(warns_of(decay, steady ? "steady_tone" : "beats")) << steady;
    EXPECT_FALSE(warns_of(decay, steady ? "beats" : "steady_tone")) << steady;
  }
}

TEST(RingDown, TakesNoJointForTwoModes) {
  for (const double release : {0.3e-4, 1e-4, 3e-4}) {
    if (release != 1e-4 && !test::in_studies()) continue;  // on either side of it
    JointedMode mode = jointed_mode();
    mode.release = release;
    const std::vector<double> clean = mode.sampled(2, kRate, 3.0, 5);
    for (const double noise : {0.0, 1e-4, 3e-3, 1e-2}) {
      const RingDown decay = ring_down(with_noise(clean, noise, 7), kRate, kAcceleration);
      EXPECT_FALSE(warns_of(decay, "beats")) << release << ", " << noise;
      EXPECT_FALSE(warns_of(decay, "steady_tone")) << release << ", " << noise;
    }
  }
}

TEST(RingDown, TakesNoNoiseForAnotherMode) {
  MICROSLIP_OF_RELEASE_ALONE();
  for (std::uint64_t seed = 1; seed <= test::draws_of(20, 3); ++seed) {
    for (const double noise : {1e-3, 2e-2}) {
      const ViscousMode mode{.damping_ratio = 0.006};
      const RingDown decay =
          ring_down(with_noise(sampled({mode}, 2, kRate, 3.0), noise, seed), kRate, kAcceleration);
      EXPECT_FALSE(warns_of(decay, "beats")) << noise << ", seed " << seed;
      EXPECT_FALSE(warns_of(decay, "steady_tone")) << noise << ", seed " << seed;
    }
  }
}

TEST(RingDown, SaysWhereTheShapeMoves) {
  const ViscousMode mode{.damping_ratio = 0.008};
  Recording recording = two_sensors(sampled({mode}, 2, kRate, 2.0), 0.4, 1e-4);
  std::vector<double>& other = recording.channels[1].values;
  for (std::size_t i = 0; i < other.size(); ++i) {
    other[i] *= 1.0 + 0.1 * std::exp(-6.0 * static_cast<double>(i) / kRate);
  }
  const RingDown both = ring_down(recording, kBoth);
  EXPECT_TRUE(warns_of(both, "shape_moves"));
  EXPECT_TRUE(warns_of(both, "sensors_differ"));
  EXPECT_NE(both.flags.front().find("shape_moves"), std::string::npos);
  // The first sensor is right; the disagreement is in the deviation of both.
  EXPECT_NEAR(both.damping_ratio.front(), mode.damping_ratio, 2.0 * both.damping_ratio_std.front());
}

/// Two modes at two sensors: `first` and `second` are the shares of the second mode.
Recording two_modes(double first, double second) {
  const ViscousMode low{.frequency = 42.0, .damping_ratio = 0.004};
  const ViscousMode high{.frequency = 50.0, .damping_ratio = 0.004};
  const auto seen = [&](double share, std::uint64_t seed) {
    std::vector<double> sum = sampled({low}, 2, kRate, 4.0);
    const std::vector<double> more = sampled({high}, 2, kRate, 4.0);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = (1.0 - share) * sum[i] + share * more[i];
    }
    return with_noise(sum, 1e-4, seed);
  };
  Recording recording = recording_of(seen(first, 1), kAcceleration);
  recording.channels.push_back({"acc2", kAcceleration, seen(second, 2), {}, {}});
  return recording;
}

TEST(RingDown, FollowsOneModeAtSensorsThatShowTwo) {
  const RingDown both = ring_down(two_modes(0.05, 0.95), kBoth, {.frequency = 50.0});
  EXPECT_EQ(both.sensors.size(), 2U);
  for (const double f : both.frequency) EXPECT_NEAR(f, 50.0, 0.05);
  const RingDown free = ring_down(two_modes(0.05, 0.6), kBoth);
  EXPECT_EQ(free.sensors.size(), 2U);
  for (const double f : free.frequency) EXPECT_NEAR(f, 42.0, 0.05);
}

TEST(RingDown, LeavesOutASensorOfAnotherMode) {
  const Recording recording = two_modes(0.0, 1.0);
  const RingDown one = ring_down(recording, kBoth);
  ASSERT_EQ(one.sensors.size(), 1U);
  EXPECT_TRUE(warns_of(one, "sensor_left_out"));
  for (const double f : one.frequency) EXPECT_NEAR(f, 42.0, 0.01);
}

TEST(RingDown, SaysWhereFrequenciesOfSensorsDiffer) {
  // 0.4 % apart: one mode by its frequency, but not within what either is known to.
  const ViscousMode mode{.damping_ratio = 0.008};
  const ViscousMode off{.frequency = 50.2, .damping_ratio = 0.008};
  Recording recording =
      recording_of(with_noise(sampled({mode}, 2, kRate, 2.0), 1e-4, 1), kAcceleration);
  recording.channels.push_back(
      {"acc2", kAcceleration, with_noise(sampled({off}, 2, kRate, 2.0), 1e-4, 2), {}, {}});
  const RingDown both = ring_down(recording, kBoth);
  const auto differ = std::ranges::find(both.warnings, "sensors_differ", &Warning::code);
  ASSERT_NE(differ, both.warnings.end());
  EXPECT_NE(differ->text.find("frequency"), std::string::npos) << differ->text;
  for (std::size_t i = 0; i < both.size(); ++i) {
    EXPECT_NEAR(both.frequency[i], 50.1, 0.11);
    EXPECT_NEAR(both.frequency[i], 50.0, 2.0 * both.frequency_std[i]);
  }
}

TEST(RingDown, RefusesAFrequencyWhereNoPeakIs) {
  const std::vector<double> signal = with_noise(
      sampled({ViscousMode{.frequency = 42.0, .damping_ratio = 0.004}}, 0, kRate, 4.0), 1e-5, 1);
  try {
    (void)ring_down(signal, kRate, kLength, {.frequency = 46.9});
    ADD_FAILURE() << "42 Hz passes for what is near 46.9 Hz";
  } catch (const InputError& error) {
    for (const char* part : {"42.21 to 51.59 Hz", "peak", "at 42"}) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  EXPECT_NEAR(ring_down(signal, kRate, kLength, {.frequency = 45.0}).frequency.front(), 42.0, 0.01);
}

TEST(RingDown, TakesThePeakThatIsNearest) {
  // 9 % above the frequency that is given, and higher than the one that is meant.
  const ViscousMode mode{.damping_ratio = 0.004};
  const ViscousMode higher{.frequency = 54.5, .damping_ratio = 0.004, .amplitude = 1.5e-4};
  const RingDown decay = ring_down(with_noise(sampled({mode, higher}, 0, kRate, 6.0), 1e-4, 1),
                                   kRate, kLength, {.frequency = 50.0});
  for (const double f : decay.frequency) EXPECT_NEAR(f, 50.0, 0.5);
}

TEST(RingDown, RefusesSensorsThatAreMissingOrTwice) {
  const Recording recording = two_sensors(sampled({ViscousMode{}}, 2, kRate, 2.0), 0.4, 0.01);
  const auto channels = [&](std::vector<std::string> names) {
    try {
      (void)ring_down(recording, names);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(channels({"acc1", "acc1"}).find("'acc1' twice"), std::string::npos);
  EXPECT_NE(channels({"acc1", "ldv"}).find("'ldv'"), std::string::npos);
  EXPECT_NE(channels({}).find("missing"), std::string::npos);
}

TEST(RingDown, BeginsAfterAPlateau) {
  ViscousMode mode{.damping_ratio = 0.006, .start = 1.0};
  std::vector<double> signal = sampled({mode}, 0, kRate, 4.0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(mode.start * kRate); ++i) {
    const double t = static_cast<double>(i) / kRate - mode.start;
    signal[i] = mode.amplitude * std::cos(mode.damped_omega() * t + mode.phase);
  }
  const RingDown decay = ring_down(with_noise(signal, 1e-3, 1), kRate, kLength);
  EXPECT_GT(decay.from, mode.start);
  EXPECT_LT(decay.from, mode.start + 8.0 / mode.frequency);
  EXPECT_NEAR(decay.damping_ratio.front() / mode.damping_ratio, 1.0, 0.02);
}

TEST(RingDown, EndsBeforeTheNoise) {
  const ViscousMode mode{.damping_ratio = 0.02};
  const std::vector<double> clean = sampled({mode}, 0, kRate, 10.0);  // e^−63
  const RingDown decay = ring_down(with_noise(clean, 0.01, 3), kRate, kLength);
  EXPECT_TRUE(decay.summary.converged());
  EXPECT_LT(decay.to, 2.0);
  EXPECT_NEAR(decay.noise_std / (0.01 * clean.front() / std::cos(mode.phase)), 1.0, 0.2);
  for (std::size_t i = 0; i < decay.size(); ++i) {
    EXPECT_LT(decay.damping_ratio_std[i], 0.1 * decay.damping_ratio[i]);
    EXPECT_NEAR(decay.damping_ratio[i], mode.damping_ratio, 4.0 * decay.damping_ratio_std[i]);
  }
}

TEST(RingDown, EndsAtASecondImpact) {
  const ViscousMode mode{.damping_ratio = 0.01};
  ViscousMode second = mode;
  second.start = 1.0;
  const RingDown decay = ring_down(with_noise(sampled({mode, second}, 0, kRate, 3.0), 1e-3, 1),
                                   kRate, kLength, {.to = 2.0});
  // The larger one is the second: the first is not free decay up to it.
  EXPECT_GT(decay.from, 1.0);
  second.amplitude *= 0.5;
  const RingDown first =
      ring_down(with_noise(sampled({mode, second}, 0, kRate, 3.0), 1e-3, 1), kRate, kLength);
  EXPECT_LT(first.time.back(), 1.0);
  EXPECT_FALSE(first.summary.converged());
  EXPECT_TRUE(warns_of(first, "amplitude_rises") || warns_of(first, "mode_lost"));
}

TEST(RingDown, TakesMotionAndTimeFromTheRecording) {
  const ViscousMode mode;
  const Recording recording = recording_of(sampled({mode}, 1, kRate, 2.0), kVelocity);
  const RingDown decay = ring_down(recording, "acc1", {.from = 0.0});
  EXPECT_EQ(decay.measured, kVelocity);
  EXPECT_NEAR(decay.from, 0.0, 1.0 / kRate);
  const double a = mode.amplitude * std::exp(-mode.decay() * (decay.time.front() + 0.5));
  EXPECT_NEAR(decay.amplitude.front() / a, 1.0, 1e-6);
}

void expect_refused(const std::function<void()>& call, const std::vector<std::string>& parts) {
  try {
    call();
    ADD_FAILURE() << "not refused: " << parts.front();
  } catch (const InputError& error) {
    for (const std::string& part : parts) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

void expect_signal_refused(const std::vector<double>& signal, const std::vector<std::string>& parts,
                           const RingDownOptions& options = {}) {
  expect_refused([&] { (void)ring_down(signal, kRate, kLength, options); }, parts);
}

TEST(RingDown, RefusesWhatIsNoDecay) {
  const ViscousMode mode;
  const std::vector<double> good = sampled({mode}, 0, kRate, 2.0);
  expect_signal_refused({}, {"too short"});
  expect_signal_refused(std::vector<double>(good.begin(), good.begin() + 500), {"too short"});
  expect_signal_refused(std::vector<double>(5000, 0.0), {"no decay found"});
  expect_signal_refused(with_noise(std::vector<double>(5000, 1.0), 1.0, 7), {"no decay found"});
  // Constant or growing to the end of the record: nothing is left behind the largest amplitude.
  expect_signal_refused(sampled({{.damping_ratio = 0.0}}, 0, kRate, 2.0),
                        {"free decay", "too short"});
  expect_signal_refused(sampled({{.damping_ratio = -0.01}}, 0, kRate, 2.0),
                        {"free decay", "too short"});
  expect_signal_refused(with_noise(good, 2.0, 5), {"no decay found"}, {.frequency = 50.0});

  std::vector<double> clipped = good;
  for (double& y : clipped) y = std::clamp(y, -5e-5, 5e-5);
  expect_signal_refused(clipped, {"clipped"});
  std::vector<double> broken = good;
  broken[7] = std::numeric_limits<double>::quiet_NaN();
  expect_signal_refused(broken, {"sample 8", "must be finite"});
}

std::vector<double> clipped_at(std::vector<double> signal, double limit) {
  for (double& y : signal) y = std::clamp(y, -limit, limit);
  return signal;
}

// An amplifier at its limit, its noise on top: no two samples are alike, and damping is too small
// by 18 % and more as long as the amplitude is above the limit. Such windows are named, and no
// others. (Four samples a period, at 0 and at the limit, are those of a sine.)
TEST(RingDown, NamesWindowsThatAreClippedBeneathNoise) {
  const ViscousMode mode{.damping_ratio = 0.004, .phase = 0.0};
  for (const double rate : {5000.0, 233.0, 187.0}) {
    for (const double limit : {0.8, 0.6, 0.4, 0.2}) {
      const std::vector<double> signal =
          clipped_at(sampled({mode}, 0, rate, 8.0), limit * mode.amplitude);
      const RingDown decay = ring_down(with_noise(signal, 1e-4, 5), rate, kLength);
      // Above 0.7 one window alone is, in part, and few samples of it.
      EXPECT_TRUE(warns_of(decay, "clipped") || (limit > 0.7 && rate < 200.0)) << limit << rate;
      const double within = -std::log(limit) / mode.decay();  // from when on
      for (std::size_t i = 0; i < decay.size(); ++i) {
        const bool named = decay.flags[i].find("clipped") != std::string::npos;
        const double error = decay.damping_ratio[i] / mode.damping_ratio - 1.0;
        const double noise = decay.damping_ratio_std[i] / mode.damping_ratio;
        EXPECT_TRUE(named || std::abs(error) < 0.02 + 5.0 * noise)
            << error << " at " << decay.time[i];
        EXPECT_FALSE(named && decay.time[i] - 0.3 * decay.window[i] > within)
            << limit << ", " << decay.time[i];
      }
    }
  }
}

// What is within the range is not called clipped: few samples a period beneath much noise, of which
// the range of one window may lack 3 % by chance; a mode beside another; a joint.
TEST(RingDown, CallsNoDecayWithinTheRangeClipped) {
  for (const double damping : {0.004, 0.02}) {
    for (const double rate : {120.0, 215.0, 430.0}) {
      for (std::uint64_t seed = 1; seed <= test::draws_of(20, 4); ++seed) {
        const std::vector<double> signal =
            sampled({{.damping_ratio = damping, .phase = 0.7 * static_cast<double>(seed)}}, 0, rate,
                    0.03 / damping);
        const RingDown decay =
            ring_down(with_noise(signal, 0.02, seed), rate, kLength, {.frequency = 50.0});
        EXPECT_FALSE(warns_of(decay, "clipped")) << damping << " at " << rate << ", " << seed;
      }
    }
  }
  for (const double beside : {51.0, 53.0, 150.0}) {
    const std::vector<double> two =
        sampled({{.damping_ratio = 0.004},
                 {.frequency = beside, .damping_ratio = 0.004, .amplitude = 3e-5}},
                0, kRate, 4.0);
    const RingDown decay = ring_down(with_noise(two, 1e-4, 3), kRate, kLength, {.frequency = 50.0});
    EXPECT_FALSE(warns_of(decay, "clipped")) << beside;
  }
}

// Of several sensors one at its limit is named, whichever leads.
TEST(RingDown, NamesTheSensorThatIsClipped) {
  const ViscousMode mode{.damping_ratio = 0.004, .phase = 0.0};
  const std::vector<double> good = sampled({mode}, 0, kRate, 4.0);
  Recording recording = recording_of(with_noise(good, 1e-4, 1), kLength);
  Channel second = recording.channels.front();
  second.name = "second";
  second.values = with_noise(clipped_at(good, 0.5 * mode.amplitude), 1e-4, 2);
  recording.channels.push_back(second);
  const std::vector<std::string> both{recording.channels.front().name, "second"};
  const RingDown decay = ring_down(recording, both);
  const auto warning = std::ranges::find(decay.warnings, "clipped", &Warning::code);
  ASSERT_NE(warning, decay.warnings.end());
  EXPECT_NE(decay.flags.front().find("clipped"), std::string::npos);
  EXPECT_EQ(decay.flags.back().find("clipped"), std::string::npos);
}

// Above 0.45 of the sampling rate a mode and its mirror image, as far above half of the rate as the
// mode is below, are less than six lines of the shortest window apart.
TEST(RingDown, RefusesAModeNearHalfOfTheSamplingRate) {
  constexpr double kCoarse = 100.0;  // Hz
  for (const double frequency : {46.0, 48.5, 52.0}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const ViscousMode mode{.frequency = frequency, .phase = static_cast<double>(seed)};
      const std::vector<double> signal = with_noise(sampled({mode}, 2, kCoarse, 4.0), 0.01, seed);
      expect_refused([&] { (void)ring_down(signal, kCoarse, kAcceleration); },
                     {"at most 45 Hz", "sampling rate of 100 Hz", "Record with"});
      expect_refused([&] { (void)ring_down(signal, kCoarse, kAcceleration, {.frequency = 44.5}); },
                     {"45 Hz", "Record with"});
    }
  }
}

// Up to there levels lie below half of the sampling rate and have a standard deviation, also where
// no line beside the mode is left to take the noise from.
TEST(RingDown, KnowsItsErrorsWithFewSamplesAPeriod) {
  constexpr double kCoarse = 100.0;  // Hz
  std::size_t levels = 0;
  for (const double frequency : {38.0, 43.0, 44.5}) {
    for (const double damping : {0.01, 0.03}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const ViscousMode mode{
            .frequency = frequency, .damping_ratio = damping, .phase = static_cast<double>(seed)};
        const RingDown decay = ring_down(with_noise(sampled({mode}, 2, kCoarse, 3.0), 0.01, seed),
                                         kCoarse, kAcceleration);
        for (std::size_t i = 0; i < decay.size(); ++i) {
          EXPECT_LT(decay.frequency[i], 0.5 * kCoarse);
          EXPECT_GT(decay.damping_ratio_std[i], 1e-4 * damping);
          // Noise alone exceeds five standard deviations once in a million.
          EXPECT_NEAR(decay.damping_ratio[i], damping, 5.0 * decay.damping_ratio_std[i])
              << frequency << " Hz, " << damping << ", " << seed;
          ++levels;
        }
      }
    }
  }
  EXPECT_GE(levels, 18U);
}

TEST(RingDown, RefusesOptionsOutOfRange) {
  const std::vector<double> good = sampled({ViscousMode{}}, 0, kRate, 2.0);
  expect_signal_refused(good, {"frequency", "above 0"}, {.frequency = -1.0});
  expect_signal_refused(good, {"frequency", "at most 2250"}, {.frequency = 2400.0});
  expect_signal_refused(good, {"band", "must rise"}, {.band = {{60.0, 40.0}}});
  expect_signal_refused(good, {"band", "half of the sampling rate"}, {.band = {{2600.0, 3000.0}}});
  expect_signal_refused(good, {"record", "too short"}, {.band = {{1.0, 2.0}}});
  expect_signal_refused(good, {"band", "not at its edge"}, {.band = {{60.0, 90.0}}});
  expect_signal_refused(good, {"frequency", "inside of the band"},
                        {.frequency = 80.0, .band = {{40.0, 60.0}}});
  expect_signal_refused(good, {"range", "must rise"}, {.from = 1.0, .to = 0.5});
  expect_signal_refused(good, {"range", "overlap the record"}, {.from = 3.0});
  expect_signal_refused(good, {"least_periods"}, {.least_periods = 1.0});
  expect_signal_refused(good, {"largest_fall"}, {.largest_fall = 0.0});
  expect_signal_refused(good, {"wanted_std"}, {.wanted_std = 0.0});
  expect_signal_refused(good, {"largest_std"}, {.largest_std = 2.0});
  expect_refused([&] { (void)ring_down(good, 0.0, kLength); }, {"sampling rate"});
  expect_refused([&] { (void)ring_down(good, kRate, kForce); }, {"force", "must be displacement"});
}

TEST(RingDown, NamesTheChannelAtFault) {
  const Recording recording = recording_of(sampled({ViscousMode{}}, 1, kRate, 2.0), kVelocity);
  expect_refused([&] { (void)ring_down(recording, "ldv"); }, {"hit.csv", "'ldv'", "'acc1'"});
  Recording force = recording;
  force.channels[0].dimension = kForce;
  expect_refused([&] { (void)ring_down(force, "acc1"); }, {"hit.csv", "'acc1'", "force"});
  Recording silent = recording;
  std::ranges::fill(silent.channels[0].values, 0.0);
  expect_refused([&] { (void)ring_down(silent, "acc1"); }, {"hit.csv", "'acc1'", "no decay"});
}

}  // namespace
}  // namespace microslip::ring_down_test
