// SPDX-License-Identifier: MIT

// Rates and units: what becomes SI, and what is left alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/uff_support.hpp"

namespace microslip::uff_units_test {
namespace {

using test::codes;
using test::Function58;
using test::kThree;
using test::read_channel;
using test::read_uff;
using test::three_points;
using test::units164;
using Numbers = std::vector<double>;
using Codes = std::vector<std::string>;

// ---- Rates. ----

TEST(UffUnits, TakesARateNearAnIntegerForIt) {
  Function58 f = three_points();
  const auto step = [&](const std::string& text) {
    f.step = text;
    return read_uff(text_dataset(f, kThree)).recordings[0].axis.step;
  };
  EXPECT_EQ(step("1.52588E-05"), 1.0 / 65536.0);
  EXPECT_EQ(step("1.95312E-05"), 1.0 / 51200.0) << "cut, not rounded";
  EXPECT_EQ(step("1.22070E-04"), 1.0 / 8192.0);
  EXPECT_EQ(step("3.33333E-01"), 1.0 / 3.0);
  EXPECT_EQ(step("1.23456E-01"), 0.123456) << "8.10005 Hz is no integer";
  EXPECT_EQ(step("2.00000E+00"), 2.0);
}

TEST(UffUnits, FrequenciesAreNoRates) {
  Function58 f = three_points();
  f.abscissa_type = 18;
  f.abscissa_unit = "Hz";
  f.step = "1.52588E-05";
  const Axis axis = read_uff(text_dataset(f, kThree)).recordings[0].axis;
  EXPECT_EQ(axis.dimension, kFrequency);
  EXPECT_EQ(axis.step, 1.52588e-05);
}

// ---- Units. ----

std::optional<Dimension> dimension_of(const Function58& f, const std::string& before = "") {
  return read_channel(before + text_dataset(f, kThree)).dimension;
}

TEST(UffUnits, LabelsTellTheUnit) {
  Function58 f = three_points();
  f.ordinate_type_code = 12;
  f.ordinate_unit = "g";
  EXPECT_EQ(read_channel(text_dataset(f, kThree)).values,
            (Numbers{9.80665, 2 * 9.80665, 3 * 9.80665}));
  EXPECT_EQ(dimension_of(f), kAcceleration);
  f.ordinate_unit = "mm";
  EXPECT_EQ(dimension_of(f), kLength) << "whatever the type says";
  f.ordinate_unit = "furlong";
  EXPECT_EQ(dimension_of(f), std::nullopt);
  EXPECT_EQ(dimension_of(f, units164(1, "1.0D+00", "1.0D+00")), std::nullopt)
      << "a label that is not known says that it is not the unit of dataset 164";
  f.abscissa_unit = "ms";
  EXPECT_DOUBLE_EQ(read_uff(text_dataset(f, kThree)).recordings[0].axis.step, 1e-6);
}

// ---- Text fields that are as wide in bytes or in characters. ----

enum class Padding { kBytes, kCharacters };

std::string padded(std::string text, std::size_t width, Padding padding) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  const auto extra = padding == Padding::kBytes
                         ? 0U
                         : static_cast<std::size_t>(std::ranges::count_if(text, continues));
  text.resize(std::max(text.size(), width + extra), ' ');
  return text;
}

/// Record 9 of an acceleration, without blanks behind the unit's field.
std::string ordinate(const std::string& label, const std::string& unit, Padding padding) {
  return "        12    0    0    0 " + padded(label, 20, padding) + ' ' +
         padded(unit, 20, padding);
}

Recordings read_ordinate(const std::string& line) {
  Function58 f = three_points();
  f.ordinate_line = line;
  // Not a unit that is given on no evidence, should the label be lost.
  return read_uff(units164(9, "1.0D+00", "1.0D+00") + text_dataset(f, kThree));
}

double first_value(const Recordings& read) { return read.recordings[0].channels[0].values[0]; }

TEST(UffUnits, TextFieldsMayBePaddedByBytesOrCharacters) {
  struct Case {
    std::string label, unit;
    Dimension dimension;
    double factor;
  };
  for (const Case& c :
       {Case{"Kraftstärke", "kN", kForce, 1000.0},
        Case{"acc (m/s²)", "mm/s^2", kAcceleration, 0.001}, Case{"Weg für u", "mm", kLength, 0.001},
        Case{"Größe über 6 Lg", "mm/s²", kAcceleration, 0.001}}) {
    for (const Padding padding : {Padding::kBytes, Padding::kCharacters}) {
      for (const std::size_t width : {0U, 80U}) {
        SCOPED_TRACE(c.label + (padding == Padding::kBytes ? " in bytes " : " in characters ") +
                     std::to_string(width));
        const Recordings read =
            read_ordinate(padded(ordinate(c.label, c.unit, padding), width, padding));
        EXPECT_EQ(codes(read), Codes{});
        EXPECT_EQ(read.recordings[0].channels[0].dimension, c.dimension);
        EXPECT_DOUBLE_EQ(first_value(read), c.factor);
      }
    }
  }
}

TEST(UffUnits, ALabelCutWithinACharacterLeavesTheUnitWhereItIs) {
  const Recordings read =
      read_ordinate(ordinate("Beschleunigung quer\xC3", "mm/s\xC2\xB2", Padding::kBytes));
  EXPECT_EQ(read.recordings[0].channels[0].dimension, kAcceleration);
  EXPECT_EQ(first_value(read), 0.001);
}

TEST(UffUnits, AUnitThatDependsOnTheCountIsNone) {
  // By bytes N m; by characters the N ends the label and m is left.
  const std::string both_fit = ordinate("Kräftepaar über x", "N m", Padding::kBytes);
  // The label is too long for its field: by bytes kN, by characters N.
  const std::string none_fits = "        12    0    0    0 ä" + std::string(18, 'x') + "_kN";
  for (const std::string& line : {both_fit, none_fits}) {
    const Recordings read = read_ordinate(line);
    EXPECT_EQ(codes(read), Codes{"uff_columns"});
    EXPECT_EQ(read.recordings[0].channels[0].dimension, std::nullopt);
    EXPECT_EQ(first_value(read), 1.0);
  }
  const Recordings read = read_ordinate(padded(both_fit, 80, Padding::kBytes));
  EXPECT_EQ(codes(read), Codes{}) << "a line of 80 bytes says how it was padded";
  EXPECT_EQ(read.recordings[0].channels[0].dimension, kForce * kLength);
}

TEST(UffUnits, ZerosPadAsBlanksDo) {
  std::string line = ordinate("Kraftstärke", "kN", Padding::kBytes);
  std::replace(line.begin() + 26, line.end(), ' ', '\0');
  EXPECT_EQ(first_value(read_ordinate(line)), 1000.0);
}

TEST(UffUnits, PointNamesMayBePaddedByBytesOrCharacters) {
  for (const Padding padding : {Padding::kBytes, Padding::kCharacters}) {
    Function58 f = three_points();
    f.id = "NONE";
    f.response = padded("Träger", 10, padding);
    f.response_node = 12;
    f.response_direction = 3;
    const Channel channel = read_channel(text_dataset(f, kThree));
    EXPECT_EQ(channel.name, "Träger 12 +Z");
    for (const auto& [name, text] : channel.attributes) EXPECT_NE(name, "reference entity") << text;
  }
}

TEST(UffUnits, BlankLabelsAreNeverTakenForSi) {
  Function58 f = three_points();
  f.ordinate_unit = "NONE";
  const Channel channel = read_channel(text_dataset(f, kThree));
  EXPECT_EQ(channel.dimension, std::nullopt);
  EXPECT_EQ(channel.values, (Numbers{1, 2, 3}));
}

TEST(UffUnits, Dataset164GivesBlankLabelsTheirUnit) {
  Function58 f = three_points();
  f.ordinate_unit = "";
  const std::string user = units164(9, "1.00000000000000000D+03", "2.00000000000000000D+00");
  Channel channel = read_channel(user + text_dataset(f, kThree));
  EXPECT_EQ(channel.dimension, kForce);
  EXPECT_EQ(channel.values, (Numbers{0.5, 1.0, 1.5})) << "SI = value / factor";

  f.ordinate_type_code = 12;
  channel = read_channel(user + text_dataset(f, kThree));
  EXPECT_EQ(channel.dimension, kAcceleration);
  EXPECT_EQ(channel.values, (Numbers{0.001, 0.002, 0.003}));

  f.response_direction = 5;  // a rotation: rad/s^2, which no factor scales
  channel = read_channel(user + text_dataset(f, kThree));
  EXPECT_EQ(channel.dimension, kAngularFrequency / kTime);
  EXPECT_EQ(channel.values, (Numbers{1, 2, 3}));

  f.response_direction = 0;
  f.function_type = 9;
  EXPECT_EQ(dimension_of(f, user), std::nullopt) << "a power density is not of its signal's unit";
}

TEST(UffUnits, UnitsDoNotReachIntoAFileThatWasAppended) {
  Function58 f = three_points();
  f.ordinate_unit = "";
  const std::string header = test::marker() + "   151\nname\n" + test::marker();
  const Recordings read = read_uff(header + units164(1, "1.0D+00", "1.0D+00") +
                                   text_dataset(f, kThree) + header + text_dataset(f, kThree));
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings[0].channels[0].dimension, kForce);
  EXPECT_EQ(read.recordings[1].channels[0].dimension, std::nullopt);
  EXPECT_EQ(read.recordings[0].attributes, (Attributes{{"model name", "name"}}));
  EXPECT_EQ(read.recordings[1].source, "t.uff #2");
}

TEST(UffUnits, QuotientsOfNumeratorAndDenominator) {
  Function58 f = three_points();
  f.function_type = 4;
  f.ordinate_type = 5;
  f.abscissa_type = 18;
  f.abscissa_unit = "Hz";
  f.ordinate_type_code = 12;
  f.ordinate_unit = "mm/s^2";
  f.denominator_type = 13;
  f.denominator_unit = "kN";
  const std::string values =
      "  1.00000E+00  2.00000E+00  3.00000E+00  4.00000E+00  5.00000E+00  6.00000E+00\n";
  Channel channel = read_channel(text_dataset(f, values));
  EXPECT_EQ(channel.dimension, kAcceleration / kForce);
  EXPECT_DOUBLE_EQ(channel.values[1], 3e-6);
  EXPECT_DOUBLE_EQ(channel.imaginary[2], 6e-6);
  f.denominator_unit = "";
  EXPECT_EQ(read_channel(text_dataset(f, values)).dimension, std::nullopt) << "half is not known";
}

TEST(UffUnits, LabelsWithParentheses) {
  Function58 f = three_points();
  const auto unit = [&](const std::string& label) {
    f.ordinate_unit = label;
    return dimension_of(f);
  };
  EXPECT_EQ(unit("(1/N)*(m/s\xB2)"), kAcceleration / kForce);
  EXPECT_EQ(unit("(m/s^2)/N"), kAcceleration / kForce);
  EXPECT_EQ(unit("m/(s*s)"), kAcceleration);
  EXPECT_EQ(unit("m/(s/m)"), kLength.power(2) / kTime);
  EXPECT_EQ(unit("m/(N s)"), std::nullopt);
  EXPECT_EQ(unit("(m/s)^2"), std::nullopt);
  EXPECT_EQ(unit("((m))"), std::nullopt);
  EXPECT_EQ(unit("(m"), std::nullopt);
}

TEST(UffUnits, AnAbscissaOfUnknownUnitIsNoTime) {
  Function58 f = three_points();
  f.abscissa_unit = "fortnights";
  const Recordings read = read_uff(text_dataset(f, kThree));
  EXPECT_EQ(codes(read), Codes{"uff_axis_unit"});
  EXPECT_EQ(read.recordings[0].axis.dimension, kDimensionless);
  f.abscissa_unit = "SEC";
  EXPECT_EQ(read_uff(text_dataset(f, kThree)).recordings[0].axis.dimension, kTime);
  f.abscissa_unit = "";
  EXPECT_EQ(read_uff(text_dataset(f, kThree)).recordings[0].axis.dimension, kTime);
}

}  // namespace
}  // namespace microslip::uff_units_test
