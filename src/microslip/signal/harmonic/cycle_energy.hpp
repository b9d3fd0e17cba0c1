// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/signal/harmonic/fourier_fit.hpp"
#include "microslip/signal/harmonic/fourier_series.hpp"
#include "microslip/signal/recording/recording.hpp"

/// @file
/// Energies of a cycle of steady vibration [AR14 (15)–(18)].

namespace microslip {

/// An energy with its standard error.
struct EnergyEstimate {
  double energy = 0.0;     ///< J
  double std_error = 0.0;  ///< J; 0 where the standard errors of the coefficients were not given
};

/// Work of a force on the point at which the acceleration is measured, in its direction, over one
/// period [AR14 (16)]:
///
///     W = ∮ f ẇ dt = π Σ n Im(F_n conj(W_n)) = −(π/ω²) Σ Im(F_n conj(A_n))/n,   W_n = −A_n/(nω)²
///
/// Its standard error from those of the coefficients, taken as independent:
/// (π/ω²)² Σ (|F_n|² σ_An² + |A_n|² σ_Fn²)/n²; that of ω is negligible beside them.
/// @param force             f, N.
/// @param acceleration      ẅ, m/s²; of the same ω and the same zero of time.
/// @param force_std         standard errors of F_n, N: FourierFit::harmonic_std; empty for 0.
/// @param acceleration_std  of A_n, m/s²; empty for 0.
/// @throws InputError  where ω differs or is not above 0, or a length does not fit.
[[nodiscard]] EnergyEstimate cycle_energy(const FourierSeries& force,
                                          const FourierSeries& acceleration,
                                          std::span<const double> force_std = {},
                                          std::span<const double> acceleration_std = {});

/// Source of the velocity for the sum over the samples.
enum class VelocityFrom {
  kSeries,   ///< the series of the acceleration, integrated in closed form
  kSamples,  ///< the samples of the acceleration, integrated cumulatively
};

/// Work over one period by the sum over the samples.
struct SampledEnergy {
  double energy = 0.0;     ///< mean over the whole cycles, J
  double std_error = 0.0;  ///< from the scatter over the cycles, see scatter(); NaN for < 4, J
  std::vector<double> per_cycle;  ///< J
};

/// W from the samples [AR14 (17)]: ∫ f ẇ dt over each whole cycle after the first sample. For even
/// steps by h/24 (−y_{i−1} + 13 y_i + 13 y_{i+1} − y_{i+2}) per step, for others by the trapezoid,
/// the ends of a cycle interpolated by cubics. For whole numbers of samples per cycle that is exact
/// as long as the product has no content at the sampling rate; else the error is of order (ωh)⁴.
///
/// Mean and trend that were fitted are subtracted from both signals. The velocity is that of the
/// series, or the running integral of the samples, less its mean over the cycle; the latter is
/// independent of the series but for ω.
/// @param axis                over time.
/// @param force               f, N, one value per point of the axis.
/// @param acceleration        ẅ, m/s², one value per point of the axis.
/// @param force_series        the fit of `force`.
/// @param acceleration_series the fit of `acceleration`.
/// @param velocity            where ẇ comes from.
/// @throws InputError  where lengths or ω differ, or the record has no whole cycle.
[[nodiscard]] SampledEnergy cycle_energy_from_samples(
    const Axis& axis, std::span<const double> force, std::span<const double> acceleration,
    const FourierSeries& force_series, const FourierSeries& acceleration_series,
    VelocityFrom velocity = VelocityFrom::kSeries);

/// Energy that the linear (hysteretic) damping of a structure takes in one period [AR14 (18), with
/// the factor n that harmonic n needs: it runs n cycles a period]:
///
///     W_lin = Σ_i Σ_n nπ η_i ω_i² |q_in|²
///
/// @param modal          q_i, coordinates of mass-normalised modes, m√kg.
/// @param loss_factor    η_i, 1; ≥ 0; one per mode.
/// @param natural_omega  ω_i, rad/s; ≥ 0; one per mode.
/// @param modal_std      [mode][n − 1] standard errors of q_in, taken as independent; empty for 0.
/// @throws InputError  where a length or value does not fit.
[[nodiscard]] EnergyEstimate linear_dissipation(
    std::span<const FourierSeries> modal, std::span<const double> loss_factor,
    std::span<const double> natural_omega, std::span<const std::vector<double>> modal_std = {});

}  // namespace microslip
