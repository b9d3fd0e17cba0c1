// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/step_quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "microslip/dynamics/march/step_cubic.hpp"
#include "support/quadrature.hpp"

namespace microslip::step_quadrature_test {
namespace {

// q̇ at the inner points against the free vibration in closed form and Duhamel's integral of the
// load by quadrature, to its rounding.
TEST(StepQuadrature, KnowsTheVelocityInsideOfAStep) {
  const double h = 0.01;
  const double eta = 0.05;
  for (const double angle : {0.01, 1.4, 4.9}) {
    const double omega = angle / h;
    StepQuadrature quadrature(std::vector<Mode>{{1.0, 0.0}, {omega, eta}});
    quadrature.set_length(h);
    const StepCubic cubic(0.3, 50.0, -0.7, 90.0, h);
    const double middle = 0.4;
    const double q0 = 2e-5;
    const double v0 = -0.01;
    const auto load = [&](double x) {
      return cubic.value(x) + middle * 16.0 * x * x * (1.0 - x) * (1.0 - x);
    };
    const double decay = 0.5 * eta * omega;
    const double vibrates = std::sqrt(omega * omega - decay * decay);
    const auto impulse_slope = [&](double t) {
      return std::exp(-decay * t) *
             (std::cos(vibrates * t) - decay / vibrates * std::sin(vibrates * t));
    };
    for (std::size_t point = 0; point < kInnerPoints; ++point) {
      const double t = kInnerPoint[point] * h;
      const double freely = v0 * impulse_slope(t) - q0 * omega * omega / vibrates *
                                                        std::exp(-decay * t) *
                                                        std::sin(vibrates * t);
      const auto forced = testing::integrate(
          [&](long double at) {
            const auto time = static_cast<double>(at);
            return impulse_slope(t - time) * load(time / h);
          },
          0.0, t);
      const double* w = quadrature.data() + point * StepQuadrature::kKinds * kLanes + 1;
      using Q = StepQuadrature;
      const double found = w[Q::kE21 * kLanes] * q0 + w[Q::kE22 * kLanes] * v0 +
                           w[Q::kC0 * kLanes] * 0.3 + w[Q::kD0 * kLanes] * 50.0 -
                           w[Q::kC1 * kLanes] * 0.7 + w[Q::kD1 * kLanes] * 90.0 +
                           w[Q::kCM * kLanes] * middle;
      EXPECT_NEAR(found, freely + static_cast<double>(forced), 1e-14) << angle << " at " << point;
    }
  }
}

/// Of a linear structure of two modes under noise, with steps of `angle` of the higher one.
double imbalance(double angle) {
  const JointedStructure structure(ModalModel({{30.0, 0.05}, {100.0, 0.02}}, {{"tip", {0.8, 1.1}}}),
                                   {}, {{"tip"}});
  RandomStream random(4, 0);
  LoadHistory loads{{}, {{"tip", {}}}};
  for (int i = 0; i <= 500; ++i) {
    loads.time.push_back(0.02 * i);
    loads.forces[0].force.push_back(random.normal());
  }
  return march(structure, loads, {.step = angle / 100.0, .points = {"tip"}}).energy.imbalance();
}

// The march of a linear structure is exact under straight pieces of load, so that the imbalance is
// that of the quadrature: of order 8, by the degree 7 of Gauss–Lobatto with 5 points.
TEST(StepQuadrature, IsOfOrderEight) {
  const double coarse = imbalance(2.0);
  const double fine = imbalance(1.0);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(coarse, 100.0 * fine);  // 2⁸ but for terms of higher order and of either sign
}

// A joint that turns and begins to slip in many of the steps. Without the breakpoints inside of a
// step the imbalance of the shorter one is 9e-7, by the ends of the steps 3e-9.
TEST(StepQuadrature, IncludesBreakpointsInsideOfAStep) {
  const Joint joint(6000.0, SlipDensity({UniformPart{0.2, 3.0, 0.8}}));
  const JointedStructure structure(ModalModel({{10.0 * std::numbers::pi, 0.0}}, {{"mass", {1.0}}}),
                                   {{"joint", joint, {1.0}}}, {{"mass"}});
  LoadHistory loads{{}, {{"mass", {}}}};
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.005 * i;
    loads.time.push_back(t);
    loads.forces[0].force.push_back(2.0 * std::sin(14.0 * std::numbers::pi * t) +
                                    1.2 * std::sin(34.0 * std::numbers::pi * t));
  }
  const auto imbalance_of = [&](double step) {
    return march(structure, loads, {.step = step, .points = {"mass"}}).energy.imbalance();
  };
  EXPECT_LT(imbalance_of(1e-3), 6e-10);
  EXPECT_LT(imbalance_of(2.5e-3), 2e-7);
}

}  // namespace
}  // namespace microslip::step_quadrature_test
