// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_weights.hpp"

#include <array>
#include <cmath>
#include <complex>

#include "microslip/base/vector_clones.hpp"

namespace microslip {
namespace {

/// g(1) and g′(1) of what vibrates, δ well below θ.
ImpulseResponse vibrating_response(double delta, double theta_squared) {
  const double frequency = std::sqrt(theta_squared - delta * delta);
  const double decay = std::exp(-delta);
  const double ratio = decay * std::sin(frequency) / frequency;
  return {ratio, decay * std::cos(frequency) - delta * ratio};
}

/// The response by the roots −δ ± √(δ² − θ²), real or not.
ImpulseResponse decaying_response(double delta, double theta_squared) {
  using Complex = std::complex<double>;
  const Complex root = std::sqrt(Complex(delta * delta - theta_squared, 0.0));
  const Complex up = std::exp(root - delta);  // no overflow: |Re root| ≤ δ
  const Complex down = std::exp(-root - delta);
  const Complex sinh = 0.5 * (up - down);
  const Complex cosh = 0.5 * (up + down);
  const double small = std::abs(root);
  const Complex ratio = small < 1e-4 ? std::exp(-delta) * (1.0 + root * root / 6.0) : sinh / root;
  return {ratio.real(), (cosh - delta * ratio).real()};
}

}  // namespace

ImpulseResponse impulse_response(double delta, double theta_squared) {
  return delta * delta < 0.5 * theta_squared ? vibrating_response(delta, theta_squared)
                                             : decaying_response(delta, theta_squared);
}

namespace {

constexpr std::size_t kPowers = 5;

/// Responses of q″ + 2δq′ + θ²q = τᵐ over τ from 0 to 1, from rest: q(1) for m = 0 … 4, and the
/// impulse response g(1), its slope g′(1) and g′ + 2δg, the response to q(0) = 1. δ = ½ηωh, θ = ωh.
struct Responses {
  std::array<double, kPowers> power;
  double impulse;
  double slope;
  double rest;
};

constexpr std::size_t kMostTerms = 100;
/// Terms added between checks whether they were the last.
constexpr std::size_t kTermsAtOnce = 4;

/// 1/(n(n + 1)); n from 1.
constexpr std::array<double, kMostTerms + 8> kInverseProducts = [] {
  std::array<double, kMostTerms + 8> values{};
  for (std::size_t n = 1; n < values.size(); ++n) {
    values[n] = 1.0 / (static_cast<double>(n) * static_cast<double>(n + 1));
  }
  return values;
}();

/// The responses of a group of modes, and their parameters.
struct GroupResponses {
  double delta[kLanes];
  double theta_squared[kLanes];
  double power[kPowers][kLanes];
  double impulse[kLanes];
  double slope[kLanes];
  double rest[kLanes];
};

/// One more term of q(1) = Σ_k a_k of q = τ^{m+2} Σ a_k τᵏ; n = m + 1 + k.
inline void add_term(const GroupResponses& r, std::size_t n, double* before, double* term,
                     double* sum) {
  const double grows = 2.0 * static_cast<double>(n);
  const double share = kInverseProducts[n];
#pragma omp simd
  for (std::size_t j = 0; j < kLanes; ++j) {
    const double next = -(r.delta[j] * grows * term[j] + r.theta_squared[j] * before[j]) * share;
    before[j] = term[j];
    term[j] = next;
    sum[j] += next;
  }
}

// Responses by the series for m = 3 and 4, both at once, as each waits for its own last term. The
// terms fall from (θ, 2δ)ᵏ/k! on. Here and in closed form τᵐ goes from one to the next by θ²q_m = 1
// − 2δ q_m′ − q_m″, with q_m′ = m q_{m−1}: stable down for a small θ, where the other direction
// divides by it, and up for a large one.
MICROSLIP_VECTOR_CLONES
void by_series(GroupResponses& r) {
  double before[2][kLanes] = {};
  double term[2][kLanes];
  double sum[2][kLanes];
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < kLanes; ++j) term[i][j] = sum[i][j] = kInverseProducts[4 + i];
  }
  for (std::size_t k = 1; k < kMostTerms; k += kTermsAtOnce) {
    for (std::size_t n = 4 + k; n < 4 + k + kTermsAtOnce; ++n) {
      add_term(r, n, before[0], term[0], sum[0]);
      add_term(r, n + 1, before[1], term[1], sum[1]);
    }
    // What follows of the smaller one is less than half of its last digit.
    double left = 0.0;
#pragma omp simd reduction(max : left)
    for (std::size_t j = 0; j < kLanes; ++j) {
      const double part = std::abs(term[0][j]) + std::abs(before[0][j]) - 1e-18 * sum[1][j];
      left = part > left ? part : left;
    }
    if (!(left > 0.0)) break;
  }
#pragma omp simd
  for (std::size_t j = 0; j < kLanes; ++j) {
    const double delta = r.delta[j];
    const double theta_squared = r.theta_squared[j];
    const double second = (1.0 - theta_squared * sum[1][j] - 8.0 * delta * sum[0][j]) / 12.0;
    const double first = (1.0 - theta_squared * sum[0][j] - 6.0 * delta * second) / 6.0;
    const double zeroth = (1.0 - theta_squared * second - 4.0 * delta * first) / 2.0;
    r.power[4][j] = sum[1][j];
    r.power[3][j] = sum[0][j];
    r.power[2][j] = second;
    r.power[1][j] = first;
    r.power[0][j] = zeroth;
    r.impulse[j] = 1.0 - theta_squared * first - 2.0 * delta * zeroth;
    r.rest[j] = 1.0 - theta_squared * zeroth;
    r.slope[j] = r.rest[j] - 2.0 * delta * r.impulse[j];
  }
}

Responses in_closed_form(double delta, double theta_squared) {
  const auto [impulse, slope] = impulse_response(delta, theta_squared);
  Responses r;
  r.impulse = impulse;
  r.slope = slope;
  r.rest = slope + 2.0 * delta * impulse;
  const double inverse = 1.0 / theta_squared;
  r.power[0] = (1.0 - 2.0 * delta * impulse - slope) * inverse;
  r.power[1] = (1.0 - 2.0 * delta * r.power[0] - impulse) * inverse;
  r.power[2] = (1.0 - 4.0 * delta * r.power[1] - 2.0 * r.power[0]) * inverse;
  r.power[3] = (1.0 - 6.0 * delta * r.power[2] - 6.0 * r.power[1]) * inverse;
  r.power[4] = (1.0 - 8.0 * delta * r.power[3] - 12.0 * r.power[2]) * inverse;
  return r;
}

/// ∫₀¹ e^{(1−τ)z} τᵐ dτ for m = 0 … 4, z ≤ 0. For moderate z by Kummer's transformation of the
/// power series, all terms positive [DLMF 13.2.39]; where z is large by parts, which divides by it.
std::array<double, kPowers> decayed_powers(double z) {
  constexpr double kLarge = 30.0;
  std::array<double, kPowers> result{};
  if (z < -kLarge) {
    result[0] = std::expm1(z) / z;
    for (std::size_t m = 1; m < kPowers; ++m) {
      result[m] = (static_cast<double>(m) * result[m - 1] - 1.0) / z;
    }
    return result;
  }
  const double decay = std::exp(z);
  for (std::size_t m = 0; m < kPowers; ++m) {
    double term = 1.0;  // (−z)ᵏ/k!
    double sum = 0.0;
    for (double k = 0.0; k < 200.0; ++k) {
      const double part = term / (static_cast<double>(m) + 1.0 + k);
      sum += part;
      if (k > -z && part < 1e-17 * sum) break;
      term *= -z / (k + 1.0);
    }
    result[m] = decay * sum;
  }
  return result;
}

/// As differences between a slow and a fast decay, which must be apart: nothing is divided by θ²,
/// so that the slow one may be as slow as it likes.
Responses by_real_roots(double delta, double theta_squared) {
  const double root = std::sqrt(delta * delta - theta_squared);
  const double fast = -(delta + root);
  const double slow = theta_squared / fast;
  const double apart = 2.0 * root;
  const auto of_slow = decayed_powers(slow);
  const auto of_fast = decayed_powers(fast);
  Responses r;
  for (std::size_t m = 0; m < kPowers; ++m) r.power[m] = (of_slow[m] - of_fast[m]) / apart;
  const double e_slow = std::exp(slow);
  const double e_fast = std::exp(fast);
  r.impulse = (e_slow - e_fast) / apart;
  r.slope = (slow * e_slow - fast * e_fast) / apart;
  r.rest = (slow * e_fast - fast * e_slow) / apart;
  return r;
}

bool is_slow(double delta, double theta_squared) { return theta_squared < 9.0 && delta < 1.5; }

Responses fast_responses(double delta, double theta_squared) {
  return theta_squared <= 0.75 * delta * delta ? by_real_roots(delta, theta_squared)
                                               : in_closed_form(delta, theta_squared);
}

/// The series where modes are slow, what they would make of the others replaced.
void respond(GroupResponses& r) {
  Responses fast[kLanes];
  bool is_fast[kLanes];
  for (std::size_t j = 0; j < kLanes; ++j) {
    is_fast[j] = !is_slow(r.delta[j], r.theta_squared[j]);
    if (!is_fast[j]) continue;
    fast[j] = fast_responses(r.delta[j], r.theta_squared[j]);
    r.delta[j] = r.theta_squared[j] = 0.0;
  }
  by_series(r);
  for (std::size_t j = 0; j < kLanes; ++j) {
    if (!is_fast[j]) continue;
    for (std::size_t m = 0; m < kPowers; ++m) r.power[m][j] = fast[j].power[m];
    r.impulse[j] = fast[j].impulse;
    r.slope[j] = fast[j].slope;
    r.rest[j] = fast[j].rest;
  }
}

/// Values and slopes at both ends, and more in the middle, from the responses to 1, τ, τ², τ³, τ⁴.
MICROSLIP_VECTOR_CLONES
void fill(const GroupResponses& r, double h, const double* frequency, double* weights) {
  using W = StepWeights;
#pragma omp simd
  for (std::size_t j = 0; j < kLanes; ++j) {
    const double omega = frequency[j];
    const double p0 = r.power[0][j];
    const double p1 = r.power[1][j];
    const double p2 = r.power[2][j];
    const double p3 = r.power[3][j];
    const double p4 = r.power[4][j];
    const double g = r.impulse[j];
    weights[W::kE11 * kLanes + j] = r.rest[j];
    weights[W::kE12 * kLanes + j] = h * g;
    weights[W::kE21 * kLanes + j] = -omega * omega * h * g;
    weights[W::kE22 * kLanes + j] = r.slope[j];
    weights[W::kA0 * kLanes + j] = h * h * (p0 - 3.0 * p2 + 2.0 * p3);
    weights[W::kB0 * kLanes + j] = h * h * h * (p1 - 2.0 * p2 + p3);
    weights[W::kA1 * kLanes + j] = h * h * (3.0 * p2 - 2.0 * p3);
    weights[W::kB1 * kLanes + j] = h * h * h * (p3 - p2);
    weights[W::kC0 * kLanes + j] = h * (g - 6.0 * p1 + 6.0 * p2);
    weights[W::kD0 * kLanes + j] = h * h * (p0 - 4.0 * p1 + 3.0 * p2);
    weights[W::kC1 * kLanes + j] = h * (6.0 * p1 - 6.0 * p2);
    weights[W::kD1 * kLanes + j] = h * h * (3.0 * p2 - 2.0 * p1);
    weights[W::kAM * kLanes + j] = 16.0 * h * h * (p2 - 2.0 * p3 + p4);
    weights[W::kCM * kLanes + j] = 16.0 * h * (2.0 * p1 - 6.0 * p2 + 4.0 * p3);
  }
}

}  // namespace

StepWeights::StepWeights(std::span<const Mode> modes)
    : frequency_(padded(modes.size()), 0.0),
      loss_factor_(padded(modes.size()), 0.0),
      weights_(padded(modes.size()) * kKinds, 0.0) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    frequency_[i] = modes[i].angular_frequency;
    loss_factor_[i] = modes[i].loss_factor;
  }
}

void StepWeights::set_length(double length) {
  length_ = length;
  GroupResponses r;
  for (std::size_t first = 0; first < frequency_.size(); first += kLanes) {
    for (std::size_t j = 0; j < kLanes; ++j) {
      const double theta = frequency_[first + j] * length;
      r.delta[j] = 0.5 * loss_factor_[first + j] * theta;
      r.theta_squared[j] = theta * theta;
    }
    respond(r);
    fill(r, length, frequency_.data() + first, weights_.data() + first * kKinds);
  }
}

}  // namespace microslip
