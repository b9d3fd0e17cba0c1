// SPDX-License-Identifier: MIT
#include "microslip/io/config/named_value_access.hpp"

#include <variant>

#include "microslip/io/config/json_texts.hpp"

namespace microslip {
namespace {

template <class T>
std::optional<T> entry(const NamedValues& record, std::string_view name) {
  for (const auto& [key, value] : record) {
    if (key == name && std::holds_alternative<T>(value)) return std::get<T>(value);
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> number_in(const NamedValues& record, std::string_view name) {
  return entry<double>(record, name);
}

std::optional<std::string> text_in(const NamedValues& record, std::string_view name) {
  return entry<std::string>(record, name);
}

std::vector<double> numbers_in(const NamedValues& record, std::string_view name) {
  return entry<std::vector<double>>(record, name).value_or(std::vector<double>());
}

std::vector<std::string> texts_in(const NamedValues& record, std::string_view name) {
  const std::optional<JsonText> list = entry<JsonText>(record, name);
  return list ? texts_of(*list) : std::vector<std::string>();
}

}  // namespace microslip
