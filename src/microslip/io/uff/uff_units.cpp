// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_units.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

enum SpecificType : std::int64_t {
  kGeneral = 1,
  kTypeTime = 17,
  kTypeFrequency = 18,
};

/// Exponents of length and force of translations and of rotations, and the power of the second that
/// no factor scales. Rotations count in radians where that is their nature.
struct TypeRule {
  std::int64_t type;
  int length, force;
  int rotation_length, rotation_force;
  int time;
  int rotation_angle;
};

constexpr std::array kTypeRules{
    TypeRule{2, -2, 1, -1, 1, 0, 0},   // stress
    TypeRule{3, 0, 0, 0, 0, 0, 0},     // strain
    TypeRule{8, 1, 0, 0, 0, 0, 1},     // displacement
    TypeRule{9, 0, 1, 1, 1, 0, 0},     // reaction force
    TypeRule{11, 1, 0, 0, 0, -1, 1},   // velocity
    TypeRule{12, 1, 0, 0, 0, -2, 1},   // acceleration
    TypeRule{13, 0, 1, 1, 1, 0, 0},    // excitation force
    TypeRule{15, -2, 1, -1, 1, 0, 0},  // pressure
    TypeRule{16, -1, 1, 1, 1, 2, 0},   // mass
    TypeRule{21, -2, 1, -2, 1, 0, 0},  // sound pressure
};

/// The types that stand for a dimension when it is written.
struct TypeOfDimension {
  Dimension dimension;
  std::int64_t type;
};
constexpr std::array kTypesOfDimensions{
    TypeOfDimension{kLength, 8},        TypeOfDimension{kVelocity, 11},
    TypeOfDimension{kAcceleration, 12}, TypeOfDimension{kForce, 13},
    TypeOfDimension{kPressure, 15},     TypeOfDimension{kMass, 16},
    TypeOfDimension{kTime, kTypeTime},  TypeOfDimension{kFrequency, kTypeFrequency},
};

Unit quotient(const Unit& a, const Unit& b) {
  return {a.numerator * b.denominator, a.denominator * b.numerator, a.dimension / b.dimension};
}

/// The label without its parentheses: what stands in one behind a slash has its operators turned,
/// since a quotient is read from the left. Empty where they are nested or raised to a power.
std::string without_parentheses(std::string_view label) {
  std::string flat;
  bool inside = false;
  bool turned = false;
  for (std::size_t i = 0; i < label.size(); ++i) {
    const char c = label[i];
    if (c == '(') {
      if (inside) return {};
      inside = true;
      turned = trimmed(flat).ends_with('/');
    } else if (c == ')') {
      const std::size_t next = std::min(label.find_first_not_of(' ', i + 1), label.size());
      constexpr std::string_view kOperators = "*/(";
      if (!inside ||
          (next < label.size() && kOperators.find(label[next]) == std::string_view::npos)) {
        return {};
      }
      inside = turned = false;
    } else if (turned && (c == ' ' || static_cast<unsigned char>(c) == 0xC2)) {
      return {};  // a product without an asterisk; ² begins with the byte of ·
    } else if (turned && (c == '*' || c == '/')) {
      flat += c == '*' ? '/' : '*';
    } else {
      flat += c;
    }
  }
  return inside ? std::string() : flat;
}

/// "(1/N)*(m/s²)" occurs where find_unit() has "1/N*m/s²".
std::optional<Unit> find_label_unit(std::string_view label) {
  if (label.find('(') == std::string_view::npos) return find_unit(label);
  return find_unit(without_parentheses(label));
}

Unit system_unit(const Uff164& units, int length, int force, int time, int angle) {
  const double factor = std::pow(units.length, length) * std::pow(units.force, force);
  return {1.0, factor,
          kLength.power(length) * kForce.power(force) * kTime.power(time) * kAngle.power(angle)};
}

/// Of what dataset 164 gives a unit by the data type alone.
std::optional<Unit> unit_by_type(const UffQuantity& quantity, bool rotation, const Uff164& units) {
  if (quantity.type == kGeneral) {
    const auto [length, force, temperature] = quantity.exponents;
    const auto usual = [](std::int64_t n) { return std::abs(n) <= 9; };
    if (temperature != 0 || (length == 0 && force == 0) || !usual(length) || !usual(force)) {
      return std::nullopt;
    }
    return system_unit(units, static_cast<int>(length), static_cast<int>(force), 0, 0);
  }
  const auto rule = std::find_if(kTypeRules.begin(), kTypeRules.end(),
                                 [&](const TypeRule& r) { return r.type == quantity.type; });
  if (rule == kTypeRules.end()) return std::nullopt;
  if (rotation) {
    const int time = rule->type == 16 ? 2 : rule->time;
    return system_unit(units, rule->rotation_length, rule->rotation_force, time,
                       rule->rotation_angle);
  }
  return system_unit(units, rule->length, rule->force, rule->time, 0);
}

bool is_rotation(const UffPoint& point) {
  return std::abs(point.direction) >= 4 && std::abs(point.direction) <= 6;
}

/// Squares of the quantity, per Hz or not: what the types alone do not tell.
bool is_power(std::int64_t function_type) {
  return function_type == 2 || function_type == 3 || (function_type >= 7 && function_type <= 10);
}

std::optional<Unit> quantity_unit(const UffQuantity& quantity, const UffPoint& point,
                                  const Uff58Header& header, const std::optional<Uff164>& units) {
  if (!quantity.unit.empty()) return find_label_unit(quantity.unit);
  if (!units || is_power(header.function_type)) return std::nullopt;
  return unit_by_type(quantity, is_rotation(point), *units);
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Labels of time and frequency beside those of find_unit().
std::optional<Unit> find_axis_unit(const UffQuantity& quantity) {
  if (const auto unit = find_label_unit(quantity.unit)) return unit;
  const std::string label = lower_case(quantity.unit);
  if (quantity.type == kTypeTime && (label == "s" || label == "sec" || label == "secs" ||
                                     label == "second" || label == "seconds")) {
    return Unit{.dimension = kTime};
  }
  if (quantity.type == kTypeFrequency && (label == "hz" || label == "hertz")) {
    return Unit{.dimension = kFrequency};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Unit> uff_abscissa_unit(const Uff58Header& header,
                                      const std::optional<Uff164>& units) {
  constexpr std::int64_t kTimeResponse = 1;
  const UffQuantity& quantity = header.abscissa;
  if (!quantity.unit.empty()) return find_axis_unit(quantity);
  const bool over_time = quantity.type == 0 && header.function_type == kTimeResponse;
  if (quantity.type == kTypeTime || over_time) return Unit{.dimension = kTime};
  if (quantity.type == kTypeFrequency) return Unit{.dimension = kFrequency};
  return units ? unit_by_type(quantity, is_rotation(header.response), *units) : std::nullopt;
}

std::optional<Unit> uff_denominator_unit(const Uff58Header& header,
                                         const std::optional<Uff164>& units) {
  const UffQuantity& quantity = header.denominator;
  if (quantity.type == 0 && quantity.unit.empty()) return Unit{};
  return quantity_unit(quantity, header.reference, header, units);
}

std::optional<Unit> uff_ordinate_unit(const Uff58Header& header,
                                      const std::optional<Uff164>& units) {
  const auto above = quantity_unit(header.ordinate, header.response, header, units);
  const auto below = uff_denominator_unit(header, units);
  if (!above || !below) return std::nullopt;
  return quotient(*above, *below);
}

std::optional<std::string> find_uff_unit_label(const Dimension& dimension) {
  constexpr std::size_t kWidth = 20;
  std::string label = si_unit(dimension);
  if (uff_width(label) > kWidth) std::erase(label, '^');
  const std::optional<Unit> unit = find_unit(label);
  const bool reads_back = uff_width(label) <= kWidth && unit && unit->dimension == dimension;
  return reads_back ? std::optional(label) : std::nullopt;
}

UffQuantity uff_quantity(const std::optional<Dimension>& dimension) {
  UffQuantity quantity;
  if (!dimension) return quantity;
  const std::optional<std::string> label = find_uff_unit_label(*dimension);
  if (!label) {
    throw InputError("unit", si_unit(*dimension),
                     "must fit into the 20 characters of a label of a universal file",
                     "Write another format.");
  }
  quantity.unit = *label;
  const auto known =
      std::find_if(kTypesOfDimensions.begin(), kTypesOfDimensions.end(),
                   [&](const TypeOfDimension& t) { return t.dimension == *dimension; });
  quantity.type = known != kTypesOfDimensions.end() ? known->type : kGeneral;
  if (quantity.type == kGeneral) {  // mass is force over length, apart from time
    quantity.exponents = {dimension->length - dimension->mass, dimension->mass, 0};
  }
  return quantity;
}

}  // namespace microslip
