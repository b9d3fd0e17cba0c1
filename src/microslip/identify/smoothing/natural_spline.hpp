// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// A natural cubic spline given by its values and second derivatives at the knots.
class NaturalSpline {
 public:
  NaturalSpline() = default;

  /// @param x       knots, at least 2, strictly increasing.
  /// @param value   g(x_i); of the length of x.
  /// @param second  g″(x_i); of the length of x, zero at both ends.
  /// @throws InputError  where lengths or order are wrong.
  NaturalSpline(std::vector<double> x, std::vector<double> value, std::vector<double> second);

  /// g(x), extrapolated linearly outside of the knots; O(log n). NaN where x is, and without knots.
  [[nodiscard]] double value(double x) const;
  /// g′(x).
  [[nodiscard]] double first_derivative(double x) const;
  /// g″(x), piecewise linear; 0 outside of the knots.
  [[nodiscard]] double second_derivative(double x) const;

  /// The knots x_i, rising.
  [[nodiscard]] std::span<const double> knots() const { return x_; }
  /// The values there, g(x_i).
  [[nodiscard]] std::span<const double> knot_values() const { return value_; }
  /// The second derivatives there, g″(x_i).
  [[nodiscard]] std::span<const double> knot_second_derivatives() const { return second_; }

 private:
  [[nodiscard]] std::size_t interval(double x) const;
  [[nodiscard]] double knot_slope(std::size_t knot) const;

  std::vector<double> x_;
  std::vector<double> value_;
  std::vector<double> second_;
};

}  // namespace microslip
