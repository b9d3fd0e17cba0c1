// SPDX-License-Identifier: MIT
#include "microslip/io/uff_output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "microslip/base/error.hpp"

namespace microslip {

UffOutput::UffOutput(const std::string& path)
    : path_(path), file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (!file_.is_open()) fail(errno);
}

void UffOutput::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void UffOutput::close() {
  if (!file_.close()) fail(errno);
}

void UffOutput::fail(int error) const {
  throw FileError(path_,
                  fmt::format("cannot be written: {}", std::generic_category().message(error)));
}

}  // namespace microslip
