// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "microslip/structure/beam.hpp"

namespace microslip::testing {

/// The beam by the textbook: the solutions w″ and w‴ at the clamp are carried to L with circular
/// and hyperbolic functions, and the determinant of the conditions there is zero at a natural
/// frequency. The determinant cancels by e^{2λ}, and by the square of a heavy mass: 50 digits are
/// enough for ten modes of a beam with masses up to 1000 times its own.
template <unsigned kDigits>
class ExactBeamIn {
 public:
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<kDigits>,
                                             boost::multiprecision::et_off>;

  explicit ExactBeamIn(const Beam& beam) : beam_(beam) {
    std::ranges::sort(beam_.masses, {}, &PointMass::position);
  }

  [[nodiscard]] Real determinant(const Real& angular_frequency) const {
    const auto [first, second] = conditions(angular_frequency);
    return first[0] * second[1] - second[0] * first[1];
  }

  /// A natural frequency lies within a relative `distance` of ω.
  [[nodiscard]] bool has_root_near(double angular_frequency, double distance) const {
    const Real below = determinant(Real(angular_frequency) * (1 - Real(distance)));
    const Real above = determinant(Real(angular_frequency) * (1 + Real(distance)));
    return below.sign() * above.sign() < 0;
  }

  /// The root within a relative `distance` of ω, to 30 digits.
  [[nodiscard]] Real root(double angular_frequency, double distance) const {
    Real low = Real(angular_frequency) * (1 - Real(distance));
    Real high = Real(angular_frequency) * (1 + Real(distance));
    const int sign = determinant(low).sign();
    for (int i = 0; i < 60; ++i) {
      const Real middle = (low + high) / 2;
      (determinant(middle).sign() == sign ? low : high) = middle;
    }
    return low;
  }

  /// (w, w′) at the places x of the solution with w(L) = 0, of any scale.
  [[nodiscard]] std::vector<std::array<Real, 2>> shape(const Real& root,
                                                       const std::vector<double>& places) const {
    const auto [first, second] = conditions(root);
    std::vector<std::array<Real, 2>> result;
    for (const double x : places) {
      const State a = carried({0, 0, 1, 0}, root, x);
      const State b = carried({0, 0, 0, 1}, root, x);
      result.push_back({a[0] * second[0] - b[0] * first[0], a[1] * second[0] - b[1] * first[0]});
    }
    return result;
  }

 private:
  using State = std::array<Real, 4>;  // w, w′, w″, w‴

  /// w and the moment at L of the two solutions.
  [[nodiscard]] std::array<std::array<Real, 2>, 2> conditions(const Real& omega) const {
    std::array<std::array<Real, 2>, 2> result;
    for (int i = 0; i < 2; ++i) {
      const State y = carried({0, 0, i == 0 ? 1 : 0, i == 0 ? 0 : 1}, omega, beam_.length);
      const bool clamped = std::isinf(beam_.tip_stiffness);
      result[static_cast<std::size_t>(i)] = {
          y[0],
          clamped ? y[1] : Real(beam_.bending_stiffness) * y[2] + Real(beam_.tip_stiffness) * y[1]};
    }
    return result;
  }

  [[nodiscard]] State carried(State y, const Real& omega, double to) const {
    const Real stiffness = beam_.bending_stiffness;
    const Real beta = sqrt(omega * sqrt(Real(beam_.mass_per_length) / stiffness));
    double x = 0.0;
    for (const auto& [position, mass] : beam_.masses) {
      if (position >= to) break;
      y = field(y, beta, Real(position) - x);
      y[3] += Real(mass) * omega * omega / stiffness * y[0];
      x = position;
    }
    return field(y, beta, Real(to) - x);
  }

  static State field(const State& y, const Real& beta, const Real& length) {
    const Real z = beta * length;
    const std::array<Real, 4> k = {(cosh(z) + cos(z)) / 2, (sinh(z) + sin(z)) / 2,
                                   (cosh(z) - cos(z)) / 2, (sinh(z) - sin(z)) / 2};
    const std::array<Real, 4> powers = {1, beta, beta * beta, beta * beta * beta};
    State next;
    for (std::size_t row = 0; row < 4; ++row) {
      next[row] = 0;
      for (std::size_t column = 0; column < 4; ++column) {
        next[row] += k[(column + 4 - row) % 4] * powers[row] / powers[column] * y[column];
      }
    }
    return next;
  }

  Beam beam_;
};

using ExactBeam = ExactBeamIn<50>;

}  // namespace microslip::testing
