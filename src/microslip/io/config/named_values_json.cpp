// SPDX-License-Identifier: MIT
#include "microslip/io/config/named_values_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

/// Whether the value is a number that a double holds; integers beyond 2^53 may not be.
bool is_exact_double(const Json& value) {
  if (!value.is_number_integer()) return value.is_number();
  const auto nearest = value.get<double>();
  if (std::abs(nearest) < 0x1p63) return static_cast<std::int64_t>(nearest) == value;
  return nearest < 0x1p64 && nearest > 0.0 && static_cast<std::uint64_t>(nearest) == value;
}

bool is_number_array(const Json& value) {
  return value.is_array() && std::all_of(value.begin(), value.end(), is_exact_double);
}

NamedValue read_value(const Json& value) {
  if (is_exact_double(value)) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  if (is_number_array(value)) return value.get<std::vector<double>>();
  return JsonText{value.dump()};
}

bool is_input_hash(const Json& value) {
  const auto has_text = [&](const char* key) {
    return value.contains(key) && value[key].is_string();
  };
  return value.is_object() && value.size() == 2 && has_text("file") && has_text("sha256");
}

/// True where the value has the form that its key asks for.
bool read_known(const std::string& key, const Json& value, Provenance& provenance) {
  if (key == "program" && value.is_string()) {
    provenance.program = value.get<std::string>();
  } else if (key == "version" && value.is_string()) {
    provenance.version = value.get<std::string>();
  } else if (key == "command" && value.is_string()) {
    provenance.command = value.get<std::string>();
  } else if (key == "seed" && value.is_number_unsigned()) {
    provenance.seed = value.get<std::uint64_t>();
  } else if (key == "options" && value.is_object()) {
    provenance.options = read_named_values(value);
  } else if (key == "inputs" && value.is_array() &&
             std::all_of(value.begin(), value.end(), is_input_hash)) {
    for (const Json& input : value) {
      provenance.inputs.push_back(
          {input["file"].get<std::string>(), input["sha256"].get<std::string>()});
    }
  } else {
    return false;
  }
  return true;
}

void append_finite(std::string& text, double value) {
  if (!std::isfinite(value)) {
    throw InputError("number", value, "must be finite to be written as JSON");
  }
  append_number(text, value);
}

class ValueWriter {
 public:
  explicit ValueWriter(std::string& text) : text_(text) {}

  void operator()(double value) const { append_finite(text_, value); }
  void operator()(const std::string& value) const { append_string(text_, value); }
  void operator()(const std::vector<double>& values) const { append_numbers(text_, values); }
  void operator()(const JsonText& value) const {
    if (!Json::accept(value.text)) {
      throw InputError("JSON text", in_quotes(value.text), "must be valid JSON");
    }
    text_ += value.text;
  }

 private:
  std::string& text_;
};

std::string hashes_json(const std::vector<InputHash>& inputs) {
  std::string text = "[";
  for (const InputHash& input : inputs) {
    text += text.size() > 1 ? ", {\"file\": " : "{\"file\": ";
    append_string(text, input.file);
    text += ", \"sha256\": ";
    append_string(text, input.sha256);
    text += '}';
  }
  return text + "]";
}

}  // namespace

NamedValues read_named_values(const Json& object) {
  NamedValues record;
  for (const auto& [key, value] : object.items()) record.emplace_back(key, read_value(value));
  return record;
}

Provenance read_provenance(const Json& object) {
  Provenance provenance;
  provenance.program.clear();
  for (const auto& [key, value] : object.items()) {
    if (!read_known(key, value, provenance)) provenance.other.emplace_back(key, read_value(value));
  }
  return provenance;
}

void append_string(std::string& text, std::string_view value) {
  // Invalid UTF-8, possible in file names, becomes U+FFFD.
  text += Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void append_numbers(std::string& text, const std::vector<double>& values) {
  text += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += ", ";
    append_finite(text, values[i]);
  }
  text += ']';
}

void append_named_values(std::string& text, const NamedValues& record, std::string_view indent) {
  std::set<std::string_view> names;
  text += '{';
  for (const auto& [name, value] : record) {
    if (!names.insert(name).second) {
      throw InputError("record", in_quotes(name), "must be the name of one entry only");
    }
    text += fmt::format("{}\n{}  ", names.size() > 1 ? "," : "", indent);
    append_string(text, name);
    text += ": ";
    std::visit(ValueWriter(text), value);
  }
  text += names.empty() ? "}" : fmt::format("\n{}}}", indent);
}

NamedValues provenance_values(const Provenance& provenance) {
  NamedValues record;
  const auto add_text = [&](const char* name, const std::string& value) {
    if (!value.empty()) record.emplace_back(name, value);
  };
  add_text("program", provenance.program);
  add_text("version", provenance.version);
  add_text("command", provenance.command);
  if (!provenance.inputs.empty()) {
    record.emplace_back("inputs", JsonText{hashes_json(provenance.inputs)});
  }
  if (!provenance.options.empty()) {
    std::string options;
    append_named_values(options, provenance.options, "    ");
    record.emplace_back("options", JsonText{options});
  }
  if (provenance.seed) record.emplace_back("seed", JsonText{fmt::format("{}", *provenance.seed)});
  record.insert(record.end(), provenance.other.begin(), provenance.other.end());
  return record;
}

}  // namespace microslip
