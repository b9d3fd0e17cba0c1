// SPDX-License-Identifier: MIT
#include "microslip/io/reading_process.hpp"

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
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/file_descriptor.hpp"

namespace microslip {
namespace {

constexpr std::uintmax_t kSecondsToWait = 60;  // a disk may sleep
constexpr std::uintmax_t kSecondsToWork = 2;   // a stalled virtual machine counts its stall as work
constexpr std::uintmax_t kLongestLimit = 86400;
constexpr std::uintmax_t kMemory = std::uintmax_t{512} << 20U;
constexpr std::uintmax_t kMemoryOfByte = 16;
/// Deflate makes no more than 1040 of one byte (RFC 1951); some values are looked at twice.
constexpr std::uintmax_t kMostOfByte = 2080;
constexpr int kBetweenLooks = 100;  // ms
constexpr int kPipeSize = 1 << 20;

/// What the copy sends, each after one of these.
enum class Message : char { kProgress = 'p', kResult = 'r', kError = 'e', kEnd = 'd' };
enum class ErrorKind : char { kOfInput, kOfFormat, kOfFile, kOfMemory, kOther };

/// An error of the copy: its message stands as it is.
template <class Base>
class Received : public Base {
 public:
  Received(std::string text, Base base) : Base(std::move(base)), text_(std::move(text)) {}
  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

struct ErrorText {
  ErrorKind kind = ErrorKind::kOther;
  std::string text;
  std::string name;  ///< of an InputError
  TextPlace place;   ///< of a FormatError
};

template <class Parcel>
void pass(Parcel& parcel, ErrorText& error) {
  pass(parcel, error.kind);
  pass(parcel, error.text);
  pass(parcel, error.name);
  pass(parcel, error.place.file);
  pass(parcel, error.place.line);
  pass(parcel, error.place.column);
}

[[noreturn]] void fail_to_start(const std::string& path, int error) {
  throw FileError(path,
                  fmt::format("cannot be read in a process of its own: {}", std::strerror(error)));
}

[[noreturn]] void fail_as_damaged(const std::string& path, std::string_view how) {
  throw FormatError({.file = path}, "a whole HDF5 file",
                    fmt::format("one on which the HDF5 library {}", how),
                    "The file is damaged; save or copy it anew.");
}

[[noreturn]] void throw_received(ErrorText error, const std::string& path) {
  switch (error.kind) {
    case ErrorKind::kOfInput:
      throw Received(std::move(error.text), InputError(error.name, "", ""));
    case ErrorKind::kOfFormat:
      throw Received(std::move(error.text), FormatError(error.place, "", ""));
    case ErrorKind::kOfFile:
      throw Received(std::move(error.text), FileError(path, ""));
    case ErrorKind::kOfMemory:
      throw std::bad_alloc();
    default:
      fail_as_damaged(path, "fails");
  }
}

// In the copy -------------------------------------------------------------------------------------

/// What the copy may use beyond what its start gave it; null in every other process.
struct Limits {
  rlim_t seconds = 0;
  rlim_t memory = 0;  ///< all that it had at its start, too
  std::uintmax_t expected = 0;
  std::uintmax_t most_expected = 0;
};
Limits* limits_of_copy = nullptr;

/// Ends by the signal, whatever the program has set up: no handler of its own, no report.
void die_of(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void set_limit(int resource, rlim_t value) {
  const auto kind = static_cast<__rlimit_resource_t>(resource);
  rlimit limit{};
  if (getrlimit(kind, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, value);
  setrlimit(kind, &limit);
}

/// The address space of this process; the sanitizers reserve a great deal of it.
rlim_t memory_now() {
  const FileDescriptor file(open("/proc/self/statm", O_RDONLY | O_CLOEXEC));
  std::array<char, 32> text{};
  if (!file.is_open() || ::read(file.number(), text.data(), text.size() - 1) <= 0) return 0;
  return std::strtoull(text.data(), nullptr, 10) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// Time of work, so that a slow disk or a busy machine does not count; and, far more, of waiting.
void apply(const Limits& limits) {
  set_limit(RLIMIT_CPU, limits.seconds + std::min(limits.expected >> 25U, kLongestLimit));
  if (limits.memory > 0) set_limit(RLIMIT_AS, limits.memory + 2 * limits.expected);
}

void set_limits(Limits& limits, std::uintmax_t bytes) {
  limits.seconds = kSecondsToWork + std::min(bytes >> 22U, kLongestLimit);
  const rlim_t now = memory_now();
  if (now > 0) limits.memory = now + kMemory + kMemoryOfByte * bytes;
  limits.most_expected = bytes * kMostOfByte;
  limits_of_copy = &limits;
  apply(limits);
  alarm(static_cast<unsigned>(kSecondsToWait + std::min(bytes >> 20U, kLongestLimit)));
}

void leave_no_core() {
  // 1 byte: with 0, Linux still hands the core to a program that collects them, see core(5).
  set_limit(RLIMIT_CORE, 1);
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

/// Ends the copy where nobody reads any more.
void send(int pipe, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::write(pipe, data, size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) _exit(1);
    data += count;
    size -= static_cast<std::size_t>(count);
  }
}

ErrorText text_of_current_error() {
  try {
    throw;
  } catch (const InputError& error) {
    return {.kind = ErrorKind::kOfInput, .text = error.what(), .name = error.name(), .place = {}};
  } catch (const FormatError& error) {
    return {.kind = ErrorKind::kOfFormat, .text = error.what(), .name = {}, .place = error.place()};
  } catch (const FileError& error) {
    return {.kind = ErrorKind::kOfFile, .text = error.what(), .name = {}, .place = {}};
  } catch (const std::bad_alloc&) {
    return {.kind = ErrorKind::kOfMemory, .text = {}, .name = {}, .place = {}};
  } catch (...) {
    return {};
  }
}

[[noreturn]] void run_copy(const FileDescriptor& pipe, std::uintmax_t bytes,
                           const ReadingProcess& process) noexcept {
  for (const int signal :
       {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGALRM, SIGXCPU, SIGPIPE}) {
    die_of(signal);
  }
  leave_no_core();
  print_nothing();
  Limits limits;
  set_limits(limits, bytes);
  ParcelWriter to([&](const char* data, std::size_t size) { send(pipe.number(), data, size); });
  const auto put = [&](Message message) { pass(to, message); };
  try {
    process.read([&](std::size_t done, std::size_t total) {
      put(Message::kProgress);
      pass(to, done);
      pass(to, total);
      to.flush();
      return true;
    });
    put(Message::kResult);
    process.give(to);
  } catch (...) {
    ErrorText error = text_of_current_error();
    put(Message::kError);
    pass(to, error);
  }
  put(Message::kEnd);
  to.flush();
  _exit(0);
}

// In the process that started it ------------------------------------------------------------------

/// Reaps the copy, which is killed where nobody has waited for its end.
class Copy {
 public:
  explicit Copy(pid_t id) : id_(id) {}
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  ~Copy() {
    if (id_ < 0) return;
    kill(id_, SIGKILL);
    (void)wait();
  }

  /// The signal that ended it; 0 where none did, or where the program ignores SIGCHLD and cannot
  /// know it.
  int wait() {
    int state = 0;
    pid_t id = -1;
    do {
      id = waitpid(id_, &state, 0);
    } while (id < 0 && errno == EINTR);
    id_ = -1;
    return id >= 0 && WIFSIGNALED(state) ? WTERMSIG(state) : 0;
  }

 private:
  pid_t id_;
};

/// The copy is gone before it has said all.
struct Gone {};

/// What the copy sends, while the caller is asked whether to go on.
class Answer {
 public:
  Answer(const FileDescriptor& pipe, const Progress& progress, std::size_t bytes)
      : pipe_(pipe), progress_(progress), total_(bytes) {}

  void take(const std::string& path, const ReadingProcess& process) {
    ParcelReader from([this](char* data, std::size_t size) { fill(data, size); });
    for (;;) {
      Message message{};
      pass(from, message);
      switch (message) {
        case Message::kProgress:
          pass(from, done_);
          pass(from, total_);
          ask();
          break;
        case Message::kResult:
          process.take(from);
          pass(from, message);
          if (message != Message::kEnd) throw Gone{};
          return;
        case Message::kError: {
          ErrorText error;
          pass(from, error);
          throw_received(std::move(error), path);
        }
        default:
          throw Gone{};
      }
    }
  }

 private:
  void ask() const {
    if (progress_ && !progress_(done_, total_)) throw Cancelled();
  }

  void fill(char* data, std::size_t size) {
    while (size > 0) {
      pollfd ready{pipe_.number(), POLLIN, 0};
      if (poll(&ready, 1, kBetweenLooks) <= 0) {
        ask();
        continue;
      }
      const ssize_t count = ::read(pipe_.number(), data, size);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) throw Gone{};
      data += count;
      size -= static_cast<std::size_t>(count);
    }
  }

  const FileDescriptor& pipe_;
  const Progress& progress_;
  std::size_t done_ = 0;
  std::size_t total_;
};

}  // namespace

void run_reading_process(const Hdf5Session& /*session*/, const std::string& path,
                         const Progress& progress, const ReadingProcess& process) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  const std::size_t bytes = unknown ? 0 : size;
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_start(path, errno);
  const FileDescriptor ours(ends[0]);
  FileDescriptor copys(ends[1]);
  fcntl(copys.number(), F_SETPIPE_SZ, kPipeSize);  // fewer switches; it works without
  const pid_t id = fork();
  if (id < 0) fail_to_start(path, errno);
  if (id == 0) run_copy(copys, bytes, process);
  Copy copy(id);
  copys.close();
  try {
    Answer(ours, progress, bytes).take(path, process);
  } catch (const Gone&) {
    const int signal = copy.wait();
    const bool late = signal == SIGXCPU || signal == SIGALRM;
    fail_as_damaged(path, late ? "does not come to an end" : "fails");
  }
  (void)copy.wait();
}

void expect_to_read(std::size_t bytes) {
  if (limits_of_copy == nullptr) return;
  Limits& limits = *limits_of_copy;
  limits.expected += std::min<std::uintmax_t>(bytes, limits.most_expected - limits.expected);
  apply(limits);
}

}  // namespace microslip
