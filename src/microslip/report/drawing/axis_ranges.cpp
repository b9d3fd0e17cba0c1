// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/axis_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "microslip/report/drawing/drawn.hpp"

namespace microslip {
namespace {

constexpr double kPadding = 0.04;     // of the length of the axis, at both ends
constexpr double kNearZero = 0.2;     // of the largest value: the axis starts at zero
constexpr double kShortest = 1e-9;    // length of an axis relative to its values
constexpr double kAboutOne = 0.25;    // decades to each side of a single value: a tick or two
constexpr double kSmallest = 1e-100;  // magnitude that is not zero

/// The smallest interval with all values in it.
class Extent {
 public:
  explicit Extent(bool log) : log_(log) {}

  void include(double value) {
    if (log_ && value < kSmallestOnLog) return;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }

  [[nodiscard]] bool empty() const { return low_ > high_; }

  [[nodiscard]] AxisRange padded() const { return log_ ? padded_log() : padded_linear(); }

 private:
  [[nodiscard]] AxisRange padded_linear() const {
    const double largest = std::max(std::abs(low_), std::abs(high_));
    if (largest < kSmallest) return {.from = -1.0, .to = 1.0};
    if (high_ - low_ <= kShortest * largest) {
      return {.from = low_ - 0.1 * largest, .to = high_ + 0.1 * largest};
    }
    const double margin = kPadding * (high_ - low_);
    const bool from_zero = low_ >= 0.0 && low_ <= kNearZero * high_;
    const bool to_zero = high_ <= 0.0 && high_ >= kNearZero * low_;
    return {.from = from_zero ? 0.0 : low_ - margin, .to = to_zero ? 0.0 : high_ + margin};
  }

  [[nodiscard]] AxisRange padded_log() const {
    const double decades = std::log10(high_) - std::log10(low_);
    const double factor = std::pow(10.0, decades > kShortest ? kPadding * decades : kAboutOne);
    return {.from = low_ / factor, .to = high_ * factor};
  }

  bool log_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

bool inside(double value, const std::optional<AxisRange>& range) {
  return !range || (range->from <= value && value <= range->to);
}

/// The interval that the layers cover where `shown` holds.
template <class Shown>
void include_layers(const Figure& figure, Extent& x, Extent& y, Shown shown) {
  for (const Layer& layer : figure.layers) {
    if (const auto* marker = std::get_if<MarkerLayer>(&layer)) x.include(marker->x);
    for (const Piece& piece : drawn_pieces(layer, figure.x.log, figure.y.log)) {
      for (const Place& place : piece) {
        if (!shown(place)) continue;
        for (const double value : {place.x_low, place.x, place.x_high}) x.include(value);
        for (const double value : {place.y_low, place.y, place.y_high}) y.include(value);
      }
    }
  }
}

}  // namespace

AxisRanges axis_ranges(const Figure& figure) {
  Extent x(figure.x.log);
  Extent y(figure.y.log);
  include_layers(figure, x, y, [&](const Place& place) {
    return inside(place.x, figure.x.range) && inside(place.y, figure.y.range);
  });
  // Nothing lies in the ranges asked for: what is drawn elsewhere gives the other axis its scale.
  if (x.empty() || y.empty()) include_layers(figure, x, y, [](const Place&) { return true; });
  return {.x = figure.x.range ? *figure.x.range : x.padded(),
          .y = figure.y.range ? *figure.y.range : y.padded()};
}

double axis_fraction(const AxisRange& range, bool log, double value) {
  if (!log) return (value - range.from) / (range.to - range.from);
  if (value < kSmallestOnLog) return -std::numeric_limits<double>::infinity();
  return (std::log(value) - std::log(range.from)) / (std::log(range.to) - std::log(range.from));
}

}  // namespace microslip
