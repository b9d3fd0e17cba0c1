// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"
#include "support/figures.hpp"
#include "support/reference_csv.hpp"
#include "support/structures.hpp"

namespace microslip::harmonic_balance_test {
namespace {

using std::numbers::pi;

constexpr Quantity kFrequency = Quantity::kAngularFrequency;
constexpr Quantity kForce = Quantity::kForceAmplitude;
constexpr Quantity kResponse = Quantity::kResponse;

/// The promise of each solution; stored energy is a few hundred times that lost.
constexpr double kImbalance = 1e-8;

void expect_balanced(const ResponseCurve& curve) {
  EXPECT_TRUE(curve.summary.converged()) << curve.summary.full();
  for (const SteadyVibration& point : curve.points) {
    test::record_largest("energy imbalance [1]", point.energy_imbalance);
    EXPECT_LE(point.energy_imbalance, kImbalance) << point.angular_frequency;
  }
  for (const SteadyVibration& point : curve.peaks) EXPECT_LE(point.energy_imbalance, kImbalance);
}

// ---- One degree of freedom. ----

// Figures of another program, one harmonic, exact integrals. 4096 samples leave 2e-8.
TEST(FrequencyResponse, HasThePeakOfOneHarmonic) {
  const auto table = testing::reference_table("sdof_peak.csv");
  ASSERT_EQ(table.rows(), 3U);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Joint joint = row < 2 ? testing::iwan_joint() : testing::jenkins_joint();
    const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                  {.harmonics = 1, .samples = 4096});
    const ResponseCurve curve = balance.frequency_response(table["force [N]"][row], 0.8, 1.1);
    expect_balanced(curve);
    ASSERT_EQ(curve.peaks.size(), 1U);
    const double peak = table["peak_displacement [m]"][row];
    const double omega = table["angular_frequency [rad/s]"][row];
    EXPECT_NEAR(curve.peaks[0].response, peak, 1e-6 * peak);
    EXPECT_NEAR(curve.peaks[0].angular_frequency, omega, 1e-6 * omega);
    test::record_deviation("peak", curve.peaks[0].response, peak);
    test::record_deviation("peak", curve.peaks[0].angular_frequency, omega);
    EXPECT_EQ(curve.points.front().angular_frequency, 0.8);
    EXPECT_NEAR(curve.points.back().angular_frequency, 1.1, 1e-11);
  }
}

// Three public codes agree on 1.2274 m at 0.96057 rad/s to these digits; theirs are on a grid.
TEST(FrequencyResponse, HasTheJenkinsPeakOfThreeHarmonics) {
  const HarmonicBalance balance(testing::one_mass(testing::jenkins_joint()), {"mass"},
                                {.harmonics = 3, .samples = 1024});
  const ResponseCurve curve = balance.frequency_response(0.1, 0.8, 1.1);
  expect_balanced(curve);
  ASSERT_EQ(curve.peaks.size(), 1U);
  EXPECT_NEAR(curve.peaks[0].response, 1.2274, 3e-4);
  EXPECT_NEAR(curve.peaks[0].angular_frequency, 0.9606, 3e-4);
  test::record_largest("displacement [m]", curve.peaks[0].response);
  test::record_largest("frequency [rad/s]", curve.peaks[0].angular_frequency);
}

// One harmonic in closed form, with the describing function of the joint [AR14 (7)]:
// A = a |k + k_eq(a) − ω² + i(cω + D(a)/(πa²))|. Tolerance: 4096 samples leave 2e-8 of the joint's
// force, and near resonance the sum is a hundredth of its parts.
double force_at(const Joint& joint, double response, double omega) {
  const std::complex<double> stiffness(
      0.75 + secant_stiffness(joint, response) - omega * omega,
      0.01 * omega + dissipation(joint, response) / (pi * response * response));
  return response * std::abs(stiffness);
}

TEST(ConstantResponse, IsThatOfTheEquivalentLinearMass) {
  for (const Joint& joint : {testing::iwan_joint(), testing::jenkins_joint()}) {
    const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                  {.harmonics = 1, .samples = 4096});
    for (const double response : {0.1, 1.0, 3.0}) {
      const ResponseCurve curve = balance.constant_response(response, 0.8, 1.1);
      expect_balanced(curve);
      EXPECT_GE(curve.points.size(), 20U);
      EXPECT_TRUE(curve.turning_points.empty());
      for (const SteadyVibration& point : curve.points) {
        const double force = force_at(joint, response, point.angular_frequency);
        EXPECT_NEAR(point.force_amplitude, force, 1e-5 * force) << point.angular_frequency;
        EXPECT_NEAR(point.response, response, 1e-11);
      }
      ASSERT_EQ(curve.peaks.size(), 1U);  // the least force
      const double omega = curve.peaks[0].angular_frequency;
      const double least = force_at(joint, response, omega);
      EXPECT_LT(least, force_at(joint, response, omega * 1.0005));
      EXPECT_LT(least, force_at(joint, response, omega * 0.9995));
    }
  }
}

// At phase resonance ω² = k + k_eq(a), A = a (cω + D(a)/(πa²)).
TEST(Backbone, IsThatOfTheEquivalentLinearMass) {
  for (const Joint& joint : {testing::iwan_joint(), testing::jenkins_joint()}) {
    const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                  {.harmonics = 1, .samples = 4096});
    const std::vector<double> responses{1e-3, 0.1, 0.7, 0.81, 2.0, 20.0, 0.5};
    const ResponseCurve curve = balance.backbone(responses);
    expect_balanced(curve);
    ASSERT_EQ(curve.points.size(), responses.size());
    for (std::size_t i = 0; i < responses.size(); ++i) {
      const double a = responses[i];
      const double omega = std::sqrt(0.75 + secant_stiffness(joint, a));
      const double force = 0.01 * omega * a + dissipation(joint, a) / (pi * a);
      EXPECT_NEAR(curve.points[i].angular_frequency, omega, 1e-7 * omega) << a;
      EXPECT_NEAR(curve.points[i].force_amplitude, force, 1e-5 * force) << a;
      EXPECT_NEAR(curve.points[i].phase_lag, pi / 2, 1e-11);
    }
  }
}

TEST(Solve, FindsTheLevelWhoseResonanceIsAtAFrequency) {
  const Joint joint = testing::iwan_joint();
  const HarmonicBalance balance(testing::one_mass(joint), {"mass"},
                                {.harmonics = 1, .samples = 4096});
  const double response = 0.4;
  const double omega = std::sqrt(0.75 + secant_stiffness(joint, response));
  const VibrationResult found = balance.solve(kPhaseResonance, {kFrequency, omega});
  ASSERT_TRUE(found.summary.converged()) << found.summary.full();
  EXPECT_NEAR(found.vibration.response, response, 1e-5 * response);
  // Stuck it is 1 rad/s, in macro-slip √0.75 = 0.866 rad/s: nothing resonates elsewhere.
  for (const double elsewhere : {1.01, 0.86}) {
    const VibrationResult none = balance.solve({kFrequency, elsewhere}, kPhaseResonance);
    EXPECT_FALSE(none.summary.converged());
    EXPECT_NE(none.summary.reason.find("no response up to"), std::string::npos)
        << none.summary.reason;
  }
}

TEST(Solve, GoesOnFromAVibrationNearby) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"},
                                {.harmonics = 3, .samples = 256});
  const auto first = balance.solve({kFrequency, 0.93}, {kForce, 0.02});
  ASSERT_TRUE(first.summary.converged());
  // Force and response leave two frequencies; the start says which.
  const auto same =
      balance.solve({kForce, 0.02}, {kResponse, first.vibration.response * 1.01}, first.vibration);
  ASSERT_TRUE(same.summary.converged()) << same.summary.full();
  EXPECT_GT(same.vibration.angular_frequency, 0.93);
  EXPECT_LT(same.vibration.angular_frequency, 0.94);
  EXPECT_LE(same.vibration.energy_imbalance, kImbalance);
}

// The force has jumps of its second derivative at the reversals: its harmonics fall as n^-3 and
// what they make of the first one faster. Observed: order 4.1. 8192 samples keep their error below.
TEST(Solve, ConvergesInTheHarmonics) {
  const auto response = [](std::size_t harmonics) {
    const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"},
                                  {.harmonics = harmonics, .samples = 8192});
    const auto result = balance.solve({kFrequency, 0.9606}, {kForce, 0.1});
    EXPECT_TRUE(result.summary.converged()) << result.summary.full();
    return result.vibration.response;
  };
  const double exact = response(61);
  const double coarse = std::abs(response(3) - exact);
  const double middle = std::abs(response(7) - exact);
  const double fine = std::abs(response(15) - exact);
  EXPECT_LT(coarse, 3e-6);
  EXPECT_LT(middle, coarse * std::pow(3.0 / 7.0, 3.5));
  EXPECT_LT(fine, middle * std::pow(7.0 / 15.0, 3.5));
}

// ---- Linear limits. ----

// Without joints the balance is the receptance, to rounding; each harmonic of the force makes its
// own.
TEST(FrequencyResponse, WithoutJointsIsTheReceptance) {
  const std::vector<Mode> modes{{30.0, 0.01}, {55.0, 0.004}, {90.0, 0.02}};
  const ModalModel linear(modes, {{"in", {1.0, -0.5, 0.3}}, {"out", {0.4, 0.8, -1.0}}});
  for (const DampingLaw law : {DampingLaw::kViscous, DampingLaw::kHysteretic}) {
    const std::complex<double> second(0.2, -0.1);
    const HarmonicBalance balance(JointedStructure(linear, {}, {{"in", {1.0, second}}}, law),
                                  {"out", ResponseKind::kAcceleration}, {.harmonics = 3});
    const ResponseCurve curve = balance.frequency_response(2.0, 20.0, 70.0);
    expect_balanced(curve);
    EXPECT_EQ(curve.peaks.size(), 2U);
    for (const SteadyVibration& point : curve.points) {
      const double omega = point.angular_frequency;
      const std::complex<double> first = 2.0 * linear.receptance("out", "in", omega, law);
      EXPECT_NEAR(point.response, omega * omega * std::abs(first), 1e-12 * point.response);
      const auto displacement = point.displacement(linear, "out");
      const auto doubled = 2.0 * second * linear.receptance("out", "in", 2.0 * omega, law);
      EXPECT_LT(std::abs(displacement[1] - first), 1e-12 * std::abs(first));
      EXPECT_LT(std::abs(displacement[2] - doubled), 1e-12 * std::abs(doubled));
    }
  }
}

// With 1e-9 of the macro-slip force the density of the reference joint slips by 1e-9.
TEST(FrequencyResponse, AtSmallForceIsThatOfTheStuckStructure) {
  const Joint joint = testing::reference_joint();
  const double k = joint.stiffness();
  const JointedStructure structure = testing::one_mass(joint, k, 10.0);
  const HarmonicBalance balance(structure, {"mass"});
  const double stuck = std::sqrt(2.0 * k);
  ASSERT_EQ(structure.stuck_frequencies().size(), 1U);
  EXPECT_NEAR(structure.stuck_frequencies()[0], stuck, 1e-12 * stuck);
  const ModalModel linear({{stuck, 10.0 / stuck}}, {{"mass", {1.0}}});
  const ResponseCurve curve = balance.frequency_response(1e-9, 0.9 * stuck, 1.1 * stuck);
  expect_balanced(curve);
  EXPECT_EQ(curve.peaks.size(), 1U);
  for (const SteadyVibration& point : curve.points) {
    const double expected =
        1e-9 * std::abs(linear.receptance("mass", "mass", point.angular_frequency));
    EXPECT_NEAR(point.response, expected, 1e-7 * expected);
  }
}

// ---- What modes may contain. ----

// The modes of the stuck structure with the spring taken out, and those without it, are the same
// structure.
TEST(JointedStructure, TakesOutTheSpringOfItsModes) {
  const Joint joint = testing::jenkins_joint();
  const double stuck = 1.0;
  const ModalModel modes({{stuck, 0.01 / stuck}}, {{"mass", {1.0}}});
  StructuralJoint held{.name = "joint", .joint = joint, .shape = {1.0}, .spring_in_modes = 0.25};
  const HarmonicBalance with(JointedStructure(modes, {held}, {{"mass"}}), {"mass"});
  const HarmonicBalance without(testing::one_mass(joint), {"mass"});
  for (const double omega : {0.9, 0.96, 1.0, 1.05}) {
    const auto one = with.solve({kFrequency, omega}, {kForce, 0.1});
    const auto other = without.solve({kFrequency, omega}, {kForce, 0.1});
    ASSERT_TRUE(one.summary.converged() && other.summary.converged());
    EXPECT_NEAR(one.vibration.response, other.vibration.response, 1e-9) << omega;
  }
}

// A body that only its joint holds: at rest nothing but the joint keeps its place.
TEST(JointedStructure, MayBeHeldByItsJointAlone) {
  const Joint joint = testing::iwan_joint();
  const ModalModel body({{0.0, 0.0}}, {{"mass", {1.0}}});
  const HarmonicBalance balance(JointedStructure(body, {{"joint", joint, {1.0}}}, {{"mass"}}),
                                {"mass"}, {.harmonics = 1, .samples = 4096});
  for (const double a : {0.05, 0.4}) {
    const auto result = balance.solve(kPhaseResonance, {kResponse, a});
    ASSERT_TRUE(result.summary.converged()) << result.summary.full();
    const double omega = std::sqrt(secant_stiffness(joint, a));
    EXPECT_NEAR(result.vibration.angular_frequency, omega, 1e-7 * omega);
    EXPECT_NEAR(result.vibration.force_amplitude, dissipation(joint, a) / (pi * a),
                1e-6 * dissipation(joint, a) / (pi * a));
    EXPECT_LE(result.vibration.energy_imbalance, kImbalance);
  }
}

// Where the receptance without joint is infinite the mass moves as it does beside that place: with
// one harmonic by the closed form. 4096 samples leave 1e-11 of the joint's force.
TEST(Solve, AtThePoleOfAnUndampedMode) {
  const Joint joint = testing::iwan_joint();
  const HarmonicBalance balance(testing::one_mass(joint, 1.0, 0.0), {"mass"},
                                {.harmonics = 1, .samples = 4096});
  for (const double omega : {1.0, 1.0 + 1e-14, 1.0 + 1e-9}) {
    const auto result = balance.solve({kFrequency, omega}, {kForce, 0.05});
    ASSERT_TRUE(result.summary.converged()) << result.summary.full();
    const double a = result.vibration.response;
    const std::complex<double> stiffness(1.0 - omega * omega + secant_stiffness(joint, a),
                                         dissipation(joint, a) / (pi * a * a));
    EXPECT_NEAR(std::abs(stiffness) * a, 0.05, 1e-8 * 0.05) << omega;
    EXPECT_LE(result.vibration.energy_imbalance, kImbalance);
  }
  // The pole of the third harmonic.
  const HarmonicBalance three(testing::one_mass(joint, 1.0, 0.0), {"mass"}, {.harmonics = 3});
  const auto at = three.solve({kFrequency, 1.0 / 3.0}, {kForce, 0.05});
  const auto beside = three.solve({kFrequency, 1.0 / 3.0 + 1e-9}, {kForce, 0.05});
  ASSERT_TRUE(at.summary.converged() && beside.summary.converged()) << at.summary.full();
  EXPECT_NEAR(at.vibration.response, beside.vibration.response, 1e-7 * at.vibration.response);
}

// The same structure in other units has the same vibration: metres become micrometres or
// gigametres, newtons giga- or nanonewtons. Rounding, times the quality of the resonance.
TEST(Solve, KnowsNoUnits) {
  const auto response = [](double metre, double newton) {
    const double mass = newton / metre;  // 1 kg in these units, seconds kept
    const Joint joint = Joint::four_parameter(0.2 * newton, 0.25 * newton / metre, -0.5, 0.0);
    const double omega = std::sqrt(0.75);
    const double shape = 1.0 / std::sqrt(mass);
    const ModalModel linear({{omega, 0.01 / omega}, {3.0, 0.01}}, {{"mass", {shape, 0.5 * shape}}});
    const HarmonicBalance balance(
        JointedStructure(linear, {{"joint", joint, {shape, -0.3 * shape}}}, {{"mass"}}), {"mass"});
    const ResponseCurve curve = balance.frequency_response(0.05 * newton, 0.8, 1.1);
    EXPECT_TRUE(curve.summary.converged()) << curve.summary.full();
    return curve.peaks.at(0).response / metre;
  };
  const double expected = response(1.0, 1.0);
  for (const double metre : {1e-9, 1e6}) {
    for (const double newton : {1e-9, 1e9}) {
      EXPECT_NEAR(response(metre, newton), expected, 1e-8 * expected) << metre << ", " << newton;
    }
  }
}

// ---- Curves over other quantities. ----

// At a fixed frequency over the force, at phase resonance over the response: each point is the
// solution that is found there from the stuck structure, to the tolerance over the conditioning.
TEST(Follow, OverForceAndResponseIsWhatSolveFinds) {
  const JointedStructure structure = testing::one_mass(testing::iwan_joint());
  const HarmonicBalance balance(structure, {"mass"}, {.harmonics = 3});
  const ResponseCurve forces = balance.follow({kFrequency, 0.97}, kForce, 0.001, 0.3);
  expect_balanced(forces);
  EXPECT_EQ(forces.points.back().force_amplitude, 0.3);
  for (std::size_t i = 0; i < forces.points.size(); i += 5) {
    const SteadyVibration& point = forces.points[i];
    EXPECT_NEAR(point.angular_frequency, 0.97, 1e-11);
    const auto alone = balance.solve({kFrequency, 0.97}, {kForce, point.force_amplitude});
    ASSERT_TRUE(alone.summary.converged());
    EXPECT_NEAR(point.response, alone.vibration.response, 1e-9 * point.response);
  }
  const ResponseCurve responses = balance.follow(kPhaseResonance, kResponse, 3.0, 0.01);
  expect_balanced(responses);
  for (std::size_t i = 0; i < responses.points.size(); i += 5) {
    const SteadyVibration& point = responses.points[i];
    const auto alone = balance.solve(kPhaseResonance, {kResponse, point.response});
    ASSERT_TRUE(alone.summary.converged());
    EXPECT_NEAR(point.angular_frequency, alone.vibration.angular_frequency, 1e-9);
    EXPECT_NEAR(point.force_amplitude, alone.vibration.force_amplitude,
                1e-9 * point.force_amplitude);
  }
}

// ---- Turning back. ----

// A joint that never slips on a structure that it only feels by shortening: N = ½kΓq², a Duffing
// oscillator q̈ + ηω₀q̇ + ω₀²q + βq³ = f with β = ½kΓ². Kept to two harmonics u = −½Γq² is exact
// for a q of one, and the curve is |ω₀² − ω² + ¾βa² + iηω₀ω| a = A: it turns back twice.
TEST(FrequencyResponse, RetracesACurveThatTurnsBack) {
  const Joint spring(100.0, SlipDensity());
  StructuralJoint tie{.name = "tie", .joint = spring, .shape = {0.0}, .shortening = {0.3}};
  const double beta = 0.5 * 100.0 * 0.3 * 0.3;
  const ModalModel linear({{1.0, 0.02}}, {{"mass", {1.0}}});
  const HarmonicBalance balance(JointedStructure(linear, {tie}, {{"mass"}}), {"mass"},
                                {.harmonics = 2, .samples = 16});
  // Where the curve is steep a residual of 1e-12 is 1e-10 of the force.
  const double force = 0.01;
  const auto deviation = [&](const SteadyVibration& point) {
    const double a = point.response;
    const double omega = point.angular_frequency;
    const std::complex<double> z(1.0 - omega * omega + 0.75 * beta * a * a, 0.02 * omega);
    return std::abs(z) * a / force - 1.0;
  };
  for (const bool up : {true, false}) {
    const ResponseCurve curve = up ? balance.frequency_response(force, 0.5, 2.0)
                                   : balance.frequency_response(force, 2.0, 0.5);
    expect_balanced(curve);
    ASSERT_EQ(curve.peaks.size(), 1U);
    EXPECT_NEAR(deviation(curve.peaks[0]), 0.0, 1e-9);
    // Going up it turns back at its tip, going down at the foot of the fold.
    ASSERT_EQ(curve.turning_points.size(), 2U);
    const double tip = curve.points[curve.turning_points[up ? 0 : 1]].angular_frequency;
    const double foot = curve.points[curve.turning_points[up ? 1 : 0]].angular_frequency;
    EXPECT_GT(tip, foot + 0.05);
    EXPECT_NEAR(tip, curve.peaks[0].angular_frequency, 0.01);
    for (const SteadyVibration& point : curve.points) {
      EXPECT_NEAR(deviation(point), 0.0, 1e-9) << point.angular_frequency;
    }
  }
}

// Ranges that end on the way to the tip: a step that passes the end may have turned behind it,
// which is none of the curve's.
TEST(FrequencyResponse, KnowsNoTurningPointBeyondItsRange) {
  StructuralJoint tie{
      .name = "tie", .joint = Joint(100.0, SlipDensity()), .shape = {0.0}, .shortening = {0.3}};
  const ModalModel linear({{1.0, 0.02}}, {{"mass", {1.0}}});
  const HarmonicBalance balance(JointedStructure(linear, {tie}, {{"mass"}}), {"mass"},
                                {.harmonics = 2, .samples = 16});
  const double tip = balance.frequency_response(0.01, 0.5, 2.0).peaks.at(0).angular_frequency;
  for (double margin = 1e-4; margin < 0.1; margin *= 1.2) {
    const ResponseCurve curve = balance.frequency_response(0.01, 0.5, tip - margin);
    expect_balanced(curve);
    const bool turns =
        !std::ranges::is_sorted(curve.points, {}, &SteadyVibration::angular_frequency);
    EXPECT_EQ(!curve.turning_points.empty(), turns) << margin;
  }
}

// ---- The friction rig. ----

// The virtual test of [AR14] by another program: Hermite elements, hybrid Newton, samples on a
// grid; it states an error of 1e-4.
TEST(Backbone, OfTheFrictionRigIsThatOfAnotherProgram) {
  const auto table = testing::reference_table("reference_rig_levels.csv");
  const HarmonicBalance balance(testing::friction_rig(), {"force", ResponseKind::kAcceleration},
                                {.harmonics = 9, .samples = 512});
  const ResponseCurve curve = balance.backbone(table["response_amplitude [m/s^2]"]);
  expect_balanced(curve);
  ASSERT_EQ(curve.points.size(), table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const SteadyVibration& point = curve.points[i];
    const JointCycle& joint = point.joints[0];
    const auto expect = [&](const std::string& column, double value, double tolerance) {
      const double expected = table[column][i];
      EXPECT_NEAR(value, expected, tolerance * std::abs(expected)) << column << ", row " << i;
      test::record_deviation(column.substr(0, column.find(" [")), value, expected);
    };
    expect("frequency [Hz]", point.frequency(), 1e-5);
    expect("force_amplitude [N]", point.force_amplitude, 2e-3);
    expect("amplitude [m]", joint.amplitude, 5e-4);
    expect("mean_displacement [m]", joint.displacement[0].real(), 2e-3);
    expect("dissipation [J]", joint.dissipation, 1e-3);
    expect("input_energy [J]", point.input_energy, 1e-3);
    expect("linear_dissipation [J]", point.linear_dissipation, 1e-3);
    const auto acceleration = point.acceleration(balance.structure().linear(), "force");
    expect("acceleration_harmonic2 [m/s^2]", std::abs(acceleration[2]), 2e-2);
    expect("acceleration_harmonic3 [m/s^2]", std::abs(acceleration[3]), 2e-2);
    const double loop = dissipation(testing::reference_joint(), joint.amplitude);
    EXPECT_NEAR(joint.dissipation, loop, 1e-4 * loop);  // the harmonics above 9 are not in it
  }
}

// Through the resonance at constant force and at constant response, with the shortening: each point
// keeps its energy, and both curves meet at the peak.
TEST(FrequencyResponse, OfTheFrictionRigKeepsItsEnergy) {
  const HarmonicBalance balance(testing::friction_rig(), {"force", ResponseKind::kAcceleration},
                                {.harmonics = 5, .samples = 128});
  const ResponseCurve force = balance.frequency_response(2.0, 2.0 * pi * 52.0, 2.0 * pi * 58.0);
  expect_balanced(force);
  ASSERT_EQ(force.peaks.size(), 1U);
  const ResponseCurve response =
      balance.constant_response(force.peaks[0].response, 2.0 * pi * 52.0, 2.0 * pi * 58.0);
  expect_balanced(response);
  ASSERT_EQ(response.peaks.size(), 1U);
  EXPECT_NEAR(response.peaks[0].force_amplitude, 2.0, 1e-3);
}

// ---- What cannot be. ----

// Nothing is lost: each point has a balance to keep all the same, but none can be at the resonance.
// The range leaves out 0.5 rad/s, where harmonic 2 may vibrate freely.
TEST(FrequencyResponse, WithoutLossEndsAtItsResonance) {
  const Joint spring(0.25, SlipDensity());
  const HarmonicBalance balance(testing::one_mass(spring, 0.75, 0.0), {"mass"});
  const ResponseCurve below = balance.frequency_response(0.02, 0.52, 0.99);
  expect_balanced(below);
  const ResponseCurve across = balance.frequency_response(0.02, 0.52, 1.5);
  for (const SteadyVibration& point : across.points) {
    EXPECT_LE(point.energy_imbalance, kImbalance) << point.angular_frequency;
    EXPECT_TRUE(std::isfinite(point.response));
  }
  EXPECT_FALSE(across.summary.converged());
  EXPECT_NE(across.summary.reason.find(" Hz"), std::string::npos) << across.summary.reason;
}

// A mode that no joint touches, undamped and at its pole: its response is infinite.
// Two modes without loss whose motions cancel at the joint at some 70.16 Hz, between and beyond
// which it moves and slips. Beside a place where it stands still the stuck structure is linear:
// there the response is the receptance of its modes with the spring k.
TEST(FrequencyResponse, PassesWhereAJointStandsStill) {
  const Joint joint(2e4, SlipDensity({UniformPart{0.0, 20.0, 0.8}}));
  const JointedStructure structure(
      ModalModel({{2.0 * pi * 20.0, 0.0}, {2.0 * pi * 50.0, 0.0}}, {{"d", {0.7, 0.5}}}),
      {{.name = "joint", .joint = joint, .shape = {0.8, -0.6}}}, {{"d"}});
  const HarmonicBalance balance(structure, {"d"});
  for (const bool upward : {true, false}) {
    const double from = 2.0 * pi * (upward ? 60.0 : 100.0);
    const double to = 2.0 * pi * (upward ? 100.0 : 60.0);
    const ResponseCurve curve = balance.frequency_response(1.0, from, to);
    ASSERT_TRUE(curve.summary.converged()) << curve.summary.full();
    EXPECT_NEAR(curve.points.back().angular_frequency, to, 1e-9 * to);
    const auto still = std::ranges::min_element(
        curve.points, {}, [](const SteadyVibration& v) { return v.joints[0].amplitude; });
    // Where u = 0 the joint has no force, and 0.8·0.7/(ω₁² − ω²) = 0.6·0.5/(ω₂² − ω²).
    const double squares = (0.56 * 2500.0 - 0.3 * 400.0) / (0.56 - 0.3);
    EXPECT_NEAR(still->frequency(), std::sqrt(squares), 1e-3);
    const double a = 400.0 - squares;
    const double b = 2500.0 - squares;
    EXPECT_NEAR(still->response, std::abs(0.49 / a + 0.25 / b) / (4.0 * pi * pi),
                1e-3 * still->response);
  }
}

TEST(Solve, SaysThatTheEquationsAreNotFinite) {
  const ModalModel linear({{1.0, 0.0}, {2.0, 0.01}}, {{"mass", {1.0, 1.0}}});
  const HarmonicBalance balance(
      JointedStructure(linear, {{"joint", testing::iwan_joint(), {0.0, 1.0}}}, {{"mass"}}),
      {"mass"});
  const auto result = balance.solve({kFrequency, 1.0}, {kForce, 0.1});
  EXPECT_FALSE(result.summary.converged());
  EXPECT_NE(result.summary.reason.find("not finite"), std::string::npos) << result.summary.reason;
  const ResponseCurve curve = balance.frequency_response(0.1, 1.0, 1.2);
  EXPECT_TRUE(curve.points.empty());
  EXPECT_NE(curve.summary.reason.find("the first point"), std::string::npos);
}

// Far beyond resonance the other mode rules the phase at "a": no resonance of mode 0 has this
// level.
TEST(Backbone, ThatTurnsBackSaysSo) {
  const ModalModel linear({{1.0, 0.02}, {1.1, 0.02}}, {{"a", {1.0, 1.2}}, {"b", {1.0, -0.4}}});
  const HarmonicBalance balance(
      JointedStructure(linear, {{"joint", testing::iwan_joint(), {1.0, 0.2}}}, {{"a"}}), {"b"});
  const std::vector<double> responses{0.01, 0.1, 1.0, 10.0, 100.0};
  const ResponseCurve curve = balance.backbone(responses);
  for (const SteadyVibration& point : curve.points) {
    EXPECT_LE(point.energy_imbalance, kImbalance);
    EXPECT_NEAR(std::sin(point.phase_lag), point.phase_lag > 0.0 ? 1.0 : -1.0, 1e-10);
  }
  if (!curve.summary.converged()) {
    EXPECT_NE(curve.summary.reason.find("on the way to"), std::string::npos);
  }
}

// The range ends right behind the peak, in the step that holds it, or right before it.
TEST(FrequencyResponse, HasThePeakOfItsLastStep) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  for (const bool up : {true, false}) {
    const double from = up ? 0.63 : 1.2;
    const double sign = up ? 1.0 : -1.0;
    const ResponseCurve whole = balance.frequency_response(0.1, from, up ? 1.2 : 0.63);
    ASSERT_EQ(whole.peaks.size(), 1U);
    const double peak = whole.peaks[0].angular_frequency;
    for (const double margin : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const ResponseCurve with = balance.frequency_response(0.1, from, peak + sign * margin);
      expect_balanced(with);
      ASSERT_EQ(with.peaks.size(), 1U) << margin;
      EXPECT_NEAR(with.peaks[0].angular_frequency, peak, 1e-7) << margin;
      const ResponseCurve without = balance.frequency_response(0.1, from, peak - sign * margin);
      expect_balanced(without);
      EXPECT_TRUE(without.peaks.empty()) << margin;
    }
  }
}

TEST(FrequencyResponse, WithoutTheResonanceHasNoPeak) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  const ResponseCurve curve = balance.frequency_response(0.02, 1.2, 2.0);
  expect_balanced(curve);
  EXPECT_TRUE(curve.peaks.empty());
  EXPECT_GE(curve.points.size(), 20U);
}

// ---- Progress. ----

// Once for each point, those between others too, and once more at the end of the range; never less
// than before.
TEST(FrequencyResponse, TellsItsProgressAndCanBeCancelled) {
  for (const double accuracy : {0.0, 0.002}) {
    const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"},
                                  {.accuracy = accuracy});
    for (const bool up : {true, false}) {
      std::vector<std::size_t> reported;
      const Progress listen = [&](std::size_t done, std::size_t total) {
        EXPECT_EQ(total, 1000U);
        reported.push_back(done);
        return true;
      };
      const ResponseCurve curve = up ? balance.frequency_response(0.02, 0.8, 1.1, listen)
                                     : balance.constant_response(0.5, 1.1, 0.8, listen);
      EXPECT_TRUE(curve.summary.converged());
      EXPECT_EQ(reported.size(), curve.points.size() + 1);
      EXPECT_TRUE(std::ranges::is_sorted(reported));
      EXPECT_EQ(reported.front(), 0U);
      EXPECT_EQ(reported.back(), 1000U);
      if (accuracy > 0.0) continue;
      // Of the points of the steps the last alone is at the whole.
      const auto whole = std::ranges::lower_bound(reported, std::size_t{999});
      EXPECT_LE(reported.end() - whole, 2);
    }
  }
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  std::size_t calls = 0;
  const Progress cancel = [&](std::size_t, std::size_t) { return ++calls < 3; };
  EXPECT_THROW((void)balance.frequency_response(0.02, 0.8, 1.1, cancel), Cancelled);
  EXPECT_EQ(calls, 3U);
  const std::vector<double> responses{0.1, 0.2, 0.3, 0.4};
  calls = 0;
  EXPECT_THROW((void)balance.backbone(responses, 0, cancel), Cancelled);
  EXPECT_EQ(calls, 3U);
}

// The progress of a curve that turns back does not fall.
TEST(FrequencyResponse, NeverTellsLessProgress) {
  const ModalModel linear({{1.0, 0.02}}, {{"mass", {1.0}}});
  const StructuralJoint tie{
      .name = "tie", .joint = Joint(100.0, SlipDensity()), .shape = {0.0}, .shortening = {0.3}};
  const HarmonicBalance balance(JointedStructure(linear, {tie}, {{"mass"}}), {"mass"},
                                {.harmonics = 2, .samples = 16});
  std::size_t last = 0;
  const ResponseCurve curve =
      balance.frequency_response(0.01, 0.5, 2.0, [&](std::size_t done, std::size_t) {
        EXPECT_GE(done, last);
        last = done;
        return true;
      });
  EXPECT_EQ(curve.turning_points.size(), 2U);
  EXPECT_EQ(last, 1000U);
}

TEST(FrequencyResponse, ThatStopsSaysWhereAndKeepsWhatItHas) {
  const HarmonicBalance few(testing::one_mass(testing::iwan_joint()), {"mass"}, {.max_points = 5});
  const ResponseCurve curve = few.frequency_response(0.02, 0.8, 1.1);
  EXPECT_FALSE(curve.summary.converged());
  EXPECT_EQ(curve.points.size(), 5U);
  EXPECT_NE(curve.summary.reason.find("max_points = 5"), std::string::npos);
  EXPECT_NE(curve.summary.reason.find(" Hz, force 0.02 N"), std::string::npos)
      << curve.summary.reason;

  const HarmonicBalance hasty(testing::one_mass(testing::jenkins_joint()), {"mass"},
                              {.max_iterations = 2});
  const auto result = hasty.solve(kPhaseResonance, {kResponse, 2.0});
  EXPECT_FALSE(result.summary.converged());
  EXPECT_NE(result.summary.reason.find("reached"), std::string::npos) << result.summary.reason;
  const std::vector<double> responses{2.0};
  const ResponseCurve backbone = hasty.backbone(responses);
  EXPECT_FALSE(backbone.summary.converged());
  EXPECT_NE(backbone.summary.reason.find("on the way to 2"), std::string::npos)
      << backbone.summary.reason;
}

}  // namespace
}  // namespace microslip::harmonic_balance_test
