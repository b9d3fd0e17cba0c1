// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/test_file.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"

namespace microslip {
namespace {

TestContent content_of(std::string_view head, std::string_view kind) {
  if (is_stepped_sine_table(head)) return TestContent::kSteppedSine;
  if (kind == kLevelsKind) return TestContent::kLevels;
  if (kind == kModalLevelsKind) return TestContent::kModalLevels;
  const KnownKind* const known = known_kind(kind);
  return known == nullptr || known->is_recording ? TestContent::kRecording : TestContent::kOther;
}

bool is_table(TestContent content) {
  return content == TestContent::kLevels || content == TestContent::kModalLevels ||
         content == TestContent::kSteppedSine;
}

/// What is left of a file, with its digest. @param kept  gets all of it where it is not null.
std::string digest_of_rest(InputStream& file, std::string* kept) {
  std::array<char, std::size_t{1} << 16U> block;
  Sha256 digest;
  while (const std::size_t size = file.read(block.data(), block.size())) {
    const std::string_view bytes(block.data(), size);
    digest.update(bytes);
    if (kept != nullptr) kept->append(bytes);
  }
  return digest.finish();
}

}  // namespace

TestFile open_test(const std::string& path) {
  TestFile test{.path = path, .part = part_of_file(path)};
  std::error_code ignored;  // what is not there is no pipe, and says so where it is opened
  test.once = std::filesystem::is_fifo(test.part.file, ignored);
  if (test.once) return test;
  InputStream file(test.part.file);
  test.once = test.part.file == "-";
  if (test.once && !file.rewind()) return test;
  if (!test.part.variable.empty()) {
    if (is_stepped_sine(path)) test.content = TestContent::kSteppedSine;
    test.sha256 = digest_of_rest(file, nullptr);
    return test;
  }
  test.text = peek_kind_head(file);
  test.kind = file_kind(test.text);
  test.content = content_of(test.text, test.kind);
  if (test.once) {
    test.text.clear();
    file.rewind();
    return test;
  }
  if (test.content == TestContent::kRecording) test.format = find_recording_format_of(test.text);
  const bool whole = is_table(test.content);
  if (whole) test.text.clear();
  test.sha256 = digest_of_rest(file, whole ? &test.text : nullptr);
  return test;
}

std::string text_of(const TestFile& file) {
  return file.once || !is_table(file.content) ? read_file(file.part.file) : file.text;
}

std::vector<SteppedSine> read_stepped_sines(const TestFile& file) {
  if (!file.part.variable.empty()) return read_stepped_sines(file.path);
  return {parse_stepped_sine(text_of(file), input_name(file.path))};
}

}  // namespace microslip
