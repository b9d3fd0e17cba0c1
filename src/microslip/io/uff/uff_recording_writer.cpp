// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/uff/uff151.hpp"
#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff58_writer.hpp"
#include "microslip/io/uff/uff_axis.hpp"
#include "microslip/io/uff/uff_channel.hpp"
#include "microslip/io/uff/uff_fields.hpp"
#include "microslip/io/uff/uff_recording.hpp"

namespace microslip {
namespace {

void check_name(const Recording& recording, const std::string& name) {
  constexpr std::size_t kWidth = 80;
  const bool reads_back = uff_width(name) <= kWidth && uff_text(name) == name &&
                          trimmed(name) == name && !uff_is_none(name);
  if (reads_back) return;
  throw InputError(recording.source + ": name of a channel", in_quotes(name, kWidth),
                   "must have at most 80 characters in a universal file, without control "
                   "characters or blanks at its ends, and not be NONE",
                   "Rename the channel.");
}

void check_six_digits(const Recording& recording) {
  const std::vector<double>& x = recording.axis.values;
  const auto in_text = [](double value) { return *uff_number(uff_e13(value)); };
  const auto together = std::adjacent_find(
      x.begin(), x.end(), [&](double a, double b) { return in_text(a) >= in_text(b); });
  if (together == x.end()) return;
  throw InputError(
      fmt::format("{}: point {} of the axis", recording.source, together - x.begin() + 2),
      *std::next(together),
      "must differ from the one before it in the six digits of a text universal file",
      "Write it in binary (58b).");
}

void write_recording(FileOutput& output, const Recording& recording, bool binary) {
  output.write(format_uff151(recording.attributes));
  output.write(format_uff164_si());
  const std::vector<double> x = binary ? uff_abscissae(recording) : recording.axis.values;
  std::vector<Uff58Header> headers = uff58_headers(recording);
  for (std::size_t i = 0; i < headers.size(); ++i) {
    Uff58Header& header = headers[i];
    set_abscissae(x, header);
    const Channel& channel = recording.channels[i];
    write_uff58(output, header, {x, channel.values, channel.imaginary}, binary);
  }
}

}  // namespace

void write_recordings_uff(const std::string& path, std::span<const Recording> recordings,
                          bool binary) {
  if (recordings.empty()) throw InputError("recordings", 0.0, "must be 1 or more to be written");
  for (const Recording& recording : recordings) {
    check_recording(recording);
    for (const Channel& channel : recording.channels) check_name(recording, channel.name);
    if (!binary) check_six_digits(recording);
  }
  FileOutput output(path);
  for (const Recording& recording : recordings) write_recording(output, recording, binary);
  output.close();
}

}  // namespace microslip
