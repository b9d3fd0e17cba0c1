// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/step_breakpoints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/base/vector_clones.hpp"

namespace microslip {
namespace {

/// Gauss–Legendre quadrature on [0, 1] with 4 nodes: exact for a cubic times one.
constexpr std::size_t kNodes = 4;
constexpr std::array<double, kNodes> kNode{0.06943184420297371, 0.33000947820757187,
                                           0.66999052179242813, 0.93056815579702629};
constexpr std::array<double, kNodes> kNodeWeight{0.17392742256872693, 0.32607257743127307,
                                                 0.32607257743127307, 0.17392742256872693};

/// The coefficients of T_m of a vibration are 2J_m(½θ) [DLMF 10.12.2], which is below 2(¼θ)ᵐ/m!
/// [DLMF 10.14.4]: 5e-6 of the tenth at θ = 5. That of g = sin(ωt)/ω is that much of 1/ω, where g
/// reaches it, and 1/θ times that of h.
constexpr double kLargestAngle = 5.0;
constexpr double kSmallTerm = 6e-6;

/// Up to the first that is small against the largest value of g, and of ġ.
std::size_t terms_needed(double angle) {
  double term = 0.5 * std::max(1.0, angle);  // over θ, of m = 1
  for (std::size_t m = 1; m < kBreakpointTerms; ++m) {
    if (term <= kSmallTerm) return m;
    term *= 0.25 * angle / static_cast<double>(m + 1);
  }
  return kBreakpointTerms;
}

/// x = cos(π(k + ½)/n), the zeros of T_n, and T_m there.
struct ChebyshevTable {
  std::array<double, kBreakpointTerms> x;
  std::array<std::array<double, kBreakpointTerms>, kBreakpointTerms> polynomial;  // [m][k]
};

ChebyshevTable chebyshev_table() {
  ChebyshevTable table;
  constexpr auto kCount = static_cast<double>(kBreakpointTerms);
  for (std::size_t k = 0; k < kBreakpointTerms; ++k) {
    const double angle = std::numbers::pi * (static_cast<double>(k) + 0.5) / kCount;
    table.x[k] = std::cos(angle);
    for (std::size_t m = 0; m < kBreakpointTerms; ++m) {
      table.polynomial[m][k] = std::cos(static_cast<double>(m) * angle);
    }
  }
  return table;
}

/// ∫ T_m e over the piece of a step between two shares, added; e over the piece.
MICROSLIP_VECTOR_CLONES
void add_piece(double left, double right, const StepCubic& e, std::size_t terms, double* moments) {
  const double length = right - left;
  double x[kNodes];
  double before[kNodes];
  double now[kNodes];
#pragma omp simd
  for (std::size_t i = 0; i < kNodes; ++i) {
    x[i] = 1.0 - 2.0 * (left + length * kNode[i]);
    before[i] = length * kNodeWeight[i] * e.value(kNode[i]);
    now[i] = x[i] * before[i];
  }
  for (std::size_t m = 0; m < terms; ++m) {
    moments[m] += (before[0] + before[2]) + (before[1] + before[3]);
#pragma omp simd
    for (std::size_t i = 0; i < kNodes; ++i) {
      const double next = 2.0 * x[i] * now[i] - before[i];
      before[i] = now[i];
      now[i] = next;
    }
  }
}

/// The pieces of e between two breakpoints: their ends, and e over the share of the piece.
template <class Visit>
void visit_pieces(std::span<const JointPath::Breakpoint> breakpoints, const StepCubic& force,
                  const Visit& visit) {
  double share = 0.0;
  double e = 0.0;
  double slope = 0.0;  // over the share
  for (const JointPath::Breakpoint& breakpoint : breakpoints) {
    const double e_there = breakpoint.force - force.value(breakpoint.share);
    const double slope_there = force.slope(breakpoint.share);
    visit(share, breakpoint.share,
          StepCubic(e, slope, e_there, breakpoint.before - slope_there, breakpoint.share - share));
    share = breakpoint.share;
    e = e_there;
    slope = breakpoint.after - slope_there;
  }
  visit(share, 1.0, StepCubic(e, slope, 0.0, 0.0, 1.0 - share));
}

}  // namespace

BreakpointMoments breakpoint_moments(std::span<const JointPath::Breakpoint> breakpoints,
                                     const StepCubic& force, std::size_t terms) {
  BreakpointMoments moments{};
  visit_pieces(breakpoints, force, [&](double left, double right, const StepCubic& e) {
    add_piece(left, right, e, terms, moments.data());
  });
  return moments;
}

void integrate_breakpoints(std::span<const JointPath::Breakpoint> breakpoints,
                           const StepCubic& force, std::span<const double> shares,
                           double* integrals) {
  double before = 0.0;  // of the pieces that are passed
  std::size_t next = 0;
  visit_pieces(breakpoints, force, [&](double left, double right, const StepCubic& e) {
    const double length = right - left;
    for (; next < shares.size() && shares[next] <= right; ++next) {
      integrals[next] = before + length * e.integral((shares[next] - left) / length);
    }
    before += length * e.integral(1.0);
  });
}

BreakpointWeights::BreakpointWeights(std::span<const double> stiffness,
                                     std::span<const double> damping)
    : stiffness_(stiffness.begin(), stiffness.end()),
      damping_(damping.begin(), damping.end()),
      weights_(stiffness.size() * kBreakpointTerms * kKinds, 0.0) {
  for (const double s : stiffness) longest_ = std::min(longest_, kLargestAngle / std::sqrt(s));
  for (const double d : damping) longest_ = std::min(longest_, kLargestAngle / d);
}

void BreakpointWeights::set_length(double length) {
  if (length == length_) return;
  length_ = length;
  terms_ = terms_needed(kLargestAngle * length / longest_);
  static const ChebyshevTable table = chebyshev_table();
  for (std::size_t i = 0; i < stiffness_.size(); ++i) {
    std::array<double, kBreakpointTerms> impulse;
    std::array<double, kBreakpointTerms> slope;
    for (std::size_t k = 0; k < kBreakpointTerms; ++k) {
      const double share = 0.5 * (1.0 + table.x[k]);
      const double t = share * length;
      const auto [g, g_dot] = impulse_response(0.5 * damping_[i] * t, stiffness_[i] * t * t);
      impulse[k] = length * t * g;
      slope[k] = length * g_dot;
    }
    const std::size_t group = i / kLanes;
    for (std::size_t m = 0; m < kBreakpointTerms; ++m) {
      double of_impulse = 0.0;
      double of_slope = 0.0;
      for (std::size_t k = 0; k < kBreakpointTerms; ++k) {
        of_impulse += table.polynomial[m][k] * impulse[k];
        of_slope += table.polynomial[m][k] * slope[k];
      }
      const double scale = (m == 0 ? 1.0 : 2.0) / static_cast<double>(kBreakpointTerms);
      double* at =
          weights_.data() + ((group * kBreakpointTerms + m) * kKinds) * kLanes + i % kLanes;
      at[kOfDisplacement * kLanes] = scale * of_impulse;
      at[kOfVelocity * kLanes] = scale * of_slope;
    }
  }
}

}  // namespace microslip
