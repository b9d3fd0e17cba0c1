// SPDX-License-Identifier: MIT
#include "curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/joint/memory.hpp"

namespace ahmadian_rajaei {

std::vector<double> equal_steps(double from, double to, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return values;
}

std::vector<double> equal_ratios(double from, double to, std::size_t count) {
  std::vector<double> values = equal_steps(std::log(from), std::log(to), count);
  for (double& value : values) value = std::exp(value);
  return values;
}

std::vector<double> scaled(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b.at(i)));
  return largest;
}

std::vector<double> cycle_of_displacements(double amplitude, std::size_t points) {
  std::vector<double> x(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    x[i] = amplitude * std::cos(angle);
  }
  return x;
}

Loop steady_loop(const microslip::Joint& joint, double amplitude, std::size_t points) {
  Loop loop{cycle_of_displacements(amplitude, points), std::vector<double>(points)};
  microslip::Memory memory(joint);
  memory.advance(amplitude);
  memory.march(loop.displacement, loop.force);
  return loop;
}

std::vector<double> masing_loop(const std::function<double(double)>& virgin_force,
                                const std::vector<double>& x) {
  const double amplitude = x.front();
  std::vector<double> force(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double sign = 2 * i < x.size() ? 1.0 : -1.0;
    force[i] =
        sign * (virgin_force(amplitude) - 2.0 * virgin_force(0.5 * (amplitude - sign * x[i])));
  }
  return force;
}

CurveTable::CurveTable(Columns columns) : columns_(std::move(columns)), values_(columns_.size()) {}

void CurveTable::add(std::string_view curve, const std::vector<std::vector<double>>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    values_.at(i).insert(values_[i].end(), values[i].begin(), values[i].end());
  }
  names_.insert(names_.end(), values.front().size(), std::string(curve));
}

microslip::CsvWriter CurveTable::table() const {
  microslip::CsvWriter table;
  table.add_text("curve", names_);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    table.add_numbers(columns_[i].first, columns_[i].second, values_[i]);
  }
  return table;
}

}  // namespace ahmadian_rajaei
