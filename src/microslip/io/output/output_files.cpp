// SPDX-License-Identifier: MIT
#include "microslip/io/output/output_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/kinds/own_file.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/output/postponed_signals.hpp"
#include "microslip/io/output/write_error.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// Of the name that the old file has while it is replaced.
constexpr const char* kOldSuffix = ".old";
/// Of the name of a file until it has its own.
constexpr std::string_view kStagedEnding = ".tmp";

[[noreturn]] void fail_twice(std::string_view path) {
  throw FileError(path, "would be written twice", "Choose different names.");
}

[[noreturn]] void fail_twice_on_standard_output() {
  throw FileError(kStandardOutput, "would be written twice", "Name a file for one of them.");
}

std::string folder_of(const std::string& target) {
  const std::string folder = fs::path(target).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The file behind a link, so that writing to the link does not replace it.
std::string behind_links(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return path;
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  if (error) throw FileError(path, "is a broken link", "Remove it or choose another name.");
  return target.string();
}

/// Of two names of one file, or of one that is to be.
bool is_same_file(const std::string& a, const std::string& b) {
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

void check_folder(const std::string& path, const std::string& target) {
  const std::string folder = folder_of(target);
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) {
    if (errno != ENOENT) fail_to_write(path, errno);
    throw FileError(path, fmt::format("cannot be written: there is no folder '{}'", folder),
                    "Create it first.");
  }
  if (!S_ISDIR(status.st_mode)) {
    throw FileError(path, fmt::format("cannot be written: '{}' is not a folder", folder),
                    "Choose another name.");
  }
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
    fail_to_write(path, errno);
}

/// Where a path leads, and what is there to be replaced.
struct OutputTarget {
  std::string file;
  std::optional<struct stat> replaced;
};

void check_replaceable(const std::string& path, const OutputTarget& target) {
  if (!target.replaced) return;
  if (S_ISDIR(target.replaced->st_mode)) {
    throw FileError(path, "is a folder and cannot be replaced", "Name a file in it.");
  }
  if (!S_ISREG(target.replaced->st_mode)) {
    throw FileError(path, "is not a regular file and cannot be replaced",
                    "Write to - and redirect standard output.");
  }
  if (::faccessat(AT_FDCWD, target.file.c_str(), W_OK, AT_EACCESS) != 0) {
    throw FileError(path, "is not writable", "Choose another name or change its permissions.");
  }
}

OutputTarget checked_target(const std::string& path) {
  if (path.empty() || path.find('\0') != std::string::npos) {
    throw FileError(path.empty() ? "''" : path.c_str(), "is not a file name");
  }
  OutputTarget target{.file = behind_links(path), .replaced = {}};
  check_folder(path, target.file);
  struct stat status {};
  if (::stat(target.file.c_str(), &status) == 0) {
    target.replaced = status;
  } else if (errno != ENOENT) {
    fail_to_write(path, errno);
  }
  check_replaceable(path, target);
  return target;
}

/// Whether a file that the user gave up is of a kind that another may replace: recordings in CSV
/// are of as many kinds as they have channels.
bool is_given_up(std::string_view old_kind, std::string_view kind, Replacing replacing) {
  constexpr std::string_view kAnyTable = "a table of '";
  return replacing == Replacing::kAny && old_kind.starts_with(kAnyTable) &&
         kind.starts_with(kAnyTable);
}

void check_kind(const std::string& path, const std::string& target, std::string_view kind,
                Replacing replacing) {
  const std::string old_head = read_kind_head(target);
  if (old_head.empty()) return;
  const std::string old_kind = file_kind(old_head);
  if (!kind.empty() && old_kind == kind) return;
  if (is_given_up(old_kind, kind, replacing)) return;
  throw FileError(path,
                  fmt::format("exists and contains {}; it would be replaced by {}",
                              old_kind.empty() ? "something else" : old_kind,
                              kind.empty() ? "something else" : kind),
                  "Remove it or choose another name.");
}

void check_own(const std::string& path, const std::string& target) {
  if (read_file_head(target, 1).empty() || is_own_file(target)) return;
  throw FileError(path, "exists and was not written by microslip; it would be replaced",
                  "Move it away or choose another name.");
}

void check_may_be_replaced(const std::string& path, const std::string& target,
                           const std::string& by, Replacing replacing) {
  if (replacing == Replacing::kAny || has_same_bytes(target, by)) return;
  if (replacing == Replacing::kOwn) return check_own(path, target);
  if (read_file_head(target, 1).empty()) return;
  throw FileError(path, "exists and has another content; it would be replaced",
                  "Choose another name, or add `replace`.");
}

/// Where a process of this number can be asked for: this machine and its numbering of processes, in
/// a few letters. A folder may be one of a network.
const std::string& place_of_processes() {
  static const std::string place = [] {
    std::array<char, 256> host{};
    (void)::gethostname(host.data(), host.size() - 1);
    std::array<char, 64> numbering{};
    (void)::readlink("/proc/self/ns/pid", numbering.data(), numbering.size() - 1);
    constexpr std::size_t kLetters = 8;
    return sha256(std::string(host.data()) + numbering.data()).substr(0, kLetters);
  }();
  return place;
}

/// The number of the process that left a file of this name, where it is one of ours from this
/// place.
std::optional<pid_t> process_of(std::string_view name) {
  const std::string prefix = ".microslip-" + place_of_processes() + "-";
  const std::size_t end_of_staged = name.rfind(kStagedEnding);
  if (!name.starts_with(prefix) || end_of_staged == name.npos) return std::nullopt;
  const std::string_view suffix = name.substr(end_of_staged + kStagedEnding.size());
  if (!suffix.empty() && suffix != kOldSuffix && suffix != kRowsSuffix) return std::nullopt;
  name.remove_prefix(prefix.size());
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
  if (error != std::errc() || *end != '-' || process <= 0) return std::nullopt;
  return process;
}

/// Removes what processes left that were killed before they could; once a folder.
void remove_litter(const std::string& folder) {
  static std::mutex mutex;
  static std::set<std::string> looked_at;
  {
    const std::lock_guard lock(mutex);
    if (!looked_at.insert(folder).second) return;
  }
  std::error_code unreadable;  // then there is nothing to be done about it
  for (fs::directory_iterator at(folder, unreadable), end; !unreadable && at != end;
       at.increment(unreadable)) {
    const std::optional<pid_t> process = process_of(at->path().filename().string());
    if (process && ::kill(*process, 0) != 0 && errno == ESRCH) ::unlink(at->path().c_str());
  }
}

/// A new file in the folder of the target, with the permissions of the file it is going to replace.
std::pair<Temporary, FileDescriptor> create_beside(const std::string& path,
                                                   const OutputTarget& target) {
  static std::atomic<unsigned> counter{0};
  const std::string folder = folder_of(target.file);
  remove_litter(folder);
  for (;;) {
    Temporary temporary(fmt::format("{}/.microslip-{}-{}-{}{}", folder, place_of_processes(),
                                    ::getpid(), counter++, kStagedEnding));
    FileDescriptor file(
        ::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.is_open()) {
      if (target.replaced) ::fchmod(file.number(), target.replaced->st_mode & 07777U);
      return {std::move(temporary), std::move(file)};
    }
    const int error = errno;
    temporary.keep();
    if (error != EEXIST) fail_to_write(path, error);
  }
}

/// To disk, or the new name could outlive the content in a power failure.
void flush_to_disk(const std::string& path, const std::string& temporary) {
  FileDescriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail_to_write(path, errno);
  sync_file(file.number(), path);
  if (!file.close()) fail_to_write(path, errno);
}

/// The names, too. A folder that may be written to but not be listed cannot be opened: no harm.
void flush_folder(const std::string& path, const std::string& target) {
  const FileDescriptor folder(
      ::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) sync_file(folder.number(), path);
}

/// A file that has got its final name, and how to take that back.
struct Placed {
  std::string target;
  bool replaced;
  std::optional<Temporary> old;  ///< the file that was there, where the file system can keep it

  void take_back() {
    if (!replaced) {
      ::unlink(target.c_str());
    } else if (old && ::rename(old->path().c_str(), target.c_str()) == 0) {
      old->keep();
    }
  }
};

/// Gives a file its name where there was none: what another process put there meanwhile stays.
void give_new_name(const std::string& path, const std::string& target, Temporary& temporary) {
  if (::link(temporary.path().c_str(), target.c_str()) == 0) return;
  if (errno == EEXIST) {
    throw FileError(path, "appeared while its content was computed; it would be replaced",
                    "Move it away or choose another name.");
  }
  const bool has_links = errno != EPERM && errno != EOPNOTSUPP && errno != ENOSYS &&
                         errno != EINVAL && errno != EMLINK;
  if (has_links) fail_to_write(path, errno);
  if (::rename(temporary.path().c_str(), target.c_str()) != 0) fail_to_write(path, errno);
  temporary.keep();
}

std::optional<Temporary> second_name(const std::string& target, const std::string& temporary) {
  std::optional<Temporary> old(temporary + kOldSuffix);
  if (::link(target.c_str(), old->path().c_str()) != 0) old.reset();
  return old;
}

}  // namespace

void check_output(const std::string& path, std::string_view kind, Replacing replacing) {
  if (path == "-") return;
  const OutputTarget target = checked_target(path);
  if (!target.replaced) return;
  if (!kind.empty()) check_kind(path, target.file, kind, replacing);
  if (replacing == Replacing::kOwn) check_own(path, target.file);
}

void check_outputs(std::span<const PlannedOutput> outputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    check_output(output->path, output->kind);
    for (auto other = outputs.begin(); other != output; ++other) {
      if (output->path == "-" && other->path == "-") fail_twice_on_standard_output();
      if (output->path == "-" || other->path == "-") continue;
      if (is_same_file(behind_links(output->path), behind_links(other->path))) {
        fail_twice(output->path);
      }
    }
  }
}

std::pair<OutputFiles::File*, FileDescriptor> OutputFiles::create(const std::string& path,
                                                                  Replacing replacing) {
  const OutputTarget target = checked_target(path);
  const auto same = [&](const File& file) { return is_same_file(file.target, target.file); };
  if (std::any_of(files_.begin(), files_.end(), same)) fail_twice(path);
  auto created = create_beside(path, target);
  File& file = files_.emplace_back(File{path, target.file, std::move(created.first), replacing});
  return {&file, std::move(created.second)};
}

void OutputFiles::add(const std::string& path, std::string_view content) {
  if (path == "-") {
    if (standard_output_) fail_twice_on_standard_output();
    standard_output_ = content;
    return;
  }
  auto [file, descriptor] = create(path, Replacing::kOwn);
  write_all(descriptor.number(), content, path);
  if (!descriptor.close()) fail_to_write(path, errno);
}

std::string OutputFiles::stage(const std::string& path, Replacing replacing) {
  if (path == "-") throw FileError(kStandardOutput, "cannot take this format", "Name a file.");
  auto [file, descriptor] = create(path, replacing);
  if (!descriptor.close()) fail_to_write(path, errno);
  return file->temporary.path();
}

/// The disk may take seconds, in which others write: it comes before the checks.
void OutputFiles::check_all() {
  for (const File& file : files_) flush_to_disk(file.path, file.temporary.path());
  for (File& file : files_) {
    const OutputTarget target = checked_target(file.path);
    const std::string& temporary = file.temporary.path();
    file.replaces = target.replaced.has_value();
    if (!file.replaces) continue;
    check_kind(file.path, target.file, file_kind(read_kind_head(temporary)), file.replacing);
    check_may_be_replaced(file.path, target.file, temporary, file.replacing);
  }
}

void OutputFiles::commit() {
  check_all();
  if (standard_output_) {
    write_standard_output(*standard_output_);
    finish_standard_output();
  }
  give_names();
  files_.clear();
  standard_output_.reset();
}

/// A signal between two names would leave files of two calls, or none where its handler removes
/// the old ones.
void OutputFiles::give_names() {
  const PostponedSignals until_all_have_theirs;
  std::vector<Placed> placed;
  placed.reserve(files_.size());
  try {
    for (File& file : files_) {
      if (!file.replaces) {
        give_new_name(file.path, file.target, file.temporary);
        placed.push_back({file.target, false, {}});
        continue;
      }
      auto old = second_name(file.target, file.temporary.path());
      if (::rename(file.temporary.path().c_str(), file.target.c_str()) != 0) {
        fail_to_write(file.path, errno);
      }
      file.temporary.keep();
      placed.push_back({file.target, true, std::move(old)});
    }
    for (const File& file : files_) flush_folder(file.path, file.target);
  } catch (...) {
    for (Placed& earlier : placed) earlier.take_back();
    throw;
  }
}

void write_file(const std::string& path, std::string_view content) {
  OutputFiles files;
  files.add(path, content);
  files.commit();
}

void remove_file(const std::string& path) { ::unlink(path.c_str()); }

}  // namespace microslip
