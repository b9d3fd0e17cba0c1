// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "microslip/report/drawing/figure.hpp"
#include "microslip/report/drawing/placed.hpp"

/// @file
/// The legend of a figure. Internal to report.

namespace microslip {

/// The text for a layer, broken into lines; without a layer, the number of further entries.
struct LegendText {
  std::optional<std::size_t> layer;
  std::vector<std::string> lines;
};

/// A sample of the layer, kSampleWidth from x on at the height of the first line, and the lines.
struct LegendEntry {
  std::optional<std::size_t> layer;
  double x = 0.0;
  double y = 0.0;
  std::vector<PlacedText> lines;
};

inline constexpr double kSampleWidth = 26.0;  ///< px

/// The texts of the layers that have one, for entries of at most `width` px. Nothing where the
/// figure has no legend.
[[nodiscard]] std::vector<LegendText> legend_texts(const Figure& figure, double width);

/// Width of the widest entry, with its sample, px.
[[nodiscard]] double legend_width(const std::vector<LegendText>& texts);

/// As many of the texts, one below the other, as fit into `height` px; in place of the rest, their
/// number.
[[nodiscard]] std::vector<LegendText> fitting_texts(const std::vector<LegendText>& texts,
                                                    double height);

/// Height of all entries, one below the other, px.
[[nodiscard]] double legend_height(const std::vector<LegendText>& texts);

/// Places the entries one below the other.
[[nodiscard]] std::vector<LegendEntry> legend_column(const std::vector<LegendText>& texts,
                                                     double left, double top);

/// Places the entries side by side in as many rows as they need, the last one at the bottom of the
/// room; entries for which the room is too low are only counted.
/// @param[out] height  of the rows.
[[nodiscard]] std::vector<LegendEntry> legend_rows(const std::vector<LegendText>& texts,
                                                   const Box& room, double& height);

}  // namespace microslip
