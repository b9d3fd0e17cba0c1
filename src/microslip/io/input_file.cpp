// SPDX-License-Identifier: MIT
#include "microslip/io/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/file_descriptor.hpp"

namespace microslip {
namespace {

std::string_view remedy_for(int error) {
  switch (error) {
    case ENOENT:
      return "Check the path.";
    case ENOTDIR:
      return "A part of the path is a file, not a folder.";
    case EACCES:
      return "Ask for the right to read it.";
    default:
      return {};
  }
}

[[noreturn]] void fail(const std::string& name, int error) {
  throw FileError(name, fmt::format("cannot be read: {}", std::generic_category().message(error)),
                  remedy_for(error));
}

FileDescriptor open_input(const std::string& path) {
  if (path.find('\0') != std::string::npos) {
    throw FileError(path.c_str(), "cannot be read: the path holds a zero byte");
  }
  FileDescriptor file(path == "-" ? ::dup(STDIN_FILENO)
                                  : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail(input_name(path), errno);
  return file;
}

struct stat status_of(const FileDescriptor& file, const std::string& name) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail(name, errno);
  if (S_ISDIR(status.st_mode)) throw FileError(name, "is a folder", "Name a file in it.");
  return status;
}

/// Reads until `size` bytes are there or the file ends; returns how many are.
std::size_t read_some(const FileDescriptor& file, const std::string& name, char* buffer,
                      std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count = ::read(file.number(), buffer + done, size - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(name, errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

[[noreturn]] void fail_too_large(const std::string& name, std::size_t limit) {
  throw FileError(name, fmt::format("is larger than {} bytes", limit), "Is it the right file?");
}

std::string read_all(const FileDescriptor& file, const std::string& name, std::size_t expected,
                     std::size_t limit) {
  std::string content;
  std::size_t done = 0;
  // One byte more than expected, so that the end is seen without another round.
  for (std::size_t size = std::max<std::size_t>(expected, 65535) + 1;; size = 2 * size) {
    content.resize(std::min(size, limit + 1));
    done += read_some(file, name, content.data() + done, content.size() - done);
    if (done > limit) fail_too_large(name, limit);
    if (done < content.size()) break;
  }
  content.resize(done);
  return content;
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string read_file(const std::string& path, std::size_t limit) {
  const std::string name = input_name(path);
  const FileDescriptor file = open_input(path);
  const struct stat status = status_of(file, name);
  const std::size_t expected =
      S_ISREG(status.st_mode) ? static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) : 0;
  if (expected > limit) fail_too_large(name, limit);
  try {
    return read_all(file, name, expected, limit);
  } catch (const std::bad_alloc&) {
    throw FileError(name, "does not fit into memory");
  }
}

std::string read_file_head(const std::string& path, std::size_t size) {
  const std::string name = input_name(path);
  const FileDescriptor file = open_input(path);
  status_of(file, name);
  std::string content(size, '\0');
  content.resize(read_some(file, name, content.data(), size));
  return content;
}

}  // namespace microslip
