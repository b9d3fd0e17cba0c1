// SPDX-License-Identifier: MIT
#include "microslip/io/table_stream.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "microslip/io/write_error.hpp"

namespace microslip {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 18;

[[noreturn]] void refuse_table(std::string_view path, int error) {
  fail_to_write(path == "-" ? std::string_view("standard output") : path, error);
}

FileDescriptor opened(const std::string& path, const std::string& name, int flags) {
  FileDescriptor file(::open(name.c_str(), flags | O_CLOEXEC, 0600));
  if (!file.is_open()) refuse_table(path, errno);
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
  temporary_.emplace(staged_ + ".rows");
  rows_.emplace(opened(path_, temporary_->path(), O_RDWR | O_CREAT | O_EXCL));
}

void TableStream::add(std::string_view rows) {
  buffer_ += rows;
  if (buffer_.size() >= kBuffer) flush();
}

void TableStream::flush() {
  if (on_standard_output() && std::fflush(stdout) != 0) refuse_table(path_, errno);
  put(on_standard_output() ? STDOUT_FILENO : rows_->number(), buffer_);
  buffer_.clear();
}

void TableStream::put(int file, std::string_view text) const {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_table(path_, errno);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void TableStream::finish(std::string_view comments) {
  if (on_standard_output()) buffer_ += comments;
  flush();
  if (on_standard_output()) {
    sync_file(STDOUT_FILENO, "standard output");
    close_copy(STDOUT_FILENO, "standard output");
    return;
  }
  FileDescriptor file = opened(path_, staged_, O_WRONLY);
  put(file.number(), head_);
  put(file.number(), comments);
  put(file.number(), header_);
  copy_rows(file.number());
  if (!rows_->close() || !file.close()) refuse_table(path_, errno);
  temporary_.reset();
  output_.commit();
}

void TableStream::copy_rows(int to) {
  if (::lseek(rows_->number(), 0, SEEK_SET) != 0) refuse_table(path_, errno);
  std::string block(kBuffer, '\0');
  for (;;) {
    const ssize_t count = ::read(rows_->number(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_table(path_, errno);
    if (count == 0) return;
    put(to, std::string_view(block).substr(0, static_cast<std::size_t>(count)));
  }
}

}  // namespace microslip
