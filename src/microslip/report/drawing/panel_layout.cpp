// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/panel_layout.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kEdge = 14.0;          // between the edge of the picture and anything, px
constexpr double kTickGap = 11.0;       // between an axis and its numbers, px
constexpr double kLabelGap = 10.0;      // between these and the label of the axis, px
constexpr double kMarkerGap = 4.0;      // above and below the labels of markers, px
constexpr double kHeadingGap = 10.0;    // between the axes and what stands above, px
constexpr double kShortestAxis = 40.0;  // px
constexpr double kLabelShare = 0.9;     // most of the height for a line of the label of y
constexpr double kRightGap = 18.0;      // between the axes and a legend on the right, px
constexpr double kRightShare = 0.35;    // most of the width for a legend on the right
constexpr double kBelowShare = 0.45;    // most of the height for a legend below
constexpr double kInsideShare = 0.6;    // most of the width of the axes for a legend inside
constexpr double kInset = 12.0;         // between the axes and a legend inside of them, px

/// Lines below each other; the first one's middle is half a line below `top`.
std::vector<PlacedText> stacked(const std::vector<std::string>& lines, double x, double top,
                                Side side, Font font) {
  std::vector<PlacedText> placed;
  for (const std::string& line : lines) {
    const double y = top - (static_cast<double>(placed.size()) + 0.5) * line_height(font);
    placed.push_back({.text = line, .x = x, .y = y, .side = side});
  }
  return placed;
}

double height_of(const std::vector<std::string>& lines, Font font) {
  return static_cast<double>(lines.size()) * line_height(font);
}

double widest_label(const Ticks& ticks) {
  double widest = 0.0;
  for (const TickLabel& label : ticks.labelled) {
    widest = std::max(widest, label_width(label, kSmallFont));
  }
  return widest;
}

/// Rows for the labels of markers. A label is centred on its line unless it would leave the space,
/// and goes to the lowest row where it does not touch the one on its left.
class MarkerRows {
 public:
  MarkerRows(const Figure& figure, const Box& axes, double right) : axes_(axes), right_(right) {
    const AxisRange range = axis_ranges(figure).x;
    for (std::size_t i = 0; i < figure.layers.size(); ++i) {
      const auto* marker = std::get_if<MarkerLayer>(&figure.layers[i]);
      if (marker == nullptr) continue;
      const double at = axis_fraction(range, figure.x.log, marker->x);
      if (at < 0.0 || at > 1.0) continue;
      const double x = axes.left + at * axes.width();
      markers_.push_back(
          {.layer = i,
           .label = {.text = shown_text(marker->label), .x = x, .side = Side::kCentre}});
    }
    std::stable_sort(markers_.begin(), markers_.end(),
                     [](const auto& a, const auto& b) { return a.label.x < b.label.x; });
    for (PlacedMarker& marker : markers_) place(marker.label);
  }

  [[nodiscard]] double height() const {
    return static_cast<double>(ends_.size()) * line_height(kSmallFont);
  }

  [[nodiscard]] std::vector<PlacedMarker> above(double bottom) && {
    for (PlacedMarker& marker : markers_) marker.label.y += bottom;
    return std::move(markers_);
  }

 private:
  void place(PlacedText& label) {
    if (label.text.empty()) return;
    const double width = text_width(label.text, kSmallFont);
    double start = label.x - 0.5 * width;
    if (start < axes_.left) {
      label.side = Side::kLeft;
      start = label.x;
    } else if (start + width > right_) {
      label.side = Side::kRight;
      start = label.x - width;
    }
    std::size_t row = 0;
    while (row < ends_.size() && start < ends_[row] + kSmallFont.size) ++row;
    if (row == ends_.size()) ends_.push_back(0.0);
    ends_[row] = start + width;
    label.y = (static_cast<double>(row) + 0.5) * line_height(kSmallFont);
  }

  Box axes_;
  double right_;
  std::vector<double> ends_;  // where the last label of each row ends
  std::vector<PlacedMarker> markers_;
};

/// Works inwards: what stands at the left and right, then below and above, leaves the axes.
class LayoutMaker {
 public:
  LayoutMaker(const Figure& figure, const Box& space, const Margins& least)
      : figure_(figure),
        least_{.left = space.left + least.left,
               .bottom = space.bottom + least.bottom,
               .right = space.right - least.right,
               .top = space.top - least.top},
        inner_{.left = space.left + kEdge,
               .bottom = space.bottom + kEdge,
               .right = space.right - kEdge,
               .top = space.top - kEdge} {
    layout_.ranges = axis_ranges(figure);
  }

  PanelLayout make() {
    // How dense the numbers of y can stand follows from the height of the axes, and how wide these
    // are from the numbers: the first round guesses the height.
    double height = inner_.height() - 100.0;
    for (int round = 0; round < 2; ++round) {
      layout_.axes = inner_;
      place_left_and_right(std::max(height, kShortestAxis));
      place_below();
      place_above();
      height = layout_.axes.height();
    }
    check_room();
    place_numbers();
    place_y_label();
    place_inside_or_right();
    return std::move(layout_);
  }

 private:
  void place_left_and_right(double height) {
    Box& axes = layout_.axes;
    layout_.y_ticks =
        axis_ticks(layout_.ranges.y, figure_.y.log, height, true, kSmallFont, figure_.y.degrees);
    y_lines_ =
        wrapped(axis_text(figure_.y), std::max(height, kLabelShare * inner_.height()), kLabelFont);
    axes.left += height_of(y_lines_, kLabelFont) + (y_lines_.empty() ? 0.0 : kLabelGap) +
                 widest_label(layout_.y_ticks) + kTickGap;
    label_shift_ = std::max(least_.left - axes.left, 0.0);
    axes.left += label_shift_;
    double right = 8.0;
    if (figure_.legend == Legend::kRight) {
      right_texts_ = legend_texts(figure_, kRightShare * inner_.width());
      if (!right_texts_.empty()) right = legend_width(right_texts_) + kRightGap;
    }
    axes.right = std::min(axes.right - right, least_.right);
    // The ticks need a length; check_room() looks at it later.
    const double width = std::max(axes.width(), kShortestAxis);
    layout_.x_ticks =
        axis_ticks(layout_.ranges.x, figure_.x.log, width, false, kSmallFont, figure_.x.degrees);
    // Half of the number at the end of the axis stands beyond it.
    if (!layout_.x_ticks.labelled.empty()) {
      const TickLabel& last = layout_.x_ticks.labelled.back();
      const double end = axes.left + 0.5 * label_width(last, kSmallFont) +
                         axes.width() * axis_fraction(layout_.ranges.x, figure_.x.log, last.value);
      axes.right -= std::max(0.0, end - inner_.right);
    }
  }

  void place_below() {
    Box& axes = layout_.axes;
    double legend = 0.0;
    if (figure_.legend == Legend::kBelow) {
      Box room = inner_;
      room.left = axes.left;
      room.top = inner_.bottom + kBelowShare * inner_.height();
      layout_.legend = legend_rows(legend_texts(figure_, room.width()), room, legend);
    }
    const double label_bottom = inner_.bottom + legend + (legend > 0.0 ? kLabelGap : 0.0);
    const auto lines = wrapped(axis_text(figure_.x), axes.width(), kLabelFont);
    const double label_top = label_bottom + height_of(lines, kLabelFont);
    axes.bottom =
        label_top + (lines.empty() ? 0.0 : 0.5 * kLabelGap) + line_height(kSmallFont) + kTickGap;
    const double shift = std::max(least_.bottom - axes.bottom, 0.0);
    axes.bottom += shift;
    raise(layout_.legend, shift);
    layout_.x_label = stacked(lines, 0.5 * (axes.left + axes.right), label_top + shift,
                              Side::kCentre, kLabelFont);
  }

  static void raise(std::vector<LegendEntry>& legend, double shift) {
    for (LegendEntry& entry : legend) {
      entry.y += shift;
      for (PlacedText& line : entry.lines) line.y += shift;
    }
  }

  void place_above() {
    Box& axes = layout_.axes;
    const double width = inner_.right - axes.left;
    const auto title = wrapped(figure_.title, width, kTitleFont);
    const auto subtitle = wrapped(figure_.subtitle, width, kSmallFont);
    MarkerRows markers(figure_, axes, inner_.right);
    layout_.title = stacked(title, axes.left, inner_.top, Side::kLeft, kTitleFont);
    const double below_title = inner_.top - height_of(title, kTitleFont);
    layout_.subtitle = stacked(subtitle, axes.left, below_title, Side::kLeft, kSmallFont);
    const double below_subtitle = below_title - height_of(subtitle, kSmallFont);
    const bool headed = below_subtitle < inner_.top;
    const bool marked = markers.height() > 0.0;
    const double gap = marked ? kMarkerGap : headed ? kHeadingGap : 0.0;
    axes.top = below_subtitle - markers.height() - (headed && marked ? kMarkerGap : 0.0) - gap;
    axes.top = std::min(axes.top, least_.top);
    layout_.markers = std::move(markers).above(axes.top + gap);
  }

  void check_room() const {
    const Box& axes = layout_.axes;
    if (axes.width() >= kShortestAxis && axes.height() >= kShortestAxis) return;
    throw InputError("picture", "too small", "the texts of a figure must leave room for its axes",
                     "Make the picture larger or the texts shorter.");
  }

  void place_numbers() {
    const Box& axes = layout_.axes;
    for (const TickLabel& label : layout_.x_ticks.labelled) {
      const double at = axis_fraction(layout_.ranges.x, figure_.x.log, label.value);
      layout_.numbers.push_back({.label = label,
                                 .x = axes.left + at * axes.width(),
                                 .y = axes.bottom - kTickGap - 0.5 * line_height(kSmallFont)});
    }
    for (const TickLabel& label : layout_.y_ticks.labelled) {
      const double at = axis_fraction(layout_.ranges.y, figure_.y.log, label.value);
      layout_.numbers.push_back({.label = label,
                                 .x = axes.left - kTickGap,
                                 .y = axes.bottom + at * axes.height(),
                                 .side = Side::kRight});
    }
  }

  /// Places the label in the middle of the axis, unless it is longer and would leave the space.
  void place_y_label() {
    const Box& axes = layout_.axes;
    for (const std::string& line : y_lines_) {
      const double half = 0.5 * text_width(line, kLabelFont);
      const double middle = std::max(std::min(0.5 * (axes.bottom + axes.top), inner_.top - half),
                                     inner_.bottom + half);
      const double x =
          inner_.left + label_shift_ +
          (static_cast<double>(layout_.y_label.size()) + 0.5) * line_height(kLabelFont);
      layout_.y_label.push_back({.text = line, .x = x, .y = middle, .side = Side::kCentre});
    }
  }

  void place_inside_or_right() {
    const Box& axes = layout_.axes;
    if (figure_.legend == Legend::kRight) {
      layout_.legend = legend_column(fitting_texts(right_texts_, axes.height()),
                                     axes.right + kRightGap, axes.top);
      return;
    }
    if (figure_.legend == Legend::kBelow) return;
    const auto texts = fitting_texts(legend_texts(figure_, kInsideShare * axes.width()),
                                     axes.height() - 2.0 * kInset);
    if (texts.empty()) return;
    const bool left = figure_.legend == Legend::kTopLeft || figure_.legend == Legend::kBottomLeft;
    const bool top = figure_.legend == Legend::kTopLeft || figure_.legend == Legend::kTopRight;
    const double width = legend_width(texts);
    const double height = legend_height(texts);
    const double x = left ? axes.left + kInset : axes.right - kInset - width;
    const double y = top ? axes.top - kInset : axes.bottom + kInset + height;
    layout_.legend = legend_column(texts, x, y);
    layout_.legend_box = {
        .left = x - 4.0, .bottom = y - height - 3.0, .right = x + width + 4.0, .top = y + 3.0};
  }

  const Figure& figure_;
  Box least_;  // the axes lie within
  Box inner_;
  PanelLayout layout_;
  double label_shift_ = 0.0;  // of the label of y
  std::vector<std::string> y_lines_;
  std::vector<LegendText> right_texts_;
};

}  // namespace

PanelLayout panel_layout(const Figure& figure, const Box& space, const Margins& least) {
  return LayoutMaker(figure, space, least).make();
}

Margins margins_of(const PanelLayout& layout, const Box& space) {
  const Box& axes = layout.axes;
  return {.left = axes.left - space.left,
          .bottom = axes.bottom - space.bottom,
          .right = space.right - axes.right,
          .top = space.top - axes.top};
}

}  // namespace microslip
