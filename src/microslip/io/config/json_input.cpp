// SPDX-License-Identifier: MIT
#include "microslip/io/config/json_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/structured_input.hpp"

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
                      fmt::format("at most {} nested objects and arrays", kDeepestNesting), "more");
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

[[noreturn]] void fail_syntax(std::string_view text, std::string_view file,
                              const Json::parse_error& error) {
  const std::size_t offset = error.byte == 0 ? 0 : error.byte - 1;
  throw FormatError(place_at(text, offset, file), "JSON", found_at(text, offset),
                    "Check quotes, commas and brackets.");
}

/// The first number that is no double, outside of texts; the end of the text where there is none.
/// The parser refuses it, but does not say where it stands.
std::string_view first_overflow(std::string_view text) {
  constexpr std::string_view kOfNumbers = "+-.0123456789eE";
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') {
      while (++at < text.size() && text[at] != '"') {
        if (text[at] == '\\') ++at;
      }
    } else if (text[at] == '-' || (text[at] >= '0' && text[at] <= '9')) {
      const std::size_t end = std::min(text.find_first_not_of(kOfNumbers, at), text.size());
      const std::string number(text.substr(at, end - at));
      if (std::isinf(std::strtod(number.c_str(), nullptr))) return text.substr(at, end - at);
      at = end - 1;
    }
  }
  return text.substr(text.size());
}

[[noreturn]] void fail_overflow(std::string_view text, std::string_view file) {
  const std::string_view number = first_overflow(text);
  throw FormatError(place_at(text, static_cast<std::size_t>(number.data() - text.data()), file),
                    "a number within the range of doubles", in_quotes(number));
}

}  // namespace

Json parse_json(std::string_view text, std::string_view file) {
  require_content(text, KindFormat::kJson, file);
  try {
    return Json::parse(text.begin(), text.end(), StructureCheck(file));
  } catch (const Json::parse_error& error) {
    fail_syntax(text, file, error);
  } catch (const Json::out_of_range&) {
    fail_overflow(text, file);
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

namespace {

/// -0.0 is 0, as -0 is: a whole number of JSON.
double number_in_json(const Json& value) {
  const auto number = value.get<double>();
  return number == 0.0 ? 0.0 : number;
}

}  // namespace

double JsonObject::number(std::string_view key) const {
  const Json& value = at(key);
  if (!value.is_number()) throw wrong_type(name(key), described(value), kNumber);
  return number_in_json(value);
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
    result.push_back(number_in_json(value));
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
