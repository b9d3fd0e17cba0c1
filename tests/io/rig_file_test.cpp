// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/rig_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "io/toml_pairs.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/rig_writer.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip::rig_file_test {
namespace {

using test::message_of;
using test::Pair;
using test::pairs_of;
using test::without;

const std::string kFolder = MICROSLIP_EXAMPLES "/reference_rig/";
const std::string kReference = test::get(kFolder + "rig.toml");

const std::string kModes =
    "schema = \"microslip.rig/1\"\n"
    "[modes]\n"
    "frequency_Hz = [55.8, 349]\n"
    "excitation = [1.1, -0.8]\n"
    "joint = [-0.021, 0.5]\n"
    "[damping]\n"
    "loss_factor = [0]\n"
    "[excitation]\n"
    "channel = \"force\"\n"
    "[[accelerometer]]\n"
    "shape = [1, 0.5]\n"
    "channel = \"acc\"\n";

std::string message(const std::string& text) {
  return message_of<Error>([&] { return parse_rig(text, "rig.toml"); });
}

/// The text with the first `before` in it replaced.
std::string edited(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

std::string reference_message(const std::string& before, const std::string& after) {
  return message(edited(kReference, before, after));
}

std::string modes_message(const std::string& before, const std::string& after) {
  return message(edited(kModes, before, after));
}

void expect_contains(const std::string& text, const std::string& part, const std::string& input) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text << "\n" << input;
}

void expect_starts(const std::string& text, const std::string& start) {
  EXPECT_EQ(text.substr(0, start.size()), start);
}

// ---- What is read. ----

void expect_reference_structure(const Rig& rig) {
  ASSERT_NE(rig.beam(), nullptr);
  EXPECT_EQ(rig.beam()->length, 0.583);
  EXPECT_EQ(rig.beam()->width, 0.040);
  EXPECT_EQ(rig.beam()->thickness, 0.005);
  EXPECT_EQ(rig.beam()->youngs_modulus, 2.07e11);
  EXPECT_EQ(rig.beam()->mass_density, 7850.0);
  EXPECT_EQ(rig.contact.rod_radius, 0.030);
  EXPECT_EQ(rig.contact.stiffness, 1.7e5);
  EXPECT_EQ(rig.contact.stick_frequency, std::nullopt);
  EXPECT_EQ(rig.contact.joint, "joint.json");
  EXPECT_EQ(rig.loss_factor, (std::vector<double>{0.0028, 0.0018, 0.0011}));
  ASSERT_EQ(rig.masses.size(), 3U);
  EXPECT_EQ(rig.masses[0].position, 0.55);
  EXPECT_EQ(rig.masses[0].mass, 0.030);
  EXPECT_EQ(rig.masses[1].position, 0.35);
  EXPECT_EQ(rig.masses[1].mass, 0.010);
  EXPECT_EQ(rig.masses[2].position, 0.18);
  EXPECT_EQ(rig.masses[2].mass, 0.010);
}

void expect_reference_sensors(const Rig& rig) {
  EXPECT_EQ(rig.excitation.position, 0.55);
  EXPECT_EQ(rig.excitation.channel, "force");
  ASSERT_EQ(rig.accelerometers.size(), 3U);
  EXPECT_EQ(rig.accelerometers[0].position, 0.55);
  EXPECT_EQ(rig.accelerometers[0].channel, "acc1");
  EXPECT_EQ(rig.accelerometers[1].position, 0.35);
  EXPECT_EQ(rig.accelerometers[1].channel, "acc2");
  EXPECT_EQ(rig.accelerometers[2].position, 0.18);
  EXPECT_EQ(rig.accelerometers[2].channel, "acc3");
  ASSERT_TRUE(rig.vibrometer);
  EXPECT_EQ(rig.vibrometer->channel, "ldv");
  EXPECT_EQ(rig.vibrometer->measures, RigVibrometer::Measures::kJoint);
}

void expect_reference_test(const Rig& rig) {
  ASSERT_TRUE(rig.test);
  EXPECT_EQ(rig.test->response_from, 0.294);
  EXPECT_EQ(rig.test->response_to, 39.24);
  EXPECT_EQ(rig.test->count, 90U);
  EXPECT_FALSE(rig.test->logarithmic);
  EXPECT_EQ(rig.test->sampling_rate, 8192.0);
  EXPECT_EQ(rig.test->duration, 1.0);
  EXPECT_EQ(rig.test->frequency_resolution, 0.1);
  EXPECT_EQ(rig.test->modes, 7U);
  EXPECT_EQ(rig.test->harmonics, 9U);
  ASSERT_TRUE(rig.noise);
  EXPECT_EQ(rig.noise->force, 0.002);
  EXPECT_EQ(rig.noise->acceleration, 0.005);
  EXPECT_EQ(rig.noise->vibrometer, 2e-8);
}

TEST(RigFile, ReadsTheReferenceRig) {
  const Rig rig = read_rig(kFolder + "rig.toml");
  expect_reference_structure(rig);
  expect_reference_sensors(rig);
  expect_reference_test(rig);
  EXPECT_EQ(file_kind(kReference), kRigKind);
}

TEST(RigFile, TheJointOfTheReferenceRigIsTheReferenceJoint) {
  const Rig rig = read_rig(kFolder + "rig.toml");
  EXPECT_EQ(read_joint(kFolder + rig.contact.joint).joint.stiffness(), rig.contact.stiffness);
  EXPECT_EQ(test::get(kFolder + "joint.json"),
            test::get(MICROSLIP_EXAMPLES "/reference_joint/joint.json"));
}

TEST(RigFile, ReadsTheOtherChoices) {
  Rig rig = parse_rig(edited(kReference, "stiffness_N_per_m = 1.7e5", "stick_frequency_Hz = 55"),
                      "rig.toml");
  EXPECT_EQ(rig.contact.stiffness, std::nullopt);
  EXPECT_EQ(rig.contact.stick_frequency, 55.0) << "an integer is a number";
  rig = parse_rig(edited(kReference, "\"linear\"", "\"log\""), "rig.toml");
  EXPECT_TRUE(rig.test->logarithmic);
  rig = parse_rig(edited(kReference, "measures = \"joint\"", "measures = \"axial\""), "rig.toml");
  EXPECT_EQ(rig.vibrometer->measures, RigVibrometer::Measures::kAxial);
}

TEST(RigFile, ReadsModes) {
  const Rig rig = parse_rig(kModes, "rig.toml");
  EXPECT_EQ(rig.beam(), nullptr);
  ASSERT_NE(rig.modes(), nullptr);
  EXPECT_EQ(rig.modes()->frequency, (std::vector<double>{55.8, 349.0}));
  EXPECT_EQ(rig.modes()->excitation, (std::vector<double>{1.1, -0.8}));
  EXPECT_EQ(rig.modes()->joint, (std::vector<double>{-0.021, 0.5}));
  ASSERT_EQ(rig.accelerometers.size(), 1U);
  EXPECT_EQ(rig.accelerometers[0].shape, (std::vector<double>{1.0, 0.5}));
  EXPECT_EQ(rig.accelerometers[0].channel, "acc");
  EXPECT_EQ(rig.excitation.channel, "force");
  EXPECT_FALSE(rig.contact.stiffness || rig.vibrometer || rig.test || rig.noise);
  const Rig with_contact =
      parse_rig(kModes + "[contact]\nstiffness_N_per_m = 2e5\njoint = 'a/b.json'\n", "rig.toml");
  EXPECT_EQ(with_contact.contact.stiffness, 2e5);
  EXPECT_EQ(with_contact.contact.joint, "a/b.json");
}

TEST(RigFile, WhatIsOptionalHasTheDefaultsOfARig) {
  std::string text = edited(kReference, "frequency_resolution_Hz = 0.1\n", "");
  text = edited(edited(text, "modes = 7\n", ""), "harmonics = 9\n", "");
  text = edited(edited(text, "force_N = 0.002\n", ""), "vibrometer_m = 2e-8\n", "");
  const Rig rig = parse_rig(text, "rig.toml");
  EXPECT_EQ(rig.test->frequency_resolution, RigTest{}.frequency_resolution);
  EXPECT_EQ(rig.test->modes, RigTest{}.modes);
  EXPECT_EQ(rig.test->harmonics, RigTest{}.harmonics);
  EXPECT_EQ(rig.noise->force, 0.0);
  EXPECT_EQ(rig.noise->acceleration, 0.005);
  EXPECT_EQ(rig.noise->vibrometer, 0.0);
}

TEST(RigFile, ReadsByteOrderMarkAndCarriageReturns) {
  const std::string text = std::regex_replace(kReference, std::regex("\n"), "\r\n");
  const Rig rig = parse_rig("\xEF\xBB\xBF" + text, "rig.toml");
  expect_reference_structure(rig);
  expect_reference_sensors(rig);
  expect_reference_test(rig);
}

// ---- Each value of the text in turn is left out or replaced. ----

TEST(RigFileFault, EachMissingKey) {
  const std::set<std::string> optional{
      "contact.joint", "test.frequency_resolution_Hz", "test.modes",        "test.harmonics",
      "noise.force_N", "noise.acceleration_m_per_s2",  "noise.vibrometer_m"};
  for (const std::string& original : {kReference, kModes}) {
    for (const Pair& pair : pairs_of(original)) {
      const std::string text = without(original, pair);
      const std::string found = message(text);
      if (optional.count(pair.path) > 0) {
        EXPECT_EQ(found, "no error") << pair.path;
        continue;
      }
      expect_contains(found, "rig.toml:", text);
      // One of two keys is missing: both are reported, without their units.
      expect_contains(found, pair.key == "stiffness_N_per_m" ? "stiffness" : pair.key, text);
      const std::string table = pair.path.substr(0, pair.path.rfind('.'));
      if (table != pair.path) expect_contains(found, table, text);
    }
  }
}

TEST(RigFileFault, EachReplacedValue) {
  const std::string shaken = kReference +
                             "[shaker]\nresistance_Ohm = 2\ninductance_H = 1e-3\n"
                             "force_factor_N_per_A = 5\nmoving_mass_kg = 0.02\n"
                             "suspension_stiffness_N_per_m = 1e3\n"
                             "suspension_damping_Ns_per_m = 1\nstinger_stiffness_N_per_m = 1e6\n";
  std::size_t cases = 0;
  for (const std::string& original : {shaken, kModes}) {
    for (const Pair& pair : pairs_of(original)) {
      const char first = original[pair.value_start];
      for (const std::string value :
           {"\"1\"", "-1", "[]", "nan", "-inf", "true", "[[1]]", "{}", "2014-06-01", "[\"a\"]"}) {
        if (first == '"' && value == "\"1\"" && pair.key == "channel") continue;
        if (pair.path == "contact.joint" && value == "\"1\"") continue;  // any path will do
        std::string text = original;
        text.replace(pair.value_start, pair.end - pair.value_start, value);
        const std::string found = message(text);
        expect_contains(found, fmt::format("rig.toml:{}:", pair.line), text);
        expect_contains(found, pair.path, text);
        ++cases;
      }
    }
  }
  EXPECT_GT(cases, 400U);
}

TEST(RigFileFault, EachMisspeltKey) {
  for (const std::string& original : {kReference, kModes}) {
    for (const Pair& pair : pairs_of(original)) {
      if (pair.key == "schema") continue;  // without it nothing else is looked at
      std::string text = original;
      text.insert(pair.start + 1, "x");
      const std::string found = message(text);
      expect_contains(found, fmt::format("rig.toml:{}:", pair.line), text);
      expect_contains(found, fmt::format("Did you mean '{}'?", pair.key), text);
    }
  }
}

TEST(RigFileFault, EachMissingHeader) {  // its keys belong to the table before it then
  for (std::size_t at = kReference.find("\n["); at != std::string::npos;
       at = kReference.find("\n[", at + 1)) {
    std::string text = kReference;
    text.erase(at + 1, text.find(']', at) - at);
    expect_contains(message(text), "rig.toml:", text);
  }
}

// ---- Whole messages. ----

TEST(RigFileFault, NoFile) {
  EXPECT_EQ(message_of<FileError>([] { return read_rig("no-such-rig.toml"); }),
            "no-such-rig.toml: cannot be read: No such file or directory. Check the path.");
}

TEST(RigFileFault, AnotherFile) {
  EXPECT_EQ(message(""), "rig.toml: expected TOML, found an empty file");
  EXPECT_EQ(message(test::get(kFolder + "joint.json")),
            "rig.toml: expected TOML, found a joint (joint.json). Is it the right file?");
  EXPECT_EQ(message("schema = \"microslip.model/1\"\nsurprise = 1\n"),
            "rig.toml:1:10: expected the schema 'microslip.rig/1', found 'microslip.model/1'. "
            "This is a structure with joints (model.toml), not a rig.");
  EXPECT_EQ(message("[package]\n"),
            "rig.toml:1:1: expected the key 'schema' at the top, found the keys 'package'. It "
            "states the kind of the file: see docs/file_formats.md.");
}

TEST(RigFileFault, ValuesThatBreakARule) {
  EXPECT_EQ(reference_message("length_m = 0.583", "length_m = -1"),
            "rig.toml:5:12: beam.length_m = -1; must be above 0 and finite");
  EXPECT_EQ(reference_message("position_m = 0.18\nchannel", "position_m = 0.6\nchannel"),
            "rig.toml:44:14: accelerometer[2].position_m = 0.6; must be above 0 and below "
            "beam.length = 0.583 m. The beam does not move at its ends.");
  EXPECT_EQ(reference_message("\"acc3\"", "\"acc1\""),
            "rig.toml:45:11: accelerometer[2].channel = acc1; must differ from "
            "accelerometers[0].channel");
  expect_starts(reference_message("to_m_per_s2 = 39.24", "to_m_per_s2 = 0.1"),
                "rig.toml:52:64: test.response_acceleration.to_m_per_s2 = 0.1; mu");
  EXPECT_EQ(modes_message("shape = [1, 0.5]", "shape = [1]"),
            "rig.toml:11:9: accelerometer[0].shape = 1 values; must have 2, one per mode of "
            "modes.frequency");
  expect_starts(modes_message("[55.8, 349]", "[349, 55.8]"),
                "rig.toml:3:16: modes.frequency_Hz = 55.8; m");
}

TEST(RigFileFault, ValuesOfAWrongType) {
  EXPECT_EQ(reference_message("length_m = 0.583", "length_m = \"0.583\""),
            "rig.toml:5:12: beam.length_m = '0.583'; must be a number. Write it without quotes.");
  EXPECT_EQ(reference_message("[0.0028, 0.0018, 0.0011]", "[0.0028, 'x']"),
            "rig.toml:17:24: damping.loss_factor[1] = 'x'; must be a number. Write it without "
            "quotes.");
  EXPECT_EQ(reference_message("count = 90", "count = 90.5"),
            "rig.toml:52:79: test.response_acceleration.count = 90.5; must be a whole number, 0 or "
            "more");
  EXPECT_EQ(reference_message("\"linear\"", "\"cubic\""),
            "rig.toml:52:93: test.response_acceleration.spacing = 'cubic'; must be \"linear\" or "
            "\"log\"");
  EXPECT_EQ(
      reference_message("\"joint.json\"", "\"\""),
      "rig.toml:14:9: contact.joint = ''; must be the path of a joint file. Leave the key out "
      "where the joint is not known.");
}

TEST(RigFileFault, KeysThatDoNotBelongHere) {
  EXPECT_EQ(reference_message("rod_radius_m", "rod_radius_mm"),
            "rig.toml:12:1: expected in contact the keys rod_radius_m, stiffness_N_per_m, "
            "stick_frequency_Hz, joint, found the unknown key 'rod_radius_mm'. Did you mean "
            "'rod_radius_m'?");
  expect_contains(modes_message("shape = [1, 0.5]", "position_m = 0.5"),
                  "rig.toml:11:1: expected in accelerometer[0] the keys shape, channel, found the "
                  "unknown key 'position_m'",
                  "position with modes");
  expect_contains(modes_message("[excitation]\n", "[excitation]\nposition_m = 0.5\n"),
                  "rig.toml:9:1: expected in excitation the keys channel, found the unknown key "
                  "'position_m'",
                  "position with modes");
  expect_contains(message(kModes + "[contact]\nrod_radius_m = 0.03\n"),
                  "rig.toml:14:1: expected in contact the keys stiffness_N_per_m",
                  "rod with modes");
}

TEST(RigFileFault, TablesThatDoNotBelongTogether) {
  EXPECT_EQ(message(kModes + "[beam]\n"),
            "rig.toml:13:1: expected one of the tables [beam] and [modes], found both");
  EXPECT_EQ(message("schema = \"microslip.rig/1\"\n"),
            "rig.toml:1:1: expected one of the tables [beam] and [modes], found neither");
  EXPECT_EQ(message(kModes + "[[mass]]\nposition_m = 0\nmass_kg = 1\n"),
            "rig.toml:13:1: mass = 1 given; must not be given with modes. The modes contain "
            "all masses.");
  expect_starts(reference_message("1.7e5  ", "1.7e5\nstick_frequency_Hz = 55.8 "),
                "rig.toml:11:1: contact = stiffness and stick_frequency; must");
  EXPECT_EQ(modes_message("[[accelerometer]]", "[accelerometer]"),
            "rig.toml:10:1: accelerometer = a table; must be an array of tables. Write "
            "[[accelerometer]].");
  expect_starts(message(edited(edited(kModes, "[[accelerometer]]", "[vibrometer]"),
                               "shape = [1, 0.5]\n", "measures = \"joint\"\n") +
                        "[test]\n"),
                "rig.toml:1:1: expected the key 'accelerometer' at t");
}

TEST(RigFileFault, DuplicateKeys) {
  expect_starts(reference_message("width_m = 0.040", "length_m = 0.040"),
                "rig.toml:6:12: expected TOML, found ");
  expect_starts(reference_message("[[mass]]", "[beam]"),
                "rig.toml:19:1: expected TOML, found '[beam]'. The parser says ");
}

const std::string kShaker =
    "[shaker]\n"
    "resistance_Ohm = 3\n"
    "inductance_H = 0\n"
    "force_factor_N_per_A = 12.5\n"
    "moving_mass_kg = 0.2\n"
    "suspension_stiffness_N_per_m = 0\n"
    "suspension_damping_Ns_per_m = 0.5\n"
    "stinger_stiffness_N_per_m = 1e6\n";

TEST(RigFile, ReadsTheShaker) {
  EXPECT_FALSE(parse_rig(kReference, "rig.toml").shaker.has_value());
  const Rig rig = parse_rig(kReference + kShaker, "rig.toml");
  ASSERT_TRUE(rig.shaker.has_value());
  EXPECT_EQ(rig.shaker->resistance, 3.0);
  EXPECT_EQ(rig.shaker->inductance, 0.0);
  EXPECT_EQ(rig.shaker->force_factor, 12.5);
  EXPECT_EQ(rig.shaker->moving_mass, 0.2);
  EXPECT_EQ(rig.shaker->suspension_stiffness, 0.0);
  EXPECT_EQ(rig.shaker->suspension_damping, 0.5);
  EXPECT_EQ(rig.shaker->stinger_stiffness, 1e6);
  // What is left out has its default.
  const Rig other = parse_rig(kReference + "[shaker]\nmoving_mass_kg = 0.2\n", "rig.toml");
  EXPECT_EQ(other.shaker->resistance, RigShaker{}.resistance);
  expect_contains(message(kReference + "[shaker]\nmass_kg = 0.2\n"), "mass_kg", "unknown key");
  expect_contains(message(kReference + "[shaker]\nmoving_mass_kg = 0\n"),
                  "shaker.moving_mass_kg = 0; must be above 0", "no mass");
}

/// Writes what it reads.
void expect_round_trip(const std::string& text) {
  const Rig rig = parse_rig(text, "rig.toml");
  const std::string written = format_rig(rig);
  EXPECT_EQ(file_kind(written), kRigKind);
  const Rig again = parse_rig(written, "written.toml");
  // The text holds all of a rig, each number as the shortest that reads back as the same.
  EXPECT_EQ(format_rig(again), written);
  EXPECT_EQ(again.contact.joint, rig.contact.joint);
  EXPECT_EQ(again.contact.stiffness, rig.contact.stiffness);
  EXPECT_EQ(again.contact.stick_frequency, rig.contact.stick_frequency);
  EXPECT_EQ(again.contact.rod_radius, rig.contact.rod_radius);
  EXPECT_EQ(again.loss_factor, rig.loss_factor);
  EXPECT_EQ(again.masses.size(), rig.masses.size());
  EXPECT_EQ(again.excitation.channel, rig.excitation.channel);
  EXPECT_EQ(again.excitation.position, rig.excitation.position);
  ASSERT_EQ(again.accelerometers.size(), rig.accelerometers.size());
  for (std::size_t j = 0; j < rig.accelerometers.size(); ++j) {
    EXPECT_EQ(again.accelerometers[j].position, rig.accelerometers[j].position);
    EXPECT_EQ(again.accelerometers[j].shape, rig.accelerometers[j].shape);
    EXPECT_EQ(again.accelerometers[j].channel, rig.accelerometers[j].channel);
  }
  EXPECT_EQ(again.vibrometer.has_value(), rig.vibrometer.has_value());
  EXPECT_EQ(again.test.has_value(), rig.test.has_value());
  EXPECT_EQ(again.noise.has_value(), rig.noise.has_value());
  EXPECT_EQ(again.shaker.has_value(), rig.shaker.has_value());
}

TEST(RigFile, WritesWhatItReads) {
  expect_round_trip(kReference);
  expect_round_trip(kReference + kShaker);
  expect_round_trip(kModes);
  expect_round_trip(edited(kReference, "spacing = \"linear\"", "spacing = \"log\""));
  expect_round_trip(edited(kReference, "measures = \"joint\"", "measures = \"axial\""));
  expect_round_trip(edited(kReference, "2.07e11", "2.0700000000000002e11"));
  // A name of all signs that a string of TOML escapes.
  const std::string name = R"("a \"b\" \\ \t \u007F µ")";
  const Rig rig = parse_rig(edited(kReference, "\"ldv\"", name), "rig.toml");
  EXPECT_EQ(parse_rig(format_rig(rig), "rig.toml").vibrometer->channel, rig.vibrometer->channel);
}

}  // namespace
}  // namespace microslip::rig_file_test
