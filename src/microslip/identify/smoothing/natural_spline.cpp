// SPDX-License-Identifier: MIT
#include "microslip/identify/smoothing/natural_spline.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

NaturalSpline::NaturalSpline(std::vector<double> x, std::vector<double> value,
                             std::vector<double> second)
    : x_(std::move(x)), value_(std::move(value)), second_(std::move(second)) {
  const auto n = static_cast<double>(x_.size());
  if (x_.size() < 2) throw InputError("number of knots", n, "must be at least 2");
  if (value_.size() != x_.size() || second_.size() != x_.size()) {
    throw InputError("number of knots", n, "must be that of the values and second derivatives");
  }
  const auto fall = std::ranges::adjacent_find(x_, [](double a, double b) { return !(a < b); });
  if (fall != x_.end()) throw InputError("knot", *fall, "must be below the next one");
  if (second_.front() != 0.0) {
    throw InputError("first second derivative", second_.front(), "must be 0");
  }
  if (second_.back() != 0.0) {
    throw InputError("last second derivative", second_.back(), "must be 0");
  }
}

double NaturalSpline::value(double x) const {
  if (x_.empty()) return kUnknown;
  if (x < x_.front()) return value_.front() + (x - x_.front()) * knot_slope(0);
  if (x > x_.back()) return value_.back() + (x - x_.back()) * knot_slope(x_.size() - 1);
  const std::size_t i = interval(x);
  const double h = x_[i + 1] - x_[i];
  const double a = x - x_[i];
  const double b = x_[i + 1] - x;
  return (b * value_[i] + a * value_[i + 1]) / h -
         a * b / 6.0 * ((1.0 + b / h) * second_[i] + (1.0 + a / h) * second_[i + 1]);
}

double NaturalSpline::first_derivative(double x) const {
  if (x_.empty()) return kUnknown;
  if (x <= x_.front()) return knot_slope(0);
  if (x >= x_.back()) return knot_slope(x_.size() - 1);
  const std::size_t i = interval(x);
  const double h = x_[i + 1] - x_[i];
  const double a = (x - x_[i]) / h;
  const double b = (x_[i + 1] - x) / h;
  return (value_[i + 1] - value_[i]) / h +
         h / 6.0 * ((1.0 - 3.0 * b * b) * second_[i] + (3.0 * a * a - 1.0) * second_[i + 1]);
}

double NaturalSpline::second_derivative(double x) const {
  if (x_.empty()) return kUnknown;
  if (x <= x_.front() || x >= x_.back()) return 0.0;
  const std::size_t i = interval(x);
  const double a = (x - x_[i]) / (x_[i + 1] - x_[i]);
  return second_[i] + a * (second_[i + 1] - second_[i]);
}

/// The interval that contains x, by its left knot; x within the knots.
std::size_t NaturalSpline::interval(double x) const {
  const auto right = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  return static_cast<std::size_t>(right - x_.begin()) - 1;
}

/// g′ at the first or the last knot.
double NaturalSpline::knot_slope(std::size_t knot) const {
  const std::size_t i = knot == 0 ? 0 : knot - 1;
  const double h = x_[i + 1] - x_[i];
  const double chord = (value_[i + 1] - value_[i]) / h;
  return knot == 0 ? chord - h / 6.0 * second_[1] : chord + h / 6.0 * second_[i];
}

}  // namespace microslip
