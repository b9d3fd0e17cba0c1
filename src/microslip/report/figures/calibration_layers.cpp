// SPDX-License-Identifier: MIT
#include "microslip/report/figures/calibration_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "microslip/base/gather.hpp"

namespace microslip {
namespace {

constexpr std::array kStylesOfModes = {LineStyle::kSolid, LineStyle::kDashed,
                                       LineStyle::kDashDotted, LineStyle::kLongDashed,
                                       LineStyle::kDotted};
/// Grey is kept for what the levels do not determine.
constexpr int kColoursOfModes = kGrey;

std::string name_of_mode(std::size_t mode) { return fmt::format("mode {}", mode); }

/// Whether the levels determine the density at a knot; true without `variance_reduction`.
bool is_determined(const DensityFound& joint, std::size_t i) {
  return joint.variance_reduction.empty() || joint.variance_reduction[i] >= kDetermined;
}

/// Stretches of knots that are determined or are not, each with the first one of the next.
template <class Add>
void for_stretches(const DensityFound& joint, const Add& add) {
  const std::size_t count = joint.slip_force.size();
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    if (i < count && is_determined(joint, i) == is_determined(joint, begin)) continue;
    add(begin, std::min(i + 1, count), is_determined(joint, begin));
    begin = i;
  }
}

std::vector<double> part(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  return {values.begin() + static_cast<std::ptrdiff_t>(begin),
          values.begin() + static_cast<std::ptrdiff_t>(end)};
}

}  // namespace

Stroke stroke_of(std::size_t index) {
  return {.colour = static_cast<int>(index) % kColoursOfModes,
          .style = kStylesOfModes.at(index % kStylesOfModes.size()),
          .width = 2.0};
}

std::vector<Layer> density_layers(const DensityFound& joint, std::size_t index,
                                  const std::string& legend) {
  std::vector<Layer> layers;
  const Stroke stroke = stroke_of(index);
  if (!joint.lower.empty()) {
    for_stretches(joint, [&](std::size_t begin, std::size_t end, bool determined) {
      if (end - begin < 2) return;
      layers.emplace_back(BandLayer{
          .x = part(joint.slip_force, begin, end),
          .lower = part(joint.lower, begin, end),
          .upper = part(joint.upper, begin, end),
          .legend = determined ? fmt::format("{} % band", std::round(100.0 * joint.confidence))
                               : "band by the prior",
          .colour = determined ? stroke.colour : kGrey,
          .name = fmt::format("{}: {}", legend, determined ? "band" : "band by the prior")});
    });
  }
  layers.emplace_back(LineLayer{joint.slip_force, joint.density, legend, stroke});
  return layers;
}

std::vector<RowsOfMode> rows_by_mode(const LevelsOfModes& levels) {
  std::vector<RowsOfMode> modes;
  for (std::size_t row = 0; row < levels.mode.size(); ++row) {
    auto mode = std::ranges::find(modes, levels.mode[row], &RowsOfMode::mode);
    if (mode == modes.end()) mode = modes.insert(modes.end(), RowsOfMode{levels.mode[row], {}});
    mode->rows.push_back(row);
  }
  std::ranges::sort(modes, {}, &RowsOfMode::mode);
  for (RowsOfMode& mode : modes) {
    std::ranges::stable_sort(mode.rows, {},
                             [&](std::size_t row) { return levels.displacement[row]; });
  }
  return modes;
}

void add_marks(std::vector<Layer>& layers, const LevelsOfModes& levels,
               const std::vector<double>& values, const std::vector<double>& std) {
  if (values.empty()) return;
  const std::vector<RowsOfMode> modes = rows_by_mode(levels);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<std::size_t> rows = modes[m].rows;
    std::erase_if(rows, [&](std::size_t row) { return !std::isfinite(values[row]); });
    if (rows.empty()) continue;
    layers.emplace_back(PointLayer{.x = gather(levels.displacement, rows),
                                   .y = gather(values, rows),
                                   .y_error = gather(std, rows),
                                   .legend = name_of_mode(modes[m].mode),
                                   .colour = stroke_of(m).colour,
                                   .open = true,
                                   .name = name_of_mode(modes[m].mode) + ", measured"});
  }
}

void add_lines(std::vector<Layer>& layers, const LevelsOfModes& levels,
               const std::vector<double>& values) {
  if (values.empty()) return;
  const std::vector<RowsOfMode> modes = rows_by_mode(levels);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    layers.emplace_back(LineLayer{.x = gather(levels.displacement, modes[m].rows),
                                  .y = gather(values, modes[m].rows),
                                  .legend = name_of_mode(modes[m].mode),
                                  .stroke = stroke_of(m),
                                  .name = name_of_mode(modes[m].mode) + ", found"});
  }
}

void add_bands(std::vector<Layer>& layers, const LevelsOfModes& levels,
               const std::vector<double>& lower, const std::vector<double>& upper) {
  if (lower.empty() || upper.empty()) return;
  const std::vector<RowsOfMode> modes = rows_by_mode(levels);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (modes[m].rows.size() < 2) continue;
    layers.emplace_back(BandLayer{.x = gather(levels.displacement, modes[m].rows),
                                  .lower = gather(lower, modes[m].rows),
                                  .upper = gather(upper, modes[m].rows),
                                  .colour = stroke_of(m).colour,
                                  .name = name_of_mode(modes[m].mode) + ", band"});
  }
}

}  // namespace microslip
