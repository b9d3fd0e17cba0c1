// SPDX-License-Identifier: MIT
#include "microslip/observe/record_evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "microslip/base/error.hpp"
#include "support/messages.hpp"

namespace microslip::record_evidence_test {
namespace {

ForceRecord sine() {
  ForceRecord record;
  record.time_step = 1e-3;
  for (int i = 0; i < 500; ++i) {
    const double phase = 0.05 * i;
    record.displacement.push_back(1e-5 * std::sin(phase));
    record.force.push_back(2.0 * std::sin(phase + 0.1));
  }
  return record;
}

TEST(RecordEvidence, KeepsWhatWasMeasuredAndTellsTurns) {
  const RecordEvidence evidence(sine(), PathStart::kVirgin);
  EXPECT_EQ(evidence.measured().force, sine().force);
  EXPECT_EQ(evidence.rows().reversals, 8U);  // 25 rad
  EXPECT_NEAR(evidence.rows().reach, 1e-5, 1e-8);
  const RecordEvidence other = evidence.from(PathStart::kUnknown);
  EXPECT_EQ(other.start(), PathStart::kUnknown);
  EXPECT_LT(other.rows().rows.front().force, 2.1);
  EXPECT_GT(other.rows().rows.front().first, 0U);
}

TEST(RecordEvidence, RefusesWhatIsNoRecord) {
  const auto refused = [](const ForceRecord& record) {
    return test::message_or("taken", [&] { return RecordEvidence(record, PathStart::kVirgin); });
  };
  ForceRecord record = sine();
  record.force.pop_back();
  test::expect_message(refused(record), "499");

  record = sine();
  record.displacement[6] = std::numeric_limits<double>::quiet_NaN();
  test::expect_message(refused(record), "7");

  record = sine();
  record.force.assign(record.force.size(), 3.0);
  test::expect_message(refused(record), "force");

  record = sine();
  record.displacement.resize(10);
  record.force.resize(10);
  test::expect_message(refused(record), "16");

  record = sine();
  record.time_step = -1.0;
  test::expect_message(refused(record), "-1");
}

}  // namespace
}  // namespace microslip::record_evidence_test
