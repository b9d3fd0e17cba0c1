// SPDX-License-Identifier: MIT
// `campaign` of a model: a virtual structure of two joints, three modes, two sessions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/base/random.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/documents/structure/model_writer.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/chain_structure.hpp"
#include "support/effort.hpp"
#include "support/figures.hpp"
#include "support/replaced.hpp"
#include "support/simulated_calibration.hpp"

namespace microslip::cli_test::campaign_model_test {
namespace {

constexpr double kLossNoise = 0.005;      // of D
constexpr double kFrequencyNoise = 1e-5;  // relative
constexpr std::size_t kLevels = 9;        // of a mode in a session
constexpr std::size_t kModes = 3;

/// Of the frequencies in the second session.
double offset_of(std::size_t mode) { return 0.003 + 0.0005 * static_cast<double>(mode); }

JointedStructure true_structure() {
  return testing::lap_and_other(testing::tent(6e5, 90.0, 0.6), testing::tent(9e5, 110.0, 0.5));
}

/// The same with modes that have no joints in them.
JointedStructure true_structure_of_free_modes() {
  return testing::chain_structure({3.0, 2.0, 2.5}, {5e5, 4e5, 7e5, 2e5},
                                  {{"lap", 0, 1, testing::tent(6e5, 90.0, 0.6)},
                                   {"other", 1, 2, testing::tent(9e5, 110.0, 0.5)}},
                                  0.004, {0.0, 0.0});
}

/// The structure with joints to be found.
std::string unknown_model(const JointedStructure& truth = true_structure()) {
  std::vector<StructuralJoint> stuck(truth.joints().begin(), truth.joints().end());
  for (StructuralJoint& joint : stuck) joint.joint = Joint(joint.joint.stiffness(), SlipDensity());
  return format_model(
      {.structure = JointedStructure(truth.linear(), stuck, {Excitation{"p1"}}, truth.damping()),
       .response = "p1",
       .joint_files = {"", ""},
       .to_find = {0, 1}});
}

/// modal_levels.csv of a mode, from 0, in a session, from 0, by the harmonic balance of the true
/// structure. The joints move less in the third mode than in the others.
/// @param offset  of the frequencies, beside those of the structure.
std::string measured(const JointedStructure& truth, std::size_t mode, std::size_t session,
                     double gain, double offset, Forcing forcing = Forcing::kExcitation) {
  constexpr std::array kFrom{5e-6, 1e-6, 4e-7};
  constexpr std::array kTo{2.5e-4, 0.7e-4, 0.35e-5};
  const HarmonicBalance balance(truth, {"p1"}, {.forcing = forcing});
  RandomStream random(5, 10 * session + mode);
  std::vector<double> responses;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kLevels - 1);
    responses.push_back((session == 0 ? 1.0 : 1.07) * kFrom.at(mode) *
                        std::pow(kTo.at(mode) / kFrom.at(mode), share));
  }
  std::string text = "mode [1],displacement [m],frequency [Hz],dissipation [J]\n";
  for (const SteadyVibration& point : balance.backbone(responses, mode).points) {
    double loss = 0.0;
    for (const JointCycle& joint : point.joints) loss += joint.dissipation;
    text += fmt::format(
        "{},{:.12g},{:.12g},{:.12g}\n", mode + 1, point.response,
        point.frequency() * std::exp(offset) * (1.0 + kFrequencyNoise * random.normal()),
        gain * loss * (1.0 + kLossNoise * random.normal()));
  }
  return text;
}

/// The same with damping ratios, to 1 %, in place of losses: at the lowest levels the joints have
/// less of them than the noise.
std::string measured_damping(std::size_t mode, std::size_t session) {
  constexpr double kNoise = 0.01;
  constexpr std::array kFrom{5e-6, 1e-6, 4e-7};
  constexpr std::array kTo{2.5e-4, 0.7e-4, 0.35e-5};
  const HarmonicBalance balance(true_structure(), {"p1"}, {});
  RandomStream random(7, 10 * session + mode);
  std::vector<double> responses;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kLevels - 1);
    responses.push_back(kFrom.at(mode) * std::pow(kTo.at(mode) / kFrom.at(mode), share));
  }
  std::string text = "mode [1],displacement [m],frequency [Hz],damping_ratio [1]\n";
  for (const SteadyVibration& point : balance.backbone(responses, mode).points) {
    text += fmt::format("{},{:.12g},{:.12g},{:.12g}\n", mode + 1, point.response, point.frequency(),
                        point.damping_ratio() * (1.0 + kNoise * random.normal()));
  }
  return text;
}

/// A table with one more column. @param cell  of it, from those of a row.
template <typename Cell>
std::string with_column(const std::string& table, const std::string& name, const Cell& cell) {
  std::string wider;
  std::size_t number = 0;
  for (std::size_t at = 0; at < table.size(); ++number) {
    const std::size_t end = table.find('\n', at);
    const std::string row = table.substr(at, end - at);
    wider += row + ',' + (number == 0 ? name : cell(number, row)) + '\n';
    at = end + 1;
  }
  return wider;
}

/// A table whose losses say that they are known to a share.
std::string with_deviations(const std::string& table, double share) {
  return with_column(table, "dissipation_std [J]", [&](std::size_t, const std::string& row) {
    return fmt::format("{:.6g}", share * std::stod(row.substr(row.rfind(',') + 1)));
  });
}

const std::string kHead = R"(schema = "microslip.campaign/1"
title = "Two joints"
model = "model.toml"
[identification]
draws = 200
session_offsets = true
)";

std::string name_of(std::size_t session, std::size_t mode) {
  return fmt::format("{}{}", session == 0 ? "monday" : "friday", mode + 1);
}

/// @param third   the use of tests of the third mode.
/// @param others  that of the others.
std::string campaign(const std::string& more, const std::string& third,
                     const std::string& others = "identify") {
  std::string text = kHead + more;
  for (std::size_t session = 0; session < 2; ++session) {
    for (std::size_t mode = 0; mode < kModes; ++mode) {
      const std::string name = name_of(session, mode);
      text += fmt::format(
          "[[test]]\nname = \"{0}\"\nfile = \"{0}.csv\"\nuse = \"{1}\"\nsession = \"{2}\"\n"
          "conditions = {{ torque_Nm = {3} }}\n",
          name, mode == 2 ? third : others, session + 1, session == 0 ? 20 : 25);
    }
  }
  return text;
}

/// The structure with its tests.
class Laboratory : public Sandbox {
 public:
  /// @param falsified  mode, from 0, whose losses are read 10 % too high in the second session, and
  ///                   in the first as well where `always`.
  explicit Laboratory(std::size_t falsified = kModes, bool always = false)
      : Sandbox{{"model.toml", unknown_model()}} {
    for (std::size_t session = 0; session < 2; ++session) {
      for (std::size_t mode = 0; mode < kModes; ++mode) {
        const bool wrong = mode == falsified && (session == 1 || always);
        put(name_of(session, mode) + ".csv",
            measured(true_structure(), mode, session, wrong ? 1.1 : 1.0,
                     session == 0 ? 0.0 : offset_of(mode)));
      }
    }
  }
};

const Arguments kCall{"campaign", "campaign.toml", "--out", "found"};

CsvTable table(const Sandbox& box, const std::string& name) {
  return {box.get("found/" + name), name};
}

/// What of the verdicts of a quantity of predicted tests is "inside", and how many there are.
std::pair<double, double> inside(const Sandbox& box, const std::string& quantity) {
  double held = 0.0;
  double count = 0.0;
  for (const std::string& verdict : table(box, "campaign.csv").text(quantity + "_verdict")) {
    held += verdict == "inside" ? 1.0 : 0.0;
    count += verdict.empty() ? 0.0 : 1.0;
  }
  return {held, count};
}

/// The names that contradict the others, each once.
std::vector<std::string> contradicting(const Sandbox& box) {
  const CsvTable left_out = table(box, "leave_one_out.csv");
  const std::vector<std::string> names = left_out.text("left_out");
  const std::vector<std::string> verdicts = left_out.text("contradicts");
  std::vector<std::string> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (verdicts[i] == "yes" && std::ranges::count(found, names[i]) == 0) found.push_back(names[i]);
  }
  return found;
}

// Joints from two modes in both sessions predict the third: 18 frequencies and losses, of which a
// band of 95 % misses 0.9 each, more than three in 1.5 %. The offset of the third mode in the
// second session, 0.4 %, is taken as the mean of the others, 0.325 %, and their rms as its σ.
TEST(campaign_of_a_model, PredictsAModeFromTwoOthers) {
  const Laboratory box;
  box.put("campaign.toml", campaign("", "predict"));
  const Outcome run = expect_done(box, kCall);
  for (const std::string part :
       {"Two joints", "session 2, mode 2", "frequency offset +0.350", "Prediction of 2 tests"}) {
    EXPECT_NE(run.out.find(part), std::string::npos) << part << " in " << run.out;
  }
  for (const std::string quantity : {"frequency", "dissipation"}) {
    const auto [held, count] = inside(box, quantity);
    EXPECT_EQ(count, 2.0 * kLevels) << quantity;
    EXPECT_GE(held, count - 3.0) << quantity;
    test::record_smallest("inside of 95 % [1]", held / count);
  }
  for (const std::string name :
       {"lap.json", "lap_samples.h5", "other.json", "other_samples.h5", "model.toml",
        "model_2.toml", "modal_levels.csv", "calibration.json", "calibration.csv",
        "identifiability.csv", "comparison.csv", "sessions.csv", "conditions.csv"}) {
    EXPECT_TRUE(box.has("found/" + name)) << name;
  }
  EXPECT_FALSE(box.has("found/joint.json"));
  const std::vector<std::string> kinds = table(box, "comparison.csv").text("kind");
  EXPECT_EQ(std::ranges::count(kinds, "modal-levels"), static_cast<std::ptrdiff_t>(kinds.size()));
  EXPECT_NE(box.get("found/sessions.csv").find("# repeatability_between_sessions = "),
            std::string::npos);
  // Tests used for identification are distinguished from others.
  expect_done(box, {"report", "found", "--no-pictures", "--out", "report.html"});
  const std::string report = box.get("report.html");
  const std::string alone = "predicted alone";
  const std::size_t first = report.find(alone);
  const std::size_t second = report.find(alone, first + 1);
  EXPECT_LT(first, report.find("monday3.csv (SHA-256"));
  EXPECT_LT(second, report.find("friday3.csv (SHA-256"));
  EXPECT_EQ(report.find(alone, second + 1), std::string::npos);
}

// A table of a decay in two modes, of which the second alone is asked for.
TEST(campaign_of_a_model, TakesAModeOfATable) {
  const Laboratory box;
  const std::string second = box.get("monday2.csv");
  box.put("decay.csv", box.get("monday1.csv") + second.substr(second.find('\n') + 1));
  const std::string plan = R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
forcing = "modal"
[[test]]
name = "decay"
file = "decay.csv"
use = "both"
kind = "ringdown"
mode = 2
)";
  box.put("campaign.toml", plan);
  expect_done(box, kCall);
  const CsvTable levels = table(box, "modal_levels.csv");
  EXPECT_EQ(levels.numbers("mode", kDimensionless), std::vector<double>(kLevels, 2.0));
  EXPECT_EQ(levels.text("source").front(), "level 10");
  EXPECT_EQ(table(box, "comparison.csv").text("kind").front(), "ringdown");
  box.put("campaign.toml", test::replaced(plan, "mode = 2", "mode = 3"));
  expect_refused(box, kCall, {"test 'decay': mode", "3", "one of those of decay.csv"});
}

// σ of a mean of nine frequencies is a third of their noise: five σ of a difference of two. In the
// studies alone: PredictsAModeFromTwoOthers finds offsets, too.
TEST(campaign_of_a_model, FindsTheOffsetOfEachModeInASession) {
  MICROSLIP_STUDY();
  const Laboratory box;
  box.put("campaign.toml", campaign("", "identify"));
  expect_done(box, kCall);
  const CsvTable sessions = table(box, "sessions.csv");
  const std::vector<double> modes = sessions.numbers("mode", kDimensionless);
  const std::vector<double> offsets = sessions.numbers("frequency_offset", kDimensionless);
  ASSERT_EQ(modes.size(), 2 * kModes);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto mode = static_cast<std::size_t>(modes[i]) - 1;
    EXPECT_NEAR(offsets[i], i < kModes ? 0.0 : offset_of(mode), 5.0 * kFrequencyNoise * 0.47) << i;
  }
  // Levels less offsets: calibrate finds the same from the table that is left.
  expect_done(box, {"calibrate", "model.toml", "found/modal_levels.csv", "--out", "again",
                    "--samples", "200", "--quiet"});
  const auto loss = [&](const std::string& file) {
    return CsvTable(box.get(file), file).numbers("dissipation_lap", kEnergy);
  };
  const std::vector<double> found = loss("found/calibration.csv");
  const std::vector<double> again = loss("again/calibration.csv");
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(again[i] / found[i], 1.0, 0.01) << i;
}

// The nominal frequency of the third mode is 1 % off: predictions of it are that uncertain, and
// those of the others as little as ever.
TEST(campaign_of_a_model, KnowsHowFarEachModeIsOff) {
  MICROSLIP_OF_RELEASE_ALONE();
  const JointedStructure truth = true_structure();
  const std::vector<double> off{0.0, 0.0, 0.01};
  const Sandbox box{{"model.toml", unknown_model(with_modal_offsets(truth, off))}};
  std::string plan = R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
draws = 200
)";
  for (std::size_t mode = 0; mode < kModes; ++mode) {
    box.put(name_of(0, mode) + ".csv", measured(truth, mode, 0, 1.0, 0.0));
    plan += fmt::format("[[test]]\nname = \"{0}\"\nfile = \"{0}.csv\"\nuse = \"both\"\n",
                        name_of(0, mode));
  }
  box.put("campaign.toml", plan);
  expect_done(box, kCall);
  const CsvTable rows = table(box, "campaign.csv");
  const std::vector<std::string> tests = rows.text("test");
  const std::vector<std::string> verdicts = rows.text("frequency_verdict");
  const std::vector<std::string> lower = rows.text("frequency_lower");
  const std::vector<std::string> upper = rows.text("frequency_upper");
  double held = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (verdicts[i].empty()) continue;
    const double width = std::stod(upper[i]) / std::stod(lower[i]) - 1.0;
    if (tests[i] == name_of(0, 2)) {
      held += verdicts[i] == "inside" ? 1.0 : 0.0;
      count += 1.0;
      EXPECT_NEAR(width, 4.0 * 0.01, 0.02) << i;  // of ±2σ by 200 draws
    } else {
      EXPECT_LT(width, 0.002) << i;
    }
  }
  EXPECT_EQ(count, static_cast<double>(kLevels));
  EXPECT_EQ(held, count);
}

// What sets the structure off in the second session leaves its joints as they are: modes without
// these are 0.4 to 0.6 % off, those with them less. Each of 54 frequencies and losses of tests that
// identify is predicted; a band of 95 % misses 1.35 in 27, more than four in 1 %. In the studies
// alone: PredictsAModeFromTwoOthers finds offsets of sessions and predicts by them.
TEST(campaign_of_a_model, PutsTheOffsetOnTheStructureAlone) {
  MICROSLIP_STUDY();
  const JointedStructure monday = true_structure_of_free_modes();
  const JointedStructure friday =
      with_modal_offsets(monday, std::vector<double>{0.004, 0.005, 0.006});
  const Sandbox box{{"model.toml", unknown_model(monday)},
                    {"campaign.toml", campaign("", "both", "both")}};
  for (std::size_t session = 0; session < 2; ++session) {
    for (std::size_t mode = 0; mode < kModes; ++mode) {
      box.put(name_of(session, mode) + ".csv",
              measured(session == 0 ? monday : friday, mode, session, 1.0, 0.0));
    }
  }
  expect_done(box, kCall);
  const CsvTable rows = table(box, "campaign.csv");
  const std::vector<std::string> sessions = rows.text("session");
  const std::vector<std::string> verdicts = rows.text("frequency_verdict");
  double held = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (sessions[i] != "2" || verdicts[i].empty()) continue;
    held += verdicts[i] == "inside" ? 1.0 : 0.0;
    count += 1.0;
  }
  EXPECT_EQ(count, static_cast<double>(kModes * kLevels));
  EXPECT_GE(held, count - 4.0);
  // Bands are those of a frequency that is read to 1e-5, and of what the offset of the structure
  // changes by as its joints soften: a sixth of the 0.5 % that it is at most.
  const std::vector<std::string> lower = rows.text("frequency_lower");
  const std::vector<std::string> upper = rows.text("frequency_upper");
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (verdicts[i].empty()) continue;
    EXPECT_LT(std::stod(upper[i]) / std::stod(lower[i]) - 1.0, 0.001) << i;
  }
  const ModelFile given = read_model(box.file("found/model_2.toml"));
  for (std::size_t i = 0; i < kModes; ++i) {
    const double truth = friday.linear().modes()[i].angular_frequency;
    test::record_deviation("frequency without joints",
                           given.structure.linear().modes()[i].angular_frequency, truth);
  }
}

// 10 % are twenty times the noise. Left out, the test of the second mode on Friday is compared with
// five that agree. In the studies alone: NamesAFalsifiedMode leaves out three times instead of six.
TEST(campaign_of_a_model, NamesTheTestOfAFalsifiedMode) {
  MICROSLIP_STUDY();
  const Laboratory box(1);
  box.put("campaign.toml", campaign("leave_one_out = \"tests\"\n", "identify"));
  const Outcome run = expect_done(box, kCall);
  EXPECT_EQ(contradicting(box), std::vector<std::string>{"friday2"}) << run.out;
  EXPECT_NE(run.out.find("friday2 contradicts the others"), std::string::npos);
}

/// A table of the first two modes with the joints of the truth.
std::string both_modes(std::size_t session, double gain) {
  const std::string second = measured(true_structure(), 1, session, gain, 0.0);
  return measured(true_structure(), 0, session, gain, 0.0) + second.substr(second.find('\n') + 1);
}

// 5 % more loss in the one, ten times the noise: what all together scatter by would hold it.
// Frequencies tell the joints, too, so that even of two tests the one that is wrong is known.
TEST(campaign_of_a_model, NamesAWrongTestAmongFew) {
  MICROSLIP_STUDY();
  const Sandbox box{{"model.toml", unknown_model()}};
  std::string plan = R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
draws = 200
leave_one_out = "tests"
)";
  const std::string tests = "abc";
  for (std::size_t i = 0; i < tests.size(); ++i) {
    box.put(fmt::format("{}.csv", tests[i]), both_modes(i, tests[i] == 'b' ? 1.05 : 1.0));
    plan +=
        fmt::format("[[test]]\nname = \"{0}\"\nfile = \"{0}.csv\"\nuse = \"identify\"\n", tests[i]);
    if (i == 0) continue;
    box.put("campaign.toml", plan);
    const Outcome run = expect_done(box, kCall);
    const std::vector<std::string> wrong = contradicting(box);
    for (const std::string name : {"b: mode 1", "b: mode 2"}) {
      EXPECT_EQ(std::ranges::count(wrong, name), 1) << run.out;
    }
    EXPECT_EQ(wrong.size(), 2U) << run.out;
  }
}

TEST(campaign_of_a_model, NamesAFalsifiedMode) {
  MICROSLIP_OF_RELEASE_ALONE();
  const Laboratory box(1, true);
  box.put("campaign.toml", campaign("leave_one_out = \"modes\"\n", "identify"));
  const Outcome run = expect_done(box, kCall);
  EXPECT_EQ(contradicting(box), std::vector<std::string>{"mode 2"}) << run.out;
  // What lies above the amplitudes of the others is not judged.
  const std::vector<std::string> verdicts = table(box, "leave_one_out.csv").text("verdict");
  EXPECT_GE(std::ranges::count(verdicts, "beyond"), 1);
}

// In the studies alone: NamesAFalsifiedMode judges modes that agree, too.
TEST(campaign_of_a_model, NamesNoneThatAgree) {
  MICROSLIP_STUDY();
  const Laboratory box;
  box.put("campaign.toml", campaign("leave_one_out = \"modes\"\n", "identify"));
  const Outcome run = expect_done(box, kCall);
  EXPECT_TRUE(contradicting(box).empty()) << run.out;
}

// Damping ratios without standard deviations: their noise is a share of the loss of structure and
// joints, and so is what they are compared with. The losses that are left for the joints are
// negative at some of the lowest levels; means are not off by them. Five standard deviations of
// nine ratios.
TEST(campaign_of_a_model, JudgesDampingRatiosByTheirScatter) {
  MICROSLIP_STUDY();
  const Laboratory box;
  for (std::size_t session = 0; session < 2; ++session) {
    for (std::size_t mode = 0; mode < kModes; ++mode) {
      box.put(name_of(session, mode) + ".csv", measured_damping(mode, session));
    }
  }
  box.put("campaign.toml", campaign("leave_one_out = \"tests\"\n", "identify"));
  const Outcome run = expect_done(box, kCall);
  EXPECT_TRUE(contradicting(box).empty()) << run.out;
  for (const double offset :
       table(box, "sessions.csv").numbers("dissipation_offset", kDimensionless)) {
    EXPECT_NEAR(offset, 0.0, 5.0 * 0.01 / 3.0);
  }
  // Both sessions have the same displacements: what the one reaches is not beyond the other.
  const std::vector<std::string> verdicts = table(box, "leave_one_out.csv").text("verdict");
  EXPECT_EQ(std::ranges::count(verdicts, "beyond"), 0);
}

// Losses scatter by 0.5 % and say 0.2 %: calibrate tells so, and what is left out and what is
// predicted is compared with their scatter.
TEST(campaign_of_a_model, TakesDeviationsForNoLessThanTheScatter) {
  MICROSLIP_STUDY();
  const Laboratory box;
  for (std::size_t session = 0; session < 2; ++session) {
    for (std::size_t mode = 0; mode < kModes; ++mode) {
      const std::string name = name_of(session, mode) + ".csv";
      box.put(name, with_deviations(box.get(name), 0.002));
    }
  }
  box.put("campaign.toml", campaign("leave_one_out = \"tests\"\n", "both"));
  const Outcome run = expect_done(box, kCall);
  EXPECT_TRUE(contradicting(box).empty()) << run.out;
  const auto [held, count] = inside(box, "dissipation");
  EXPECT_EQ(count, 2.0 * kLevels);
  EXPECT_GE(held, count - 3.0);
  EXPECT_NE(box.get("found/comparison.csv").find("times their standard deviations"),
            std::string::npos);
}

// Without one of two modes the other cannot distinguish two joints: that is said, and nobody
// accused.
TEST(campaign_of_a_model, DoesNotJudgeByJointsThatAreKnownOnlyTogether) {
  const Laboratory box;
  box.put("campaign.toml", R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
draws = 100
leave_one_out = "tests"
[[test]]
name = "monday1"
file = "monday1.csv"
use = "identify"
[[test]]
name = "monday2"
file = "monday2.csv"
use = "identify"
)");
  const Outcome run = expect_done(box, kCall);
  EXPECT_TRUE(contradicting(box).empty()) << run.out;
  const CsvTable left_out = table(box, "leave_one_out.csv");
  EXPECT_GE(std::ranges::count(left_out.text("contradicts"), "not_judged"), 1) << run.out;
  EXPECT_NE(left_out.text("warnings_of_others").front().find("known_only_together"),
            std::string::npos);
  EXPECT_NE(run.out.find("is not assessed: without it"), std::string::npos) << run.out;
}

// What is reported of a level names its test, and what a table tells of its levels goes along.
TEST(campaign_of_a_model, NamesLevelsByTheirTests) {
  const Laboratory box;
  const std::string flagged =
      with_column(box.get("monday3.csv"), "flags", [](std::size_t number, const std::string&) {
        return std::string(number == 2 ? "not_steady" : "");
      });
  box.put("monday3.csv", flagged);
  std::string wrong = box.get("friday2.csv");  // the loss of its fourth level
  std::size_t end = 0;
  for (int row = 0; row < 5; ++row) end = wrong.find('\n', end) + 1;
  const std::size_t cell = wrong.rfind(',', end) + 1;
  wrong.replace(cell, end - 1 - cell,
                fmt::format("{:.8g}", 1.5 * std::stod(wrong.substr(cell, end - 1 - cell))));
  box.put("friday2.csv", wrong);
  box.put("campaign.toml", campaign("", "identify"));
  const Outcome run = expect_done(box, kCall);
  EXPECT_NE(run.out.find("friday2: level 4 has 1.4"), std::string::npos) << run.out;
  const std::vector<std::string> flags = table(box, "modal_levels.csv").text("flags");
  EXPECT_EQ(flags[2 * kLevels + 1], "not_steady");
  EXPECT_EQ(std::ranges::count(flags, ""), static_cast<std::ptrdiff_t>(flags.size()) - 1);
}

// A decay of the second mode by a march of the true structure, whose hysteretic damping is viscous
// there: frequencies and damping ratios that it follows from the joints that it identified, with
// two tables, to its standard deviations.
TEST(campaign_of_a_model, TakesADecay) {
  const Laboratory box;
  const JointedStructure truth = true_structure();
  box.put("truth.toml", format_model({.structure = truth,
                                      .response = "p1",
                                      .joint_files = {"true_lap.json", "true_other.json"}}));
  for (const StructuralJoint& joint : truth.joints()) {
    box.put(fmt::format("true_{}.json", joint.name), format_joint({joint.joint, {}, {}}));
  }
  expect_done(box,
              {"march", "truth.toml", "--release", "2:50um", "--duration", "3s", "--sampling-rate",
               "4096Hz", "--no-error-estimate", "--out", "march.csv", "--quiet"});
  const std::string marched = box.get("march.csv");
  box.put("blow.csv", marched.substr(0, marched.rfind('\n', marched.size() - 2) + 1));
  for (const std::size_t mode : {0, 2}) {  // tables of decays, too
    box.put(name_of(0, mode) + ".csv", measured(truth, mode, 0, 1.0, 0.0, Forcing::kModal));
  }
  const std::string plan = R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
draws = 200
forcing = "modal"
[[test]]
name = "monday1"
file = "monday1.csv"
use = "identify"
[[test]]
name = "monday3"
file = "monday3.csv"
use = "identify"
[[test]]
name = "blow"
file = "blow.csv"
use = "both"
kind = "ringdown"
mode = 2
sensors = { displacement = "p1" }
)";
  box.put("campaign.toml", test::replaced(plan, "forcing = \"modal\"\n", ""));
  expect_refused(box, kCall, {"blow", "ringdown", "a decay is not driven", "forcing = \"modal\""});
  box.put("campaign.toml", plan);
  expect_done(box, kCall);
  EXPECT_TRUE(box.has("found/blow_levels.csv"));
  for (const std::string quantity : {"frequency", "damping_ratio"}) {
    const auto [held, count] = inside(box, quantity);
    EXPECT_GE(count, 15.0) << quantity;
    EXPECT_GE(held, 0.9 * count) << quantity;
  }
  const std::vector<double> modes = table(box, "modal_levels.csv").numbers("mode", kDimensionless);
  EXPECT_GE(std::ranges::count(modes, 2.0), 15);
}

// A steady record by another program beside its levels: D of the 23rd level of the table, 0.5 % of
// noise in that, to 1 %.
TEST(campaign_of_a_model, TakesASteadyRecord) {
  const std::string folder = MICROSLIP_TEST_DATA "/two_joints/";
  std::string model = test::get(folder + "model.toml");
  for (int i = 1; i <= 6; ++i) {
    model += fmt::format("[[accelerometer]]\nchannel = \"acc{}\"\npoint = \"{}\"\n", i,
                         i == 1 ? "drive" : fmt::format("p{}", i));
  }
  const Sandbox box{{"model.toml", model},
                    {"levels.csv", test::get(folder + "modal_levels.csv")},
                    {"steady.csv", test::get(folder + "recordings/mode2_level10.csv")},
                    {"modal.toml", R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
forcing = "modal"
[[test]]
name = "steady"
file = "steady.csv"
use = "identify"
)"},
                    {"campaign.toml", R"(schema = "microslip.campaign/1"
model = "model.toml"
[[test]]
name = "table"
file = "levels.csv"
use = "identify"
[[test]]
name = "steady"
file = "steady.csv"
use = "identify"
)"}};
  expect_refused(box, {"campaign", "modal.toml", "--out", "found"},
                 {"steady", "a steady record is driven", "forcing = \"excitation\""});
  expect_done(box, kCall);
  EXPECT_TRUE(box.has("found/steady_levels.csv"));
  const CsvTable rows = table(box, "campaign.csv");
  EXPECT_EQ(rows.text("test").back(), "steady");
  EXPECT_EQ(rows.numbers("mode", kDimensionless).back(), 2.0);
  const double measured_loss = rows.numbers("dissipation", kEnergy).back();
  EXPECT_NEAR(rows.numbers("dissipation_predicted", kEnergy).back() / measured_loss, 1.0, 0.01);
}

// Of one test per mode too few are left for two joints: said, and the rest is there.
TEST(campaign_of_a_model, SaysWhereTheOthersAreTooFew) {
  const Laboratory box;
  box.put("campaign.toml", R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
draws = 100
leave_one_out = "tests"
[[test]]
name = "monday2"
file = "monday2.csv"
use = "identify"
[[test]]
name = "few"
file = "few.csv"
use = "identify"
)");
  const std::string all = box.get("monday3.csv");
  std::size_t end = 0;
  for (int line = 0; line < 5; ++line) end = all.find('\n', end) + 1;
  box.put("few.csv", all.substr(0, end));  // four levels, and eight are needed
  const Outcome run = box.run(kCall);
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.out.find("without monday2 nothing was found"), std::string::npos) << run.out;
  const CsvTable left_out = table(box, "leave_one_out.csv");
  EXPECT_EQ(left_out.text("verdict").front(), "not_found");
  EXPECT_EQ(left_out.text("contradicts").front(), "no");
}

// What a campaign of several joints cannot do is refused by name, with what does it.
TEST(campaign_of_a_model, SaysWhatItCannotDo) {
  const Laboratory box;
  box.put("levels.csv", "amplitude [m],dissipation [J]\n1e-5,1e-6\n2e-5,6e-6\n");
  box.put("sweep.csv",
          "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n46,1,1,0.3\n47,1,2,1.6\n");
  const std::string plan = campaign("", "predict");
  const auto refused = [&](const std::string& before, const std::string& after,
                           const std::vector<std::string>& parts) {
    box.put("campaign.toml", test::replaced(plan, before, after));
    SCOPED_TRACE(after);
    expect_refused(box, kCall, parts);
  };
  refused("draws = 200", "smoothing = \"gcv\"", {"identification.smoothing", "one joint"});
  refused("draws = 200", "stiffness_N_per_m = 1e5", {"stiffness_N_per_m", "model.toml"});
  refused("draws = 200", "draws = 50", {"draws", "from 100"});
  refused("session_offsets = true", "session_offsets = true\nfrequency = \"absolute\"",
          {"session_offsets", "absolute", "change"});
  refused("session_offsets = true", "stiffness = \"fit\"", {"stiffness", "absolute"});
  refused("session_offsets = true", "harmonics = 0", {"harmonics", "1 to 100"});
  box.put("campaign.toml", R"(schema = "microslip.campaign/1"
model = "model.toml"
[identification]
draws = 100
leave_one_out = "modes"
[[test]]
name = "monday1"
file = "monday1.csv"
use = "identify"
)");
  expect_refused(box, kCall, {"leave_one_out", "modes", "of one mode"});
  refused("file = \"monday1.csv\"", "file = \"levels.csv\"",
          {"monday1", "a table of levels", "identify"});
  refused("file = \"monday1.csv\"", "file = \"sweep.csv\"",
          {"monday1", "stepped-sine", "modal_levels.csv"});
  refused("file = \"monday3.csv\"", "file = \"monday3.csv\"\nkind = \"loops\"",
          {"kind", "one joint", "verify"});
  box.put("bare.csv", "displacement [m],frequency [Hz],dissipation [J]\n1e-5,50,1e-6\n");
  box.put("empty.csv", "");
  refused("file = \"monday1.csv\"", "file = \"bare.csv\"",
          {"monday1", "bare.csv", "lacks the column 'mode [1]'"});
  refused("file = \"monday1.csv\"", "file = \"empty.csv\"", {"monday1", "empty.csv", "is empty"});
  refused("file = \"monday1.csv\"", "file = \"model.toml\"",
          {"monday1", "a structure with joints"});
  refused("model = \"model.toml\"", "model = \"levels.csv\"", {"must be a model.toml"});
  refused("model = \"model.toml\"", "model = \"model.toml\"\nstructure = \"model.toml\"",
          {"model", "with structure"});
}

}  // namespace
}  // namespace microslip::cli_test::campaign_model_test
