// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/paper_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/report/drawing/panel_layout.hpp"

namespace microslip {
namespace {

// Letters of 13 px, the smallest, are printed 8 points high.
constexpr double kPixelsPerInch = 72.0 * kSmallFont.size / 8.0;
constexpr double kPixelsPerMillimetre = kPixelsPerInch / 25.4;
constexpr double kPngDotsPerInch = 600.0;
constexpr double kOneColumn = 90.0;    // mm
constexpr double kTwoColumns = 190.0;  // mm
constexpr double kLeastPanel = 55.0;   // width of one beside others, mm
// Height of axes over their width: of panels, and of those that stand below each other.
constexpr double kRatio = 0.72;
constexpr double kLowRatio = 0.38;
constexpr double kLeastAxes = 170.0;    // px
constexpr double kHighestAxes = 320.0;  // px
constexpr double kHighestLow = 150.0;   // px
// A picture is no higher than a page, unless its axes would be lower than this.
constexpr double kPageHeight = 240.0;  // mm
constexpr double kLowestAxes = 60.0;   // px
constexpr double kTall = 4000.0;       // higher than any panel, px

void letter_panels(FigureGrid& grid) {
  if (grid.panels.size() < 2) return;
  for (std::size_t i = 0; i < grid.panels.size(); ++i) {
    const std::string letter = fmt::format("({})", static_cast<char>('a' + i % 26));
    Figure& panel = grid.panels[i];
    panel.title = panel.title.empty() ? letter : letter + " " + panel.title;
  }
}

/// The stroke of a line or loop; nothing of other layers.
Stroke* stroke_of(Layer& layer) {
  return std::visit(
      [](auto& concrete) -> Stroke* {
        if constexpr (requires { concrete.stroke, concrete.legend; }) {
          return &concrete.stroke;
        }
        return nullptr;
      },
      layer);
}

/// Whether a line looks like one of those that are drawn: of that style, and hardly wider or
/// narrower.
bool looks_like_one_of(const std::vector<Stroke>& used, const Stroke& stroke) {
  constexpr double kMuchWider = 2.5;
  return std::ranges::any_of(used, [&](const Stroke& other) {
    const auto [narrow, wide] = std::minmax(other.width, stroke.width);
    return other.style == stroke.style && wide < kMuchWider * narrow;
  });
}

/// Lines of one entry in the legend stay alike.
void tell_lines_apart(Figure& figure) {
  constexpr std::array kStyles = {LineStyle::kSolid, LineStyle::kDashed, LineStyle::kDashDotted,
                                  LineStyle::kLongDashed, LineStyle::kDotted};
  std::vector<Stroke> used;
  std::vector<Stroke*> same;
  std::map<std::string, Stroke*> named;
  std::vector<std::pair<Stroke*, const Stroke*>> followers;
  for (Layer& layer : figure.layers) {
    Stroke* stroke = stroke_of(layer);
    if (stroke == nullptr || legend_of(layer).empty()) continue;
    const auto [first, is_new] = named.try_emplace(legend_of(layer), stroke);
    if (!is_new) {
      followers.emplace_back(stroke, first->second);
    } else if (looks_like_one_of(used, *stroke)) {
      same.push_back(stroke);
    } else {
      used.push_back(*stroke);
    }
  }
  std::size_t next = 0;
  const auto is_used = [&used](LineStyle style) {
    return std::ranges::find(used, style, &Stroke::style) != used.end();
  };
  for (Stroke* stroke : same) {
    while (next < kStyles.size() && is_used(kStyles.at(next))) ++next;
    if (next == kStyles.size()) used.clear();  // all are in use: from the first again
    next %= kStyles.size();
    stroke->style = kStyles.at(next++);
  }
  for (const auto& [stroke, leading] : followers) stroke->style = leading->style;
}

/// The height of a row: that of the highest panel, with what stands above and below its axes.
double row_height(const FigureGrid& grid, double width, std::size_t rows) {
  const bool low = grid.columns == 1 && rows > 1;
  const double most = kPageHeight * kPixelsPerMillimetre / static_cast<double>(rows);
  double highest = 0.0;
  for (const Figure& panel : grid.panels) {
    const Box space{.left = 0.0, .bottom = 0.0, .right = width, .top = kTall};
    const Box axes = panel_layout(panel, space).axes;
    const double texts = kTall - axes.height();
    const double height = low ? std::min(kLowRatio * axes.width(), kHighestLow)
                              : std::clamp(kRatio * axes.width(), kLeastAxes, kHighestAxes);
    highest = std::max(highest, texts + std::max(std::min(height, most - texts), kLowestAxes));
  }
  return highest;
}

/// Fewer panels side by side where they would be narrow.
PictureSize size_of(FigureGrid& grid, double width_mm) {
  const auto fitting = static_cast<std::size_t>(std::max(width_mm / kLeastPanel, 1.0));
  grid.columns = std::min({grid.columns, grid.panels.size(), fitting});
  const double width = width_mm * kPixelsPerMillimetre;
  const std::size_t rows = (grid.panels.size() + grid.columns - 1) / grid.columns;
  const double row = row_height(grid, width / static_cast<double>(grid.columns), rows);
  return {static_cast<int>(std::lround(width)),
          static_cast<int>(std::lround(row * static_cast<double>(rows)))};
}

}  // namespace

PaperPicture draw_for_paper(FigureGrid grid, PictureFormat format, const PaperPrint& print) {
  check_figure(grid);
  if (print.width_mm && !(*print.width_mm >= 50.0 && *print.width_mm <= 400.0)) {
    throw InputError("width_mm", *print.width_mm, "must be 50 to 400 mm");
  }
  const double width_mm = print.width_mm.value_or(grid.columns > 1 ? kTwoColumns : kOneColumn);
  letter_panels(grid);
  for (Figure& panel : grid.panels) tell_lines_apart(panel);
  const PictureSize size = size_of(grid, width_mm);
  PictureStyle style{.pixels_per_inch = kPixelsPerInch,
                     .png_scale = kPngDotsPerInch / kPixelsPerInch,
                     .framed = true,
                     .grey = print.grey};
  return {draw(grid, format, size, style), width_mm, size.height / kPixelsPerMillimetre};
}

}  // namespace microslip
