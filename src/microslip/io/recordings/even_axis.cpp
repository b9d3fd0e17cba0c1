// SPDX-License-Identifier: MIT
#include "microslip/io/recordings/even_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kFloor = 1e-6;       // of the step: far below what any sampling clock keeps
constexpr double kCeiling = 0.24;     // of the step: coarser times cannot tell even from uneven
constexpr double kFewCeiling = 0.01;  // the same where few points could be so close by chance
constexpr std::size_t kFew = 20;
constexpr double kWholeRate = 1e-5;  // relative: two whole rates above 1e5 Hz are not confused

struct Line {
  double start;
  double step;
};

/// ulp(t) for values that rise: a power of ten is only computed when t enters another decade.
class PrintedResolution {
 public:
  PrintedResolution(const PrintedDigits& digits, double factor)
      : factor_(factor),
        significant_(digits.significant),
        fixed_(std::pow(10.0, -digits.decimals)) {}

  double operator()(double value) {
    const double printed = std::abs(value / factor_);
    if (!(printed >= from_ && printed < to_)) enter_decade(printed);
    return ulp_;
  }

 private:
  void enter_decade(double printed) {
    if (printed == 0.0) {
      ulp_ = fixed_ * factor_;
      return;
    }
    const double decade = std::floor(std::log10(printed));
    from_ = std::pow(10.0, decade);
    to_ = std::pow(10.0, decade + 1.0);
    ulp_ = std::max(fixed_, std::pow(10.0, decade + 1.0 - significant_)) * factor_;
  }

  double factor_;
  double significant_;
  double fixed_;
  double from_ = 0.0;
  double to_ = 0.0;
  double ulp_ = 0.0;
};

/// ulp(t) of numbers in single precision.
class SingleResolution {
 public:
  explicit SingleResolution(double factor) : factor_(factor) {}

  double operator()(double value) const {
    constexpr int kDigits = std::numeric_limits<float>::digits;
    if (value == 0.0) return std::numeric_limits<float>::denorm_min() * factor_;
    return std::ldexp(factor_, std::ilogb(value / factor_) + 1 - kDigits);
  }

 private:
  double factor_;
};

template <class Resolution>
bool explains(const Line& line, std::span<const double> values, Resolution resolution,
              bool is_stated = false) {
  // Doubles of the printed numbers and of start + i·step are rounded themselves.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                          std::max(std::abs(values.front()), std::abs(values.back()));
  const double end = std::max(resolution(values.front()), resolution(values.back()));
  const double ceiling = values.size() < kFew && !is_stated ? kFewCeiling : kCeiling;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = std::abs(values[i] - (line.start + static_cast<double>(i) * line.step));
    const double printed = 0.5 * (resolution(values[i]) + end);
    const double tolerance =
        std::clamp(printed, kFloor * line.step, ceiling * line.step) + rounding;
    if (!(off <= tolerance)) return false;
  }
  return true;
}

Line through_ends(std::span<const double> values) {
  return {values.front(),
          (values.back() - values.front()) / static_cast<double>(values.size() - 1)};
}

/// step = Σ(i − m)(t_i − t_0)/Σ(i − m)², m the mean of i: rounding errors average out, as they do
/// not between the ends.
Line least_squares(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const double middle = 0.5 * (n - 1.0);
  double moment = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = values[i] - values.front();
    moment += (static_cast<double>(i) - middle) * t;
    sum += t;
  }
  const double step = moment * 12.0 / (n * (n * n - 1.0));
  return {values.front() + sum / n - middle * step, step};
}

/// The same start with a step of 1/n s; nothing where that is another step.
std::optional<double> whole_rate_step(double step) {
  const double rate = 1.0 / step;
  const double whole = std::round(rate);
  if (!(whole >= 1.0 && std::abs(rate - whole) <= kWholeRate * whole)) return std::nullopt;
  return 1.0 / whole;
}

template <class Resolution>
std::optional<Line> even_line(std::span<const double> values, const Dimension& dimension,
                              const Resolution& resolution) {
  const Line ends = through_ends(values);
  const Line fit = least_squares(values);
  if (dimension == kTime) {
    for (const Line& line : {ends, fit}) {
      const std::optional<double> step = whole_rate_step(line.step);
      if (!step) continue;
      const Line whole{ends.start, *step};
      if (explains(whole, values, resolution)) return whole;
    }
  }
  for (const Line& line : {ends, fit}) {
    if (explains(line, values, resolution)) return line;
  }
  return std::nullopt;
}

template <class Resolution>
Axis axis_of(std::vector<double> values, const Dimension& dimension, const Resolution& resolution) {
  Axis axis{.dimension = dimension, .start = 0.0, .step = 0.0, .values = {}};
  if (const std::optional<Line> line = even_line(values, dimension, resolution)) {
    axis.start = line->start;
    axis.step = line->step;
  } else {
    axis.values = std::move(values);
  }
  return axis;
}

/// Whether even steps show both neighbours of their number of units, not one and an outlier.
bool shows_rounding(double units, double count) {
  constexpr double kFewest = 4.0;
  return count * std::abs(units - std::round(units)) >= kFewest;
}

}  // namespace

void PrintedDigits::add(std::string_view number) {
  int after_point = 0;
  int digits = 0;
  bool behind_point = false;
  std::size_t i = 0;
  for (; i < number.size() && number[i] != 'e' && number[i] != 'E'; ++i) {
    const char c = number[i];
    if (c == '.' || c == ',') behind_point = true;
    if (c < '0' || c > '9') continue;
    if (behind_point) ++after_point;
    if (c != '0' || digits > 0) ++digits;
  }
  int exponent = 0;
  if (i < number.size()) {
    const std::size_t skip = i + 1 < number.size() && number[i + 1] == '+' ? 2 : 1;
    std::from_chars(number.data() + i + skip, number.data() + number.size(), exponent);
  }
  // No double needs more; what a damaged file holds must not run over.
  constexpr int kMost = 400;
  decimals = std::max(decimals,
                      std::clamp(after_point - std::clamp(exponent, -kMost, kMost), -kMost, kMost));
  significant = std::max(significant, std::min(digits, kMost));
}

Axis axis_from_printed(std::vector<double> values, const Unit& unit, const PrintedDigits& digits) {
  return axis_of(std::move(values), unit.dimension, PrintedResolution(digits, unit.factor()));
}

std::optional<Axis> axis_of_stated_step(std::span<const double> values, const Unit& unit,
                                        const PrintedDigits& digits, double step) {
  const PrintedResolution resolution(digits, unit.factor());
  const Line line{values.front(), step};
  if (!(step > 0.0) || !explains(line, values, resolution, true)) return std::nullopt;
  return Axis{.dimension = unit.dimension, .start = line.start, .step = step, .values = {}};
}

std::optional<RoundedClock> axis_of_rounded_clock(std::span<const double> values, const Unit& unit,
                                                  const PrintedDigits& digits, double stated) {
  const bool falls = !std::ranges::is_sorted(values);
  if (values.size() < kFew || falls || unit.dimension != kTime) return std::nullopt;
  PrintedResolution resolution(digits, unit.factor());
  const double ulp = std::max(resolution(values.front()), resolution(values.back()));
  const double step = stated > 0.0 ? stated : least_squares(values).step;
  const auto n = static_cast<double>(values.size());
  if (!(step > 0.0) || (!(stated > 0.0) && !shows_rounding(step / ulp, n))) return std::nullopt;
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = values[i] - values.front() - static_cast<double>(i) * step;
    low = std::min(low, off);
    high = std::max(high, off);
  }
  if (high - low > ulp * (1.0 + 2.0 / std::sqrt(n))) return std::nullopt;
  return RoundedClock{
      {.dimension = unit.dimension, .start = values.front(), .step = step, .values = {}},
      ulp / (values.back() - values.front())};
}

std::optional<Axis> axis_of_clock(std::span<const double> values, const Unit& unit,
                                  const PrintedDigits& digits, const StatedRates& rates,
                                  std::string_view file, std::vector<Warning>& warnings) {
  std::optional<RoundedClock> clock = axis_of_rounded_clock(values, unit, digits);
  if (!clock) return std::nullopt;
  const double found = 1.0 / clock->axis.step;
  const double within = 100.0 * clock->uncertainty;
  const auto at_rate = [&](double rate) {
    return axis_of_rounded_clock(values, unit, digits, 1.0 / rate);
  };
  if (rates.asked) {
    if (auto asked = at_rate(*rates.asked)) return std::move(asked->axis);
    throw InputError("`rate`", fmt::format("{:.12g} Hz", *rates.asked),
                     fmt::format("must agree with the times of {}, which are {:.6g} Hz to within "
                                 "{:.2g} %",
                                 file, found, within));
  }
  if (rates.in_file) {
    if (auto stated = at_rate(*rates.in_file)) return std::move(stated->axis);
  }
  warnings.push_back(
      {"times_rounded",
       fmt::format("{}: the times have too few digits for their steps; they are taken as even, "
                   "{:.6g} Hz to within {:.2g} % by their whole span. `rate` gives it exactly",
                   file, found, within)});
  return std::move(clock->axis);
}

Axis axis_from_singles(std::vector<double> values, const Unit& unit) {
  return axis_of(std::move(values), unit.dimension, SingleResolution(unit.factor()));
}

}  // namespace microslip
