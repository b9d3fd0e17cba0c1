// SPDX-License-Identifier: MIT
#include "microslip/io/bytes/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/memory_limit.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"

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

/// Files of a known signature are left to their readers, which call them by their name.
void check_text(std::string_view content, std::size_t from, const std::string& name) {
  const std::size_t zero = content.find('\0', from);
  if (zero == std::string_view::npos || !signature(content).empty()) return;
  throw FormatError(place_at(content, zero, name), "text", "the byte 0x00",
                    "Is this a text table?");
}

/// In blocks, each of which is judged before the next.
std::string read_all_text(InputStream& file, std::size_t limit) {
  constexpr std::size_t kLargestBlock = std::size_t{1} << 20U;
  const std::size_t block =
      std::clamp<std::size_t>(file.size().value_or(kLargestBlock) + 1, 4096, kLargestBlock);
  std::string content;
  for (;;) {
    const std::size_t from = content.size();
    content.resize(from + std::min(block, limit + 1 - from));
    content.resize(from + file.read(content.data() + from, content.size() - from));
    check_text(content, from, file.name());
    if (content.size() > limit) fail_too_large(file.name(), limit);
    if (content.size() == from) return content;
    if (from == 0) content.reserve(file.size().value_or(0) + 1);
  }
}

/// What reads all of a file, where that fits into memory.
template <typename Read>
std::string whole(InputStream& file, std::size_t limit, const Read& read) {
  if (file.size().value_or(0) > limit) fail_too_large(file.name(), limit);
  return within_memory(file.name(), [&] { return read(file, limit); });
}

}  // namespace

std::string read_file(const std::string& path, std::size_t limit) {
  InputStream file(path);
  return read_rest(file, limit);
}

std::string read_text(const std::string& path, std::size_t limit) {
  InputStream file(path);
  return read_rest_of_text(file, limit);
}

std::string read_rest_of_text(InputStream& file, std::size_t limit) {
  return whole(file, limit, read_all_text);
}

std::string read_rest(InputStream& file, std::size_t limit) { return whole(file, limit, read_all); }

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
