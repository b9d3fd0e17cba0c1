// SPDX-License-Identifier: MIT
#include "microslip/io/loggers/piece_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr std::size_t kReportEvery = std::size_t{1} << 22U;

std::size_t size_of_file(const InputStream& stream) {
  if (stream.size()) return *stream.size();
  throw FileError(stream.name(), "is a pipe or a device, which supports recordings in CSV only",
                  "Save them in a file and name that.");
}

}  // namespace

PieceReader::PieceReader(const std::string& path, Progress progress)
    : stream_(path), progress_(std::move(progress)), size_(size_of_file(stream_)) {}

void PieceReader::refill(std::size_t size) {
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t known = buffer_.size();
  const std::size_t wanted = std::min(std::max(size, kPiece), known + left());
  buffer_.resize(wanted);
  buffer_.resize(known + stream_.read(buffer_.data() + known, wanted - known));
  if (buffer_.size() < size) fail(fmt::format("{} more bytes", size), "the end of the file");
}

std::string_view PieceReader::take(std::size_t size) {
  if (size > left()) {
    fail(fmt::format("{} more bytes", size), fmt::format("{}", left()),
         "It is truncated; copy it again.");
  }
  if (buffer_.size() - begin_ < size) refill(size);
  const std::string_view piece = std::string_view(buffer_).substr(begin_, size);
  begin_ += size;
  offset_ += size;
  if (progress_ && offset_ >= next_report_) {
    if (!progress_(offset_, size_)) throw Cancelled();
    next_report_ = offset_ + kReportEvery;
  }
  return piece;
}

std::string_view PieceReader::peek(std::size_t size) {
  size = std::min(size, left());
  if (buffer_.size() - begin_ < size) refill(size);
  return std::string_view(buffer_).substr(begin_, size);
}

void PieceReader::skip(std::size_t size) {
  while (size > 0) {
    const std::size_t count = std::min(size, kPiece);
    (void)take(count);
    size -= count;
  }
}

void PieceReader::fail(std::string_view expected, std::string_view found,
                       std::string_view remedy) const {
  throw FormatError({.file = fmt::format("{}, byte {}", name(), offset_)}, expected, found, remedy);
}

}  // namespace microslip
