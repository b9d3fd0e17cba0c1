// SPDX-License-Identifier: MIT
#include "microslip/io/config/record_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "microslip/base/error.hpp"
#include "microslip/io/config/json_texts.hpp"
#include "microslip/io/config/named_value_access.hpp"

namespace microslip {

bool RecordValues::has(std::string_view key, bool written) const {
  return reads() ? number_in(*read_, key).has_value() || count(key) > 0 : written;
}

std::vector<std::string> RecordValues::names(std::string_view prefix) const {
  std::vector<std::string> names;
  if (!reads()) return names;
  for (const auto& [key, value] : *read_) {
    if (!key.starts_with(prefix) || !std::holds_alternative<double>(value)) continue;
    names.push_back(key.substr(prefix.size()));
  }
  return names;
}

void RecordValues::one(const std::string& key, double& value) {
  if (reads()) {
    value = number_in(*read_, key).value_or(value);
  } else {
    written_.emplace_back(key, value);
  }
}

void RecordValues::one(const std::string& key, std::optional<double>& value) {
  if (reads()) {
    if (const auto found = number_in(*read_, key)) value = found;
  } else if (value) {
    written_.emplace_back(key, *value);
  }
}

void RecordValues::one(const std::string& key, std::string& value) {
  if (reads()) {
    value = text_in(*read_, key).value_or(value);
  } else if (!value.empty()) {
    written_.emplace_back(key, value);
  }
}

void RecordValues::one(const std::string& key, bool& value, std::string_view yes,
                       std::string_view no) {
  std::string word(value ? yes : no);
  one(key, word);
  if (word == yes || word == no) value = word == yes;
}

void RecordValues::list(const std::string& key, std::vector<double>& values) {
  if (reads()) {
    values = numbers_in(*read_, key);
  } else {
    written_.emplace_back(key, values);
  }
}

void RecordValues::list(const std::string& key, std::vector<std::string>& values) {
  if (reads()) {
    values = texts_in(*read_, key);
  } else {
    written_.emplace_back(key, list_of_texts(values));
  }
}

void RecordValues::pair(const std::string& key, double& first, double& second) {
  std::vector<double> both{first, second};
  list(key, both, 2);
  first = both[0];
  second = both[1];
}

std::size_t RecordValues::count(std::string_view key) const {
  return std::max(numbers_in(*read_, key).size(), texts_in(*read_, key).size());
}

std::size_t RecordValues::place(std::string_view key, double value, std::size_t count,
                                std::string_view what) const {
  const bool whole = value >= 1.0 && value <= static_cast<double>(count) &&
                     value == static_cast<double>(static_cast<std::size_t>(value));
  if (whole) return static_cast<std::size_t>(value) - 1;
  throw InputError(fmt::format("{}.{}", object_, key), value,
                   fmt::format("must be a whole number from 1 to the {} {}", count, what), remedy_);
}

void RecordValues::require(std::string_view key) const {
  if (!reads() || number_in(*read_, key) || text_in(*read_, key)) return;
  throw InputError(fmt::format("{}.{}", object_, key), InputState{"missing or of another kind"},
                   "must be given", remedy_);
}

void RecordValues::check_count(std::string_view key, std::size_t found, std::size_t expected,
                               const char* items) const {
  if (found == expected) return;
  throw InputError(fmt::format("{}.{}", object_, key), fmt::format("{} {}", found, items),
                   fmt::format("must be {}, to match the other data", expected), remedy_);
}

}  // namespace microslip
