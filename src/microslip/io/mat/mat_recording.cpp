// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_recording.hpp"

#include <fmt/format.h>

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/mat/mat_file.hpp"
#include "microslip/io/mat/mat_foreign.hpp"
#include "microslip/io/mat/mat_path.hpp"
#include "microslip/io/recordings/hdf5_layout.hpp"

namespace microslip {
namespace {

/// Reads a struct that microslip wrote; takes its numbers out of it.
class OwnStruct {
 public:
  OwnStruct(MatValue& value, std::size_t element, std::string place)
      : value_(value), element_(element), place_(std::move(place)) {}

  [[nodiscard]] bool has(std::string_view name) const {
    return field_of(value_, element_, name) != nullptr;
  }

  MatValue& field(std::string_view name, MatValue::Kind kind, std::string_view what) {
    MatValue* found = field_of(value_, element_, name);
    if (found == nullptr || found->kind != kind) {
      throw FormatError({.file = place_}, fmt::format("{} in '{}'", what, name),
                        found == nullptr ? "none" : describe(*found),
                        "The file is damaged, or another program changed it.");
    }
    return *found;
  }

  std::string text(std::string_view name) {
    const MatValue& found = field(name, MatValue::Kind::kText, "a text");
    if (found.texts.size() > 1) fail("a text of one row", describe(found));
    return found.texts.empty() ? std::string{} : found.texts.front();
  }

  MatValue& numbers(std::string_view name) {
    return field(name, MatValue::Kind::kNumbers, "numbers");
  }

  double number(std::string_view name) {
    const MatValue& found = numbers(name);
    if (found.real.size() != 1 || !found.imaginary.empty()) fail("a number", describe(found));
    return found.real.front();
  }

  Dimension unit(std::string_view name) {
    const std::string text_of_unit = text(name);
    const std::optional<Unit> unit = find_unit(text_of_unit);
    if (!unit || unit->factor() != 1.0) fail("an SI unit", in_quotes(text_of_unit));
    return unit->dimension;
  }

  Attributes attributes() {
    const MatValue& cell = field("attributes", MatValue::Kind::kCell, "a cell of texts");
    const std::size_t rows = cell.children.size() / 2;
    Attributes result;
    if (rows > 0 && (cell.sizes[0] != rows || cell.sizes[1] != 2)) {
      fail("attributes of n × 2", describe(cell));
    }
    for (std::size_t i = 0; i < rows; ++i) {
      result.emplace_back(text_of(cell.children[i]), text_of(cell.children[rows + i]));
    }
    return result;
  }

 private:
  [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
    throw FormatError({.file = place_}, expected, found,
                      "The file is damaged, or another program changed it.");
  }

  [[nodiscard]] std::string text_of(const MatValue& value) const {
    if (value.kind == MatValue::Kind::kText && value.texts.size() < 2) {
      return value.texts.empty() ? std::string{} : value.texts.front();
    }
    if (value.count() == 0) return {};
    fail("a text", describe(value));
  }

  MatValue& value_;
  std::size_t element_;
  std::string place_;
};

Channel own_channel(MatValue& channels, std::size_t element, const std::string& place) {
  OwnStruct from(channels, element, fmt::format("{}.channels({})", place, element + 1));
  Channel channel;
  channel.name = from.text("name");
  if (!from.text("unit").empty()) channel.dimension = from.unit("unit");
  MatValue& values = from.numbers("values");
  channel.values = std::move(values.real);
  channel.imaginary = std::move(values.imaginary);
  channel.attributes = from.attributes();
  return channel;
}

MatReadOptions reading_of(const RecordingReadOptions& options) {
  return {.allow_truncated = options.allow_truncated, .progress = options.progress};
}

Recordings recordings_of_tree(MatTree tree, std::string_view variable, const std::string& path,
                              const RecordingReadOptions& options) {
  Recordings result = recordings_of(tree.root, variable, path, options);
  if (tree.truncated) {
    result.warnings.push_back(
        {"file_truncated", path + ": ends within a variable, which is left out; copy it again"});
  }
  return result;
}

}  // namespace

bool is_own_recording(MatValue& value, std::size_t element) {
  const MatValue* schema = field_of(value, element, "schema");
  return schema != nullptr && schema->kind == MatValue::Kind::kText &&
         schema->texts == std::vector{std::string(kRecordingSchema)};
}

Recording own_recording(MatValue& value, std::size_t element, const std::string& place) {
  OwnStruct from(value, element, place);
  Recording recording;
  recording.source = from.text("source");
  recording.axis.dimension = from.unit("axis_unit");
  if (from.has("axis")) {
    recording.axis.values = std::move(from.numbers("axis").real);
  } else {
    recording.axis.start = from.number("start");
    recording.axis.step = from.number("step");
  }
  recording.attributes = from.attributes();
  MatValue& channels = from.field("channels", MatValue::Kind::kStruct, "a struct");
  for (std::size_t i = 0; i < channels.count(); ++i) {
    recording.channels.push_back(own_channel(channels, i, place));
  }
  return recording;
}

Recordings read_recordings_mat(const std::string& path, std::string_view variable,
                               const RecordingReadOptions& options) {
  return recordings_of_tree(read_mat_tree(path, reading_of(options)), variable, path, options);
}

Recordings read_recordings_mat(InputStream& file, std::string_view variable,
                               const RecordingReadOptions& options) {
  return recordings_of_tree(read_mat_tree(file, reading_of(options)), variable, file.name(),
                            options);
}

Recordings read_recordings_mat73(const std::string& path, std::string_view variable,
                                 const RecordingReadOptions& options) {
  return recordings_of_tree(read_mat73_tree(path, reading_of(options)), variable, path, options);
}

Recordings read_recordings_hdf5_or_octave(const std::string& path,
                                          const RecordingReadOptions& options) {
  Hdf5Recordings read = read_hdf5_file(path, options);
  if (!read.of_octave) return std::move(read.recordings);
  return recordings_of(read.variables.root, {}, path, options);
}

}  // namespace microslip
