// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <regex>
#include <string>
#include <vector>

/// @file
/// The pairs `key = value` of a text of TOML, to be left out or replaced one by one.

namespace microslip::test {

/// A pair `key = value` of a text of TOML, a pair in an inline table among them.
struct Pair {
  std::size_t start = 0, value_start = 0, end = 0;
  std::size_t line = 0;
  std::string key;
  std::string path;  ///< of the key
};

/// Paths of tables as the messages name them: an array's have an index.
class TablePaths {
 public:
  std::string next(const std::string& header, bool is_array) {
    return is_array ? fmt::format("{}[{}]", header, count_[header]++) : header;
  }

 private:
  std::map<std::string, int> count_;
};

inline std::vector<Pair> pairs_of(const std::string& text) {
  static const std::regex header(R"(^\[(\[?)([\w.]+)\])");
  static const std::regex pair(R"re((\w+) = ("[^"]*"|\[[^\]]*\]|[-+.e\d]+|\{))re");
  std::vector<Pair> pairs;
  TablePaths paths;
  std::string table;
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t line_end = text.find('\n', start);
    const std::string line = text.substr(start, line_end - start);
    const std::string code = line.substr(0, line.find('#'));
    ++number;
    std::smatch match;
    if (std::regex_search(code, match, header)) table = paths.next(match[2], match.length(1) > 0);
    std::string prefix = table.empty() ? "" : table + ".";
    for (std::sregex_iterator i(code.begin(), code.end(), pair), end; i != end; ++i) {
      const auto at = [&](int group) {
        return start + static_cast<std::size_t>(i->position(group));
      };
      if ((*i)[2] == "{") {
        prefix += (*i)[1].str() + ".";
        continue;
      }
      pairs.push_back({at(0), at(2), at(0) + static_cast<std::size_t>(i->length(0)), number,
                       (*i)[1], prefix + (*i)[1].str()});
    }
    start = line_end + 1;
  }
  return pairs;
}

inline std::string without(const std::string& text, const Pair& pair) {
  std::string result = text;
  result.erase(pair.start, pair.end - pair.start);
  if (result.compare(pair.start, 2, ", ") == 0) {
    result.erase(pair.start, 2);
  } else if (pair.start >= 2 && result.compare(pair.start - 2, 2, ", ") == 0) {
    result.erase(pair.start - 2, 2);
  }
  return result;
}

}  // namespace microslip::test
