// SPDX-License-Identifier: MIT
#include "microslip/calibrate/calibration_draws.hpp"

#include <algorithm>
#include <utility>

#include "microslip/calibrate/evidence_chain.hpp"

namespace microslip {
namespace {

/// Draws of the prior: as many as its variance needs.
constexpr std::size_t kPriorDraws = 400;

/// Slip displacements of the edges of a joint in any of the states, m.
std::vector<double> all_edges(const std::vector<WeighedState>& states, std::size_t joint) {
  std::vector<double> all;
  for (const WeighedState& one : states) {
    const std::vector<double> own = one.state.unknowns.of(joint).edges();
    all.insert(all.end(), own.begin(), own.end());
  }
  std::ranges::sort(all);
  return all;
}

/// Coefficients that can represent all states: for each joint those of a state that continues as a
/// power law, whose knots are the finest, and the edges of all.
AllUnknowns common_unknowns(const std::vector<WeighedState>& states) {
  const AllUnknowns& first = states.front().state.unknowns;
  if (states.size() == 1) return first;
  std::vector<std::size_t> which;
  std::vector<JointUnknowns> joints;
  for (std::size_t j = 0; j < first.count(); ++j) {
    const auto is_power_law = [j](const WeighedState& one) {
      return one.state.unknowns.of(j).exponent() != 0.0;
    };
    const auto finest = std::ranges::find_if(states, is_power_law);
    which.push_back(first.index(j));
    joints.push_back((finest == states.end() ? first : finest->state.unknowns)
                         .of(j)
                         .by_knots(all_edges(states, j)));
  }
  return {std::move(which), std::move(joints), first.modes()};
}

Eigen::VectorXd in_terms_of(const AllUnknowns& common, const AllUnknowns& own,
                            const Eigen::VectorXd& x) {
  Eigen::VectorXd found(common.size());
  for (std::size_t j = 0; j < common.count(); ++j) {
    found.segment(common.begin(j), common.of(j).size()) =
        common.of(j).projected(own.of(j), own.part(j, x));
  }
  found.tail(common.mode_count()) = x.tail(common.mode_count());
  return found;
}

/// Draws of several states, dealt so that each share of all has each of them by its weight.
class DealtDraws {
 public:
  /// @param share  of the draws of a state that come before this one.
  void add(double share, Eigen::VectorXd x) { all_.emplace_back(share, std::move(x)); }

  [[nodiscard]] std::vector<Eigen::VectorXd> taken() {
    std::ranges::stable_sort(all_, {}, &std::pair<double, Eigen::VectorXd>::first);
    std::vector<Eigen::VectorXd> draws;
    for (auto& [share, x] : all_) draws.push_back(std::move(x));
    return draws;
  }

 private:
  std::vector<std::pair<double, Eigen::VectorXd>> all_;
};

}  // namespace

Eigen::VectorXd CalibrationDraws::mean() const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(posterior.front().size());
  for (const Eigen::VectorXd& x : posterior) sum += x;
  return sum / static_cast<double>(posterior.size());
}

CalibrationDraws draw_all(const std::vector<WeighedState>& states,
                          const std::array<double, kRowKinds.size()>& least, std::size_t count,
                          std::uint64_t seed) {
  CalibrationDraws draws{.unknowns = common_unknowns(states)};
  std::size_t weights = 0;
  for (const WeighedState& one : states) weights += one.weight;
  DealtDraws posterior;
  DealtDraws prior;
  std::size_t before = 0;
  for (std::size_t chain = 0; chain < states.size(); ++chain) {
    const auto& [state, weight] = states[chain];
    const NormalEquations equations(state.evidence);
    const auto length = [&](std::size_t all) {
      return ChainLength{all * (before + weight) / weights - all * before / weights, seed, chain};
    };
    const auto keep_in = [&](DealtDraws& dealt, std::size_t of) {
      return [&, of, i = 0.0](const Eigen::VectorXd& x) mutable {
        const bool same = states.size() == 1;
        dealt.add((i + 0.5) / static_cast<double>(of),
                  same ? x : in_terms_of(draws.unknowns, state.unknowns, x));
        i += 1.0;
      };
    };
    draw_evidence(equations, state.settled, least, length(count),
                  keep_in(posterior, length(count).draws));
    draw_prior(equations, state.settled, length(kPriorDraws),
               keep_in(prior, length(kPriorDraws).draws));
    before += weight;
  }
  draws.posterior = posterior.taken();
  draws.prior = prior.taken();
  return draws;
}

}  // namespace microslip
