// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "microslip/base/units.hpp"
#include "microslip/io/responses/frequency_response.hpp"
#include "microslip/io/uff/uff58_header.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// A function between two points of a structure as a frequency response, whatever file it is from.
/// Internal to io.

namespace microslip {

/// Contents of a file on it; what it refers to must outlive it.
struct NodalFunction {
  std::string name;    ///< "dataset 3", for messages
  UffPoint response;   ///< where the motion is, and its direction
  UffPoint reference;  ///< of the force
  const Axis& axis;
  const std::optional<Dimension>& dimension;  ///< nothing: without unit
  std::span<const double> values;
  std::span<const double> imaginary;   ///< empty where it is real
  std::string_view unit_rule;          ///< that one without unit breaks: "must have …"
  std::string_view unit_remedy;        ///< and what to do about it
  std::string_view point_remedy = {};  ///< remedy for a point without node

  /// "dataset 3 (node 5 x by a force at node 1 x)". @throws InputError  without node or direction.
  [[nodiscard]] std::string full_name() const;
};

/// Without the lines at 0 Hz.
/// @throws InputError  naming it, where it has no node or direction, no unit, is not a motion over
///                     a force, is real, not finite or over no rising frequency.
[[nodiscard]] FrequencyResponse frequency_response(const NodalFunction& function);

}  // namespace microslip
