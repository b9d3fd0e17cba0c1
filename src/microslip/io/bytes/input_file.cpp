// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/sha256.hpp"

namespace microslip {
namespace {

[[noreturn]] void fail_too_large(const std::string& name, std::size_t limit) {
  throw FileError(name, fmt::format("is larger than {} bytes", limit), "Is it the right file?");
}

std::string read_all(InputStream& file, std::size_t limit) {
  std::string content;
  std::size_t done = 0;
  // One byte more than expected, so that the end is seen without another round.
  for (std::size_t size = std::max<std::size_t>(file.size().value_or(0), 65535) + 1;;
       size = 2 * size) {
    content.resize(std::min(size, limit + 1));
    done += file.read(content.data() + done, content.size() - done);
    if (done > limit) fail_too_large(file.name(), limit);
    if (done < content.size()) break;
  }
  content.resize(done);
  return content;
}

}  // namespace

std::string read_file(const std::string& path, std::size_t limit) {
  InputStream file(path);
  return read_rest(file, limit);
}

std::string read_rest(InputStream& file, std::size_t limit) {
  if (file.size().value_or(0) > limit) fail_too_large(file.name(), limit);
  try {
    return read_all(file, limit);
  } catch (const std::bad_alloc&) {
    throw FileError(file.name(), "does not fit into memory");
  }
}

std::string sha256_of_rest(InputStream& file) {
  std::array<char, std::size_t{1} << 16U> block;
  Sha256 digest;
  std::size_t done = 0;
  while (const std::size_t size = file.read(block.data(), block.size())) {
    digest.update({block.data(), size});
    done += size;
    if (done > kLargestFile) fail_too_large(file.name(), kLargestFile);
  }
  return digest.finish();
}

std::string read_file_head(const std::string& path, std::size_t size) {
  InputStream file(path);
  std::string content(size, '\0');
  content.resize(file.read(content.data(), size));
  return content;
}

bool is_pipe_or_device(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

}  // namespace microslip
