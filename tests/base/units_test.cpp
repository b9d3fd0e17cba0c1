// SPDX-License-Identifier: MIT
#include "microslip/base/units.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"

namespace microslip::units_test {
namespace {

struct Case {
  std::string text;
  double factor;
  Dimension dimension;
};

std::vector<Case> known_units() {
  return {
      {"m", 1.0, kLength},
      {"mm", 1e-3, kLength},
      {"um", 1e-6, kLength},
      {"\xC2\xB5m", 1e-6, kLength},  // U+00B5
      {"\xCE\xBCm", 1e-6, kLength},  // U+03BC
      {"nm", 1e-9, kLength},
      {"cm", 1e-2, kLength},
      {"km", 1e3, kLength},
      {"in", 0.0254, kLength},
      {"ft", 0.3048, kLength},
      {"mil", 2.54e-5, kLength},
      {"N", 1.0, kForce},
      {"mN", 1e-3, kForce},
      {"kN", 1e3, kForce},
      {"lbf", 4.4482216152605, kForce},
      {"J", 1.0, kEnergy},
      {"mJ", 1e-3, kEnergy},
      {"uJ", 1e-6, kEnergy},
      {"µJ", 1e-6, kEnergy},
      {"N m", 1.0, kEnergy},
      {"N*mm", 1e-3, kEnergy},
      {"N·m", 1.0, kEnergy},
      {"lbf in", 4.4482216152605 * 0.0254, kEnergy},
      {"in·lbf", 4.4482216152605 * 0.0254, kEnergy},
      {"in*lbf", 4.4482216152605 * 0.0254, kEnergy},
      {"in-lbf", 4.4482216152605 * 0.0254, kEnergy},
      {"m/s**2", 1.0, kAcceleration},
      {"m/sec^2", 1.0, kAcceleration},
      {"lbf·in", 4.4482216152605 * 0.0254, kEnergy},
      {"kip", 4448.2216152605, kForce},
      {"klbf", 4448.2216152605, kForce},
      {"kip/in", 4448.2216152605 / 0.0254, kStiffness},
      {"kip-ft", 4448.2216152605 * 0.3048, kEnergy},
      {"N-m", 1.0, kEnergy},
      {"m-s-2", 1.0, kAcceleration},
      {"N/m", 1.0, kStiffness},
      {"N / mm", 1e3, kStiffness},
      {"kN/mm", 1e6, kStiffness},
      {"mN/mm", 1.0, kStiffness},
      {"N/um", 1e6, kStiffness},
      {"lbf/in", 4.4482216152605 / 0.0254, kStiffness},
      {"1/N", 1.0, kPerForce},
      {"1/kN", 1e-3, kPerForce},
      {"N^-1", 1.0, kPerForce},
      {"N⁻¹", 1.0, kPerForce},
      {"s", 1.0, kTime},
      {"ms", 1e-3, kTime},
      {"us", 1e-6, kTime},
      {"Hz", 1.0, kFrequency},
      {"1/s", 1.0, kFrequency},
      {"kHz", 1e3, kFrequency},
      {"rad/s", 1.0, kAngularFrequency},
      {"m/s", 1.0, kVelocity},
      {"m/s^2", 1.0, kAcceleration},
      {"m/s2", 1.0, kAcceleration},
      {"m/s²", 1.0, kAcceleration},
      {"m/s/s", 1.0, kAcceleration},
      {"m s^-2", 1.0, kAcceleration},
      {"mm/s^2", 1e-3, kAcceleration},
      {"g", 9.80665, kAcceleration},
      {"mg", 9.80665e-3, kAcceleration},
      {"kg", 1.0, kMass},
      {"t", 1000.0, kMass},
      {"lb", 0.45359237, kMass},
      {"rad", 1.0, kAngle},
      {"deg", std::numbers::pi / 180.0, kAngle},
      {"°", std::numbers::pi / 180.0, kAngle},
      {"1", 1.0, kDimensionless},
      {"-", 1.0, kDimensionless},
      {"%", 1e-2, kDimensionless},
      {"m/m", 1.0, kDimensionless},
      {" Pa ", 1.0, kPressure},
      {"kPa", 1e3, kPressure},
      {"MPa", 1e6, kPressure},
      {"GPa", 1e9, kPressure},
      {"N/m^2", 1.0, kPressure},
      {"psi", 6894.757293168361, kPressure},
      {"kg/m^3", 1.0, kMassDensity},
      {"N^2/Hz", 1.0, kForce.power(2) / kFrequency},
      {"(m/s^2)^2/Hz", 1.0, kAcceleration.power(2) / kFrequency},
      {"g^2/Hz", 9.80665 * 9.80665, kAcceleration.power(2) / kFrequency},
      {"1/(N m)", 1.0, kEnergy.power(-1)},
      {"(mm/s)2", 1e-6, kVelocity.power(2)},
  };
}

// As exports of testing machines (MTS, Instron, Zwick), loggers (LabVIEW, Hioki) and analysers
// write them. A pound-force is 4.4482216152605 N, standard gravity 9.80665 m/s^2 (NIST SP 811).
std::vector<Case> other_spellings() {
  return {
      {"lbs", 4.4482216152605, kForce},
      {"LBS", 4.4482216152605, kForce},
      {"kips", 4448.2216152605, kForce},
      {"lbs/in", 4.4482216152605 / 0.0254, kStiffness},
      {"kgf", 9.80665, kForce},
      {"kp", 9.80665, kForce},
      {"daN", 10.0, kForce},
      {"Newtons", 1.0, kForce},
      {"in.", 0.0254, kLength},
      {"inch", 0.0254, kLength},
      {"Inches", 0.0254, kLength},
      {"mils", 2.54e-5, kLength},
      {"microns", 1e-6, kLength},
      {"millimeters", 1e-3, kLength},
      {"in./sec", 0.0254, kVelocity},
      {"sec", 1.0, kTime},
      {"sec.", 1.0, kTime},
      {"Seconds", 1.0, kTime},
      {"msec", 1e-3, kTime},
      {"min", 60.0, kTime},
      {"h", 3600.0, kTime},
      {"g's", 9.80665, kAcceleration},
      {"G", 9.80665, kAcceleration},
      {"rpm", 1.0 / 60.0, kFrequency},
      {"degrees", std::numbers::pi / 180.0, kAngle},
      {"µε", 1e-6, kDimensionless},
      {"microstrain", 1e-6, kDimensionless},
      {"mm/mm", 1.0, kDimensionless},
      {"bar", 1e5, kPressure},
      {"mbar", 100.0, kPressure},
      {"ksi", 6894757.293168361, kPressure},
      {"PSI", 6894.757293168361, kPressure},
      {"RPM", 1.0 / 60.0, kFrequency},
      {"rev/min", 1.0 / 60.0, kFrequency},
      {"cycles/min", 1.0 / 60.0, kFrequency},
      {"cycles/s", 1.0, kFrequency},
      {"Cycles / sec", 1.0, kFrequency},
      {"hz", 1.0, kFrequency},
      {"mins", 60.0, kTime},
      {"hr", 3600.0, kTime},
      {"HRS", 3600.0, kTime},
      {"KN", 1e3, kForce},
      {"KN/mm", 1e6, kStiffness},
      {"LBF", 4.4482216152605, kForce},
      {"lbm", 0.45359237, kMass},
      {"lbm/ft^3", 16.018463373960142, kMassDensity},  // NIST SP 811, B.9: pound per cubic foot
      {"kgm", 1.0, kMass * kLength},
      {"ms-2", 1.0, kAcceleration},
      {"ms^-2", 1.0, kAcceleration},
      {"ms⁻²", 1.0, kAcceleration},
      {"mms-2", 1e-3, kAcceleration},
      {"ms-1", 1.0, kVelocity},
      {"mm s-1", 1e-3, kVelocity},
      {"Nm", 1.0, kEnergy},
      {"kNm", 1e3, kEnergy},
      {"Nmm", 1e-3, kEnergy},
      {"Nm-1", 1.0, kStiffness},
      {"kgm-3", 1.0, kMassDensity},
  };
}

TEST(Units, SpellingsOfLaboratoriesAreKnown) {
  for (const Case& c : other_spellings()) {
    const auto unit = find_unit(c.text);
    ASSERT_TRUE(unit) << c.text;
    EXPECT_DOUBLE_EQ(unit->factor(), c.factor) << c.text;
    EXPECT_EQ(unit->dimension, c.dimension) << c.text << ": " << dimension_name(unit->dimension);
  }
}

// Conversions of NIST SP 811 (2008), appendix B.8, to the digits given there.
TEST(Units, OthersOfLaboratoriesAreKnown) {
  const std::vector<Case> cases{
      {"klbm", 453.59237, kMass},
      {"oz", 0.028349523125, kMass},
      {"slug", 14.59390, kMass},
      {"Mg", 1000.0, kMass},
      {"ips", 0.0254, kVelocity},
      {"mG", 9.80665e-3, kAcceleration},
      {"Gal", 0.01, kAcceleration},
      {"tonf", 8896.443, kForce},
      {"tf", 9806.65, kForce},
      {"ozf", 0.2780139, kForce},
      {"pounds", 4.448222, kForce},
      {"dyn", 1e-5, kForce},
      {"psf", 47.88026, kPressure},
      {"uin", 2.54e-8, kLength},
      {"ft-lb", 1.355818, kEnergy},
      {"lb-in", 0.1129848, kEnergy},
      {"oz-in", 7.061552e-3, kEnergy},
      {"lb/in", 175.1268, kStiffness},
      {"lb/in^3", 27679.90, kMassDensity},
      {"lbm/in", 17.85797, kMass / kLength},
  };
  for (const Case& c : cases) {
    const auto unit = find_unit(c.text);
    ASSERT_TRUE(unit) << c.text;
    EXPECT_NEAR(unit->factor(), c.factor, 1e-6 * c.factor) << c.text;
    EXPECT_EQ(unit->dimension, c.dimension) << c.text;
  }
}

// A capital tells mega from milli: of units with such prefixes it counts.
TEST(Units, PrefixesAreToldApartByCapitals) {
  EXPECT_EQ(find_unit("mN")->factor(), 1e-3);
  EXPECT_EQ(find_unit("MN")->factor(), 1e6);
  EXPECT_EQ(find_unit("mPa")->factor(), 1e-3);
  EXPECT_EQ(find_unit("MPa")->factor(), 1e6);
  for (const char* text : {"MPA", "MHZ", "mhz", "kn", "MM", "tm", "lbmm", "MIN"}) {
    EXPECT_FALSE(find_unit(text)) << text;
  }
}

TEST(Units, OtherQuantitiesAreNamedAsSuch) {
  for (const char* text : {"°C", "degF", "V", "mV", "mV/g", "Ω", "pC/N", "Volts", "cycles"}) {
    EXPECT_TRUE(is_other_unit(text)) << text;
    EXPECT_FALSE(find_unit(text)) << text;
  }
  for (const char* text : {"", "furlong", "N", "1", "/V", "cycles/s"})
    EXPECT_FALSE(is_other_unit(text)) << text;
}

TEST(Units, KnownOnesConvertToSi) {
  for (const Case& c : known_units()) {
    const auto unit = find_unit(c.text);
    ASSERT_TRUE(unit) << c.text;
    EXPECT_DOUBLE_EQ(unit->factor(), c.factor) << c.text;
    EXPECT_EQ(unit->dimension, c.dimension) << c.text << ": " << dimension_name(unit->dimension);
  }
}

TEST(Units, PowersOfTenAreExact) {
  EXPECT_EQ(find_unit("um")->to_si(3.0), 3e-6);
  EXPECT_EQ(find_unit("mm")->to_si(0.7), 0.7e-3);
  EXPECT_EQ(find_unit("nm")->to_si(123.0), 123e-9);
  EXPECT_EQ(find_unit("mN/mm")->to_si(0.1), 0.1);
  EXPECT_EQ(find_unit("in")->to_si(1.0), 0.0254);
}

TEST(Units, UnknownOnesAreRefused) {
  for (const char* text :
       {"",     " ",    "furlong", "kkg",  "mkg",   "mmm",  "/",   "1/",
        "/s",   "m^",   "m^0",     "m^99", "m--2",  "m-",   "-m",  "in--lbf",
        "kkip", "N//m", "m***2",   "12",   "\xB5m", "\xFF", "kin", "m^9999999999999999999"}) {
    EXPECT_FALSE(find_unit(text)) << text;
  }
  EXPECT_FALSE(find_unit(std::string(100000, 'm')));
}

TEST(Units, PowersAddUpOnlySoFar) {
  std::string text = "Gm^1";
  EXPECT_FALSE(find_unit(text)) << "giga-metres are not in use";
  text = "km9";
  for (int i = 0; i < 20; ++i) text += " km9";
  EXPECT_FALSE(find_unit(text)) << "a factor beyond the range of numbers";
}

std::string message(std::string_view text, const Dimension& expected) {
  try {
    (void)parse_unit(text, expected);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// Found by scripts/fuzz.
TEST(Units, MessagesShowTheBeginningOfWhatIsLong) {
  const std::string long_one = std::string(59, 'm') + "µ" + std::string(60000, 'm');
  EXPECT_EQ(message(long_one, kLength).substr(0, 80),
            "unit = '" + std::string(59, 'm') + "…'; must be");
}

TEST(Units, MessagesNameTheUnitTheRuleAndTheRemedy) {
  EXPECT_EQ(message("furlong", kLength),
            "unit = 'furlong'; must be a unit of length and is not known. Units that fit: "
            "m, mm, um (µm), nm, cm, in, ft, mil.");
  EXPECT_EQ(message("N", kLength),
            "unit = 'N'; must be a unit of length and is one of force. Units that fit: "
            "m, mm, um (µm), nm, cm, in, ft, mil.");
  EXPECT_EQ(message("rad/s", kFrequency),
            "unit = 'rad/s'; must be a unit of frequency and is one of angular frequency. "
            "Units that fit: Hz, kHz. 1 Hz is 2 pi rad/s.");
  EXPECT_EQ(message("m", kLength), "no error");
}

TEST(Units, EachProposedUnitFits) {
  for (const Dimension& dimension :
       {kDimensionless, kLength, kMass, kTime, kAngle, kFrequency, kAngularFrequency, kVelocity,
        kAcceleration, kForce, kEnergy, kStiffness, kPerForce, kPressure, kMassDensity,
        kForce.power(2) / kFrequency, kAcceleration.power(2) / kFrequency}) {
    EXPECT_EQ(find_unit(si_unit(dimension))->dimension, dimension) << si_unit(dimension);
    EXPECT_EQ(find_unit(si_unit(dimension))->factor(), 1.0) << si_unit(dimension);
    std::string_view list_view;
    const std::string list = usual_units(dimension);
    list_view = list;
    while (!list_view.empty()) {
      const std::string_view text = list_view.substr(0, list_view.find(','));
      list_view.remove_prefix(std::min(text.size() + 1, list_view.size()));
      EXPECT_EQ(parse_unit(text.substr(0, text.find(" (")), dimension).dimension, dimension)
          << text;
    }
  }
}

TEST(Units, DimensionsWithoutANameAreSpelt) {
  EXPECT_EQ(dimension_name(kMass.power(2) / kTime), "kg^2 s^-1");
  EXPECT_EQ(si_unit(kMass.power(2) / kTime), "kg^2 s^-1");
}

}  // namespace
}  // namespace microslip::units_test
