// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/reading_worker.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/sandbox/reading_messages.hpp"

namespace microslip {
namespace {

constexpr std::uintmax_t kSecondsToWait = 60;  // a disk may sleep
constexpr std::uintmax_t kSecondsToWork = 2;   // a stalled virtual machine counts its stall as work
constexpr std::uintmax_t kLongestLimit = 86400;
constexpr std::uintmax_t kMemory = std::uintmax_t{512} << 20U;
constexpr std::uintmax_t kMemoryOfByte = 16;
/// Deflate makes no more than 1040 of one byte (RFC 1951); some values are looked at twice.
constexpr std::uintmax_t kMostOfByte = 2080;

/// Limits of the process beyond its initial use; null before run_reading_worker().
struct Limits {
  rlim_t seconds = 0;
  rlim_t memory = 0;  ///< all that it had at its start, too
  std::uintmax_t expected = 0;
  std::uintmax_t most_expected = 0;
};
Limits* limits_of_worker = nullptr;

/// Whatever was ignored or blocked by the program that started this one.
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
  limits_of_worker = &limits;
  apply(limits);
  alarm(static_cast<unsigned>(kSecondsToWait + std::min(bytes >> 20U, kLongestLimit)));
  // 1 byte: with 0, Linux still hands the core to a program that collects them, see core(5).
  set_limit(RLIMIT_CORE, 1);
}

/// Standard output for what is sent alone; others print to /dev/null from now on.
FileDescriptor take_standard_output() {
  FileDescriptor pipe(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3));
  const FileDescriptor nowhere(open("/dev/null", O_WRONLY | O_CLOEXEC));
  if (!pipe.is_open() || !nowhere.is_open()) _exit(1);
  dup2(nowhere.number(), STDOUT_FILENO);
  return pipe;
}

/// Ends the process when the reader has closed the pipe.
void send(int pipe, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::write(pipe, data, size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) _exit(1);
    data += count;
    size -= static_cast<std::size_t>(count);
  }
}

ReadingError current_error() {
  try {
    throw;
  } catch (const InputError& error) {
    return {.kind = ReadingErrorKind::kOfInput, .text = error.what(), .name = error.name()};
  } catch (const FormatError& error) {
    return {.kind = ReadingErrorKind::kOfFormat, .text = error.what(), .place = error.place()};
  } catch (const FileError& error) {
    return {.kind = ReadingErrorKind::kOfFile, .text = error.what()};
  } catch (const std::bad_alloc&) {
    return {.kind = ReadingErrorKind::kOfMemory};
  } catch (...) {
    return {};
  }
}

}  // namespace

int run_reading_worker(const std::string& path, const ReadingWork& work) {
  for (const int signal : {SIGALRM, SIGXCPU, SIGPIPE}) die_of(signal);
  const FileDescriptor pipe = take_standard_output();
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  Limits limits;
  set_limits(limits, unknown ? 0 : size);
  ParcelWriter to([&](const char* data, std::size_t count) { send(pipe.number(), data, count); });
  const auto put = [&](ReadingMessage message) { pass(to, message); };
  try {
    work.read([&](std::size_t done, std::size_t total) {
      put(ReadingMessage::kProgress);
      pass(to, done);
      pass(to, total);
      to.flush();
      return true;
    });
    put(ReadingMessage::kResult);
    work.give(to);
  } catch (...) {
    ReadingError error = current_error();
    put(ReadingMessage::kError);
    pass(to, error);
  }
  put(ReadingMessage::kEnd);
  to.flush();
  limits_of_worker = nullptr;
  return 0;
}

void expect_to_read(std::size_t bytes) {
  if (limits_of_worker == nullptr) return;
  Limits& limits = *limits_of_worker;
  limits.expected += std::min<std::uintmax_t>(bytes, limits.most_expected - limits.expected);
  apply(limits);
}

}  // namespace microslip
