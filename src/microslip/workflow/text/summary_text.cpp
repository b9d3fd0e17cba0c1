// SPDX-License-Identifier: MIT
#include "microslip/workflow/text/summary_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace microslip {

std::string line(std::string_view name, std::string_view text) {
  return fmt::format("  {:<20} {}\n", name, text);
}

namespace {

/// The end of the first word; what stands between backticks, as an option and its value, is one.
std::size_t word_end(std::string_view text) {
  std::size_t end = text.find(' ');
  const std::size_t open = text.find('`');
  if (open < end) {
    const std::size_t close = text.find('`', open + 1);
    if (close != std::string_view::npos) end = text.find(' ', close);
  }
  return std::min(end, text.size());
}

}  // namespace

std::string wrapped(std::string_view first, std::string_view text, std::size_t indent,
                    std::size_t width) {
  std::string result(first);
  std::size_t column = first.size();
  while (!text.empty()) {
    const std::size_t end = word_end(text);
    if (column + end > width && column > indent) {
      result.pop_back();  // the blank before the break
      result += "\n" + std::string(indent, ' ');
      column = indent;
    }
    result += text.substr(0, end);
    column += end;
    text.remove_prefix(end);
    if (!text.empty()) {
      text.remove_prefix(1);
      result += ' ';
      ++column;
    }
  }
  return result + "\n";
}

std::string shortened(const std::string& source, std::size_t width) {
  std::string name = source.substr(source.find_last_of('/') + 1);
  std::ranges::replace_if(
      name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return name.size() <= width ? name : "~" + name.substr(name.size() - width + 1);
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::vector<Warning> kinds_of(const std::vector<FlaggedRecord>& records, std::string_view noun,
                              std::size_t source_width) {
  std::set<std::string> known;
  std::vector<Warning> kinds;
  for (const auto& [source, flags] : records) {
    for (const auto& [code, text] : flags) {
      if (!known.insert(code).second) continue;
      const auto count = std::ranges::count_if(records, [&code = code](const FlaggedRecord& other) {
        return std::ranges::find(other.flags, code, &Warning::code) != other.flags.end();
      });
      kinds.push_back({fmt::format("{} ({} of {} {}, first {})", code, count, records.size(), noun,
                                   shortened(source, source_width)),
                       text});
    }
  }
  return kinds;
}

}  // namespace microslip
