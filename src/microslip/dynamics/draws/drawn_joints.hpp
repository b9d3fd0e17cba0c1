// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "microslip/joint/joint.hpp"

namespace microslip {

/// A joint as it may be.
struct DrawnJoint {
  Joint joint;                                ///< the draw
  std::optional<double> linear_damping = {};  ///< β, J/m²; none: as without draws
};

/// Draws of one joint.
struct JointDraws {
  std::size_t count = 0;  ///< how many there are; 0: the joint is certain
  /// Draw i < count; called by several threads at once.
  std::function<DrawnJoint(std::size_t i)> at = {};
};

// g++ 12 warns that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Pairing of the draws of several joints.
enum class JointPairing {
  kIndependent,  ///< drawn independently
  kTogether,     ///< draws of the same number belong together, as one calibration drew them
};

#pragma GCC diagnostic pop

/// Posterior draws of joints: draw i of seed s, the same in a structure and alone, whatever the
/// order and the number of draws, the machine, its threads and ranks. Immutable.
///
/// Draws of a joint are taken without repetition, in an order that the seed makes, from first to
/// last, then again in another: N draws out of M ≥ N are N different ones. Then comes the normal
/// load, e^{σz} times the nominal one, z standard normal: with_normal_load().
class DrawnJoints {
 public:
  /// @param draws        of each joint.
  /// @param normal_load  σ of each joint, 1; or none.
  /// @param pairing      of those that have draws.
  /// @param seed         s.
  /// @throws InputError  for σ below 0 or above kLargestSpread; for another number of σ than of
  ///                     joints; for draws that belong together and are not as many.
  DrawnJoints(std::vector<JointDraws> draws, std::vector<double> normal_load, JointPairing pairing,
              std::uint64_t seed);

  /// Beyond it a number is not known at all: e^{±1.96 · 1} is a factor 50 from end to end.
  static constexpr double kLargestSpread = 1.0;

  /// Draw i.
  /// @param nominal  the joints, of which those without draws are kept; as many as above.
  /// @param i        its number.
  [[nodiscard]] std::vector<DrawnJoint> draw(std::span<const Joint> nominal, std::uint64_t i) const;

  /// Whether draws differ.
  [[nodiscard]] bool any() const;

 private:
  [[nodiscard]] std::size_t number_of_draw(std::size_t joint, std::uint64_t i) const;

  std::vector<JointDraws> draws_;
  std::vector<double> normal_load_;
  JointPairing pairing_;
  std::uint64_t seed_;
  std::vector<std::vector<std::size_t>> order_;  ///< of the draws of each joint
};

}  // namespace microslip
