// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/comparison_results.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/workflow/compare/comparison_table.hpp"
#include "microslip/workflow/results/comparison_input.hpp"
#include "support/messages.hpp"

namespace microslip::comparison_results_test {
namespace {

using namespace std::string_literals;

/// Two of three values of force in a band of 95 %, and a warning of the test.
VerifiedTests verified(bool drawn) {
  ComparedCurve force{.quantity = "force",
                      .dimension = kForce,
                      .axis = "frequency",
                      .axis_dimension = kFrequency,
                      .at = {10.0, 11.0, 12.0},
                      .measured = {1.0, 2.0, 3.0},
                      .predicted = {1.0, 2.0, 3.3},
                      .chance = 0.25};
  if (drawn) {
    force.lower = {0.9, 1.9, 3.1};
    force.upper = {1.1, 2.1, 3.5};
  }
  ComparedTest test{.source = "a.csv", .curves = {force}, .note = "phase: as it is"};
  if (drawn) test.taken = DrawsTaken{.options = {.count = 40}, .failures = {}};
  test.warnings = {{"draws_few", "take more."}};
  if (drawn) test.warnings.push_back({"few_inside", "2 of 3 values of force lie inside."});
  return {.heading = "microslip 0.1.0: microslip verify\nsha256[m.toml] = ab", .tests = {test}};
}

ComparisonFound read_back(bool drawn) {
  return comparison_of({"comparison.csv", comparison_table(verified(drawn))});
}

TEST(ComparisonResults, HoldWhatTheCommentsOfTheTableTell) {
  const ComparisonFound found = read_back(true);
  EXPECT_EQ(found.confidence, 0.95);
  ASSERT_EQ(found.warnings.size(), 2U);
  EXPECT_EQ(found.warnings[1].code, "few_inside");
  EXPECT_EQ(found.warnings[1].text, "a.csv: 2 of 3 values of force lie inside.");
  ASSERT_EQ(found.notes.size(), 2U);  // draws, and how the phase was taken: not call, nor hashes
  EXPECT_EQ(found.notes[0].first, "draws");
  EXPECT_EQ(found.notes[1], std::pair("a.csv"s, "phase: as it is"s));
  EXPECT_EQ(found.tests.at(0).curves.at(0).chance, 0.25);
}

// Names that look like what the program writes of itself lose nothing.
TEST(ComparisonResults, HaveTheNotesOfTestsOfAnyName) {
  for (const std::string name :
       {"microslip x.mat", "a sha256.csv", "b: warning: c.csv", "n = 1.csv"}) {
    VerifiedTests made = verified(false);
    made.tests[0].source = name;
    made.tests[0].failure = "no resonance";
    const ComparisonFound found = comparison_of({"comparison.csv", comparison_table(made)});
    ASSERT_EQ(found.notes.size(), 2U) << name;
    EXPECT_EQ(found.notes[0], std::pair(name, "NOT CONVERGED: no resonance"s));
    EXPECT_EQ(found.notes[1], std::pair(name, "phase: as it is"s));
  }
}

// A curve is marked whatever words the warning has.
TEST(ComparisonResults, NameCurvesWithFewInside) {
  VerifiedTests made = verified(true);
  made.tests[0].curves[0].few_inside = true;
  made.tests[0].curves.push_back(made.tests[0].curves[0]);
  made.tests[0].curves[1].quantity = "phase_lag";
  made.tests[0].curves[1].few_inside = false;
  const ComparisonFound found = comparison_of({"comparison.csv", comparison_table(made)});
  EXPECT_TRUE(found.tests.at(0).curves.at(0).few_inside);
  EXPECT_FALSE(found.tests.at(0).curves.at(1).few_inside);
}

TEST(ComparisonResults, RefuseSharesThatAreNone) {
  std::string text = comparison_table(verified(true));
  text.replace(text.find("confidence = 0.95"), 17, "confidence = 1.5");
  test::expect_message(test::message_or<FormatError>("none",
                                                     [&] {
                                                       (void)comparison_of({"c.csv", text});
                                                       return 0;
                                                     }),
                       "c.csv: expected confidence from 0 to 1 in the comments, found 1.5");
}

TEST(ComparisonResults, VerdictCountsTheValuesInside) {
  const std::string verdict = comparison_verdict(read_back(true));
  test::expect_message(verdict, "2 of 3 values of 1 test inside their bands, 3 expected");
  // rms of (3.3/3 − 1) and two zeros: 0.1/√3.
  test::expect_message(verdict, "force 5.8 %");
  test::expect_message(verdict, "Against it: few_inside");
  EXPECT_EQ(verdict.find("draws_few"), std::string::npos) << verdict;
}

TEST(ComparisonResults, VerdictWithoutDrawsSaysThatThereAreNoBands) {
  test::expect_message(comparison_verdict(read_back(false)),
                       "1 test, without bands to assess them (verify --draws)");
  ComparisonFound other = read_back(true);
  other.of_this_model = false;
  EXPECT_EQ(comparison_verdict(other),
            "not available: the comparison is of another joint or model");
}

TEST(ComparisonResults, CampaignsAreReadByTheirColumns) {
  CampaignFound found;
  add_campaign_table(
      {"campaign.csv",
       "# title = Plate, three torques\n"
       "# warning: code: what.\n"
       "test,use,session,condition_torque_Nm,part,source,amplitude [m],frequency [Hz],"
       "frequency_predicted [Hz],dissipation [J],dissipation_predicted [J],force_verdict,"
       "frequency_verdict\n"
       "a,identify,1,12,level,a.csv:1,1e-5,50,50.1,1e-6,2e-6,,\n"
       "b,predict,1,,peak,b.csv,,50,51,,,inside,outside\n"},
      found);
  EXPECT_EQ(found.title, "Plate, three torques");
  ASSERT_EQ(found.entries.size(), 2U);
  EXPECT_EQ(found.entries[0].conditions, "torque 12 Nm");
  EXPECT_EQ(found.entries[0].dissipation_predicted, 2e-6);
  EXPECT_EQ(found.entries[1].inside, 1U);
  EXPECT_EQ(found.entries[1].outside, 1U);
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_EQ(found.warnings[0].text, "what.");
  test::expect_message(test::message_or<FormatError>(
                           "none",
                           [&] {
                             add_sessions({"sessions.csv", "session,tests [1]\na,-1\n"}, found);
                             return 0;
                           }),
                       "sessions.csv:2:3: expected a count");
}

// The test named like a mode is a test. Without the column the names decide: earlier versions.
TEST(ComparisonResults, NameThePartsThatWereLeftOut) {
  const std::string cells = "1e-5,1e-6,1e-6,,,inside,0,,no\n";
  const auto entries = [&](const std::string& first, const std::vector<std::string>& names) {
    std::string text = first +
                       ",amplitude [m],measured [J],predicted [J],lower [J],upper [J],verdict,"
                       "mean_deviation [1],chance [1],contradicts\n";
    for (const std::string& name : names) text += name + "," + cells;
    CampaignFound found;
    add_left_out({"leave_one_out.csv", text}, found);
    return found.left_out;
  };
  const auto now = entries("left_out,part,test", {"mode 1,test,mode 1", "a: level 2,level,a"});
  EXPECT_EQ(now.at(0).part, "test");
  EXPECT_EQ(now.at(1).part, "level");
  EXPECT_EQ(now.at(1).test, "a");
  const auto earlier = entries("left_out,test", {"mode 1,mode 1", "a: level 2,a", "mode 2,a"});
  EXPECT_EQ(earlier.at(0).part, "test");
  EXPECT_EQ(earlier.at(1).part, "level");
  EXPECT_EQ(earlier.at(2).part, "mode");
}

TEST(ComparisonResults, CampaignsTellHowTestsRepeat) {
  CampaignFound found;
  add_sessions({"sessions.csv",
                "# repeatability_between_sessions = 0.02\n"
                "session,tests [1],levels [1],frequency_difference [1],"
                "frequency_difference_std [1],frequency_offset [1],"
                "frequency_offset_std [1],frequency_scatter [1],"
                "dissipation_offset [1],dissipation_scatter [1]\n"
                "a,1,2,0,0,0,0,0,0,0\n"},
               found);
  EXPECT_EQ(found.repeatability, "2 % from session to session");
}

}  // namespace
}  // namespace microslip::comparison_results_test
