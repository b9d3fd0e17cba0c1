// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march_weights.hpp"

#include <array>
#include <cmath>
#include <complex>

namespace microslip {
namespace {

/// Of q″ + 2δq′ + θ²q = τᵐ over τ from 0 to 1, from rest: q(1) for m = 0 … 3, and the impulse
/// response g(1), its slope g′(1) and g′ + 2δg, the response to q(0) = 1. δ = ½ηωh, θ = ωh.
struct Responses {
  std::array<double, 4> power;
  double impulse;
  double slope;
  double rest;
};

constexpr std::size_t kMostTerms = 100;

/// 1/(n(n + 1)); n from 1.
constexpr std::array<double, kMostTerms + 8> kInverseProducts = [] {
  std::array<double, kMostTerms + 8> values{};
  for (std::size_t n = 1; n < values.size(); ++n) {
    values[n] = 1.0 / (static_cast<double>(n) * static_cast<double>(n + 1));
  }
  return values;
}();

/// q(1) = Σ_k a_k of q = τ^{m+2} Σ a_k τᵏ, for m = 2 and 3. The terms fall from (θ, 2δ)ᵏ/k! on. Both
/// at once, as each waits for its own last term.
std::array<double, 2> power_series(double delta, double theta_squared) {
  std::array<double, 2> before{};
  std::array<double, 2> term{kInverseProducts[3], kInverseProducts[4]};
  std::array<double, 2> sum = term;
  for (std::size_t k = 1; k < kMostTerms; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t n = 3 + i + k;
      const double next =
          -(2.0 * delta * static_cast<double>(n) * term[i] + theta_squared * before[i]) *
          kInverseProducts[n];
      before[i] = term[i];
      term[i] = next;
      sum[i] += term[i];
    }
    // What follows of the smaller one is less than half of its last digit.
    if (std::abs(term[0]) + std::abs(before[0]) < 1e-18 * sum[1]) break;
  }
  return sum;
}

// Both take τᵐ from one to the next by θ²q_m = 1 − 2δ q_m′ − q_m″, with q_m′ = m q_{m−1}: stable
// down for a small θ, where the other way divides by it, and up for a large one.
Responses by_series(double delta, double theta_squared) {
  Responses r;
  const auto [second, third] = power_series(delta, theta_squared);
  r.power[2] = second;
  r.power[3] = third;
  r.power[1] = (1.0 - theta_squared * r.power[3] - 6.0 * delta * r.power[2]) / 6.0;
  r.power[0] = (1.0 - theta_squared * r.power[2] - 4.0 * delta * r.power[1]) / 2.0;
  r.impulse = 1.0 - theta_squared * r.power[1] - 2.0 * delta * r.power[0];
  r.rest = 1.0 - theta_squared * r.power[0];
  r.slope = r.rest - 2.0 * delta * r.impulse;
  return r;
}

/// g(1) and g′(1) of what vibrates, δ well below θ.
std::array<double, 2> vibrating_response(double delta, double theta_squared) {
  const double frequency = std::sqrt(theta_squared - delta * delta);
  const double decay = std::exp(-delta);
  const double ratio = decay * std::sin(frequency) / frequency;
  return {ratio, decay * std::cos(frequency) - delta * ratio};
}

/// g(1) and g′(1) with the roots −δ ± √(δ² − θ²), real or not.
std::array<double, 2> impulse_response(double delta, double theta_squared) {
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

Responses in_closed_form(double delta, double theta_squared) {
  const auto [impulse, slope] = delta * delta < 0.5 * theta_squared
                                    ? vibrating_response(delta, theta_squared)
                                    : impulse_response(delta, theta_squared);
  Responses r;
  r.impulse = impulse;
  r.slope = slope;
  r.rest = slope + 2.0 * delta * impulse;
  const double inverse = 1.0 / theta_squared;
  r.power[0] = (1.0 - 2.0 * delta * impulse - slope) * inverse;
  r.power[1] = (1.0 - 2.0 * delta * r.power[0] - impulse) * inverse;
  r.power[2] = (1.0 - 4.0 * delta * r.power[1] - 2.0 * r.power[0]) * inverse;
  r.power[3] = (1.0 - 6.0 * delta * r.power[2] - 6.0 * r.power[1]) * inverse;
  return r;
}

/// ∫₀¹ e^{(1−τ)z} τᵐ dτ for m = 0 … 3, z ≤ 0. For moderate z by Kummer's transformation of the
/// power series, all terms positive [DLMF 13.2.39]; where z is large by parts, which divides by it.
std::array<double, 4> decayed_powers(double z) {
  constexpr double kLarge = 30.0;
  std::array<double, 4> result{};
  if (z < -kLarge) {
    result[0] = std::expm1(z) / z;
    for (std::size_t m = 1; m < 4; ++m) {
      result[m] = (static_cast<double>(m) * result[m - 1] - 1.0) / z;
    }
    return result;
  }
  const double decay = std::exp(z);
  for (std::size_t m = 0; m < 4; ++m) {
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
  for (std::size_t m = 0; m < 4; ++m) r.power[m] = (of_slow[m] - of_fast[m]) / apart;
  const double e_slow = std::exp(slow);
  const double e_fast = std::exp(fast);
  r.impulse = (e_slow - e_fast) / apart;
  r.slope = (slow * e_slow - fast * e_fast) / apart;
  r.rest = (slow * e_fast - fast * e_slow) / apart;
  return r;
}

Responses responses(double delta, double theta_squared) {
  const bool slow = theta_squared < 9.0 && delta < 1.5;
  if (!slow && theta_squared <= 0.75 * delta * delta) return by_real_roots(delta, theta_squared);
  return slow ? by_series(delta, theta_squared) : in_closed_form(delta, theta_squared);
}

/// Values and slopes at both ends from the responses to 1, τ, τ², τ³.
std::array<double, 4> hermite(double p0, double p1, double p2, double p3) {
  return {p0 - 3.0 * p2 + 2.0 * p3, p1 - 2.0 * p2 + p3, 3.0 * p2 - 2.0 * p3, p3 - p2};
}

}  // namespace

StepWeights::StepWeights(std::span<const Mode> modes)
    : modes_(modes.begin(), modes.end()), weights_(padded(modes.size()) * kKinds, 0.0) {}

void StepWeights::set_length(double length) {
  length_ = length;
  const double h = length;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const double theta = modes_[i].angular_frequency * h;
    const double delta = 0.5 * modes_[i].loss_factor * theta;
    const Responses r = responses(delta, theta * theta);
    double* out = weights_.data() + i / kLanes * kKinds * kLanes + i % kLanes;
    const auto set = [out](Kind kind, double value) { out[kind * kLanes] = value; };
    set(kE11, r.rest);
    set(kE12, h * r.impulse);
    set(kE21, -theta * theta * r.impulse / h);
    set(kE22, r.slope);
    const auto q = hermite(r.power[0], r.power[1], r.power[2], r.power[3]);
    const auto v = hermite(r.impulse, r.power[0], 2.0 * r.power[1], 3.0 * r.power[2]);
    set(kA0, h * h * q[0]);
    set(kB0, h * h * h * q[1]);
    set(kA1, h * h * q[2]);
    set(kB1, h * h * h * q[3]);
    set(kC0, h * v[0]);
    set(kD0, h * h * v[1]);
    set(kC1, h * v[2]);
    set(kD1, h * h * v[3]);
  }
}

}  // namespace microslip
