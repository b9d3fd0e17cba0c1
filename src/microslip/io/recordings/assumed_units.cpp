// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/assumed_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

constexpr std::string_view kOption = "`assume_units`";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::optional<Dimension> quantity_of(const Channel& channel) {
  for (const auto& [name, value] : channel.attributes) {
    if (name == "quantity") return quantity_of_name(value);
  }
  return quantity_of_name(channel.name);
}

std::pair<std::string, Unit> parse_argument(const std::string& argument) {
  const std::size_t sign = argument.rfind('=');  // a name may hold the sign, a unit does not
  const std::string name(trimmed(std::string_view(argument).substr(0, sign)));
  if (sign == std::string::npos || name.empty()) {
    throw InputError(kOption, in_quotes(argument), "must read CHANNEL=UNIT or SI",
                     "For instance force=N.");
  }
  const std::string_view text = std::string_view(argument).substr(sign + 1);
  const std::optional<Unit> unit = find_unit(text);
  if (!unit) {
    throw InputError(kOption, in_quotes(argument),
                     fmt::format("{} must be a known unit", in_quotes(text)),
                     "For instance N, m/s^2, g, um, or 1 for a number.");
  }
  return {name, *unit};
}

/// Gives it to each channel of that name that has no unit; how many have the name.
std::size_t assume_named(const std::string& name, const Unit& unit,
                         std::span<Recording> recordings) {
  std::size_t found = 0;
  for (Recording& recording : recordings) {
    if (std::ranges::find(recording.channels, name, &Channel::name) == recording.channels.end()) {
      continue;
    }
    recording.assume_unit(name, unit);
    ++found;
  }
  return found;
}

[[noreturn]] void throw_missing(const std::string& name, std::span<const Recording> recordings) {
  if (recordings.size() == 1) {
    (void)recordings.front().channel(name);  // names the channels there are
  }
  throw InputError(kOption, in_quotes(name), "must be a channel of one of the recordings");
}

}  // namespace

std::optional<Unit> AssumedUnits::find(std::string_view name) const {
  for (const auto& [channel, unit] : named) {
    if (channel == name) return unit;
  }
  const std::optional<Dimension> dimension = quantity_of_name(name);
  if (!si || !dimension) return std::nullopt;
  return Unit{.dimension = *dimension};
}

bool AssumedUnits::names(std::string_view name) const {
  return std::ranges::any_of(named, [&](const auto& entry) { return entry.first == name; });
}

AssumedUnits parse_assumed_units(std::span<const std::string> arguments) {
  AssumedUnits units;
  for (const std::string& argument : arguments) {
    if (argument == "SI") {
      units.si = true;
      continue;
    }
    auto entry = parse_argument(argument);
    if (units.names(entry.first)) {
      throw InputError(kOption, in_quotes(argument), "must name each channel once");
    }
    units.named.push_back(std::move(entry));
  }
  return units;
}

void assume_units(const AssumedUnits& units, std::span<Recording> recordings) {
  for (const auto& [name, unit] : units.named) {
    if (assume_named(name, unit, recordings) == 0 && !axis_dimension(name)) {
      throw_missing(name, recordings);
    }
  }
  if (!units.si) return;
  for (Recording& recording : recordings) {
    for (const Channel& channel : recording.channels) {
      const std::optional<Dimension> dimension =
          channel.dimension ? std::nullopt : quantity_of(channel);
      if (dimension) recording.assume_unit(channel.name, Unit{.dimension = *dimension});
    }
  }
}

std::optional<Dimension> axis_dimension(std::string_view name) {
  const std::optional<Dimension> dimension = quantity_of_name(name);
  const bool axis = dimension == kTime || dimension == kFrequency;
  const bool one_word = std::ranges::all_of(name, [](char c) { return is_letter(c); });
  return axis && one_word ? dimension : std::nullopt;
}

}  // namespace microslip
