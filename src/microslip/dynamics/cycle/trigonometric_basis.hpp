// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"

/// @file
/// Periodic functions by their harmonics, in real numbers. Internal to dynamics.
///
/// x(τ) = Re Σ_{n=0}^{H} x_n e^{inτ} is the vector (x_0, Re x_1, Im x_1, …, Re x_H, Im x_H): its
/// product with the row T(τ) = (1, cos τ, −sin τ, …, cos Hτ, −sin Hτ) is x(τ).

namespace microslip {

/// 2H + 1.
[[nodiscard]] constexpr Eigen::Index coefficient_count(std::size_t harmonics) {
  return static_cast<Eigen::Index>(2 * harmonics + 1);
}

/// Where Re x_n is in the vector; Im x_n, for n ≥ 1, is the one after.
[[nodiscard]] constexpr Eigen::Index coefficient_index(std::size_t n) {
  return static_cast<Eigen::Index>(n == 0 ? 0 : 2 * n - 1);
}

/// Whether that place belongs to an even harmonic, the mean among them.
[[nodiscard]] constexpr bool is_even_coefficient(Eigen::Index i) {
  return i == 0 || (i - 1) / 2 % 2 == 1;
}

/// Coefficients of a function in a vector: all, or, where x(τ + π) = −x(τ), those of odd harmonics,
/// (Re x_1, Im x_1, Re x_3, …).
enum class Wave : std::uint8_t { kAny, kOdd };

/// Where in such a vector the pair of harmonic 1 begins.
[[nodiscard]] constexpr Eigen::Index first_pair(Wave wave) { return wave == Wave::kOdd ? 0 : 1; }

/// From the harmonic of one pair to that of the next.
[[nodiscard]] constexpr std::size_t harmonic_step(Wave wave) { return wave == Wave::kOdd ? 2 : 1; }

/// Where its coefficients are in the vector of all, harmonics up to H.
[[nodiscard]] std::vector<Eigen::Index> coefficients_of(Wave wave, std::size_t harmonics);

/// x_n. @param x  the coefficients of one function.
[[nodiscard]] std::complex<double> harmonic_of(const Eigen::Ref<const Eigen::VectorXd>& x,
                                               std::size_t n);

/// The value of a function and its derivatives by τ.
struct Motion {
  double value;
  double velocity;
  double acceleration;
};
[[nodiscard]] Motion motion_at(std::span<const double> coefficients, double tau,
                               Wave wave = Wave::kAny);

/// The row T(τ).
void basis_at(double tau, Eigen::Ref<Eigen::VectorXd> row);

/// dT/dτ where the row is T.
void derivative_of_basis(const Eigen::Ref<const Eigen::VectorXd>& row,
                         Eigen::Ref<Eigen::VectorXd> slope);

/// The matrix C with C y = the coefficients up to H of the product t(τ) y(τ).
/// @param t     the coefficients of t up to 2H, or fewer: the rest is zero.
/// @param wave  of y; odd: t has even harmonics alone, and what couples even and odd ones is 0.
[[nodiscard]] Eigen::MatrixXd multiplication_matrix(const Eigen::Ref<const Eigen::VectorXd>& t,
                                                    std::size_t harmonics, Wave wave = Wave::kAny);

/// T at N equal samples of a period.
class TrigonometricBasis {
 public:
  TrigonometricBasis(std::size_t harmonics, std::size_t samples);

  [[nodiscard]] std::size_t harmonics() const { return harmonics_; }
  [[nodiscard]] Eigen::Index samples() const { return rows_.rows(); }

  /// N × (4H + 1): one row per sample, up to harmonic 2H.
  [[nodiscard]] const Eigen::MatrixXd& rows() const { return rows_; }

  /// (N + 1) × (2H + 1): row k is the sum of the rows before k.
  [[nodiscard]] const Eigen::MatrixXd& sums() const { return sums_; }

  /// x at the first samples: the columns that are named times their coefficients.
  void evaluate(std::span<const Eigen::Index> columns, std::span<const double> coefficients,
                std::span<double> x) const;

  /// Σ_k rows()(first + k, c) f_k for each column c that is named.
  void sum(std::span<const Eigen::Index> columns, Eigen::Index first, std::span<const double> f,
           std::span<double> sums) const;

  /// 1/N, then 2/N: the coefficients of sampled x are these times rows()ᵀ x.
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weights_; }

 private:
  std::size_t harmonics_;
  Eigen::MatrixXd rows_;
  Eigen::MatrixXd sums_;
  Eigen::VectorXd weights_;
};

}  // namespace microslip
