// SPDX-License-Identifier: MIT
#include "microslip/dynamics/draws/drawn_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/draws/draw_streams.hpp"
#include "microslip/joint/normal_load_scale.hpp"

namespace microslip {
namespace {

void check_joints(const std::vector<JointDraws>& joints, JointPairing pairing) {
  std::size_t first = 0;
  for (const JointDraws& draws : joints) {
    if (draws.count == 0) continue;
    if (first == 0) first = draws.count;
    if (pairing == JointPairing::kIndependent || draws.count == first) continue;
    throw InputError("draws of a joint", static_cast<double>(draws.count),
                     fmt::format("must be as many as of the others, {}, to be paired", first));
  }
}

/// 0 … count − 1 in a random order, all as likely.
std::vector<std::size_t> random_order(std::size_t count, RandomStream random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = count; left > 1; --left) {
    const auto taken = static_cast<std::size_t>(random.uniform() * static_cast<double>(left));
    std::swap(order[left - 1], order[std::min(taken, left - 1)]);
  }
  return order;
}

}  // namespace

void check_spread(std::string_view name, const std::vector<double>& spread, std::size_t count,
                  std::string_view of) {
  if (!spread.empty() && spread.size() != count) {
    throw InputError(fmt::format("number of values of {}", name),
                     static_cast<double>(spread.size()),
                     fmt::format("must be {}, one per {}, or 0", count, of));
  }
  for (const double value : spread) {
    if (value >= 0.0 && value <= DrawnJoints::kLargestSpread) continue;
    throw InputError(name, value,
                     fmt::format("must be from 0 to {:g}", DrawnJoints::kLargestSpread));
  }
}

DrawnJoints::DrawnJoints(std::vector<JointDraws> draws, std::vector<double> normal_load,
                         JointPairing pairing, std::uint64_t seed)
    : draws_(std::move(draws)),
      normal_load_(std::move(normal_load)),
      pairing_(pairing),
      seed_(seed) {
  check_spread("spread of a normal load", normal_load_, draws_.size(), "joint");
  check_joints(draws_, pairing_);
  for (std::size_t j = 0; j < draws_.size(); ++j) {
    const std::size_t own = pairing_ == JointPairing::kTogether ? 0 : j;
    order_.push_back(random_order(draws_[j].count, draw_stream(seed_, DrawnKind::kOrder, own)));
  }
}

bool DrawnJoints::any() const {
  return std::ranges::any_of(normal_load_, [](double value) { return value > 0.0; }) ||
         std::ranges::any_of(draws_, [](const JointDraws& draws) { return draws.count > 0; });
}

std::vector<DrawnJoint> DrawnJoints::draw(std::span<const Joint> nominal, std::uint64_t i) const {
  RandomStream normal_load = draw_stream(seed_, DrawnKind::kNormalLoad, i);
  std::vector<DrawnJoint> joints;
  for (std::size_t j = 0; j < nominal.size(); ++j) {
    const bool drawn = draws_[j].count > 0;
    joints.push_back(drawn ? draws_[j].at(number_of_draw(j, i)) : DrawnJoint{nominal[j]});
    joints[j].joint = with_normal_load(joints[j].joint, drawn_factor(normal_load, normal_load_, j));
  }
  return joints;
}

/// Each pass over the draws begins at another place of the order: joints that are independent meet
/// in other pairs.
std::size_t DrawnJoints::number_of_draw(std::size_t joint, std::uint64_t i) const {
  constexpr unsigned kJointBits = 32;
  const std::size_t count = draws_[joint].count;
  const std::uint64_t pass = i / count;
  std::uint64_t at = i % count;
  if (pass > 0) {
    const std::uint64_t own = pairing_ == JointPairing::kTogether ? 0 : joint;
    RandomStream random = draw_stream(seed_, DrawnKind::kTurn, (own << kJointBits) + pass);
    at += static_cast<std::uint64_t>(random.uniform() * static_cast<double>(count));
  }
  return order_[joint][at % count];
}

}  // namespace microslip
