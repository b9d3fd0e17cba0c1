// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/test_file.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/documents/levels/response_sweep.hpp"
#include "microslip/documents/levels/stepped_sine_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/bytes/text.hpp"
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

/// Whether a variable is of stepped sines. What hinders its reading is for those who read it.
bool is_sweep(const MatVariable& file, const std::string& name) {
  try {
    return is_stepped_sine(file, name);
  } catch (const Error&) {
    return false;
  }
}

/// A variable of a file that is open. What hinders its reading is for those who read it.
std::optional<MatVariable> variable_of(InputStream& file, const std::string& name) {
  try {
    return MatVariable(file, name);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Keeps a variable that is of stepped sines.
void keep_sweep(MatVariable variable, const std::string& name, TestFile& test) {
  test.part.variable = name;
  test.sweep = std::move(variable);
  test.content = TestContent::kSteppedSine;
}

/// The format of a file that can hold variables.
std::optional<RecordingFormat> format_of_variables(std::string_view head) {
  const auto format = find_recording_format_of(head);
  const bool holds = format == RecordingFormat::kMat || format == RecordingFormat::kMat73;
  return holds ? format : std::nullopt;
}

void find_variable(InputStream& file, TestFile& test) {
  test.format = format_of_variables(test.text);
  const std::string name = test.part.variable;
  std::optional<MatVariable> variable = variable_of(file, name);
  if (variable && is_sweep(*variable, name)) keep_sweep(std::move(*variable), name, test);
}

/// The one variable of a MATLAB file that is of stepped sines. Not sought in a file too large for
/// any sweep or of many variables, which is a recording.
void seek_sweep(InputStream& file, TestFile& test) {
  constexpr std::size_t kLargest = std::size_t{64} << 20;
  constexpr std::size_t kMost = 20;
  if (test.format != RecordingFormat::kMat || file.size().value_or(kLargest) >= kLargest) return;
  const std::optional<MatVariable> all = file.rewind() ? variable_of(file, "") : std::nullopt;
  if (!all) return;
  const std::vector<std::string> names = all->fields("");
  if (names.size() > kMost) return;
  std::optional<MatVariable> sweep;
  std::string found;
  for (const std::string& name : names) {
    std::optional<MatVariable> variable = file.rewind() ? variable_of(file, name) : std::nullopt;
    if (!variable || !is_sweep(*variable, name)) continue;
    if (sweep) return;
    sweep = std::move(variable);
    found = name;
  }
  if (sweep) keep_sweep(std::move(*sweep), found, test);
}

}  // namespace

TestFile open_test(const std::string& path, Hashed hashed) {
  TestFile test{.path = path, .part = part_of_file(path)};
  test.once = is_pipe_or_device(test.part.file);
  if (test.once) return test;
  InputStream file(test.part.file);
  test.once = test.part.file == "-";
  if (test.once && !file.rewind()) return test;
  test.text = peek_kind_head(file);
  if (!test.part.variable.empty()) {
    find_variable(file, test);
    if (hashed == Hashed::kYes && file.rewind()) test.sha256 = sha256_of_rest(file);
    return test;
  }
  test.kind = file_kind(test.text);
  test.content = content_of(test.text, test.kind);
  if (test.once) {
    test.text.clear();
    file.rewind();
  } else if (is_table(test.content)) {
    test.text = read_rest_of_text(file);
    test.sha256 = sha256(test.text);
  } else if (test.content == TestContent::kRecording) {
    test.format = find_recording_format_of(test.text);
    if (test.format && hashed == Hashed::kYes) test.sha256 = sha256_of_rest(file);
    seek_sweep(file, test);
  }
  return test;
}

void require_file(const TestFile& file, const std::string& name, std::string_view what) {
  if (!file.once) return;
  throw InputError(name, in_quotes(file.path),
                   fmt::format("must be {}: a pipe or a device can be read only once", what),
                   "Write it to a file first.");
}

std::string text_of(const TestFile& file) {
  return file.once || !is_table(file.content) ? read_file(file.part.file) : file.text;
}

Recordings read_recordings(const TestFile& file, const RecordingReadOptions& options) {
  if (!file.format) return read_recordings(file.path, options);
  return read_recordings(file.part, *file.format, options);
}

std::vector<SteppedSine> read_stepped_sines(const TestFile& file) {
  if (file.sweep) return read_mat_sweeps(*file.sweep, file.part.variable);
  if (file.kind == recording_kind(RecordingFormat::kUff)) {
    return response_sweeps(read_recordings(file, {}), file.path);
  }
  return {parse_stepped_sine(text_of(file), input_name(file.path))};
}

}  // namespace microslip
