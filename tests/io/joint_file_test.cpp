// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/joint_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"

namespace microslip::joint_file_test {
namespace {

using test::message_of;

std::string with_density(const std::string& density) {
  return "{\"schema\": \"microslip.joint/1\", \"stiffness_N_per_m\": 1e5, \"density\": " + density +
         "}";
}

JointFile read(const std::string& text) { return parse_joint(text, "joint.json"); }

/// A fault of the form.
std::string fault(const std::string& text) {
  return message_of<FormatError>([&] { return read(text); });
}

/// A value that breaks a rule, in a density of one part.
std::string value_fault(const std::string& part) {
  return message_of<InputError>([&] { return read(with_density("[" + part + "]")); });
}

TEST(JointFile, ReadsEachTypeOfPart) {
  const JointFile file = read(R"({ "schema": "microslip.joint/1", "stiffness_N_per_m": 170000,
    "density": [ {"type": "uniform", "from_N": 0, "to_N": 5, "weight": 0.25},
                 {"type": "power_law",
                  "coefficient": 0.01, "exponent": -0.5, "from_N": 0, "to_N": 25},
                 {"type": "piecewise_linear", "slip_force_N": [0, 4], "density_per_N": [0.02, 0]},
                 {"type": "atoms", "slip_force_N": [1, 2], "weight": [0.1, 0.2]} ] })");
  EXPECT_EQ(file.joint.stiffness(), 170000.0);
  const auto parts = file.joint.density().parts();
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(std::get<UniformPart>(parts[0]).weight, 0.25);
  EXPECT_EQ(std::get<PowerLawPart>(parts[1]).exponent, -0.5);
  EXPECT_EQ(std::get<PiecewiseLinearPart>(parts[2]).slip_force, (std::vector<double>{0.0, 4.0}));
  EXPECT_EQ(std::get<AtomsPart>(parts[3]).weight, (std::vector<double>{0.1, 0.2}));
  EXPECT_FALSE(file.provenance);
  EXPECT_TRUE(file.identification.empty());
}

TEST(JointFile, TheFourParameterPartTakesItsStiffnessFromTheJoint) {
  const JointFile file = read(with_density(
      R"([{"type": "four_parameter", "macroslip_force_N": 400, "chi": -0.5, "beta": 1}])"));
  const auto& part = std::get<FourParameterPart>(file.joint.density().parts()[0]);
  EXPECT_EQ(part.stiffness, 1e5);
  EXPECT_EQ(part.macroslip_force, 400.0);
}

TEST(JointFile, WithoutPartsNothingSlips) {
  EXPECT_EQ(read(with_density("[]")).joint.density().elastic_remainder(), 1.0);
}

TEST(JointFile, WritesItsKeysInAFixedOrder) {
  Provenance provenance;
  provenance.version = "1.2.3";
  provenance.command = "microslip identify levels.csv";
  provenance.inputs = {{"levels.csv", "abc"}, {"\"odd\"\n", "def"}};
  provenance.options = {{"method", std::string("inversion")}, {"bands", 200.0}};
  provenance.seed = 18446744073709551615U;
  const JointFile file{
      .joint =
          Joint(1e5, SlipDensity({UniformPart{0.0, 5.0, 0.5}, AtomsPart{{1.0, 2.0}, {0.1, 0.2}}})),
      .provenance = provenance,
      .identification = {{"covered_N", std::vector<double>{0.5, 30.0}},
                         {"elastic_remainder", 0.2},
                         {"converged", JsonText{"true"}}}};
  EXPECT_EQ(format_joint(file), R"({
  "schema": "microslip.joint/1",
  "stiffness_N_per_m": 1e+05,
  "density": [
    {"type": "uniform", "from_N": 0, "to_N": 5, "weight": 0.5},
    {"type": "atoms",
      "slip_force_N": [1, 2],
      "weight": [0.1, 0.2]}
  ],
  "provenance": {
    "program": "microslip",
    "version": "1.2.3",
    "command": "microslip identify levels.csv",
    "inputs": [{"file": "levels.csv", "sha256": "abc"}, {"file": "\"odd\"\n", "sha256": "def"}],
    "options": {
      "method": "inversion",
      "bands": 200
    },
    "seed": 18446744073709551615
  },
  "identification": {
    "covered_N": [0.5, 30],
    "elastic_remainder": 0.2,
    "converged": true
  }
}
)");
  const JointFile back = read(format_joint(file));
  EXPECT_EQ(back.provenance, provenance);
  EXPECT_EQ(back.identification, file.identification);
  EXPECT_EQ(format_joint(back), format_joint(file));
}

// Of -0.0 came -0, which is read as 0.
TEST(JointFile, ANegativeZeroIsReadAsItIsWritten) {
  const std::string text = with_density(
      R"([{"type": "four_parameter", "macroslip_force_N": 1.2, "chi": -0.0, "beta": -0.0}])");
  const std::string written = format_joint(read(text));
  EXPECT_EQ(format_joint(read(written)), written);
}

TEST(JointFile, KeepsWhatOthersSayInProvenanceAndIdentification) {
  const JointFile file = read(R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1,
    "density": [], "provenance": {"created": "today", "nested": {"a": [1, {"b": null}]}, "seed": -1,
    "inputs": ["x"], "big": 12345678901234567890},
    "identification": {"mixed": [1, "a"], "none": []}})");
  ASSERT_TRUE(file.provenance);
  const NamedValues expected{{"created", std::string("today")},
                             {"nested", JsonText{R"({"a":[1,{"b":null}]})"}},
                             {"seed", -1.0},
                             {"inputs", JsonText{R"(["x"])"}},
                             {"big", JsonText{"12345678901234567890"}}};
  EXPECT_EQ(file.provenance->other, expected);
  EXPECT_FALSE(file.provenance->seed);
  EXPECT_EQ(file.identification,
            (NamedValues{{"mixed", JsonText{R"([1,"a"])"}}, {"none", std::vector<double>{}}}));
  const JointFile back = read(format_joint(file));
  EXPECT_EQ(back.provenance, file.provenance);
  EXPECT_EQ(back.identification, file.identification);
}

TEST(JointFile, TellsTheLinearDampingThatWasIdentified) {
  const auto read_with = [](const std::string& identification) {
    return read(R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1, "density": [])" +
                identification + "}");
  };
  const auto of = [](const std::string& value) {
    return R"(, "identification": {"linear_damping_J_per_m2": )" + value + "}";
  };
  EXPECT_EQ(identified_damping(read_with("")), std::nullopt);
  EXPECT_EQ(identified_damping(read_with(R"(, "identification": {})")), std::nullopt);
  EXPECT_EQ(identified_damping(read_with(of("0"))), 0.0);
  EXPECT_EQ(identified_damping(read_with(of("4672.5"))), 4672.5);
  for (const char* value : {"-1e-9", "1.1e15", "12345678901234567890", "\"4672\"", "null", "[1]"}) {
    EXPECT_THROW((void)read_with(of(value)), InputError) << value;
  }
}

TEST(JointFile, RefusesToWriteWhatItCouldNotRead) {
  JointFile file{.joint = Joint(1.0, SlipDensity()), .provenance = {}, .identification = {}};
  file.identification = {{"a", std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_EQ(message_of<InputError>([&] { return format_joint(file); }),
            "number = nan; must be finite to be written as JSON");
  file.identification = {{"a", JsonText{"{"}}};
  EXPECT_EQ(message_of<InputError>([&] { return format_joint(file); }),
            "JSON text = '{'; must be valid JSON");
  file.identification = {{"a", 1.0}, {"a", 2.0}};
  EXPECT_EQ(message_of<InputError>([&] { return format_joint(file); }),
            "record = 'a'; must be the name of one entry only");
  file.identification = {{"name", std::string("\xFF")}};
  EXPECT_NE(format_joint(file).find("\"name\": \"\xEF\xBF\xBD\""), std::string::npos);
}

// ---- Faults of the form. ----

TEST(JointFileFault, Missing) {
  EXPECT_EQ(message_of<FileError>([] { return read_joint("no-such-joint.json"); }),
            "no-such-joint.json: cannot be read: No such file or directory. Check the path.");
}

TEST(JointFileFault, Empty) {
  EXPECT_EQ(fault(""), "joint.json: expected JSON, found an empty file");
  EXPECT_EQ(fault(" \n"), "joint.json: expected JSON, found an empty file");
}

TEST(JointFileFault, Syntax) {
  EXPECT_EQ(fault("{\n  \"schema\": \"microslip.joint/1\",\n  stiffness: 1\n}"),
            "joint.json:3:3: expected JSON, found 'stiffness: 1'. Check quotes, commas and "
            "brackets.");
  EXPECT_EQ(fault("{\"schema\": \"microslip.joint/1\""),
            "joint.json:1:31: expected JSON, found the end of the file. Check quotes, commas and "
            "brackets.");
  EXPECT_NE(fault("{} {}").find("joint.json:1:4: expected JSON, found '{}'"), std::string::npos)
      << fault("{} {}");
  EXPECT_NE(fault("{\"a\": NaN}").find("joint.json:1:"), std::string::npos);
  EXPECT_NE(fault("{\"a\": \"\xFF\"}").find("joint.json:1:"), std::string::npos);
  EXPECT_LT(fault("{\"a\": \"" + std::string(10'000'000, 'x')).size(), 200U) << "a huge token";
}

TEST(JointFileFault, NumberOutOfRange) {
  EXPECT_EQ(fault("{\"schema\": \"microslip.joint/1\",\n \"stiffness_N_per_m\": 1e999}"),
            "joint.json:2:23: expected a number within the range of doubles, found '1e999'");
  EXPECT_EQ(fault("{\"schema\": \"1e999 \\\"-1e999\", \"a\": [1.0, -2e+999, 1e999]}"),
            "joint.json:1:41: expected a number within the range of doubles, found '-2e+999'");
}

TEST(JointFileFault, HugeIntegersAreNumbers) {
  EXPECT_EQ(read(R"({"schema": "microslip.joint/1", "density": [],
                     "stiffness_N_per_m": 123456789012345678901234567890})")
                .joint.stiffness(),
            123456789012345678901234567890.0);
}

TEST(JointFileFault, DeepNesting) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  const std::string expected =
      "joint.json: expected at most 64 nested objects and arrays, found more";
  EXPECT_EQ(fault(deep), expected);
  EXPECT_EQ(fault(with_density(deep)), expected);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(fault(objects), expected);
}

TEST(JointFileFault, ManyKeys) {
  std::string text = "{";
  for (int i = 0; i < 100000; ++i) text += "\"k" + std::to_string(i) + "\":1,";
  EXPECT_EQ(fault(text), "joint.json: expected at most 1000 keys in an object, found more");
}

TEST(JointFileFault, NoObject) {
  EXPECT_EQ(fault("[1]"), "joint.json: expected an object, found an array of 1");
  EXPECT_EQ(fault("\"joint\""), "joint.json: expected an object, found 'joint'");
  EXPECT_EQ(fault(with_density("[1]")), "joint.json: expected an object as density[0], found 1");
}

TEST(JointFileFault, Schema) {
  EXPECT_EQ(
      fault(R"({"schema": "microslip.joint/9", "surprise": 1})"),
      "joint.json: expected the schema 'microslip.joint/1', found 'microslip.joint/9'. Is it a "
      "joint, and of this version of the program?");
  EXPECT_EQ(fault(R"({"stiffness": 1})"),
            "joint.json: expected the key 'schema' at the top, found the keys 'stiffness'. It "
            "states the kind of the file: see docs/file_formats.md.");
}

TEST(JointFileFault, UnknownKey) {
  EXPECT_EQ(fault(R"({"schema": "microslip.joint/1", "stiffness": 1})"),
            "joint.json: expected at the top the keys schema, stiffness_N_per_m, density, "
            "provenance, identification, found the unknown key 'stiffness'. Did you mean "
            "'stiffness_N_per_m'?");
  EXPECT_EQ(fault(with_density(R"([{"type": "uniform", "form_N": 0, "to_N": 5, "weight": 1}])")),
            "joint.json: expected in density[0] the keys type, from_N, to_N, weight, found the "
            "unknown key 'form_N'. Did you mean 'from_N'?");
}

TEST(JointFileFault, MissingKey) {
  EXPECT_EQ(fault(with_density(R"([{"type": "uniform", "to_N": 5, "weight": 1}])")),
            "joint.json: expected the key 'from_N' in density[0], found the keys 'type, to_N, "
            "weight'");
}

TEST(JointFileFault, DuplicateKey) {
  EXPECT_EQ(fault(with_density(R"([{"type": "uniform", "to_N": 5, "to_N": 6}])")),
            "joint.json: expected each key once in an object, found 'to_N' twice. Remove one of "
            "them.");
}

TEST(JointFileFault, WrongType) {
  EXPECT_EQ(value_fault(R"({"type": "uniform", "from_N": "0", "to_N": 5, "weight": 1})"),
            "joint.json: density[0].from_N = '0'; must be a number. Write it without quotes.");
  EXPECT_EQ(value_fault(R"({"type": "uniform", "from_N": null, "to_N": 5, "weight": 1})"),
            "joint.json: density[0].from_N = null; must be a number");
  EXPECT_EQ(value_fault(R"({"type": "atoms", "slip_force_N": 1, "weight": 1})"),
            "joint.json: density[0].slip_force_N = 1; must be an array");
  EXPECT_EQ(value_fault(R"({"type": "atoms", "slip_force_N": [1, true], "weight": [1, 1]})"),
            "joint.json: density[0].slip_force_N[1] = true; must be a number");
  EXPECT_EQ(value_fault(R"({"type": 3})"),
            "joint.json: density[0].type = 3; must be a text in quotes");
  EXPECT_EQ(value_fault(R"({"type": "gaussian"})"),
            "joint.json: density[0].type = 'gaussian'; must be uniform, power_law, "
            "piecewise_linear, atoms or four_parameter");
  EXPECT_EQ(message_of<InputError>([] { return read(with_density("{}")); }),
            "joint.json: density = an object; must be an array");
  EXPECT_EQ(fault(R"({"schema": "microslip.joint/1", "stiffness_N_per_m": 1, "density": [],
                      "provenance": "me"})"),
            "joint.json: expected an object as provenance, found 'me'");
}

// ---- Values: the rules are those of SlipDensity and Joint, the names those of the file. ----

TEST(JointFileFault, ReversedRange) {
  EXPECT_EQ(message_of<InputError>([] {
              return read(with_density(R"([{"type": "atoms", "slip_force_N": [1], "weight": [0.1]},
                  {"type": "uniform", "from_N": 5, "to_N": 3, "weight": 0.1}])"));
            }),
            "joint.json: density[1].to_N = 3; must be finite and larger than from = 5. A reversed "
            "range: swap the two.");
}

TEST(JointFileFault, ValuesThatBreakARule) {
  const auto begins = [](const std::string& text, const std::string& beginning) {
    EXPECT_EQ(text.substr(0, beginning.size()), beginning);
  };
  begins(value_fault(R"({"type": "uniform", "from_N": -1, "to_N": 3, "weight": 0.1})"),
         "joint.json: density[0].from_N = -1; ");
  begins(value_fault(R"({"type": "uniform", "from_N": 0, "to_N": 3, "weight": -0.1})"),
         "joint.json: density[0].weight = -0.1; ");
  begins(value_fault(R"({"type": "uniform", "from_N": 0, "to_N": 3, "weight": 1.5})"),
         "joint.json: total weight of density = 1.5; ");
  begins(
      value_fault(
          R"({"type": "piecewise_linear", "slip_force_N": [0, 1], "density_per_N": [0.1, -0.2]})"),
      "joint.json: density[0].density_per_N[1] = -0.2; ");
  begins(value_fault(
             R"({"type": "piecewise_linear", "slip_force_N": [1, 0], "density_per_N": [0, 0]})"),
         "joint.json: density[0].slip_force_N[1] = 0; ");
  begins(value_fault(R"({"type": "four_parameter", "macroslip_force_N": 1, "chi": -1, "beta": 0})"),
         "joint.json: density[0].chi = -1; ");
  begins(value_fault(R"({"type": "four_parameter", "macroslip_force_N": 0, "chi": 0, "beta": 0})"),
         "joint.json: density[0].macroslip_force_N = 0; ");
  for (const char* density :
       {"[]", R"([{"type": "four_parameter", "macroslip_force_N": 1, "chi": 0, "beta": 0}])"}) {
    begins(message_of<InputError>([&] {
             return read(std::string(R"({"schema": "microslip.joint/1", "stiffness_N_per_m": -2,
                                        "density": )") +
                         density + "}");
           }),
           "joint.json: stiffness_N_per_m = -2; ");
  }
}

// ---- Round trips. ----

/// Magnitudes from the smallest to the largest that the rules on a density let through.
double any_positive(std::mt19937_64& random) {
  std::uniform_real_distribution<double> exponent(-320.0, 150.0);
  return std::pow(10.0, exponent(random));
}

std::vector<DensityPart> any_parts(std::mt19937_64& random) {
  std::vector<DensityPart> parts;
  const auto share = [&] { return 1e-3 * std::uniform_real_distribution<double>()(random); };
  for (std::uint64_t n = random() % 5; n > 0; --n) {
    const double from = any_positive(random);
    const double to = 2.0 * from + any_positive(random);
    switch (random() % 3) {
      case 0:
        parts.push_back(UniformPart{from, to, share()});
        break;
      case 1:
        parts.push_back(AtomsPart{{to, from, to}, {share(), 5e-324, 0.0}});
        break;
      default:
        parts.push_back(PiecewiseLinearPart{{from, to}, {share() / (to - from), 0.0}});
    }
  }
  return parts;
}

void expect_same(const Joint& a, const Joint& b) {
  EXPECT_EQ(a.stiffness(), b.stiffness());
  EXPECT_EQ(format_joint({a, {}, {}}), format_joint({b, {}, {}}));
  EXPECT_EQ(a.density().total().zeroth, b.density().total().zeroth);
}

TEST(JointFile, SurvivesTheRoundTrip) {
  std::mt19937_64 random(11);
  int made = 0;
  for (int i = 0; i < 2000; ++i) {
    try {
      const Joint joint(1.0 + any_positive(random), SlipDensity(any_parts(random)));
      ++made;
      expect_same(joint, read(format_joint({joint, {}, {}})).joint);
    } catch (const InputError&) {
      // Beyond what a density may be; nothing to write then.
    }
  }
  EXPECT_GT(made, 1000);
}

TEST(JointFile, RecordsSurviveTheRoundTrip) {
  std::mt19937_64 random(12);
  JointFile file{.joint = Joint(1.0, SlipDensity()), .provenance = {}, .identification = {}};
  for (int i = 0; file.identification.size() < 500; ++i) {  // integers beyond 2^53 among them
    file.identification.emplace_back("n" + std::to_string(i), static_cast<double>(random() >> 1U));
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) file.identification.emplace_back("v" + std::to_string(i), value);
  }
  EXPECT_EQ(read(format_joint(file)).identification, file.identification);
}

TEST(JointFile, DoesNotDependOnTheLocale) {
  class CommaPunctuation : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    std::string do_grouping() const override { return "\1"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  const JointFile file{
      .joint = Joint(12345.5, SlipDensity()), .provenance = {}, .identification = {}};
  EXPECT_NE(format_joint(file).find("\"stiffness_N_per_m\": 12345.5"), std::string::npos);
  EXPECT_EQ(read(format_joint(file)).joint.stiffness(), 12345.5);
  std::locale::global(before);
}

}  // namespace
}  // namespace microslip::joint_file_test
