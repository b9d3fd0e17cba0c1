// SPDX-License-Identifier: MIT
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

/// @file
/// Loaded before the program (LD_PRELOAD): one system call on a file or folder below a folder fails
/// with EIO, as on a network disk that is gone; or a signal comes just before it. The environment
/// tells which:
///
///     MICROSLIP_FAILING_FOLDER  the folder, absolute and without links
///     MICROSLIP_FAILING_CALL    close, flock, fsync, link or rename
///     MICROSLIP_FAILING_NUMBER  the how manieth of them, from 1
///     MICROSLIP_FAILED          a file that is made when it has failed
///     MICROSLIP_FAILING_SIGNAL  the number of the signal that comes; without it, the call fails
///
/// Closing counts for what was opened to be written; what was only read loses nothing.

namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

bool is_below_folder(std::string_view path) {
  const std::string_view folder = variable("MICROSLIP_FAILING_FOLDER");
  return !folder.empty() && path.substr(0, folder.size()) == folder;
}

bool is_named_below_folder(const char* path) {
  std::error_code error;
  const auto folder =
      std::filesystem::canonical(std::filesystem::absolute(path, error).parent_path(), error);
  return !error && is_below_folder(folder.string());
}

bool is_below_folder(int file) {
  std::array<char, 4096> path{};
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t size = ::readlink(link.c_str(), path.data(), path.size());
  return size > 0 && is_below_folder(std::string_view(path.data(), static_cast<std::size_t>(size)));
}

bool is_written(int file) {
  const int flags = ::fcntl(file, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

/// Whether this call, which is of those that may, is the one that fails.
bool fails(std::string_view call) {
  static std::atomic<int> count{0};
  if (variable("MICROSLIP_FAILING_CALL") != call) return false;
  if (++count != std::atoi(std::getenv("MICROSLIP_FAILING_NUMBER"))) return false;
  (void)::creat(std::getenv("MICROSLIP_FAILED"), 0600);
  if (const char* signal = std::getenv("MICROSLIP_FAILING_SIGNAL")) {
    std::raise(std::atoi(signal));
    return false;
  }
  errno = EIO;
  return true;
}

/// The function of the system.
template <class F>
F* next(const char* name) {
  return reinterpret_cast<F*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int close(int file) {
  const bool counts = is_below_folder(file) && is_written(file);
  const int result = next<int(int)>("close")(file);
  return counts && fails("close") ? -1 : result;
}

/// As on a file system without locks.
int flock(int file, int operation) {
  if (is_below_folder(file) && fails("flock")) {
    errno = ENOLCK;
    return -1;
  }
  return next<int(int, int)>("flock")(file, operation);
}

int fsync(int file) {
  if (is_below_folder(file) && fails("fsync")) return -1;
  return next<int(int)>("fsync")(file);
}

int link(const char* from, const char* to) noexcept {
  if (is_named_below_folder(to) && fails("link")) return -1;
  return next<int(const char*, const char*)>("link")(from, to);
}

int rename(const char* from, const char* to) noexcept {
  if (is_named_below_folder(to) && fails("rename")) return -1;
  return next<int(const char*, const char*)>("rename")(from, to);
}
}
