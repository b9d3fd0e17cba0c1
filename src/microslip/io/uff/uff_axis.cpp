// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_axis.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "microslip/io/uff/uff58_writer.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

double with_integer_rate(double step) {
  constexpr double kRelative = 1e-5;  // one in the last of the digits that a header has
  const double rate = 1.0 / step;
  const double integer = std::round(rate);
  const bool near = step > 0.0 && integer >= 1.0 && std::isfinite(integer) &&
                    std::abs(rate - integer) < kRelative * rate;
  return near ? 1.0 / integer : step;
}

bool is_grid(const std::vector<double>& x, double step) {
  const Axis axis{.start = x.front(), .step = step, .values = {}};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (axis.at(i) != x[i]) return false;
  }
  return true;
}

/// The step of even points with exactly these values, if there is one: the mean step has rounding
/// errors of a few units in its last place.
std::optional<double> exact_step(const std::vector<double>& x) {
  constexpr int kNeighbours = 4;
  if (x.size() < 3) return std::nullopt;
  const double mean = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  if (!(mean > 0.0 && std::isfinite(mean))) return std::nullopt;
  if (const double step = with_integer_rate(mean); is_grid(x, step)) return step;
  double below = mean;
  double above = mean;
  for (int i = 0; i <= kNeighbours; ++i) {
    if (is_grid(x, below)) return below;
    if (is_grid(x, above)) return above;
    below = std::nextafter(below, 0.0);
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return std::nullopt;
}

}  // namespace

Axis even_uff_axis(double start, double step, const Unit& unit) {
  Axis axis{.dimension = unit.dimension,
            .start = unit.to_si(start),
            .step = unit.to_si(step),
            .values = {}};
  if (axis.dimension == kTime) axis.step = with_integer_rate(axis.step);
  return axis;
}

Axis uneven_uff_axis(std::vector<double> x, const Unit& unit) {
  if (unit.factor() != 1.0) {
    for (double& value : x) value = unit.to_si(value);
  }
  Axis axis{.dimension = unit.dimension, .values = {}};
  if (const auto step = exact_step(x)) {
    axis.start = x.front();
    axis.step = *step;
  } else {
    axis.values = std::move(x);
  }
  return axis;
}

bool header_holds(const Axis& axis) {
  const double start = uff_number(uff_e13(axis.start)).value_or(0.0);
  const double step = uff_number(uff_e13(axis.step)).value_or(0.0);
  const Axis read = even_uff_axis(start, step, {.dimension = axis.dimension});
  return read.start == axis.start && read.step == axis.step;
}

std::vector<double> uff_abscissae(const Recording& recording) {
  const Axis& axis = recording.axis;
  if (!axis.even() || header_holds(axis)) return axis.values;
  std::vector<double> x(recording.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = axis.at(i);
  return x;
}

void set_abscissae(const std::vector<double>& x, Uff58Header& header) {
  if (x.empty()) return;
  header.even = false;
  header.start = header.step = 0.0;
}

}  // namespace microslip
