// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/departure_meanings.hpp"

#include <gtest/gtest.h>

#include "microslip/identify/evidence/evidence_verdicts.hpp"
#include "microslip/identify/evidence/level_verdicts.hpp"

namespace microslip::departure_meanings_test {
namespace {

/// A reader of the summary is no reader of codes.
TEST(DepartureMeanings, EveryDepartureIsInWords) {
  for (const RecordDeparture departure : kRecordDepartures) {
    EXPECT_NE(departure_meaning(to_string(departure)), to_string(departure));
  }
  for (const LevelDeparture departure :
       {LevelDeparture::kOrder, LevelDeparture::kSecant, LevelDeparture::kFrequency}) {
    EXPECT_NE(departure_meaning(to_string(departure)), to_string(departure));
  }
  EXPECT_EQ(departure_with_code("dead_zone"), "play, pinching or bearing (dead_zone)");
  EXPECT_EQ(departure_with_code("of_a_later_version"), "of_a_later_version");
}

}  // namespace
}  // namespace microslip::departure_meanings_test
