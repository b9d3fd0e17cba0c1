// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::child_process_test {
namespace {

ChildResult run(std::vector<std::string> command, std::string_view input = {}) {
  auto result = run_child(std::move(command), input);
  EXPECT_TRUE(result.has_value());
  return result.value_or(ChildResult{});
}

// More than any pipe or socket buffers, so that both sides have to take turns.
std::string much() {
  std::string text;
  for (int i = 0; i < 1000000; ++i) text += std::to_string(i) + '\n';
  return text;
}

TEST(ChildProcess, ReturnsWhatIsWritten) {
  const ChildResult result = run({"sh", "-c", "cat; echo wrong >&2; exit 3"}, "right");
  EXPECT_EQ(result.output, "right");
  EXPECT_EQ(result.errors, "wrong\n");
  EXPECT_EQ(result.status, 3);
}

TEST(ChildProcess, LargeInputAndOutputAtTheSameTime) {
  const std::string text = much();
  // Not EXPECT_EQ, which would print them.
  EXPECT_TRUE(run({"cat"}, text).output == text);
  EXPECT_TRUE(run({"sh", "-c", "cat >&2"}, text).errors == text);
}

TEST(ChildProcess, TheChildNeedNotReadItsInput) {
  const std::string text = much();
  EXPECT_EQ(run({"true"}, text).status, 0);
  EXPECT_EQ(run({"sh", "-c", "exec <&-; echo early"}, text).output, "early\n");
}

TEST(ChildProcess, ArgumentsReachNoShell) {
  EXPECT_EQ(run({"printf", "%s|", "$(id)", "; exit 1", "'"}).output, "$(id)|; exit 1|'|");
}

TEST(ChildProcess, NothingWithoutTheProgram) {
  EXPECT_FALSE(run_child({"no-such-program-of-microslip"}, "").has_value());
  EXPECT_THROW((void)run_child({"/etc/passwd"}, ""), Error);  // no program
}

TEST(ChildProcess, ASignalIsAStatus) {
  EXPECT_EQ(run({"sh", "-c", "kill -9 $$"}).status, 128 + SIGKILL);
}

TEST(ChildProcess, LeavesNoChildBehind) {
  (void)run({"true"});
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, WorksInManyThreads) {
  std::vector<std::thread> threads;
  std::vector<std::string> outputs(8);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    threads.emplace_back([&outputs, i] {
      for (int k = 0; k < 10; ++k) outputs[i] += run({"cat"}, std::to_string(i)).output;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    EXPECT_EQ(outputs[i], std::string(10, static_cast<char>('0' + i)));
  }
}

// A program may run with its standard streams closed: the sockets then get their numbers.
TEST(ChildProcess, WorksWithClosedStandardStreams) {
  const pid_t id = fork();
  ASSERT_GE(id, 0);
  if (id == 0) {
    for (const int stream : {0, 1, 2}) close(stream);
    const auto result = run_child({"sh", "-c", "cat; echo wrong >&2"}, "right");
    _exit(result && result->output == "right" && result->errors == "wrong\n" ? 0 : 1);
  }
  int state = 0;
  ASSERT_EQ(waitpid(id, &state, 0), id);
  EXPECT_EQ(state, 0);
}

}  // namespace
}  // namespace microslip::child_process_test
