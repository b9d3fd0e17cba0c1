// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "microslip/io/recordings/doubtful_unit.hpp"
#include "microslip/io/uff/uff_attributes.hpp"
#include "microslip/io/uff/uff_axis.hpp"

namespace microslip {
namespace {

void to_si(std::vector<double>& values, const Unit& unit) {
  if (unit.factor() == 1.0) return;
  for (double& value : values) value = unit.to_si(value);
}

void forget_unknown(UffQuantity& quantity) {
  if (quantity.unit == kUnknownUffUnit) quantity.unit.clear();
}

/// The labels become those of SI, since that is what the values now are in.
void set_si_labels(Uff58Header& header, const std::optional<Unit>& abscissa,
                   const std::optional<Unit>& ordinate, const std::optional<Unit>& denominator) {
  const auto set = [](UffQuantity& quantity, const Dimension& dimension) {
    if (const auto label = find_uff_unit_label(dimension)) quantity.unit = *label;
  };
  if (abscissa) set(header.abscissa, abscissa->dimension);
  if (ordinate && denominator) {
    set(header.ordinate, ordinate->dimension * denominator->dimension);
    const bool used = header.denominator.type != 0 || !header.denominator.unit.empty();
    if (used) set(header.denominator, denominator->dimension);
  }
  for (UffQuantity* quantity :
       {&header.abscissa, &header.ordinate, &header.denominator, &header.z_axis}) {
    forget_unknown(*quantity);
  }
}

/// A unit that no label can name again counts as unknown.
std::optional<Unit> only_if_named(const std::optional<Unit>& unit) {
  return unit && find_uff_unit_label(unit->dimension) ? unit : std::nullopt;
}

bool is_si(const std::optional<Unit>& unit, const Dimension& dimension) {
  return unit && unit->dimension == dimension && unit->factor() == 1.0;
}

/// In a line of the header, or as the unit of length of the file.
bool has_factor_of_gravity(const Uff58Header& header, const std::optional<Uff164>& units) {
  return std::ranges::any_of(header.id_lines,
                             [](const auto& line) { return says_per_gravity(line); }) ||
         (units && says_per_gravity(fmt::format("{}", units->length)));
}

/// Attributes may be of other units than the values are now.
void make_units_true(Uff58Header& header, const Uff58Header& usual, const Dimension& axis,
                     const std::optional<Dimension>& values) {
  const std::optional<Uff164> si = Uff164{};
  const auto abscissa = uff_abscissa_unit(header, si);
  if (axis == kDimensionless && abscissa && header.abscissa.unit.empty()) {
    header.abscissa.unit = kUnknownUffUnit;
  } else if (!is_si(abscissa, axis) && (abscissa || axis != kDimensionless)) {
    header.abscissa = usual.abscissa;
  }
  if (!values) {
    if (uff_ordinate_unit(header, si)) header.ordinate.unit = kUnknownUffUnit;
  } else if (!is_si(uff_ordinate_unit(header, si), *values)) {
    header.ordinate = usual.ordinate;
    header.denominator = usual.denominator;
  }
}

bool has_attribute(const Channel& channel, std::string_view name) {
  return std::any_of(channel.attributes.begin(), channel.attributes.end(),
                     [&](const auto& attribute) { return attribute.first == name; });
}

/// ID line 1 is the name, unless the lines that were read give these names again.
void set_first_lines(const Recording& recording, std::vector<Uff58Header>& headers) {
  for (std::size_t i = 0; i < headers.size(); ++i) {
    const Channel& channel = recording.channels[i];
    if (!has_attribute(channel, "id line 1")) headers[i].id_lines[0] = channel.name;
  }
  const std::vector<std::string> names = uff_channel_names(headers);
  const bool same = std::equal(names.begin(), names.end(), recording.channels.begin(),
                               [](const auto& name, const auto& c) { return name == c.name; });
  if (same) return;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    headers[i].id_lines[0] = recording.channels[i].name;
  }
}

}  // namespace

UffChannel uff_channel(Uff58 data, const std::optional<Uff164>& units) {
  UffChannel channel;
  channel.header = std::move(data.header);
  Uff58Header& header = channel.header;
  const std::optional<Unit> abscissa = only_if_named(uff_abscissa_unit(header, units));
  std::optional<Unit> ordinate = only_if_named(uff_ordinate_unit(header, units));
  if (ordinate && is_gravity(*ordinate) && has_factor_of_gravity(header, units)) {
    channel.doubtful = true;
    ordinate.reset();
  }
  const std::optional<Unit> denominator = uff_denominator_unit(header, units);
  channel.axis = header.even ? even_uff_axis(header.start, header.step, abscissa.value_or(Unit{}))
                             : uneven_uff_axis(std::move(data.x), abscissa.value_or(Unit{}));
  channel.values = std::move(data.values);
  channel.imaginary = std::move(data.imaginary);
  if (ordinate) {
    channel.dimension = ordinate->dimension;
    to_si(channel.values, *ordinate);
    to_si(channel.imaginary, *ordinate);
  }
  set_si_labels(header, abscissa, ordinate, denominator);
  return channel;
}

std::vector<Channel> uff_channels(const Dimension& axis, std::vector<UffChannel> channels) {
  std::vector<Uff58Header> headers;
  for (UffChannel& channel : channels) headers.push_back(std::move(channel.header));
  const std::vector<std::string> names = uff_channel_names(headers);
  std::vector<Channel> result;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    Uff58Header& header = headers[i];
    UffChannel& channel = channels[i];
    if (header.id_lines[0] == names[i]) header.id_lines[0].clear();
    Uff58Header usual = usual_uff58_header(axis, channel.dimension, header.is_complex);
    Attributes attributes = uff58_attributes(header, usual);
    result.push_back({.name = names[i],
                      .dimension = channel.dimension,
                      .values = std::move(channel.values),
                      .imaginary = std::move(channel.imaginary),
                      .attributes = std::move(attributes)});
  }
  return result;
}

std::vector<Uff58Header> uff58_headers(const Recording& recording) {
  const Axis& axis = recording.axis;
  std::vector<Uff58Header> headers;
  for (const Channel& channel : recording.channels) {
    const Uff58Header usual =
        usual_uff58_header(axis.dimension, channel.dimension, !channel.imaginary.empty());
    Uff58Header header = usual;
    apply_uff58_attributes(channel.attributes, header);
    make_units_true(header, usual, axis.dimension, channel.dimension);
    header.points = channel.values.size();
    header.even = axis.even();
    header.start = axis.even() ? axis.start : 0.0;
    header.step = axis.even() ? axis.step : 0.0;
    headers.push_back(std::move(header));
  }
  set_first_lines(recording, headers);
  return headers;
}

}  // namespace microslip
