// SPDX-License-Identifier: MIT
#include "microslip/io/output/table_stream.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "microslip/io/output/file_output.hpp"
#include "microslip/io/output/write_error.hpp"

namespace microslip {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 18;

FileDescriptor opened(const std::string& path, const std::string& name, int flags) {
  FileDescriptor file(::open(name.c_str(), flags | O_CLOEXEC, 0600));
  if (!file.is_open()) fail_to_write(path, errno);
  return file;
}

}  // namespace

TableStream::TableStream(std::string path, std::string head, std::string header)
    : path_(std::move(path)), head_(std::move(head)), header_(std::move(header)) {
  if (on_standard_output()) {
    buffer_ = head_ + header_;
    return;
  }
  staged_ = output_.stage(path_);
  temporary_.emplace(staged_ + std::string(kRowsSuffix));
  rows_.emplace(opened(path_, temporary_->path(), O_RDWR | O_CREAT | O_EXCL));
}

void TableStream::add(std::string_view rows) {
  buffer_ += rows;
  if (buffer_.size() >= kBuffer) flush();
}

void TableStream::flush() {
  if (on_standard_output()) {
    write_standard_output(buffer_);
  } else {
    write_all(rows_->number(), buffer_, path_);
  }
  buffer_.clear();
}

void TableStream::finish(std::string_view comments) {
  if (on_standard_output()) buffer_ += comments;
  flush();
  if (on_standard_output()) {
    finish_standard_output();
    return;
  }
  FileDescriptor file = opened(path_, staged_, O_WRONLY);
  for (const std::string_view text :
       {std::string_view(head_), comments, std::string_view(header_)}) {
    write_all(file.number(), text, path_);
  }
  copy_rows(file.number());
  if (!rows_->close() || !file.close()) fail_to_write(path_, errno);
  temporary_.reset();
  output_.commit();
}

void TableStream::copy_rows(int to) {
  if (::lseek(rows_->number(), 0, SEEK_SET) != 0) fail_to_write(path_, errno);
  std::string block(kBuffer, '\0');
  for (;;) {
    const ssize_t count = ::read(rows_->number(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_write(path_, errno);
    if (count == 0) return;
    write_all(to, std::string_view(block).substr(0, static_cast<std::size_t>(count)), path_);
  }
}

}  // namespace microslip
