// SPDX-License-Identifier: MIT
#include "io/uff_support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::test {

std::string marker() { return "    -1\n"; }

std::string quantity_line(int type, std::string_view label, std::string_view unit) {
  return fmt::format("{:10d}    0    0    0 {:<20} {:<20}\n", type, label, unit);
}

std::string header_lines(const Function58& f) {
  std::string text = fmt::format("{:<80}\nNONE\n01-Jan-24 12:00:00\nNONE\nNONE\n", f.id);
  const std::string response =
      f.response + std::string(10 - std::min<std::size_t>(10, f.response.size()), ' ');
  text += fmt::format("{:5d}         1    0         0 {}{:10d}{:4d} NONE               0   0\n",
                      f.function_type, response, f.response_node, f.response_direction);
  text += fmt::format("{:10d}{:10d}{:10d}{:>13}{:>13}  0.00000E+00\n", f.ordinate_type, f.points,
                      f.even ? 1 : 0, f.start, f.step);
  return text + quantity_line(f.abscissa_type, "Time", f.abscissa_unit) +
         (f.ordinate_line.empty() ? quantity_line(f.ordinate_type_code, "y", f.ordinate_unit)
                                  : f.ordinate_line + '\n') +
         quantity_line(f.denominator_type, "NONE", f.denominator_unit) +
         quantity_line(0, "NONE", "NONE");
}

std::string text_dataset(const Function58& f, std::string_view values) {
  return marker() + "    58\n" + header_lines(f) + std::string(values) + marker();
}

std::string binary_dataset(const Function58& f, std::string_view payload, long long announced,
                           int byte_order, int format, std::string_view before_end) {
  return marker() +
         fmt::format("{:6d}b{:6d}{:6d}{:12d}{:12d}{:6d}{:6d}{:12d}{:12d}\n", 58, byte_order, format,
                     11, announced, 0, 0, 0, 0) +
         header_lines(f) + std::string(payload) + std::string(before_end) + marker();
}

std::string ieee8(double value, bool little) {
  return bytes_of_bits(std::bit_cast<std::uint64_t>(value), little);
}

std::string ieee4(double value, bool little) {
  return bytes_of_bits(std::bit_cast<std::uint32_t>(static_cast<float>(value)), little);
}

std::string doubles(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) bytes += ieee8(value);
  return bytes;
}

Function58 three_points() {
  Function58 f;
  f.points = 3;
  return f;
}

std::string units164(int code, const std::string& length, const std::string& force) {
  return marker() + "   164\n" + fmt::format("{:10d}{:<20}{:10d}\n", code, "system", 2) +
         fmt::format("{:>25}{:>25}{:>25}\n", length, force, "1.00000000000000000D+00") +
         "  0.00000000000000000D+00\n" + marker();
}

Recordings read_uff(const std::string& content, bool allow_truncated) {
  const TemporaryFolder folder;
  put(folder.file("t.uff"), content);
  return read_recordings_uff(folder.file("t.uff"), {.allow_truncated = allow_truncated});
}

Channel read_channel(const std::string& content, bool allow_truncated) {
  Recordings read = read_uff(content, allow_truncated);
  if (read.recordings.size() != 1 || read.recordings[0].channels.size() != 1) {
    throw Error("not one channel");
  }
  return read.recordings[0].channels[0];
}

std::string uff_fault(const std::string& content) {
  const std::string message = message_of<Error>([&] { return read_uff(content); });
  const std::size_t at = message.find("t.uff");
  return at == std::string::npos ? message : message.substr(at);
}

std::vector<std::string> codes(const Recordings& read) {
  std::vector<std::string> result;
  for (const Warning& warning : read.warnings) result.push_back(warning.code);
  return result;
}

}  // namespace microslip::test
