// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/input_stream.hpp"

#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <utility>

#include "microslip/io/bytes/input_name.hpp"
#include "microslip/io/bytes/open_input.hpp"

namespace microslip {

InputStream::InputStream(const std::string& path)
    : name_(input_name(path)), file_(open_input(path)), size_(regular_size(file_, name_)) {
  const off_t begin = ::lseek(file_.number(), 0, SEEK_CUR);
  if (begin >= 0) begin_ = static_cast<std::size_t>(begin);
}

InputStream::InputStream(std::string text, std::string name)
    : name_(std::move(name)), file_(-1), size_(text.size()), peeked_(std::move(text)) {}

std::size_t InputStream::read(char* buffer, std::size_t size) {
  const std::size_t known = peeked_.copy(buffer, size);
  peeked_.erase(0, known);
  return known + read_file(buffer + known, size - known);
}

std::string_view InputStream::peek(std::size_t size) {
  const std::size_t known = peeked_.size();
  if (known >= size) return std::string_view(peeked_).substr(0, size);
  peeked_.resize(size);
  peeked_.resize(known + read_file(peeked_.data() + known, size - known));
  return peeked_;
}

std::size_t InputStream::read_file(char* buffer, std::size_t size) {
  std::size_t done = 0;
  while (file_.is_open() && done < size) {
    const ssize_t count = ::read(file_.number(), buffer + done, size - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_reading(name_, errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

bool InputStream::rewind() {
  if (!begin_ || ::lseek(file_.number(), static_cast<off_t>(*begin_), SEEK_SET) < 0) return false;
  peeked_.clear();
  return true;
}

}  // namespace microslip
