// SPDX-License-Identifier: MIT
#include "microslip/signal/recording/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/base/error.hpp"
#include "microslip/signal/recording/missing_values.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

std::string name_of(const Recording& recording, std::string_view channel) {
  return fmt::format("{}: channel '{}'", recording.source, channel);
}

[[noreturn]] void throw_missing(const Recording& recording, std::string_view name) {
  const auto left_out = std::ranges::find(recording.left_out, name, &LeftOutChannel::name);
  if (left_out != recording.left_out.end()) {
    throw InputError(name_of(recording, name), InputState{"left out"},
                     fmt::format("must have a value at each point; {}", left_out->reason));
  }
  throw InputError(name_of(recording, name), InputState{"missing"},
                   fmt::format("the recording has {}", names_of_channels(recording)),
                   "Give a name from there.");
}

/// A name of another quantity than the one sought is a hint that another channel was meant:
/// following the remedy must not make metres of an acceleration.
[[noreturn]] void throw_without_unit(const Recording& recording, std::string_view name,
                                     const Dimension& expected) {
  const Dimension likely = quantity_of_name(name).value_or(expected);
  const Attributes& attributes = recording.channel(name).attributes;
  const auto unknown = std::ranges::find(attributes, "unit", &Attributes::value_type::first);
  const std::string state =
      unknown == attributes.end()
          ? "without unit"
          : fmt::format("labelled '{}', which is unknown or doubtful", unknown->second);
  std::string rule = unknown == attributes.end() ? "must have a unit" : "must have a known unit";
  std::string remedy =
      fmt::format("Give its unit with `assume_units {}={}`", name, si_unit(likely));
  if (likely == expected) {
    rule += " of " + dimension_name(expected);
  } else {
    remedy += fmt::format(", if it is {} as its name states", dimension_name(likely));
  }
  throw InputError(name_of(recording, name), InputState{state}, rule, remedy + ".");
}

std::size_t count_not_finite(std::span<const double> values) {
  return static_cast<std::size_t>(
      std::ranges::count_if(values, [](double v) { return !std::isfinite(v); }));
}

bool is_whole(const Channel& channel) {
  return count_not_finite(channel.values) == 0 && count_not_finite(channel.imaginary) == 0;
}

/// Why the values of a channel are missing, as far as its reader has said so.
std::string missing_because(const Attributes& attributes) {
  const auto found =
      std::ranges::find(attributes, kMissingAttribute, &Attributes::value_type::first);
  return found == attributes.end() ? std::string{} : found->second;
}

std::string reason_of(const Channel& channel) {
  const std::vector<double>& values =
      count_not_finite(channel.values) > 0 ? channel.values : channel.imaginary;
  const auto bad = std::ranges::find_if_not(values, [](double v) { return std::isfinite(v); });
  const std::string because = missing_because(channel.attributes);
  return fmt::format("{} of its {} values are missing or not finite, the first at point {}{}{}",
                     count_not_finite(values), values.size(),
                     std::distance(values.begin(), bad) + 1, because.empty() ? "" : ": ", because);
}

void check_finite(const Recording& recording, std::string_view name, std::span<const double> values,
                  const Attributes& attributes = {}) {
  const auto bad = std::ranges::find_if_not(values, [](double v) { return std::isfinite(v); });
  if (bad == values.end()) return;
  const std::string place =
      fmt::format("{}, point {}", name_of(recording, name), std::distance(values.begin(), bad) + 1);
  const std::string rule = count_not_finite(values) == 1
                               ? "must be finite"
                               : fmt::format(
                                     "must be finite; {} of {} values are missing or not "
                                     "finite",
                                     count_not_finite(values), values.size());
  const std::string because = missing_because(attributes);
  if (!because.empty()) {
    throw InputError(place, InputState{fmt::format("without value: {}", because)}, rule,
                     "If it is a value, correct what the file states of it.");
  }
  throw InputError(place, *bad, rule, "Cut the record where it is whole.");
}

void check_axis(const Recording& recording) {
  const Axis& axis = recording.axis;
  if (axis.even()) {
    if (!(axis.step > 0.0 && std::isfinite(axis.step) && std::isfinite(axis.start))) {
      throw InputError(recording.source + ": step of the axis", axis.step,
                       "must be above 0 and finite");
    }
    return;
  }
  check_finite(recording, "axis", axis.values);
  const auto fall = std::ranges::adjacent_find(axis.values, std::greater_equal<>{});
  if (fall == axis.values.end()) return;
  throw InputError(fmt::format("{}: point {} of the axis", recording.source,
                               std::distance(axis.values.begin(), fall) + 2),
                   *std::next(fall), fmt::format("must be above {}, the point before it", *fall));
}

void check_channel(const Recording& recording, const Channel& channel, std::size_t points) {
  if (channel.name.empty()) {
    throw InputError(recording.source + ": name of a channel", "''", "must not be empty");
  }
  if (channel.values.size() != points ||
      (!channel.imaginary.empty() && channel.imaginary.size() != points)) {
    throw InputError(name_of(recording, channel.name) + " length",
                     fmt::format("{}", channel.values.size()),
                     fmt::format("must be {}, that of the others", points));
  }
  check_finite(recording, channel.name, channel.values, channel.attributes);
  check_finite(recording, channel.name, channel.imaginary, channel.attributes);
}

}  // namespace

std::string names_of_channels(const Recording& recording) {
  std::string names;
  for (const Channel& channel : recording.channels) {
    names += (names.empty() ? "'" : ", '") + channel.name + "'";
  }
  return names.empty() ? "none" : names;
}

std::vector<std::string> leave_out_incomplete(Recording& recording) {
  std::vector<std::string> reasons;
  if (std::ranges::none_of(recording.channels, is_whole)) return reasons;
  std::erase_if(recording.channels, [&](const Channel& channel) {
    if (is_whole(channel)) return false;
    recording.left_out.push_back({channel.name, reason_of(channel)});
    reasons.push_back(fmt::format("channel '{}' is left out: {}", channel.name,
                                  recording.left_out.back().reason));
    return true;
  });
  return reasons;
}

const Channel& Recording::channel(std::string_view name) const {
  const auto found = std::ranges::find(channels, name, &Channel::name);
  if (found == channels.end()) throw_missing(*this, name);
  return *found;
}

std::span<const double> Recording::signal(std::string_view name, const Dimension& expected) const {
  const Channel& found = channel(name);
  if (axis.dimension != kTime) {
    throw InputError(name_of(*this, name), InputState{"over " + dimension_name(axis.dimension)},
                     "must be over time");
  }
  if (!found.imaginary.empty()) {
    throw InputError(name_of(*this, name), InputState{"complex"}, "must be real");
  }
  if (!found.dimension) throw_without_unit(*this, name, expected);
  if (*found.dimension != expected) {
    throw InputError(
        name_of(*this, name), dimension_name(*found.dimension),
        fmt::format("must be {}, in {}", dimension_name(expected), usual_units(expected)));
  }
  return found.values;
}

void Recording::assume_unit(std::string_view name, const Unit& unit) {
  const auto found = std::ranges::find(channels, name, &Channel::name);
  if (found == channels.end()) throw_missing(*this, name);
  if (found->dimension) {
    throw InputError(name_of(*this, name), dimension_name(*found->dimension),
                     "must have no unit if one is assumed", "The unit in the file is used.");
  }
  found->dimension = unit.dimension;
  for (double& value : found->values) value = unit.to_si(value);
  for (double& value : found->imaginary) value = unit.to_si(value);
}

void check_recording(const Recording& recording) {
  if (recording.channels.empty()) {
    throw InputError(recording.source, "no channel", "must have at least one");
  }
  const std::size_t points =
      recording.axis.even() ? recording.size() : recording.axis.values.size();
  if (points < 2) {
    throw InputError(recording.source, fmt::format("{} points", points), "must have at least 2");
  }
  check_axis(recording);
  std::vector<std::string_view> names;
  for (const Channel& channel : recording.channels) {
    check_channel(recording, channel, points);
    names.push_back(channel.name);
  }
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  if (twice == names.end()) return;
  throw InputError(name_of(recording, *twice), "there twice", "must have a unique name");
}

}  // namespace microslip
