// SPDX-License-Identifier: MIT
#include "microslip/io/json_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "microslip/base/error.hpp"
#include "microslip/io/structured_input.hpp"
#include "microslip/io/text.hpp"

namespace microslip {
namespace {

/// Looks at each event of the parser before it becomes part of the document.
class StructureCheck {
 public:
  explicit StructureCheck(std::string_view file) : file_(file) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& value) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) check_depth(depth);
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key) check_key(value.get_ref<const std::string&>());
    return true;
  }

 private:
  void check_depth(int depth) const {
    if (depth < kDeepestNesting) return;
    throw FormatError({file_, 0, 0},
                      fmt::format("at most {} objects and arrays in each other", kDeepestNesting),
                      "more");
  }

  void check_key(const std::string& key) {
    if (!keys_.back().insert(key).second) {
      throw FormatError({file_, 0, 0}, "each key once in an object", in_quotes(key) + " twice",
                        "Remove one of them.");
    }
    if (keys_.back().size() > kMostKeys) {
      throw FormatError({file_, 0, 0}, fmt::format("at most {} keys in an object", kMostKeys),
                        "more");
    }
  }

  std::string file_;
  std::vector<std::set<std::string>> keys_;
};

/// The parser's words are "… while parsing object key - invalid literal; last read: '{n'; expected
/// string literal", where each piece may be missing.
[[noreturn]] void fail_syntax(std::string_view text, std::string_view file,
                              const Json::parse_error& error) {
  const std::string_view words = error.what();
  constexpr std::string_view kExpected = "; expected ";
  const std::size_t expected = words.rfind(kExpected);
  const std::size_t offset = error.byte == 0 ? 0 : error.byte - 1;
  throw FormatError(place_at(text, offset, file),
                    expected == std::string_view::npos
                        ? "JSON"
                        : fmt::format("{} (JSON)", words.substr(expected + kExpected.size())),
                    found_at(text, offset), "Check quotes, commas and brackets.");
}

[[noreturn]] void fail_overflow(std::string_view text, std::string_view file,
                                const Json::out_of_range& error) {
  std::string_view number = error.what();
  number.remove_prefix(std::min(number.find('\'') + 1, number.size()));
  number = number.substr(0, number.rfind('\''));
  throw FormatError(place_at(text, std::min(text.find(number), text.size()), file),
                    "a number within the range of doubles", in_quotes(number));
}

}  // namespace

Json parse_json(std::string_view text, std::string_view file) {
  require_content(text, "JSON", file);
  try {
    return Json::parse(text.begin(), text.end(), StructureCheck(file));
  } catch (const Json::parse_error& error) {
    fail_syntax(text, file, error);
  } catch (const Json::out_of_range& error) {
    fail_overflow(text, file, error);
  }
}

JsonObject::JsonObject(const Json& value, std::string_view file, std::string_view path)
    : value_(value), file_(file), path_(path) {
  if (value.is_object()) return;
  throw FormatError({file_, 0, 0},
                    path.empty() ? "an object" : fmt::format("an object as {}", path),
                    described(value));
}

void JsonObject::allow_only(const std::vector<std::string_view>& keys) const {
  for (const auto& [key, value] : value_.items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    throw unknown_key({file_, 0, 0}, path_, key, keys);
  }
}

bool JsonObject::has(std::string_view key) const {
  return value_.find(std::string(key)) != value_.end();
}

const Json& JsonObject::at(std::string_view key) const {
  const auto found = value_.find(std::string(key));
  if (found != value_.end()) return *found;
  std::vector<std::string_view> keys;
  for (const auto& [other, value] : value_.items()) keys.push_back(other);
  throw missing_key({file_, 0, 0}, path_, key, keys);
}

double JsonObject::number(std::string_view key) const {
  const Json& value = at(key);
  if (!value.is_number()) throw wrong_type(name(key), described(value), kNumber);
  return value.get<double>();
}

std::string JsonObject::text(std::string_view key) const {
  const Json& value = at(key);
  if (!value.is_string()) throw wrong_type(name(key), described(value), kText);
  return value.get<std::string>();
}

const Json& JsonObject::array(std::string_view key) const {
  const Json& value = at(key);
  if (!value.is_array()) throw wrong_type(name(key), described(value), "an array");
  return value;
}

std::vector<double> JsonObject::numbers(std::string_view key) const {
  std::vector<double> result;
  for (const Json& value : array(key)) {
    if (!value.is_number()) {
      throw wrong_type(fmt::format("{}[{}]", name(key), result.size()), described(value), kNumber);
    }
    result.push_back(value.get<double>());
  }
  return result;
}

std::string JsonObject::name(std::string_view key) const {
  return fmt::format("{}: {}", file_, key_path(path_, key));
}

std::string described(const Json& value) {
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  if (value.is_object()) return "an object";
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  return value.dump();
}

}  // namespace microslip
