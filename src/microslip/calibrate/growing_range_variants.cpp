// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "microslip/calibrate/growing_range.hpp"

namespace microslip {
namespace {

/// χ₀ that draws have.
constexpr std::array kDrawnExponents = {0.0, -0.125, -0.25, -0.375, -0.5, -0.625, -0.75};
/// Chains of draws with exponents of their own: one of this share of probability has one at least.
/// A power of 2, so that each odd number goes through all of them.
constexpr std::size_t kExponentChains = 16;

/// Empty ranges of one of the chains, each as often as it is likely, those of two in another order.
std::vector<bool> emptied(const FoundEdges& edges, std::size_t chain) {
  std::vector<bool> empty = edges.empty;
  for (std::size_t range = 0; range < empty.size(); ++range) {
    const std::size_t place = chain * (2 * range + 1) % kExponentChains;
    const double share = (static_cast<double>(place) + 0.5) / static_cast<double>(kExponentChains);
    empty[range] = share < edges.emptiness[range];
  }
  const bool all = !empty.empty() && std::ranges::find(empty, false) == empty.end();
  return all ? edges.empty : empty;
}

}  // namespace

/// About the joints that were found, as they explain the levels with any exponent: λ and τ are
/// near.
CalibratedState GrowingRange::beside(const CalibratedState& found, const Variant& variant) {
  AllUnknowns now = unknowns(variant);
  Eigen::VectorXd x = now.projected(found.unknowns, found.settled.x);
  CalibratedState state = linear_about(found.levels, std::move(now), std::move(x));
  state.settled = settle(NormalEquations(state.evidence), found.settled.weights, bounds());
  if (tick_) tick_();
  return state;
}

/// Exponents of one joint, each as many times of kExponentChains as it is likely: the one found
/// alone where no other explains as many levels.
std::vector<double> GrowingRange::likely_exponents(std::size_t joint, const CalibratedState& found,
                                                   VariantStates& states) {
  std::vector<double> fall;
  for (const double exponent : kDrawnExponents) {
    Variant variant = found_with(exponents_);
    variant.exponents[joint] = exponent;
    const CalibratedState& state = state_with(variant, found, states).state;
    fall.push_back(state.found < found.found ? HUGE_VAL
                                             : state.settled.likelihood - found.settled.likelihood);
  }
  const double least = std::ranges::min(fall);
  if (!std::isfinite(least)) return std::vector<double>(kExponentChains, exponents_[joint]);
  std::vector<double> likelihood;
  for (const double each : fall) likelihood.push_back(std::exp(-0.5 * (each - least)));
  const double sum = std::accumulate(likelihood.begin(), likelihood.end(), 0.0);
  std::vector<double> likely;
  double below = 0.0;
  for (std::size_t i = 0; i < likelihood.size(); ++i) {
    below += likelihood[i] / sum * static_cast<double>(kExponentChains);
    while (static_cast<double>(likely.size()) + 0.5 < below) likely.push_back(kDrawnExponents[i]);
  }
  return likely;
}

WeighedState& GrowingRange::state_with(const Variant& variant, const CalibratedState& found,
                                       VariantStates& states) {
  auto known = states.find(variant);
  if (known == states.end()) {
    known = states.emplace(variant, WeighedState{beside(found, variant)}).first;
  }
  return known->second;
}

std::vector<WeighedState> GrowingRange::with_others(const CalibratedState& found) {
  keep_weights_ = false;
  VariantStates states;
  states.emplace(found_with(exponents_), WeighedState{found});
  std::vector<std::vector<double>> likely;
  for (std::size_t j = 0; j < sought_.size(); ++j) {
    likely.push_back(likely_exponents(j, found, states));
  }
  for (std::size_t chain = 0; chain < kExponentChains; ++chain) {
    Variant variant;
    for (std::size_t j = 0; j < sought_.size(); ++j) {
      const std::size_t turn = chain * (2 * j + 1) % kExponentChains;
      variant.exponents.push_back(likely[j][turn]);
      variant.empty.push_back(emptied(edges_[j], turn));
      const std::size_t others = edges_[j].elsewhere.size();
      const std::size_t place = (chain * (2 * j + 1) + j) % (others + 1);
      variant.places.push_back(place == others ? kFound : place);
    }
    ++state_with(variant, found, states).weight;
  }
  std::vector<WeighedState> drawn;
  for (auto& [variant, state] : states) {
    if (state.weight > 0) drawn.push_back(std::move(state));
  }
  (void)linear_about(found.levels, found.unknowns, found.about);  // others have moved the levels
  return drawn;
}

}  // namespace microslip
