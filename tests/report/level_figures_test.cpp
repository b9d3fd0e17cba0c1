// SPDX-License-Identifier: MIT
#include "microslip/report/figures/level_figures.hpp"

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
#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/figures/loops_figure.hpp"
#include "microslip/report/figures/rig_figures.hpp"
#include "report/support.hpp"

namespace microslip::level_figures_test {
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

/// With the required columns of levels alone.
MeasuredLevels two_levels() {
  MeasuredLevels made;
  made.levels.amplitude = {1e-5, 2e-5};
  made.levels.dissipation = {1e-6, 5e-6};
  return made;
}

TEST(EnergiesFigure, ShowsTheLevelsAndTheJointInReadableUnits) {
  const Figure figure = energies_figure(results());
  EXPECT_EQ(axis_text(figure.x), "joint amplitude A [µm]");
  EXPECT_EQ(axis_text(figure.y), "energy per cycle [µJ]");
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

TEST(EnergiesFigure, OfAmplitudesAndDissipationsAlone) {
  ExperimentResults bare;
  bare.levels = two_levels();
  const Figure figure = energies_figure(bare);
  ASSERT_EQ(figure.layers.size(), 1U);
  EXPECT_TRUE(layer<PointLayer>(figure, "joint, D").y_error.empty());
}

TEST(EnergiesFigure, AddsTheLinearDampingThatWasIdentified) {
  ExperimentResults damped = results();
  damped.joint->linear_damping = 30.0;
  const Figure figure = energies_figure(damped);
  const auto& joint = layer<LineLayer>(figure, "identified joint");
  const auto& total = layer<LineLayer>(figure, "with damping βA²");
  // 30 J/m² times (100 µm)² are 0.3 µJ.
  EXPECT_NEAR(total.y.back() - joint.y.back(), 0.3, 1e-9);
  EXPECT_EQ(layer<PointLayer>(figure, "D, with damping βA²").y.size(), 2U);
}

// Input 5 µJ and 400 µJ, of which the linear damping takes 3 µJ and 100 µJ.
TEST(LinearShareFigure, IsPercentOfTheInput) {
  FigureOptions options;
  options.beside = {LineLayer{{0.0, 1e-4}, {0.15, 0.15}, "15 %"}};
  const Figure figure = linear_share_figure(results(), options);
  EXPECT_EQ(axis_text(figure.y), "linear loss over input energy [%]");
  expect_near(layer<PointLayer>(figure, "linear loss").y, {60.0, 25.0});
  expect_near(layer<PointLayer>(figure, "linear loss").x, {20.0, 100.0});
  expect_near(layer<LineLayer>(figure, "15 %").y, {15.0, 15.0});
  EXPECT_EQ(figure.y.range->to, 100.0);
  ExperimentResults bare;
  bare.levels = two_levels();
  EXPECT_TRUE(contains(input_fault([&] { return linear_share_figure(bare); }), "linear loss"));
}

TEST(EnergiesFigure, TakesTheScaleThatIsAskedFor) {
  const Figure figure = energies_figure(results(), {.scale = AmplitudeScale::kLinear});
  EXPECT_FALSE(figure.x.log || figure.y.log);
}

TEST(DensityFigure, HasBandTruthOthersAndWhereLevelsAre) {
  ExperimentResults known = results();
  known.truth = uniform_joint();
  known.joint->band_confidence = 0.9;
  known.joint->band_slip_force = {1.0, 2.0, 10.0};
  known.joint->band_lower = {0.0, 0.04, 0.04};
  known.joint->band_upper = {1.0, 0.06, 0.06};
  const Figure figure = density_figure(known, {.others = {{"fit", uniform_joint()}}});
  EXPECT_EQ(axis_text(figure.x), "slip force f* [N]");
  EXPECT_EQ(axis_text(figure.y), "density φ [1/N]");
  // Below the lowest level the band is an assumption.
  EXPECT_EQ(layer<BandLayer>(figure, "90 % band").x, (Numbers{2.0, 10.0}));
  expect_near(layer<BandLayer>(figure, "90 % band").upper, {0.06, 0.06});
  EXPECT_EQ(layer<LineLayer>(figure, "identified joint").x.front(), 1.8);
  for (const char* name : {"identified joint", "truth", "fit"}) {
    const auto& line = layer<LineLayer>(figure, name);
    for (const double density : line.y) EXPECT_NEAR(density, 0.05, 1e-12) << name;
    EXPECT_EQ(line.x.back(), 10.0);
  }
  EXPECT_EQ(layer<LineLayer>(figure, "truth").stroke.style, LineStyle::kDashed);
  EXPECT_EQ(std::get<MarkerLayer>(figure.layers.back()).x, 10.0);
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(DensityFigure, LeavesOutWhatIsInfiniteAtZero) {
  ExperimentResults power;
  power.joint = IdentifiedJoint{.joint = Joint::four_parameter(400.0, 252660.0, -0.5, 1.0)};
  const Figure figure = density_figure(power);
  // Its atom at the end is no part of a density: half of k at β = 1, χ = −0.5.
  EXPECT_GT(layer<LineLayer>(figure, "joint without its atoms, 50.0 % of k").x.front(), 0.0);
  EXPECT_NO_THROW(check_figure(figure));
}

TEST(DensityFigure, RefusesAJointThatCannotSlip) {
  ExperimentResults spring;
  spring.joint = IdentifiedJoint{.joint = Joint(1e5, SlipDensity())};
  EXPECT_TRUE(contains(input_fault([&] { return density_figure(spring); }), "a part slips"));
}

TEST(LoopsFigure, EndAtTheVirginCurve) {
  const Figure figure = loops_figure(results());
  EXPECT_EQ(axis_text(figure.x), "joint displacement [µm]");
  EXPECT_EQ(axis_text(figure.y), "joint force [N]");
  for (const double amplitude : {100.0, 75.0, 50.0, 25.0}) {
    const auto& loop = layer<LoopLayer>(figure, "A = " + fmt::format("{:g}", amplitude) + " µm");
    EXPECT_NEAR(std::ranges::max(loop.x), amplitude, 1e-9);
    const double a = 1e-6 * amplitude;
    EXPECT_NEAR(std::ranges::max(loop.y), 1e5 * a - 0.05 * std::pow(1e5 * a, 2) / 2.0, 1e-9);
  }
}

TEST(LoopsFigure, WithoutLevelsReachTheMacroSlip) {
  ExperimentResults only;
  only.joint = IdentifiedJoint{.joint = uniform_joint()};
  const Figure figure = loops_figure(only);
  // 20 N over 1e5 N/m are 200 µm; the force is then 10 N, all that the sliders carry.
  EXPECT_NEAR(std::ranges::max(layer<LoopLayer>(figure, "A = 240 µm").y), 10.0, 1e-9);
}

TEST(ResonanceFigure, IsOverTheResponseWhereThatIsKnown) {
  const Figure figure = resonance_figure(results());
  EXPECT_EQ(axis_text(figure.x), "exciter acceleration [m/s²]");
  EXPECT_EQ(layer<PointLayer>(figure, "drive").y, (Numbers{50.0, 49.0}));
  EXPECT_EQ(layer<PointLayer>(figure, "resonance").x, (Numbers{1.0, 5.0}));
  ExperimentResults other = results();
  other.backbone = JointBackbone{{2e-5, 1e-4}, {50.1, 49.1}, {0.01, 0.02}};
  const Figure beside = resonance_figure(other, {}, FrequencyOver::kAmplitude);
  EXPECT_EQ(axis_text(beside.x), "joint amplitude A [µm]");
  EXPECT_EQ(layer<LineLayer>(beside, "predicted by the joint").y, (Numbers{50.1, 49.1}));
  expect_near(layer<PointLayer>(beside, "resonance").x, {20.0, 100.0});
  const Figure in_g = resonance_figure(other, {.response_unit = "g"});
  EXPECT_EQ(axis_text(in_g.x), "exciter acceleration [g]");
  expect_near(layer<PointLayer>(in_g, "drive").x, {1.0 / 9.80665, 5.0 / 9.80665});
  EXPECT_THROW((void)resonance_figure(other, {.response_unit = "mm"}), InputError);
  other.levels->response_amplitude.clear();
  EXPECT_EQ(axis_text(resonance_figure(other).x), "joint amplitude A [µm]");
  other.levels->frequency.clear();
  other.levels->resonance_frequency.clear();
  EXPECT_TRUE(contains(input_fault([&] { return resonance_figure(other); }), "frequencies"));
}

TEST(StiffnessFigure, ShowsSecantsWithTheirBars) {
  const Figure figure = stiffness_figure(results());
  EXPECT_EQ(axis_text(figure.y), "secant stiffness k_eq [kN/m]");
  EXPECT_FALSE(figure.x.log || figure.y.log);
  expect_near(layer<PointLayer>(figure, "measured").y, {90.0, 50.0});
  expect_near(layer<PointLayer>(figure, "measured").y_error, {0.9, 0.5});
  EXPECT_TRUE(stiffness_figure(results(), {.scale = AmplitudeScale::kLog}).x.log);
}

// D contains βA² beside the dissipation of the joint, and the loss factor is that of the joint.
TEST(DampingFigure, IsOfTheJointAlone) {
  ExperimentResults damped = results();
  damped.joint->linear_damping = 1000.0;
  const Figure figure = damping_figure(damped);
  EXPECT_NEAR(layer<PointLayer>(figure, "measured").y[0],
              (2e-6 - 1000.0 * 4e-10) / (std::numbers::pi * 9e4 * 4e-10), 1e-12);
}

// D 5 %, k 1 % and A 1 %: the deviations of D, of k and twice that of A, squared and added.
TEST(DampingFigure, PropagatesStandardDeviations) {
  const Figure figure = damping_figure(results());
  const auto& points = layer<PointLayer>(figure, "measured");
  const double loss = 2e-6 / (std::numbers::pi * 9e4 * 4e-10);
  EXPECT_NEAR(points.y[0], loss, 1e-12);
  EXPECT_NEAR(points.y_error[0], loss * std::sqrt(0.05 * 0.05 + 0.01 * 0.01 + 0.02 * 0.02), 1e-12);
}

TEST(DampingFigure, OfARingDownIsTheDampingRatio) {
  ExperimentResults decay;
  decay.levels = two_levels();
  decay.levels->damping_ratio = {0.01, 0.02};
  const Figure figure = damping_figure(decay);
  EXPECT_EQ(axis_text(figure.y), "damping ratio ζ of the mode [%]");
  expect_near(std::get<PointLayer>(figure.layers[0]).y, {1.0, 2.0});
}

TEST(JointFigures, HasThreePanels) {
  const FigureGrid grid = joint_figures(results());
  ASSERT_EQ(grid.panels.size(), 3U);
  EXPECT_EQ(axis_text(grid.panels[0].y), "dissipation per cycle D [µJ]");
  EXPECT_EQ(axis_text(grid.panels[2].y), "loss factor η [1]");
  EXPECT_NO_THROW(check_figure(grid));
}

TEST(ConstantResponseFigure, IsAccelerationOverForce) {
  ExperimentResults made;
  made.responses = {{2.0, {50.0, 51.0}, {0.5, 0.25}}};
  const Figure figure = constant_response_figure(made);
  EXPECT_EQ(axis_text(figure.y), "acceleration over force [m/s²/N]");
  EXPECT_EQ(layer<LineLayer>(figure, "2 m/s²").y, (Numbers{4.0, 8.0}));
  EXPECT_EQ(figure.layers.size(), made.responses.size());
}

TEST(ConstantResponseFigure, OfTheTruthBeside) {
  ExperimentResults made;
  made.responses = {{2.0, {54.0, 55.0}, {0.5, 0.25}, {54.5, 55.5}, {0.4, 0.2}},
                    {4.0, {54.0, 55.0}, {1.0, 0.5}, {54.5, 55.5}, {0.8, 0.4}}};
  const Figure figure = constant_response_figure(made);
  ASSERT_EQ(figure.layers.size(), 4U);
  EXPECT_EQ(layer<LineLayer>(figure, "true joint").x, (Numbers{54.5, 55.5}));
  EXPECT_EQ(layer<LineLayer>(figure, "true joint").y, (Numbers{5.0, 10.0}));
  EXPECT_EQ(layer<LineLayer>(figure, "true joint").stroke.style, LineStyle::kDotted);
  EXPECT_EQ(legend_of(figure.layers[3]), "true joint") << "one entry for both";
  EXPECT_EQ(name_of(figure.layers[3]), "4 m/s², true joint");
}

// Response over force at the frequency of the level.
TEST(ConstantResponseFigure, OfTheLevelsBeside) {
  ExperimentResults made = results();
  made.levels->force_amplitude = {0.5, 4.0};
  made.responses = {{2.0, {50.0, 51.0}, {0.5, 0.25}}};
  const Figure figure = constant_response_figure(made, {.response_unit = "g"});
  EXPECT_EQ(layer<PointLayer>(figure, "measured levels").x, (Numbers{50.0, 49.0}));
  EXPECT_EQ(layer<PointLayer>(figure, "measured levels").y, (Numbers{2.0, 1.25}));
  EXPECT_EQ(layer<LineLayer>(figure, "0.204 g").y, (Numbers{4.0, 8.0}));
}

TEST(DeviationFigures, HasAPanelAChannel) {
  ExperimentResults made;
  made.comparisons = {{"a", "force", "converged", 50.0, 1.0, 0.02, 0.01, 1.0, 0.0},
                      {"a", "acc1", "converged", 50.0, 1.0, 0.04, 0.03, 1.0, 0.0},
                      {"b", "force", "converged", 49.0, 2.0, 0.06, 0.05, 1.0, 0.0}};
  const std::vector<Figure> figures = deviation_figures(made);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].title, "force");
  expect_near(layer<PointLayer>(figures[0], "prediction").y, {2.0, 6.0});
  expect_near(layer<PointLayer>(figures[0], "noise alone").y, {1.0, 5.0});
  expect_near(layer<PointLayer>(figures[0], "prediction").x, {1.0, 2.0});
}

TEST(FiguresOfATest, SayWhatIsMissing) {
  EXPECT_TRUE(contains(input_fault([] { return energies_figure({}); }), "needs levels"));
  EXPECT_TRUE(
      contains(input_fault([] { return density_figure(ExperimentResults{}); }), "needs a joint"));
  EXPECT_TRUE(contains(input_fault([] { return loops_figure({}); }), "needs a joint"));
  EXPECT_TRUE(contains(input_fault([] { return stiffness_figure({}); }), "needs a joint"));
  EXPECT_TRUE(contains(input_fault([] { return constant_response_figure({}); }), "responses"));
  EXPECT_TRUE(contains(input_fault([] { return deviation_figures({}); }), "verification"));
}

}  // namespace
}  // namespace microslip::level_figures_test
