// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/joint/normal_load_scale.hpp"

namespace microslip {
namespace {

/// A kind of number has streams of its own, so that a draw of one does not depend on which others
/// are uncertain. Those of identifications are small numbers.
enum class DrawnKind : std::uint64_t {
  kFrequency = 1,
  kLossFactor,
  kNormalLoad,
  kForceGain,
  kResponseGain,
  kOrder,
  kTurn,
};

RandomStream stream_of(std::uint64_t seed, DrawnKind kind, std::uint64_t number) {
  constexpr unsigned kKindBits = 48;
  return {seed, (static_cast<std::uint64_t>(kind) << kKindBits) + number};
}

/// e^{σz} for the next z, which is used up also where σ is 0.
double factor(RandomStream& random, const std::vector<double>& spread, std::size_t at) {
  const double z = random.normal();
  return spread.empty() || spread[at] == 0.0 ? 1.0 : std::exp(spread[at] * z);
}

void check_spread(std::string_view name, const std::vector<double>& spread, std::size_t count,
                  std::string_view of) {
  if (!spread.empty() && spread.size() != count) {
    throw InputError(fmt::format("number of values of {}", name),
                     static_cast<double>(spread.size()),
                     fmt::format("must be {}, one {}, or 0", count, of));
  }
  for (const double value : spread) {
    if (value >= 0.0 && value <= StructureDraws::kLargestSpread) continue;
    throw InputError(name, value,
                     fmt::format("must be from 0 to {:g}", StructureDraws::kLargestSpread));
  }
}

void check_joints(const std::vector<JointDraws>& joints, std::size_t count, JointPairing pairing) {
  if (!joints.empty() && joints.size() != count) {
    throw InputError("number of draws of joints", static_cast<double>(joints.size()),
                     fmt::format("must be {}, one a joint, or 0", count));
  }
  std::size_t first = 0;
  for (const JointDraws& draws : joints) {
    if (draws.count == 0) continue;
    if (first == 0) first = draws.count;
    if (pairing == JointPairing::kIndependent || draws.count == first) continue;
    throw InputError(
        "draws of a joint", static_cast<double>(draws.count),
        fmt::format("must be as many as of the others, {}, to belong together", first));
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

bool any_above_zero(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value > 0.0; });
}

}  // namespace

bool StructureSpread::any() const {
  return any_above_zero(frequency) || any_above_zero(loss_factor) || any_above_zero(normal_load) ||
         any_above_zero(force_gain) || response_gain > 0.0;
}

StructureDraws::StructureDraws(JointedStructure nominal, StructureSpread spread,
                               std::vector<JointDraws> joints, JointPairing pairing,
                               std::uint64_t seed)
    : nominal_(std::move(nominal)),
      spread_(std::move(spread)),
      joints_(std::move(joints)),
      pairing_(pairing),
      seed_(seed) {
  const std::size_t modes = nominal_.linear().size();
  check_spread("spread of a frequency", spread_.frequency, modes, "a mode");
  check_spread("spread of a loss factor", spread_.loss_factor, modes, "a mode");
  check_spread("spread of a normal load", spread_.normal_load, nominal_.joints().size(), "a joint");
  check_spread("spread of a force gain", spread_.force_gain, nominal_.excitations().size(),
               "an excitation");
  check_spread("spread of the response gain", {spread_.response_gain}, 1, "a response");
  check_joints(joints_, nominal_.joints().size(), pairing_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const std::size_t own = pairing_ == JointPairing::kTogether ? 0 : j;
    order_.push_back(random_order(joints_[j].count, stream_of(seed_, DrawnKind::kOrder, own)));
  }
}

bool StructureDraws::any() const {
  return spread_.any() ||
         std::ranges::any_of(joints_, [](const JointDraws& draws) { return draws.count > 0; });
}

StructureDraw StructureDraws::draw(std::uint64_t i) const {
  StructureDraw drawn{
      JointedStructure(drawn_modes(i), drawn_joints(i), drawn_excitations(i), nominal_.damping())};
  RandomStream random = stream_of(seed_, DrawnKind::kResponseGain, i);
  drawn.response_gain = factor(random, {spread_.response_gain}, 0);
  return drawn;
}

ModalModel StructureDraws::drawn_modes(std::uint64_t i) const {
  RandomStream frequency = stream_of(seed_, DrawnKind::kFrequency, i);
  RandomStream loss_factor = stream_of(seed_, DrawnKind::kLossFactor, i);
  std::vector<Mode> modes(nominal_.linear().modes().begin(), nominal_.linear().modes().end());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].angular_frequency *= factor(frequency, spread_.frequency, m);
    modes[m].loss_factor *= factor(loss_factor, spread_.loss_factor, m);
  }
  return ModalModel(std::move(modes),
                    {nominal_.linear().points().begin(), nominal_.linear().points().end()});
}

/// Each pass over the draws begins at another place of the order: joints that are independent meet
/// in other pairs.
std::size_t StructureDraws::number_of_draw(std::size_t joint, std::uint64_t i) const {
  constexpr unsigned kJointBits = 32;
  const std::size_t count = joints_[joint].count;
  const std::uint64_t pass = i / count;
  std::uint64_t at = i % count;
  if (pass > 0) {
    const std::uint64_t own = pairing_ == JointPairing::kTogether ? 0 : joint;
    RandomStream random = stream_of(seed_, DrawnKind::kTurn, (own << kJointBits) + pass);
    at += static_cast<std::uint64_t>(random.uniform() * static_cast<double>(count));
  }
  return order_[joint][at % count];
}

std::vector<StructuralJoint> StructureDraws::drawn_joints(std::uint64_t i) const {
  RandomStream normal_load = stream_of(seed_, DrawnKind::kNormalLoad, i);
  std::vector<StructuralJoint> joints(nominal_.joints().begin(), nominal_.joints().end());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (j < joints_.size() && joints_[j].count > 0) {
      DrawnJoint drawn = joints_[j].at(number_of_draw(j, i));
      joints[j].joint = std::move(drawn.joint);
      if (drawn.linear_damping) joints[j].linear_damping = *drawn.linear_damping;
    }
    const double scale = factor(normal_load, spread_.normal_load, j);
    joints[j].joint = with_normal_load(joints[j].joint, scale);
  }
  return joints;
}

std::vector<Excitation> StructureDraws::drawn_excitations(std::uint64_t i) const {
  RandomStream random = stream_of(seed_, DrawnKind::kForceGain, i);
  std::vector<Excitation> excitations(nominal_.excitations().begin(), nominal_.excitations().end());
  for (std::size_t d = 0; d < excitations.size(); ++d) {
    const double gain = factor(random, spread_.force_gain, d);
    for (std::complex<double>& harmonic : excitations[d].harmonics) harmonic /= gain;
  }
  return excitations;
}

}  // namespace microslip
