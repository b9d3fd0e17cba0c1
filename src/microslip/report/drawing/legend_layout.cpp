// SPDX-License-Identifier: MIT
#include "microslip/report/drawing/legend_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

namespace microslip {
namespace {

constexpr double kTextGap = 8.0;     // between a sample and its text, px
constexpr double kEntryGap = 3.0;    // between entries below each other, px
constexpr double kColumnGap = 24.0;  // between entries side by side, px

double entry_width(const LegendText& text) {
  double widest = 0.0;
  for (const std::string& line : text.lines) {
    widest = std::max(widest, text_width(line, kSmallFont));
  }
  return kSampleWidth + kTextGap + widest;
}

double entry_height(const LegendText& text) {
  return static_cast<double>(text.lines.size()) * line_height(kSmallFont) + kEntryGap;
}

LegendEntry entry_at(const LegendText& text, double left, double top) {
  LegendEntry entry{
      .layer = text.layer, .x = left, .y = top - 0.5 * line_height(kSmallFont), .lines = {}};
  double y = entry.y;
  for (const std::string& line : text.lines) {
    entry.lines.push_back({.text = line, .x = left + kSampleWidth + kTextGap, .y = y});
    y -= line_height(kSmallFont);
  }
  return entry;
}

/// The first of the texts, and how many are left.
std::vector<LegendText> first_texts(const std::vector<LegendText>& texts, std::size_t count) {
  if (count >= texts.size()) return texts;
  std::vector<LegendText> first(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(count));
  first.push_back({.layer = {}, .lines = {fmt::format("\u2026 {} more", texts.size() - count)}});
  return first;
}

/// Starts of the columns, from the left of the legend.
std::vector<double> column_starts(const std::vector<LegendText>& texts, double width) {
  if (texts.empty()) return {0.0};
  std::vector<double> starts = {0.0};
  for (const LegendText& text : texts) {
    starts.push_back(starts.back() + entry_width(text) + kColumnGap);
  }
  const double all = starts.back() - kColumnGap;
  starts.pop_back();
  if (all <= width) return starts;
  const double pitch = legend_width(texts) + kColumnGap;
  const double count = std::max(std::floor((width + kColumnGap) / pitch), 1.0);
  starts.clear();
  for (int i = 0; i < static_cast<int>(count); ++i) starts.push_back(i * pitch);
  return starts;
}

std::vector<LegendEntry> all_rows(const std::vector<LegendText>& texts, const Box& room,
                                  double& height) {
  std::vector<LegendEntry> entries;
  const std::vector<double> starts = column_starts(texts, room.width());
  height = 0.0;
  for (std::size_t first = 0; first < texts.size(); first += starts.size()) {
    double row = 0.0;
    for (std::size_t i = first; i < std::min(first + starts.size(), texts.size()); ++i) {
      entries.push_back(entry_at(texts[i], room.left + starts[i - first], room.bottom - height));
      row = std::max(row, entry_height(texts[i]));
    }
    height += row;
  }
  // The rows were stacked downwards from the bottom.
  for (LegendEntry& entry : entries) {
    entry.y += height;
    for (PlacedText& line : entry.lines) line.y += height;
  }
  return entries;
}

}  // namespace

std::vector<LegendText> legend_texts(const Figure& figure, double width) {
  std::vector<LegendText> texts;
  if (figure.legend == Legend::kNone) return texts;
  std::set<std::string_view> listed;
  for (std::size_t i = 0; i < figure.layers.size(); ++i) {
    const Layer& layer = figure.layers[i];
    if (std::holds_alternative<MarkerLayer>(layer) || !is_shown(layer)) continue;
    if (!listed.insert(legend_of(layer)).second) continue;
    auto lines = wrapped(legend_of(layer), width - kSampleWidth - kTextGap, kSmallFont);
    if (!lines.empty()) texts.push_back({.layer = i, .lines = std::move(lines)});
  }
  return texts;
}

double legend_width(const std::vector<LegendText>& texts) {
  double widest = 0.0;
  for (const LegendText& text : texts) widest = std::max(widest, entry_width(text));
  return widest;
}

std::vector<LegendText> fitting_texts(const std::vector<LegendText>& texts, double height) {
  std::size_t count = texts.size();
  while (count > 0 && legend_height(first_texts(texts, count)) > height) --count;
  return first_texts(texts, count);
}

double legend_height(const std::vector<LegendText>& texts) {
  double height = 0.0;
  for (const LegendText& text : texts) height += entry_height(text);
  return height;
}

std::vector<LegendEntry> legend_column(const std::vector<LegendText>& texts, double left,
                                       double top) {
  std::vector<LegendEntry> entries;
  for (const LegendText& text : texts) {
    entries.push_back(entry_at(text, left, top));
    top -= entry_height(text);
  }
  return entries;
}

std::vector<LegendEntry> legend_rows(const std::vector<LegendText>& texts, const Box& room,
                                     double& height) {
  std::vector<LegendEntry> entries = all_rows(texts, room, height);
  for (std::size_t count = texts.size(); height > room.height() && count > 0;) {
    entries = all_rows(first_texts(texts, --count), room, height);
  }
  return entries;
}

}  // namespace microslip
