// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Effects of sessions and conditions of the tests of a campaign, as in its tables.

namespace microslip {

/// A mode in a session compared with the joints that were identified from all. NaN where the levels
/// do not determine it. Of a rig there is one mode.
struct SessionEffect {
  std::string name = {};   ///< of the session
  std::size_t mode = 1;    ///< from 1
  std::size_t tests = 0;   ///< with levels
  std::size_t levels = 0;  ///< of these
  /// Mean of y less that of the first session that has levels of the mode, 1.
  double frequency_difference = std::numeric_limits<double>::quiet_NaN();
  /// σ of that, 1; NaN also where no session has two levels.
  double frequency_difference_std = std::numeric_limits<double>::quiet_NaN();
  double frequency_offset = 0.0;      ///< δ: the difference where offsets are fitted, else 0, 1
  double frequency_offset_std = 0.0;  ///< σ of that, 1
  /// Of y about its mean over the session, rms, 1.
  double frequency_scatter = std::numeric_limits<double>::quiet_NaN();
  double dissipation_offset = std::numeric_limits<double>::quiet_NaN();   ///< mean of r, 1
  double dissipation_scatter = std::numeric_limits<double>::quiet_NaN();  ///< of r about it, rms, 1
  /// Whether its amplitudes lie all below or all above those of the first session, and by how much
  /// the mean of ln f̂ over it is off that of the first, 1: what the joint softens by in between is
  /// then part of the offset, with no level that holds the two apart.
  bool apart = false;
  double softening = 0.0;  ///< 0 without frequencies
};

/// A mean with its standard deviation. NaN where it is not known.
struct ConditionMean {
  double mean = std::numeric_limits<double>::quiet_NaN();   ///< 1
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< 1
};

/// The levels of tests in which a condition has one value, against the joint identified from all.
struct ConditionGroup {
  std::string value = {};             ///< as text
  std::optional<double> number = {};  ///< nothing of a text
  std::size_t tests = 0;              ///< with levels
  std::size_t levels = 0;             ///< of these
  double least = 0.0;                 ///< amplitude, m
  double largest = 0.0;               ///< as above
  ConditionMean dissipation = {};     ///< of r = ln(D/D̂)
  /// Of y = ln(f/f̂) less the offset of the session and, of a model, what is wrong with the mode.
  ConditionMean frequency = {};
};

/// One condition of the tests to identify from.
struct ConditionEffect {
  std::string name = {};  ///< torque_Nm
  std::vector<ConditionGroup> groups =
      {};  ///< by rising number, texts in alphabetical order behind
  /// Slope of r over the condition by weighted least squares of the means, 1 a unit of the
  /// condition; NaN where a value is no number, there is one, or a σ is not known.
  ConditionMean dissipation_trend = {};
  ConditionMean frequency_trend = {};  ///< trend of y
  bool overlap = true;                 ///< whether the amplitudes of all groups do
  bool common_modes = true;            ///< whether all groups have levels of one mode

  /// Whether tests of different values are of one joint here.
  [[nodiscard]] bool pooled() const { return groups.size() > 1; }
};

}  // namespace microslip
