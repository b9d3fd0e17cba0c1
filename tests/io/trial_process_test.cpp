// SPDX-License-Identifier: MIT
#include "microslip/io/trial_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

class TrialProcess : public testing::Test {
 protected:
  ~TrialProcess() override { EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left"; }

  void run(const std::function<void()>& read, const Progress& progress = {}) const {
    const Hdf5Session session;
    try_in_child(session, "a.h5", progress, read);
  }

  void expect_damaged(const std::function<void()>& read) const {
    EXPECT_EQ(test::message_of<FormatError>([&] {
                run(read);
                return 0;
              }),
              "a.h5: expected a whole HDF5 file, found one on which the HDF5 library fails. The "
              "file is damaged; save or copy it anew.");
  }
};

TEST_F(TrialProcess, GoesOnAfterAnEnd) {
  int here = 0;
  EXPECT_NO_THROW(run([&] { here = 1; }));
  EXPECT_NO_THROW(run([] { throw std::runtime_error("as the caller will"); }));
  EXPECT_EQ(here, 0) << "it ran in this process";
}

TEST_F(TrialProcess, RefusesWhatCrashes) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGKILL, SIGALRM}) {
    SCOPED_TRACE(signal);
    expect_damaged([signal] { (void)raise(signal); });
  }
  expect_damaged([] { _exit(0); });
}

TEST_F(TrialProcess, CallsNoHandlerOfTheProgram) {
  const auto before = std::signal(SIGSEGV, [](int) { _exit(0); });
  expect_damaged([] { (void)raise(SIGSEGV); });
  (void)std::signal(SIGSEGV, before);
}

TEST_F(TrialProcess, RefusesWhatRunsForEver) {
  expect_damaged([] {
    for (volatile int i = 0; i == 0;) {
    }
  });
}

// Then there is no exit status to ask for.
TEST_F(TrialProcess, NeedsNoExitStatus) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  EXPECT_NO_THROW(run([] {}));
  expect_damaged([] { (void)raise(SIGSEGV); });
  (void)std::signal(SIGCHLD, before);
}

TEST_F(TrialProcess, CanBeCancelled) {
  const auto wait_for_ever = [] {
    for (;;) pause();
  };
  EXPECT_THROW(run(wait_for_ever, [](std::size_t, std::size_t) { return false; }), Cancelled);
}

TEST_F(TrialProcess, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run([] {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) (void)!write(stream, "x", 1);
  });
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace microslip
