// SPDX-License-Identifier: MIT
#include "microslip/report/report_data.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/report/text_layout.hpp"

namespace microslip {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 6> kKinds = {"line", "points", "band",
                                                    "loop", "bars",   "marker"};
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

Json as_json(const ReportAxis& axis) {
  Json json{{"label", shown_text(axis.label)},
            {"unit", shown_text(axis.unit)},
            {"log", axis.log},
            {"switch", axis.log_switch}};
  if (axis.range) json["range"] = {axis.range->from, axis.range->to};
  return json;
}

/// Curves of one figure often have the same x, which is half of their data: the number of the
/// first.
Json x_of(const std::vector<ReportTrace>& traces, std::size_t index) {
  for (std::size_t i = 0; i < index; ++i) {
    if (traces[i].x.size() > 1 && traces[i].x == traces[index].x) return {{"of", i}};
  }
  return axis_values(traces[index].x);
}

Json as_json(const std::vector<ReportTrace>& traces, std::size_t index) {
  const ReportTrace& trace = traces[index];
  Json json{{"name", shown_text(trace.name)},
            {"group", shown_text(legend_of(trace))},
            {"kind", kKinds[static_cast<std::size_t>(trace.kind)]},
            {"colour", trace.stroke.colour % kColours},
            {"style", kStyles[static_cast<std::size_t>(trace.stroke.style)]},
            {"width", trace.stroke.width},
            {"shown", trace.shown},
            {"x", x_of(traces, index)}};
  if (!trace.y.empty()) json["y"] = numbers(trace.y);
  if (!trace.y_std.empty()) json["yStd"] = numbers(trace.y_std);
  if (trace.kind == TraceKind::kBand) {
    json["lower"] = numbers(trace.lower);
    json["upper"] = numbers(trace.upper);
  }
  return json;
}

Json as_json(const ReportFigure& figure, std::size_t section) {
  Json choices = Json::array();
  for (const ReportChoice& choice : figure.choices) {
    Json traces = Json::array();
    for (std::size_t i = 0; i < choice.traces.size(); ++i) {
      traces.push_back(as_json(choice.traces, i));
    }
    choices.push_back({{"name", shown_text(choice.name)}, {"traces", std::move(traces)}});
  }
  return {{"section", section},
          {"title", shown_text(figure.title)},
          {"chart", figure.chart == ChartKind::kTimeHistory ? "time" : "plot"},
          {"x", as_json(figure.x)},
          {"y", as_json(figure.y)},
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
