// SPDX-License-Identifier: MIT
#include "microslip/io/assumed_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "microslip/base/error.hpp"
#include "microslip/io/text.hpp"

namespace microslip {
namespace {

constexpr std::string_view kOption = "--assume-units";

struct Word {
  std::string_view text;
  Dimension dimension;
};

constexpr std::array kWords{
    Word{"force", kForce},         Word{"acceleration", kAcceleration},
    Word{"acc", kAcceleration},    Word{"velocity", kVelocity},
    Word{"vel", kVelocity},        Word{"displacement", kLength},
    Word{"disp", kLength},         Word{"pressure", kPressure},
    Word{"time", kTime},           Word{"t", kTime},
    Word{"frequency", kFrequency}, Word{"freq", kFrequency},
};

/// The letters that a text begins with, in small.
std::string first_word(std::string_view text) {
  std::string word;
  for (const char c : text) {
    const char small = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (small < 'a' || small > 'z') break;
    word += small;
  }
  return word;
}

std::optional<Dimension> dimension_of_word(std::string_view word) {
  const auto* found = std::ranges::find(kWords, word, &Word::text);
  if (found == kWords.end()) return std::nullopt;
  return found->dimension;
}

std::optional<Dimension> quantity_of(const Channel& channel) {
  for (const auto& [name, value] : channel.attributes) {
    if (name == "quantity") return dimension_of_word(first_word(value));
  }
  return dimension_of_word(first_word(channel.name));
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
                     fmt::format("{} must be a unit that is known here", in_quotes(text)),
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
  const std::optional<Dimension> dimension = dimension_of_word(first_word(name));
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
  const std::string word = first_word(name);
  const std::optional<Dimension> dimension = dimension_of_word(word);
  const bool axis = dimension == kTime || dimension == kFrequency;
  return axis && word.size() == name.size() ? dimension : std::nullopt;
}

}  // namespace microslip
