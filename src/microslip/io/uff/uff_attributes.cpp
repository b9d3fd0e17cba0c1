// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_attributes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <variant>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/uff/uff_units.hpp"

namespace microslip {
namespace {

constexpr std::array<std::string_view, 29> kFunctionTypes{"general or unknown",
                                                          "time response",
                                                          "auto spectrum",
                                                          "cross spectrum",
                                                          "frequency response",
                                                          "transmissibility",
                                                          "coherence",
                                                          "auto correlation",
                                                          "cross correlation",
                                                          "power spectral density",
                                                          "energy spectral density",
                                                          "probability density",
                                                          "spectrum",
                                                          "cumulative frequency distribution",
                                                          "peaks and valleys",
                                                          "stress over cycles",
                                                          "strain over cycles",
                                                          "orbit",
                                                          "mode indicator",
                                                          "force pattern",
                                                          "partial power",
                                                          "partial coherence",
                                                          "eigenvalue",
                                                          "eigenvector",
                                                          "shock response spectrum",
                                                          "impulse response filter",
                                                          "multiple coherence",
                                                          "order function",
                                                          "phase compensation"};

constexpr std::array<std::string_view, 13> kDirections{
    "-RZ", "-RY", "-RX", "-Z", "-Y", "-X", "none", "+X", "+Y", "+Z", "+RX", "+RY", "+RZ"};
constexpr std::int64_t kDirectionZero = 6;

/// A number as a word of the list, or in digits where it has none.
template <std::size_t kSize>
std::string word_of(const std::array<std::string_view, kSize>& words, std::int64_t number,
                    std::int64_t zero = 0) {
  const std::int64_t i = number + zero;
  const bool known = i >= 0 && i < static_cast<std::int64_t>(kSize);
  return known ? std::string(words[static_cast<std::size_t>(i)]) : fmt::format("{}", number);
}

template <class Number>
bool read_whole(std::string_view text, Number& number) {
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return false;
  number = value;
  return true;
}

template <std::size_t kSize>
void read_word(const std::array<std::string_view, kSize>& words, std::string_view text,
               std::int64_t& number, std::int64_t zero = 0) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    (void)read_whole(text, number);
  } else {
    number = found - words.begin() - zero;
  }
}

using Exponents = std::array<std::int64_t, 3>;

/// One field of the header, under the name of its attribute. Integers of two kinds have words.
struct Field {
  enum Words { kNone, kFunction, kDirection };
  std::string name;
  std::variant<std::string*, std::int64_t*, double*, Exponents*> value;
  std::size_t width;  ///< of an integer, in the file
  Words words = kNone;
};

void add_point(std::vector<Field>& fields, const std::string& name, UffPoint& point) {
  fields.push_back({name + " entity", &point.entity, 10});
  fields.push_back({name + " node", &point.node, 10});
  fields.push_back({name + " direction", &point.direction, 4, Field::kDirection});
}

void add_quantity(std::vector<Field>& fields, const std::string& name, UffQuantity& quantity) {
  fields.push_back({name + " type", &quantity.type, 10});
  fields.push_back({name + " exponents", &quantity.exponents, 5});
  fields.push_back({name + " label", &quantity.label, 20});
  fields.push_back({name + " unit", &quantity.unit, 20});
}

std::vector<Field> fields_of(Uff58Header& header) {
  std::vector<Field> fields;
  for (std::size_t i = 0; i < header.id_lines.size(); ++i) {
    fields.push_back({fmt::format("id line {}", i + 1), &header.id_lines[i], 80});
  }
  fields.push_back({"function type", &header.function_type, 5, Field::kFunction});
  fields.push_back({"function number", &header.function_id, 10});
  fields.push_back({"version", &header.version, 5});
  fields.push_back({"load case", &header.load_case, 10});
  add_point(fields, "response", header.response);
  add_point(fields, "reference", header.reference);
  fields.push_back({"z value", &header.z, 13});
  add_quantity(fields, "abscissa", header.abscissa);
  add_quantity(fields, "ordinate", header.ordinate);
  add_quantity(fields, "denominator", header.denominator);
  add_quantity(fields, "z axis", header.z_axis);
  return fields;
}

std::string text_of(const Field& field) {
  if (const auto* text = std::get_if<std::string*>(&field.value)) return **text;
  if (const auto* number = std::get_if<double*>(&field.value)) {
    std::string text;
    append_number(text, **number);
    return text;
  }
  if (const auto* exponents = std::get_if<Exponents*>(&field.value)) {
    const auto& [length, force, temperature] = **exponents;
    return fmt::format("{} {} {}", length, force, temperature);
  }
  const std::int64_t number = *std::get<std::int64_t*>(field.value);
  if (field.words == Field::kFunction) return word_of(kFunctionTypes, number);
  if (field.words == Field::kDirection) return word_of(kDirections, number, kDirectionZero);
  return fmt::format("{}", number);
}

void set_exponents(Exponents& target, std::string_view text, std::size_t width) {
  Exponents exponents{};
  for (std::int64_t& exponent : exponents) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (!read_whole(word, exponent) || word.size() > width) return;
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  target = exponents;
}

void set_text(const Field& field, std::string_view text) {
  if (auto* const* target = std::get_if<std::string*>(&field.value)) {
    **target = text;
  } else if (auto* const* number = std::get_if<double*>(&field.value)) {
    double value = 0.0;
    if (read_whole(text, value) && std::isfinite(value)) **number = value;
  } else if (auto* const* exponents = std::get_if<Exponents*>(&field.value)) {
    set_exponents(**exponents, text, field.width);
  } else {
    std::int64_t value = *std::get<std::int64_t*>(field.value);
    if (field.words == Field::kFunction) read_word(kFunctionTypes, text, value);
    if (field.words == Field::kDirection) read_word(kDirections, text, value, kDirectionZero);
    if (field.words == Field::kNone) (void)read_whole(text, value);
    if (fmt::format("{}", value).size() <= field.width)
      *std::get<std::int64_t*>(field.value) = value;
  }
}

std::string point_text(const UffPoint& point) {
  std::string text =
      fmt::format("{} {}", point.entity.empty() ? "point" : point.entity, point.node);
  if (point.direction != 0) text += ' ' + word_of(kDirections, point.direction, kDirectionZero);
  return text;
}

/// Cross spectrum, frequency response, transmissibility, coherence, cross correlation.
bool is_of_two_points(std::int64_t function_type) {
  return (function_type >= 3 && function_type <= 6) || function_type == 8;
}

}  // namespace

Uff58Header usual_uff58_header(const Dimension& axis, const std::optional<Dimension>& values,
                               bool is_complex) {
  constexpr std::int64_t kTimeResponse = 1;
  constexpr std::int64_t kSpectrum = 12;
  Uff58Header header;
  header.is_complex = is_complex;
  if (axis == kTime) header.function_type = kTimeResponse;
  if (axis == kFrequency) header.function_type = kSpectrum;
  header.abscissa = uff_quantity(axis);
  if (axis == kTime) header.abscissa.label = "Time";
  if (axis == kFrequency) header.abscissa.label = "Frequency";
  header.ordinate = uff_quantity(values);
  return header;
}

Attributes uff58_attributes(const Uff58Header& header, const Uff58Header& usual) {
  Uff58Header found = header;
  Uff58Header expected = usual;
  const std::vector<Field> fields = fields_of(found);
  const std::vector<Field> usual_fields = fields_of(expected);
  Attributes attributes;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    std::string text = text_of(fields[i]);
    if (text != text_of(usual_fields[i])) attributes.emplace_back(fields[i].name, std::move(text));
  }
  return attributes;
}

void apply_uff58_attributes(const Attributes& attributes, Uff58Header& header) {
  const std::vector<Field> fields = fields_of(header);
  for (const auto& [name, text] : attributes) {
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
    if (field != fields.end()) set_text(*field, text);
  }
}

std::string uff_point_name(const Uff58Header& header) {
  std::string name = point_text(header.response);
  if (is_of_two_points(header.function_type) && header.reference.node != 0) {
    name += " / " + point_text(header.reference);
  }
  return name;
}

std::vector<std::string> uff_channel_names(std::span<const Uff58Header> headers) {
  std::multiset<std::string_view> first_lines;
  for (const Uff58Header& header : headers) first_lines.insert(header.id_lines[0]);
  std::set<std::string> taken;
  std::map<std::string, int> last;  // of each name that is not unique
  std::vector<std::string> names(headers.size());
  for (std::size_t i = 0; i < headers.size(); ++i) {
    const std::string& line = headers[i].id_lines[0];
    if (line.empty() || first_lines.count(line) > 1) continue;
    names[i] = line;
    taken.insert(line);
  }
  for (std::size_t i = 0; i < headers.size(); ++i) {
    if (!names[i].empty()) continue;
    const std::string name = uff_point_name(headers[i]);
    names[i] = name;
    int& n = last.try_emplace(name, 1).first->second;
    while (!taken.insert(names[i]).second) names[i] = fmt::format("{} ({})", name, ++n);
  }
  return names;
}

}  // namespace microslip
