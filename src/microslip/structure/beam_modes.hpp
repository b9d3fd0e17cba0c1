// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "microslip/structure/uniform_beam.hpp"

namespace microslip {

/// The first modes of a beam: ω_i by rising frequency, and shapes φ_i that are mass-normalised with
/// the point masses,
///
///     ∫₀ᴸ ρA φ_i φ_j dx + Σ_k m_k φ_i(x_k) φ_j(x_k) = δ_ij,
///
/// with the sign that φ_i′(L) < 0, or that a spring would make it so where the end is clamped: the
/// first mode is positive inside the span. All are exact to rounding: solutions of the beam
/// equation between the masses, none missed however close two frequencies are (the count of
/// natural_frequencies_below() encloses each). Immutable.
///
/// The spring acts on the frequencies by ∂ω_i²/∂k_θ = φ_i′(L)².
class BeamModes {
 public:
  /// @param beam   as check_beam() demands.
  /// @param modes  from 1 to 1000.
  /// @throws InputError  for a beam or a number of modes out of its range.
  BeamModes(const Beam& beam, std::size_t modes);

  /// The number of modes.
  [[nodiscard]] std::size_t size() const { return angular_frequencies_.size(); }

  /// ω_i, rad/s, rising.
  [[nodiscard]] std::span<const double> angular_frequencies() const { return angular_frequencies_; }
  /// ω_i/(2π), Hz. @param mode  from 0; @throws InputError  where there is no such mode.
  [[nodiscard]] double frequency(std::size_t mode) const;

  /// φ_i(x) of all modes, kg^−½. @param x  m, in [0, L]; @throws InputError  elsewhere.
  [[nodiscard]] std::vector<double> shapes(double x) const;
  /// φ_i′(x) of all modes, kg^−½/m. @param x  m, in [0, L]; @throws InputError  elsewhere.
  [[nodiscard]] std::vector<double> slopes(double x) const;

  /// φ_i′(L), kg^−½/m; with all its digits also where a stiff spring makes it small.
  [[nodiscard]] std::span<const double> tip_slopes() const { return tip_slopes_; }

  /// ∫₀ᴸ φ_i′ φ_j′ dx, 1/(kg m): the shortening of the beam is −½ Σ q_i q_j of it [AR14 (13)].
  /// @param i, j  from 0; @throws InputError  where there is no such mode.
  [[nodiscard]] double slope_integral(std::size_t i, std::size_t j) const;

 private:
  void check_mode(std::size_t mode) const;
  template <typename Action>
  void for_each_state(double x, const Action& action) const;

  double length_;
  std::vector<double> angular_frequencies_;
  std::vector<double> tip_slopes_;
  std::vector<double> slope_integrals_;  // by rows
  std::vector<double> wavenumbers_;      // λ_i, over L
  std::vector<double> nodes_;            // where the elements start, over L; L itself at the end
  std::vector<std::array<double, 4>>
      states_;  // (φ, φ′/λ, φ″/λ², φ‴/λ³) behind each node, one row per mode
};

}  // namespace microslip
