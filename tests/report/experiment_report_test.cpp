// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/report/sections/experiment_report.hpp"
#include "report/support.hpp"

namespace microslip::experiment_report_test {
namespace {

using test::contains;
using test::input_fault;

constexpr double kStiffness = 1.0e5;  // N/m
constexpr std::size_t kLevels = 20;

Joint uniform_joint() {
  return {kStiffness, SlipDensity({UniformPart{.from = 0.0, .to = 40.0, .weight = 1.0}})};
}

/// Levels without noise up to kA = 30 N of 40.
MeasuredLevels exact_levels() {
  const Joint joint = uniform_joint();
  MeasuredLevels test;
  for (std::size_t i = 1; i <= kLevels; ++i) {
    const double a = 1.5e-5 * static_cast<double>(i);
    test.levels.amplitude.push_back(a);
    test.levels.dissipation.push_back(dissipation(joint, a));
    test.levels.secant_stiffness.push_back(secant_stiffness(joint, a));
    test.source.push_back("level " + std::to_string(i));
    test.flags.emplace_back(i == 3 ? "spike" : "");
    test.input_energy.push_back(2.0 * dissipation(joint, a));
    test.linear_dissipation.push_back(dissipation(joint, a));
  }
  return test;
}

ExperimentResults exact_results() {
  ExperimentResults results;
  results.title = "Test";
  results.levels = exact_levels();
  results.joint = IdentifiedJoint{.joint = uniform_joint(),
                                  .method = "inversion",
                                  .status = "converged",
                                  .from_these_levels = true,
                                  .covered_from = 1.5,
                                  .covered_to = 30.0,
                                  .band_confidence = 0.95,
                                  .band_slip_force = {0.0, 15.0, 30.0},
                                  .band_lower = {0.02, 0.02, 0.02},
                                  .band_upper = {0.03, 0.03, 0.03}};
  results.truth = uniform_joint();
  return results;
}

const ReportSection& section(const ReportDocument& document, std::string_view title) {
  return *std::ranges::find(document.sections, title, &ReportSection::title);
}

/// The first of that title, or the one of a section.
const ReportFigure& figure(const ReportDocument& document, std::string_view title,
                           std::string_view of = {}) {
  static const ReportFigure kNone;
  for (const ReportSection& part : document.sections) {
    if (!of.empty() && part.title != of) continue;
    for (const ReportBlock& block : part.blocks) {
      const auto* found = std::get_if<ReportFigure>(&block);
      if (found != nullptr && found->figure.title == title) return *found;
    }
  }
  ADD_FAILURE() << "no figure " << title;
  return kNone;
}

const ReportTable& table(const ReportDocument& document, std::string_view title) {
  static const ReportTable kNone;
  for (const ReportSection& part : document.sections) {
    for (const ReportBlock& block : part.blocks) {
      const auto* found = std::get_if<ReportTable>(&block);
      if (found != nullptr && found->title == title) return *found;
    }
  }
  ADD_FAILURE() << "no table " << title;
  return kNone;
}

const ReportFigure& figure(const ReportDocument&& document, std::string_view title,
                           std::string_view of = {}) = delete;

/// The points of a line, marks, bars or a band.
struct Drawn {
  std::vector<double> x;
  std::vector<double> y;  // the upper edge of a band
  bool shown = true;
};

Drawn drawn(const Layer& layer) {
  return std::visit(
      [](const auto& concrete) -> Drawn {
        if constexpr (requires { concrete.y; }) {
          return {concrete.x, concrete.y, concrete.shown};
        } else if constexpr (requires { concrete.upper; }) {
          return {concrete.x, concrete.upper, concrete.shown};
        } else {
          return {{concrete.x}, {}};
        }
      },
      layer);
}

Drawn trace(const ReportFigure& in, std::string_view name) {
  const std::vector<Layer>& layers = chosen_layers(in);
  const auto found = std::ranges::find(layers, name, name_of);
  if (found == layers.end()) throw std::runtime_error("no trace " + std::string(name));
  return drawn(*found);
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

std::vector<std::string> titles_of(const ReportDocument& document) {
  std::vector<std::string> titles;
  for (const ReportSection& part : document.sections) titles.push_back(part.title);
  return titles;
}

/// The missing parts that a document lists, with the commands that make them.
std::string missing_in(const ReportDocument& document) {
  std::string text;
  for (const ReportSection& part : document.sections) {
    for (const ReportBlock& block : part.blocks) {
      if (const auto* missing = std::get_if<ReportMissing>(&block)) {
        text += missing->text + " " + missing->command + "\n";
      }
    }
  }
  return text;
}

/// Everything that a test can leave behind.
ExperimentResults all_results() {
  ExperimentResults results = exact_results();
  results.levels->response_amplitude.assign(kLevels, 1.0);
  results.levels->force_amplitude.assign(kLevels, 2.0);
  results.levels->frequency.assign(kLevels, 55.0);
  results.levels->resonance_frequency.assign(kLevels, 55.1);
  results.records = {{"level_1", {{"force", "N", {0.0, 0.01}, {1.0, 2.0}, {}, {}}}, {}}};
  results.force_control = {{"1", 0.5, {0.03, 0.05}, {0.001, 0.002}}};
  results.responses = {{1.0, {54.0, 55.0}, {4.0, 2.0}, {54.0, 55.5}, {4.0, 2.5}}};
  results.backbone = {{1.5e-5, 3e-4}, {55.2, 54.0}, {0.002, 0.01}};
  results.true_backbone = results.backbone;
  results.comparisons = {{"a.csv", "force", "converged", 55.0, 1.0, 0.02, 0.001, 1.0, 0.0}};
  results.provenance = {{"seed", "1"}};
  results.files = {{"levels.csv", "ab", ""}};
  return results;
}

TEST(ExperimentReport, SectionsInTheirOrder) {
  const ReportDocument document = experiment_report(all_results());
  EXPECT_EQ(
      titles_of(document),
      (std::vector<std::string>{"Summary", "Levels", "Signals", "Energies", "Density", "Loops",
                                "Stiffness and damping", "Responses", "Prediction", "Provenance"}));
  EXPECT_EQ(missing_in(document), "");
  EXPECT_EQ(input_fault([&] { check_report(document); }), "no error");
}

TEST(ExperimentReport, WhatIsNotThereIsListedBeforeTheLastSection) {
  const ReportDocument document = experiment_report(exact_results());
  EXPECT_EQ(titles_of(document), (std::vector<std::string>{
                                     "Summary", "Levels", "Energies", "Density", "Loops",
                                     "Stiffness and damping", "Not in this report", "Provenance"}));
  const std::string missing = missing_in(document);
  for (const std::string part :
       {"recordings level_*", "measure rig.toml --out DIR --before-control",
        "No frequency responses", "microslip verify rig.toml joint.json"}) {
    EXPECT_TRUE(contains(missing, part)) << part << " is not in\n" << missing;
  }
}

// Parts that only a virtual test can supply are not advised for a real one.
TEST(ExperimentReport, ARealTestIsNotToldToBeMadeAgain) {
  ExperimentResults results = exact_results();
  results.truth.reset();
  EXPECT_FALSE(contains(missing_in(experiment_report(results)), "microslip measure"));
}

TEST(ExperimentReport, NothingAtAllSaysWhatMakesEachPart) {
  const ReportDocument document = experiment_report({.title = "Empty"});
  EXPECT_EQ(input_fault([&] { check_report(document); }), "no error");
  EXPECT_EQ(titles_of(document),
            (std::vector<std::string>{"Summary", "Not in this report", "Provenance"}));
  const std::string missing = missing_in(document);
  for (const std::string part : {"microslip identify", "microslip reduce", "microslip verify"}) {
    EXPECT_TRUE(contains(missing, part)) << part << " is not in\n" << missing;
  }
}

// The levels are those of the joint: differences are rounding of D, a few units of its last digit.
TEST(ExperimentReport, ResidualsOfTheExactJointVanish) {
  const ReportDocument document = experiment_report(exact_results());
  const ReportFigure& residuals = figure(document, "Residuals of D");
  EXPECT_EQ(trace(residuals, "levels").y.size(), kLevels);
  EXPECT_LT(largest(trace(residuals, "levels").y), 1e-12);  // %
}

TEST(ExperimentReport, EnergiesAreInMillijoulesOverMicrometres) {
  const ExperimentResults results = exact_results();
  const ReportDocument document = experiment_report(results);
  const ReportFigure& energies = figure(document, "Energies per cycle");
  const Drawn input = trace(energies, "input energy");
  EXPECT_DOUBLE_EQ(input.x.back(), 300.0);
  EXPECT_DOUBLE_EQ(input.y.back(), 1e3 * results.levels->input_energy.back());
  EXPECT_EQ(energies.figure.x.unit, "µm");
  EXPECT_EQ(energies.figure.y.unit, "mJ");
  const ReportFigure& share = figure(document, "Share of the linear loss");
  EXPECT_DOUBLE_EQ(trace(share, "linear loss").y[0], 50.0);
}

// φ of the uniform joint is 1/40 N everywhere; D′ = 4Φ1(kA) = 2 (kA)²/40 N.
TEST(ExperimentReport, DensityAndSlopeOfAUniformJoint) {
  const ReportDocument document = experiment_report(exact_results());
  const ReportFigure& density = figure(document, "Slip-force density", "Density");
  for (const double value : trace(density, "truth").y) EXPECT_DOUBLE_EQ(value, 0.025);
  EXPECT_EQ(trace(density, "95 % band").x, (std::vector{15.0, 30.0}));  // not below 0.9 kA_min
  EXPECT_FALSE(trace(density, "differences").shown);
  const ReportFigure& slope = figure(document, "Slope of the dissipation");
  EXPECT_NEAR(trace(slope, "identified joint").y.back(), 2.0 * 30.0 * 30.0 / 40.0, 1e-9);
  // Between levels h = 15 µm apart the slope of the quadratic D′ is right to k²h²/(6·40) N = 9e-3
  // N.
  const Drawn differences = trace(slope, "differences");
  const double middle = 1e-6 * differences.x.back() * kStiffness;
  EXPECT_NEAR(differences.y.back(), 2.0 * middle * middle / 40.0, 1e-2);
}

// Levels and truth are matched by the file names of their records.
TEST(ExperimentReport, ErrorOfTheReductionWhereTheTruthIsKnown) {
  ExperimentResults results = exact_results();
  MeasuredLevels exact = exact_levels();
  results.levels->source[7] = "there/level 8";
  results.levels->source[3] = "another";
  results.levels->levels.dissipation[7] *= 1.02;
  std::ranges::reverse(exact.source);
  std::ranges::reverse(exact.levels.amplitude);
  std::ranges::reverse(exact.levels.dissipation);
  exact.levels.secant_stiffness.clear();
  results.true_levels = exact;
  const ReportDocument document = experiment_report(results);
  const Drawn error = trace(figure(document, "Error of the reduction"), "D");
  ASSERT_EQ(error.x.size(), kLevels - 1);
  EXPECT_NEAR(error.y[6], 2.0, 1e-12);  // %
  EXPECT_NEAR(error.y[5], 0.0, 1e-12);
}

TEST(ExperimentReport, LoopsAreClosedAndOfTheDissipation) {
  const ReportDocument document = experiment_report(exact_results());
  const ReportFigure& loops = figure(document, "Regenerated loops");
  ASSERT_EQ(loops.choices.size(), 4);
  EXPECT_EQ(loops.choices[0].name, "300 µm");
  EXPECT_EQ(loops.choices[2].name, "150 µm");
  ASSERT_EQ(loops.choices[0].layers.size(), 5);  // identified, three splines, truth
  const Drawn loop = trace(loops, "identified joint");
  double area = 0.0;
  for (std::size_t i = 0; i < loop.x.size(); ++i) {
    const std::size_t next = (i + 1) % loop.x.size();
    area += 0.5 * (loop.y[i] + loop.y[next]) * (loop.x[next] - loop.x[i]) * 1e-6;
  }
  // The trapezoidal rule with 120 steps a branch is right to about 1/120².
  EXPECT_NEAR(std::abs(area), dissipation(uniform_joint(), 3e-4),
              1e-4 * dissipation(uniform_joint(), 3e-4));
  EXPECT_EQ(largest(trace(figure(document, "Difference to the identified joint"), "truth").y), 0.0);
}

// λ along the path: the degrees of freedom grow as λ falls, and the chosen one is the joint's.
TEST(ExperimentReport, DensitiesAlongThePath) {
  const ReportDocument document = experiment_report(exact_results());
  const ReportFigure& path = figure(document, "Density along the path");
  ASSERT_EQ(path.figure.layers.size(), 5);
  double last = 0.0;
  for (const Layer& one : path.figure.layers) {
    const std::size_t comma = name_of(one).find(", ");
    const double freedom = std::stod(name_of(one).substr(comma + 2));
    EXPECT_GE(freedom, last) << name_of(one);
    last = freedom;
  }
  EXPECT_TRUE(contains(name_of(path.figure.layers[2]), "chosen λ"));
}

// A joint identified with a fixed λ is compared with others by that λ.
TEST(ExperimentReport, TheOptionsOfTheJointAreThoseOfThePath) {
  ExperimentResults results = exact_results();
  results.options.inversion.lambda = 12.5;
  const ReportDocument document = experiment_report(results);
  const ReportFigure& path = figure(document, "Path of the smoothing parameter");
  EXPECT_TRUE(contains(name_of(path.figure.layers[1]), "chosen: λ = 12.5,"))
      << name_of(path.figure.layers[1]);
}

// βA² with β = 50 J/m² on top of the exact D.
TEST(ExperimentReport, LinearDampingIsShownAndTakenOff) {
  constexpr double kBeta = 50.0;
  ExperimentResults results = exact_results();
  results.joint->linear_damping = kBeta;
  Levels& levels = results.levels->levels;
  for (std::size_t i = 0; i < kLevels; ++i) {
    levels.dissipation[i] += kBeta * std::pow(levels.amplitude[i], 2);
  }
  const ReportDocument document = experiment_report(results);
  const ReportFigure& energies = figure(document, "Energies per cycle");
  const double total = trace(energies, "with damping βA²").y.back();
  EXPECT_NEAR(total - trace(energies, "identified joint").y.back(), 1e3 * kBeta * 9e-8,
              1e-12);  // mJ
  EXPECT_NEAR(total, 1e3 * levels.dissipation.back(), 1e-9);
  EXPECT_LT(largest(trace(figure(document, "Residuals of D"), "levels").y), 1e-10);  // %
  const ReportFigure& loss = figure(document, "Loss factor of the joint");
  EXPECT_NEAR(trace(loss, "measured").y[0], trace(loss, "identified joint").y[0], 1e-12);
}

std::string summary_text(const ReportDocument& document) {
  std::string text;
  for (const ReportBlock& block : section(document, "Summary").blocks) {
    if (const auto* paragraph = std::get_if<ReportText>(&block)) text += paragraph->text + "\n";
    if (const auto* warnings = std::get_if<ReportWarnings>(&block)) {
      for (const Warning& one : warnings->warnings) text += one.code + ": " + one.text + "\n";
    }
    if (const auto* facts = std::get_if<ReportFacts>(&block)) {
      for (const auto& [name, value] : facts->facts) text += name + " = " + value + "\n";
    }
  }
  return text;
}

// φ = 1/40 1/N up to 40 N: up to 30 N three quarters of k slip, all of it beyond.
TEST(ExperimentReport, TellsWhatSlipsInTheCoveredRange) {
  ExperimentResults results = exact_results();
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "75.0 % of its stiffness slips at slip forces up to 30 N. The levels"))
      << text;
  results.joint->covered_to = 40.0;
  const std::string all = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(all, "100.0 % of its stiffness slips at slip forces up to 40 N.\n")) << all;
}

/// The block of the summary that comes first.
ReportVerdict verdict_of(const ExperimentResults& results) {
  const ReportDocument document = experiment_report(results);
  return std::get<ReportVerdict>(section(document, "Summary").blocks.front());
}

// The density, the verdict on it, the valid range of predictions and the warnings stand
// before all else.
TEST(ExperimentReport, BeginsWithVerdictDensityReachAndWarnings) {
  ExperimentResults results = exact_results();
  const ReportDocument document = experiment_report(results);
  const std::vector<ReportBlock>& blocks = section(document, "Summary").blocks;
  EXPECT_FALSE(std::get<ReportVerdict>(blocks[0]).doubtful);
  EXPECT_EQ(std::get<ReportVerdict>(blocks[0]).codes, std::vector<std::string>{"levels_flagged"});
  const auto& density = std::get<ReportFigure>(blocks[1]);
  EXPECT_EQ(density.figure.y.unit, "1/N");
  EXPECT_EQ(trace(density, "95 % band").y.size(), 2U);
  EXPECT_TRUE(std::get<ReportFacts>(blocks[2]).prominent);
  EXPECT_TRUE(std::get<ReportFacts>(blocks[3]).beside);
  EXPECT_TRUE(std::get<ReportWarnings>(blocks[4]).beside);
}

TEST(ExperimentReport, SaysWhatTheLevelsWereTestedFor) {
  ExperimentResults results = exact_results();
  EXPECT_TRUE(contains(verdict_of(results).text, "Not tested whether"));
  results.joint->verdicts = {{"secant_against_dissipation", 0.001, 0.002, false},
                             {"frequency_against_dissipation", 0.001, 0.002, false}};
  EXPECT_TRUE(contains(verdict_of(results).text, "2 departures looked for, none found"));
  EXPECT_FALSE(verdict_of(results).doubtful);
  results.joint->verdicts[1].broken = true;
  EXPECT_TRUE(contains(verdict_of(results).text, "the frequency does not fall as D implies"));
  EXPECT_TRUE(verdict_of(results).doubtful);
  results.joint->verdicts.clear();
  results.joint->status = "no_progress";
  EXPECT_TRUE(contains(verdict_of(results).text, "did not converge (no_progress)"));
  EXPECT_TRUE(verdict_of(results).doubtful);
}

// Up to kA = 30 N of 40 three quarters of k slip.
TEST(ExperimentReport, SaysHowFarPredictionsReach) {
  ExperimentResults results = exact_results();
  results.levels->force_amplitude.assign(kLevels, 2.0);
  results.levels->force_amplitude[0] = 0.5;
  results.levels->response_amplitude.assign(kLevels, std::nan(""));
  std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "joint amplitude = 15 to 300 µm, 20 levels")) << text;
  EXPECT_TRUE(contains(text, "force of the exciter = 0.5 to 2 N")) << text;
  EXPECT_TRUE(contains(text, "response = not measured")) << text;
  EXPECT_TRUE(contains(text, "larger motions = not available: 25.0 % of k did not slip")) << text;
  EXPECT_TRUE(contains(text, "error of predictions = not verified")) << text;
  results.joint->from_these_levels = false;
  results.joint->covered_to = 40.0;
  text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "joint amplitude = 15 to 400 µm\n")) << text;
  EXPECT_TRUE(contains(text, "larger motions = known: all of the stiffness has slipped")) << text;
  results.joint->covered_from.reset();
  text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "joint amplitude = not given in its file")) << text;
}

TEST(ExperimentReport, ShowsAtoms) {
  ExperimentResults results = exact_results();
  results.joint->joint = {kStiffness,
                          SlipDensity({UniformPart{0.0, 20.0, 0.5},
                                       AtomsPart{.slip_force = {25.0}, .weight = {0.25}}})};
  const ReportDocument document = experiment_report(results);
  EXPECT_TRUE(contains(summary_text(document), "slips at once = 25.0 % at 25 N"))
      << summary_text(document);
  const ReportFigure& density = figure(document, "Slip-force density");
  EXPECT_EQ(trace(density, "atom").x, std::vector<double>{25.0});
  EXPECT_TRUE(contains(density.figure.caption, "An atom")) << density.figure.caption;
}

// Three levels are too few for the methods.
TEST(ExperimentReport, LoopsSayNothingOfSplinesThatAreNotDrawn) {
  ExperimentResults results = exact_results();
  const ReportDocument whole = experiment_report(results);
  EXPECT_TRUE(contains(figure(whole, "Regenerated loops").figure.caption, "spline"));
  const Levels all = results.levels->levels;
  results.levels = MeasuredLevels{};
  for (std::size_t i = 0; i < 3; ++i) {
    results.levels->levels.amplitude.push_back(all.amplitude[i]);
    results.levels->levels.dissipation.push_back(all.dissipation[i]);
  }
  const ReportDocument few = experiment_report(results);
  EXPECT_FALSE(contains(figure(few, "Regenerated loops").figure.caption, "spline"));
}

TEST(ExperimentReport, AParametricModelHasNoSmoothing) {
  ExperimentResults results = exact_results();
  results.joint->scatter = 0.02;
  results.joint->lambda = 1.0;
  results.joint->parameters = {{"macroslip_force", 8.0, 0.1}};
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "macroslip_force = 8 ± 0.1 N")) << text;
  EXPECT_FALSE(contains(text, "smoothing = ")) << text;
  EXPECT_FALSE(contains(text, "scatter of its levels")) << text;
}

TEST(ExperimentReport, SaysWhatWasNotExaminedWhereNothingWarns) {
  ExperimentResults results = exact_results();
  results.levels->flags.clear();
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "was identified by inversion from 20 levels")) << text;
  EXPECT_TRUE(contains(text, "No warning and no flag. Not examined: ")) << text;
}

// A joint written by hand beside levels that it has nothing to do with.
TEST(ExperimentReport, AJointThatNobodyIdentifiedIsNotCalledIdentified) {
  ExperimentResults results = exact_results();
  results.levels->flags.clear();
  results.joint =
      IdentifiedJoint{.joint = Joint(kStiffness, SlipDensity(std::vector<DensityPart>{})),
                      .status = "not given in the file"};
  const std::string text = summary_text(experiment_report(results));
  EXPECT_FALSE(contains(text, "kN/m was identified")) << text;
  EXPECT_FALSE(contains(text, "No warning")) << text;
  EXPECT_FALSE(contains(text, "scatter of")) << text;
  EXPECT_TRUE(contains(text, "does not state the method")) << text;
  EXPECT_TRUE(contains(text, "joint_of_unknown_origin")) << text;
  EXPECT_TRUE(contains(
      text, "joint_misses_levels: D of the joint differs from that of the levels by 100.0 % of D"))
      << text;
}

TEST(ExperimentReport, AJointChangedAfterItsIdentificationIsWarnedOf) {
  ExperimentResults results = exact_results();
  const double k = results.joint->joint.stiffness();
  results.joint->from_these_levels = true;
  results.joint->joint = Joint(2.0 * k, results.joint->joint.density());
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "joint_misses_levels")) << text;
  EXPECT_TRUE(contains(text, "was changed after identification")) << text;
  EXPECT_TRUE(contains(text, "Not examined: whether the stuck stiffness")) << text;
}

TEST(ExperimentReport, AFrequencyThatRisesIsNotThatOfAJointThatSoftens) {
  ExperimentResults results = exact_results();
  std::vector<double>& frequency = results.levels->frequency;
  frequency.assign(results.levels->levels.size(), 80.0);
  EXPECT_FALSE(contains(summary_text(experiment_report(results)), "frequency_rises"));
  frequency.back() = 80.2;  // as a drive in steps may
  EXPECT_FALSE(contains(summary_text(experiment_report(results)), "frequency_rises"));
  frequency.front() = 80.4;
  frequency.back() = 80.32;
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "frequency_rises: The frequency rises by 0.40 %")) << text;
}

TEST(ExperimentReport, FlagsOfPredictionsAreWarnings) {
  ExperimentResults results = exact_results();
  results.comparisons = {
      {.source = "a", .channel = "force", .status = "converged", .flags = "resonance_off"},
      {.source = "a", .channel = "acc", .status = "converged", .flags = "resonance_off"},
      {.source = "b", .channel = "force", .status = "no_progress"}};
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text, "resonance_off: 1 of 2 predicted records: the predicted resonance"))
      << text;
  EXPECT_TRUE(contains(text, "prediction_not_converged: 1 of 2 predicted records")) << text;
}

TEST(ExperimentReport, ScatterAndSmoothingAreThoseThatTheJointTells) {
  ExperimentResults results = exact_results();
  results.joint->from_these_levels = false;
  results.joint->scatter = 37.9;
  results.joint->scatter_is_relative = false;
  results.joint->secant_scatter = 0.38;
  results.joint->lambda = 0.172;
  results.joint->degrees_of_freedom = 12.0;
  results.joint->smoothing = "as specified";
  const std::string text = summary_text(experiment_report(results));
  EXPECT_TRUE(contains(text,
                       "scatter of its levels = D 37.90 times the given standard deviations, k_eq "
                       "0.38 of its own"))
      << text;
  EXPECT_TRUE(contains(text, "smoothing = λ = 0.172, 12.0 degrees of freedom (as specified)"))
      << text;
  EXPECT_TRUE(contains(text, "according to its file not from the levels below")) << text;
  EXPECT_FALSE(contains(text, "levels = 20")) << text;
}

TEST(ExperimentReport, PredictionsOfAnotherJointAreNotItsError) {
  ExperimentResults results = exact_results();
  results.comparisons = {{"a.csv", "force", "converged", 55.0, 1.0, 0.02, 0.001, 1.01, 0.003}};
  results.predictions_are_of_this_joint = false;
  const ReportDocument document = experiment_report(results);
  const std::string text = summary_text(document);
  EXPECT_TRUE(contains(text, "error of predictions = not available")) << text;
  const auto& first = std::get<ReportText>(section(document, "Prediction").blocks[0]);
  EXPECT_TRUE(contains(first.text, "another joint or rig")) << first.text;
}

/// A sweep whose peak lies outside of its band.
ComparisonFound compared_sweep() {
  ComparedCurve force{.quantity = "force", .dimension = kForce};
  force.axis = "frequency";
  force.axis_dimension = kFrequency;
  force.at = {50.0, 51.0};
  force.measured = {1.0, 2.0};
  force.predicted = {1.0, 1.5};
  force.lower = {0.9, 1.4};
  force.upper = {1.1, 1.6};
  ComparedCurve peak = force;
  force.few_inside = true;
  peak.part = TestPart::kPeak;
  for (auto* values : {&peak.at, &peak.measured, &peak.predicted, &peak.lower, &peak.upper}) {
    values->erase(values->begin());
  }
  return {
      .tests = {{.source = "a.csv", .kind = TestKind::kConstantResponse, .curves = {force, peak}}},
      .warnings = {{"few_inside", "a.csv: 1 of 2 values of force lie inside."}},
      .confidence = 0.95};
}

TEST(ExperimentReport, TestsAgainstAModelAreTheErrorOfPredictions) {
  ExperimentResults results = exact_results();
  results.comparison = compared_sweep();
  const ReportDocument document = experiment_report(results);
  const std::string text = summary_text(document);
  EXPECT_TRUE(contains(text, "predictions against tests = 1 of 3 values of 1 test inside")) << text;
  EXPECT_TRUE(contains(text, "few_inside")) << text;
  EXPECT_FALSE(contains(text, "compared with no record")) << text;
  const ReportSection& shown = section(document, "Tests against the model");
  std::vector<const ReportTable*> tables;
  for (const ReportBlock& block : shown.blocks) {
    if (const auto* table = std::get_if<ReportTable>(&block)) tables.push_back(table);
  }
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0]->marked, std::vector<std::size_t>{0});  // few_inside of its force
  ASSERT_EQ(tables[1]->rows.size(), 1U);                      // the peak; steps are in the figure
  EXPECT_EQ(std::get<std::string>(tables[1]->rows[0].back()), "outside");
  EXPECT_EQ(std::get<std::string>(tables[1]->rows[0][6]), "1.4 N to 1.6 N");
}

TEST(ExperimentReport, AComparisonMayBeAllThereIs) {
  ExperimentResults results;
  results.comparison = compared_sweep();
  const ReportDocument document = experiment_report(results);
  const auto& verdict = std::get<ReportVerdict>(document.sections.front().blocks.front());
  EXPECT_TRUE(verdict.doubtful);
  EXPECT_TRUE(contains(verdict.text, "1 of 3 values of 1 test inside")) << verdict.text;
  results.comparison->of_this_model = false;
  const ReportDocument foreign = experiment_report(results);
  EXPECT_TRUE(contains(std::get<ReportVerdict>(foreign.sections.front().blocks.front()).text,
                       "another joint or model"));
}

TEST(ExperimentReport, ACampaignShowsTestsSessionsAndWhatWasLeftOut) {
  ExperimentResults results = exact_results();
  CampaignFound campaign;
  campaign.entries = {{.test = "a", .use = "identify", .session = "1", .part = "level"},
                      {.test = "b", .use = "predict", .session = "1", .part = "peak", .inside = 2}};
  campaign.entries[0].amplitude = 1e-5;
  campaign.entries[0].dissipation = 1.1e-6;
  campaign.entries[0].dissipation_predicted = 1e-6;
  campaign.sessions = {{.name = "1", .tests = 1, .levels = 1}};
  campaign.conditions = {
      {{.name = "torque_Nm",
        .groups = {{.value = "20", .tests = 1, .levels = 1, .dissipation = {0.0, 0.01}},
                   {.value = "25", .tests = 1, .levels = 1, .dissipation = {0.05, 0.01}}}},
       "D +1 ± 0.2 % per unit of torque_Nm"},
      {{.name = "order", .groups = {{.value = "rising", .tests = 2, .levels = 2}}}}};
  campaign.left_out = {{.left_out = "a",
                        .part = "test",
                        .test = "a",
                        .amplitude = 1e-5,
                        .measured = 1.1e-6,
                        .predicted = 1e-6,
                        .lower = 0.9e-6,
                        .upper = 1.05e-6,
                        .verdict = "outside",
                        .mean_deviation = 0.0953,
                        .chance = 0.01,
                        .contradicts = true}};
  results.campaign = campaign;
  const ReportDocument document = experiment_report(results);
  std::vector<std::string> titles;
  for (const ReportBlock& block : section(document, "Campaign").blocks) {
    if (const auto* table = std::get_if<ReportTable>(&block)) titles.push_back(table->title);
    if (const auto* figure = std::get_if<ReportFigure>(&block)) {
      titles.push_back(figure->figure.title);
    }
  }
  EXPECT_EQ(titles, (std::vector<std::string>{
                        "Dissipation against the joint", "Tests of the campaign", "Sessions",
                        "Conditions", "Effect of conditions", "Left-out dissipation", "Left out"}));
  const ReportTable& conditions = table(document, "Effect of conditions");
  EXPECT_EQ(conditions.marked, std::vector<std::size_t>{0});  // 5 % apart, 3.5 σ of a difference
  EXPECT_EQ(std::get<std::string>(conditions.rows[0][0]), "torque [Nm]");
  EXPECT_EQ(std::get<std::string>(conditions.rows[0][1]), "D +1 ± 0.2 % per unit of torque_Nm");
  EXPECT_EQ(std::get<std::string>(conditions.rows[0][2]), "no");
  EXPECT_TRUE(contains(std::get<std::string>(conditions.rows[0][3]), "D at 25 differs by +5"));
  EXPECT_TRUE(contains(std::get<std::string>(conditions.rows[1][3]), "one value"));
  check_report(document);
}

TEST(ExperimentReport, ACampaignOfAModelShowsModes) {
  ExperimentResults results = exact_results();
  CampaignFound campaign{.of_model = true};
  for (const double mode : {1.0, 2.0}) {
    CampaignEntry entry{.test = "a", .use = "identify", .session = "1", .part = "level"};
    entry.mode = mode;
    entry.amplitude = 1e-5;
    entry.dissipation = 1.1e-6;
    entry.dissipation_predicted = 1e-6;
    campaign.entries.push_back(entry);
    campaign.sessions.push_back(
        {.name = "1", .mode = static_cast<std::size_t>(mode), .tests = 1, .levels = 1});
  }
  results.campaign = campaign;
  const ReportDocument document = experiment_report(results);
  const auto& lead = std::get<ReportText>(section(document, "Campaign").blocks.front());
  EXPECT_TRUE(contains(lead.text, "2 modal levels of 1 test identify its joints, in 1 session"))
      << lead.text;
  const ReportFigure& losses = figure(document, "Dissipation against the joints");
  ASSERT_EQ(losses.figure.layers.size(), 2U);
  EXPECT_EQ(std::get<PointLayer>(losses.figure.layers[1]).legend, "session 1, mode 2");
  const ReportTable& sessions = table(document, "Sessions");
  EXPECT_EQ(sessions.columns[1].name, "mode");
  EXPECT_EQ(std::get<double>(sessions.rows[1][1]), 2.0);
  check_report(document);
}

/// Two joints from two tests of a campaign, of which the second is left out with D 20 % off; the
/// others predict two of its three levels.
ExperimentResults contradicted_results() {
  ExperimentResults results;
  results.title = "Test";
  results.calibration =
      CalibrationSummary{.status = "converged",
                         .levels = 6,
                         .levels_found = 6,
                         .scatter = 0.09,
                         .joints = {{.name = "lap", .stiffness = 1e5, .covered_to = 2.0},
                                    {.name = "other", .stiffness = 1e5, .covered_to = 2.0}},
                         .pairs = {{.first = "lap", .second = "other"}},
                         .warnings = {{"left_out_contradicts", "friday contradicts the others."}}};
  for (const char* joint : {"lap", "other"}) {
    results.densities.push_back({.name = joint,
                                 .slip_force = {0.0, 2.0},
                                 .density = {0.1, 0.1},
                                 .variance_reduction = {1.0, 1.0}});
  }
  results.comparison = compared_sweep();
  results.comparison->warnings.insert(results.comparison->warnings.begin(),
                                      results.calibration->warnings.front());
  CampaignFound& campaign = results.campaign.emplace(CampaignFound{.of_model = true});
  campaign.warnings = results.calibration->warnings;
  for (const char* test : {"monday", "friday"}) {
    campaign.entries.push_back({.test = test, .use = "identify", .session = "1", .part = "level"});
    for (const double amplitude : {1e-6, 5e-6, 2e-5}) {
      const bool wrong = campaign.entries.back().test == "friday";
      const bool beyond = wrong && amplitude > 1e-5;
      campaign.left_out.push_back({.left_out = test,
                                   .part = "test",
                                   .test = test,
                                   .amplitude = amplitude,
                                   .measured = wrong ? 1.2e-6 : 1e-6,
                                   .predicted = beyond ? std::nan("") : 1e-6,
                                   .lower = 0.9e-6,
                                   .upper = 1.1e-6,
                                   .verdict = beyond  ? "beyond"
                                              : wrong ? "outside"
                                                      : "inside",
                                   .mean_deviation = wrong ? std::log(1.2) : 0.0,
                                   .chance = wrong ? 0.0 : 1.0,
                                   .contradicts = wrong});
    }
  }
  return results;
}

/// The warnings of a document, section after section.
std::vector<std::string> warned_of(const ReportDocument& document) {
  std::vector<std::string> codes;
  for (const ReportSection& part : document.sections) {
    for (const ReportBlock& block : part.blocks) {
      const auto* warnings = std::get_if<ReportWarnings>(&block);
      if (warnings == nullptr) continue;
      for (const Warning& warning : warnings->warnings) codes.push_back(warning.code);
    }
  }
  return codes;
}

TEST(ExperimentReport, AContradictionIsOnTheFirstScreen) {
  ExperimentResults results = contradicted_results();
  const ReportDocument document = experiment_report(results);
  const auto& verdict = std::get<ReportVerdict>(document.sections.front().blocks.front());
  EXPECT_TRUE(verdict.doubtful);
  EXPECT_EQ(verdict.text,
            "1 of 2 tests contradicts the others, 0.1 would by chance: friday, D +20 %. The levels "
            "determine each density.");
  EXPECT_TRUE(contains(summary_text(document), "contradict the others = 1 of 2 tests"))
      << summary_text(document);
  check_report(document);
  for (LeftOutEntry& entry : results.campaign->left_out) entry.contradicts = false;
  const ReportDocument agreed = experiment_report(results);
  const auto& good = std::get<ReportVerdict>(agreed.sections.front().blocks.front());
  EXPECT_FALSE(good.doubtful);
  EXPECT_EQ(good.text, "The levels determine each density.");
}

// One of twenty levels contradicts by chance, and two of forty do: no doubt of the joint.
TEST(ExperimentReport, LevelsThatContradictByChanceAreToldAlone) {
  for (const auto& [wrong, doubtful] : {std::pair{1U, false}, std::pair{2U, true}}) {
    ExperimentResults results = exact_results();
    results.joint->verdicts = {{.departure = "asymmetric"}};
    CampaignFound& campaign = results.campaign.emplace();
    campaign.entries = {{.test = "a", .use = "identify", .session = "1", .part = "level"}};
    for (std::size_t i = 1; i <= 20; ++i) {
      campaign.left_out.push_back({.left_out = "a: level " + std::to_string(i),
                                   .part = "level",
                                   .test = "a",
                                   .amplitude = 1e-6 * static_cast<double>(i),
                                   .measured = 1e-6,
                                   .predicted = 1e-6,
                                   .lower = 0.9e-6,
                                   .upper = 1.1e-6,
                                   .verdict = i <= wrong ? "outside" : "inside",
                                   .contradicts = i <= wrong});
    }
    const ReportDocument document = experiment_report(results);
    const auto& verdict = std::get<ReportVerdict>(document.sections.front().blocks.front());
    EXPECT_EQ(verdict.doubtful, doubtful);
    EXPECT_TRUE(contains(verdict.text, "of 20 levels contradict")) << verdict.text;
    EXPECT_TRUE(contains(verdict.text, "Nothing contradicts a Masing joint")) << verdict.text;
  }
}

TEST(ExperimentReport, EachWarningIsShownOnce) {
  const ReportDocument document = experiment_report(contradicted_results());
  std::vector<std::string> codes = warned_of(document);
  EXPECT_EQ(std::ranges::count(codes, "left_out_contradicts"), 1);
  EXPECT_EQ(std::ranges::count(codes, "few_inside"), 1);
}

TEST(ExperimentReport, RepeatabilityThatIsToldWasExamined) {
  for (ExperimentResults results : {contradicted_results(), exact_results()}) {
    if (!results.campaign) results.campaign.emplace();
    EXPECT_TRUE(contains(summary_text(experiment_report(results)), "whether the test repeats"));
    results.campaign->repeatability = "9 % from session to session";
    const std::string text = summary_text(experiment_report(results));
    EXPECT_FALSE(contains(text, "whether the test repeats")) << text;
    EXPECT_TRUE(contains(text, "Not examined: ")) << text;
  }
}

TEST(ExperimentReport, WhatWasLeftOutIsShownByItsTest) {
  const ReportDocument document = experiment_report(contradicted_results());
  const ReportTable& left_out = table(document, "Left out");
  ASSERT_EQ(left_out.rows.size(), 2U);
  EXPECT_EQ(std::get<double>(left_out.rows[1][1]), 3.0);  // levels
  EXPECT_EQ(std::get<double>(left_out.rows[1][2]), 2.0);  // of which these are not beyond
  EXPECT_EQ(std::get<double>(left_out.rows[1][4]), 0.0);
  const ReportFigure& shown = figure(document, "Left-out dissipation");
  EXPECT_TRUE(shown.figure.x.log);  // 1 to 20 µm
  std::vector<std::string> names;
  for (const Layer& layer : shown.figure.layers) names.push_back(name_of(layer));
  EXPECT_EQ(names, (std::vector<std::string>{"centre and edges of the band", "monday, inside",
                                             "friday, outside"}));
  EXPECT_EQ(legend_of(shown.figure.layers[2]), "friday");
}

// σ = √(σ_D² + (D′σ_A)²): with D′σ_A = σ_D the residuals are √2 times smaller.
TEST(ExperimentReport, ScatterOfTheAmplitudeCountsThroughTheSlope) {
  ExperimentResults results = exact_results();
  Levels& levels = results.levels->levels;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const double deviation = 0.01 * levels.dissipation[i];
    levels.dissipation_std.push_back(deviation);
    levels.amplitude_std.push_back(deviation /
                                   dissipation_slope(uniform_joint(), levels.amplitude[i]));
    levels.dissipation[i] += (i % 2 == 0 ? 1.0 : -1.0) * deviation;
  }
  const ReportDocument document = experiment_report(results);
  const ReportFigure& residuals = figure(document, "Standardised residuals");
  // By ± σ_A, which is a third of a percent: 1e-5 off the slope.
  EXPECT_NEAR(trace(residuals, "levels").y[0], std::sqrt(0.5), 1e-5);
  EXPECT_TRUE(contains(residuals.figure.caption, "Their rms is 0.71")) << residuals.figure.caption;
}

TEST(ExperimentReport, ResidualsInStandardDeviations) {
  ExperimentResults results = exact_results();
  Levels& levels = results.levels->levels;
  for (std::size_t i = 0; i < kLevels; ++i) {
    levels.dissipation_std.push_back(0.01 * levels.dissipation[i]);
    levels.dissipation[i] += (i % 2 == 0 ? 0.5 : -1.5) * levels.dissipation_std[i];
  }
  const ReportDocument document = experiment_report(results);
  const Drawn residuals = trace(figure(document, "Standardised residuals"), "levels");
  EXPECT_NEAR(residuals.y[0], 0.5, 1e-9);
  EXPECT_NEAR(residuals.y[1], -1.5, 1e-9);
}

TEST(ExperimentReport, ResponsesBesideTheTruthAndTheMeasured) {
  const ReportDocument document = experiment_report(all_results());
  const ReportFigure& responses = figure(document, "Frequency responses at constant response");
  EXPECT_EQ(trace(responses, "1 m/s²").y, (std::vector{0.25, 0.5}));
  EXPECT_EQ(trace(responses, "1 m/s², true joint").y, (std::vector{0.25, 0.4}));
  EXPECT_EQ(trace(responses, "measured levels").y[0], 0.5);
  const ReportFigure& resonance = figure(document, "Resonance frequency");
  EXPECT_EQ(trace(resonance, "predicted by the joint").y, (std::vector{55.2, 54.0}));
  EXPECT_DOUBLE_EQ(trace(resonance, "predicted by the joint").x[1], 300.0);  // µm
  const ReportFigure& damping = figure(document, "Damping of the structure");
  EXPECT_DOUBLE_EQ(trace(damping, "by the true joint").y[1], 1.0);  // %
}

// ζ = W/(4πE): E of the backbone grows with A², so does half the input energy at twice the ζ.
TEST(ExperimentReport, DampingOfTheStructureAsMeasured) {
  ExperimentResults results = all_results();
  results.levels->input_energy.clear();
  for (const double a : results.levels->levels.amplitude) {
    results.levels->input_energy.push_back(4.0 * std::numbers::pi * 0.02 * 50.0 * a * a);
  }
  results.backbone->vibration_energy = {50.0 * 1.5e-5 * 1.5e-5, 50.0 * 3e-4 * 3e-4};
  const ReportDocument document = experiment_report(results);
  for (const double value : trace(figure(document, "Damping of the structure"), "measured").y) {
    EXPECT_NEAR(value, 2.0, 1e-12);  // %
  }
}

TEST(ExperimentReport, TheFrequencyOfTheDriveWhereThatIsAllThatIsKnown) {
  ExperimentResults results = exact_results();
  results.levels->frequency.assign(kLevels, 55.0);
  const ReportDocument document = experiment_report(results);
  const ReportFigure& resonance = figure(document, "Resonance frequency");
  EXPECT_EQ(trace(resonance, "drive").y.size(), kLevels);
  EXPECT_TRUE(contains(resonance.figure.caption, "The frequency of the drive"))
      << resonance.figure.caption;
}

TEST(ExperimentReport, ADistortionOfZeroIsBelowTheNoise) {
  ExperimentResults results = exact_results();
  results.levels->force_distortion.assign(kLevels, 0.0014);
  results.levels->force_distortion[0] = 0.0;
  const ReportDocument document = experiment_report(results);
  const auto& table = std::get<ReportTable>(section(document, "Levels").blocks[0]);
  const auto column = std::ranges::find(table.columns, "distortion", &ReportColumn::name);
  const auto at = static_cast<std::size_t>(column - table.columns.begin());
  EXPECT_EQ(std::get<std::string>(table.rows[0][at]), "< noise");
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[1][at]), 0.14);  // %
  EXPECT_FALSE(contains(table.caption, "σ")) << table.caption;
}

TEST(ExperimentReport, TheRigInItsMainValues) {
  ExperimentResults results = exact_results();
  results.rig = Rig{.structure = RigBeam{0.583, 0.04, 0.005, 207e9, 7850.0},
                    .contact = {.rod_radius = 0.03, .stiffness = 1.7e5},
                    .loss_factor = {0.0028, 0.0018},
                    .masses = {{0.55, 0.03}},
                    .excitation = {.position = 0.55, .shape = {}, .channel = "force"},
                    .accelerometers = {{.position = 0.35, .shape = {}, .channel = "acc2"}}};
  const ReportDocument document = experiment_report(results);
  const auto& facts = std::get<ReportFacts>(section(document, "Rig").blocks[0]).facts;
  const auto value = [&](std::string_view name) {
    return std::ranges::find(facts, name, &std::pair<std::string, std::string>::first)->second;
  };
  EXPECT_EQ(value("beam"), "583 × 40 × 5 mm");
  EXPECT_EQ(value("mass"), "30 g at 550 mm");
  EXPECT_EQ(value("stuck stiffness"), "170 kN/m");
  EXPECT_EQ(value("loss factors"), "0.0028, 0.0018");
  EXPECT_EQ(value("accelerometer"), "acc2 at 350 mm");
}

TEST(ExperimentReport, StiffnessMeasuredAndOfTheJoint) {
  const ReportDocument document = experiment_report(exact_results());
  const ReportFigure& secant = figure(document, "Secant stiffness");
  EXPECT_NEAR(trace(secant, "measured").y.back(), trace(secant, "identified joint").y.back(), 1e-9);
  const ReportFigure& loss = figure(document, "Loss factor of the joint");
  EXPECT_NEAR(trace(loss, "measured").y[0], trace(loss, "identified joint").y[0], 1e-12);
}

TEST(ExperimentReport, FlagsAreMarkedAndWorriedAbout) {
  const ReportDocument document = experiment_report(exact_results());
  const auto& table = std::get<ReportTable>(section(document, "Levels").blocks[0]);
  EXPECT_EQ(table.marked, (std::vector<std::size_t>{2}));
  bool said = false;
  for (const ReportBlock& block : section(document, "Summary").blocks) {
    const auto* warnings = std::get_if<ReportWarnings>(&block);
    if (warnings == nullptr) continue;
    said = std::ranges::any_of(warnings->warnings, [](const Warning& warning) {
      return warning.code == "levels_flagged" && contains(warning.text, "1 of 20 levels");
    });
  }
  EXPECT_TRUE(said);
  const auto& flags = std::get<ReportFacts>(section(document, "Levels").blocks[1]);
  ASSERT_EQ(flags.facts.size(), 1);
  EXPECT_EQ(flags.facts[0].first, "spike");
  EXPECT_EQ(flags.facts[0].second, "single samples are outliers; 1 level");
}

TEST(ExperimentReport, RecordsWithAndWithoutForceControl) {
  ExperimentResults results = exact_results();
  results.records = {{"level_1",
                      {{"force", "N", {0.0, 0.01}, {1.0, 2.0}, {0.0, 0.01}, {1.5, 2.5}},
                       {"ldv", "m", {0.0, 0.01}, {1e-6, 2e-6}, {}, {}}},
                      {{"force", "N", {2.0, 0.02}, {2.0, 0.2}}}}};
  const ReportDocument document = experiment_report(results);
  const ReportFigure& force = figure(document, "Force over time");
  EXPECT_EQ(force.chart, ChartKind::kTimeHistory);
  EXPECT_EQ(trace(force, "force").x[1], 10.0);  // ms
  EXPECT_EQ(trace(force, "force, before control").y[1], 2.5);
  EXPECT_DOUBLE_EQ(trace(figure(document, "Displacement over time"), "ldv").y[1], 2.0);  // µm
  const ReportFigure& harmonics = figure(document, "Harmonics");
  EXPECT_DOUBLE_EQ(trace(harmonics, "force").y[0], 1.0);  // %
  EXPECT_DOUBLE_EQ(trace(harmonics, "force, before control").y[0], 10.0);
  EXPECT_EQ(trace(harmonics, "force").x[0], 2.0);
}

TEST(ExperimentReport, ForceControlOverTheLevels) {
  ExperimentResults results = exact_results();
  results.force_control = {{"1", 0.5, {0.03, 0.05}, {0.001, 0.002}},
                           {"2", 1.5, {0.1, 0.0}, {0, 0}}};
  const ReportDocument document = experiment_report(results);
  const ReportFigure& control = figure(document, "Force control over the levels");
  EXPECT_EQ(trace(control, "before control").y, (std::vector{5.0, 10.0}));
  EXPECT_EQ(trace(control, "after control").y, (std::vector{0.2, 0.0}));
  EXPECT_EQ(figure(document, "Harmonics of the force").choices.size(), 2);
}

const ReportTable& table_in(const ReportSection& in) {
  const auto found = std::ranges::find_if(in.blocks, [](const ReportBlock& block) {
    return std::holds_alternative<ReportTable>(block);
  });
  return std::get<ReportTable>(*found);
}

TEST(ExperimentReport, PredictionsAndTheWorstOfThem) {
  ExperimentResults results = exact_results();
  results.comparisons = {
      {"a.csv", "force", "converged", 55.0, 1.0, 0.02, 0.001, 1.01, 0.003},
      {"a.csv", "acc1", "converged", 55.0, 1.0, 0.005, 0.005, 1.0, 0.0},
      {"b.csv", "acc1", "not converged", 54.0, 2.0, 0.3, 0.25, 1.0, 0.0, "spike"}};
  const ReportDocument document = experiment_report(results);
  const ReportTable& table = table_in(section(document, "Prediction"));
  ASSERT_EQ(table.rows.size(), 2);                     // a row a record, a column a channel
  EXPECT_EQ(std::get<double>(table.rows[0][3]), 2.0);  // %
  EXPECT_EQ(std::get<double>(table.rows[0][4]), 0.5);
  EXPECT_TRUE(std::isnan(std::get<double>(table.rows[1][3])));
  EXPECT_EQ(std::get<double>(table.rows[1][4]), 30.0);
  EXPECT_EQ(std::get<std::string>(table.rows[1][5]), "not converged spike");
  EXPECT_EQ(table.marked, (std::vector<std::size_t>{1}));
  EXPECT_NEAR(trace(figure(document, "Amplitude error"), "force").y[0], 1.0, 1e-12);  // %
  EXPECT_DOUBLE_EQ(trace(figure(document, "Phase error"), "force").y[0], 3.0);        // mrad
  ReportFigure misfit = figure(document, "Misfit of the prediction");
  ASSERT_EQ(misfit.choices.size(), 2U);
  EXPECT_EQ(misfit.choices[1].name, "acc1");
  misfit.chosen = 1;
  EXPECT_EQ(trace(misfit, "prediction").x, (std::vector{1.0, 2.0}));
  EXPECT_EQ(trace(misfit, "noise alone").y, (std::vector{0.5, 25.0}));
  EXPECT_TRUE(
      contains(summary_text(document),
               "error of predictions = at most 16.6 % beyond the noise (acc1, b.csv); NRMSE "
               "with the noise at most 30.0 %; records of 1 to 2 m/s²"))
      << summary_text(document);
}

TEST(ExperimentReport, ARecordHasItsResponseBesideItsName) {
  ExperimentResults results = all_results();
  results.levels->source[4] = "elsewhere/level_5.csv";
  results.levels->response_amplitude[4] = 3.25;
  results.records = {
      {"recordings/level_5.csv", {{"force", "N", {0.0, 0.01}, {1.0, 2.0}, {}, {}}}, {}},
      {"level_9.csv", {{"force", "N", {0.0, 0.01}, {1.0, 2.0}, {}, {}}}, {}}};
  results.record_count = 20;
  const ReportDocument document = experiment_report(results);
  const ReportFigure& force = figure(document, "Force over time");
  EXPECT_EQ(force.choices[0].name, "level_5.csv (3.25 m/s²)");
  EXPECT_EQ(force.choices[1].name, "level_9.csv");
  const auto& text = std::get<ReportText>(section(document, "Signals").blocks[0]);
  EXPECT_TRUE(contains(text.text, "2 of the 20 records are shown over time")) << text.text;
  EXPECT_TRUE(contains(text.text, "--records shows more")) << text.text;
}

TEST(ExperimentReport, LevelsThatNoMethodTakesAreShownAllTheSame) {
  ExperimentResults results = exact_results();
  results.levels->levels.dissipation.assign(kLevels, 0.0);
  const ReportDocument document = experiment_report(results);
  EXPECT_EQ(trace(figure(document, "Energies per cycle"), "linear loss").y.size(), kLevels);
  bool said = false;
  for (const ReportBlock& block : section(document, "Summary").blocks) {
    const auto* warnings = std::get_if<ReportWarnings>(&block);
    said = said || (warnings != nullptr && warnings->warnings[0].code == "no_other_methods");
  }
  EXPECT_TRUE(said);
}

TEST(TestReportFault, LengthsDiffer) {
  ExperimentResults results = exact_results();
  results.levels->frequency = {55.0};
  EXPECT_EQ(input_fault([&] { (void)experiment_report(results); }),
            "frequency.size() = 1; must be 0 or the 20 of the levels");
}

TEST(TestReportFault, LengthsOfPartsDiffer) {
  const auto fault_of = [](const auto& change) {
    ExperimentResults results = all_results();
    change(results);
    return input_fault([&] { (void)experiment_report(results); });
  };
  EXPECT_EQ(fault_of([](ExperimentResults& r) { r.joint->band_lower.pop_back(); }),
            "band_lower.size() = 2; must be 3, that of the corresponding data");
  EXPECT_EQ(fault_of([](ExperimentResults& r) { r.backbone->vibration_energy = {1.0}; }),
            "backbone.vibration_energy.size() = 1; must be 2, that of the corresponding data");
  EXPECT_EQ(fault_of([](ExperimentResults& r) { r.force_control[0].after.clear(); }),
            "force_control.after.size() = 0; must be 2, that of the corresponding data");
  EXPECT_EQ(fault_of([](ExperimentResults& r) { r.responses[0].force.pop_back(); }),
            "force.size() = 1; must be 2, that of the corresponding data");
  EXPECT_EQ(fault_of([](ExperimentResults& r) { r.records[0].signals[0].recorded.clear(); }),
            "force.recorded.size() = 0; must be 2, that of the corresponding data");
}

TEST(ExperimentReport, ResponsesWithoutTheirAmplitudesInTheLevels) {
  ExperimentResults results = all_results();
  results.levels->response_amplitude.clear();
  const ReportDocument document = experiment_report(results);
  EXPECT_EQ(figure(document, "Frequency responses at constant response").figure.layers.size(), 2U);
}

/// A joint of two records, the second of which rubs faster in one direction than in the other.
ExperimentResults record_results() {
  ExperimentResults results;
  results.title = "Records";
  IdentifiedJoint joint{.joint = uniform_joint(),
                        .method = "inversion",
                        .status = "converged",
                        .covered_from = 1.5,
                        .covered_to = 30.0,
                        .warnings = {"asymmetric", "asymmetric"},
                        .warning_texts = {"record 1: one", "record 2: two"},
                        .band_confidence = 0.95,
                        .band_slip_force = {0.0, 15.0, 30.0},
                        .band_lower = {0.02, 0.02, 0.02},
                        .band_upper = {0.03, 0.03, 0.03}};
  FoundByRecords& found = joint.by_records.emplace();
  found.stiffness = BandedValue{kStiffness, 0.98 * kStiffness, 1.02 * kStiffness};
  found.elastic = BandedValue{0.0, 0.0, 100.0};
  for (const bool second : {false, true}) {
    RecordFound& record = found.records.emplace_back();
    record = {.source = second ? "lab/b.csv" : "lab/a.csv",
              .start = "virgin",
              .start_from = "shown",
              .scatter = 0.1,
              .unexplained = second ? 0.04 : 0.01,
              .offset = {0.5}};
    record.verdicts = {{"asymmetric", second ? 0.03 : 0.02, 0.001, true},
                       {"drifts", second ? 0.001 : 0.002, 0.001, false}};
  }
  for (const std::size_t number : {0U, 1U}) {
    ForcePath& path = results.force_paths.emplace_back();
    path.record = number;
    path.source = number == 0 ? "a.csv" : "b.csv";
    path.reversals = 4;
    for (int i = 0; i < 400; ++i) {
      path.time.push_back(0.01 * i);
      path.path.push_back(1e-4 * std::sin(0.05 * i));
      path.force.push_back(1e5 * path.path.back());
      path.found.push_back(i < 20 ? std::nan("") : path.force.back() - 0.1);
    }
    path.displacement = path.path;
  }
  results.joint = joint;
  return results;
}

TEST(ReportOfRecords, BeginsWithDensityVerdictsAndWarnings) {
  const ReportDocument document = experiment_report(record_results());
  EXPECT_EQ(titles_of(document),
            (std::vector<std::string>{"Summary", "Force along the record", "Measured loops",
                                      "Dissipation and stiffness", "Records", "Provenance"}));
  const ReportSection& summary = document.sections.front();
  const auto& verdict = std::get<ReportVerdict>(summary.blocks[0]);
  EXPECT_TRUE(verdict.doubtful);
  EXPECT_TRUE(contains(verdict.text, "(the two sides differ). The nearest such joint"))
      << verdict.text;
  EXPECT_EQ(std::get<ReportFigure>(summary.blocks[1]).figure.title, "Slip-force density");
  EXPECT_TRUE(std::get<ReportTable>(summary.blocks[3]).beside);
  const auto& reach = std::get<ReportFacts>(summary.blocks[4]);
  EXPECT_TRUE(reach.beside);
  EXPECT_EQ(reach.facts.front().first, "half range of the motion");
  EXPECT_TRUE(contains(reach.facts.back().second, "at most 4.0 % of the force of its own records"));
  const auto& warnings = std::get<ReportWarnings>(summary.blocks[5]).warnings;
  ASSERT_EQ(warnings.size(), 2U) << "one of each record, of the same code";
  EXPECT_EQ(warnings[1].text, "record 2: two");
  const auto& facts = std::get<ReportFacts>(summary.blocks[2]);
  EXPECT_EQ(facts.facts[0], (std::pair<std::string, std::string>{"stuck stiffness k, 95 % band",
                                                                 "100.0 ± 2.0 kN/m"}));
  EXPECT_EQ(facts.facts[2],
            (std::pair<std::string, std::string>{"force unexplained, at most", "4.0 %"}));
  EXPECT_EQ(facts.facts[3], (std::pair<std::string, std::string>{"departures found", "1 of 2"}));
}

TEST(ReportOfRecords, ShowsEachDepartureWhereItStandsOutMost) {
  const ReportDocument document = experiment_report(record_results());
  const ReportTable& verdicts = table(document, "Is it a Masing joint?");
  ASSERT_EQ(verdicts.rows.size(), 2U);
  EXPECT_EQ(verdicts.marked, (std::vector<std::size_t>{0}));
  EXPECT_TRUE(contains(std::get<std::string>(verdicts.rows[0][0]), "the two sides differ"));
  EXPECT_EQ(verdicts.rows[0][1], ReportCell(2.0));
  EXPECT_EQ(verdicts.rows[0][2], ReportCell(3.0)) << "%";
  EXPECT_EQ(verdicts.rows[0][4], ReportCell("yes"));
  EXPECT_EQ(verdicts.rows[1][1], ReportCell(1.0));
  EXPECT_EQ(table(document, "Tested assumptions, record by record").rows.size(), 4U);
  EXPECT_EQ(table(document, "Records").rows[1][1], ReportCell("b.csv"));
}

// A reader without a script sees the drawn pictures; a gap is where the joint is not known yet.
TEST(ReportOfRecords, DrawsMeasuredAgainstFound) {
  const ReportDocument document = experiment_report(record_results());
  const ReportFigure& force = figure(document, "Force over time");
  ASSERT_EQ(force.choices.size(), 2U);
  EXPECT_EQ(force.choices[1].name, "2: b.csv");
  EXPECT_EQ(trace(force, "measured").x.size(), 400U);
  EXPECT_EQ(trace(force, "identified joint").x.size(), 380U);
  EXPECT_TRUE(contains(force.figure.caption, "gaps"));
  EXPECT_FALSE(contains(force.figure.caption, "highest and lowest"));
  const Drawn residual = trace(figure(document, "Residual over time"), "residual");
  ASSERT_EQ(residual.y.size(), 380U);
  const double unit = figure(document, "Residual over time").figure.y.unit == "mN" ? 1e3 : 1.0;
  EXPECT_NEAR(residual.y[7], 0.1 * unit, 1e-9 * unit);
  EXPECT_EQ(trace(figure(document, "Measured and found loops"), "measured").x.size(), 400U);
  // The residual is the same in both directions.
  for (const char* mean : {"mean while it rises", "mean while it falls"}) {
    EXPECT_NEAR(trace(figure(document, "Residual over displacement"), mean).y.front(), 0.1 * unit,
                1e-9 * unit);
  }
  for (const char* title :
       {"Dissipation of the joint", "Secant stiffness", "Loss factor of the joint"}) {
    EXPECT_FALSE(chosen_layers(figure(document, title)).empty()) << title;
  }
}

// A part of a record may be at rest, and without a known state.
TEST(ReportOfRecords, DrawsAPartAtRest) {
  ExperimentResults results = record_results();
  ForcePath& path = results.force_paths[0];
  std::ranges::fill(path.path, 0.0);
  path.displacement = path.path;
  std::ranges::fill(results.force_paths[1].found, std::nan(""));
  const ReportDocument document = experiment_report(results);
  const ReportFigure& residual = figure(document, "Residual over displacement");
  EXPECT_EQ(trace(residual, "mean while it falls").x.size(), 1U) << "all at one displacement";
}

TEST(ReportOfRecords, SaysThatRecordingsAreMissing) {
  ExperimentResults results = record_results();
  results.force_paths.clear();
  const ReportDocument document = experiment_report(results);
  EXPECT_TRUE(contains(missing_in(document), "No forces and no loops"));
  EXPECT_EQ(table(document, "Records").rows.size(), 2U);
  EXPECT_TRUE(std::isnan(std::get<double>(table(document, "Records").rows[0][2])));
}

TEST(ReportOfRecords, ComesWithTheLevelsOfTheFolder) {
  ExperimentResults results = record_results();
  results.levels = exact_levels();
  const std::vector<std::string> titles = titles_of(experiment_report(results));
  for (const char* title : {"Force along the record", "Levels", "Energies", "Density"}) {
    EXPECT_NE(std::ranges::find(titles, title), titles.end()) << title;
  }
}

TEST(TestReportFault, LengthsOfARecordDiffer) {
  ExperimentResults results = record_results();
  results.force_paths[1].found.pop_back();
  EXPECT_EQ(input_fault([&] { (void)experiment_report(results); }),
            "b.csv.found.size() = 399; must be 400, that of the corresponding data");
}

// Tables of predictions in the folder have a section, their bands behind the curves; without any
// there is none.
TEST(ExperimentReport, ShowsCurvesOfPredictionsWithTheirBands) {
  ExperimentResults results = exact_results();
  const auto has_curves = [](const ReportDocument& document) {
    return std::ranges::count(titles_of(document), "Curves") == 1;
  };
  EXPECT_FALSE(has_curves(experiment_report(results)));
  results.curves.response = PredictedResponse{
      {10.0, 11.0}, {0.5, 0.5}, {2e-3, 1e-3}, {0.5, 2.0}, {{1e-3, 5e-4}, {3e-3, 2e-3}}};
  results.curves.march = {
      {"displacement", "displacement", "m", {0.0, 1.0}, {0.0, 1.0}, {{0.0, 0.5}, {0.0, 1.5}}},
      {"joint", "joint force", "N", {0.0, 1.0}, {0.0, 2.0}, {}}};
  const ReportDocument document = experiment_report(results);
  ASSERT_TRUE(has_curves(document));
  EXPECT_EQ(trace(figure(document, "Frequency response"), "band of draws").y,
            (std::vector<double>{3.0, 2.0}));
  const ReportFigure& march = figure(document, "March");
  EXPECT_EQ(trace(march, "band of draws").y, (std::vector<double>{0.0, 1.5}));
  EXPECT_TRUE(contains(march.figure.caption, "neither edge"));
  EXPECT_EQ(figure(document, "March: joint force").figure.layers.size(), 1U);
}

}  // namespace
}  // namespace microslip::experiment_report_test
