// SPDX-License-Identifier: MIT
#include "microslip/rig/verification/verification_batch.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/densities.hpp"
#include "support/rigs.hpp"

namespace microslip::verification_batch_test {
namespace {

using testing::reference_joint;
using testing::reference_recording;
using testing::reference_rig;

constexpr std::size_t kFiles = 6;

/// Level i + 1, as a file of its own.
std::vector<Recording> read(std::size_t i) {
  return {reference_recording(static_cast<int>(i) + 1)};
}

const Verifier& verifier() {
  static const Verifier kVerifier(reference_rig(), reference_joint());
  return kVerifier;
}

/// Every error of the records, to the last bit.
std::vector<double> figures(const VerificationBatch& batch) {
  std::vector<double> all;
  for (const Verification& record : batch.records) {
    all.push_back(*record.predicted.frequency_offset);
    for (const ChannelComparison& channel : record.channels) all.push_back(channel.nrmse);
  }
  return all;
}

TEST(VerificationBatch, IsTheSameOnOneThreadAndMore) {
  const std::vector<double> expected =
      figures(verify_batch(verifier(), kFiles, read, {.execution = Execution::serial()}));
  EXPECT_EQ(expected.size(), 6 * kFiles);
  for (const std::size_t threads : {2, 5}) {
    EXPECT_EQ(
        figures(verify_batch(verifier(), kFiles, read, {.execution = Execution::threads(threads)})),
        expected)
        << threads;
  }
}

TEST(VerificationBatch, KeepsTheOrder) {
  const VerificationBatch batch = verify_batch(verifier(), kFiles, read);
  ASSERT_EQ(batch.records.size(), kFiles);
  EXPECT_TRUE(batch.converged());
  for (std::size_t i = 0; i < kFiles; ++i) {
    EXPECT_EQ(batch.records[i].recorded.source, read(i).front().source);
  }
}

TEST(VerificationBatch, LeavesFaultyRecordsOutOnRequest) {
  const auto read_with_fault = [](std::size_t i) {
    std::vector<Recording> recordings = read(i);
    if (i == 2) recordings.front().channels.erase(recordings.front().channels.begin() + 1);
    return recordings;
  };
  EXPECT_THROW((void)verify_batch(verifier(), kFiles, read_with_fault), InputError);
  const VerificationBatch batch =
      verify_batch(verifier(), kFiles, read_with_fault, {.skip_faulty = true});
  EXPECT_EQ(batch.records.size(), kFiles - 1);
  ASSERT_EQ(batch.rejected.size(), 1U);
  EXPECT_EQ(batch.rejected[0].index, 2U);
  EXPECT_NE(batch.rejected[0].reason.find("level_3.csv: channel 'acc1'"), std::string::npos);
}

TEST(VerificationBatch, KeepsWhatDoesNotConverge) {
  VerificationOptions options;
  options.balance.max_iterations = 2;
  const VerificationBatch batch =
      verify_batch(Verifier(reference_rig(), reference_joint(), options), kFiles, read);
  EXPECT_EQ(batch.records.size(), kFiles);
  EXPECT_TRUE(batch.rejected.empty());
  EXPECT_FALSE(batch.converged());
}

TEST(VerificationBatch, StopsOnRequest) {
  const auto stop = [](std::size_t count, std::size_t total) {
    EXPECT_EQ(total, kFiles);
    return count < 2;
  };
  EXPECT_THROW((void)verify_batch(verifier(), kFiles, read, {.progress = stop}), Cancelled);
}

}  // namespace
}  // namespace microslip::verification_batch_test
