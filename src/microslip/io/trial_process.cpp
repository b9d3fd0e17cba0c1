// SPDX-License-Identifier: MIT
#include "microslip/io/trial_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/file_descriptor.hpp"

namespace microslip {
namespace {

constexpr std::uintmax_t kSecondsToWait = 60;  // a disk may sleep
constexpr std::uintmax_t kSecondsToWork = 3;   // some 2 GB of memory where it runs wild
constexpr std::uintmax_t kLongestLimit = 86400;
constexpr int kBetweenLooks = 100;  // ms

[[noreturn]] void fail_to_start(const std::string& path, int error) {
  throw FileError(path,
                  fmt::format("cannot be tried in a process of its own: {}", std::strerror(error)));
}

/// Ends by the signal, whatever the program has set up: no handler of its own, no report.
void die_of(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

/// Of work, so that a slow disk or a busy machine does not count; and, far more, of waiting.
void limit_time(std::uintmax_t bytes) {
  const std::uintmax_t more = std::min(bytes >> 20U, kLongestLimit);
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) == 0) {
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, kSecondsToWork + more);
    setrlimit(RLIMIT_CPU, &limit);
  }
  alarm(static_cast<unsigned>(kSecondsToWait + more));
}

void leave_no_core() {
  rlimit limit{};
  if (getrlimit(RLIMIT_CORE, &limit) != 0) return;
  // 1 byte: with 0, Linux still hands the core to a program that collects them, see core(5).
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 1);
  setrlimit(RLIMIT_CORE, &limit);
}

void print_nothing() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    if (nowhere < 0) {
      ::close(stream);
    } else {
      dup2(nowhere, stream);
    }
  }
}

/// What the child does: it tells that it came to an end.
[[noreturn]] void run_trial(const FileDescriptor& verdict, std::uintmax_t bytes,
                            const std::function<void()>& read) noexcept {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU})
    die_of(signal);
  leave_no_core();
  print_nothing();
  limit_time(bytes);
  try {
    read();
  } catch (...) {  // NOLINT(bugprone-empty-catch): the parent meets it as well
  }
  const char done = 1;
  _exit(write(verdict.number(), &done, 1) == 1 ? 0 : 1);
}

/// Reaps the child, which is killed where nobody has waited for its end.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (!ended_) kill(id_, SIGKILL);
    while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  /// True where it tells that it came to an end. Its exit status would not do: there is none where
  /// the program ignores SIGCHLD.
  bool wait(const FileDescriptor& verdict, const Progress& progress, std::size_t bytes) {
    pollfd ready{verdict.number(), POLLIN, 0};
    while (poll(&ready, 1, kBetweenLooks) <= 0) {
      if (progress && !progress(0, bytes)) throw Cancelled();
    }
    char done = 0;
    ssize_t count = -1;
    do {
      count = read(verdict.number(), &done, 1);
    } while (count < 0 && errno == EINTR);
    ended_ = true;
    return count == 1;
  }

 private:
  pid_t id_;
  bool ended_ = false;
};

}  // namespace

void try_in_child(const Hdf5Session& /*session*/, const std::string& path, const Progress& progress,
                  const std::function<void()>& read) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  const std::size_t bytes = unknown ? 0 : size;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(path, errno);
  const FileDescriptor ours(ends[0]);
  FileDescriptor childs(ends[1]);
  const pid_t id = fork();
  if (id < 0) fail_to_start(path, errno);
  if (id == 0) run_trial(childs, bytes, read);
  Child child(id);
  childs.close();
  if (child.wait(ours, progress, bytes)) return;
  throw FormatError({.file = path}, "a whole HDF5 file", "one on which the HDF5 library fails",
                    "The file is damaged; save or copy it anew.");
}

}  // namespace microslip
