// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/recordings/recording_csv_header.hpp"

namespace microslip {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20U;

std::string_view axis_name(const Axis& axis) {
  if (axis.dimension == kTime) return "time";
  if (axis.dimension == kFrequency) return "frequency";
  throw InputError("axis", dimension_name(axis.dimension), "must be time or frequency in CSV",
                   "Write the recording to another format.");
}

void append_attribute(std::string& text, std::string_view name, std::string_view value) {
  text += name == "comment" ? fmt::format("# {}\n", on_one_line(value))
                            : fmt::format("# {}: {}\n", on_one_line(name), on_one_line(value));
}

void append_name(std::string& text, std::string_view name, std::string_view mark,
                 const std::optional<Dimension>& dimension) {
  std::string cell = on_one_line(name);
  cell += mark;
  if (dimension) {
    cell += fmt::format(" [{}]", si_unit(*dimension));
  } else if (cell.ends_with(')')) {
    cell += " []";  // or it would be taken for a unit
  }
  text += ',';
  append_text_cell(text, cell);
}

std::string header_of(const Recording& recording) {
  std::string text;
  for (const auto& [name, value] : recording.attributes) append_attribute(text, name, value);
  for (const Channel& channel : recording.channels) {
    for (const auto& [name, value] : channel.attributes) {
      append_attribute(text, fmt::format("{}{}{}", channel.name, kChannelMark, name), value);
    }
  }
  text += fmt::format("{} [{}]", axis_name(recording.axis), si_unit(recording.axis.dimension));
  for (const Channel& channel : recording.channels) {
    const bool complex = !channel.imaginary.empty();
    append_name(text, channel.name, complex ? kRealMark : "", channel.dimension);
    if (complex) append_name(text, channel.name, kImaginaryMark, channel.dimension);
  }
  return text + '\n';
}

void append_row(std::string& text, const Recording& recording, std::size_t row) {
  append_number(text, recording.axis.at(row));
  for (const Channel& channel : recording.channels) {
    text += ',';
    append_number(text, channel.values[row]);
    if (channel.imaginary.empty()) continue;
    text += ',';
    append_number(text, channel.imaginary[row]);
  }
  text += '\n';
}

/// Brackets in a name would be read as those of a unit, the name of the axis as another axis.
void check_names(const Recording& recording) {
  for (const Channel& channel : recording.channels) {
    if (channel.name.find('[') == std::string::npos && channel.name != axis_name(recording.axis)) {
      continue;
    }
    throw InputError(recording.source + ": name of a channel", in_quotes(channel.name),
                     "must have no [ in CSV and not be that of the axis",
                     "Write the recording to another format.");
  }
}

std::string checked_header(const Recording& recording) {
  check_recording(recording);
  check_names(recording);
  return header_of(recording);
}

}  // namespace

void write_recording_csv(const std::string& path, const Recording& recording) {
  std::string text = checked_header(recording);
  FileOutput file(path);
  for (std::size_t row = 0; row < recording.size(); ++row) {
    append_row(text, recording, row);
    if (text.size() < kBufferSize) continue;
    file.write(text);
    text.clear();
  }
  file.write(text);
  file.close();
}

std::string format_recording_csv(const Recording& recording) {
  std::string text = checked_header(recording);
  for (std::size_t row = 0; row < recording.size(); ++row) append_row(text, recording, row);
  return text;
}

}  // namespace microslip
