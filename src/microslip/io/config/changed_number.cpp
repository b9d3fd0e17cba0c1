// SPDX-License-Identifier: MIT
#include "microslip/io/config/changed_number.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/json_input.hpp"
#include "microslip/io/config/toml_input.hpp"

namespace microslip {
namespace {

[[noreturn]] void fail_path(std::string_view file, const std::string& path,
                            const std::string& found) {
  throw InputError(fmt::format("{}: {}", file, in_quotes(path)), found,
                   "must be the path of a number, as structure.loss_factor[1]",
                   "Elements of arrays count from 0.");
}

/// Table or array around the last key or element of a path, and that.
std::pair<std::string, std::string> split(const std::string& path) {
  const std::size_t at = path.find_last_of(".[");
  if (at == std::string::npos) return {"", path};
  std::string last = path.substr(at + 1);
  if (path[at] == '[' && last.ends_with(']')) last.pop_back();
  return {path.substr(0, at), last};
}

/// "a.b[1]" as the JSON pointer "/a/b/1".
std::string pointer_of(const std::string& path) {
  std::string pointer = "/";
  for (const char c : path) {
    if (c == ']') continue;
    if (c == '~')
      pointer += "~0";
    else
      pointer += c == '.' || c == '[' ? '/' : c;
  }
  return pointer;
}

}  // namespace

std::string toml_with_number(std::string_view text, std::string_view file, const std::string& path,
                             double value) {
  toml::table content = parse_toml(text, file);
  const toml::node_view<toml::node> node = content.at_path(path);
  if (!node) fail_path(file, path, "nothing");
  if (!node.is_number()) fail_path(file, path, described(*node.node()));
  // It may be a whole number, which cannot become another in place.
  const auto [around, last] = split(path);
  if (toml::array* array = content.at_path(around).as_array(); array != nullptr) {
    array->replace(array->cbegin() + std::stol(last), value);
  } else {
    toml::table& table = around.empty() ? content : *content.at_path(around).as_table();
    table.insert_or_assign(last, value);
  }
  std::ostringstream changed;
  changed.imbue(std::locale::classic());
  changed << content << '\n';
  return changed.str();
}

std::string json_with_number(std::string_view text, std::string_view file, const std::string& path,
                             double value) {
  Json content = parse_json(text, file);
  const Json::json_pointer place(pointer_of(path));
  if (!content.contains(place)) fail_path(file, path, "nothing");
  Json& node = content.at(place);
  if (!node.is_number()) fail_path(file, path, described(node));
  node = value;
  return content.dump();
}

}  // namespace microslip
