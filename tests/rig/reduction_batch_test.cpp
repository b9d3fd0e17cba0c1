// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/reduction_batch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "support/rigs.hpp"

namespace microslip::reduction_batch_test {
namespace {

using test::message_of;
using testing::Sampling;
using testing::SolvedRig;
using testing::unseen_rig;

const SolvedRig& solved() {
  static const SolvedRig kSolved(MICROSLIP_TEST_DATA "/unseen_rig.csv");
  return kSolved;
}

const Reducer& reducer() {
  static const Reducer kReducer(unseen_rig());
  return kReducer;
}

/// A short record of level i, as a file of its own.
std::vector<Recording> read(std::size_t i) {
  return {solved().record(i, {.rate = 2048.0, .points = 512}, 1)};
}

/// Every figure of the levels, to the last bit.
std::vector<double> figures(const ReductionBatch& batch) {
  std::vector<double> all;
  for (const ReducedLevel& level : batch.levels) {
    all.insert(all.end(), {level.frequency, level.amplitude.value, level.amplitude.std,
                           level.dissipation.value, level.dissipation.std,
                           level.secant_stiffness->value, level.secant_stiffness->std});
  }
  return all;
}

std::vector<std::string> sources(const ReductionBatch& batch) {
  std::vector<std::string> all;
  for (const ReducedLevel& level : batch.levels) all.push_back(level.source);
  return all;
}

constexpr std::size_t kFiles = 12;

TEST(ReductionBatch, IsTheSameOnOneThreadAndMore) {
  const std::vector<double> expected =
      figures(reduce_batch(reducer(), kFiles, read, {.execution = Execution::serial()}));
  EXPECT_EQ(expected.size(), 7 * kFiles);
  for (const std::size_t threads : {2, 3, 8}) {
    EXPECT_EQ(
        figures(reduce_batch(reducer(), kFiles, read, {.execution = Execution::threads(threads)})),
        expected)
        << threads;
  }
}

TEST(ReductionBatch, KeepsTheOrderOfFilesAndOfRecordsInEach) {
  const auto read_two = [](std::size_t i) {
    std::vector<Recording> both = read(2 * i);
    both.push_back(read(2 * i + 1).front());
    return both;
  };
  const ReductionBatch batch = reduce_batch(reducer(), kFiles / 2, read_two);
  std::vector<std::string> expected;
  for (std::size_t i = 1; i <= kFiles; ++i) expected.push_back(fmt::format("level_{}", i));
  EXPECT_EQ(sources(batch), expected);
  EXPECT_TRUE(batch.rejected.empty());
  EXPECT_EQ(figures(batch), figures(reduce_batch(reducer(), kFiles, read)));
}

TEST(ReductionBatch, OfNothingIsEmpty) {
  EXPECT_TRUE(reduce_batch(reducer(), 0, read).levels.empty());
  const ReductionBatch batch =
      reduce_batch(reducer(), 2, [](std::size_t) { return std::vector<Recording>{}; });
  EXPECT_TRUE(batch.levels.empty());
  EXPECT_TRUE(batch.rejected.empty());
}

/// File 3 cannot be read, file 7 lacks a channel.
std::vector<Recording> read_with_faults(std::size_t i) {
  if (i == 3) throw FileError("third.csv", "cannot be read");
  std::vector<Recording> recordings = read(i);
  if (i == 7) recordings.front().channels.erase(recordings.front().channels.begin() + 1);
  return recordings;
}

TEST(ReductionBatch, TellsTheFirstFaultInOrder) {
  for (int run = 0; run < 10; ++run) {  // whichever thread comes first
    EXPECT_NE(message_of<Error>([] {
                return reduce_batch(reducer(), kFiles, read_with_faults);
              }).find("third.csv"),
              std::string::npos);
  }
}

TEST(ReductionBatch, LeavesFaultyFilesOutOnRequest) {
  const ReductionBatch batch =
      reduce_batch(reducer(), kFiles, read_with_faults, {.skip_faulty = true});
  EXPECT_EQ(batch.levels.size(), kFiles - 2);
  EXPECT_EQ(batch.levels[3].source, "level_5");
  ASSERT_EQ(batch.rejected.size(), 2U);
  EXPECT_EQ(batch.rejected[0].index, 3U);
  EXPECT_NE(batch.rejected[0].reason.find("third.csv"), std::string::npos);
  EXPECT_EQ(batch.rejected[1].index, 7U);
  EXPECT_NE(batch.rejected[1].reason.find("level_8: channel 'acc1'"), std::string::npos);
}

TEST(ReductionBatch, AFaultyRecordDoesNotTakeItsFileAlong) {
  const auto read_all = [](std::size_t) {
    std::vector<Recording> all;
    for (std::size_t i = 4; i < 10; ++i) all.push_back(read(i).front());
    all[1].channels.front().values.assign(all[1].size(), 0.0);
    return all;
  };
  const ReductionBatch batch = reduce_batch(reducer(), 1, read_all, {.skip_faulty = true});
  EXPECT_EQ(sources(batch),
            (std::vector<std::string>{"level_5", "level_7", "level_8", "level_9", "level_10"}));
  ASSERT_EQ(batch.rejected.size(), 1U);
  EXPECT_NE(batch.rejected[0].reason.find("level_6: channel 'force' = constant"),
            std::string::npos);
}

TEST(ReductionBatch, ProgressCountsTheFiles) {
  std::vector<std::size_t> done;  // the callback is never in two threads at once
  const auto listen = [&](std::size_t count, std::size_t total) {
    EXPECT_EQ(total, kFiles);
    done.push_back(count);
    return true;
  };
  (void)reduce_batch(reducer(), kFiles, read, {.progress = listen});
  std::vector<std::size_t> expected;
  for (std::size_t i = 1; i <= kFiles; ++i) expected.push_back(i);
  EXPECT_EQ(done, expected);
}

TEST(ReductionBatch, StopsOnRequest) {
  for (const bool skip : {false, true}) {
    const auto stop = [](std::size_t count, std::size_t) { return count < 3; };
    EXPECT_THROW(
        (void)reduce_batch(reducer(), kFiles, read, {.skip_faulty = skip, .progress = stop}),
        Cancelled);
    const auto read_and_stop = [](std::size_t i) {
      if (i == 4) throw Cancelled();
      return read(i);
    };
    EXPECT_THROW((void)reduce_batch(reducer(), kFiles, read_and_stop, {.skip_faulty = skip}),
                 Cancelled)
        << "a reader that was stopped is not a faulty file";
  }
}

}  // namespace
}  // namespace microslip::reduction_batch_test
