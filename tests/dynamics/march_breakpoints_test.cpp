// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/march/joint_path.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/dynamics/march/march_loops.hpp"
#include "microslip/dynamics/march/step_breakpoints.hpp"
#include "microslip/dynamics/march/step_cubic.hpp"
#include "support/largest_difference.hpp"
#include "support/quadrature.hpp"

namespace microslip {
namespace {

// Σ w_m M_m against ∫ g(h − t) e dt by quadrature, with the impulse response
// e^{−δt} sin(ω_d t)/ω_d and e a broken line less the cubic through its ends. The series of g is
// wrong by 1e-5 at the longest step that it is meant for.
TEST(StepBreakpoints, AddWhatTheCubicLeavesOut) {
  std::size_t terms = 0;
  for (const double angle : {1e-9, 1e-3, 0.03, 0.3, 1.4, 4.9}) {  // the first is a rigid body
    const double h = 0.01;
    const double omega = angle / h;
    const double eta = 0.05;
    std::vector<double> stiffness(kLanes, 0.0);
    std::vector<double> damping(kLanes, 0.0);
    stiffness[2] = omega * omega;
    damping[2] = eta * omega;
    BreakpointWeights weights(stiffness, damping);
    ASSERT_GE(weights.longest(), h);
    weights.set_length(h);
    EXPECT_GE(weights.terms(), terms);  // a shorter step needs fewer
    terms = weights.terms();

    // 0 up to the share 0.3, then a slope of 2 N over the step up to 0.8, then of −1 N.
    const auto force = [](double x) {
      return std::max(0.0, 2.0 * (std::min(x, 0.8) - 0.3)) - std::max(0.0, x - 0.8);
    };
    const std::array<JointPath::Breakpoint, 2> breakpoints{
        {{0.3, 0.0, force(0.3), 0.0, 2.0, false}, {0.8, 0.0, force(0.8), 2.0, -1.0, false}}};
    const StepCubic cubic(0.0, 0.0, force(1.0), -1.0 / h, h);
    const BreakpointMoments all = breakpoint_moments(breakpoints, cubic, terms);
    const std::span<const double> moments = std::span(all).first(terms);
    std::vector<double> shape(kLanes, 0.0);
    shape[2] = 1.0;
    std::vector<double> q(kLanes, 0.0);
    std::vector<double> v(kLanes, 0.0);
    march_loops::add_breakpoints(1, weights.data(), shape.data(), moments, q.data(), v.data());

    const double decay = 0.5 * eta * omega;
    const double vibrates = std::sqrt(omega * omega - decay * decay);
    const auto e = [&](long double time) {
      const auto t = static_cast<double>(time);
      return force(t / h) - cubic.value(t / h);
    };
    const auto displaced = [&](long double t) {
      return std::exp(-decay * (h - t)) * std::sin(vibrates * (h - t)) / vibrates * e(t);
    };
    const auto moved = [&](long double t) {
      const long double left = h - t;
      return std::exp(-decay * left) *
             (std::cos(vibrates * left) - decay / vibrates * std::sin(vibrates * left)) * e(t);
    };
    long double of_q = 0.0L;
    long double of_v = 0.0L;
    for (const auto& [from, to] : {std::array{0.0, 0.3}, {0.3, 0.8}, {0.8, 1.0}}) {
      of_q += testing::integrate(displaced, from * h, to * h);
      of_v += testing::integrate(moved, from * h, to * h);
    }
    EXPECT_NEAR(q[2], static_cast<double>(-of_q), 1e-5 * h * h) << angle;
    EXPECT_NEAR(v[2], static_cast<double>(-of_v), 1e-5 * h) << angle;
    EXPECT_EQ(q[1], 0.0);

    // ∫ e up to some shares, by the same quadrature.
    const std::array<double, 4> shares{0.1, 0.5, 0.9, 1.0};
    std::array<double, 4> found;
    integrate_breakpoints(breakpoints, cubic, shares, found.data());
    for (std::size_t i = 0; i < shares.size(); ++i) {
      long double integral = 0.0L;
      for (const auto& [from, to] : {std::array{0.0, 0.3}, {0.3, 0.8}, {0.8, 1.0}}) {
        integral += testing::integrate([&](long double x) { return e(static_cast<double>(x) * h); },
                                       from, std::clamp(shares[i], from, to));
      }
      EXPECT_NEAR(found[i], static_cast<double>(integral), 1e-14);
    }
  }
  EXPECT_EQ(terms, kBreakpointTerms);
}

/// The shares at which a joint that sets off by y₁x + y₂x² + y₃x³ + y₄x⁴ turns.
std::vector<double> turns(double y1, double y2, double y3, double y4) {
  const Joint joint(1500.0, SlipDensity({PiecewiseLinearPart{{0.0, 8.0}, {0.12, 0.08}}}));
  CurveFollower follower(joint);
  follower.turn(1);
  const double end = y1 + 2.0 * y2 + 3.0 * y3 + 4.0 * y4;
  const StepQuartic y({0.0, y1, y1 + y2 + y3 + y4, end, 1.0}, 2.0 * y2);
  JointPath path(joint);
  EXPECT_TRUE(path.follow({follower, 1, 0.0, follower.next_kink(), 0.0, 0.0}, y));
  std::vector<double> shares;
  for (const JointPath::Breakpoint& breakpoint : path.breakpoints()) {
    if (breakpoint.turns) shares.push_back(breakpoint.share);
  }
  return shares;
}

// Of slopes that are products of known zeros: (1 − x/a)(1 + x²), which no parabola is, and
// (1 − x/a)(1 − x/b)(1 + x), in mm. 1e-12 is what Newton's method leaves of a step of 1e-7.
TEST(JointPath, TurnsWhereTheQuarticHasItsExtremes) {
  constexpr double kSize = 1e-3;
  for (const double a : {1e-4, 0.2, 0.5, 0.97}) {
    const auto once = turns(kSize, -kSize / (2.0 * a), kSize / 3.0, -kSize / (4.0 * a));
    ASSERT_EQ(once.size(), 1U) << a;
    EXPECT_NEAR(once[0], a, 1e-12);
  }
  const double a = 0.3;
  const double b = 0.6;
  const double scale = kSize / (a * b);
  const auto twice =
      turns(kSize, scale * (a * b - a - b) / 2.0, scale * (1.0 - a - b) / 3.0, scale / 4.0);
  ASSERT_EQ(twice.size(), 2U);
  EXPECT_NEAR(twice[0], a, 1e-12);
  EXPECT_NEAR(twice[1], b, 1e-12);
  EXPECT_TRUE(turns(kSize, -0.1 * kSize, 0.0, 0.0).empty());
}

/// A rod of ten joints under noise: loops close and turn in every other step.
struct Rod {
  static constexpr std::size_t kModes = 12;
  static constexpr std::size_t kJoints = 10;

  Rod() {
    for (std::size_t i = 0; i <= 600; ++i) {
      loads.time.push_back(1e-3 * static_cast<double>(i));
      loads.forces[0].force.push_back(0.0);
    }
    RandomStream random(11, 0);
    for (int line = 0; line < 30; ++line) {  // up to 150 Hz
      const double omega = 2.0 * std::numbers::pi * 5.0 * (line + random.uniform());
      const double phase = 6.28 * random.uniform();
      for (std::size_t i = 0; i < loads.time.size(); ++i) {
        const double t = loads.time[i];
        loads.forces[0].force[i] += 20.0 * t * std::sin(omega * t + phase);
      }
    }
  }

  static std::vector<double> shape(double place) {
    std::vector<double> shape;
    for (std::size_t i = 0; i < kModes; ++i) {
      shape.push_back(std::sin((static_cast<double>(i) + 0.5) * std::numbers::pi * place));
    }
    return shape;
  }

  static JointedStructure structure(double compliance) {
    std::vector<Mode> modes;
    for (std::size_t i = 0; i < kModes; ++i) {
      modes.push_back({2.0 * std::numbers::pi * 20.0 * (2.0 * static_cast<double>(i) + 1.0), 0.01});
    }
    std::vector<StructuralJoint> joints;
    for (std::size_t j = 0; j < kJoints; ++j) {
      const double at = (static_cast<double>(j) + 0.6) / kJoints;
      joints.push_back(
          {.name = "joint " + std::to_string(j),
           .joint = Joint(1500.0, SlipDensity({PiecewiseLinearPart{{0.0, 8.0}, {0.12, 0.08}}})),
           .shape = shape(at),
           .series_compliance = compliance});
    }
    return {ModalModel(std::move(modes), {{"tip", shape(1.0)}}), std::move(joints), {{"tip"}}};
  }

  [[nodiscard]] MarchResult march(double compliance, double steps) const {
    return microslip::march(
        structure(compliance), loads,
        {.step = 1e-3 / steps, .points = {"tip"}, .tolerance = 1e-10, .estimate_error = false});
  }

  LoadHistory loads{{}, {{"tip", {}}}};
};

double difference(const MarchResult& one, const MarchResult& other) {
  return testing::largest_difference(one.points[0].displacement, other.points[0].displacement);
}

// Of fourth order although joints turn and close loops inside of steps, more than one of them in
// many: a step that took no notice would be of order 2. No step is cut for it.
TEST(StepBreakpoints, KeepTheOrderOfStepsThatAreNotCut) {
  const Rod rod;
  for (const double compliance : {0.0, 1e-4}) {  // stiff, and 15 % of the joint in series
    const MarchResult exact = rod.march(compliance, 32.0);
    const MarchResult coarse = rod.march(compliance, 2.0);
    const MarchResult fine = rod.march(compliance, 4.0);
    EXPECT_EQ(coarse.steps, 2 * (rod.loads.time.size() - 1));
    EXPECT_GT(coarse.reversals + coarse.kinks, coarse.steps);
    EXPECT_EQ(coarse.reversals, exact.reversals);
    EXPECT_EQ(coarse.kinks, exact.kinks);
    const double error = difference(coarse, exact);
    const double of_half = difference(fine, exact);
    EXPECT_LT(error, 4e-5);
    EXPECT_GT(error / of_half, 10.0) << error << ' ' << of_half;  // 16; 4 for order 2
    EXPECT_LT(exact.energy.imbalance(), 1e-6);
  }
}

}  // namespace
}  // namespace microslip
