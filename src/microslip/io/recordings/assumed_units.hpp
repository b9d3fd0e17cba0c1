// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// Units for the channels of a file, and the time or frequency they are over, that the file gives
/// none.
struct AssumedUnits {
  /// Each channel without unit whose quantity the file names is in the SI unit of it. A file names
  /// it in the attribute `quantity` of the channel ("force"), or by the channel's name, see
  /// quantity_of_name().
  bool si = false;
  /// By name of the channel; these go before `si`.
  std::vector<std::pair<std::string, Unit>> named;

  /// Unit assumed for a name without unit; nothing where none is.
  [[nodiscard]] std::optional<Unit> find(std::string_view name) const;
  /// Whether `named` has it.
  [[nodiscard]] bool names(std::string_view name) const;
};

/// Of the arguments of --assume-units: each `CHANNEL=UNIT` or `SI`.
/// @throws InputError  where one has another form, its unit is unknown, or a channel comes twice.
[[nodiscard]] AssumedUnits parse_assumed_units(std::span<const std::string> arguments);

/// Gives the channels without unit the units that are assumed; their values become SI.
/// @throws InputError  where a channel of `named` is in none of the recordings, unless it is called
///                     as a time or frequency is, or has a unit.
void assume_units(const AssumedUnits& units, std::span<Recording> recordings);

/// The dimension of time or frequency where a column is called as one is: time, t, frequency or
/// freq, in capitals or not.
[[nodiscard]] std::optional<Dimension> axis_dimension(std::string_view name);

}  // namespace microslip
