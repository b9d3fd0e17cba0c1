// SPDX-License-Identifier: MIT

// Faults of a record and the flags of its level. Level 4 of the reference recordings, 55.3 Hz, each
// with one fault.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/reduction.hpp"
#include "support/rigs.hpp"

namespace microslip::reduction_flags_test {
namespace {

using testing::reference_recording;
using testing::reference_rig;

constexpr double kTrueDissipation = 3.497508388724248e-4;  // J, of level 4
constexpr double kTrueAmplitude = 1.033353494953558e-4;    // m

std::vector<double>& values(Recording& recording, const std::string& name) {
  for (Channel& channel : recording.channels) {
    if (channel.name == name) return channel.values;
  }
  throw std::runtime_error("no channel " + name);
}

void scale(Recording& recording, const std::string& name, double factor) {
  for (double& value : values(recording, name)) value *= factor;
}

ReducedLevel reduced(const std::function<void(Recording&)>& spoil,
                     const Rig& rig = reference_rig()) {
  Recording recording = reference_recording(4);
  spoil(recording);
  return Reducer(rig).reduce(recording);
}

TEST(ReductionFlags, CleanRecordHasNone) {
  const ReducedLevel level = reduced([](Recording&) {});
  for (const Warning& flag : level.flags) ADD_FAILURE() << flag.code << ": " << flag.text;
}

TEST(ReductionFlags, HumDoesNotMoveTheFundamental) {
  for (const double hum : {50.0, 100.0, 120.0, 150.0}) {
    for (const char* name : {"force", "acc1", "ldv"}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(hum));
      const ReducedLevel level = reduced([&](Recording& recording) {
        std::vector<double>& signal = values(recording, name);
        const double amplitude = 0.03 * *std::ranges::max_element(signal);
        for (std::size_t i = 0; i < signal.size(); ++i) {
          signal[i] += amplitude * std::cos(2.0 * std::numbers::pi * hum * recording.axis.at(i));
        }
      });
      EXPECT_NEAR(level.frequency, 55.3, 0.01);
      // 27 cycles of a neighbouring tone of 3 % leak so much into a coefficient.
      EXPECT_NEAR(level.dissipation.value / kTrueDissipation, 1.0, 0.02);
      EXPECT_NEAR(level.amplitude.value / kTrueAmplitude, 1.0, 0.01);
    }
  }
}

TEST(ReductionFlags, LostSamplesAreNoSteadyState) {
  for (const std::ptrdiff_t lost : {5, 10, 37}) {
    const ReducedLevel level = reduced([&](Recording& recording) {
      for (Channel& channel : recording.channels) {
        channel.values.erase(channel.values.begin() + 1000, channel.values.begin() + 1000 + lost);
      }
    });
    EXPECT_TRUE(level.has_flag("phase_unsteady")) << lost;
  }
}

TEST(ReductionFlags, SpikeIsFlagged) {
  for (const char* name : {"force", "acc1", "ldv"}) {
    const ReducedLevel level = reduced([&](Recording& recording) {
      std::vector<double>& signal = values(recording, name);
      signal[777] += 100.0 * *std::ranges::max_element(signal);
    });
    EXPECT_TRUE(level.has_flag("spike")) << name;
  }
}

TEST(ReductionFlags, VibrometerOfWrongSignOrUnit) {
  const ReducedLevel inverted =
      reduced([](Recording& recording) { scale(recording, "ldv", -1.0); });
  EXPECT_TRUE(inverted.has_flag("vibrometer_mismatch"));
  EXPECT_TRUE(inverted.has_flag("secant_not_positive"));
  EXPECT_FALSE(inverted.secant_stiffness);
  const ReducedLevel micrometres =
      reduced([](Recording& recording) { scale(recording, "ldv", 1e6); });
  EXPECT_TRUE(micrometres.has_flag("vibrometer_mismatch"));
}

TEST(ReductionFlags, WrongUnitsBreakBounds) {
  const ReducedLevel pounds =
      reduced([](Recording& recording) { scale(recording, "force", 4.4482216); });
  EXPECT_TRUE(pounds.has_flag("dissipation_above_bound"));
  const ReducedLevel negative =
      reduced([](Recording& recording) { scale(recording, "force", -1.0); });
  EXPECT_TRUE(negative.has_flag(kNegativeDissipation));
  const ReducedLevel sensor =
      reduced([](Recording& recording) { scale(recording, "acc2", 9.80665); });
  EXPECT_TRUE(sensor.has_flag("model_misfit"));
  Rig rig = reference_rig();
  RigBeam beam = *rig.beam();
  beam.youngs_modulus /= 1e3;
  rig.structure = beam;
  EXPECT_TRUE(reduced([](Recording&) {}, rig).has_flag("far_from_first_mode"));
}

TEST(ReductionFlags, GapLeavesItsCyclesOut) {
  Recording recording = reference_recording(4);
  Axis uneven;
  for (std::size_t i = 0; i < recording.size(); ++i) uneven.values.push_back(recording.axis.at(i));
  recording.axis = uneven;
  const auto cut = [](std::vector<double>& values) {
    values.erase(values.begin() + 500, values.begin() + 555);
  };
  cut(recording.axis.values);
  for (Channel& channel : recording.channels) cut(channel.values);
  const ReducedLevel level = Reducer(reference_rig()).reduce(recording);
  EXPECT_TRUE(level.has_flag("dropout"));
  EXPECT_TRUE(level.has_flag("uneven_sampling"));
  EXPECT_NEAR(level.dissipation.value / kTrueDissipation, 1.0, 5e-3);
  EXPECT_LE(level.dissipation.std, 1e-3 * kTrueDissipation);
}

TEST(ReductionFlags, OneAccelerometerAnywhereIsEnough) {
  for (std::size_t kept = 0; kept < 3; ++kept) {
    Rig rig = reference_rig();
    rig.accelerometers = {rig.accelerometers[kept]};
    const ReducedLevel level = reduced([](Recording&) {}, rig);
    EXPECT_NEAR(level.dissipation.value / kTrueDissipation, 1.0, 5e-3) << kept;
  }
}

}  // namespace
}  // namespace microslip::reduction_flags_test
