// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_input.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/open_input.hpp"

namespace microslip {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 18U;
constexpr std::size_t kLongestUffLine = std::size_t{1} << 16U;
constexpr std::size_t kReportEach = std::size_t{1} << 22U;

}  // namespace

UffInput::UffInput(const std::string& path, Progress progress)
    : name_(input_name(path)), progress_(std::move(progress)), file_(open_input(path)) {
  if (const auto size = regular_size(file_, name_); size && path != "-") {
    size_ = *size;
    return;
  }
  content_ = read_file(path);
  in_memory_ = true;
  size_ = content_.size();
}

std::optional<std::string_view> UffInput::line() {
  if (position_ == size_) return std::nullopt;
  std::string_view text = window(256);
  std::size_t end = text.find('\n');
  if (end == std::string_view::npos) {
    text = window(kLongestUffLine);
    end = text.find('\n');
  }
  line_was_whole_ = end != std::string_view::npos;
  ++line_number_;
  position_ += line_was_whole_ ? end + 1 : text.size();
  const std::size_t start = position_ - (line_was_whole_ ? end + 1 : text.size()) - window_start_;
  const std::size_t length = line_was_whole_ ? end : text.size();
  while (!line_was_whole_ && position_ < size_) {  // too long: the rest is of no use
    const std::string rest = peek(0, kLongestUffLine);
    const std::size_t at = rest.find('\n');
    line_was_whole_ = at != std::string::npos;
    position_ += line_was_whole_ ? at + 1 : rest.size();
  }
  report(position_);
  text = std::string_view(window_).substr(start, length);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

TextPlace UffInput::place(std::size_t column) const {
  if (!lines_are_counted_) return {.file = name_};
  return {.file = name_, .line = line_number_, .column = column};
}

void UffInput::read(std::span<char> bytes) {
  const std::size_t buffered =
      position_ >= window_start_ && position_ < window_start_ + window_.size()
          ? std::min(bytes.size(), window_start_ + window_.size() - position_)
          : 0;
  if (buffered > 0) {
    std::memcpy(bytes.data(), window_.data() + (position_ - window_start_), buffered);
  }
  copy(position_ + buffered, bytes.subspan(buffered));
  position_ += bytes.size();
  lines_are_counted_ = false;
  report(position_);
}

std::string UffInput::peek(std::size_t offset, std::size_t size) {
  if (offset >= remaining()) return {};
  std::string bytes(std::min(size, remaining() - offset), '\0');
  copy(position_ + offset, bytes);
  return bytes;
}

/// The next `size` bytes, or as many as are left.
std::string_view UffInput::window(std::size_t size) {
  const std::size_t wanted = std::min(size, remaining());
  if (position_ < window_start_ || position_ + wanted > window_start_ + window_.size()) {
    window_.resize(std::min(std::max(wanted, kWindow), remaining()));
    window_start_ = position_;
    copy(position_, window_);
  }
  return std::string_view(window_).substr(position_ - window_start_, wanted);
}

void UffInput::copy(std::size_t from, std::span<char> bytes) const {
  if (in_memory_) {
    if (!bytes.empty()) std::memcpy(bytes.data(), content_.data() + from, bytes.size());
    return;
  }
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::pread(file_.number(), bytes.data() + done, bytes.size() - done,
                                  static_cast<off_t>(from + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_reading(name_, errno);
    if (count == 0) throw FileError(name_, "became shorter while it was read");
    done += static_cast<std::size_t>(count);
  }
}

void UffInput::report(std::size_t done) {
  if (!progress_ || (done < reported_ + kReportEach && done < size_)) return;
  if (done == reported_) return;
  reported_ = done;
  if (!progress_(done, size_)) throw Cancelled();
}

}  // namespace microslip
