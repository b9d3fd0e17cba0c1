// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff58_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <iterator>

namespace microslip {
namespace {

constexpr std::size_t kRecord = 80;
constexpr std::size_t kTextBlock = std::size_t{1} << 17U;

std::string line(std::string_view text) { return uff_padded(text, kRecord) + '\n'; }

/// NONE stands for nothing.
std::string field(std::string_view text, std::size_t width) {
  return uff_padded(uff_is_none(text) ? "NONE" : text, width);
}

std::string format_point(const UffPoint& point) {
  return fmt::format(" {}{:10d}{:4d}", field(point.entity, 10), point.node, point.direction);
}

std::string format_quantity(const UffQuantity& quantity) {
  return line(fmt::format("{:10d}{:5d}{:5d}{:5d} {} {}", quantity.type, quantity.exponents[0],
                          quantity.exponents[1], quantity.exponents[2], field(quantity.label, 20),
                          field(quantity.unit, 20)));
}

std::string format_id(const Uff58Header& header, bool binary) {
  if (!binary) return line("    58");
  constexpr int kLittleEndian = 1;
  constexpr int kIeee = 2;
  constexpr int kTextLines = 11;
  const std::size_t bytes = header.points * header.values_per_point() * sizeof(double);
  return line(fmt::format("{:6d}b{:6d}{:6d}{:12d}{:12d}{:6d}{:6d}{:12d}{:12d}", 58, kLittleEndian,
                          kIeee, kTextLines, bytes, 0, 0, 0, 0));
}

/// Appends to a text and hands it on when it is large.
class Buffer {
 public:
  explicit Buffer(FileOutput& output) : output_(output) { text_.reserve(kTextBlock + 2 * kRecord); }

  std::string& text() {
    if (text_.size() >= kTextBlock) flush();
    return text_;
  }
  void flush() {
    output_.write(text_);
    text_.clear();
  }

 private:
  FileOutput& output_;
  std::string text_;
};

/// Points of a line of text: 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
std::size_t points_per_line(const Uff58Header& header) {
  return header.even ? 4 / header.components() : 2 / header.components();
}

void write_text(FileOutput& output, const Uff58Header& header, const Uff58Values& values) {
  Buffer buffer(output);
  const std::size_t per_line = points_per_line(header);
  for (std::size_t i = 0; i < header.points;) {
    std::string& text = buffer.text();
    const std::size_t start = text.size();
    for (const std::size_t end = std::min(i + per_line, header.points); i < end; ++i) {
      const auto out = std::back_inserter(text);
      if (!header.even) fmt::format_to(out, "{:13.5E}", values.x[i]);
      fmt::format_to(out, "{:20.12E}", values.real[i]);
      if (header.is_complex) fmt::format_to(out, "{:20.12E}", values.imaginary[i]);
    }
    text.append(kRecord - (text.size() - start), ' ');
    text += '\n';
  }
  buffer.flush();
}

/// In the order of bytes of the file.
double little_endian(double value) {
  if constexpr (std::endian::native == std::endian::little) return value;
  return std::bit_cast<double>(__builtin_bswap64(std::bit_cast<std::uint64_t>(value)));
}

void write_binary(FileOutput& output, const Uff58Header& header, const Uff58Values& values) {
  std::array<std::span<const double>, 3> parts{};
  std::size_t count = 0;
  if (!header.even) parts[count++] = values.x;
  parts[count++] = values.real;
  if (header.is_complex) parts[count++] = values.imaginary;

  std::vector<double> block;
  const std::size_t at_once = kTextBlock / sizeof(double) / count;
  for (std::size_t done = 0; done < header.points;) {
    const std::size_t points = std::min(at_once, header.points - done);
    block.resize(points * count);
    for (std::size_t part = 0; part < count; ++part) {
      for (std::size_t i = 0; i < points; ++i) {
        block[i * count + part] = little_endian(parts[part][done + i]);
      }
    }
    output.write({reinterpret_cast<const char*>(block.data()), block.size() * sizeof(double)});
    done += points;
  }
}

std::string format_header(const Uff58Header& header, bool binary) {
  std::string text = line("    -1") + format_id(header, binary);
  for (const std::string& id_line : header.id_lines) text += line(field(id_line, kRecord));
  text += line(fmt::format("{:5d}{:10d}{:5d}{:10d}{}{}", header.function_type, header.function_id,
                           header.version, header.load_case, format_point(header.response),
                           format_point(header.reference)));
  text += line(fmt::format("{:10d}{:10d}{:10d}{}{}{}", header.is_complex ? 6 : 4, header.points,
                           header.even ? 1 : 0, uff_e13(header.start), uff_e13(header.step),
                           uff_e13(header.z)));
  return text + format_quantity(header.abscissa) + format_quantity(header.ordinate) +
         format_quantity(header.denominator) + format_quantity(header.z_axis);
}

}  // namespace

std::string uff_e13(double value) { return fmt::format("{:13.5E}", value); }

void write_uff58(FileOutput& output, const Uff58Header& header, const Uff58Values& values,
                 bool binary) {
  output.write(format_header(header, binary));
  binary ? write_binary(output, header, values) : write_text(output, header, values);
  output.write(line("    -1"));
}

}  // namespace microslip
