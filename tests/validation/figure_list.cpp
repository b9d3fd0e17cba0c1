// SPDX-License-Identifier: MIT
#include "validation/figure_list.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <string_view>

// As the library has it: tests that link both must not have two definitions of one parser.
#define TOML_ASSERT(expr) static_assert(true)
#include <toml++/toml.h>

namespace microslip::validation {
namespace {

/// The text in the brackets of `name [unit]`; none for [1].
std::string unit_of(const std::string& figure) {
  const std::size_t open = figure.rfind('[');
  if (open == std::string::npos || !figure.ends_with(']')) return "";
  const std::string unit = figure.substr(open + 1, figure.size() - open - 2);
  return unit == "1" ? "" : unit;
}

class LineReader {
 public:
  explicit LineReader(const toml::table& table) : table_(table) {}

  FigureLine read() {
    FigureLine line;
    line.what = text("what", true);
    line.by = text("by", true);
    line.figure = text("figure");
    line.over = text("over");
    line.unit = taken("unit") ? text("unit") : unit_of(line.figure);
    line.scale = number("scale").value_or(1.0);
    line.digits = static_cast<int>(number("digits").value_or(2.0));
    line.at_least = number("at_least");
    line.at_most = number("at_most");
    line.reference = text("reference", true);
    line.external = flag("external");
    line.summary = static_cast<int>(number("summary").value_or(0.0));
    for (const auto& [key, value] : table_) {
      if (!known_.contains(std::string(key.str()))) fail(fmt::format("unknown key {}", key.str()));
    }
    if (line.counts_tests() && (line.at_least || line.at_most)) fail("a bound needs a figure");
    return line;
  }

 private:
  [[noreturn]] void fail(const std::string& rule) const {
    throw std::runtime_error(fmt::format("figures.toml:{}: {}", table_.source().begin.line, rule));
  }

  bool taken(const std::string& key) {
    known_.insert(key);
    return table_.contains(key);
  }

  std::string text(const std::string& key, bool needed = false) {
    if (!taken(key) && !needed) return "";
    const auto value = table_[key].value<std::string>();
    if (!value || (needed && value->empty())) fail(key + " must be a text");
    if (value->find_first_of("|\n") != std::string::npos) fail(key + " must have no | or line end");
    return *value;
  }

  std::optional<double> number(const std::string& key) {
    if (!taken(key)) return std::nullopt;
    const auto value = table_[key].value<double>();
    if (!value) fail(key + " must be a number");
    return value;
  }

  bool flag(const std::string& key) {
    return taken(key) && table_[key].value<bool>().value_or(false);
  }

  const toml::table& table_;
  std::set<std::string> known_;
};

}  // namespace

std::vector<FigureTopic> read_figure_list(const std::string& path) {
  const toml::table file = toml::parse_file(path);
  std::vector<FigureTopic> topics;
  const toml::array* tables = file["topic"].as_array();
  if (tables == nullptr) throw std::runtime_error(path + ": there is no [[topic]]");
  for (const toml::node& node : *tables) {
    const toml::table& table = *node.as_table();
    FigureTopic topic{table["name"].value_or(std::string()), {}};
    const toml::array* lines = table["line"].as_array();
    if (topic.name.empty() || lines == nullptr) {
      throw std::runtime_error(path + ": a topic needs a name and lines");
    }
    for (const toml::node& line : *lines) {
      topic.lines.push_back(LineReader(*line.as_table()).read());
    }
    topics.push_back(std::move(topic));
  }
  return topics;
}

}  // namespace microslip::validation
