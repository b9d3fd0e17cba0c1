// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/decay_reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/messages.hpp"

namespace microslip::decay_reduction_test {
namespace {

constexpr double kDamping = 0.01;  // ζ
constexpr double kMass = 1.5;      // kg

/// x = 1 mm e^(−ζωt) cos(√(1 − ζ²)ωt), 40 Hz, beside a channel that is no motion.
std::string linear_decay() {
  const double omega = 2.0 * std::numbers::pi * 40.0;
  Recording recording{.source = "decay", .axis = {}, .channels = {}, .attributes = {}};
  recording.axis.step = 1e-3;
  Channel motion{"x", kLength, {}, {}, {}};
  for (std::size_t i = 0; i < 2000; ++i) {
    const double t = recording.axis.at(i);
    motion.values.push_back(1e-3 * std::exp(-kDamping * omega * t) *
                            std::cos(std::sqrt(1.0 - kDamping * kDamping) * omega * t));
  }
  Channel force{"force", kForce, std::vector<double>(2000, 0.0), {}, {}};
  recording.channels = {force, motion};
  return format_recording_csv(recording);
}

// A linear mode: ζ at all levels. Its decay is followed to 1e-4 where nothing is added to it.
TEST(DecayReduction, DampingOfALinearMode) {
  const test::TemporaryFolder folder;
  test::put(folder.file("decay.csv"), linear_decay());
  const ReducedDecay reduced = reduce_decay({.recording = folder.file("decay.csv")});
  EXPECT_FALSE(reduced.band_given);
  ASSERT_FALSE(reduced.levels.damping_ratio.empty());
  for (const double ratio : reduced.levels.damping_ratio) EXPECT_NEAR(ratio, kDamping, 1e-4);
  const CsvTable table(levels_text(reduced, "call"), "levels.csv");
  EXPECT_FALSE(table.has("dissipation"));
  EXPECT_EQ(table.numbers("damping_ratio", kDimensionless).size(),
            reduced.levels.damping_ratio.size());
}

// A cycle of amplitude A loses about 2πζ m ω² A² = 4πζ E.
TEST(DecayReduction, DissipationByTheModalMass) {
  const test::TemporaryFolder folder;
  test::put(folder.file("decay.csv"), linear_decay());
  DecayReduction options{.recording = folder.file("decay.csv")};
  options.levels.emplace().modal_mass = kMass;
  const RingDownLevels levels = reduce_decay(options).levels;
  const double omega = 2.0 * std::numbers::pi * 40.0;
  for (std::size_t i = 0; i < levels.amplitude.size(); ++i) {
    const double expected = 2.0 * std::numbers::pi * kDamping * kMass * omega * omega *
                            levels.amplitude[i] * levels.amplitude[i];
    EXPECT_NEAR(levels.dissipation[i] / expected, 1.0, 0.02);
  }
}

TEST(DecayReduction, AChannelThatIsNotThereIsNamed) {
  const test::TemporaryFolder folder;
  test::put(folder.file("decay.csv"), linear_decay());
  const std::string message = test::message_or("no error", [&] {
    (void)reduce_decay({.recording = folder.file("decay.csv"), .channels = {"y"}});
  });
  EXPECT_NE(message.find("channel 'y'"), std::string::npos) << message;
  EXPECT_NE(message.find("The channels are 'force', 'x'"), std::string::npos) << message;
}

}  // namespace
}  // namespace microslip::decay_reduction_test
