// SPDX-License-Identifier: MIT
#include "microslip/io/output/file_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "microslip/io/output/write_error.hpp"

namespace microslip {

FileOutput::FileOutput(const std::string& path)
    : path_(path), file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (!file_.is_open()) fail_to_write(path_, errno);
}

void FileOutput::write(std::string_view bytes) { write_all(file_.number(), bytes, path_); }

void FileOutput::close() {
  if (!file_.close()) fail_to_write(path_, errno);
}

void write_all(int descriptor, std::string_view bytes, std::string_view path) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail_to_write(path, count < 0 ? errno : EIO);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void write_standard_output(std::string_view bytes) {
  if (std::fflush(stdout) != 0) fail_to_write(kStandardOutput, errno);
  write_all(STDOUT_FILENO, bytes, kStandardOutput);
}

void finish_standard_output() {
  sync_file(STDOUT_FILENO, kStandardOutput);
  close_copy(STDOUT_FILENO, kStandardOutput);
}

}  // namespace microslip
