// SPDX-License-Identifier: MIT
#include "microslip/io/output/write_error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace microslip {
namespace {

/// Another path would do; for all else see remedy_for_system().
std::string_view remedy_for_path(int error) {
  switch (error) {
    case ENOENT:
      return "Create the folder first.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "Choose a folder that you may write to.";
    case ENAMETOOLONG:
      return "Choose a shorter name.";
    case ENOTDIR:
    case EISDIR:
    case ELOOP:
    case EEXIST:
      return "Choose another name.";
    default:
      return {};
  }
}

std::string_view remedy_for_system(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "Free some space, or choose another folder.";
    case EFBIG:
      return "Raise the limit of the size of files (ulimit -f), or choose another folder.";
    case EIO:
      return "Check the disk, or choose another folder.";
    default:
      return {};
  }
}

/// Pipes, terminals and some file systems have nothing to bring to a disk.
bool cannot_be_synced(int error) {
  return error == EINVAL || error == ENOTSUP || error == EROFS || error == ENOSYS;
}

}  // namespace

bool is_fault_of_path(int error) { return !remedy_for_path(error).empty(); }

void fail_to_write(std::string_view path, int error) {
  const std::string reason =
      fmt::format("cannot be written: {}", std::generic_category().message(error));
  if (is_fault_of_path(error)) throw FileError(path, reason, remedy_for_path(error));
  throw WriteError(path, reason, remedy_for_system(error));
}

void sync_file(int descriptor, std::string_view path) {
  int result = 0;
  do {
    result = ::fsync(descriptor);
  } while (result != 0 && errno == EINTR);
  if (result != 0 && !cannot_be_synced(errno)) fail_to_write(path, errno);
}

void close_copy(int descriptor, std::string_view path) {
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (copy >= 0 && ::close(copy) != 0) fail_to_write(path, errno);
}

}  // namespace microslip
