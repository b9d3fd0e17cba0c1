// SPDX-License-Identifier: MIT
#include "microslip/report/paper_figures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "report/support.hpp"

namespace microslip::paper_figures_test {
namespace {

using test::contains;
using test::input_fault;
using Numbers = std::vector<double>;

constexpr double kRounding = 1e-12;  // relative, of a few operations

/// The layer of that name.
template <class L>
const L& layer(const Figure& figure, const std::string& legend) {
  for (const Layer& one : figure.layers) {
    const auto* found = std::get_if<L>(&one);
    if (found != nullptr && found->legend == legend) return *found;
  }
  throw std::runtime_error("no layer " + legend);
}

void expect_near(const Numbers& found, const Numbers& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], kRounding * std::abs(expected[i])) << i;
  }
}

/// φ = 0.05 1/N up to 20 N, k = 1e5 N/m. Up to kA = 20 N, F = kA − 0.05 (kA)²/2 and
/// D = (4/k) ∫ f*(kA − f*) φ df* = (4/k) 0.05 (kA)³/6. [AR14 (5), (7)]
Joint uniform_joint() {
  return {1e5, SlipDensity({UniformPart{.from = 0.0, .to = 20.0, .weight = 1.0}})};
}

double uniform_dissipation(double amplitude) {
  return 4.0 / 1e5 * 0.05 * std::pow(1e5 * amplitude, 3) / 6.0;
}

ExperimentResults results() {
  ExperimentResults made;
  MeasuredLevels levels;
  levels.levels.amplitude = {2e-5, 1e-4};
  levels.levels.dissipation = {2e-6, 3e-4};
  levels.levels.amplitude_std = {2e-7, 1e-6};
  levels.levels.dissipation_std = {1e-7, 3e-6};
  levels.levels.secant_stiffness = {9e4, 5e4};
  levels.levels.secant_stiffness_std = {9e2, 5e2};
  levels.frequency = {50.0, 49.0};
  levels.resonance_frequency = {50.25, 49.25};
  levels.response_amplitude = {1.0, 5.0};
  levels.input_energy = {5e-6, 4e-4};
  levels.linear_dissipation = {3e-6, 1e-4};
  made.levels = levels;
  made.joint = IdentifiedJoint{.joint = uniform_joint(), .covered_from = 2.0, .covered_to = 10.0};
  return made;
}

/// With nothing but what levels must have.
MeasuredLevels two_levels() {
  MeasuredLevels made;
  made.levels.amplitude = {1e-5, 2e-5};
  made.levels.dissipation = {1e-6, 5e-6};
  return made;
}

TEST(PaperEnergies, ShowsTheLevelsAndTheJointInReadableUnits) {
  const Figure figure = paper_energies(results());
  EXPECT_EQ(figure.x.label, "joint amplitude A [µm]");
  EXPECT_EQ(figure.y.label, "energy per cycle [µJ]");
  EXPECT_TRUE(figure.x.log && figure.y.log);
  expect_near(layer<PointLayer>(figure, "input energy").y, {5.0, 400.0});
  expect_near(layer<PointLayer>(figure, "linear loss").y, {3.0, 100.0});
  expect_near(layer<PointLayer>(figure, "joint, D").x, {20.0, 100.0});
  expect_near(layer<PointLayer>(figure, "joint, D").y, {2.0, 300.0});
  expect_near(layer<PointLayer>(figure, "joint, D").y_error, {0.1, 3.0});
  const auto& line = layer<LineLayer>(figure, "identified joint");
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    EXPECT_NEAR(line.y[i], 1e6 * uniform_dissipation(1e-6 * line.x[i]), 1e-9 * line.y[i]);
  }
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(PaperEnergies, OfAmplitudesAndDissipationsAlone) {
  ExperimentResults bare;
  bare.levels = two_levels();
  const Figure figure = paper_energies(bare);
  ASSERT_EQ(figure.layers.size(), 1U);
  EXPECT_TRUE(layer<PointLayer>(figure, "joint, D").y_error.empty());
}

TEST(PaperEnergies, AddsTheLinearDampingThatWasIdentified) {
  ExperimentResults damped = results();
  damped.joint->linear_damping = 30.0;
  const Figure figure = paper_energies(damped);
  const auto& joint = layer<LineLayer>(figure, "identified joint");
  const auto& total = layer<LineLayer>(figure, "with damping βA²");
  // 30 J/m² times (100 µm)² are 0.3 µJ.
  EXPECT_NEAR(total.y.back() - joint.y.back(), 0.3, 1e-9);
  EXPECT_EQ(layer<PointLayer>(figure, "D, with damping βA²").y.size(), 2U);
}

TEST(PaperEnergies, TakesTheScaleThatIsAskedFor) {
  const Figure figure = paper_energies(results(), {.scale = AmplitudeScale::kLinear});
  EXPECT_FALSE(figure.x.log || figure.y.log);
}

TEST(PaperDensity, HasBandTruthOthersAndWhereLevelsAre) {
  ExperimentResults known = results();
  known.truth = uniform_joint();
  known.joint->band_confidence = 0.9;
  known.joint->band_slip_force = {1.0, 2.0, 10.0};
  known.joint->band_lower = {0.0, 0.04, 0.04};
  known.joint->band_upper = {1.0, 0.06, 0.06};
  const Figure figure = paper_density(known, {.others = {{"fit", uniform_joint()}}});
  EXPECT_EQ(figure.x.label, "slip force f* [N]");
  EXPECT_EQ(figure.y.label, "density φ [1/kN]");
  // Below the lowest level the band is an assumption.
  EXPECT_EQ(layer<BandLayer>(figure, "90 % band").x, (Numbers{2.0, 10.0}));
  expect_near(layer<BandLayer>(figure, "90 % band").upper, {60.0, 60.0});
  EXPECT_EQ(layer<LineLayer>(figure, "identified joint").x.front(), 1.8);
  for (const char* name : {"identified joint", "truth", "fit"}) {
    const auto& line = layer<LineLayer>(figure, name);
    for (const double density : line.y) EXPECT_NEAR(density, 50.0, 1e-9) << name;
    EXPECT_EQ(line.x.back(), 10.0);
  }
  EXPECT_EQ(layer<LineLayer>(figure, "truth").stroke.style, LineStyle::kDashed);
  EXPECT_EQ(std::get<MarkerLayer>(figure.layers.back()).x, 10.0);
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(PaperDensity, LeavesOutWhatIsInfiniteAtZero) {
  ExperimentResults power;
  power.joint = IdentifiedJoint{.joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0)};
  const Figure figure = paper_density(power);
  // Its atom at the end is no part of a density: half of k at β = 1, χ = −0.5.
  EXPECT_GT(layer<LineLayer>(figure, "joint without its atoms, 50.0 % of k").x.front(), 0.0);
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(PaperDensity, RefusesAJointThatCannotSlip) {
  ExperimentResults spring;
  spring.joint = IdentifiedJoint{.joint = Joint(1e5, SlipDensity())};
  EXPECT_TRUE(contains(input_fault([&] { return paper_density(spring); }), "a part slips"));
}

TEST(PaperLoops, EndAtTheVirginCurve) {
  const Figure figure = paper_loops(results());
  EXPECT_EQ(figure.x.label, "joint displacement [µm]");
  EXPECT_EQ(figure.y.label, "joint force [N]");
  for (const double amplitude : {100.0, 75.0, 50.0, 25.0}) {
    const auto& loop = layer<LoopLayer>(figure, "A = " + fmt::format("{:g}", amplitude) + " µm");
    EXPECT_NEAR(std::ranges::max(loop.x), amplitude, 1e-9);
    const double a = 1e-6 * amplitude;
    EXPECT_NEAR(std::ranges::max(loop.y), 1e5 * a - 0.05 * std::pow(1e5 * a, 2) / 2.0, 1e-9);
  }
}

TEST(PaperLoops, WithoutLevelsReachTheMacroSlip) {
  ExperimentResults only;
  only.joint = IdentifiedJoint{.joint = uniform_joint()};
  const Figure figure = paper_loops(only);
  // 20 N over 1e5 N/m are 200 µm; the force is then 10 N, all that the sliders carry.
  EXPECT_NEAR(std::ranges::max(layer<LoopLayer>(figure, "A = 240 µm").y), 10.0, 1e-9);
}

TEST(PaperResonance, IsOverTheResponseWhereThatIsKnown) {
  const Figure figure = paper_resonance(results());
  EXPECT_EQ(figure.x.label, "exciter acceleration [m/s²]");
  EXPECT_EQ(layer<PointLayer>(figure, "drive").y, (Numbers{50.0, 49.0}));
  EXPECT_EQ(layer<PointLayer>(figure, "resonance").x, (Numbers{1.0, 5.0}));
  ExperimentResults other = results();
  other.levels->response_amplitude.clear();
  EXPECT_EQ(paper_resonance(other).x.label, "joint amplitude A [µm]");
  other.levels->frequency.clear();
  other.levels->resonance_frequency.clear();
  EXPECT_TRUE(contains(input_fault([&] { return paper_resonance(other); }), "frequencies"));
}

TEST(PaperStiffness, ShowsSecantsWithTheirBars) {
  const Figure figure = paper_stiffness(results());
  EXPECT_EQ(figure.y.label, "secant stiffness k_eq [kN/m]");
  EXPECT_FALSE(figure.x.log || figure.y.log);
  expect_near(layer<PointLayer>(figure, "measured").y, {90.0, 50.0});
  expect_near(layer<PointLayer>(figure, "measured").y_error, {0.9, 0.5});
  EXPECT_TRUE(paper_stiffness(results(), {.scale = AmplitudeScale::kLog}).x.log);
}

// D holds βA² beside what the joint dissipates, and the loss factor is that of the joint.
TEST(PaperDamping, IsOfTheJointAlone) {
  ExperimentResults damped = results();
  damped.joint->linear_damping = 1000.0;
  const Figure figure = paper_damping(damped);
  EXPECT_NEAR(layer<PointLayer>(figure, "measured").y[0],
              (2e-6 - 1000.0 * 4e-10) / (std::numbers::pi * 9e4 * 4e-10), 1e-12);
}

// D 5 %, k 1 % and A 1 %: the deviations of D, of k and twice that of A, squared and added.
TEST(PaperDamping, PropagatesStandardDeviations) {
  const Figure figure = paper_damping(results());
  const auto& points = layer<PointLayer>(figure, "measured");
  const double loss = 2e-6 / (std::numbers::pi * 9e4 * 4e-10);
  EXPECT_NEAR(points.y[0], loss, 1e-12);
  EXPECT_NEAR(points.y_error[0], loss * std::sqrt(0.05 * 0.05 + 0.01 * 0.01 + 0.02 * 0.02), 1e-12);
}

TEST(PaperDamping, OfARingDownIsTheDampingRatio) {
  ExperimentResults decay;
  decay.levels = two_levels();
  decay.levels->damping_ratio = {0.01, 0.02};
  const Figure figure = paper_damping(decay);
  EXPECT_EQ(figure.y.label, "damping ratio ζ of the mode [%]");
  expect_near(std::get<PointLayer>(figure.layers[0]).y, {1.0, 2.0});
}

TEST(PaperDissipation, HasThreePanels) {
  const FigureGrid grid = paper_dissipation(results());
  ASSERT_EQ(grid.panels.size(), 3U);
  EXPECT_EQ(grid.panels[0].y.label, "dissipation per cycle D [µJ]");
  EXPECT_EQ(grid.panels[2].y.label, "loss factor η [1]");
  EXPECT_NO_THROW(check_figure(grid));
}

TEST(PaperConstantResponse, IsAccelerationOverForce) {
  ExperimentResults made;
  made.responses = {{2.0, {50.0, 51.0}, {0.5, 0.25}}};
  const Figure figure = paper_constant_response(made);
  EXPECT_EQ(figure.y.label, "acceleration over force [m/s²/N]");
  EXPECT_EQ(layer<LineLayer>(figure, "2 m/s²").y, (Numbers{4.0, 8.0}));
  EXPECT_EQ(figure.layers.size(), made.responses.size());
}

TEST(PaperConstantResponse, OfTheTruthBeside) {
  ExperimentResults made;
  made.responses = {{2.0, {54.0, 55.0}, {0.5, 0.25}, {54.5, 55.5}, {0.4, 0.2}},
                    {4.0, {54.0, 55.0}, {1.0, 0.5}, {54.5, 55.5}, {0.8, 0.4}}};
  const Figure figure = paper_constant_response(made);
  ASSERT_EQ(figure.layers.size(), 4U);
  EXPECT_EQ(layer<LineLayer>(figure, "truth").x, (Numbers{54.5, 55.5}));
  EXPECT_EQ(layer<LineLayer>(figure, "truth").y, (Numbers{5.0, 10.0}));
  EXPECT_EQ(std::get<LineLayer>(figure.layers[3]).legend, "");
}

TEST(PaperDeviations, HasAPanelAChannel) {
  ExperimentResults made;
  made.comparisons = {{"a", "force", "converged", 50.0, 1.0, 0.02, 0.01, 1.0, 0.0},
                      {"a", "acc1", "converged", 50.0, 1.0, 0.04, 0.03, 1.0, 0.0},
                      {"b", "force", "converged", 49.0, 2.0, 0.06, 0.05, 1.0, 0.0}};
  const FigureGrid grid = paper_deviations(made);
  ASSERT_EQ(grid.panels.size(), 2U);
  EXPECT_EQ(grid.panels[0].title, "force");
  expect_near(layer<PointLayer>(grid.panels[0], "prediction").y, {2.0, 6.0});
  expect_near(layer<PointLayer>(grid.panels[0], "noise alone").y, {1.0, 5.0});
  expect_near(layer<PointLayer>(grid.panels[0], "prediction").x, {1.0, 2.0});
}

TEST(PaperFigures, SayWhatIsMissing) {
  EXPECT_TRUE(contains(input_fault([] { return paper_energies({}); }), "needs levels"));
  EXPECT_TRUE(
      contains(input_fault([] { return paper_density(ExperimentResults{}); }), "needs a joint"));
  EXPECT_TRUE(contains(input_fault([] { return paper_loops({}); }), "needs a joint"));
  EXPECT_TRUE(contains(input_fault([] { return paper_stiffness({}); }), "needs a joint"));
  EXPECT_TRUE(contains(input_fault([] { return paper_constant_response({}); }), "responses"));
  EXPECT_TRUE(contains(input_fault([] { return paper_deviations({}); }), "verification"));
}

}  // namespace
}  // namespace microslip::paper_figures_test
