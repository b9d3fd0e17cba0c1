// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/open_input.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_name.hpp"

namespace microslip {
namespace {

std::string_view remedy_for_missing(const std::string& name) {
  if (name.find_first_of("*?") != std::string::npos) {
    return "No file fits this pattern: check the folder.";
  }
  if (name.starts_with('\'') || name.starts_with('"')) return "Its quotes are part of the name.";
  return "Check the path.";
}

std::string_view remedy_for_reading(const std::string& name, int error) {
  switch (error) {
    case ENOENT:
      return remedy_for_missing(name);
    case ENOTDIR:
      return "A part of the path is a file, not a folder.";
    case EACCES:
      return "Get permission to read it.";
    default:
      return {};
  }
}

}  // namespace

void fail_reading(const std::string& name, int error) {
  throw FileError(name, fmt::format("cannot be read: {}", std::generic_category().message(error)),
                  remedy_for_reading(name, error));
}

FileDescriptor open_input(const std::string& path) {
  if (path.find('\0') != std::string::npos) {
    throw FileError(path.c_str(), "cannot be read: the path contains a zero byte");
  }
  FileDescriptor file(path == "-" ? ::dup(STDIN_FILENO)
                                  : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail_reading(input_name(path), errno);
  return file;
}

std::optional<std::size_t> regular_size(const FileDescriptor& file, const std::string& name) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail_reading(name, errno);
  if (S_ISDIR(status.st_mode)) throw FileError(name, "is a folder", "Name a file in it.");
  if (!S_ISREG(status.st_mode)) return std::nullopt;
  return static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
}

}  // namespace microslip
