// SPDX-License-Identifier: MIT
#include "microslip/base/attended_work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// Works until it is asked to stop, or for ten seconds.
void work_until_stopped(const Progress& progress) {
  for (std::size_t i = 0; i < 10'000; ++i) {
    if (!progress(i, 10'000)) throw Cancelled();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(AttendedWork, IsDoneOnAnotherThread) {
  const auto here = std::this_thread::get_id();
  std::thread::id there;
  do_attended([&](const Progress&) { there = std::this_thread::get_id(); },
              [](std::size_t, std::size_t) { return true; });
  EXPECT_NE(there, here);
}

TEST(AttendedWork, IsAttendedByTheCallerWithWhatItTold) {
  const auto here = std::this_thread::get_id();
  std::vector<std::size_t> reported;
  EXPECT_THROW(do_attended(work_until_stopped,
                           [&](std::size_t done, std::size_t total) {
                             EXPECT_EQ(std::this_thread::get_id(), here);
                             EXPECT_EQ(total, 10'000U);
                             reported.push_back(done);
                             return reported.size() < 3;
                           }),
               Cancelled);
  ASSERT_EQ(reported.size(), 3U);
  EXPECT_LT(reported[0], reported[1]);
  EXPECT_LT(reported[1], reported[2]);
}

// Work that is over at once is stopped all the same.
TEST(AttendedWork, AsksBeforeShortWorkEnds) {
  bool went_on = false;
  do_attended([&](const Progress& progress) { went_on = progress(0, 1); },
              [](std::size_t, std::size_t) { return false; });
  EXPECT_FALSE(went_on);
}

TEST(AttendedWork, ThrowsWhatTheWorkThrows) {
  EXPECT_THROW(do_attended([](const Progress&) { throw std::out_of_range("work"); },
                           [](std::size_t, std::size_t) { return true; }),
               std::out_of_range);
}

TEST(AttendedWork, ThrowsWhatItsAttendantThrowsOnceTheWorkHasEnded) {
  std::atomic<bool> ended = false;
  const auto work = [&](const Progress& progress) {
    try {
      work_until_stopped(progress);
    } catch (...) {
      ended = true;
      throw;
    }
  };
  EXPECT_THROW(
      do_attended(work,
                  [](std::size_t, std::size_t) -> bool { throw std::out_of_range("attendant"); }),
      std::out_of_range);
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace microslip
