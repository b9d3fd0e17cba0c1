// SPDX-License-Identifier: MIT
#include "microslip/documents/study/journal_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/little_endian.hpp"
#include "microslip/io/bytes/file_descriptor.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/write_error.hpp"

namespace microslip {
namespace {

constexpr std::string_view kJournalEnding = ".journal";
constexpr std::size_t kSumSize = 16;
constexpr std::size_t kBlockHeadSize = 2 * kLittleEndianSize + kSumSize;
/// A heading beyond it is none of ours.
constexpr std::uint64_t kLargestHeading = std::uint64_t{64} << 20U;

/// "OUT.journal" or "OUT.3-of-20.journal".
bool is_journal_of(const std::string& out, std::string_view name) {
  if (!name.starts_with(out) || !name.ends_with(kJournalEnding)) return false;
  if (name.size() == out.size() + kJournalEnding.size()) return true;
  if (name.size() < out.size() + kJournalEnding.size()) return false;
  const std::string_view share =
      name.substr(out.size(), name.size() - out.size() - kJournalEnding.size());
  const std::size_t of = share.find("-of-");
  if (!share.starts_with('.') || of == std::string_view::npos) return false;
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  return is_number(share.substr(1, of - 1)) && is_number(share.substr(of + 4));
}

std::string first_line() { return std::string(kJournalKind) + "\n"; }

std::string check_sum(std::string_view numbers, std::string_view content) {
  Sha256 sum;
  sum.update(numbers);
  sum.update(content);
  return sum.finish().substr(0, kSumSize);
}

FileDescriptor open_to_read(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.is_open()) return file;
  throw FileError(path, fmt::format("cannot be read: {}", std::generic_category().message(errno)));
}

/// So many bytes, or as many as there are.
std::string read_at(int file, std::uint64_t offset, std::uint64_t size, const std::string& path) {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count =
        ::pread(file, bytes.data() + done, size - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      throw FileError(path,
                      fmt::format("cannot be read: {}", std::generic_category().message(errno)));
    }
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

[[noreturn]] void fail_format(const std::string& path, const char* found) {
  throw FormatError({.file = path}, "a journal of microslip", found,
                    "Remove it, or choose another name for the result.");
}

struct Heading {
  std::string text;
  std::uint64_t end = 0;  ///< in the file
};

Heading read_heading(int file, const std::string& path) {
  constexpr std::size_t kMostDigits = 20;
  const std::string first = first_line();
  const std::string head = read_at(file, 0, first.size() + kMostDigits, path);
  if (!head.starts_with(first)) fail_format(path, "something else");
  const std::size_t line = head.find('\n', first.size());
  std::uint64_t size = 0;
  const char* const digits = head.data() + first.size();
  const char* const end = line == std::string::npos ? digits : head.data() + line;
  const auto [rest, error] = std::from_chars(digits, end, size);
  if (error != std::errc() || rest != end || size > kLargestHeading) {
    fail_format(path, "one whose heading is damaged");
  }
  Heading heading{read_at(file, line + 1, size, path), line + 1 + size};
  if (heading.text.size() != size) fail_format(path, "one whose heading is incomplete");
  return heading;
}

std::uint64_t size_of(int file, const std::string& path) {
  struct stat status {};
  if (::fstat(file, &status) != 0) fail_to_write(path, errno);
  return static_cast<std::uint64_t>(status.st_size);
}

/// Whether the file that is open is still the one of that name: another run may have removed it.
bool is_at(int file, const std::string& path) {
  struct stat open {};
  struct stat named {};
  if (::fstat(file, &open) != 0) fail_to_write(path, errno);
  return ::stat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

/// By what a file system says that it has no locks: Lustre mounted without flock, NFS without its
/// lock manager.
bool has_no_locks(int error) {
  return error == ENOSYS || error == ENOLCK || error == EOPNOTSUPP || error == EINVAL;
}

/// The journal, made where it is not there or empty, which no other process has or gets meanwhile.
/// Its heading comes under another name, so that it is whole or not there.
/// @param locked  becomes false where the file system has no locks.
FileDescriptor open_alone(const std::string& path, std::string_view heading, bool& locked) {
  constexpr mode_t kMode = 0666;  // less what umask takes
  for (;;) {
    FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode));
    if (!file.is_open()) fail_to_write(path, errno);
    if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0) {
      locked = locked && !has_no_locks(errno);
      if (locked && errno != EWOULDBLOCK) fail_to_write(path, errno);
      if (locked)
        throw FileError(path, "is being written by another run",
                        "Wait until that has ended, or choose another name for the result.");
    }
    if (!is_at(file.number(), path)) continue;
    if (size_of(file.number(), path) > 0) return file;
    write_file(path, fmt::format("{}{}\n{}", first_line(), heading.size(), heading));
  }
}

}  // namespace

struct JournalReader::State {
  State(std::string path_of_file, FileDescriptor opened)
      : path(std::move(path_of_file)), file(std::move(opened)) {}

  std::string path;
  FileDescriptor file;
  std::string heading;
  std::vector<JournalBlock> blocks;
  std::uint64_t end = 0;

  /// The block at an offset, where its size is within the file; whether it is whole.
  std::optional<std::pair<JournalBlock, bool>> block_at(std::uint64_t offset,
                                                        std::uint64_t size) const {
    if (size - offset < kBlockHeadSize) return std::nullopt;
    const std::string head = read_at(file.number(), offset, kBlockHeadSize, path);
    if (head.size() < kBlockHeadSize) return std::nullopt;
    const std::string_view numbers = std::string_view(head).substr(0, 2 * kLittleEndianSize);
    const JournalBlock block{from_little_endian(numbers), offset + kBlockHeadSize,
                             from_little_endian(numbers.substr(kLittleEndianSize))};
    if (block.size > size - block.offset) return std::nullopt;
    const std::string content = read_at(file.number(), block.offset, block.size, path);
    return std::pair{block, check_sum(numbers, content) == head.substr(2 * kLittleEndianSize)};
  }

  void scan() {
    const std::uint64_t size = size_of(file.number(), path);
    std::uint64_t offset = end;
    while (const auto found = block_at(offset, size)) {
      offset = found->first.offset + found->first.size;
      if (!found->second) continue;
      blocks.push_back(found->first);
      end = offset;
    }
    std::ranges::stable_sort(blocks, {}, &JournalBlock::number);
    const auto again = std::ranges::unique(blocks, {}, &JournalBlock::number);
    blocks.erase(again.begin(), again.end());
  }
};

JournalReader::JournalReader(const std::string& path)
    : state_(std::make_unique<State>(path, open_to_read(path))) {
  Heading heading = read_heading(state_->file.number(), path);
  state_->heading = std::move(heading.text);
  state_->end = heading.end;
  state_->scan();
}

JournalReader::~JournalReader() = default;
JournalReader::JournalReader(JournalReader&& other) noexcept = default;

const std::string& JournalReader::heading() const { return state_->heading; }
const std::vector<JournalBlock>& JournalReader::blocks() const { return state_->blocks; }
std::uint64_t JournalReader::end() const { return state_->end; }
const std::string& JournalReader::path() const { return state_->path; }

std::string JournalReader::content(const JournalBlock& block) const {
  std::string content = read_at(state_->file.number(), block.offset, block.size, state_->path);
  if (content.size() == block.size) return content;
  throw FileError(state_->path, "became shorter while it was read");
}

struct JournalWriter::State {
  std::string path;
  FileDescriptor file;
  std::uint64_t end = 0;
  bool locked = true;

  void cut() {
    if (::ftruncate(file.number(), static_cast<off_t>(end)) != 0) fail_to_write(path, errno);
  }
};

JournalWriter::JournalWriter(const std::string& path, std::string_view heading) {
  check_output(path, kJournalKind);
  bool locked = true;
  state_ = std::make_unique<State>(State{path, open_alone(path, heading, locked)});
  state_->locked = locked;
  state_->end = JournalReader(path).end();
  state_->cut();
}

JournalWriter::~JournalWriter() = default;

bool JournalWriter::is_locked() const { return state_->locked; }

void JournalWriter::append(std::uint64_t number, std::string_view content) {
  std::string numbers;
  append_little_endian(numbers, number);
  append_little_endian(numbers, content.size());
  std::string record = numbers + check_sum(numbers, content);
  record += content;
  if (::lseek(state_->file.number(), static_cast<off_t>(state_->end), SEEK_SET) < 0) {
    fail_to_write(state_->path, errno);
  }
  try {
    write_all(state_->file.number(), record, state_->path);
  } catch (const WriteError& error) {
    state_->cut();
    throw;
  }
  state_->end += record.size();
}

void JournalWriter::sync() { sync_file(state_->file.number(), state_->path); }

std::string journal_path(const std::string& out, const std::string& share) {
  return out + (share.empty() ? "" : "." + share) + std::string(kJournalEnding);
}

std::vector<std::string> journals_beside(const std::string& out) {
  namespace fs = std::filesystem;
  const fs::path result(out);
  const fs::path folder = result.has_parent_path() ? result.parent_path() : fs::path(".");
  const std::string start = result.filename().string();
  std::vector<std::string> paths;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (!is_journal_of(start, name) || entry.file_size(none) == 0) continue;
    paths.push_back((result.parent_path() / name).string());
  }
  std::ranges::sort(paths);
  return paths;
}

void remove_journal(const std::string& path) { ::unlink(path.c_str()); }

}  // namespace microslip
