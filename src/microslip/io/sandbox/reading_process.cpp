// SPDX-License-Identifier: MIT
#include "microslip/io/sandbox/reading_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/child_process.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/sandbox/reading_messages.hpp"

namespace microslip {
namespace {

constexpr int kBetweenLooks = 100;  // ms
constexpr int kPipeSize = 1 << 20;
constexpr int kEndedBySignal = 128;

/// An error of the other process: its message stands as it is.
template <class Base>
class Received : public Base {
 public:
  Received(std::string text, Base base) : Base(std::move(base)), text_(std::move(text)) {}
  [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

[[noreturn]] void fail_to_begin(const std::string& path, const std::string& reason) {
  throw FileError(path, "cannot be read in a process of its own: " + reason);
}

[[noreturn]] void fail_as_damaged(const std::string& path, std::string_view how) {
  throw FormatError({.file = path}, "a whole HDF5 file",
                    fmt::format("one on which the HDF5 library {}", how),
                    "The file is damaged; save or copy it again.");
}

[[noreturn]] void throw_received(ReadingError error, const std::string& path) {
  switch (error.kind) {
    case ReadingErrorKind::kOfInput:
      throw Received(std::move(error.text), InputError(error.name, "", ""));
    case ReadingErrorKind::kOfFormat:
      throw Received(std::move(error.text), FormatError(error.place, "", ""));
    case ReadingErrorKind::kOfFile:
      throw Received(std::move(error.text), FileError(path, ""));
    case ReadingErrorKind::kOfMemory:
      throw std::bad_alloc();
    default:
      fail_as_damaged(path, "fails");
  }
}

/// The program has ended before its last message.
struct Gone {};

/// Messages of the program, while the caller is asked whether to go on.
class Answer {
 public:
  Answer(const FileDescriptor& pipe, const Progress& progress, std::size_t bytes)
      : pipe_(pipe), progress_(progress), total_(bytes) {}

  void take(const std::string& path, const std::function<void(ParcelReader& from)>& take_result) {
    ParcelReader from([this](char* data, std::size_t size) { fill(data, size); });
    for (;;) {
      ReadingMessage message{};
      pass(from, message);
      switch (message) {
        case ReadingMessage::kProgress:
          pass(from, done_);
          pass(from, total_);
          ask();
          break;
        case ReadingMessage::kResult:
          take_result(from);
          pass(from, message);
          if (message != ReadingMessage::kEnd) throw Gone{};
          return;
        case ReadingMessage::kError: {
          ReadingError error;
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

[[noreturn]] void fail_as_ended(const std::string& path, int status) {
  switch (status - kEndedBySignal) {
    case SIGINT:
    case SIGTERM:
    case SIGHUP:
      throw Cancelled();
    case SIGXCPU:
    case SIGALRM:
      fail_as_damaged(path, "does not end");
    default:
      fail_as_damaged(path, "fails");
  }
}

/// A started program and the end of the pipe that it writes to.
struct Reading {
  Child program;
  FileDescriptor pipe;
};

Reading start(const std::vector<std::string>& command, const std::string& path) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) fail_to_begin(path, std::strerror(errno));
  FileDescriptor ours(ends[0]);
  const FileDescriptor its(ends[1]);
  fcntl(its.number(), F_SETPIPE_SZ, kPipeSize);  // fewer switches; it works without
  const FileDescriptor nothing(open("/dev/null", O_RDWR | O_CLOEXEC));
  if (!nothing.is_open()) fail_to_begin(path, std::strerror(errno));
  try {
    auto child = Child::start(command, {nothing.number(), its.number(), nothing.number()});
    if (child) return {*std::move(child), std::move(ours)};
  } catch (const Error& error) {
    fail_to_begin(path, error.what());
  }
  fail_to_begin(path, fmt::format("there is no program {}", command.front()));
}

}  // namespace

void run_reading_process(const std::vector<std::string>& command, const std::string& path,
                         const Progress& progress,
                         const std::function<void(ParcelReader& from)>& take) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  Reading reading = start(command, path);
  try {
    Answer(reading.pipe, progress, unknown ? 0 : size).take(path, take);
  } catch (const Gone&) {
    fail_as_ended(path, reading.program.wait());
  }
  (void)reading.program.wait();
}

}  // namespace microslip
