// SPDX-License-Identifier: MIT
#include "microslip/base/execution.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::execution_test {
namespace {

std::vector<Execution> all() {
  return {Execution::serial(), Execution::threads(), Execution::threads(1), Execution::threads(3)};
}

TEST(Execution, DoesEachPieceOnce) {
  for (const Execution& execution : all()) {
    for (const std::size_t count : {0, 1, 7, 1000}) {
      std::vector<std::atomic<int>> times(count);
      execution.for_each(count, [&](std::size_t i) { ++times[i]; });
      for (const std::atomic<int>& t : times) EXPECT_EQ(t, 1);
    }
  }
}

TEST(Execution, SerialKeepsTheOrderAndTheThread) {
  std::vector<std::size_t> order;
  std::set<std::thread::id> threads;
  Execution::serial().for_each(50, [&](std::size_t i) {
    order.push_back(i);
    threads.insert(std::this_thread::get_id());
  });
  std::vector<std::size_t> expected(50);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(order, expected);
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(Execution, TakesNoMoreThreadsAtOnceThanGiven) {
  for (const int most : {1, 2}) {
    std::atomic<int> running = 0;
    std::atomic<int> largest = 0;
    Execution::threads(static_cast<std::size_t>(most)).for_each(2000, [&](std::size_t) {
      const int now = ++running;
      int before = largest;
      while (now > before && !largest.compare_exchange_weak(before, now)) {
      }
      std::this_thread::yield();
      --running;
    });
    EXPECT_GE(largest, 1);
    EXPECT_LE(largest, most);
  }
}

TEST(Execution, PassesOnWhatAPieceThrows) {
  for (const Execution& execution : all()) {
    const auto work = [](std::size_t i) {
      if (i == 17) throw std::domain_error("17");
    };
    EXPECT_THROW(execution.for_each(100, work), std::domain_error);
    EXPECT_THROW(execution.for_each(100, work, [](auto, auto) { return true; }), std::domain_error);
  }
}

TEST(Execution, TellsProgressOneAtATime) {
  for (const Execution& execution : all()) {
    std::vector<std::size_t> reported;  // not guarded: calls do not overlap
    execution.for_each(
        300, [](std::size_t) {},
        [&](std::size_t done, std::size_t total) {
          EXPECT_EQ(total, 300U);
          reported.push_back(done);
          return true;
        });
    std::vector<std::size_t> expected(300);
    std::iota(expected.begin(), expected.end(), 1);
    EXPECT_EQ(reported, expected);
  }
}

TEST(Execution, StopsWhenProgressSaysSo) {
  for (const Execution& execution : all()) {
    std::size_t reported = 0;
    const Progress stop = [&](std::size_t done, std::size_t) {
      ++reported;
      return done < 5;
    };
    EXPECT_THROW(execution.for_each(
                     1000, [](std::size_t) {}, stop),
                 Cancelled);
    EXPECT_EQ(reported, 5U);
  }
}

TEST(Execution, IsWhatTheCallerMakesIt) {
  std::size_t asked = 0;
  const Execution backwards([&](std::size_t count, const Execution::Work& work) {
    asked = count;
    for (std::size_t i = count; i-- > 0;) work(i);
  });
  std::vector<std::size_t> order;
  backwards.for_each(3, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(asked, 3U);
  EXPECT_EQ(order, (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_THROW(Execution(Execution::ForEach()), InputError);
}

}  // namespace
}  // namespace microslip::execution_test
