// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "cli/run_program.hpp"
#include "cli/samples.hpp"

/// Stopped at any time, the program leaves what was there and nothing of its own.

namespace microslip::cli_test::interruption_test {
namespace {

Sandbox sandbox() {
  return Sandbox{{"levels.csv", sample_levels_text()},
                 {"joint.json", R"({"schema": "microslip.joint/1", "program": "microslip"})"},
                 {"density.csv", "# microslip 0: old\nslip_force [N],density [1/N]\n0,0.1\n"}};
}

Arguments with_bands(std::size_t count) {
  return {"identify",   "levels.csv", "--stiffness",         "1.7e5",         "--out",
          "joint.json", "--bands",    std::to_string(count), "--density-csv", "density.csv"};
}

TEST(Interruption, InALongComputation) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Sandbox box = sandbox();
    expect_interruptible(box, with_bands(1'000'000), signal);
  }
}

/// A pipe that is full, so that whoever writes to it waits until it is read.
class FullPipe {
 public:
  FullPipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    ::fcntl(ends_[1], F_SETFL, O_NONBLOCK);
    const std::string block(4096, '#');
    while (::write(ends_[1], block.data(), block.size()) > 0) {
    }
    ::fcntl(ends_[1], F_SETFL, 0);
  }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;
  ~FullPipe() {
    close_reader();
    close_writer();
  }

  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_writer() { close(ends_[1]); }
  void close_reader() { close(ends_[0]); }

  /// To the end; every writer must be closed.
  std::string read() {
    std::string text;
    std::string block(4096, '\0');
    for (;;) {
      const ssize_t count = ::read(ends_[0], block.data(), block.size());
      if (count <= 0) return text.substr(text.find_first_not_of('#'));
      text.append(block, 0, static_cast<std::size_t>(count));
    }
  }

 private:
  static void close(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }

  int ends_[2] = {-1, -1};
};

const Arguments kToPipe{"identify", "levels.csv",    "--stiffness", "1.7e5",  "--out",
                        "-",        "--density-csv", "new.csv",     "--quiet"};

/// Waits until the density lies in the folder under its temporary name: from then on the program
/// hangs in the pipe.
void wait_for_temporary(const Sandbox& box, const Running& program) {
  const std::size_t before = 3;
  while (box.content().size() <= before && !program.has_ended()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_FALSE(program.has_ended()) << "it must wait for the reader";
  ASSERT_FALSE(box.has("new.csv")) << "it has its name only when all is written";
}

TEST(Interruption, WhileTemporariesAreThere) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Sandbox box = sandbox();
    const auto before = box.content();
    const FullPipe pipe;
    Running program(kToPipe, box.path(), {.standard_output = pipe.writer()});
    wait_for_temporary(box, program);
    program.send(signal);
    EXPECT_EQ(program.wait().signal, signal);
    EXPECT_TRUE(box.content() == before);
  }
}

TEST(Interruption, ByAReaderThatGoesAway) {
  const Sandbox box = sandbox();
  const auto before = box.content();
  FullPipe pipe;
  Running program(kToPipe, box.path(), {.standard_output = pipe.writer()});
  wait_for_temporary(box, program);
  pipe.close_reader();
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "microslip: standard output: cannot be written: Broken pipe\n");
  EXPECT_TRUE(box.content() == before);
}

TEST(Interruption, IgnoredWhereTheCallerSaysSo) {
  const Sandbox box = sandbox();
  FullPipe pipe;
  Running program(kToPipe, box.path(),
                  {.standard_output = pipe.writer(), .ignored_signal = SIGHUP});
  wait_for_temporary(box, program);
  program.send(SIGHUP);
  pipe.close_writer();
  const std::string written = pipe.read();
  EXPECT_EQ(program.wait().status, 0);
  EXPECT_EQ(parse_joint(written, "out").joint.stiffness(), 1.7e5);
  EXPECT_TRUE(box.has("new.csv"));
}

}  // namespace
}  // namespace microslip::cli_test::interruption_test
