// SPDX-License-Identifier: MIT
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "microslip/base/vector_clones.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kSumLanes = 8;  // sums that run side by side: a vector of them or more

/// x_k = Σ_i coefficients_i matrix(k, columns_i), k < n.
MICROSLIP_VECTOR_CLONES
void add_columns(const double* matrix, Index stride, const Index* columns, Index count,
                 const double* coefficients, Index n, double* x) {
  for (Index k = 0; k < n; ++k) x[k] = 0.0;
  for (Index i = 0; i < count; ++i) {
    const double* column = matrix + columns[i] * stride;
    const double coefficient = coefficients[i];
    for (Index k = 0; k < n; ++k) x[k] += coefficient * column[k];
  }
}

/// sums_i = Σ_k f_k matrix(k, columns_i), k < n.
MICROSLIP_VECTOR_CLONES
void sum_columns(const double* matrix, Index stride, const Index* columns, Index count,
                 const double* f, Index n, double* sums) {
  for (Index i = 0; i < count; ++i) {
    const double* column = matrix + columns[i] * stride;
    std::array<double, kSumLanes> lanes{};
    Index k = 0;
    for (; k + kSumLanes <= n; k += kSumLanes) {
      for (Index l = 0; l < kSumLanes; ++l) {
        lanes[static_cast<std::size_t>(l)] += f[k + l] * column[k + l];
      }
    }
    double rest = 0.0;
    for (; k < n; ++k) rest += f[k] * column[k];
    sums[i] = ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
              ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7])) + rest;
  }
}

/// cos nτ and sin nτ of one harmonic after the other.
class Turning {
 public:
  Turning(double tau, Wave wave) : cosine(std::cos(tau)), sine(std::sin(tau)) {
    const bool twice = wave == Wave::kOdd;
    step_cosine_ = twice ? cosine * cosine - sine * sine : cosine;
    step_sine_ = twice ? 2.0 * sine * cosine : sine;
  }

  void advance() {
    const double next = cosine * step_cosine_ - sine * step_sine_;
    sine = sine * step_cosine_ + cosine * step_sine_;
    cosine = next;
  }

  double cosine;
  double sine;

 private:
  double step_cosine_;
  double step_sine_;
};

}  // namespace

std::vector<Index> coefficients_of(Wave wave, std::size_t harmonics) {
  std::vector<Index> found;
  for (Index i = 0; i < coefficient_count(harmonics); ++i) {
    if (wave == Wave::kAny || !is_even_coefficient(i)) found.push_back(i);
  }
  return found;
}

std::complex<double> harmonic_of(const Eigen::Ref<const VectorXd>& x, std::size_t n) {
  const Index at = coefficient_index(n);
  return n == 0 ? std::complex<double>(x[0]) : std::complex<double>(x[at], x[at + 1]);
}

Motion motion_at(std::span<const double> coefficients, double tau, Wave wave) {
  Motion motion{wave == Wave::kOdd ? 0.0 : coefficients[0], 0.0, 0.0};
  Turning turning(tau, wave);
  auto n = 1.0;
  for (auto i = static_cast<std::size_t>(first_pair(wave)); i + 1 < coefficients.size(); i += 2) {
    const double along = coefficients[i] * turning.cosine - coefficients[i + 1] * turning.sine;
    motion.value += along;
    motion.velocity -= n * (coefficients[i] * turning.sine + coefficients[i + 1] * turning.cosine);
    motion.acceleration -= n * n * along;
    turning.advance();
    n += static_cast<double>(harmonic_step(wave));
  }
  return motion;
}

void basis_at(double tau, Eigen::Ref<VectorXd> row) {
  row[0] = 1.0;
  Turning turning(tau, Wave::kAny);
  for (Index i = 1; i + 1 < row.size(); i += 2) {
    row[i] = turning.cosine;
    row[i + 1] = -turning.sine;
    turning.advance();
  }
}

void derivative_of_basis(const Eigen::Ref<const VectorXd>& row, Eigen::Ref<VectorXd> slope) {
  slope[0] = 0.0;
  for (Index i = 1; i + 1 < row.size(); i += 2) {
    const auto n = static_cast<double>((i + 1) / 2);
    slope[i] = n * row[i + 1];
    slope[i + 1] = -n * row[i];
  }
}

// Row a and column b: (w_a/2π) ∮ t T_a T_b dτ by the product formulas of sine and cosine, from the
// moments of t: ∮ t cos mτ dτ/π = Re t_m and −∮ t sin mτ dτ/π = Im t_m for m ≥ 1,
// with 2t_0 at m = 0.
Eigen::MatrixXd multiplication_matrix(const Eigen::Ref<const VectorXd>& t, std::size_t harmonics,
                                      Wave wave) {
  const auto order = static_cast<Index>(harmonics);
  const auto moment = [&](Index m) {  // of |m|; the sine part is odd in m
    const Index at = coefficient_index(static_cast<std::size_t>(std::abs(m)));
    if (at >= t.size()) return std::array{0.0, 0.0};
    if (m == 0) return std::array{2.0 * t[0], 0.0};
    return std::array{t[at], m < 0 ? -t[at + 1] : t[at + 1]};
  };
  const bool odd = wave == Wave::kOdd;
  const Index size = coefficient_count(harmonics);
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(size, size);
  for (Index b = 0; b <= order; ++b) {
    const Index j = coefficient_index(static_cast<std::size_t>(b));
    for (Index a = odd ? b % 2 : 0; a <= order; a += odd ? 2 : 1) {
      const Index i = coefficient_index(static_cast<std::size_t>(a));
      const double weight = a == 0 ? 0.25 : 0.5;
      const auto [sum, sum_sine] = moment(a + b);
      const auto [difference, difference_sine] = moment(a - b);
      c(i, j) = weight * (difference + sum);
      if (b > 0) c(i, j + 1) = weight * (sum_sine - difference_sine);
      if (a > 0) c(i + 1, j) = weight * (sum_sine + difference_sine);
      if (a > 0 && b > 0) c(i + 1, j + 1) = weight * (difference - sum);
    }
  }
  return c;
}

TrigonometricBasis::TrigonometricBasis(std::size_t harmonics, std::size_t samples)
    : harmonics_(harmonics),
      rows_(static_cast<Index>(samples), coefficient_count(2 * harmonics)),
      sums_(static_cast<Index>(samples) + 1, coefficient_count(harmonics)),
      weights_(
          VectorXd::Constant(coefficient_count(harmonics), 2.0 / static_cast<double>(samples))) {
  weights_[0] = 1.0 / static_cast<double>(samples);
  // The angle of each product n k is reduced to one period in integers: no digits are lost to a
  // large one, and the sines of one period suffice.
  const Index count = rows_.rows();
  VectorXd cosine(count);
  VectorXd sine(count);
  for (Index k = 0; k < count; ++k) {
    const double tau = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    cosine[k] = std::cos(tau);
    sine[k] = std::sin(tau);
  }
  rows_.col(0).setOnes();
  for (std::size_t n = 1; n <= 2 * harmonics; ++n) {
    const Index column = coefficient_index(n);
    Index turn = 0;
    for (Index k = 0; k < count; ++k) {
      rows_(k, column) = cosine[turn];
      rows_(k, column + 1) = -sine[turn];
      turn += static_cast<Index>(n);
      if (turn >= count) turn -= count;  // n < N
    }
  }
  sums_.row(0).setZero();
  for (Index j = 0; j < sums_.cols(); ++j) {
    for (Index k = 0; k < count; ++k) sums_(k + 1, j) = sums_(k, j) + rows_(k, j);
  }
}

void TrigonometricBasis::evaluate(std::span<const Index> columns,
                                  std::span<const double> coefficients, std::span<double> x) const {
  add_columns(rows_.data(), rows_.rows(), columns.data(), std::ssize(columns), coefficients.data(),
              std::ssize(x), x.data());
}

void TrigonometricBasis::sum(std::span<const Index> columns, Index first, std::span<const double> f,
                             std::span<double> sums) const {
  sum_columns(rows_.data() + first, rows_.rows(), columns.data(), std::ssize(columns), f.data(),
              std::ssize(f), sums.data());
}

}  // namespace microslip
