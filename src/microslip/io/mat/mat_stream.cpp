// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>

namespace microslip {
namespace {

/// In one go, so that somebody who listens can stop the reading in between.
constexpr std::size_t kPiece = std::size_t{64} << 20U;

constexpr std::size_t kReportEvery = std::size_t{1} << 20U;

/// Smaller values are taken out of a block of this size.
constexpr std::size_t kBlock = std::size_t{1} << 16U;

/// Deflate makes no more of one byte (RFC 1951: 258 bytes of two bits, rounded up).
constexpr std::size_t kLargestInflation = 1040;

}  // namespace

std::string MatStream::label() const { return fmt::format("{}, byte {}", name_, offset_); }

void MatStream::fail(std::string_view expected, std::string_view found) const {
  throw FormatError({.file = label()}, expected, found,
                    "The file is damaged; save or copy it again.");
}

void MatStream::fail_ended(std::string_view expected) const {
  throw Ended({.file = label()}, expected, "the end of the file",
              "It is truncated; copy it again.");
}

void MatStream::read(char* to, std::size_t size) {
  while (size > 0) {
    const std::size_t count = read_some(to, std::min(size, kPiece));
    if (count == 0) fail_ended(fmt::format("{} more bytes", size));
    offset_ += count;
    to += count;
    size -= count;
  }
}

void MatStream::skip(std::size_t size) {
  std::array<char, 4096> ignored;
  while (size > 0) {
    const std::size_t count = std::min(size, ignored.size());
    read(ignored.data(), count);
    size -= count;
  }
}

MatFileStream::MatFileStream(InputStream& file, Progress progress)
    : MatStream(file.name()), file_(file), progress_(std::move(progress)) {
  if (!file.size()) {
    throw FileError(file.name(), "cannot be read", "It must be a file, not a pipe.");
  }
  size_ = *file.size();
}

std::string MatFileStream::head(std::size_t size) { return std::string(file_.peek(size)); }

std::size_t MatFileStream::read_some(char* to, std::size_t size) {
  if (progress_ && offset() >= next_report_) {
    if (!progress_(offset(), size_)) throw Cancelled();
    next_report_ = offset() + kReportEvery;
  }
  if (taken_ == ahead_.size()) {
    if (size >= kBlock) return file_.read(to, size);
    taken_ = 0;
    ahead_.resize(kBlock);
    ahead_.resize(file_.read(ahead_.data(), kBlock));
  }
  const std::size_t count = std::min(size, ahead_.size() - taken_);
  std::copy_n(ahead_.begin() + static_cast<std::ptrdiff_t>(taken_), count, to);
  taken_ += count;
  return count;
}

MatInflateStream::MatInflateStream(MatFileStream& file, std::size_t compressed)
    : MatStream(file.label()), file_(file), compressed_(compressed) {
  if (::inflateInit(&state_) != Z_OK) throw std::bad_alloc();
}

std::size_t MatInflateStream::at_most() const {
  return (compressed_ + state_.avail_in + 1) * kLargestInflation;
}

void MatInflateStream::refill() {
  const std::size_t count = std::min(compressed_, buffer_.size());
  file_.read(buffer_.data(), count);
  compressed_ -= count;
  state_.next_in = reinterpret_cast<Bytef*>(buffer_.data());
  state_.avail_in = static_cast<uInt>(count);
}

std::size_t MatInflateStream::read_some(char* to, std::size_t size) {
  if (ended_) fail(fmt::format("{} more bytes", size), "the end of the compressed data");
  state_.next_out = reinterpret_cast<Bytef*>(to);
  state_.avail_out = static_cast<uInt>(size);
  while (state_.avail_out == size && !ended_) {
    if (state_.avail_in == 0) refill();
    const int result = ::inflate(&state_, Z_NO_FLUSH);
    ended_ = result == Z_STREAM_END;
    if (ended_ || result == Z_OK) continue;
    if (result == Z_BUF_ERROR && compressed_ > 0) continue;
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    fail("compressed data", result == Z_BUF_ERROR ? "their end" : "other bytes");
  }
  return size - state_.avail_out;
}

void MatInflateStream::finish(std::size_t most) {
  std::array<char, 4096> rest{};
  while (!ended_) {
    const std::size_t count = read_some(rest.data(), std::min(most + 1, rest.size()));
    if (count > most) fail("the end of the variable", "more bytes");
    most -= count;
  }
  file_.skip(compressed_);
}

}  // namespace microslip
