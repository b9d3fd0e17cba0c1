// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/recording_conversion.hpp"

#include <gtest/gtest.h>

#include "microslip/base/error.hpp"

namespace microslip::recording_conversion_test {
namespace {

std::vector<Recording> two_channels() {
  Recording recording{.source = "r", .axis = {}, .channels = {}, .attributes = {}};
  recording.channels = {{"a", kForce, {1.0}, {}, {}}, {"b", kLength, {2.0}, {}, {}}};
  return {recording};
}

TEST(RecordingConversion, ChannelsInTheOrderOfTheCall) {
  std::vector<Recording> recordings = two_channels();
  choose_channels({"b", "a"}, recordings);
  EXPECT_EQ(recordings[0].channels[0].name, "b");
  EXPECT_EQ(recordings[0].channels[1].name, "a");
  EXPECT_THROW(choose_channels({"c"}, recordings), InputError);
  choose_channels({}, recordings);
  EXPECT_EQ(recordings[0].channels.size(), 2);
}

// A file that was converted twice has been read under two names.
TEST(RecordingConversion, AWarningIsKeptOnce) {
  std::vector<Recording> recordings = two_channels();
  add_warning_attributes({{"cut", "first.csv: ends early"}}, recordings);
  add_warning_attributes({{"cut", "second.csv: ends early"}, {"unit", "x: none"}}, recordings);
  ASSERT_EQ(recordings[0].attributes.size(), 2);
  EXPECT_EQ(recordings[0].attributes[0].second, "cut: first.csv: ends early");
}

}  // namespace
}  // namespace microslip::recording_conversion_test
