// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "support/figures.hpp"
#include "support/structures.hpp"

namespace microslip::resonances_test {
namespace {

using std::numbers::pi;

constexpr double kImbalance = 1e-8;

std::vector<double> levels(double from, double to, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(i + 1 == count ? to : from * std::pow(to / from, double(i) / (count - 1)));
  }
  return result;
}

void expect_resonances(const ResponseCurve& curve) {
  for (const SteadyVibration& point : curve.points) {
    EXPECT_LE(point.energy_imbalance, kImbalance);
    EXPECT_NEAR(std::cos(point.phase_lag), 0.0, 1e-9) << point.response;
  }
}

bool has_row(const ResponseCurve& curve, double response) {
  return std::ranges::any_of(curve.points, [&](const SteadyVibration& point) {
    return std::abs(point.response / response - 1.0) < 1e-9;
  });
}

// ---- With a force at a point. ----

TEST(Resonances, AreTheBackboneWhereNothingFolds) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  const std::vector<double> responses = levels(1e-3, 20.0, 12);
  const ResponseCurve curve = balance.resonances(responses);
  const ResponseCurve backbone = balance.backbone(responses);
  EXPECT_EQ(curve.summary.reason, "all responses reached");
  ASSERT_EQ(curve.points.size(), responses.size());
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const SteadyVibration& expected = backbone.points[i];
    EXPECT_NEAR(curve.points[i].response, responses[i], 1e-11 * responses[i]);
    EXPECT_NEAR(curve.points[i].angular_frequency, expected.angular_frequency, 1e-10);
    EXPECT_NEAR(curve.points[i].force_amplitude, expected.force_amplitude,
                1e-9 * expected.force_amplitude);
  }
}

/// Two modes of which the second, with the joint stuck, hardly moves the drive point: a fourteenth
/// of the first.
JointedStructure weak_mode() {
  const double turn = 2.0 * pi;
  const ModalModel linear(
      {{turn * 12.143849549953952, 0.00134}, {turn * 23.644770858773224, 0.00134}},
      {{"m2", {-0.87903385625902464, 0.49152919407096346}}});
  const Joint joint = Joint::four_parameter(13.206133047334411, 158478.48402568328,
                                            -0.6761657090641489, 1.2355182600944188);
  return JointedStructure(linear, {{"J0", joint, {-0.35102479256756741, -0.62776063105754187}}},
                          {{"m2"}});
}

// The curve over the frequency, as an independent check, passes a lag of a quarter below the
// response where phase resonance ends, and does not above.
TEST(Resonances, EndWhereTheOtherModesRuleThePhase) {
  const HarmonicBalance balance(weak_mode(), {"m2"});
  const ResponseCurve none = balance.resonances(levels(1e-9, 0.8e-3, 40), 1);
  EXPECT_FALSE(none.summary.converged());
  EXPECT_TRUE(none.points.empty());
  EXPECT_LT(none.summary.wall_seconds, 5.0);
  for (const std::string part :
       {"of mode 2 at 'm2'", "exists only up to 5.9", " m; at the response", "antiresonance",
        "40 of 40 responses are missing", "modal forcing"}) {
    EXPECT_NE(none.summary.reason.find(part), std::string::npos) << none.summary.reason;
  }
  const auto rises_through = [&](double response) {
    const ResponseCurve curve =
        balance.constant_response(response, 2.0 * pi * 49.5, 2.0 * pi * 50.9);
    EXPECT_TRUE(curve.summary.converged()) << curve.summary.full();
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const double before = std::cos(curve.points[i - 1].phase_lag);
      if (before * std::cos(curve.points[i].phase_lag) < 0.0) return true;
    }
    return false;
  };
  const ResponseCurve some = balance.resonances(levels(1e-10, 1e-8, 21), 1);
  EXPECT_FALSE(some.summary.converged());
  expect_resonances(some);
  ASSERT_GE(some.points.size(), 8U);
  ASSERT_EQ(some.turning_points.size(), 1U) << "where it ends is a row";
  EXPECT_EQ(some.turning_points[0], some.points.size() - 1);
  const double end = some.points.back().response;
  EXPECT_TRUE(rises_through(0.9 * end));
  EXPECT_FALSE(rises_through(1.02 * end));
  // The first mode, which moves that point, has no end.
  EXPECT_TRUE(balance.resonances(levels(1e-9, 0.8e-3, 5)).summary.converged());
}

/// Two to four modes, one or two joints, driven and seen anywhere.
JointedStructure random_structure(std::uint64_t seed) {
  return testing::random_structure(seed, 3, 2 + seed % 3, 1 + seed % 2);
}

/// How many structures: a campaign sets it.
std::uint64_t draws() {
  const char* text = std::getenv("MICROSLIP_DRAWS");
  return text == nullptr ? 40 : std::strtoull(text, nullptr, 10);
}

// Each reaches its end or says truly why not: where phase resonance ends it folds, and where there
// is none curves over the frequency that reached their own end show it.
TEST(Resonances, OfRandomStructuresReachTheirEndOrSayWhyNot) {
  const std::vector<double> responses = levels(1e-4, 10.0, 30);
  std::size_t whole = 0;
  for (std::uint64_t seed = 1; seed <= draws(); ++seed) {
    const JointedStructure structure = random_structure(seed);
    const std::size_t mode = seed % structure.linear().size();
    const std::string point = seed % 3 == 0 ? "b" : "a";
    const ResponseCurve driven =
        HarmonicBalance(structure, {point}, {.samples = 128}).resonances(responses, mode);
    expect_resonances(driven);
    const std::string& reason = driven.summary.reason;
    for (const std::string lost : {"tracking failed", "was not found", "finds no further"}) {
      EXPECT_EQ(reason.find(lost), std::string::npos) << "seed " << seed << ": " << reason;
    }
    whole += driven.summary.converged() ? 1 : 0;
    for (const double response : responses) {
      EXPECT_TRUE(has_row(driven, response) || !driven.summary.converged()) << seed;
    }
    if (!driven.summary.converged()) {
      const bool stated = reason.find("no phase resonance was found at") != std::string::npos;
      EXPECT_TRUE(stated) << "seed " << seed << ": " << reason;
    }
    const ResponseCurve modal =
        HarmonicBalance(structure, {point}, {.samples = 128, .forcing = Forcing::kModal})
            .resonances(responses, mode);
    EXPECT_TRUE(modal.summary.converged()) << "seed " << seed << ": " << modal.summary.full();
    expect_resonances(modal);
  }
  test::record_smallest("share that reaches its end [1]", double(whole) / double(draws()));
  EXPECT_GE(double(whole), 0.7 * double(draws()));
}

// ---- Folds. ----

// In the nonlinear mode of this structure the response goes up, back and up again: what lies
// between the folds is met three times, in the order of the curve.
TEST(Resonances, GoRoundFolds) {
  const HarmonicBalance balance(random_structure(56), {"a"},
                                {.samples = 128, .forcing = Forcing::kModal});
  const ResponseCurve coarse = balance.resonances(levels(1e-4, 10.0, 30), 0);
  ASSERT_EQ(coarse.turning_points.size(), 2U) << coarse.summary.reason;
  const SteadyVibration& top = coarse.points[coarse.turning_points[0]];
  const SteadyVibration& bottom = coarse.points[coarse.turning_points[1]];
  ASSERT_GT(top.response, bottom.response);
  const double between = std::sqrt(top.response * bottom.response);
  const std::vector<double> responses{0.5 * bottom.response, between, 2.0 * top.response};
  const ResponseCurve curve = balance.resonances(responses, 0);
  EXPECT_TRUE(curve.summary.converged());
  EXPECT_NE(curve.summary.reason.find("turns back 2 times"), std::string::npos)
      << curve.summary.reason;
  expect_resonances(curve);
  ASSERT_EQ(curve.points.size(), 7U);
  const std::vector<double> expected{responses[0],    between, top.response, between,
                                     bottom.response, between, responses[2]};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(curve.points[i].response, expected[i], 1e-9 * expected[i]) << i;
  }
  EXPECT_EQ(curve.turning_points, (std::vector<std::size_t>{2, 4}));
  // Three different vibrations.
  EXPECT_GT(std::abs(curve.points[1].angular_frequency - curve.points[3].angular_frequency), 1e-6);
  EXPECT_GT(std::abs(curve.points[3].angular_frequency - curve.points[5].angular_frequency), 1e-6);
}

// ---- Modal forcing. ----

// One mode is its own nonlinear mode; in one harmonic even with the force at a point.
TEST(ModalForcing, OfOneMassIsItsPhaseResonance) {
  for (const Joint& joint : {testing::iwan_joint(), testing::jenkins_joint()}) {
    const JointedStructure structure = testing::one_mass(joint);
    const std::vector<double> responses = levels(1e-3, 20.0, 9);
    const HarmonicBalance driven(structure, {"mass"}, {.harmonics = 1});
    const HarmonicBalance modal(structure, {"mass"}, {.harmonics = 1, .forcing = Forcing::kModal});
    const ResponseCurve one = driven.resonances(responses);
    const ResponseCurve other = modal.resonances(responses);
    ASSERT_TRUE(one.summary.converged() && other.summary.converged()) << other.summary.full();
    for (std::size_t i = 0; i < responses.size(); ++i) {
      const SteadyVibration& expected = one.points[i];
      const SteadyVibration& found = other.points[i];
      EXPECT_NEAR(found.angular_frequency, expected.angular_frequency, 1e-10);
      EXPECT_NEAR(found.force_amplitude, expected.force_amplitude, 1e-9 * expected.force_amplitude);
      EXPECT_NEAR(found.damping_ratio(), expected.damping_ratio(), 1e-9 * expected.damping_ratio());
      EXPECT_LE(found.energy_imbalance, kImbalance);
    }
  }
}

JointedStructure two_joints(double loss_factor) {
  const ModalModel linear({{1.0, loss_factor}, {2.3, loss_factor}},
                          {{"drive", {1.0, 0.6}}, {"end", {0.7, -1.0}}});
  const Joint soft = Joint::four_parameter(0.3, 0.25, -0.4, 0.3);
  const Joint hard(0.4, SlipDensity({UniformPart{0.0, 0.6, 0.7}}));
  return JointedStructure(linear, {{"soft", soft, {1.0, 0.2}}, {"hard", hard, {0.3, -1.0}}},
                          {{"drive"}});
}

/// The largest displacement at "drive" in a cycle.
double peak_of(const JointedStructure& structure, const SteadyVibration& vibration) {
  const auto w = vibration.displacement(structure.linear(), "drive");
  double peak = 0.0;
  for (int i = 0; i < 2000; ++i) {
    std::complex<double> value = 0.0;
    for (std::size_t n = 0; n < w.size(); ++n) {
      value += w[n] * std::polar(1.0, static_cast<double>(n) * 2.0 * pi * i / 2000.0);
    }
    peak = std::max(peak, value.real());
  }
  return peak;
}

struct Decay {
  std::vector<double> amplitude;  ///< of a cycle, by its two maxima
  std::vector<double> frequency;  ///< rad/s
  std::vector<double> damping;    ///< ζ
};

/// Maxima of a sampled motion by the parabola through three samples.
Decay decay_of(const std::vector<double>& time, const std::vector<double>& x) {
  std::vector<double> at;
  std::vector<double> height;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    if (!(x[i] > x[i - 1] && x[i] >= x[i + 1])) continue;
    const double slope = 0.5 * (x[i + 1] - x[i - 1]);
    const double bend = x[i + 1] - 2.0 * x[i] + x[i - 1];
    at.push_back(time[i] - (time[1] - time[0]) * slope / bend);
    height.push_back(x[i] - 0.5 * slope * slope / bend);
  }
  Decay decay;
  for (std::size_t i = 1; i < at.size(); ++i) {
    decay.amplitude.push_back(std::sqrt(height[i] * height[i - 1]));
    decay.frequency.push_back(2.0 * pi / (at[i] - at[i - 1]));
    decay.damping.push_back(std::log(height[i - 1] / height[i]) / (2.0 * pi));
  }
  return decay;
}

// Let go from a nonlinear mode the structure decays along it: frequency and damping of each cycle
// are those of the mode with its peaks. Time marching knows nothing of harmonics and modes of this
// kind. The cycles of a decay are not closed, and agree with closed ones but for half of what they
// lose of their amplitude, πζ: from 2 % to 0.5 % here.
TEST(ModalForcing, IsWhatAFreeDecayGoesThrough) {
  const JointedStructure structure = two_joints(0.002);
  const HarmonicBalance balance(structure, {"drive"}, {.harmonics = 9, .forcing = Forcing::kModal});
  const VibrationResult start = balance.solve(kPhaseResonance, {Quantity::kResponse, 0.5});
  ASSERT_TRUE(start.summary.converged());
  InitialState released;  // q at a turn of the motion, where the velocity is 0 but for the damping
  for (const auto& q : start.vibration.modal) {
    double value = 0.0;
    double velocity = 0.0;
    for (std::size_t n = 0; n < q.size(); ++n) {
      const std::complex<double> turned =
          q[n] * std::polar(1.0, static_cast<double>(n) * start.vibration.phase_lag);
      value += turned.real();
      velocity -= static_cast<double>(n) * start.vibration.angular_frequency * turned.imag();
    }
    released.displacement.push_back(value);
    released.velocity.push_back(velocity);
  }
  LoadHistory none;
  for (int i = 0; i <= 40000; ++i) none.time.push_back(0.02 * i);
  const MarchResult march =
      microslip::march(structure, none, {.step = 0.02, .points = {"drive"}, .start = released});
  ASSERT_TRUE(march.summary.converged()) << march.summary.full();
  std::vector<double> x = march.points[0].displacement;
  if (x[0] < 0.0) std::ranges::for_each(x, [](double& value) { value = -value; });
  const Decay decay = decay_of(march.time, x);
  ASSERT_GE(decay.amplitude.size(), 140U);
  for (std::size_t i = 2; i < 140; i += 23) {
    const double height = decay.amplitude[i];
    auto mode = balance.solve(kPhaseResonance, {Quantity::kResponse, height});
    for (int step = 0; step < 3; ++step) {  // to the mode with this peak
      const double ratio = height / peak_of(structure, mode.vibration);
      mode = balance.solve(kPhaseResonance, {Quantity::kResponse, ratio * mode.vibration.response});
    }
    ASSERT_TRUE(mode.summary.converged());
    const double omega = mode.vibration.angular_frequency;
    const double zeta = mode.vibration.damping_ratio();
    // Amplitude and frequency change together: 2ω ȧ + ω̇ a = −2ζω² a [Krack 2015].
    const auto above = balance.solve(
        kPhaseResonance, {Quantity::kResponse, 1.02 * mode.vibration.response}, mode.vibration);
    const double slope = std::log(above.vibration.angular_frequency / omega) / std::log(1.02);
    const double expected = zeta / (1.0 + 0.5 * slope);
    EXPECT_NEAR(decay.frequency[i], omega, 1e-3 * omega) << i;
    EXPECT_NEAR(decay.damping[i], expected, pi * zeta * expected) << i;
    test::record_largest("frequency [1]", std::abs(decay.frequency[i] / omega - 1.0));
    test::record_largest("damping ratio over half a decrement [1]",
                         std::abs(decay.damping[i] / expected - 1.0) / (pi * zeta));
    test::record_smallest("damping ratio [1]", std::abs(decay.damping[i] / expected - 1.0));
  }
}

// Where the joint sticks the mode is that of the linear structure, its damping by the loss factors.
// The loss factors, of some 1e-3, couple the modes to second order; slip at this level is 1e-7 of
// macro-slip.
TEST(ModalForcing, OfTheStuckRigIsItsLinearMode) {
  const JointedStructure rig = testing::friction_rig();
  const std::vector<double> natural = rig.stuck_frequencies();
  for (std::size_t m = 0; m < 3; ++m) {
    const std::vector<double> shape = rig.stuck_mode(m);
    double loss = 0.0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Mode& mode = rig.linear().modes()[i];
      loss += shape[i] * shape[i] * modal_stiffness(mode, natural[m], rig.damping()).imag() /
              (natural[m] * natural[m]);
    }
    const HarmonicBalance balance(rig, {"force"}, {.forcing = Forcing::kModal});
    const std::vector<double> low{1e-13, 1e-12};
    const ResponseCurve curve = balance.resonances(low, m);
    ASSERT_TRUE(curve.summary.converged()) << curve.summary.full();
    EXPECT_NEAR(curve.points[0].angular_frequency, natural[m], 1e-5 * natural[m]) << m;
    EXPECT_NEAR(curve.points[0].damping_ratio(), 0.5 * loss, 1e-3 * loss) << m;
    test::record_deviation("frequency", curve.points[0].angular_frequency, natural[m]);
  }
}

// ---- What cannot be. ----

template <typename Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing thrown";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(ModalForcing, RefusesWhatItDoesNotHave) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"},
                                {.forcing = Forcing::kModal});
  expect_parts(message_of([&] { (void)balance.frequency_response(0.1, 0.8, 1.1); }),
               {"force amplitude", "must not be prescribed with modal forcing"});
  expect_parts(message_of([&] { (void)balance.constant_response(0.1, 0.8, 1.1); }),
               {"must include phase resonance with modal forcing"});
  // Here 0 N/m of the joint reach mode 1, and mode 2 does not move "a".
  const ModalModel linear({{1.0, 0.01}, {2.0, 0.01}}, {{"a", {1.0, 0.0}}, {"b", {1.0, 1.0}}});
  const JointedStructure apart(linear, {{"joint", testing::iwan_joint(), {0.0, 1.0}}}, {{"b"}});
  const std::vector<double> responses{0.1, 0.2};
  expect_parts(
      message_of([&] {
        (void)HarmonicBalance(apart, {"b"}, {.forcing = Forcing::kModal}).resonances(responses, 0);
      }),
      {"must move a joint", "0.159154943 Hz"});
  expect_parts(
      message_of([&] {
        (void)HarmonicBalance(apart, {"a"}, {.forcing = Forcing::kModal}).resonances(responses, 1);
      }),
      {"must move the response point 'a'"});
}

TEST(Resonances, RefuseResponsesThatDoNotRise) {
  const HarmonicBalance balance(testing::one_mass(testing::iwan_joint()), {"mass"});
  const std::vector<double> falling{0.2, 0.1};
  expect_parts(message_of([&] { (void)balance.resonances(falling); }),
               {"response[1] = 0.1", "must be above the previous one, 0.2"});
  EXPECT_THROW((void)balance.resonances({}), InputError);
  const std::vector<double> responses{0.1, 0.2, 0.3, 0.4};
  int calls = 0;
  EXPECT_THROW(
      (void)balance.resonances(responses, 0, [&](std::size_t, std::size_t) { return ++calls < 3; }),
      Cancelled);
}

}  // namespace
}  // namespace microslip::resonances_test
