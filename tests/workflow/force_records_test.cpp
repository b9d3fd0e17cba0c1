// SPDX-License-Identifier: MIT
// Files of several recordings, of which not all have the force and the displacement of a joint.

#include "microslip/workflow/reduce/force_records.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/mat/mat_recording.hpp"

namespace microslip::force_records_test {
namespace {

Recording recording_of(const std::vector<std::pair<std::string, Dimension>>& channels,
                       std::size_t points) {
  Recording recording;
  recording.source = channels.front().first;
  recording.axis.step = 1e-3;
  for (const auto& [name, dimension] : channels) {
    Channel& channel = recording.channels.emplace_back();
    channel.name = name;
    channel.dimension = dimension;
    channel.values.assign(points, 1.0);
  }
  return recording;
}

class SeveralRecordings : public ::testing::Test {
 protected:
  ForceRecords read(const std::vector<Recording>& recordings) {
    const std::string path = folder_.file("a.mat");
    write_recordings_mat(path, recordings);
    return read_force_records(std::vector{path}, {}, {});
  }

  test::TemporaryFolder folder_;
};

const Recording kBoth = recording_of({{"force", kForce}, {"ldv", kLength}}, 40);
const Recording kMarker = recording_of({{"marker", kTime}}, 5);

TEST_F(SeveralRecordings, LeavesOutThoseWithoutForceAndDisplacement) {
  const ForceRecords read = this->read({kMarker, kBoth});
  ASSERT_EQ(read.records.size(), 1U);
  EXPECT_EQ(read.records[0].record.force.size(), 40U);
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0].code, "recording_left_out");
  EXPECT_NE(read.warnings[0].text.find("'marker'"), std::string::npos);
}

TEST_F(SeveralRecordings, SaysWhichOneHasTheOtherChannel) {
  const std::string message = test::message_of<InputError>([&] {
    (void)read({recording_of({{"force", kForce}}, 40), recording_of({{"ldv", kLength}}, 20)});
  });
  EXPECT_NE(message.find("One is in another recording of the file, "), std::string::npos);
  EXPECT_EQ(test::message_of<InputError>([&] {
              (void)read({kMarker, kMarker});
            }).find("One is in"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::force_records_test
