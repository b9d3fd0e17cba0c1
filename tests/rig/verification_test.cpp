// SPDX-License-Identifier: MIT
#include "microslip/rig/verification/verification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/rig/setup/stick_state.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

namespace microslip::verification_test {
namespace {

using test::message_of;
using testing::reference_joint;
using testing::reference_recording;
using testing::reference_rig;
using testing::SolvedRig;
using testing::unseen_rig;

constexpr int kRecordings = 6;
constexpr int kNearFifthOfG = 2;  // level_2: 2 m/s² at the exciter
constexpr int kNearOneAndHalfG = 4;

/// Error of the harmonics of a channel, without its noise.
double model_error(const ChannelComparison& channel) {
  return std::sqrt(
      std::max(channel.nrmse * channel.nrmse - channel.noise_share * channel.noise_share, 0.0));
}

const ChannelComparison& channel(const Verification& record, const std::string& name) {
  return *std::ranges::find(record.channels, name, &ChannelComparison::name);
}

Verification verified(const Joint& joint, int level, VerificationOptions options = {}) {
  return Verifier(reference_rig(), joint, std::move(options)).verify(reference_recording(level));
}

// The recordings are of another program, so the true joint leaves their noise, but for what the
// noise does to the frequency and the level that are given to the model: the standard error of a
// harmonic over 28 to 70 cycles is 1/30 of the noise of a sample, and the force, near resonance,
// amplifies it.
TEST(Verification, TheTrueJointLeavesTheNoise) {
  for (int level = 1; level <= kRecordings; ++level) {
    SCOPED_TRACE(level);
    const Verification record = verified(reference_joint(), level);
    ASSERT_TRUE(record.summary.converged()) << record.summary.full();
    ASSERT_EQ(record.channels.size(), 5U);
    for (const ChannelComparison& channel : record.channels) {
      SCOPED_TRACE(channel.name);
      EXPECT_GE(channel.nrmse, channel.noise_share);
      EXPECT_LE(channel.nrmse, 1.02 * channel.noise_share + 2.5e-4);
    }
  }
}

TEST(Verification, TheLevelOfTheTrueJointIsThatOfTheRecord) {
  for (int level = 1; level <= kRecordings; ++level) {
    SCOPED_TRACE(level);
    const Verification record = verified(reference_joint(), level);
    const PredictedLevel& predicted = record.predicted;
    EXPECT_NEAR(predicted.amplitude / record.recorded.amplitude.value, 1.0, 1e-3);
    // The noise of the force, 2 mN per sample, is 0.06 mN in a harmonic, 0.3 % of the lowest level.
    EXPECT_NEAR(predicted.input_energy / record.recorded.input_energy.value, 1.0,
                3.0 * record.recorded.input_energy.std / predicted.input_energy + 1e-4);
    EXPECT_NEAR(predicted.dissipation + predicted.linear_dissipation, predicted.input_energy,
                1e-9 * predicted.input_energy);
    // The half-width of the resonance is 0.08 Hz and more.
    ASSERT_TRUE(predicted.frequency_offset);
    EXPECT_LE(std::abs(*predicted.frequency_offset), 5e-4);
  }
}

// A typical verification: a joint from 90 levels with 1 % noise, none of them from the records.
TEST(Verification, AnIdentifiedJointPredictsWithinTwoPercent) {
  for (const std::uint64_t draw : {1, 2, 3}) {
    const Joint joint =
        identify(testing::noisy_levels(reference_joint(), draw), testing::kStiffness).joint;
    for (const int level : {kNearFifthOfG, kNearOneAndHalfG}) {
      SCOPED_TRACE(level);
      const Verification record = verified(joint, level);
      for (const ChannelComparison& channel : record.channels) {
        SCOPED_TRACE(channel.name);
        if (channel.name != "force") {
          EXPECT_LE(channel.nrmse, 0.005);
        }
        EXPECT_LE(model_error(channel), 0.02);
      }
    }
  }
}

bool warns(const Verification& record, std::string_view code) {
  return std::ranges::any_of(record.warnings, [&](const Warning& w) { return w.code == code; });
}

TEST(Verification, AWrongJointIsSeenAndItsErrorNamed) {
  const Joint truth = reference_joint();
  const Joint soft(0.9 * truth.stiffness(), truth.density());
  for (const int level : {kNearFifthOfG, kNearOneAndHalfG}) {
    SCOPED_TRACE(level);
    const Verification right = verified(truth, level);
    const Verification record = verified(soft, level);
    EXPECT_EQ(record.worst().name, "force");
    EXPECT_GE(record.worst().nrmse, 0.5);
    EXPECT_GE(model_error(channel(record, "acc3")), 10.0 * model_error(channel(right, "acc3")));
    // The resonance of the softer joint is lower, by what natural_frequency() says of the stuck
    // one.
    const StickState state = stick_state(reference_rig(), 7);
    const double stuck =
        natural_frequency(state, 0.1 * truth.stiffness()) - natural_frequency(state, 0.0);
    ASSERT_TRUE(record.predicted.frequency_offset);
    EXPECT_LE(*record.predicted.frequency_offset, 0.6 * stuck);
    EXPECT_GE(*record.predicted.frequency_offset, 1.05 * stuck);
    EXPECT_TRUE(warns(record, "resonance_off"));
    EXPECT_TRUE(warns(record, "force_off"));
    EXPECT_TRUE(right.warnings.empty()) << right.warnings.front().text;
  }
}

/// All slip forces times a factor: less slips.
TEST(Verification, AScaledDensityIsSeenInTheEnergy) {
  const std::vector<double> force{0, 4, 8, 14, 20, 28, 36, 44, 52, 60, 75};
  std::vector<double> scaled;
  std::vector<double> density;
  for (const double f : force) {
    scaled.push_back(1.25 * f);
    density.push_back(reference_joint().density().density(f) / 1.25);
  }
  const Joint joint(testing::kStiffness, SlipDensity({PiecewiseLinearPart{scaled, density}}));
  const Verification record = verified(joint, kNearOneAndHalfG);
  // D of the joint, 70 % of the input here, falls by a fifth or more.
  EXPECT_LE(record.predicted.input_energy, 0.9 * record.recorded.input_energy.value);
  EXPECT_GE(channel(record, "force").nrmse, 0.1);
}

// Solved by another program with 9 harmonics, for a rig that nothing was tuned to. The noise, a
// hundredth of that of a test, is left in the frequency and the level, and the force amplifies it.
TEST(Verification, OfAnUnseenRig) {
  const SolvedRig solved(MICROSLIP_TEST_DATA "/unseen_rig.csv");
  VerificationOptions options;
  options.reduction.fit.order = 9;
  const Verifier verifier(unseen_rig(), testing::unseen_joint(), options);
  const testing::Sampling quiet{
      .force_noise = 2e-5, .acceleration_noise = 5e-5, .vibrometer_noise = 2e-10};
  for (std::size_t level = 0; level < solved.size(); ++level) {
    SCOPED_TRACE(level);
    const Verification record = verifier.verify(solved.record(level, quiet, 7));
    ASSERT_TRUE(record.summary.converged()) << record.summary.full();
    for (const ChannelComparison& channel : record.channels) {
      SCOPED_TRACE(channel.name);
      EXPECT_LE(model_error(channel), channel.name == "force" ? 4e-4 : 2e-5);
    }
  }
}

TEST(Verification, FrequencyLevelAndPhaseAreThoseOfTheRecord) {
  const Verification record = verified(reference_joint(), kNearOneAndHalfG);
  const ChannelComparison& drive_point = channel(record, "acc1");
  EXPECT_EQ(drive_point.predicted.omega, drive_point.recorded.omega);
  EXPECT_NEAR(std::abs(drive_point.predicted.c(1) / drive_point.recorded.c(1) - 1.0), 0.0, 1e-10);
  EXPECT_NEAR(record.phase, std::arg(drive_point.recorded.c(1)), 1e-12);
  EXPECT_EQ(drive_point.recorded.order(), 10U);
  EXPECT_EQ(drive_point.predicted.order(), 10U);
}

// One mode and a joint that never slips: a/f = −ω² φ²/(ω_0²(1 + iη) − ω²) in closed form, and half
// of η more damping is half of the force more at resonance.
TEST(Verification, OfARigGivenByModes) {
  constexpr double kShape = 0.7;
  constexpr double kLoss = 0.01;
  const auto rig_of = [](double loss) {
    Rig rig;
    rig.structure = RigModes{{80.0}, {kShape}, {kShape}};
    rig.loss_factor = {loss};
    rig.excitation = {.position = 0.0, .shape = {}, .channel = "force"};
    rig.accelerometers = {{0.0, {kShape}, "acc"}};
    return rig;
  };
  const double omega = 2.0 * std::numbers::pi * 80.0;
  const std::complex<double> gain =
      -omega * omega * kShape * kShape /
      std::complex<double>(0.0, kLoss * omega * omega);  // at resonance
  Recording recording;
  recording.source = "sine";
  recording.axis.step = 1.0 / 4096.0;
  recording.channels = {{"force", kForce, {}, {}, {}}, {"acc", kAcceleration, {}, {}, {}}};
  for (std::size_t i = 0; i < 2048; ++i) {
    const std::complex<double> turn = std::polar(1.0, omega * recording.axis.at(i) + 0.3);
    recording.channels[0].values.push_back(turn.real());
    recording.channels[1].values.push_back((gain * turn).real());
  }
  const Joint stuck(1e5, SlipDensity({AtomsPart{{1e9}, {1.0}}}));
  const Verification right = Verifier(rig_of(kLoss), stuck).verify(recording);
  ASSERT_TRUE(right.summary.converged()) << right.summary.full();
  ASSERT_EQ(right.channels.size(), 2U);
  EXPECT_EQ(right.drive_point, 1U);
  EXPECT_LE(right.worst().nrmse, 1e-6);  // the fitted frequency, amplified by 1/η
  EXPECT_NEAR(*right.predicted.frequency_offset, 0.0, 1e-6);
  const Verification lossy = Verifier(rig_of(1.5 * kLoss), stuck).verify(recording);
  EXPECT_NEAR(channel(lossy, "force").nrmse, 0.5, 1e-6);
  EXPECT_NEAR(lossy.predicted.input_energy / lossy.recorded.input_energy.value, 1.5, 1e-6);
  EXPECT_NEAR(*lossy.predicted.frequency_offset, 0.0, 1e-6);
}

TEST(Verification, WithoutAnAccelerometerAtTheExciter) {
  Rig rig = reference_rig();
  rig.accelerometers.erase(rig.accelerometers.begin());
  const Verifier verifier(rig, reference_joint());
  for (int level = 2; level <= kRecordings; ++level) {
    SCOPED_TRACE(level);
    const Verification record = verifier.verify(reference_recording(level));
    ASSERT_EQ(record.channels.size(), 4U);
    // The level comes from the observed motion, which the noise of two accelerometers and the force
    // moves.
    for (const ChannelComparison& channel : record.channels) {
      SCOPED_TRACE(channel.name);
      EXPECT_LE(model_error(channel), channel.name == "force" ? 0.01 : 1e-3);
    }
  }
}

// Without the rotation, u is what the axial compliance c leaves: −c F_joint and, in the even
// harmonics, the shortening.
TEST(Verification, AnAxialVibrometerSeesTheCompliance) {
  Rig rig = reference_rig();
  rig.vibrometer->measures = RigVibrometer::Measures::kAxial;
  const Verification record =
      Verifier(rig, reference_joint()).verify(reference_recording(kNearFifthOfG));
  const double compliance = rig.beam()->length / (rig.beam()->area() * rig.beam()->youngs_modulus);
  // At this level the joint has lost 3 % of its stiffness.
  EXPECT_NEAR(std::abs(channel(record, "ldv").predicted.c(1)),
              compliance * testing::kStiffness * record.predicted.amplitude,
              0.05 * compliance * testing::kStiffness * record.predicted.amplitude);
}

TEST(Verification, HarmonicsOfTheForceAreThoseRecordedOrNone) {
  constexpr double kThird = 0.02;
  Recording recording = reference_recording(kNearOneAndHalfG);
  const Verifier verifier(reference_rig(), reference_joint());
  const FourierSeries force = channel(verifier.verify(recording), "force").recorded;
  const std::complex<double> third =
      kThird * std::pow(force.c(1), 3) / std::norm(force.c(1));  // in phase with the first
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double angle = 3.0 * force.omega * recording.axis.at(i);
    recording.channels[0].values[i] += (third * std::polar(1.0, angle)).real();
  }
  const FourierSeries predicted = channel(verifier.verify(recording), "force").predicted;
  EXPECT_NEAR(std::abs(predicted.c(3) / predicted.c(1)), kThird, 1e-3 * kThird);
  EXPECT_EQ(predicted.c(2), 0.0);  // noise is no harmonic
  VerificationOptions options;
  options.sine = true;
  const FourierSeries sine =
      channel(Verifier(reference_rig(), reference_joint(), options).verify(recording), "force")
          .predicted;
  EXPECT_EQ(sine.c(3), 0.0);
  EXPECT_GT(std::abs(sine.c(1)), 0.0);
}

TEST(Verification, KeepsAFewCycles) {
  VerificationOptions options;
  options.history_cycles = 3.0;
  const Verification record = verified(reference_joint(), kNearOneAndHalfG, options);
  const Recording recording = reference_recording(kNearOneAndHalfG);
  const double cycles = 3.0 * recording.sampling_rate() / record.recorded.frequency;
  EXPECT_NEAR(static_cast<double>(record.history.size()), cycles, 1.0);
  for (const ChannelComparison& channel : record.channels) {
    ASSERT_EQ(channel.recorded_history.size(), record.history.size());
    ASSERT_EQ(channel.predicted_history.size(), record.history.size());
  }
  const auto first =
      static_cast<std::size_t>(std::llround(record.history.front() / recording.axis.step));
  const ChannelComparison& drive_point = channel(record, "acc1");
  EXPECT_EQ(drive_point.recorded_history.front(), recording.channel("acc1").values[first]);
  EXPECT_LT(record.history.front(), 1.01 / record.recorded.frequency);
  // The first sample after the largest value of the first harmonic, 0.085 rad at most; the third
  // has 0.1 m/s².
  EXPECT_GE(drive_point.predicted_history.front(), 14.0 * std::cos(0.085) - 0.1);
  options.history_cycles = 0.0;
  EXPECT_LE(verified(reference_joint(), kNearOneAndHalfG, options).history.size(), 1U);
}

TEST(Verification, WarnsBeyondTheIdentification) {
  VerificationOptions options;
  options.covered_to = testing::kStiffness * 1.0e-4;
  const auto warnings = [&](int level) {
    return verified(reference_joint(), level, options).warnings;
  };
  EXPECT_TRUE(warnings(3).empty());   // 44 µm
  EXPECT_EQ(warnings(5).size(), 1U);  // 194 µm
  EXPECT_EQ(warnings(5).front().code, "beyond_identification");
  EXPECT_NE(warnings(5).front().text.find("1.94 times the 100 µm"), std::string::npos)
      << warnings(5).front().text;
  options.covered_to = {};
  EXPECT_TRUE(warnings(6).empty());
}

TEST(Verification, NotConvergingIsAStatus) {
  VerificationOptions options;
  options.balance.max_iterations = 2;
  const Verification record = verified(reference_joint(), 6, options);
  EXPECT_FALSE(record.summary.converged());
  EXPECT_EQ(record.channels.size(), 5U);
  for (const ChannelComparison& channel : record.channels) {
    EXPECT_TRUE(std::isfinite(channel.nrmse));
  }
}

TEST(Verification, RefusesOptionsOutOfRange) {
  const auto message = [](VerificationOptions options) {
    return message_of<InputError>(
        [&] { return Verifier(reference_rig(), reference_joint(), std::move(options)); });
  };
  VerificationOptions options;
  options.covered_to = 0.0;
  EXPECT_NE(message(options).find("covered_to"), std::string::npos);
  options = {};
  options.history_cycles = -1.0;
  EXPECT_NE(message(options).find("history_cycles"), std::string::npos);
  options = {};
  options.balance.tolerance = 1.0;
  EXPECT_NE(message(options).find("tolerance"), std::string::npos);
}

}  // namespace
}  // namespace microslip::verification_test
