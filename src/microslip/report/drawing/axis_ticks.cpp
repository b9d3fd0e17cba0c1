// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/axis_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>

#include "microslip/report/drawing/axis_ranges.hpp"

namespace microslip {
namespace {

constexpr double kExponentSize = 0.8;   // of the font size: what gnuplot's markup does
constexpr double kAcrossGap = 22.0;     // between labels side by side, px
constexpr double kRowHeight = 2.3;      // between labels above each other, font sizes
constexpr double kShortestStep = 55.0;  // between ticks of a linear axis, px

std::string with_minus(std::string text) {
  if (text.rfind('-', 0) == 0) text.replace(0, 1, "\u2212");
  return text;
}

/// Label with `digits` significant digits; with a separate power of ten where the number is very
/// large or small.
TickLabel label_of(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  const std::size_t e = text.find('e');
  TickLabel label{.value = value, .text = with_minus(text.substr(0, e)), .exponent = {}};
  if (e == std::string::npos) return label;
  label.text += "\u00d710";
  label.exponent = with_minus(std::to_string(std::stoi(text.substr(e + 1))));
  return label;
}

TickLabel power_label(int power, double value) {
  return {.value = value, .text = "10", .exponent = with_minus(std::to_string(power))};
}

double power_of_ten(int power) { return std::pow(10.0, power); }

/// A negative power of ten is no double, its inverse is: 3/10 is the double nearest to 0.3.
double times_power(double factor, int power) {
  return power < 0 ? factor / power_of_ten(-power) : factor * power_of_ten(power);
}

bool contains(const AxisRange& range, double value) {
  return range.from <= value && value <= range.to;
}

/// Digits with which multiples of digit·10^power are written exactly up to the ends of the range.
int digits_of(const AxisRange& range, int power) {
  const double largest = std::max(std::abs(range.from), std::abs(range.to));
  const double digits = std::floor(std::log10(largest)) - power + 1.0;
  return static_cast<int>(std::clamp(digits, 4.0, 15.0));
}

std::vector<TickLabel> multiples_of(int digit, int power, const AxisRange& range) {
  std::vector<TickLabel> labels;
  const int digits = digits_of(range, power);
  const double first = std::ceil(range.from / times_power(digit, power) - 1e-9);
  for (int i = 0; i < 1000; ++i) {
    // Plus zero makes a negative zero positive.
    const double value = times_power((first + i) * digit, power) + 0.0;
    if (value > range.to) break;
    if (contains(range, value)) labels.push_back(label_of(value, digits));
  }
  return labels;
}

std::vector<double> multiples_of_powers(const AxisRange& range, std::initializer_list<int> digits) {
  std::vector<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.from)));
  const int last = static_cast<int>(std::floor(std::log10(range.to)));
  for (int power = first; power <= last; ++power) {
    for (const int digit : digits) {
      const double tick = times_power(digit, power);
      if (contains(range, tick)) ticks.push_back(tick);
    }
  }
  return ticks;
}

std::vector<TickLabel> labels_of(const std::vector<double>& values) {
  std::vector<TickLabel> labels;
  labels.reserve(values.size());
  for (const double value : values) labels.push_back(label_of(value, 4));
  return labels;
}

std::vector<TickLabel> powers(const AxisRange& range, int stride) {
  std::vector<TickLabel> labels;
  const int first = static_cast<int>(std::ceil(std::log10(range.from) / stride - 1e-9)) * stride;
  for (int power = first; times_power(1.0, power) <= range.to; power += stride) {
    const double value = times_power(1.0, power);
    if (contains(range, value)) labels.push_back(power_label(power, value));
  }
  return labels;
}

/// An axis in pixels.
struct Scale {
  AxisRange range;
  bool log;
  double length;
  bool vertical;
  Font font;

  [[nodiscard]] bool fits(const std::vector<TickLabel>& labels) const {
    for (std::size_t i = 1; i < labels.size(); ++i) {
      const double distance = length * (axis_fraction(range, log, labels[i].value) -
                                        axis_fraction(range, log, labels[i - 1].value));
      if (distance < needed(labels[i - 1], labels[i])) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] double needed(const TickLabel& before, const TickLabel& after) const {
    if (vertical) return (log ? 1.5 : kRowHeight) * font.size;
    const double across = 0.5 * (label_width(before, font) + label_width(after, font)) + kAcrossGap;
    return log ? across : std::max(across, kShortestStep);
  }
};

/// The densest labels that fit at multiples of 1, 2 or 5 times a power of ten.
Ticks linear_ticks(const Scale& scale) {
  const double span = scale.range.to - scale.range.from;
  const int lowest = static_cast<int>(std::floor(std::log10(span))) - 2;
  for (int power = lowest;; ++power) {
    for (const int digit : {1, 2, 5}) {
      std::vector<TickLabel> labels = multiples_of(digit, power, scale.range);
      if (labels.size() <= 2 || scale.fits(labels)) return {.labelled = labels, .minor = {}};
    }
  }
}

/// The densest labels that fit at parts or multiples of 90 degrees; else linear_ticks().
Ticks degree_ticks(const Scale& scale) {
  for (const int step : {15, 30, 45, 90, 180, 360}) {
    std::vector<TickLabel> labels = multiples_of(step, 0, scale.range);
    if (labels.size() >= 2 && scale.fits(labels)) return {.labelled = labels, .minor = {}};
  }
  return linear_ticks(scale);
}

/// Labels of an axis with less than three powers of ten; none where none fit.
std::vector<TickLabel> short_log_labels(const Scale& scale) {
  std::vector<TickLabel> labels = labels_of(multiples_of_powers(scale.range, {1, 2, 5}));
  if (labels.size() >= 3) return scale.fits(labels) ? labels : std::vector<TickLabel>{};
  labels = labels_of(multiples_of_powers(scale.range, {1, 2, 3, 4, 5, 6, 7, 8, 9}));
  if (labels.size() >= 3 && scale.fits(labels)) return labels;
  return linear_ticks(scale).labelled;
}

Ticks log_ticks(const Scale& scale) {
  const std::vector<double> all = multiples_of_powers(scale.range, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  std::vector<TickLabel> labels = powers(scale.range, 1);
  if (labels.size() < 3) {
    std::vector<TickLabel> more = short_log_labels(scale);
    return {.labelled = more.empty() ? labels : more, .minor = all};
  }
  if (scale.fits(labels)) return {.labelled = labels, .minor = all};
  const std::vector<double> minor = multiples_of_powers(scale.range, {1});
  for (const int stride : {2, 3, 5, 10, 20, 50, 100, 200}) {
    labels = powers(scale.range, stride);
    if (scale.fits(labels)) break;
  }
  return {.labelled = labels, .minor = minor};
}

}  // namespace

double label_width(const TickLabel& label, Font font) {
  const Font raised{.size = kExponentSize * font.size, .bold = font.bold};
  return text_width(label.text, font) + text_width(label.exponent, raised);
}

Ticks axis_ticks(const AxisRange& range, bool log, double length, bool vertical, Font font,
                 bool degrees) {
  const Scale scale{
      .range = range, .log = log, .length = length, .vertical = vertical, .font = font};
  if (log) return log_ticks(scale);
  return degrees ? degree_ticks(scale) : linear_ticks(scale);
}

}  // namespace microslip
