// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "microslip/dynamics/structure/density_corners.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip {

/// dF/dy of a joint of the tangent K = dF/du and what is in series with it, y = u + cF, N/m.
[[nodiscard]] inline double in_series(double tangent, double compliance) {
  return tangent / (1.0 + tangent * compliance);
}

/// A Memory that moves from kink to kink. Internal to dynamics.
///
/// Between two kinks it moves on one smooth curve. A step is tried on that curve as if it had no
/// end: with the kink inside of the step the tangent would jump there, and the equations of the
/// step may have no solution at all. Where the kink lies is found afterwards.
class CurveFollower {
 public:
  /// @param joint  kept by reference.
  explicit CurveFollower(const Joint& joint);

  struct Response {
    double force;    ///< F, N
    double tangent;  ///< dF/du, N/m
  };

  /// At u on the present curve; before the first motion, after a move to there.
  [[nodiscard]] Response response(double u) const { return piece_ ? on_piece(u) : on_memory(u); }
  /// Moves there. @return F, N.
  double advance(double u) { return memory_.advance(u); }
  /// Moves there, where its force is known, N.
  void settle(double u, double force) { memory_.settle(u, force); }
  /// Reverses the motion here, or begins it: from here on it goes in this direction, +1 or −1.
  void turn(int direction) { follow(direction, memory_.displacement()); }

  /// u where the tangent jumps next, or its slope, m: a loop closes, an atom begins to slip, the
  /// density jumps. ±infinite where there is none.
  [[nodiscard]] double next_kink() const { return kink_; }
  /// y = u + cF of the next kink, m; infinite as it is. @param compliance  c, m/N.
  [[nodiscard]] double next_kink_behind(double compliance) const {
    if (compliance == 0.0 || !std::isfinite(kink_)) return kink_;
    return kink_ + compliance * on_piece(kink_).force;
  }
  /// Goes over to the curve behind the next kink.
  void pass_kink();

  /// dF/du on the present curve, where the joint stands, N/m; 0 before the first motion.
  [[nodiscard]] double tangent() const {
    return piece_ ? on_piece(memory_.displacement()).tangent : 0.0;
  }
  [[nodiscard]] const Memory& memory() const { return memory_; }

 private:
  /// The smooth part of a Memory between two kinks.
  struct Piece {
    Memory::Curve curve;
    std::size_t passed;    ///< corners that lie behind
    std::size_t slipping;  ///< atoms that slip on it
  };

  void follow(int direction, double from);
  void pass_corner();
  void find_kink();
  [[nodiscard]] double elastic_force(double u) const;
  [[nodiscard]] Response on_piece(double u) const;
  [[nodiscard]] Response on_memory(double u) const;

  const Joint* joint_;
  Memory memory_;
  std::vector<Corner> corners_;
  std::optional<Piece> piece_;  ///< none before the first motion
  double kink_ = std::numeric_limits<double>::infinity();
};

}  // namespace microslip
