// SPDX-License-Identifier: MIT
#include "microslip/report/page/report_data.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/report/drawing/text_layout.hpp"

namespace microslip {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> kStyles = {"solid", "dash", "dot", "dashdot", "longdash"};

/// More digits than any sensor has, in half the bytes.
double shortened(double value) {
  const std::string text = fmt::format("{:.6e}", value);
  double result = 0.0;  // stays so below the smallest normal number, for which std::stod throws
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

Json numbers(const std::vector<double>& values) {
  Json array = Json::array();
  for (const double value : values) {
    array.push_back(std::isfinite(value) ? Json(shortened(value)) : Json(nullptr));
  }
  return array;
}

/// Long even axes as first value, step and number: half of the data of a history.
Json axis_values(const std::vector<double>& x) {
  constexpr std::size_t kFew = 50;
  if (x.size() < kFew) return numbers(x);
  const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double even = x.front() + static_cast<double>(i) * step;
    if (std::abs(x[i] - even) > 1e-6 * std::abs(step)) return numbers(x);
  }
  return {{"from", x.front()}, {"step", step}, {"count", x.size()}};
}

Json as_json(const FigureAxis& axis) {
  Json json{{"label", shown_text(axis.label)},
            {"unit", shown_text(axis.unit)},
            {"log", axis.log},
            {"switch", axis.log_switch}};
  if (axis.range) json["range"] = {axis.range->from, axis.range->to};
  return json;
}

std::vector<double> x_of(const Layer& layer) {
  return std::visit(
      [](const auto& concrete) -> std::vector<double> {
        if constexpr (std::is_same_v<decltype(concrete), const MarkerLayer&>) {
          return {concrete.x};
        } else {
          return concrete.x;
        }
      },
      layer);
}

/// Curves of one figure often have the same x, which is half of their data: the number of the
/// first.
Json x_data(const std::vector<Layer>& layers, std::size_t index) {
  const std::vector<double> x = x_of(layers[index]);
  for (std::size_t i = 0; i < index; ++i) {
    if (x.size() > 1 && x_of(layers[i]) == x) return {{"of", i}};
  }
  return axis_values(x);
}

void add_stroke(Json& json, const char* kind, const Stroke& stroke) {
  json["kind"] = kind;
  json["colour"] = stroke.colour % kColours;
  json["style"] = kStyles.at(static_cast<std::size_t>(stroke.style));
  json["width"] = stroke.width;
}

void add_look(Json& json, const LineLayer& layer) { add_stroke(json, "line", layer.stroke); }
void add_look(Json& json, const LoopLayer& layer) { add_stroke(json, "loop", layer.stroke); }
void add_look(Json& json, const MarkerLayer& layer) { add_stroke(json, "marker", layer.stroke); }
void add_look(Json& json, const BarLayer& layer) {
  add_stroke(json, "bars", {.colour = layer.colour});
}

void add_look(Json& json, const PointLayer& layer) {
  add_stroke(json, "points", {.colour = layer.colour});
  if (!layer.x_error.empty()) json["xStd"] = numbers(layer.x_error);
  if (!layer.y_error.empty()) json["yStd"] = numbers(layer.y_error);
}

void add_look(Json& json, const BandLayer& layer) {
  add_stroke(json, "band", {.colour = layer.colour});
  json["lower"] = numbers(layer.lower);
  json["upper"] = numbers(layer.upper);
}

Json as_json(const std::vector<Layer>& layers, std::size_t index) {
  const Layer& layer = layers[index];
  Json json{{"name", shown_text(name_of(layer))},
            {"group", shown_text(legend_of(layer))},
            {"shown", is_shown(layer)},
            {"x", x_data(layers, index)}};
  std::visit(
      [&json](const auto& concrete) {
        add_look(json, concrete);
        if constexpr (requires { concrete.y; }) json["y"] = numbers(concrete.y);
      },
      layer);
  return json;
}

Json as_json(const FigureChoice& choice) {
  Json traces = Json::array();
  for (std::size_t i = 0; i < choice.layers.size(); ++i) {
    traces.push_back(as_json(choice.layers, i));
  }
  return {{"name", shown_text(choice.name)}, {"traces", std::move(traces)}};
}

Json as_json(const ReportFigure& figure, std::size_t section) {
  Json choices = Json::array();
  for (const FigureChoice& choice : figure.choices) choices.push_back(as_json(choice));
  if (choices.empty()) choices.push_back(as_json(FigureChoice{"", figure.figure.layers}));
  return {{"section", section},
          {"title", shown_text(figure.figure.title)},
          {"chart", figure.chart == ChartKind::kTimeHistory ? "time" : "plot"},
          {"x", as_json(figure.figure.x)},
          {"y", as_json(figure.figure.y)},
          {"choose", shown_text(figure.choose)},
          {"chosen", figure.chosen},
          {"choices", std::move(choices)}};
}

/// JSON has these only inside of strings, where an escape means the same. "</script" would end the
/// element, "<!--" hide its end.
std::string inert(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<' || c == '>' || c == '&') {
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string report_data(const ReportDocument& document) {
  Json figures = Json::array();
  for (std::size_t i = 0; i < document.sections.size(); ++i) {
    for (const ReportBlock& block : document.sections[i].blocks) {
      if (const auto* figure = std::get_if<ReportFigure>(&block)) {
        figures.push_back(as_json(*figure, i));
      }
    }
  }
  constexpr bool kAsciiOnly = true;  // U+2028 and U+2029 too
  return inert(figures.dump(-1, ' ', kAsciiOnly, Json::error_handler_t::replace));
}

}  // namespace microslip
