// SPDX-License-Identifier: MIT
#include "cli/effects_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "io/support.hpp"

namespace microslip::cli_test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

std::string without_unit(const std::string& name) {
  return trimmed(name.substr(0, name.find('[')));
}

/// A table as cells, and which lines they come from; comments are left out.
struct Cells {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  explicit Cells(const std::string& text) {
    for (const std::string& line : lines_of(text)) {
      if (line.starts_with('#')) comments += line + '\n';
      if (trimmed(line).empty() || line.starts_with('#')) continue;
      if (names.empty()) {
        header = parts(line, ",");
        for (const std::string& name : header) names.push_back(without_unit(name));
      } else {
        rows.push_back(parts(line, ","));
      }
    }
  }
  [[nodiscard]] std::size_t column(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  }
  [[nodiscard]] std::string text() const {
    std::string result = fmt::format("{}{}\n", comments, fmt::join(header, ","));
    for (const auto& row : rows) result += fmt::format("{}\n", fmt::join(row, ","));
    return result;
  }

  std::string comments;  // they come first
  std::vector<std::string> header;
};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  std::size_t at = text.find(from);
  if (from.empty() || at == std::string::npos) throw std::runtime_error("nowhere: " + from);
  for (; at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string with_column(const std::string& text, const std::string& name, const double* factor) {
  Cells cells(text);
  const std::size_t j = cells.column(name);
  if (j == cells.names.size()) throw std::runtime_error("no column " + name);
  const auto at = static_cast<std::ptrdiff_t>(j);
  if (factor == nullptr) cells.header.erase(cells.header.begin() + at);
  for (auto& row : cells.rows) {
    if (factor == nullptr) {
      row.erase(row.begin() + at);
    } else if (!row.at(j).empty()) {
      row[j] = fmt::format("{:.17g}", *factor * std::stod(row[j]));
    }
  }
  return cells.text();
}

std::string json_part(const std::string& text, const std::string& pointer) {
  const auto json = nlohmann::ordered_json::parse(text);
  const nlohmann::ordered_json::json_pointer place(pointer);
  return json.contains(place) ? json.at(place).dump() : "";
}

std::string whole(const std::string& text) {
  if (text.starts_with('{')) {
    auto json = nlohmann::ordered_json::parse(text);
    json.erase("provenance");
    return json.dump();
  }
  std::string result;
  for (const std::string& line : lines_of(text)) {
    if (!line.starts_with('#')) result += line + '\n';
  }
  return result;
}

}  // namespace

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> parts(const std::string& text, const std::string& separator) {
  std::vector<std::string> result;
  std::size_t from = 0;
  for (std::size_t to = 0; to != std::string::npos; from = to + separator.size()) {
    to = text.find(separator, from);
    result.push_back(trimmed(text.substr(from, to == std::string::npos ? to : to - from)));
  }
  return result;
}

std::vector<EffectRow> effect_rows() {
  std::vector<EffectRow> result;
  int number = 0;
  for (const std::string& line : lines_of(test::get(MICROSLIP_TEST_DATA "/effects.txt"))) {
    ++number;
    if (trimmed(line).empty() || line.starts_with('#')) continue;
    std::vector<std::string> cells = parts(line, "|");
    if (cells.size() == 5) {
      result.push_back({number, cells[0], cells[1], cells[2], cells[3], parts(cells[4], ";")});
    } else {
      result.push_back({number, "", line, "", "", {}});
    }
  }
  return result;
}

std::map<std::string, std::string> documented_files() {
  const std::string page = test::get(MICROSLIP_EXAMPLES "/../docs/file_formats.md");
  static const std::regex block("<!-- file (\\S+) -->\n```[a-z]+\n([^`]*)```");
  std::map<std::string, std::string> result;
  for (std::sregex_iterator at(page.begin(), page.end(), block); at != std::sregex_iterator();
       ++at) {
    result[(*at)[1]] = (*at)[2];
  }
  return result;
}

std::vector<std::string> documented_columns(const std::string& section) {
  const std::string page = test::get(MICROSLIP_EXAMPLES "/../docs/file_formats.md");
  const std::string text = page.substr(page.find("\n" + section));
  const std::size_t begin = text.find("Required:");
  const std::string sentence = text.substr(begin, text.find("\n\n", begin) - begin);
  static const std::regex column("`([A-Za-z_ ]+) \\[[^\\]]+\\]`");
  std::vector<std::string> result;
  for (std::sregex_iterator at(sentence.begin(), sentence.end(), column);
       at != std::sregex_iterator(); ++at) {
    result.push_back((*at)[1]);
  }
  return result;
}

std::vector<std::string> keys_in(const std::string& text) {
  static const std::regex comment("#[^\n]*");
  static const std::regex key("\"?([A-Za-z_0-9]+)\"?\\s*(=|:)");
  const std::string bare = std::regex_replace(text, comment, "");
  std::vector<std::string> result;
  for (std::sregex_iterator at(bare.begin(), bare.end(), key); at != std::sregex_iterator(); ++at) {
    if (!std::ranges::count(result, (*at)[1])) result.push_back((*at)[1]);
  }
  return result;
}

std::string edited(const std::string& text, const std::string& edit) {
  std::string result = text;
  if (const std::vector<std::string> sides = parts(edit, "->"); sides.size() == 2) {
    replace_all(result, sides[0], sides[1]);
    return result;
  }
  if (edit.ends_with(" removed")) {
    return with_column(text, trimmed(edit.substr(0, edit.size() - 8)), nullptr);
  }
  const std::vector<std::string> sides = parts(edit, "*");
  if (sides.size() != 2) throw std::runtime_error("no edit: " + edit);
  const double factor = std::stod(sides[1]);
  return with_column(text, sides[0], &factor);
}

std::string content_of(const std::string& text, const std::string& part) {
  if (part.empty()) return whole(text);
  if (part.starts_with('/')) return json_part(text, part);
  if (part.starts_with('#')) {
    std::string result;
    for (const std::string& line : lines_of(text)) {
      if (line.starts_with("# " + part.substr(1))) result += line + '\n';
    }
    return result;
  }
  const Cells cells(text);
  const std::size_t j = cells.column(part);
  std::string result;
  for (const auto& row : cells.rows) {
    if (j < row.size()) result += row[j] + '\n';
  }
  return result;
}

}  // namespace microslip::cli_test
