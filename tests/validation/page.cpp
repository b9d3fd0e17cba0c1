// SPDX-License-Identifier: MIT
#include "validation/page.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace microslip::validation {
namespace {

constexpr std::string_view kOpen = "<!-- validation: ";
constexpr std::string_view kClose = "<!-- end validation -->";
constexpr std::string_view kAsAbove = "the same";
constexpr std::string_view kNoData = "not measured, its data are not there";

/// The lines of a text; what `inside` and `outside` make of each of a block (with its name) and of
/// the others, marks among those, in turn.
template <class Inside, class Outside>
void each_line(const std::string& text, const Inside& inside, const Outside& outside) {
  std::istringstream lines(text);
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kOpen)) {
      if (!block.empty()) throw std::runtime_error("block " + block + " does not end");
      block = line.substr(kOpen.size(), line.rfind(" -->") - kOpen.size());
      outside(line);
      inside(block, "");
    } else if (line == kClose) {
      if (block.empty()) throw std::runtime_error("a block ends that did not begin");
      block.clear();
      outside(line);
    } else if (block.empty()) {
      outside(line);
    } else {
      inside(block, line + '\n');
    }
  }
  if (!block.empty()) throw std::runtime_error("block " + block + " does not end");
}

/// 4.9e-3, 0.045, 1234: without an exponent from 0.01 on.
std::string number_text(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (value != 0.0 && std::abs(value) < 0.01) text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  const bool negative = text[exponent + 1] == '-';
  const std::string power = text.substr(text.find_first_not_of('0', exponent + 2));
  text.resize(exponent);
  if (text.find('.') != std::string::npos) {
    text.resize(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
  }
  return text + (negative ? "e-" : "e") + power;
}

std::string with_unit(std::string text, const FigureLine& line) {
  if (!line.unit.empty()) text += ' ' + line.unit;
  return text;
}

std::string bound_text(const FigureLine& line) {
  constexpr int kAllDigits = 6;
  const auto text = [](double bound) { return number_text(bound, kAllDigits); };
  if (line.counts_tests()) return "all pass";
  if (line.at_least && line.at_most) {
    return with_unit(text(*line.at_least) + " to " + text(*line.at_most), line);
  }
  if (line.at_most) return with_unit("≤ " + text(*line.at_most), line);
  if (line.at_least) return with_unit("≥ " + text(*line.at_least), line);
  return "–";
}

std::string figure_text(const FigureLine& line, const std::optional<double>& figure) {
  if (!figure) return std::string(kNoData);
  if (line.counts_tests()) return fmt::format("{:g} pass", *figure);
  return with_unit(number_text(*figure, line.digits), line);
}

/// The cells of a line of a table, `| a | b |`.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = line.find("| "); at != std::string::npos;) {
    const std::size_t end = line.find(" |", at + 2);
    if (end == std::string::npos) break;
    cells.push_back(line.substr(at + 2, end - at - 2));
    at = end + 1;
  }
  return cells;
}

}  // namespace

Blocks blocks_of(const std::string& text) {
  Blocks blocks;
  each_line(
      text,
      [&](const std::string& block, const std::string& line) {
        if (line.empty() && blocks.contains(block)) {
          throw std::runtime_error("block " + block + " stands twice");
        }
        blocks[block] += line;
      },
      [](const std::string&) {});
  return blocks;
}

std::string with_blocks(const std::string& text, const Blocks& blocks) {
  std::string result;
  each_line(
      text,
      [&](const std::string& block, const std::string& line) {
        if (!line.empty()) return;
        const auto content = blocks.find(block);
        if (content == blocks.end()) throw std::runtime_error("nothing for block " + block);
        result += content->second;
      },
      [&](const std::string& line) { result += line + '\n'; });
  return result;
}

std::string table_of(const std::vector<FigureLine>& lines, const Figures& figures) {
  std::string table = "| what | measured | bound | against | by |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    table += fmt::format("| {} | {} | {} | {} | `{}` |\n", lines[i].what,
                         figure_text(lines[i], figures.at(i)), bound_text(lines[i]),
                         lines[i].reference, lines[i].by);
  }
  return table;
}

Blocks tables_of(const std::vector<FigureTopic>& topics, const std::vector<Figures>& figures) {
  Blocks blocks;
  std::map<int, std::string> summary;  // by their places
  for (std::size_t t = 0; t < topics.size(); ++t) {
    const std::vector<FigureLine>& lines = topics[t].lines;
    blocks[topics[t].name] = table_of(lines, figures.at(t));
    std::string against;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string& reference = lines[i].reference;
      const bool as_above = reference.starts_with(kAsAbove);
      if (!as_above) against = reference;
      if (lines[i].summary == 0) continue;
      const std::string rest = as_above ? reference.substr(kAsAbove.size()) : "";
      summary[lines[i].summary] +=
          fmt::format("| {} | {} | {} | {}{} |\n", lines[i].what,
                      figure_text(lines[i], figures[t].at(i)), bound_text(lines[i]), against, rest);
    }
  }
  std::string& table = blocks["summary"] =
      "| what | measured | bound | against |\n|---|---|---|---|\n";
  for (const auto& [place, text] : summary) table += text;
  return blocks;
}

Figures figures_in(const std::string& table) {
  Figures figures;
  std::istringstream lines(table);
  std::string line;
  for (int number = 0; std::getline(lines, line); ++number) {
    if (number < 2) continue;  // head and rule
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 5) throw std::runtime_error("not five cells: " + line);
    const std::string& text = cells[1];
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() && text != kNoData) throw std::runtime_error("no number: " + line);
    figures.push_back(text == kNoData ? std::nullopt : std::optional(value));
  }
  return figures;
}

std::optional<std::string> broken_bound(const FigureLine& line, double figure) {
  const bool kept = (!line.at_most || figure <= *line.at_most) &&
                    (!line.at_least || figure >= *line.at_least) && !std::isnan(figure);
  if (kept) return std::nullopt;
  return fmt::format("{}: {}, bound {} ({})", line.what, figure_text(line, figure),
                     bound_text(line), line.by);
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot open " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace microslip::validation
