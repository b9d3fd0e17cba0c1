// SPDX-License-Identifier: MIT
#include "microslip/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// value in SI = value·factor·10^exponent; the power of ten apart, to be applied exactly in the
/// end.
struct Symbol {
  std::string_view name;
  double factor;
  int exponent;
  Dimension dimension;
  std::string_view prefixes;
};

constexpr double kPound = 0.45359237;            // kg, exact by definition, as the next one
constexpr double kPoundForce = 4.4482216152605;  // N

constexpr std::array kSymbols{
    Symbol{"1", 1.0, 0, kDimensionless, ""},
    Symbol{"%", 1.0, -2, kDimensionless, ""},
    Symbol{"m", 1.0, 0, kLength, "numck"},
    Symbol{"in", 254.0, -4, kLength, "u"},
    Symbol{"ft", 3048.0, -4, kLength, ""},
    Symbol{"mil", 254.0, -7, kLength, ""},
    Symbol{"kg", 1.0, 0, kMass, ""},
    Symbol{"t", 1.0, 3, kMass, ""},
    Symbol{"lb", kPound, 0, kMass, "k"},
    Symbol{"oz", kPound / 16.0, 0, kMass, ""},
    Symbol{"slug", kPoundForce / 3048.0, 4, kMass, ""},
    Symbol{"s", 1.0, 0, kTime, "num"},
    Symbol{"min", 60.0, 0, kTime, ""},
    Symbol{"h", 3600.0, 0, kTime, ""},
    Symbol{"Hz", 1.0, 0, kFrequency, "mkMG"},
    Symbol{"rpm", 1.0 / 60.0, 0, kFrequency, ""},
    Symbol{"rad", 1.0, 0, kAngle, "um"},
    Symbol{"deg", std::numbers::pi / 180.0, 0, kAngle, ""},
    Symbol{"ips", 254.0, -4, kVelocity, ""},
    Symbol{"fps", 3048.0, -4, kVelocity, ""},
    Symbol{"N", 1.0, 0, kForce, "numckMG"},
    Symbol{"dyn", 1.0, -5, kForce, ""},
    Symbol{"daN", 1.0, 1, kForce, ""},
    Symbol{"kgf", kStandardGravity, 0, kForce, ""},
    Symbol{"kp", kStandardGravity, 0, kForce, ""},
    Symbol{"lbf", kPoundForce, 0, kForce, "k"},
    Symbol{"kip", kPoundForce, 3, kForce, ""},
    Symbol{"ozf", kPoundForce / 16.0, 0, kForce, ""},
    Symbol{"tonf", 2.0 * kPoundForce, 3, kForce, ""},  // NIST SP 811: of 2000 lb
    Symbol{"tf", kStandardGravity, 3, kForce, ""},
    Symbol{"J", 1.0, 0, kEnergy, "numkM"},
    Symbol{"Pa", 1.0, 0, kPressure, "mkMG"},
    Symbol{"bar", 1.0, 5, kPressure, "m"},
    Symbol{"hPa", 1.0, 2, kPressure, ""},
    Symbol{"psf", kPoundForce / (3048.0 * 3048.0), 8, kPressure, ""},
    Symbol{"psi", kPoundForce / (254.0 * 254.0), 8, kPressure, ""},
    Symbol{"ksi", kPoundForce / (254.0 * 254.0), 11, kPressure, ""},
    Symbol{"strain", 1.0, 0, kDimensionless, "um"},
    Symbol{"g", kStandardGravity, 0, kAcceleration, "um"},
    Symbol{"Gal", 1.0, -2, kAcceleration, "um"},
};

/// Other spellings of a unit, as testing machines, loggers and spreadsheets write them. A load in
/// lbs is a force.
struct Spelling {
  std::string_view text;  ///< in small letters: capitals do not count; else as it stands
  std::string_view symbol;
};

constexpr std::array kSpellings{
    Spelling{"sec", "s"},          Spelling{"secs", "s"},
    Spelling{"second", "s"},       Spelling{"seconds", "s"},
    Spelling{"msec", "ms"},        Spelling{"msecs", "ms"},
    Spelling{"millisecond", "ms"}, Spelling{"milliseconds", "ms"},
    Spelling{"usec", "us"},        Spelling{"usecs", "us"},
    Spelling{"microsecond", "us"}, Spelling{"microseconds", "us"},
    Spelling{"nanoseconds", "ns"}, Spelling{"minute", "min"},
    Spelling{"minutes", "min"},    Spelling{"hour", "h"},
    Spelling{"hours", "h"},        Spelling{"mins", "min"},
    Spelling{"hr", "h"},           Spelling{"hrs", "h"},
    Spelling{"inch", "in"},        Spelling{"inches", "in"},
    Spelling{"ins", "in"},         Spelling{"ft", "ft"},
    Spelling{"foot", "ft"},        Spelling{"feet", "ft"},
    Spelling{"mil", "mil"},        Spelling{"mils", "mil"},
    Spelling{"thou", "mil"},       Spelling{"micron", "um"},
    Spelling{"microns", "um"},     Spelling{"metre", "m"},
    Spelling{"metres", "m"},       Spelling{"meter", "m"},
    Spelling{"meters", "m"},       Spelling{"millimetre", "mm"},
    Spelling{"millimetres", "mm"}, Spelling{"millimeter", "mm"},
    Spelling{"millimeters", "mm"}, Spelling{"micrometer", "um"},
    Spelling{"micrometers", "um"}, Spelling{"micrometre", "um"},
    Spelling{"micrometres", "um"}, Spelling{"newton", "N"},
    Spelling{"newtons", "N"},      Spelling{"kilonewton", "kN"},
    Spelling{"kilonewtons", "kN"}, Spelling{"KN", "kN"},
    Spelling{"lb", "lb"},          Spelling{"lbm", "lb"},
    Spelling{"lbf", "lbf"},        Spelling{"klbf", "klbf"},
    Spelling{"lbs", "lbf"},        Spelling{"lbsf", "lbf"},
    Spelling{"kip", "kip"},        Spelling{"kips", "kip"},
    Spelling{"psi", "psi"},        Spelling{"ksi", "ksi"},
    Spelling{"KPa", "kPa"},        Spelling{"KPA", "kPa"},
    Spelling{"bar", "bar"},        Spelling{"kgf", "kgf"},
    Spelling{"kg", "kg"},          Spelling{"kilogram", "kg"},
    Spelling{"kilograms", "kg"},   Spelling{"kgs", "kg"},
    Spelling{"g's", "g"},          Spelling{"gn", "g"},
    Spelling{"g_n", "g"},          Spelling{"hz", "Hz"},
    Spelling{"KHz", "kHz"},        Spelling{"KHZ", "kHz"},
    Spelling{"hertz", "Hz"},       Spelling{"cps", "Hz"},
    Spelling{"rpm", "rpm"},        Spelling{"cpm", "rpm"},
    Spelling{"deg", "deg"},        Spelling{"degree", "deg"},
    Spelling{"degrees", "deg"},    Spelling{"radian", "rad"},
    Spelling{"radians", "rad"},    Spelling{"microstrain", "ustrain"},
    Spelling{"percent", "%"},      Spelling{"klbm", "klb"},
    Spelling{"pound", "lbf"},      Spelling{"pounds", "lbf"},
    Spelling{"mG", "mg"},          Spelling{"Mg", "t"},
    Spelling{"tonne", "t"},        Spelling{"tonnes", "t"},
    Spelling{"slugs", "slug"},     Spelling{"rps", "Hz"},
    Spelling{"ue", "ustrain"},     Spelling{"psf", "psf"},
    Spelling{"ips", "ips"},        Spelling{"tonf", "tonf"},
};

/// Units of quantities that are not mechanical.
constexpr std::array<std::string_view, 36> kOtherUnits{
    "degC", "degF",   "C",     "F",      "K",     "celsius", "fahrenheit", "kelvin", "V",
    "mV",   "uV",     "kV",    "volt",   "volts", "Volt",    "Volts",      "Vdc",    "VDC",
    "Vrms", "A",      "mA",    "uA",     "Ohm",   "ohm",     "W",          "kW",     "dB",
    "pC",   "counts", "count", "cycles", "cycle", "bit",     "bits",       "%RH",    "lx"};

/// Dimensions with a name, with the units that messages propose; the first one is SI.
struct Quantity {
  Dimension dimension;
  std::string_view name;
  std::string_view units;
};

constexpr std::array kQuantities{
    Quantity{kDimensionless, "ratio", "1, %"},
    Quantity{kLength, "length", "m, mm, um (µm), nm, cm, in, ft, mil"},
    Quantity{kMass, "mass", "kg, t, lb"},
    Quantity{kTime, "time", "s, ms, us"},
    Quantity{kAngle, "angle", "rad, deg"},
    Quantity{kFrequency, "frequency", "Hz, kHz"},
    Quantity{kAngularFrequency, "angular frequency", "rad/s"},
    Quantity{kVelocity, "velocity", "m/s, mm/s, um/s, in/s"},
    Quantity{kAcceleration, "acceleration", "m/s^2, mm/s^2, g, mg, in/s^2, ft/s^2"},
    Quantity{kForce, "force", "N, mN, kN, lbf, kip"},
    Quantity{kEnergy, "energy", "J, mJ, uJ (µJ), nJ, N mm, in lbf"},
    Quantity{kStiffness, "stiffness", "N/m, kN/m, MN/m, N/mm, N/um, lbf/in"},
    Quantity{kPerForce, "inverse force", "1/N, 1/kN, 1/lbf"},
    Quantity{kPressure, "pressure", "Pa, kPa, MPa, GPa, psi"},
    Quantity{kMassDensity, "mass density", "kg/m^3"},
    Quantity{kForce.power(2) / kFrequency, "power density of a force", "N^2/Hz, lbf^2/Hz"},
    Quantity{kAcceleration.power(2) / kFrequency, "power density of an acceleration",
             "(m/s^2)^2/Hz, g^2/Hz"},
};

constexpr std::string_view kDigits = "0123456789";
constexpr int kLargestPower = 9;

/// One spelling for each symbol: both micro signs become u, raised digits become digits.
std::string plain_ascii(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 18> kCharacters{{
      {"µ", "u"},  // U+00B5 micro sign
      {"μ", "u"},  // U+03BC Greek mu
      {"°", "deg"},
      {"·", "*"},
      {"⋅", "*"},
      {"⁻", "-"},
      {"¹", "1"},
      {"²", "2"},
      {"³", "3"},
      {"⁴", "4"},
      {"−", "-"},
      {"\t", " "},
      {"**", "^"},
      {"ε", "strain"},
      {"Ω", "Ohm"},
      {"Ω", "Ohm"},  // U+2126 ohm sign
      {"’", "'"},
      {"″", "in"},
  }};
  std::string result;
  while (!text.empty()) {
    const auto* found = std::find_if(kCharacters.begin(), kCharacters.end(),
                                     [&](const auto& s) { return text.starts_with(s.first); });
    const bool known = found != kCharacters.end();
    result += known ? found->second : text.substr(0, 1);
    text.remove_prefix(known ? found->first.size() : 1);
  }
  const std::size_t first = result.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return result.substr(first, result.find_last_not_of(' ') - first + 1);
}

int prefix_exponent(char prefix) {
  switch (prefix) {
    case 'n':
      return -9;
    case 'u':
      return -6;
    case 'm':
      return -3;
    case 'c':
      return -2;
    case 'k':
      return 3;
    case 'M':
      return 6;
    default:
      return 9;  // G
  }
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return small;
}

std::optional<Symbol> find_symbol(std::string_view name) {
  constexpr std::size_t kLongest = 16;
  if (name.size() > kLongest) return std::nullopt;
  for (const Symbol& symbol : kSymbols) {
    if (symbol.name == name) return symbol;
  }
  if (name == "G") return find_symbol("g");  // no prefix without a unit
  if (name.size() < 2) return std::nullopt;
  for (Symbol symbol : kSymbols) {
    if (symbol.name == name.substr(1) && symbol.prefixes.find(name[0]) != std::string_view::npos) {
      symbol.exponent += prefix_exponent(name[0]);
      return symbol;
    }
  }
  if (name.ends_with('.')) return find_symbol(name.substr(0, name.size() - 1));
  const std::string small = in_small_letters(name);
  const auto* spelling = std::ranges::find_if(
      kSpellings, [&](const Spelling& s) { return s.text == name || s.text == small; });
  return spelling == kSpellings.end() ? std::nullopt : find_symbol(spelling->symbol);
}

/// Two units without a sign between them.
struct Joined {
  Symbol first;
  Symbol second;
};

/// Nm and kgm are products of two units. So is ms before a negative power: m s^-2 is meant, not a
/// millisecond to the -2.
std::optional<Joined> find_joined(std::string_view name, bool negative) {
  constexpr std::size_t kLongest = 5;  // daNmm
  for (std::size_t cut = 1; cut < name.size() && name.size() <= kLongest; ++cut) {
    const std::string_view second = name.substr(cut);
    const std::optional<Symbol> first = find_symbol(name.substr(0, cut));
    if (!first) continue;
    const bool length = second == "m" || second == "mm" || second == "cm" || second == "um";
    const bool of_mass = name.substr(0, cut) == "kg";  // lbm and tm are no products
    const bool of_force = length && (first->dimension == kForce || of_mass);
    const bool of_motion = negative && second == "s" && first->dimension == kLength;
    if (of_force || of_motion) return Joined{*first, *find_symbol(second)};
  }
  return std::nullopt;
}

/// unit = factor (('/' | '*' | '-' | ' ') factor)*;  factor = '1' | symbol [['^'] ['-'] digit].
/// A '-' before a letter joins two units, as in in-lbf. The power behind two units without a sign
/// between them is that of the second.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : text_(text) {}

  std::optional<Unit> parse() {
    if (!read_factor(1)) return std::nullopt;
    while (!text_.empty()) {
      const int sign = read_operator();
      if (!read_factor(sign)) return std::nullopt;
    }
    if (has_pound_) read_pound_as_force();
    if (std::abs(exponent_) > 300) return std::nullopt;
    (exponent_ < 0 ? unit_.denominator : unit_.numerator) *= std::pow(10.0, std::abs(exponent_));
    return unit_;
  }

 private:
  void skip_blanks() { text_.remove_prefix(std::min(text_.find_first_not_of(' '), text_.size())); }

  int read_operator() {
    skip_blanks();
    const char first = text_.empty() ? ' ' : text_.front();
    if (first == '/' || first == '*' || first == '-') text_.remove_prefix(1);
    skip_blanks();
    return first == '/' ? -1 : 1;
  }

  bool read_factor(int sign) {
    if (text_.starts_with('(')) return read_brackets(sign);
    const std::string_view name = read_name();
    const std::optional<int> power = name == "1" ? 1 : read_power();
    if (!power) return false;
    const std::optional<Symbol> symbol = find_symbol(name);
    const std::optional<Joined> joined =
        !symbol || *power < 0 ? find_joined(name, *power < 0) : std::nullopt;
    if (joined) {
      multiply(joined->first, sign);
      multiply(joined->second, sign * *power);
      return true;
    }
    if (!symbol) return false;
    const std::string small = in_small_letters(name);
    if (small == "lb" || small == "oz" || small == "lb." || small == "oz.") has_pound_ = true;
    multiply(*symbol, sign * *power);
    return true;
  }

  /// A pound over an inch is the force of a spring, a foot-pound one of a torque.
  void read_pound_as_force() {
    if (unit_.dimension != kMass * kLength && unit_.dimension != kMass / kLength) return;
    unit_.numerator *= kStandardGravity;
    unit_.dimension = unit_.dimension * kAcceleration;
  }

  void multiply(const Symbol& symbol, int power) {
    (power > 0 ? unit_.numerator : unit_.denominator) *= std::pow(symbol.factor, std::abs(power));
    exponent_ += power * symbol.exponent;
    unit_.dimension = unit_.dimension * symbol.dimension.power(power);
  }

  /// A unit in brackets, with a power.
  bool read_brackets(int sign) {
    const std::size_t end = text_.find(')');
    if (end == std::string_view::npos) return false;
    const std::optional<Unit> inner = UnitParser(text_.substr(1, end - 1)).parse();
    text_.remove_prefix(end + 1);
    const std::optional<int> power = read_power();
    if (!inner || !power) return false;
    const int n = sign * *power;
    const double more = std::pow(inner->numerator, std::abs(n));
    const double less = std::pow(inner->denominator, std::abs(n));
    unit_.numerator *= n > 0 ? more : less;
    unit_.denominator *= n > 0 ? less : more;
    unit_.dimension = unit_.dimension * inner->dimension.power(n);
    return true;
  }

  std::string_view read_name() {
    const bool number = text_.starts_with('1');
    const std::size_t end = number ? 1 : text_.find_first_of("^-/* 0123456789");
    const std::string_view name = text_.substr(0, end);
    text_.remove_prefix(name.size());
    return name;
  }

  /// A '-' with a unit behind it.
  [[nodiscard]] bool joins() const {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return text_.size() > 1 && kLetters.find(text_[1]) != std::string_view::npos;
  }

  /// 1 where no power is written; nothing where it is written wrong.
  std::optional<int> read_power() {
    const bool raised = text_.starts_with('^');
    if (raised) text_.remove_prefix(1);
    const bool negative = text_.starts_with('-') && !joins();
    if (negative) text_.remove_prefix(1);
    const std::size_t length = std::min(text_.find_first_not_of(kDigits), text_.size());
    if (length == 0) return raised || negative ? std::nullopt : std::optional<int>(1);
    const int power = text_.front() - '0';
    text_.remove_prefix(length);
    if (length > 1 || power == 0 || power > kLargestPower) return std::nullopt;
    return negative ? -power : power;
  }

  std::string_view text_;
  Unit unit_;
  int exponent_ = 0;
  bool has_pound_ = false;  ///< or an ounce, by a name that is one of a force, too
};

/// cycles/s and rev/min: so many of something in a time.
std::optional<Unit> find_rate(std::string_view text) {
  static constexpr std::array<std::string_view, 8> kCounted{
      "cycle", "cycles", "rev", "revs", "revolution", "revolutions", "turn", "turns"};
  const std::size_t slash = std::min(text.find('/'), text.size());
  std::string counted = in_small_letters(text.substr(0, slash));
  counted.erase(counted.find_last_not_of(' ') + 1);
  if (slash == text.size() || std::ranges::find(kCounted, counted) == kCounted.end()) {
    return std::nullopt;
  }
  const std::optional<Unit> unit = UnitParser(fmt::format("1{}", text.substr(slash))).parse();
  return unit && unit->dimension == kFrequency ? unit : std::nullopt;
}

const Quantity* find_quantity(const Dimension& dimension) {
  const auto* found = std::find_if(kQuantities.begin(), kQuantities.end(),
                                   [&](const Quantity& q) { return q.dimension == dimension; });
  return found == kQuantities.end() ? nullptr : found;
}

std::string base_units(const Dimension& dimension) {
  const std::array<std::pair<std::string_view, int>, 4> bases{{{"kg", dimension.mass},
                                                               {"m", dimension.length},
                                                               {"s", dimension.time},
                                                               {"rad", dimension.angle}}};
  std::string text;
  for (const auto& [name, power] : bases) {
    if (power == 0) continue;
    text += fmt::format("{}{}", text.empty() ? "" : " ", name);
    if (power != 1) text += fmt::format("^{}", power);
  }
  return text;
}

/// A unit for messages: in quotes, and shortened where it is longer than any unit.
std::string shown_unit(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return fmt::format("'{}'", text);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // UTF-8
  return fmt::format("'{}…'", text.substr(0, end));
}

}  // namespace

std::optional<Unit> find_unit(std::string_view text) {
  const std::string plain = plain_ascii(text);
  if (plain == "-") return Unit{};
  if (const std::optional<Unit> rate = find_rate(plain)) return rate;
  return UnitParser(plain).parse();
}

bool is_other_unit(std::string_view text) {
  if (find_unit(text)) return false;
  const std::string plain = plain_ascii(text);
  const std::string_view first = std::string_view(plain).substr(0, plain.find('/'));
  return std::ranges::find(kOtherUnits, first) != kOtherUnits.end();
}

Unit parse_unit(std::string_view text, const Dimension& expected) {
  const std::string shown = shown_unit(text);
  const std::string rule = fmt::format("must be a unit of {}", dimension_name(expected));
  const std::string remedy = fmt::format("Units that fit: {}.", usual_units(expected));
  const std::optional<Unit> unit = find_unit(text);
  if (!unit) throw InputError("unit", shown, rule + " and is not known", remedy);
  if (unit->dimension != expected) {
    const bool is_angular = expected == kFrequency && unit->dimension == kAngularFrequency;
    throw InputError("unit", shown,
                     fmt::format("{} and is one of {}", rule, dimension_name(unit->dimension)),
                     remedy + (is_angular ? " 1 Hz is 2 pi rad/s." : ""));
  }
  return *unit;
}

std::string dimension_name(const Dimension& dimension) {
  const Quantity* quantity = find_quantity(dimension);
  return quantity != nullptr ? std::string(quantity->name) : base_units(dimension);
}

std::string si_unit(const Dimension& dimension) {
  const Quantity* quantity = find_quantity(dimension);
  if (quantity == nullptr) return base_units(dimension);
  return std::string(quantity->units.substr(0, quantity->units.find(',')));
}

std::string usual_units(const Dimension& dimension) {
  const Quantity* quantity = find_quantity(dimension);
  return quantity != nullptr ? std::string(quantity->units) : base_units(dimension);
}

std::string length_text(double metres) {
  if (metres < 1e-3) return fmt::format("{:.4g} µm", 1e6 * metres);
  if (metres < 1.0) return fmt::format("{:.4g} mm", 1e3 * metres);
  return fmt::format("{:.4g} m", metres);
}

}  // namespace microslip
