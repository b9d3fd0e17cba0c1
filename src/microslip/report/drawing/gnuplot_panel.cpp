// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/gnuplot_panel.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/report/drawing/drawn.hpp"
#include "microslip/report/drawing/panel_layout.hpp"

namespace microslip {
namespace {

constexpr std::array<const char*, kColours> kPalette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                        "#e69f00", "#56b4e9", "#000000", "#707070"};
// Neighbours differ by 0x30 or more. Black stays black and grey grey.
constexpr std::array<const char*, kColours> kShades = {"#202020", "#787878", "#484848", "#a0a0a0",
                                                       "#606060", "#b8b8b8", "#000000", "#707070"};
// Circle, square, triangle, diamond, triangle, pentagon, circle, square: gnuplot's filled shapes;
// the number before is the outline of each.
constexpr std::array<int, kColours> kShapes = {7, 5, 9, 13, 11, 15, 7, 5};
constexpr double kPointSize = 0.5;  // of gnuplot's
constexpr double kBandOpacity = 0.22;

constexpr const char* kTextColour = "#202020";
constexpr const char* kQuietColour = "#5c5c5c";

/// Lengths of dashes and gaps; gnuplot's unit grows with the line's width.
const char* dashes_of(LineStyle style) {
  switch (style) {
    case LineStyle::kDashed:
      return "(10,6)";
    case LineStyle::kDotted:
      return "(2,5)";
    case LineStyle::kDashDotted:
      return "(10,4,2,4)";
    case LineStyle::kLongDashed:
      return "(20,6)";
    case LineStyle::kSolid:
      break;
  }
  return "1";
}

bool has_errors(const PointLayer& layer) {
  return !layer.x_error.empty() || !layer.y_error.empty();
}

const char* style_of(const PointLayer& layer) {
  if (!has_errors(layer)) return "using 1:2 with points";
  if (layer.x_error.empty()) return "using 1:2:5:6 with yerrorbars linewidth 1";
  if (layer.y_error.empty()) return "using 1:2:3:4 with xerrorbars linewidth 1";
  return "using 1:2:3:4:5:6 with xyerrorbars linewidth 1";
}

/// px as gnuplot's coordinates `screen`, shares of the picture.
std::string at(double x, double y, const PanelSpace& space) {
  return fmt::format("screen {:.6f}, screen {:.6f}", x / space.picture_width,
                     y / space.picture_height);
}

const char* name_of(Side side) {
  switch (side) {
    case Side::kCentre:
      return "center";
    case Side::kRight:
      return "right";
    case Side::kLeft:
      break;
  }
  return "left";
}

/// Whether the character has no meaning for gnuplot within a string. Bytes beyond ASCII are letters
/// of UTF-8.
bool is_plain(char c) {
  constexpr std::string_view kPlain = " ()[].,:;=+-*/<>%!?_^|";
  return static_cast<unsigned char>(c) >= 0x80U || (c >= '0' && c <= '9') ||
         (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         kPlain.find(c) != std::string_view::npos;
}

/// Collects the commands of one panel.
class PanelWriter {
 public:
  PanelWriter(std::string& script, const Figure& figure, const PanelSpace& space)
      : script_(script),
        figure_(figure),
        space_(space),
        layout_(panel_layout(figure, space.box, space.least)) {}

  void write() {
    append_look();
    append_margins();
    append_axis("x", figure_.x, layout_.ranges.x, layout_.x_ticks);
    append_axis("y", figure_.y, layout_.ranges.y, layout_.y_ticks);
    append_texts();
    append_markers();
    append_legend();
    append_plot();
  }

 private:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(script_), format, std::forward<Arguments>(arguments)...);
    script_ += '\n';
  }

  [[nodiscard]] const char* colour_of(int index) const {
    return (space_.grey ? kShades : kPalette)[static_cast<std::size_t>(index % kColours)];
  }

  [[nodiscard]] std::string stroke_of(const Stroke& stroke) const {
    return fmt::format("linecolor rgb '{}' linewidth {} dashtype {}", colour_of(stroke.colour),
                       stroke.width, dashes_of(stroke.style));
  }

  [[nodiscard]] std::string marks_of(const PointLayer& layer) const {
    const auto index = static_cast<std::size_t>(layer.colour % kColours);
    return fmt::format("linecolor rgb '{}' pointtype {} pointsize {}", colour_of(layer.colour),
                       kShapes[index] - (layer.open ? 1 : 0), kPointSize * layer.size);
  }

  void append_look() {
    if (space_.framed) {
      line("set border 15 linecolor rgb '#000000' linewidth 0.9");
      line("set tics mirror in scale 0.7,0.35");
      line("unset x2tics");
      line("unset y2tics");
    } else {
      line("set border 3 linecolor rgb '#404040' linewidth 1");
      line("set tics nomirror out scale 0.6,0.3");
      line("set grid back linecolor rgb '#e4e4e4' linewidth 0.8 linetype 1");
    }
    line("set errorbars small");
    // gnuplot clears a place under each mark that has bars, of this size; 0 would mean the usual
    // one.
    line("set pointintervalbox 0.001");
    line("unset key");
  }

  void append_margins() {
    const Box& axes = layout_.axes;
    line("set lmargin at screen {:.6f}", axes.left / space_.picture_width);
    line("set rmargin at screen {:.6f}", axes.right / space_.picture_width);
    line("set bmargin at screen {:.6f}", axes.bottom / space_.picture_height);
    line("set tmargin at screen {:.6f}", axes.top / space_.picture_height);
  }

  void append_axis(std::string_view name, const FigureAxis& axis, const AxisRange& range,
                   const Ticks& ticks) {
    line("set {}range [{}:{}]", name, range.from, range.to);
    if (axis.log) line("set logscale {} 10", name);
    std::vector<std::string> list;
    for (const double tick : ticks.minor) list.push_back(fmt::format("'' {} 1", tick));
    for (const TickLabel& label : ticks.labelled) {
      list.push_back(fmt::format("'' {}", label.value));
    }
    if (list.empty()) {
      line("unset {}tics", name);
    } else {
      line("set {}tics ({})", name, fmt::join(list, ", "));
    }
  }

  void append_text(const PlacedText& text, Font font, std::string_view colour,
                   bool upwards = false) {
    script_ += gnuplot_label(text, font, colour, space_, upwards);
  }

  /// Only here does markup raise the exponent; nothing in it comes from outside.
  void append_number(const PlacedTick& tick) {
    const std::string& exponent = tick.label.exponent;
    line("set label '{}{}' at {} {} enhanced front font '{},{}' textcolor rgb '{}'",
         tick.label.text, exponent.empty() ? "" : fmt::format("^{{{}}}", exponent),
         at(tick.x, tick.y, space_), name_of(tick.side), kFontName, kSmallFont.size, kTextColour);
  }

  void append_texts() {
    for (const PlacedTick& tick : layout_.numbers) append_number(tick);
    for (const PlacedText& text : layout_.title) append_text(text, kTitleFont, kTextColour);
    for (const PlacedText& text : layout_.subtitle) append_text(text, kSmallFont, kQuietColour);
    for (const PlacedText& text : layout_.x_label) append_text(text, kLabelFont, kTextColour);
    for (const PlacedText& text : layout_.y_label) append_text(text, kLabelFont, kTextColour, true);
  }

  void append_markers() {
    for (const PlacedMarker& placed : layout_.markers) {
      const auto& marker = std::get<MarkerLayer>(figure_.layers[placed.layer]);
      line("set arrow from first {0}, graph 0 to first {0}, graph 1 nohead back {1}", marker.x,
           stroke_of(marker.stroke));
      if (!placed.label.text.empty()) {
        append_text(placed.label, kSmallFont, colour_of(marker.stroke.colour));
      }
    }
  }

  void append_legend() {
    const Box& box = layout_.legend_box;
    if (box.width() > 0.0) {
      append_rectangle(box, "fillcolor rgb '#ffffff' fillstyle transparent solid 0.85");
    }
    for (const LegendEntry& entry : layout_.legend) {
      if (entry.layer) {
        std::visit([&](const auto& layer) { append_sample(layer, entry.x, entry.y); },
                   figure_.layers[*entry.layer]);
      }
      for (const PlacedText& text : entry.lines) append_text(text, kSmallFont, kTextColour);
    }
  }

  void append_rectangle(const Box& box, const std::string& fill) {
    line("set object rectangle from {} to {} front {} noborder", at(box.left, box.bottom, space_),
         at(box.right, box.top, space_), fill);
  }

  void append_stroke(double x1, double y1, double x2, double y2, const std::string& stroke) {
    line("set arrow from {} to {} nohead front {}", at(x1, y1, space_), at(x2, y2, space_), stroke);
  }

  template <class LineOrLoop>
  void append_sample(const LineOrLoop& layer, double x, double y) {
    append_stroke(x, y, x + kSampleWidth, y, stroke_of(layer.stroke));
  }

  void append_sample(const PointLayer& layer, double x, double y) {
    const double middle = x + 0.5 * kSampleWidth;
    const std::string bar = fmt::format("linecolor rgb '{}' linewidth 1", colour_of(layer.colour));
    if (!layer.x_error.empty()) append_stroke(middle - 6.0, y, middle + 6.0, y, bar);
    if (!layer.y_error.empty()) append_stroke(middle, y - 6.0, middle, y + 6.0, bar);
    line("set label '' at {} point {} front", at(middle, y, space_), marks_of(layer));
  }

  template <class BandOrBar>
  requires(!requires(const BandOrBar& layer) {
    layer.stroke;
  }) void append_sample(const BandOrBar& layer, double x, double y) {
    append_rectangle({.left = x, .bottom = y - 5.0, .right = x + kSampleWidth, .top = y + 5.0},
                     fill_of(layer.colour));
  }

  void append_sample(const MarkerLayer& /*layer*/, double /*x*/, double /*y*/) {}

  [[nodiscard]] std::string fill_of(int colour) const {
    return fmt::format("fillcolor rgb '{}' fillstyle transparent solid {}", colour_of(colour),
                       kBandOpacity);
  }

  /// The data blocks first, then one plot command with all of them, in order.
  void append_plot() {
    std::vector<std::string> elements;
    for (const Layer& layer : figure_.layers) {
      const std::vector<Piece> pieces = drawn_pieces(layer, figure_.x.log, figure_.y.log);
      if (pieces.empty()) continue;
      elements.push_back(
          std::visit([&](const auto& concrete) { return element(concrete, pieces); }, layer));
    }
    line("plot {}", fmt::join(elements, ", \\\n     "));
  }

  template <class LineOrLoop>
  std::string element(const LineOrLoop& layer, const std::vector<Piece>& pieces) {
    const std::string data =
        append_data(pieces, [&](const Place& place) { line("{} {}", place.x, place.y); });
    return fmt::format("{} using 1:2 with lines {}", data, stroke_of(layer.stroke));
  }

  std::string element(const PointLayer& layer, const std::vector<Piece>& pieces) {
    const std::string data = append_data(pieces, [&](const Place& place) {
      line("{} {} {} {} {} {}", place.x, place.y, on_axis(place.x_low, figure_.x, layout_.ranges.x),
           place.x_high, on_axis(place.y_low, figure_.y, layout_.ranges.y), place.y_high);
    });
    return fmt::format("{} {} {}", data, style_of(layer), marks_of(layer));
  }

  std::string element(const BandLayer& layer, const std::vector<Piece>& pieces) {
    const std::string data = append_data(pieces, [&](const Place& place) {
      line("{} {} {}", place.x, on_axis(place.y_low, figure_.y, layout_.ranges.y), place.y_high);
    });
    return fmt::format("{} using 1:2:3 with filledcurves {} noborder", data, fill_of(layer.colour));
  }

  std::string element(const BarLayer& layer, const std::vector<Piece>& pieces) {
    const auto [from, to] = side_by_side(layer);
    const std::string data = append_data(pieces, [&](const Place& place) {
      line("{} {} {} {} {} {}", place.x, place.y, place.x + from, place.x + to,
           on_axis(place.y_low, figure_.y, layout_.ranges.y), place.y_high);
    });
    return fmt::format("{} using 1:2:3:4:5:6 with boxxyerror {} border linecolor rgb '{}'", data,
                       fill_of(layer.colour), colour_of(layer.colour));
  }

  /// Begin and end of the bar of a layer about a whole number.
  [[nodiscard]] std::pair<double, double> side_by_side(const BarLayer& layer) const {
    double count = 0.0;
    double before = 0.0;
    for (const Layer& other : figure_.layers) {
      const auto* bars = std::get_if<BarLayer>(&other);
      if (bars == &layer) before = count;
      if (bars != nullptr && bars->shown) ++count;
    }
    const double width = 2.0 * kHalfOfBars / count;
    return {before * width - kHalfOfBars, (before + 1.0) * width - kHalfOfBars};
  }

  /// A marker has no pieces; it is drawn by append_markers().
  static std::string element(const MarkerLayer& /*layer*/, const std::vector<Piece>& /*pieces*/) {
    return {};
  }

  /// The end of the axis in place of a value that a logarithmic axis cannot show.
  static double on_axis(double low, const FigureAxis& axis, const AxisRange& range) {
    return axis.log && low < kSmallestOnLog ? range.from : low;
  }

  /// @return the name of the new data block. A blank line breaks a line or band.
  template <class AppendPlace>
  std::string append_data(const std::vector<Piece>& pieces, AppendPlace append_place) {
    std::string name = fmt::format("$data_{}_{}", space_.number, blocks_++);
    line("{} << EOD", name);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i > 0) line("");
      for (const Place& place : pieces[i]) append_place(place);
    }
    line("EOD");
    return name;
  }

  std::string& script_;
  const Figure& figure_;
  const PanelSpace& space_;
  PanelLayout layout_;
  std::size_t blocks_ = 0;
};

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string string = "\"";
  for (const char c : shown_text(text)) {
    if (is_plain(c)) {
      string += c;
    } else {
      // Four digits: gnuplot reads that many where the first is a zero.
      string += fmt::format("\\0{:03o}", static_cast<unsigned char>(c));
    }
  }
  return string + "\"";
}

std::string gnuplot_label(const PlacedText& text, Font font, std::string_view colour,
                          const PanelSpace& space, bool upwards) {
  return fmt::format(
      "set label {} at {} {} {} noenhanced front font '{}{},{}' textcolor rgb '{}'\n",
      gnuplot_string(text.text), at(text.x, text.y, space), name_of(text.side),
      upwards ? "rotate by 90" : "norotate", kFontName, font.bold ? ":Bold" : "", font.size,
      colour);
}

void append_panel(std::string& script, const Figure& figure, const PanelSpace& space) {
  PanelWriter(script, figure, space).write();
}

}  // namespace microslip
