// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/missing_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/dynamics/structure/residual_flexibility.hpp"
#include "support/messages.hpp"

namespace microslip::missing_modes_test {
namespace {

using test::expect_message;
using test::message_or;

constexpr double kPi = std::numbers::pi;
constexpr double kWave = 1000.0;    // c/L of the bar, 1/s; EA/L = 1e6 N/m with its mass of 1 kg
constexpr double kStiffness = 2e6;  // of the joint, N/m
constexpr double kDrive = 0.45;     // where it is driven, over the length
constexpr std::size_t kMany = 60;   // modes of what counts as the truth

SlipDensity uniform() { return SlipDensity({UniformPart{0.0, 20.0, 0.9}}); }

/// A bar of 1 kg, fixed at its far end, by n modes in closed form: ω_i = (i − ½)π c/L, φ_i(x) = √2
/// cos((i − ½)πx/L) kg^−½. A joint holds its near end, a force drives it inside.
JointedStructure bar(std::size_t n) {
  std::vector<Mode> modes;
  ModalPoint inside{"inside", {}};
  StructuralJoint end{"end", Joint(kStiffness, uniform()), {}};
  for (std::size_t i = 1; i <= n; ++i) {
    const double number = (static_cast<double>(i) - 0.5) * kPi;
    modes.push_back({number * kWave, 0.003});
    inside.shape.push_back(std::numbers::sqrt2 * std::cos(number * kDrive));
    end.shape.push_back(std::numbers::sqrt2);
  }
  return {ModalModel(std::move(modes), {std::move(inside)}),
          {std::move(end)},
          {{"inside"}},
          DampingLaw::kHysteretic};
}

/// Σ φ_i(p) φ_i(q)/ω_i² of the modes, m/N; the joint where `joint` is true, the point else.
double in_modes(const JointedStructure& structure, bool first, bool second) {
  const auto shape = [&](bool joint) {
    return joint ? std::span<const double>(structure.joints()[0].shape)
                 : structure.linear().shape("inside");
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < structure.linear().size(); ++i) {
    const double omega = structure.linear().modes()[i].angular_frequency;
    sum += shape(first)[i] * shape(second)[i] / (omega * omega);
  }
  return sum;
}

/// Compliance of the bar at x under a force at y: the part between the farther of them and the
/// support, (1 − max(x, y)) L/(EA). In closed form.
double compliance(double x, double y) { return (1.0 - std::max(x, y)) / (kWave * kWave); }

ResidualFlexibility residual_of(const JointedStructure& structure) {
  const double between = compliance(kDrive, 0.0) - in_modes(structure, false, true);
  return {{"inside"},
          {"end"},
          {compliance(kDrive, kDrive) - in_modes(structure, false, false), between, between,
           compliance(0.0, 0.0) - in_modes(structure, true, true)}};
}

SteadyVibration peak_of(const JointedStructure& structure) {
  const HarmonicBalance balance(structure, {"inside"}, {.harmonics = 3});
  const ResponseCurve curve =
      balance.frequency_response(300.0, 2.0 * kPi * 220.0, 2.0 * kPi * 320.0);
  EXPECT_TRUE(curve.summary.converged());
  EXPECT_FALSE(curve.peaks.empty());
  return *std::ranges::max_element(curve.peaks, {}, &SteadyVibration::response);
}

// Against the compliance of a bar in closed form. The estimate knows the trend of the modes alone:
// a factor of two is what is promised.
TEST(MissingModes, AreThoseOfABarToAFactorOfTwo) {
  for (const std::size_t n : {2U, 3U, 5U, 8U, 20U, 60U}) {
    const JointedStructure structure = bar(n);
    const double truth = compliance(0.0, 0.0) - in_modes(structure, true, true);
    const std::vector<MissingCompliance> found = missing_compliance(structure);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].in_modes, in_modes(structure, true, true), 1e-20);
    EXPECT_LT(found[0].missing, 2.0 * truth) << n;
    EXPECT_GT(found[0].missing, 0.5 * truth) << n;
    EXPECT_EQ(found[0].over_joint(), kStiffness * found[0].missing);
  }
}

// A cantilever of mass 1 with a joint at its tip: φ_i(L) = 2, ω_i = λ_i² √(EI/(mL³)), λ_i from
// tables of cos λ cosh λ = −1; the compliance of its tip is L³/(3EI), 1/3 here.
TEST(MissingModes, AreThoseOfACantileverToAFactorOfTwo) {
  const std::vector<double> lambda{1.875104068711961, 4.694091132974175, 7.854757438237613,
                                   10.995540734875467, 14.137168391046470};
  for (std::size_t n = 2; n <= lambda.size(); ++n) {
    std::vector<Mode> modes;
    double held = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      modes.push_back({lambda[i] * lambda[i]});
      held += 4.0 / std::pow(lambda[i], 4.0);
    }
    const std::vector<double> tip(n, 2.0);
    const JointedStructure structure(ModalModel(std::move(modes), {{"tip", tip}}),
                                     {{"joint", Joint(1.0, uniform()), tip}}, {{"tip"}});
    const double truth = 1.0 / 3.0 - held;
    const std::vector<MissingCompliance> found = missing_compliance(structure);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_LT(found[0].missing, 2.0 * truth) << n;
    EXPECT_GT(found[0].missing, 0.5 * truth) << n;
  }
}

// With the residual in closed form two modes have the peak of sixty to a thousandth; without it
// theirs is 0.8 % and 0.13 % in frequency beside it. (The residual alone across the joint does not
// help the height: what it shares with the driven point matters as much.)
TEST(MissingModes, AreThereByTheirResidual) {
  const SteadyVibration truth = peak_of(bar(kMany));
  for (const std::size_t n : {2U, 3U, 5U}) {
    const JointedStructure few = bar(n);
    const JointedStructure whole = with_further_modes(few, static_modes(few, residual_of(few)));
    EXPECT_EQ(whole.linear().size(), n + 2);
    EXPECT_EQ(whole.linear().vibrations(), n);
    EXPECT_EQ(whole.stuck_frequencies().size(), n);  // the static ones are none
    EXPECT_THROW((void)whole.stuck_mode(n), InputError);
    EXPECT_NEAR(in_modes(whole, true, true), compliance(0.0, 0.0), 1e-18);
    EXPECT_NEAR(in_modes(whole, true, false), compliance(0.0, kDrive), 1e-18);
    const SteadyVibration peak = peak_of(whole);
    EXPECT_NEAR(peak.response, truth.response, 1e-3 * truth.response) << n;
    EXPECT_NEAR(peak.frequency(), truth.frequency(), 1e-4 * truth.frequency()) << n;
  }
  const SteadyVibration short_of = peak_of(bar(2));
  EXPECT_GT(std::abs(short_of.response / truth.response - 1.0), 5e-3);
  EXPECT_GT(std::abs(short_of.frequency() / truth.frequency() - 1.0), 1e-3);
}

/// The bar with its end on a spring of k = κ EA/L that the modes contain: λ cot λ = −κ, the shapes
/// sin(λ(1 − x/L)), of unit modal mass.
JointedStructure sprung_bar(std::size_t n, double kappa) {
  const double k = kappa * kWave * kWave;
  std::vector<Mode> modes;
  std::vector<double> end;
  for (std::size_t i = 1; i <= n; ++i) {
    double low = (static_cast<double>(i) - 0.5) * kPi;  // λ cot λ is 0 here, and −∞ at iπ
    double high = static_cast<double>(i) * kPi;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (low + high);
      (middle / std::tan(middle) > -kappa ? low : high) = middle;
    }
    modes.push_back({low * kWave, 0.003});
    end.push_back(std::sin(low) / std::sqrt(0.5 - 0.25 * std::sin(2.0 * low) / low));
  }
  return {ModalModel(std::move(modes), {{"end", end}}),
          {{.name = "end", .joint = Joint(k, uniform()), .shape = end, .spring_in_modes = k}},
          {{"end"}}};
}

// The compliance of the end is 1/(k + EA/L), and can never reach 1/k. Where the spring is as stiff
// as the bar, the estimate keeps its factor of two.
TEST(MissingModes, AreNoPartOfSpringsInTheModes) {
  for (const double kappa : {1.0, 10.0, 100.0}) {
    const double k = kappa * kWave * kWave;
    for (const std::size_t n : {2U, 3U, 5U, 8U}) {
      const JointedStructure structure = sprung_bar(n, kappa);
      const std::vector<MissingCompliance> found = missing_compliance(structure);
      ASSERT_EQ(found.size(), 1U);
      const double truth = 1.0 / (k + kWave * kWave) - found[0].in_modes;
      EXPECT_GT(found[0].missing, 0.0);
      EXPECT_LT(found[0].in_modes + found[0].missing, 1.0 / k) << kappa << " " << n;
      if (kappa > 1.0) continue;
      EXPECT_GT(found[0].missing, 0.5 * truth) << n;
      EXPECT_LT(found[0].missing, 2.0 * truth) << n;
    }
  }
}

// Chains of five masses, two of which have a spring to the ground that the modes contain, from weak
// to nearly all that holds them: the trend of the modes alone is more than the springs leave. The
// structure with the estimate must be one: without the springs it has a stiffness.
TEST(MissingModes, LeaveAStructureWithoutTheSprings) {
  for (const double k : {0.1, 1.0, 10.0, 1e3, 1e6}) {
    const Eigen::Index size = 5;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 0; i + 1 < size; ++i) {
      stiffness.block(i, i, 2, 2) += Eigen::Matrix2d{{1.0, -1.0}, {-1.0, 1.0}};
    }
    stiffness(0, 0) += k + 1e-3;
    stiffness(4, 4) += 2.0 * k;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness);
    std::vector<Mode> modes;
    StructuralJoint first{"first", Joint(k, uniform()), {}, k};
    StructuralJoint last{"last", Joint(2.0 * k, uniform()), {}, 2.0 * k};
    for (Eigen::Index i = 0; i < size; ++i) {
      modes.push_back({std::sqrt(solver.eigenvalues()(i))});
      first.shape.push_back(solver.eigenvectors()(0, i));
      last.shape.push_back(solver.eigenvectors()(4, i));
    }
    const JointedStructure structure(ModalModel(std::move(modes), {{"first", first.shape}}),
                                     {first, last}, {{"first"}});
    const std::vector<FurtherMode> further = likely_missing_modes(structure);
    EXPECT_GE(further.size(), 1U) << k;
    EXPECT_NO_THROW((void)with_further_modes(structure, further).linear().size()) << k;
  }
}

/// A joint to the ground at the first of two masses, all that holds them, by its spring of 2000 N/m
/// that both modes contain; the driven point is the second mass.
JointedStructure held_by_joint(const std::vector<Mode>& modes, const std::vector<double>& first,
                               const std::vector<double>& second) {
  const double k = 2000.0;
  return {ModalModel(modes, {{"a", second}}),
          {{.name = "j", .joint = Joint(k, uniform()), .shape = first, .spring_in_modes = k}},
          {{"a"}}};
}

std::string refusal_of_estimate(const JointedStructure& structure) {
  return message_or("none", [&] {
    return with_further_modes(structure, likely_missing_modes(structure)).linear().size();
  });
}

// The modes have the whole 1/k: nothing is left. The figures are those of masses of 1 and 1 kg, and
// of 1 and 2 kg, with a spring of 5000 and 10 000 N/m between them, as a program printed them.
TEST(MissingModes, OfAJointThatHoldsAllAreNone) {
  const JointedStructure equal = held_by_joint(
      {{2.0 * kPi * 4.7772484057621565}, {2.0 * kPi * 16.76727314135057}},
      {0.6339889056055382, 0.7733421413379022}, {0.7733421413379022, -0.6339889056055382});
  const JointedStructure heavy = held_by_joint(
      {{2.0 * kPi * 3.9312658884655725}, {2.0 * kPi * 20.375479846966122}},
      {0.5274433735638667, 0.8495901880810344}, {0.6007509832216537, -0.37295878613891953});
  for (const JointedStructure& structure : {equal, heavy}) {
    EXPECT_EQ(refusal_of_estimate(structure), "none");
    EXPECT_EQ(missing_compliance(structure)[0].missing, 0.0);
  }
}

// Of four digits the modes have up to 1.003/k: beside a stiff spring between the masses, so that
// the slowest mode is far below the other, and the check of the springs lets it pass.
TEST(MissingModes, OfFewDigitsAreNoFault) {
  const auto rounded = [](double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3.0);
    return std::round(value / unit) * unit;
  };
  double largest = 0.0;
  for (int i = 1; i <= 20; ++i) {
    const double m = 0.1 * i;  // of the second mass, kg; the first has 1 kg
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(
        Eigen::Matrix2d{{2000.0 + 1e7, -1e7 / std::sqrt(m)}, {-1e7 / std::sqrt(m), 1e7 / m}});
    std::vector<Mode> modes;
    std::vector<double> first;
    std::vector<double> second;
    for (Eigen::Index n = 0; n < 2; ++n) {
      modes.push_back({2.0 * kPi * rounded(std::sqrt(solver.eigenvalues()(n)) / (2.0 * kPi))});
      first.push_back(rounded(solver.eigenvectors()(0, n)));
      second.push_back(rounded(solver.eigenvectors()(1, n) / std::sqrt(m)));
    }
    const JointedStructure structure = held_by_joint(modes, first, second);
    EXPECT_EQ(refusal_of_estimate(structure), "none") << m;
    largest = std::max(largest, 2000.0 * missing_compliance(structure)[0].in_modes - 1.0);
  }
  EXPECT_GT(largest, 1e-4);
}

// The estimated change is the true one, to the factor of the estimate.
TEST(MissingModes, AreJudgedOnACurve) {
  const SteadyVibration truth = peak_of(bar(kMany));
  for (const std::size_t n : {2U, 3U, 15U}) {
    const HarmonicBalance balance(bar(n), {"inside"}, {.harmonics = 3});
    const ResponseCurve curve =
        balance.frequency_response(300.0, 2.0 * kPi * 220.0, 2.0 * kPi * 320.0);
    const auto change = judge_missing_modes(balance, curve, Quantity::kForceAmplitude);
    ASSERT_TRUE(change.has_value());
    EXPECT_GE(change->points, 1U);
    const double shift = std::abs(peak_of(bar(n)).frequency() / truth.frequency() - 1.0);
    EXPECT_LT(change->frequency, 2.5 * shift) << n;
    EXPECT_GT(change->frequency, 0.4 * shift) << n;
  }
}

// Of joints inside, where shapes have nodes: a bar fixed at both ends, with its joint in the middle
// or at a third, φ_i(x) = √2 sin(iπx/L), ω_i = iπ c/L, and a beam on supports, ω_i ~ i². The trend
// of the largest motion is all that is determined: between half and five times.
TEST(MissingModes, AreNotMissedAtNodes) {
  for (const double power : {1.0, 2.0}) {
    for (const double at : {0.5, 1.0 / 3.0}) {
      const auto term = [&](double i) {
        return 2.0 * std::pow(std::sin(i * kPi * at), 2.0) / std::pow(i, 2.0 * power);
      };
      for (const std::size_t n : {2U, 3U, 4U, 5U, 8U}) {
        std::vector<Mode> modes;
        std::vector<double> shape;
        for (std::size_t i = 1; i <= n; ++i) {
          modes.push_back({std::pow(static_cast<double>(i), power)});
          shape.push_back(std::numbers::sqrt2 * std::sin(static_cast<double>(i) * kPi * at));
        }
        const JointedStructure structure(ModalModel(std::move(modes), {{"a", shape}}),
                                         {{"joint", Joint(1.0, uniform()), shape}}, {{"a"}});
        double truth = 0.0;
        for (std::size_t i = n + 1; i < 20000; ++i) truth += term(static_cast<double>(i));
        const double found = missing_compliance(structure)[0].missing;
        EXPECT_GT(found, 0.5 * truth) << power << " " << at << " " << n;
        EXPECT_LT(found, 5.0 * truth) << power << " " << at << " " << n;
      }
    }
  }
}

TEST(MissingModes, AreReportedWhereACurveChangesMuch) {
  EXPECT_FALSE(changed_curve_warning({.level = 0.009, .frequency = 9e-4}, "").has_value());
  EXPECT_TRUE(changed_curve_warning({.level = 0.011}, "").has_value());
  EXPECT_TRUE(changed_curve_warning({.dissipation = 0.011}, "").has_value());
  for (const CurveChange& lost : {CurveChange{.frequency = 0.11}, {.unsolved = "in vain"}}) {
    const auto warning = changed_curve_warning(lost, "Mend it.");
    ASSERT_TRUE(warning.has_value());
    expect_message(warning->text, "could not be estimated");
  }
  const auto warning = changed_curve_warning({.frequency = 1.1e-3}, "Mend it.");
  ASSERT_TRUE(warning.has_value());
  EXPECT_EQ(warning->code, "modes_missing");
  expect_message(warning->text, "the frequency by 0.11 % ");
  expect_message(warning->text, "(estimated from the last modes). Mend it.");
}

TEST(MissingModes, AreNamedWithTheJointThatMovesTooFar) {
  const auto warning = missing_modes_warning(missing_compliance(bar(3)), "Mend it.");
  ASSERT_TRUE(warning.has_value());
  expect_message(warning->text, "static compliance of ");
  EXPECT_FALSE(missing_modes_warning(missing_compliance(bar(kMany)), "").has_value());
  EXPECT_FALSE(missing_modes_warning(std::vector<MissingCompliance>{}, "").has_value());
}

// Two masses have two modes: their points are orthogonal. One mode gives no trend.
TEST(MissingModes, AreNotSoughtWhereNothingIsMissing) {
  const double half = std::numbers::sqrt2 / 2.0;
  const Joint joint(1.0, uniform());
  const JointedStructure masses(
      ModalModel({{1.0}, {2.0}}, {{"a", {half, half}}, {"b", {half, -half}}}),
      {{"joint", joint, {half, half}}}, {{"a"}});
  EXPECT_TRUE(likely_missing_modes(masses).empty());
  EXPECT_TRUE(missing_compliance(masses).empty());
  EXPECT_TRUE(likely_missing_modes(bar(1)).empty());
}

// Γ of a joint that shortens, and the participation of a base, go with them.
TEST(FurtherModes, LeaveTheOthersAsTheyAre) {
  const Joint joint(1.0, uniform());
  StructuralJoint shortens{"joint", joint, {1.0, 0.5}};
  shortens.shortening = {1.0, 2.0, 2.0, 3.0};
  const JointedStructure structure(
      ModalModel({{1.0}, {2.0}}, {{"a", {0.3, 0.4}}}, {{"table", {0.7, 0.8}, {1.0}}}), {shortens},
      {{"a"}});
  const JointedStructure more =
      with_further_modes(structure, {{.mode = {9.0, 0.1}, .points = {5.0}, .joints = {6.0}}});
  EXPECT_EQ(more.linear().modes()[2].angular_frequency, 9.0);
  EXPECT_EQ(more.linear().points()[0].shape, (std::vector<double>{0.3, 0.4, 5.0}));
  EXPECT_EQ(more.linear().bases()[0].participation, (std::vector<double>{0.7, 0.8, 0.0}));
  EXPECT_EQ(more.joints()[0].shape, (std::vector<double>{1.0, 0.5, 6.0}));
  EXPECT_EQ(more.joints()[0].shortening,
            (std::vector<double>{1.0, 2.0, 0.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0}));
}

// A residual of the structure without the spring that the modes contain: the fault is not k's.
TEST(ResidualFlexibility, IsThatOfTheStructureOfTheModes) {
  const double k = 10.0 * kWave * kWave;
  const JointedStructure structure = sprung_bar(3, 10.0);
  const double held = missing_compliance(structure)[0].in_modes;
  const auto refusal = [&](double residual) {
    return message_or("none", [&] { return static_modes(structure, {{}, {"end"}, {residual}}); });
  };
  EXPECT_EQ(refusal(1.0 / k - held), "none");
  expect_message(refusal(1.1 / k - held), "compliance of the residual of joint 'end' = ");
  expect_message(refusal(1.1 / k - held), "of the spring of 1e+07 N/m that they contain");
}

// Two joints at one mass of 1 kg and ω = 2 rad/s, each with half of the spring of 4 N/m: their
// compliances are 1/4 m/N and coupled. What is within 1/k of each is too much for both, but in the
// direction in which the mass does not move.
TEST(ResidualFlexibility, IsWithinTheSpringsTogether) {
  StructuralJoint first{
      .name = "a", .joint = Joint(2.0, uniform()), .shape = {1.0}, .spring_in_modes = 2.0};
  StructuralJoint second = first;
  second.name = "b";
  const JointedStructure structure(ModalModel({{2.0}}, {{"mass", {1.0}}}), {first, second},
                                   {{"mass"}});
  const auto refusal = [&](double own, double shared) {
    return message_or("none", [&] {
      const ResidualFlexibility residual{{}, {"a", "b"}, {own, shared, shared, own}};
      return with_further_modes(structure, static_modes(structure, residual)).linear().size();
    });
  };
  EXPECT_EQ(refusal(0.2, -0.2), "none");
  expect_message(refusal(0.2, 0.2),
                 "compliance of the residual of joints 'a', 'b' = 1.8 times 1/k");
  expect_message(refusal(0.3, -0.3), "compliance of the residual of joint 'a' = 0.3 m/N; must be");
}

// The modes have 1.0006/k by their last digit: a small residual is not to blame.
TEST(ResidualFlexibility, IsThatOfModesOfFourDigits) {
  const StructuralJoint joint{
      .name = "a", .joint = Joint(4.0, uniform()), .shape = {1.0003}, .spring_in_modes = 4.0};
  const JointedStructure structure(ModalModel({{2.0}}, {{"mass", {1.0}}}), {joint}, {{"mass"}});
  const auto refusal = [&](double residual) {
    return message_or("none", [&] {
      return with_further_modes(structure, static_modes(structure, {{}, {"a"}, {residual}}))
          .linear()
          .size();
    });
  };
  EXPECT_EQ(refusal(5e-5), "none");
  expect_message(refusal(5e-3), "compliance of the residual of joint 'a' = 0.005 m/N");
}

TEST(ResidualFlexibility, NamesWhatIsWrong) {
  const JointedStructure structure = bar(3);
  const auto refused = [&](const ResidualFlexibility& residual, const std::string& part) {
    expect_message(message_or("none", [&] { return static_modes(structure, residual); }), part);
  };
  refused({{"middle"}, {}, {1.0}},
          "point of the residual = 'middle'; must be a point of the model");
  refused({{}, {"inside"}, {1.0}},
          "joint of the residual = 'inside'; must be a joint of the model");
  refused({{"inside", "inside"}, {}, {1.0, 0.0, 0.0, 1.0}}, "must not occur twice");
  refused({{"inside"}, {"end"}, {1.0, 0.0}}, "2 values; must have 4");
  refused({{}, {}, {}}, "0 values; must have 1");
  refused({{"inside"}, {"end"}, {1.0, 0.2, 0.1, 1.0}},
          "compliance of the residual[0, 1] = 0.2; must be that of [1, 0], 0.1");
  refused({{"inside"}, {"end"}, {1.0, 2.0, 2.0, 1.0}},
          "a negative eigenvalue, -1 over the roots of its diagonal");
  refused({{"inside"}, {}, {NAN}}, "must be finite");
  refused({{"inside"}, {}, {-1.0}}, "compliance of the residual[0, 0] = -1; must be 0 or more");
  refused({{"inside"}, {"end"}, {0.0, 1.0, 1.0, 1.0}}, "must be above 0 where others in its row");
  // Small entries beside large ones count as much.
  EXPECT_EQ(static_modes(structure, {{"inside"}, {"end"}, {1e-4, 0.0, 0.0, 9e-11}}).size(), 2U);
  EXPECT_TRUE(static_modes(structure, {{"inside"}, {}, {0.0}}).empty());
  const JointedStructure rigid(ModalModel({{0.0}}, {{"a", {1.0}}}), {}, {{"a"}});
  expect_message(message_or("none",
                            [&] {
                              return static_modes(rigid, {{"a"}, {}, {1.0}});
                            }),
                 "all of rigid bodies");
}

}  // namespace
}  // namespace microslip::missing_modes_test
