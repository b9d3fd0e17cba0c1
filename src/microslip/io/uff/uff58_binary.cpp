// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>

#include "microslip/io/uff/uff58.hpp"
#include "microslip/io/uff/uff_floats.hpp"

namespace microslip {
namespace {

/// Bytes read and decoded at once: they stay in the second-level cache.
constexpr std::size_t kBlock = std::size_t{1} << 17U;

/// The fields of the line 58b that say how values are stored.
struct BinaryForm {
  std::int64_t byte_order = 0;
  std::int64_t float_format = 0;
  std::int64_t bytes = 0;
};

/// How the values of a point lie.
struct PointLayout {
  std::size_t x_size = 0;  ///< bytes; 0 where spacing is even
  std::size_t value_size = 0;
  std::size_t components = 0;

  [[nodiscard]] std::size_t bytes() const { return x_size + value_size * components; }
};

BinaryForm read_form(const UffDataset& dataset, const TextPlace& place) {
  UffFields fields(dataset.id_line, place);
  fields.skip(7);
  BinaryForm form;
  form.byte_order = fields.integer(6, "the byte order");
  form.float_format = fields.integer(6, "the floating-point format");
  fields.skip(12);  // the number of lines of text: 11
  form.bytes = fields.integer(12, "the number of bytes");
  return form;
}

/// Those that the header allows, the likelier first: x of uneven double values takes 8 bytes in
/// as writers do, and 4 by the letter of the standard.
std::vector<PointLayout> possible_layouts(const Uff58Header& header) {
  const std::size_t size = header.is_double ? 8 : 4;
  std::vector<PointLayout> layouts{
      {.x_size = header.even ? 0 : size, .value_size = size, .components = header.components()}};
  if (!header.even && header.is_double) {
    layouts.push_back({.x_size = 4, .value_size = 8, .components = header.components()});
  }
  return layouts;
}

/// Whether so many bytes ahead the dataset is closed. Some writers put a line break before that.
bool is_closed_at(UffInput& input, std::size_t offset) {
  constexpr std::size_t kTwoLines = 2 + 80 + 2;
  const std::string bytes = input.peek(offset, kTwoLines);
  std::string_view text = bytes;
  if (text.starts_with('\r')) text.remove_prefix(1);
  if (text.starts_with('\n')) text.remove_prefix(1);
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return is_uff_marker(text);
}

/// The layout by which the announced bytes, or else the closing line, are where they must be.
std::optional<PointLayout> find_layout(UffInput& input, const Uff58Header& header,
                                       std::int64_t announced) {
  const std::vector<PointLayout> layouts = possible_layouts(header);
  const auto fits = [&](const PointLayout& layout) {
    return header.points <= input.remaining() / layout.bytes();
  };
  const auto closes = [&](const PointLayout& layout) {
    return fits(layout) && is_closed_at(input, header.points * layout.bytes());
  };
  const auto is_announced = [&](const PointLayout& layout) {
    return announced >= 0 &&
           static_cast<std::uint64_t>(announced) / layout.bytes() == header.points &&
           static_cast<std::uint64_t>(announced) % layout.bytes() == 0;
  };
  for (const PointLayout& layout : layouts) {
    if (is_announced(layout) && closes(layout)) return layout;
  }
  for (const PointLayout& layout : layouts) {
    if (closes(layout)) return layout;
  }
  for (const PointLayout& layout : layouts) {
    if (is_announced(layout)) return layout;
  }
  return std::nullopt;
}

PointLayout choose_layout(UffEnvelope& envelope, const Uff58Header& header, std::int64_t announced,
                          std::vector<Warning>& warnings) {
  UffInput& input = envelope.input();
  const std::optional<PointLayout> found = find_layout(input, header, announced);
  const PointLayout layout = found.value_or(possible_layouts(header).front());
  const bool too_few = header.points > input.remaining() / layout.bytes();
  if (!found && !too_few) {
    throw FormatError(
        input.place(),
        fmt::format("the line '    -1' after the {} bytes of the {} points of {}",
                    header.points * layout.bytes(), header.points, envelope.dataset_name()),
        fmt::format("other bytes, and {} bytes announced", announced),
        "The header and the values of the dataset contradict each other.");
  }
  if (!too_few && static_cast<std::uint64_t>(announced) != header.points * layout.bytes()) {
    warnings.push_back(
        {"uff_byte_count",
         fmt::format(
             "{}: {} bytes are announced, its {} points need {}; they are read by their number",
             envelope.dataset_name(), announced, header.points, header.points * layout.bytes())});
  }
  return layout;
}

UffFloat float_of(UffEnvelope& envelope, const BinaryForm& form, std::size_t size) {
  if (const auto found = uff_float(form.byte_order, form.float_format, size)) return *found;
  constexpr std::array<std::string_view, 4> kFormats{"an unknown format", "DEC VMS", "IEEE 754",
                                                     "IBM"};
  const bool known = form.float_format > 0 && form.float_format < 4;
  throw FormatError(
      envelope.input().place(), "binary values in IEEE 754 (format 2) of byte order 1 or 2",
      fmt::format("format {} ({}), byte order {}, {} bytes per value, in {}", form.float_format,
                  kFormats[known ? static_cast<std::size_t>(form.float_format) : 0],
                  form.byte_order, size, envelope.dataset_name()),
      "Export it again as text (58) or in IEEE 754.");
}

/// Bytes that are doubles of this machine go straight to where they belong. The vector grows by
/// blocks, so that its zeros never leave the cache.
void read_doubles(UffInput& input, std::size_t count, std::vector<double>& values) {
  constexpr std::size_t kAtOnce = kBlock / sizeof(double);
  values.reserve(count);
  while (values.size() < count) {
    const std::size_t start = values.size();
    values.resize(std::min(start + kAtOnce, count));
    input.read(
        {reinterpret_cast<char*>(values.data() + start), (values.size() - start) * sizeof(double)});
  }
}

void read_points(UffInput& input, const PointLayout& layout, UffFloat x_format,
                 UffFloat value_format, std::size_t points, Uff58& data) {
  data.values.reserve(points);
  data.x.reserve(layout.x_size > 0 ? points : 0);
  data.imaginary.reserve(layout.components > 1 ? points : 0);
  const std::size_t stride = layout.bytes();
  std::vector<char> block(std::min(kBlock / stride, std::max<std::size_t>(points, 1)) * stride);
  for (std::size_t done = 0; done < points;) {
    const std::size_t count = std::min(block.size() / stride, points - done);
    input.read(std::span(block).first(count * stride));
    const auto append = [&](std::vector<double>& target, UffFloat format, std::size_t offset) {
      target.resize(done + count);
      decode_uff_floats(format, block.data() + offset, stride, std::span(target).last(count));
    };
    if (layout.x_size > 0) append(data.x, x_format, 0);
    append(data.values, value_format, layout.x_size);
    if (layout.components > 1) {
      append(data.imaginary, value_format, layout.x_size + layout.value_size);
    }
    done += count;
  }
}

/// The bytes of values before the end of a dataset that is shorter than its header says: up to the
/// closing line, where the announced number of bytes or the end of the file lead to it.
std::size_t bytes_before_end(UffInput& input, std::int64_t announced) {
  const std::size_t remaining = input.remaining();
  if (announced >= 0 && static_cast<std::size_t>(announced) < remaining &&
      is_closed_at(input, static_cast<std::size_t>(announced))) {
    return static_cast<std::size_t>(announced);
  }
  constexpr std::size_t kLine = 82;
  const std::size_t start = remaining - std::min(remaining, kLine);
  const std::size_t marker = input.peek(start, kLine).rfind("    -1");
  const bool closed = marker != std::string::npos && is_closed_at(input, start + marker);
  return closed ? start + marker : remaining;
}

[[noreturn]] void fail_truncated(UffEnvelope& envelope, const Uff58Header& header,
                                 const PointLayout& layout, std::size_t there) {
  throw UffTruncated(envelope.input().place(),
                     fmt::format("{} bytes ({} points) in {}", header.points * layout.bytes(),
                                 header.points, envelope.dataset_name()),
                     fmt::format("{} before its end", there),
                     "Record or export it again, or read what is left with `allow_truncated`.");
}

constexpr UffFloat kNativeDouble =
    std::endian::native == std::endian::little ? UffFloat::kIeee8Little : UffFloat::kIeee8Big;

}  // namespace

void read_uff58_binary_values(UffEnvelope& envelope, const UffDataset& dataset, Uff58& data,
                              bool allow_truncated, std::vector<Warning>& warnings) {
  UffInput& input = envelope.input();
  const BinaryForm form = read_form(dataset, input.place());
  const PointLayout layout = choose_layout(envelope, data.header, form.bytes, warnings);
  const UffFloat value_format = float_of(envelope, form, layout.value_size);
  const UffFloat x_format =
      layout.x_size > 0 ? float_of(envelope, form, layout.x_size) : value_format;
  std::size_t points = data.header.points;
  if (points > input.remaining() / layout.bytes()) {
    const std::size_t there = bytes_before_end(input, form.bytes);
    if (!allow_truncated) fail_truncated(envelope, data.header, layout, there);
    points = std::min(points, there / layout.bytes());
  }
  if (layout.bytes() == sizeof(double) && value_format == kNativeDouble) {
    read_doubles(input, points, data.values);
  } else {
    read_points(input, layout, x_format, value_format, points, data);
  }
}

}  // namespace microslip
