// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/verification_draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/response/verification_file.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/joint/normal_load_scale.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

namespace microslip::verification_draws_test {
namespace {

using testing::reference_joint;
using testing::reference_recording;
using testing::reference_rig;

constexpr std::size_t kDraws = 100;

/// The reference rig with few modes, which its low levels do not need more of, by a joint that is
/// the true one but for its normal load.
Verifier verifier(double load = 1.0) {
  VerificationOptions options;
  options.reduction.modes = 3;
  options.balance.harmonics = 3;
  options.balance.samples = 64;
  options.reduction.fit.order = 3;
  return {reference_rig(), with_normal_load(reference_joint(), load), options};
}

std::vector<Verification> records_of(const Verifier& by) {
  std::vector<Verification> records;
  for (const int level : {2, 4}) records.push_back(by.verify(reference_recording(level)));
  return records;
}

VerificationSpread spread_of(const Verifier& by, const std::vector<Verification>& records,
                             const RigUncertainty& rig,
                             const Execution& execution = Execution::threads()) {
  return verification_spread(by, records, {}, rig, {.count = kDraws}, execution);
}

// A response is read as the gain times what is there: by itself a gain scales the response at the
// recorded force, and leaves its frequency. The edges of 95 % lie at e^{±1.96σ}, within four
// standard deviations of a quantile of N draws, 2.67σ/√N.
TEST(VerificationDraws, OfAGainScaleTheResponse) {
  constexpr double kGain = 0.05;
  const Verifier by = verifier();
  const VerificationSpread spread = spread_of(by, records_of(by), {.acceleration_gain = kGain});
  ASSERT_EQ(spread.records.size(), 2U);
  EXPECT_EQ(spread.taken.failed(), 0U);
  const double tolerance = 4.0 * 2.67 * kGain / std::sqrt(static_cast<double>(kDraws));
  for (const CheckedRecord& record : spread.records) {
    const CheckedValue& response = record.response;
    EXPECT_NEAR(std::log(response.lower / response.predicted), -1.96 * kGain, tolerance);
    EXPECT_NEAR(std::log(response.upper / response.predicted), 1.96 * kGain, tolerance);
    EXPECT_NEAR(record.frequency.lower, record.frequency.upper, 1e-6 * record.frequency.upper);
    // By the true joint the record is as predicted, but for noise and few modes.
    EXPECT_NEAR(response.recorded / response.predicted, 1.0, 0.02);
    EXPECT_TRUE(response.inside());
    EXPECT_TRUE(record.input_energy.inside());
  }
  EXPECT_EQ(spread.inside(&CheckedRecord::response), 2U);
}

// A joint under half of its load slips more: the response that it predicts is lower, and outside of
// draws that do not know of another load; inside of those that do.
TEST(VerificationDraws, TellWhatLiesOutside) {
  const Verifier by = verifier(0.5);
  const std::vector<Verification> records = records_of(by);
  const VerificationSpread narrow = spread_of(by, records, {.frequency = 5e-4});
  EXPECT_EQ(narrow.inside(&CheckedRecord::response), 0U);
  EXPECT_EQ(narrow.inside(&CheckedRecord::input_energy), 0U);
  const VerificationSpread wide = spread_of(by, records, {.frequency = 5e-4, .normal_load = 0.6});
  EXPECT_EQ(wide.inside(&CheckedRecord::response), 2U);
  EXPECT_EQ(wide.inside(&CheckedRecord::input_energy), 2U);
  CsvWriter table = verification_table(records);
  add_checked(wide, records, table);
  const CsvTable read(table.str(), "verification.csv");
  EXPECT_EQ(read.numbers("response_inside", kDimensionless).front(), 1.0);
  EXPECT_EQ(read.numbers("predicted_frequency_lower", kFrequency).size(),
            records[0].channels.size() + records[1].channels.size());
}

TEST(VerificationDraws, AreTheSameOnAnyNumberOfThreads) {
  const Verifier by = verifier();
  const std::vector<Verification> records = records_of(by);
  const RigUncertainty rig{.frequency = 1e-3, .loss_factor = 0.1, .normal_load = 0.1};
  const VerificationSpread one = spread_of(by, records, rig, Execution::serial());
  const VerificationSpread two = spread_of(by, records, rig, Execution::threads(2));
  for (std::size_t r = 0; r < records.size(); ++r) {
    EXPECT_EQ(one.records[r].response.lower, two.records[r].response.lower);
    EXPECT_EQ(one.records[r].frequency.upper, two.records[r].frequency.upper);
    EXPECT_EQ(one.records[r].amplitude.lower, two.records[r].amplitude.lower);
  }
}

TEST(VerificationDraws, OfNothingAreRefused) {
  const Verifier by = verifier();
  EXPECT_THROW(spread_of(by, records_of(by), {}), InputError);
  EXPECT_THROW(spread_of(by, {}, {.frequency = 1e-3}), InputError);
}

}  // namespace
}  // namespace microslip::verification_draws_test
