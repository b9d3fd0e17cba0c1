// SPDX-License-Identifier: MIT
#include "microslip/io/output/temporaries.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "io/support.hpp"

namespace microslip::temporaries_test {
namespace {

using test::put;
using Names = std::vector<std::string>;

TEST(Temporary, VanishesWithItsObject) {
  const test::TemporaryFolder folder;
  {
    Temporary first(folder.file("a"));
    const Temporary second = std::move(first);
    Temporary kept(folder.file("b"));
    put(second.path(), "x");
    put(kept.path(), "x");
    kept.keep();
    EXPECT_EQ(folder.names(), (Names{"a", "b"}));
  }
  EXPECT_EQ(folder.names(), Names{"b"});
}

TEST(Temporary, VanishesWhenAllAreRemoved) {
  const test::TemporaryFolder folder;
  std::vector<Temporary> temporaries;
  for (int i = 0; i < 100; ++i) {
    temporaries.emplace_back(folder.file("t" + std::to_string(i)));
    put(temporaries.back().path(), "x");
  }
  Temporary kept(folder.file("kept"));
  put(kept.path(), "x");
  kept.keep();
  remove_temporaries();
  EXPECT_EQ(folder.names(), Names{"kept"});
}

void remove_and_end(int) {
  remove_temporaries();
  _exit(130);
}

TEST(Temporary, VanishesInASignalHandler) {
  const test::TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    const Temporary temporary(folder.file("t"));
    put(temporary.path(), "x");
    (void)std::signal(SIGINT, remove_and_end);
    (void)std::raise(SIGINT);
    _exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(Temporary, MayBeUsedByManyThreads) {
  const test::TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&folder, t] {
      for (int i = 0; i < 500; ++i) {
        const Temporary temporary(folder.file(std::to_string(t)));
        put(temporary.path(), "x");
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(folder.names(), Names{});
}

}  // namespace
}  // namespace microslip::temporaries_test
