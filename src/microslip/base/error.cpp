// SPDX-License-Identifier: MIT
#include "microslip/base/error.hpp"

#include <fmt/format.h>

namespace microslip {
namespace {

/// Names in files may hold anything; a message is one line.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return text;
}

std::string sentence(std::string_view text) {
  return text.empty() ? std::string{} : fmt::format(". {}", text);
}

}  // namespace

std::string place_text(const TextPlace& place) {
  std::string text = place.file.empty() ? "input" : place.file;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  return text;
}

InputError::InputError(std::string_view what, double value, std::string_view rule,
                       std::string_view remedy)
    : InputError(what, fmt::format("{}", value), rule, remedy) {}

InputError::InputError(std::string_view what, std::string_view value, std::string_view rule,
                       std::string_view remedy)
    : Error(one_line(fmt::format("{} = {}; {}{}", what, value, rule, sentence(remedy)))),
      name_(what) {}

InputError::InputError(std::string_view what, InputState state, std::string_view rule,
                       std::string_view remedy)
    : Error(one_line(fmt::format("{} is {}; {}{}", what, state.text, rule, sentence(remedy)))),
      name_(what) {}

InputError InputError::renamed(std::string_view name) const {
  InputError copy = *this;
  static_cast<Error&>(copy) = Error(one_line(fmt::format("{}{}", name, what() + name_.size())));
  copy.name_ = name;
  return copy;
}

FormatError::FormatError(const TextPlace& place, std::string_view expected, std::string_view found,
                         std::string_view remedy)
    : Error(one_line(fmt::format("{}: expected {}, found {}{}", place_text(place), expected, found,
                                 sentence(remedy)))),
      place_(place) {}

FileError::FileError(std::string_view path, std::string_view reason, std::string_view remedy)
    : Error(one_line(fmt::format("{}: {}{}", path, reason, sentence(remedy)))) {}

Cancelled::Cancelled() : Error("stopped on request") {}

}  // namespace microslip
