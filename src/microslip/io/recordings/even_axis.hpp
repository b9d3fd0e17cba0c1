// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/recording/recording.hpp"

namespace microslip {

/// How finely numbers were printed: the most decimals and the most significant digits of any. A
/// value t printed like them is off by no more than half of
///   ulp(t) = max(10^−decimals, 10^(⌊log10|t|⌋ + 1 − significant)),
/// whether the number of decimals was kept or that of significant digits, trailing zeros written or
/// not.
struct PrintedDigits {
  int decimals = -400;
  int significant = 0;

  /// @param number  as printed, with a decimal point or comma and perhaps an exponent.
  void add(std::string_view number);
};

/// The axis of printed values: even where a start and a step explain all of them,
///   |t_i − (start + i·step)| ≤ max(½ ulp(t_i) + ½ ulp(t_end), 1e-6 step),
///   at most 0.24 step, or 0.01 step where there are less than 20 points;
/// otherwise the values themselves. The step comes from the first and last value or from a
/// least-squares line; of times it is 1/n s with a whole number n where it comes within 1e-5 of
/// that and 1/n explains them as well.
/// @param values  in SI, rising, two at least.
/// @param digits  of the numbers that were printed, in `unit`.
[[nodiscard]] Axis axis_from_printed(std::vector<double> values, const Unit& unit,
                                     const PrintedDigits& digits);

/// The even axis with a step that is stated elsewhere, from the first value on, where it explains
/// all of the printed values as above, at most 0.24 step off however few there are; else nothing.
/// @param step  in SI, above 0.
[[nodiscard]] std::optional<Axis> axis_of_stated_step(std::span<const double> values,
                                                      const Unit& unit, const PrintedDigits& digits,
                                                      double step);

/// Times that a clock rounded to its last digit, coarser than axis_of_stated_step() explains.
struct RoundedClock {
  Axis axis;           ///< even, from the first value on
  double uncertainty;  ///< of the step, relative: a last digit over the span
};

/// The even axis of times that the clock rounded to q, 20 at least: start and step explain all of
/// them,
///   max(t_i − i·step) − min(t_i − i·step) ≤ q·(1 + 2/√n),
/// and the rounding shows in their steps, which are whole numbers of q on both sides of
/// step/q, four times at least: a sample that is missing is no rounding. The step is that of a
/// least-squares line, of which the second term above is the error [uniform errors of q/√12].
/// Times may be equal; nothing where they fall or are not even so.
/// @param stated  a step to take in place of that of the line, in SI; 0: none.
[[nodiscard]] std::optional<RoundedClock> axis_of_rounded_clock(std::span<const double> values,
                                                                const Unit& unit,
                                                                const PrintedDigits& digits,
                                                                double stated = 0.0);

/// Rates that are stated beside times, Hz.
struct StatedRates {
  std::optional<double> asked = {};    ///< by the user
  std::optional<double> in_file = {};  ///< by the file
};

/// The axis of a clock that rounds, as axis_of_rounded_clock() knows it, in the rate that is asked
/// for, or else in that of the file where the times agree with it; else as found, with the warning
/// "times_rounded". Nothing where no clock explains the times.
/// @param file  for messages.
/// @throws InputError  where the times do not agree with the rate that is asked for.
[[nodiscard]] std::optional<Axis> axis_of_clock(std::span<const double> values, const Unit& unit,
                                                const PrintedDigits& digits,
                                                const StatedRates& rates, std::string_view file,
                                                std::vector<Warning>& warnings);

/// axis_from_printed() for values that were stored in single precision, each off by half a unit in
/// its last place: ulp(t) = 2^(⌊log2|t|⌋ − 23).
/// @param values  in SI, rising, two at least.
/// @param unit    in which they were stored.
[[nodiscard]] Axis axis_from_singles(std::vector<double> values, const Unit& unit);

}  // namespace microslip
