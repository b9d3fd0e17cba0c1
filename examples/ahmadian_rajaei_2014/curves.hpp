// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/joint/joint.hpp"

/// @file
/// Rows of numbers that the figures share.

namespace ahmadian_rajaei {

inline constexpr double kMicrometre = 1e-6;

/// `count` values from `from` to `to`; count ≥ 2.
[[nodiscard]] std::vector<double> equal_steps(double from, double to, std::size_t count);
/// `count` values in equal ratios; both above 0.
[[nodiscard]] std::vector<double> equal_ratios(double from, double to, std::size_t count);

/// The values over the unit, to be drawn.
[[nodiscard]] std::vector<double> scaled(std::vector<double> values, double unit);

/// max |a_i − b_i|; of equal length.
[[nodiscard]] double largest_difference(const std::vector<double>& a, const std::vector<double>& b);

/// x = A cos θ over a cycle from A down and up again, without the point A at its end.
[[nodiscard]] std::vector<double> cycle_of_displacements(double amplitude, std::size_t points);

/// A steady cycle.
struct Loop {
  std::vector<double> displacement;  ///< m
  std::vector<double> force;         ///< N
};

/// The steady loop of a joint at constant normal load.
[[nodiscard]] Loop steady_loop(const microslip::Joint& joint, double amplitude, std::size_t points);

/// The steady loop that a virgin curve F makes, at the displacements of cycle_of_displacements():
/// f↓(x) = F(A) − 2F((A − x)/2) for falling x, its mirror image for rising x. [AR14 (3)]
[[nodiscard]] std::vector<double> masing_loop(const std::function<double(double)>& virgin_force,
                                              const std::vector<double>& x);

/// Curves below each other in one table: the column `curve` names them, the others have the
/// numbers.
class CurveTable {
 public:
  using Columns = std::vector<std::pair<std::string, microslip::Dimension>>;

  explicit CurveTable(Columns columns);

  /// @param values  one vector per column, all of one length.
  void add(std::string_view curve, const std::vector<std::vector<double>>& values);

  [[nodiscard]] microslip::CsvWriter table() const;

 private:
  Columns columns_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> values_;
};

}  // namespace ahmadian_rajaei
