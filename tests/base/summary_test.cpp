// SPDX-License-Identifier: MIT
#include "microslip/base/summary.hpp"

#include <gtest/gtest.h>

#include <string>

#include "microslip/base/stopwatch.hpp"

namespace microslip::summary_test {
namespace {

Summary stopped(Stop why) {
  Summary summary{.method = "bisection", .reason = "of a test"};
  summary.stop = why;
  return summary;
}

TEST(Summary, IsPessimisticUntilFilledIn) {
  const Summary summary;
  EXPECT_FALSE(summary.converged());
  EXPECT_FALSE(summary.usable());
  EXPECT_EQ(summary.status(), "not run");
}

TEST(Summary, TellsWhatMayBeUsed) {
  for (const Stop why : {Stop::kConverged, Stop::kClosedForm}) {
    EXPECT_TRUE(stopped(why).converged());
    EXPECT_TRUE(stopped(why).usable());
    EXPECT_EQ(stopped(why).status(), kConvergedStatus);
  }
  for (const Stop why : {Stop::kLimit, Stop::kNoProgress, Stop::kDoubtful, Stop::kIncomplete}) {
    EXPECT_FALSE(stopped(why).converged());
    EXPECT_EQ(stopped(why).usable(), why != Stop::kDoubtful);
    EXPECT_EQ(stopped(why).status(), "not converged");
  }
}

TEST(Summary, SaysWhatTookTheTime) {
  Stopwatch watch;
  Summary summary = stopped(Stop::kLimit);
  summary.timings.push_back(watch.lap("first"));
  summary.timings.push_back(watch.lap("second"));
  summary.wall_seconds = watch.seconds();
  EXPECT_GE(summary.timings[0].seconds, 0.0);
  EXPECT_GE(summary.wall_seconds, summary.timings[0].seconds + summary.timings[1].seconds - 1e-9);
  const std::string full = summary.full();
  EXPECT_LT(full.find("first"), full.find("second"));
  EXPECT_NE(full.find("not converged"), std::string::npos);
  EXPECT_NE(summary.brief().find("bisection: not converged (of a test)"), std::string::npos);
}

}  // namespace
}  // namespace microslip::summary_test
