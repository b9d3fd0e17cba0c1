// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/shaker.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <vector>

#include "microslip/algebra/lu.hpp"
#include "microslip/base/random.hpp"

namespace microslip::shaker_test {
namespace {

using Complex = std::complex<double>;

RigShaker random_shaker(RandomStream& random) {
  const auto about = [&](double value) { return value * std::exp(2.0 * random.uniform() - 1.0); };
  return {.resistance = about(2.0),
          .inductance = about(2e-4),
          .force_factor = about(8.0),
          .moving_mass = about(0.08),
          .suspension_stiffness = about(7e3),
          .suspension_damping = about(5.0),
          .stinger_stiffness = about(3e6)};
}

Complex random_complex(RandomStream& random) { return {random.normal(), random.normal()}; }

/// I, x and F by the three equations as they stand.
Eigen::Vector3cd solve_equations(const RigShaker& s, double omega, Complex voltage, Complex w) {
  const Complex i{0.0, omega};
  Eigen::Matrix3cd matrix;
  Eigen::Vector3cd right;
  matrix << s.resistance + i * s.inductance, i * s.force_factor, 0.0,  //
      -s.force_factor,
      s.suspension_stiffness - omega * omega * s.moving_mass + i * s.suspension_damping, 1.0,  //
      0.0, -s.stinger_stiffness, 1.0;
  right << voltage, 0.0, -s.stinger_stiffness * w;
  return matrix.partialPivLu().solve(right);
}

// Rounding of three equations whose coefficients lie 1e6 apart.
TEST(Shaker, EliminatesCurrentAndArmature) {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const RigShaker shaker = random_shaker(random);
    const double omega = 3000.0 * random.uniform();
    const Complex voltage = random_complex(random);
    const Complex w = 1e-4 * random_complex(random);
    const Complex expected = solve_equations(shaker, omega, voltage, w)[2];
    const ShakerTransfer transfer = shaker_transfer(shaker, omega);
    const Complex force = transfer.voltage * voltage - transfer.displacement * w;
    EXPECT_LT(std::abs(force - expected), 1e-9 * std::abs(expected));
  }
}

TEST(Shaker, BlockedGivesItsStaticForce) {
  const RigShaker shaker{.inductance = 0.0, .suspension_stiffness = 0.0};
  // At rest F = Bl V/R.
  EXPECT_NEAR(shaker_transfer(shaker, 0.0).voltage.real(), 4.0, 1e-12);
  EXPECT_EQ(std::abs(shaker_transfer(shaker, 0.0).displacement), 0.0);
}

TEST(Shaker, LosesNoEnergyBesideCoilAndSuspension) {
  RandomStream random(2, 0);
  for (int trial = 0; trial < 50; ++trial) {
    const RigShaker shaker = random_shaker(random);
    const double omega = 100.0 + 300.0 * random.uniform();
    std::vector<Complex> voltage{0.0}, force{0.0}, w{0.0};
    double coil = 0.0;
    for (int n = 1; n <= 5; ++n) {
      voltage.push_back(random_complex(random));
      w.push_back(1e-4 * random_complex(random));
      const Eigen::Vector3cd state = solve_equations(shaker, n * omega, voltage.back(), w.back());
      force.push_back(state[2]);
      coil += std::numbers::pi / omega * shaker.resistance * std::norm(state[0]);
    }
    const ShakerEnergy energy = shaker_energy(shaker, omega, voltage, force, w);
    EXPECT_NEAR(energy.coil, coil, 1e-9 * coil);
    EXPECT_GT(energy.suspension, 0.0);
    // Terms of both signs: rounding of the largest.
    EXPECT_NEAR(energy.electrical, energy.coil + energy.suspension + energy.mechanical,
                1e-9 * energy.coil);
  }
}

}  // namespace
}  // namespace microslip::shaker_test
