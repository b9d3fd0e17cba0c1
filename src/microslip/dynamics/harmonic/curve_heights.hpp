// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <vector>

#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/harmonic/target.hpp"

namespace microslip {

/// How high a curve is at a point: the response where the force amplitude is kept, the force
/// amplitude where the response is.
/// @param point  of the curve.
/// @param kept   one of the two.
[[nodiscard]] double height_of(const SteadyVibration& point, Quantity kept);

/// A curve over the frequency between its points: its height at any frequency, once for each branch
/// there.
///
/// With h the height and
/// φ its phase lag, ω and h e^{−iφ} are cubics of the length of the polygon between two points
/// (Hermite, slopes by the neighbours): about a resonance h e^{−iφ} runs along a circle, which
/// cubics follow, whatever its peak. ω is monotone between two points, and peaks and points where
/// the curve turns back are among them. With the steps of HarmonicBalanceOptions and an accuracy of
/// 0 the heights are within some 1e-3 of the curve's.
class CurveHeights {
 public:
  /// @param curve  over the frequency; a point at least, in either direction.
  /// @param kept   the force amplitude or the response.
  CurveHeights(const ResponseCurve& curve, Quantity kept);

  /// Heights, rising; empty outside of the curve.
  /// @param angular_frequency  ω, rad/s.
  [[nodiscard]] std::vector<double> at(double angular_frequency) const;

 private:
  struct Node {
    double angular_frequency;
    std::complex<double> height;
    double place = 0.0;  ///< along the curve
    double slope = 0.0;  ///< dω by the place
    std::complex<double> height_slope = {};
  };

  void add_places();
  void add_slopes();
  [[nodiscard]] double height_in(const Node& from, const Node& to, double angular_frequency) const;

  std::vector<Node> nodes_;
};

}  // namespace microslip
