// SPDX-License-Identifier: MIT
#include "microslip/io/reading_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/sample_recordings.hpp"
#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::reading_process_test {
namespace {

using test::message_of;

class ReadingProcessTest : public testing::Test {
 protected:
  ~ReadingProcessTest() override {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  }

  Recordings run(const std::function<Recordings(const Progress&)>& read,
                 const Progress& progress = {}) const {
    const Hdf5Session session;
    return read_in_process<Recordings>(session, "a.h5", progress, read);
  }

  void expect_damaged(const std::function<void()>& read, const std::string& how = "fails") const {
    EXPECT_EQ(message_of<FormatError>([&] {
                return run([&](const Progress&) {
                  read();
                  return Recordings{};
                });
              }),
              "a.h5: expected a whole HDF5 file, found one on which the HDF5 library " + how +
                  ". The file is damaged; save or copy it anew.");
  }
};

TEST_F(ReadingProcessTest, HandsOverWhatItReads) {
  Recordings whole{test::twelve_recordings(), {{"code", "a text\n"}, {}}};
  whole.recordings.push_back(test::time_recording(300'001));  // more than a pipe holds
  int here = 0;
  const Recordings read = run([&](const Progress&) {
    here = 1;
    return whole;
  });
  EXPECT_EQ(here, 0) << "it ran in this process";
  test::expect_same(read.recordings, whole.recordings);
  ASSERT_EQ(read.warnings.size(), 2U);
  EXPECT_EQ(read.warnings[0].text, "a text\n");
}

TEST_F(ReadingProcessTest, ThrowsWhatItThrows) {
  const auto throwing = [](const auto& error) {
    return [&error](const Progress&) -> Recordings { throw error; };
  };
  const InputError input("a.h5: x", 3.0, "must be 4", "Make it so.");
  const FormatError format({"a.h5", 3, 7}, "this", "that");
  const FileError file("a.h5", "is away");
  EXPECT_EQ(message_of<InputError>([&] { return run(throwing(input)); }), input.what());
  EXPECT_EQ(message_of<FormatError>([&] { return run(throwing(format)); }), format.what());
  EXPECT_EQ(message_of<FileError>([&] { return run(throwing(file)); }), file.what());
  EXPECT_THROW((void)run(throwing(std::bad_alloc())), std::bad_alloc);
  try {
    (void)run(throwing(input));
  } catch (const InputError& error) {
    EXPECT_STREQ(error.renamed("y").what(), "y = 3; must be 4. Make it so.");
  }
  try {
    (void)run(throwing(format));
  } catch (const FormatError& error) {
    EXPECT_EQ(error.place().line, 3U);
  }
}

TEST_F(ReadingProcessTest, RefusesWhatCrashes) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGKILL}) {
    SCOPED_TRACE(signal);
    expect_damaged([signal] { (void)raise(signal); });
  }
  expect_damaged([] { _exit(0); });
  expect_damaged([] { throw std::runtime_error("of a kind that no reader throws"); });
}

TEST_F(ReadingProcessTest, CallsNoHandlerOfTheProgram) {
  const auto before = std::signal(SIGSEGV, [](int) { _exit(0); });
  expect_damaged([] { (void)raise(SIGSEGV); });
  (void)std::signal(SIGSEGV, before);
}

TEST_F(ReadingProcessTest, RefusesWhatRunsForEver) {
  expect_damaged(
      [] {
        for (volatile int i = 0; i == 0;) {
        }
      },
      "does not come to an end");
}

TEST_F(ReadingProcessTest, BoundsTheMemory) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer ends a process that gets no memory";
#endif
  EXPECT_THROW((void)run([](const Progress&) {
                 // Not touched: on a busy machine the time would run out first.
                 std::vector<std::vector<char>> all;
                 for (int i = 0; i < 64; ++i) all.emplace_back().reserve(std::size_t{32} << 20U);
                 return Recordings{};
               }),
               std::bad_alloc);
}

// Then there is no exit status to ask for.
TEST_F(ReadingProcessTest, NeedsNoExitStatus) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_NO_THROW((void)run([](const Progress&) { return Recordings{}; }));
  expect_damaged([] { (void)raise(SIGSEGV); });
  (void)std::signal(SIGCHLD, before);
}

TEST_F(ReadingProcessTest, CanBeCancelled) {
  const auto stop = [](std::size_t, std::size_t) { return false; };
  const auto wait_for_ever = [](const Progress&) -> Recordings {
    for (;;) pause();
  };
  EXPECT_THROW((void)run(wait_for_ever, stop), Cancelled);
  const auto tell = [](const Progress& told) -> Recordings {
    for (;;) (void)told(1, 2);
  };
  EXPECT_THROW((void)run(tell, stop), Cancelled);
}

TEST_F(ReadingProcessTest, TellsTheProgress) {
  std::vector<std::size_t> told;
  (void)run(
      [](const Progress& tell) {
        (void)tell(1, 2);
        (void)tell(2, 2);
        return Recordings{};
      },
      [&](std::size_t done, std::size_t total) {
        if (total == 2) told.push_back(done);
        return true;
      });
  ASSERT_GE(told.size(), 2U);
  EXPECT_EQ(told.front(), 1U);
  EXPECT_EQ(told.back(), 2U);
}

TEST_F(ReadingProcessTest, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  (void)run([](const Progress&) {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) (void)!write(stream, "x", 1);
    return Recordings{};
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace microslip::reading_process_test
