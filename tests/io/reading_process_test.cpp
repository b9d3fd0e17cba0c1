// SPDX-License-Identifier: MIT
#include "microslip/io/sandbox/reading_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "io/sample_recordings.hpp"
#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "support/built_file.hpp"
#include "support/effort.hpp"

namespace microslip::reading_process_test {
namespace {

using test::message_of;

Recordings run(const std::string& what, const std::string& number = "",
               const Progress& progress = {}) {
  static const std::string reader =
      test::built_file("MICROSLIP_FAULTY_READER", MICROSLIP_FAULTY_READER);
  return read_in_process<Recordings>({reader, what, number}, "a.h5", progress);
}

void expect_damaged(const std::string& what, const std::string& number = "",
                    const std::string& how = "fails") {
  EXPECT_EQ(message_of<FormatError>([&] { return run(what, number); }),
            "a.h5: expected a whole HDF5 file, found one on which the HDF5 library " + how +
                ". The file is damaged; save or copy it again.");
}

class ReadingProcessTest : public ::testing::Test {
 protected:
  ~ReadingProcessTest() override {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  }
};

TEST_F(ReadingProcessTest, HandsOverWhatItReads) {
  std::vector<Recording> whole = test::twelve_recordings();
  whole.push_back(test::time_recording(300'001));  // more than a pipe holds
  const Recordings read = run("read");
  test::expect_same(read.recordings, whole);
  ASSERT_EQ(read.warnings.size(), 2U);
  EXPECT_EQ(read.warnings[0].text, "a text\n");
}

TEST_F(ReadingProcessTest, ThrowsWhatItThrows) {
  const InputError input("a.h5: x", 3.0, "must be 4", "Make it so.");
  const FormatError format({"a.h5", 3, 7}, "this", "that");
  const FileError file("a.h5", "is away");
  EXPECT_EQ(message_of<InputError>([&] { return run("input"); }), input.what());
  EXPECT_EQ(message_of<FormatError>([&] { return run("format"); }), format.what());
  EXPECT_EQ(message_of<FileError>([&] { return run("file"); }), file.what());
  EXPECT_THROW((void)run("memory"), std::bad_alloc);
  try {
    (void)run("input");
  } catch (const InputError& error) {
    EXPECT_STREQ(error.renamed("y").what(), "y = 3; must be 4. Make it so.");
  }
  try {
    (void)run("format");
  } catch (const FormatError& error) {
    EXPECT_EQ(error.place().line, 3U);
  }
}

TEST_F(ReadingProcessTest, RefusesWhatCrashes) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGKILL}) {
    SCOPED_TRACE(signal);
    expect_damaged("signal", std::to_string(signal));
  }
  expect_damaged("exit");
  expect_damaged("other");
}

// Ctrl-C reaches the whole group of processes.
TEST_F(ReadingProcessTest, IsCancelledByTheTerminal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_THROW((void)run("signal", std::to_string(signal)), Cancelled);
  }
}

TEST_F(ReadingProcessTest, RefusesWhatRunsForEver) { expect_damaged("work", "", "does not end"); }

TEST_F(ReadingProcessTest, BoundsTheMemory) {
  if (test::kSanitized) {
    GTEST_SKIP() << "the address sanitizer ends a process that gets no memory";
  }
  EXPECT_THROW((void)run("take memory"), std::bad_alloc);
}

// Then there is no exit status to ask for.
TEST_F(ReadingProcessTest, NeedsNoExitStatus) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_NO_THROW((void)run("read"));
  expect_damaged("signal", std::to_string(SIGSEGV));
  (void)std::signal(SIGCHLD, before);
}

TEST_F(ReadingProcessTest, CanBeCancelled) {
  const auto stop = [](std::size_t, std::size_t) { return false; };
  EXPECT_THROW((void)run("wait", "", stop), Cancelled);
  EXPECT_THROW((void)run("tell", "", stop), Cancelled);
}

TEST_F(ReadingProcessTest, TellsTheProgress) {
  std::vector<std::size_t> reported;
  (void)run("tell twice", "", [&](std::size_t done, std::size_t total) {
    if (total == 2) reported.push_back(done);
    return true;
  });
  ASSERT_GE(reported.size(), 2U);
  EXPECT_EQ(reported.front(), 1U);
  EXPECT_EQ(reported.back(), 2U);
}

TEST_F(ReadingProcessTest, PrintsNothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  (void)run("print");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReadingProcessTest, WorksInManyThreads) {
  std::vector<std::thread> threads;
  std::vector<std::size_t> read(4);
  for (std::size_t i = 0; i < read.size(); ++i) {
    threads.emplace_back([&read, i] { read[i] = run("read").recordings.size(); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read, std::vector<std::size_t>(4, 13));
}

TEST_F(ReadingProcessTest, NeedsTheProgram) {
  EXPECT_EQ(message_of<FileError>(
                [] { return read_in_process<Recordings>({"/no/such/reader"}, "a.h5", {}); }),
            "a.h5: cannot be read in a process of its own: there is no program /no/such/reader");
}

TEST_F(ReadingProcessTest, OfHdf5IsOfTheSameVersion) {
  EXPECT_EQ(message_of<FileError>([] {
              return read_in_process<Recordings>(
                  {find_hdf5_reader(), "0.0.0", "recordings", "a.h5"}, "a.h5", {});
            }),
            "a.h5: cannot be read: microslip-hdf5-reader is of another version. Reinstall "
            "microslip and its library together.");
}

TEST_F(ReadingProcessTest, OfHdf5CanBeElsewhere) {
  setenv("MICROSLIP_HDF5_READER", "/no/such/reader", 1);
  EXPECT_EQ(find_hdf5_reader(), "/no/such/reader");
  unsetenv("MICROSLIP_HDF5_READER");
  EXPECT_NE(find_hdf5_reader(), "/no/such/reader");
}

}  // namespace
}  // namespace microslip::reading_process_test
