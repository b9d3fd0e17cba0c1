// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/line_blocks.hpp"

#include <algorithm>
#include <cstring>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

constexpr std::size_t kBlockSize = std::size_t{1} << 20U;
constexpr std::size_t kSmallestBlock = 4096;  // some files of the system have more than their size
constexpr std::size_t kLongestLine = std::size_t{16} << 20U;

}  // namespace

/// One byte more than the file has, so that its end is seen without another round.
LineBlocks::LineBlocks(InputStream& file)
    : file_(file),
      buffer_(std::clamp(file.size().value_or(kBlockSize) + 1, kSmallestBlock, kBlockSize), '\0') {}

bool LineBlocks::next() {
  drop_text();
  for (;;) {
    const std::size_t room = buffer_.size() - filled_;
    const std::size_t count = file_.read(buffer_.data() + filled_, room);
    filled_ += count;
    size_ = count < room ? filled_ : whole_lines();
    if (size_ > 0 || filled_ == 0) break;
    check_text();
    if (buffer_.size() >= kLongestLine) {
      throw FormatError({file_.name(), first_line_, 1}, "lines of text",
                        "a line of more than 16 MiB", "Is this a text table?");
    }
    buffer_.resize(2 * buffer_.size());
  }
  bytes_done_ += size_;
  return size_ > 0;
}

/// A long line is none where it has a zero, as of what a crash has left of a file.
void LineBlocks::check_text() const {
  const std::string_view line(buffer_.data(), filled_);
  const std::size_t zero = line.find('\0');
  if (zero == std::string_view::npos) return;
  throw FormatError({file_.name(), first_line_, place_at(line, zero, {}).column}, "text",
                    "the byte 0x00", "Is this a text table? Was it written to its end?");
}

void LineBlocks::drop_text() {
  first_line_ += static_cast<std::size_t>(std::count(buffer_.data(), buffer_.data() + size_, '\n'));
  std::memmove(buffer_.data(), buffer_.data() + size_, filled_ - size_);
  filled_ -= size_;
  size_ = 0;
}

std::size_t LineBlocks::whole_lines() const {
  const std::size_t end = std::string_view(buffer_.data(), filled_).rfind('\n');
  return end == std::string_view::npos ? 0 : end + 1;
}

}  // namespace microslip
