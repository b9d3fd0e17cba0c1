// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/dynamics/march/march.hpp"
#include "support/figures.hpp"
#include "support/messages.hpp"
#include "support/shaken_chain.hpp"

/// @file Structures on a shaken support, against an integration in coordinates that stand still.

namespace microslip::base_excitation_test {
namespace {

using std::numbers::pi;
using testing::ShakenChain;

/// An acceleration that is linear between its times, with the motion that it makes from rest.
class Table {
 public:
  Table(std::vector<double> time, std::vector<double> acceleration)
      : time_(std::move(time)), a_(std::move(acceleration)), v_(a_.size()), x_(a_.size()) {
    for (std::size_t k = 1; k < a_.size(); ++k) {
      const auto end = after(k - 1, time_[k] - time_[k - 1]);
      v_[k] = end.support_velocity;
      x_[k] = end.support;
    }
  }

  [[nodiscard]] ShakenChain::Acting at(double t) const {
    const auto next = std::ranges::upper_bound(time_, t);
    const auto k = std::clamp<std::ptrdiff_t>(next - time_.begin() - 1, 0,
                                              static_cast<std::ptrdiff_t>(time_.size()) - 2);
    const auto interval = static_cast<std::size_t>(k);
    return after(interval, t - time_[interval]);
  }

  [[nodiscard]] LoadHistory loads() const { return {time_, {{"table", a_}}}; }

 private:
  [[nodiscard]] ShakenChain::Acting after(std::size_t k, double s) const {
    const double rise = (a_[k + 1] - a_[k]) / (time_[k + 1] - time_[k]);
    return {.support = x_[k] + s * (v_[k] + s * (a_[k] / 2.0 + s * rise / 6.0)),
            .support_velocity = v_[k] + s * (a_[k] + s * rise / 2.0)};
  }

  std::vector<double> time_;
  std::vector<double> a_;
  std::vector<double> v_;
  std::vector<double> x_;
};

constexpr double kStep = 1e-3;  // s, between the times of the tables

/// A half-sine of 11 ms, and rest.
Table half_sine(double peak) {
  std::vector<double> time;
  std::vector<double> acceleration;
  for (int i = 0; i <= 300; ++i) {
    const double t = kStep * i;
    time.push_back(t);
    acceleration.push_back(t < 0.011 ? peak * std::sin(pi * t / 0.011) : 0.0);
  }
  return {time, acceleration};
}

/// White noise through a low pass of 60 Hz.
Table noise(std::uint64_t seed, double size) {
  RandomStream random(seed, 7);
  std::vector<double> time;
  std::vector<double> acceleration;
  double a = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    time.push_back(kStep * i);
    acceleration.push_back(size * a);
    a += (1.0 - std::exp(-2.0 * pi * 60.0 * kStep)) * (random.normal() - a);
  }
  return {time, acceleration};
}

struct Compared {
  std::string what;
  double miss = 0.0;
  double largest = 0.0;

  void add(double found, double wanted) {
    miss = std::max(miss, std::abs(found - wanted));
    largest = std::max(largest, std::abs(wanted));
  }
};

/// The march against the integration, at the times of the table: largest differences over largest
/// values.
std::vector<Compared> compare(const Table& table) {
  const ShakenChain chain;
  const LoadHistory loads = table.loads();
  MarchOptions options;
  options.points = {"m3"};
  std::vector<std::array<double, 6>> rows;  // w, ẅ, absolute w, ẅ, u, F
  const MarchResult result =
      march_rows(chain.modal("table"), loads, options, [&](const MarchRow& row) {
        rows.push_back({row.displacement[0], row.acceleration[0], row.absolute_displacement[0],
                        row.absolute_acceleration[0], row.joint_displacement[0],
                        row.joint_force[0]});
      });
  EXPECT_TRUE(result.summary.converged()) << result.summary.full();

  std::vector<Compared> all{{"displacement"},          {"acceleration"},
                            {"absolute displacement"}, {"absolute acceleration"},
                            {"joint displacement"},    {"joint force"}};
  constexpr double kFine = 5e-6;
  const auto per_row = static_cast<std::size_t>(std::llround(kStep / kFine));
  std::size_t step = 0;
  chain.integrate([&](double t) { return table.at(t); }, {}, loads.time.back(), kFine,
                  [&](double t, const ShakenChain::State& state) {
                    if (++step % per_row != 0) return;
                    const std::array<double, 6>& row = rows.at(step / per_row);
                    const ShakenChain::Acting support = table.at(t);
                    const std::size_t k = std::min(step / per_row, loads.time.size() - 1);
                    const double wanted[] = {state.x[2] - support.support,
                                             state.a[2] - loads.forces[0].force[k],
                                             state.x[2],
                                             state.a[2],
                                             state.x[1] - state.x[0],
                                             state.joint_force};
                    for (std::size_t i = 0; i < all.size(); ++i) all[i].add(row[i], wanted[i]);
                  });
  return all;
}

// 1e-4 of the largest value is required. The integration errs by h² at reversals, some 1e-6 with 5
// µs; the march itself estimates an error of 1e-6.
TEST(BaseExcitation, OfAShockIsThatOfCoordinatesThatStandStill) {
  for (const Compared& one : compare(half_sine(60.0))) {
    test::record_largest("difference [1]", one.miss / one.largest);
    EXPECT_LT(one.miss, 1e-4 * one.largest) << one.what;
  }
}

TEST(BaseExcitation, OfNoiseIsThatOfCoordinatesThatStandStill) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    for (const Compared& one : compare(noise(seed, 40.0))) {
      test::record_largest("difference [1]", one.miss / one.largest);
      EXPECT_LT(one.miss, 1e-4 * one.largest) << one.what << ", seed " << seed;
    }
  }
}

// In steady motion of the sine of a shaker table: amplitudes of relative and absolute motion. The
// transient is gone to 1e-8 after 8 s (ζ of the first mode 0.01 and slip); harmonics above 9 leave
// less than 1e-5.
TEST(BaseExcitation, InSteadyMotionIsThatOfCoordinatesThatStandStill) {
  const ShakenChain chain;
  const double acceleration = 6.0;
  const double omega = 2.0 * pi * 13.0;
  const HarmonicBalance balance(chain.modal("table"), {"m3"}, {.harmonics = 9, .samples = 512});
  const VibrationResult found = balance.solve({Quantity::kAngularFrequency, omega},
                                              {Quantity::kForceAmplitude, acceleration});
  ASSERT_TRUE(found.summary.converged()) << found.summary.full();

  constexpr double kEnd = 12.0;
  constexpr std::size_t kPerPeriod = 8000;
  const double h = 2.0 * pi / omega / kPerPeriod;
  const double periods = std::floor(kEnd * omega / (2.0 * pi));
  std::complex<double> relative = 0.0;
  std::complex<double> absolute = 0.0;
  const auto support = [&](double t) {  // a cos ωt, from a start that does not drift away
    return ShakenChain::Acting{.support = -acceleration / (omega * omega) * std::cos(omega * t),
                               .support_velocity = acceleration / omega * std::sin(omega * t)};
  };
  ShakenChain::State start;
  start.x.fill(support(0.0).support);
  const double end = periods * 2.0 * pi / omega;
  chain.integrate(support, start, end, h, [&](double t, const ShakenChain::State& state) {
    if (t <= end - 2.0 * pi / omega + 0.5 * h) return;
    const std::complex<double> turn = 2.0 / kPerPeriod * std::polar(1.0, -omega * t);
    absolute += turn * state.x[2];
    relative += turn * (state.x[2] - support(t).support);
  });
  const auto structure = balance.structure();
  const auto w = found.vibration.displacement(structure.linear(), "m3").at(1);
  const auto x = found.vibration.absolute_displacement(structure, "m3").at(1);
  EXPECT_LT(std::abs(w - relative), 1e-4 * std::abs(relative));
  EXPECT_LT(std::abs(x - absolute), 1e-4 * std::abs(absolute));
  EXPECT_GT(found.vibration.joints[0].dissipation, 0.0);
}

// Γᵀq̇ is what a base works on: energy closes in the march and in the balance as with forces.
TEST(BaseExcitation, KeepsTheBalanceOfEnergy) {
  const ShakenChain chain;
  const Table table = half_sine(60.0);
  const MarchResult marched = march(chain.modal("table"), table.loads());
  EXPECT_LT(marched.energy.imbalance(), 1e-6);
  EXPECT_GT(marched.energy.input, 0.0);
  const HarmonicBalance balance(chain.modal("table"), {"m3"});
  const auto found = balance.solve(kPhaseResonance, {Quantity::kResponse, 1e-3});
  ASSERT_TRUE(found.summary.converged()) << found.summary.full();
  EXPECT_LT(found.vibration.energy_imbalance, 1e-8);
}

TEST(BaseExcitation, StandsBesideNoForce) {
  const ShakenChain chain;
  const JointedStructure structure = chain.modal("table");
  const auto message = test::message_or("", [&] {
    return JointedStructure(structure.linear(), {}, {{"m1"}, {"table"}});
  });
  test::expect_message(message, "'table'");
  EXPECT_TRUE(structure.base_driven());
  EXPECT_FALSE(chain.modal("m1").base_driven());
}

}  // namespace
}  // namespace microslip::base_excitation_test
