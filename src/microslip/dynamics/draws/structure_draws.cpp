// SPDX-License-Identifier: MIT
#include "microslip/dynamics/draws/structure_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/dynamics/draws/draw_streams.hpp"

namespace microslip {
namespace {

bool any_above_zero(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value > 0.0; });
}

/// None are replaced by as many without uncertainty.
std::vector<JointDraws> one_a_joint(std::vector<JointDraws> joints, std::size_t count) {
  if (joints.empty()) joints.resize(count);
  if (joints.size() == count) return joints;
  throw InputError("number of draws of joints", static_cast<double>(joints.size()),
                   fmt::format("must be {}, one per joint, or 0", count));
}

/// The excitations for given readings: divided by their gains.
std::vector<Excitation> over_gains(std::span<const Excitation> read,
                                   const std::vector<double>& gains) {
  std::vector<Excitation> excitations(read.begin(), read.end());
  for (std::size_t d = 0; d < excitations.size(); ++d) {
    for (std::complex<double>& harmonic : excitations[d].harmonics) harmonic /= gains[d];
  }
  return excitations;
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
      joints_(one_a_joint(std::move(joints), nominal_.joints().size()), spread_.normal_load,
              pairing, seed),
      seed_(seed) {
  const std::size_t modes = nominal_.linear().size();
  check_spread("spread of a frequency", spread_.frequency, modes, "mode");
  check_spread("spread of a loss factor", spread_.loss_factor, modes, "mode");
  check_spread("spread of a force gain", spread_.force_gain, nominal_.excitations().size(),
               "excitation");
  check_spread("spread of the response gain", {spread_.response_gain}, 1, "response");
}

bool StructureDraws::any() const { return spread_.any() || joints_.any(); }

StructureDraw StructureDraws::draw(std::uint64_t i) const {
  std::vector<double> gains = drawn_gains(i);
  StructureDraw drawn{JointedStructure(
      drawn_modes(i), drawn_joints(i), over_gains(nominal_.excitations(), gains),
      nominal_.damping(), {nominal_.static_loads().begin(), nominal_.static_loads().end()})};
  RandomStream random = draw_stream(seed_, DrawnKind::kResponseGain, i);
  drawn.response_gain = drawn_factor(random, {spread_.response_gain}, 0);
  drawn.force_gain = std::move(gains);
  return drawn;
}

ModalModel StructureDraws::drawn_modes(std::uint64_t i) const {
  RandomStream frequency = draw_stream(seed_, DrawnKind::kFrequency, i);
  RandomStream loss_factor = draw_stream(seed_, DrawnKind::kLossFactor, i);
  std::vector<Mode> modes(nominal_.linear().modes().begin(), nominal_.linear().modes().end());
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].angular_frequency *= drawn_factor(frequency, spread_.frequency, m);
    modes[m].loss_factor *= drawn_factor(loss_factor, spread_.loss_factor, m);
  }
  return nominal_.linear().with_modes(std::move(modes));
}

std::vector<StructuralJoint> StructureDraws::drawn_joints(std::uint64_t i) const {
  std::vector<StructuralJoint> joints(nominal_.joints().begin(), nominal_.joints().end());
  std::vector<Joint> nominal;
  for (const StructuralJoint& joint : joints) nominal.push_back(joint.joint);
  std::vector<DrawnJoint> drawn = joints_.draw(nominal, i);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    joints[j].joint = std::move(drawn[j].joint);
    if (drawn[j].linear_damping) joints[j].linear_damping = *drawn[j].linear_damping;
  }
  return joints;
}

std::vector<double> StructureDraws::drawn_gains(std::uint64_t i) const {
  RandomStream random = draw_stream(seed_, DrawnKind::kForceGain, i);
  std::vector<double> gains;
  for (std::size_t d = 0; d < nominal_.excitations().size(); ++d) {
    gains.push_back(drawn_factor(random, spread_.force_gain, d));
  }
  return gains;
}

}  // namespace microslip
