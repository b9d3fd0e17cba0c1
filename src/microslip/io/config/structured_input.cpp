// SPDX-License-Identifier: MIT
#include "microslip/io/config/structured_input.hpp"

#include <fmt/format.h>

#include "microslip/io/bytes/closest_name.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

std::string where(std::string_view path) {
  return path.empty() ? "at the top" : fmt::format("in {}", path);
}

}  // namespace

void require_content(std::string_view text, KindFormat format, std::string_view file) {
  const std::string_view name = format == KindFormat::kJson ? "JSON" : "TOML";
  const KnownKind* const known = known_kind_of(text);
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  // Of JSON with a foreign schema check_schema() says more.
  const bool is_json = trimmed(text).starts_with('{');
  if (known != nullptr && known->format != format && !(is_json && format == KindFormat::kJson)) {
    throw FormatError({std::string(file), 0, 0}, name, known->words, "Is it the right file?");
  }
  if (text.find_first_not_of(" \t\r\n") != std::string_view::npos) return;
  throw FormatError({std::string(file), 0, 0}, name, "an empty file");
}

std::string key_path(std::string_view path, std::string_view key) {
  return fmt::format("{}{}{}", path, path.empty() ? "" : ".", key);
}

FormatError unknown_key(const TextPlace& place, std::string_view path, std::string_view key,
                        const std::vector<std::string_view>& allowed) {
  const std::string_view closest = closest_name(key, allowed);
  return {place, fmt::format("{} the keys {}", where(path), fmt::join(allowed, ", ")),
          fmt::format("the unknown key {}", in_quotes(key)),
          closest.empty() ? "Correct or remove it." : fmt::format("Did you mean '{}'?", closest)};
}

FormatError missing_key(const TextPlace& place, std::string_view path, std::string_view key,
                        const std::vector<std::string_view>& present) {
  const std::string keys = fmt::format("{}", fmt::join(present, ", "));
  return {place, fmt::format("the key '{}' {}", key, where(path)),
          keys.empty() ? "no key" : fmt::format("the keys {}", in_quotes(keys, 120)),
          key == "schema" ? "It states the kind of the file: see docs/file_formats.md." : ""};
}

InputError wrong_type(std::string_view name, std::string_view found, std::string_view type,
                      std::string_view remedy) {
  const bool quoted_number = found.starts_with('\'') && type == kNumber;
  return {name, found, fmt::format("must be {}", type),
          quoted_number ? "Write it without quotes." : remedy};
}

void check_schema(const TextPlace& place, std::string_view found, std::string_view schema,
                  std::string_view content) {
  if (found == schema) return;
  const bool rig_as_model = found.starts_with("microslip.rig/") && content == "a model";
  const KnownKind* const known = known_kind(found);
  std::string remedy = fmt::format("Is it {}, and of this version of the program?", content);
  if (known != nullptr) remedy = fmt::format("This is {}, not {}.", known->words, content);
  if (rig_as_model) remedy += " Make a model of it: microslip model RIG.toml JOINT.json.";
  throw FormatError(place, fmt::format("the schema '{}'", schema), in_quotes(found), remedy);
}

}  // namespace microslip
