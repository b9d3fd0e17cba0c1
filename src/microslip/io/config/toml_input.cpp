// SPDX-License-Identifier: MIT
#include "microslip/io/config/toml_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/unicode.hpp"
#include "microslip/io/config/structured_input.hpp"
#include "microslip/io/config/toml_nesting.hpp"

namespace microslip {
namespace {

TextPlace place_of(const toml::source_position& position, std::string_view file) {
  return {std::string(file), position.line, position.column};
}

std::string name_of(const toml::node& node, std::string_view file, std::string_view path) {
  return fmt::format("{}: {}", place_text(place_of(node.source().begin, file)), path);
}

/// 12.0
bool is_whole(const toml::node& node) {
  const toml::value<double>* number = node.as_floating_point();
  return number != nullptr && number->get() == std::round(number->get());
}

/// For what users of other formats, of word processors and of Windows write.
std::string_view remedy_for_syntax(std::string_view found, std::string_view said) {
  constexpr std::string_view kDigits = "0123456789";
  if (said.find("floating-point: expected decimal digit") != said.npos) {
    return "A decimal point needs a digit on each side: 80.0 or 0.5.";
  }
  if (found.starts_with(',') && found.size() > 1 && kDigits.find(found[1]) != kDigits.npos) {
    return "Write a decimal point, not a comma.";
  }
  if (found.starts_with(':')) return "Write key = value.";
  if (found.starts_with(';')) return "Only a comment may follow a value: remove ';'.";
  for (const std::string_view quote : {"\u201C", "\u201D", "\u201E", "\u2018", "\u2019"}) {
    if (found.starts_with(quote)) return "Use straight quotes: \"text\".";
  }
  if (said.find("escape sequence") != said.npos) {
    return "In \"...\" a backslash starts an escape: write paths with '/', or in '...'.";
  }
  if (said.find("control characters") != said.npos) {
    return "Close the quote on the same line.";
  }
  return "Quote strings; write numbers with a decimal point and no unit; give each key once per "
         "table; write [[table]] for each of several tables.";
}

/// The message of the parser is passed on verbatim.
[[noreturn]] void fail_syntax(std::string_view text, std::string_view file,
                              const toml::parse_error& error) {
  constexpr std::size_t kLongest = 120;  // it may hold a whole key
  const TextPlace place = place_of(error.source().begin, file);
  const std::size_t offset = offset_of(text, place);
  throw FormatError(place, "TOML", found_at(text, offset),
                    fmt::format("The parser says {}. {}", in_quotes(error.description(), kLongest),
                                remedy_for_syntax(text.substr(offset), error.description())));
}

/// Whether the first line that is no comment is the header of a table: commas, and neither a value
/// nor a [table].
bool begins_as_csv(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    return line[first] != '[' && line.find('=') == std::string_view::npos &&
           line.find_first_of(",;") != std::string_view::npos;
  }
  return false;
}

void require_toml(std::string_view text, std::string_view file) {
  require_content(text, KindFormat::kToml, file);
  std::string_view other = signature(text);
  if (other.empty() && begins_as_csv(text)) other = "a table of comma-separated values";
  if (!other.empty()) {
    throw FormatError({std::string(file), 0, 0}, "TOML", other, remedy_for_signature(other));
  }
  const std::size_t valid = valid_utf8(text);
  if (valid == text.size()) return;
  throw FormatError(place_at(text, valid, file), "UTF-8", found_at(text, valid),
                    "Save the file as UTF-8.");
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view file) {
  require_toml(text, file);
  check_toml_nesting(text, file);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    fail_syntax(text, file, error);
  }
}

TomlTable::TomlTable(const toml::table& table, std::string_view file, std::string_view path)
    : table_(table), file_(file), path_(path) {}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table_) keys.emplace_back(key.str());
  return keys;
}

void TomlTable::allow_only(const std::vector<std::string_view>& keys) const {
  for (const auto& [key, value] : table_) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    throw unknown_key(place_of(key.source().begin, file_), path_, key.str(), keys);
  }
}

bool TomlTable::has(std::string_view key) const { return table_.contains(key); }

const toml::node& TomlTable::at(std::string_view key) const {
  if (const toml::node* node = table_.get(key)) return *node;
  std::vector<std::string_view> keys;
  for (const auto& [other, value] : table_) keys.push_back(other.str());
  throw missing_key(place(key), path_, key, keys);
}

double TomlTable::number(std::string_view key) const {
  return number_of(at(key), key_path(path_, key));
}

double TomlTable::number_of(const toml::node& node, std::string_view path) const {
  if (!node.is_number()) throw wrong(node, path, kNumber);
  // value<double>() has none for whole numbers that a double rounds, above 2^53.
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  return node.as_floating_point()->get();
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  const toml::node& node = at(key);
  const toml::array* array = node.as_array();
  if (!array) {
    throw wrong(node, key_path(path_, key), "an array of numbers",
                node.is_number() ? "Write it in [ ]." : "");
  }
  std::vector<double> result;
  for (const toml::node& element : *array) {
    result.push_back(number_of(element, element_path(key, result.size())));
  }
  return result;
}

std::size_t TomlTable::whole(std::string_view key) const {
  const toml::node& node = at(key);
  const toml::value<std::int64_t>* integer = node.as_integer();
  if (!integer || integer->get() < 0) {
    throw wrong(node, key_path(path_, key), "a whole number, 0 or more",
                is_whole(node) ? "Write it without a decimal point." : "");
  }
  return static_cast<std::size_t>(integer->get());
}

std::string TomlTable::text(std::string_view key) const {
  const toml::node& node = at(key);
  const toml::value<std::string>* text = node.as_string();
  if (!text) throw wrong(node, key_path(path_, key), kText);
  return text->get();
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
  const toml::node& node = at(key);
  const toml::array* array = node.as_array();
  if (!array) {
    throw wrong(node, key_path(path_, key), "an array of texts",
                node.is_string() ? "Write it in [ ]." : "");
  }
  std::vector<std::string> result;
  for (const toml::node& element : *array) {
    const toml::value<std::string>* text = element.as_string();
    if (!text) throw wrong(element, element_path(key, result.size()), kText);
    result.push_back(text->get());
  }
  return result;
}

bool TomlTable::boolean(std::string_view key) const {
  const toml::node& node = at(key);
  const toml::value<bool>* value = node.as_boolean();
  if (!value) throw wrong(node, key_path(path_, key), "true or false");
  return value->get();
}

bool TomlTable::is_text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node != nullptr && node->is_string();
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node& node = at(key);
  const std::string path = key_path(path_, key);
  if (const toml::table* table = node.as_table()) return {*table, file_, path};
  throw wrong(node, path, "a table",
              node.is_array_of_tables() ? fmt::format("Write [{}], and only once.", path) : "");
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const toml::node& node = at(key);
  const toml::array* array = node.as_array();
  if (!array) {
    const std::string path = key_path(path_, key);
    throw wrong(node, path, "an array of tables", fmt::format("Write [[{}]].", path));
  }
  std::vector<TomlTable> result;
  for (const toml::node& element : *array) {
    const std::string path = element_path(key, result.size());
    if (!element.is_table()) throw wrong(element, path, "a table");
    result.emplace_back(*element.as_table(), file_, path);
  }
  return result;
}

std::vector<TomlTable> TomlTable::one_or_more(std::string_view key) const {
  if (at(key).is_table()) return {table(key)};
  return tables(key);
}

TextPlace TomlTable::place(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return place_of((node ? *node : table_).source().begin, file_);
}

std::string TomlTable::name(std::string_view key) const {
  return fmt::format("{}: {}", place_text(place(key)), key_path(path_, key));
}

std::string TomlTable::name(std::string_view key, std::size_t index) const {
  const toml::array* array = at(key).as_array();
  const toml::node* element = array ? array->get(index) : nullptr;
  return name_of(element ? *element : at(key), file_, element_path(key, index));
}

std::string TomlTable::element_path(std::string_view key, std::size_t index) const {
  return fmt::format("{}[{}]", key_path(path_, key), index);
}

InputError TomlTable::wrong(const toml::node& node, std::string_view path, std::string_view type,
                            std::string_view remedy) const {
  return wrong_type(name_of(node, file_, path), described(node), type, remedy);
}

std::string toml_name(const toml::table& top, std::string_view file, std::string_view path) {
  for (std::string_view part = path; !part.empty();) {
    if (const toml::node* node = top.at_path(part).node()) return name_of(*node, file, path);
    const std::size_t end = part.find_last_of(".[");
    part = part.substr(0, end == std::string_view::npos ? 0 : end);
  }
  return name_of(top, file, path);
}

std::string described(const toml::node& value) {
  if (const auto* integer = value.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* boolean = value.as_boolean()) return boolean->get() ? "true" : "false";
  if (const auto* text = value.as_string()) return in_quotes(text->get());
  if (const auto* array = value.as_array()) return fmt::format("an array of {}", array->size());
  return value.is_table() ? "a table" : "a date or time";
}

}  // namespace microslip
