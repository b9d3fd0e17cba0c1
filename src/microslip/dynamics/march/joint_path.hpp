// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "microslip/dynamics/march/step_cubic.hpp"
#include "microslip/dynamics/march/virgin_curve_cursor.hpp"

namespace microslip {

/// The way of a joint over one step of a march, by the quartic of y = u + cF over it: where on it
/// the joint turns and where its tangent jumps, and what its force is there. Internal to dynamics.
///
/// With these knots the force over a step is a piecewise cubic, so that the step need not be cut.
class JointWay {
 public:
  struct Knot {
    double share;         ///< of the step
    double displacement;  ///< u, m
    double force;         ///< F, N
    double before;        ///< dF over the share, N; from the left
    double after;         ///< from the right
    bool turns;           ///< or else its tangent jumps
  };

  /// The way begins without knots.
  explicit JointWay(const Joint& joint) : follower_(joint) {}

  struct Start {
    const CurveFollower& follower;  ///< at the beginning of the step
    int direction;                  ///< of the motion there; 0 where it has not begun
    double force;                   ///< F, N
    double kink;                    ///< y of the next kink, m
    double compliance;              ///< c, m/N
    double quiet;                   ///< changes of y below this are rounding, m
  };
  /// Follows y over the step.
  /// @return false where it starts against its direction, or there are too many knots: that is left
  ///         to shorter steps.
  [[nodiscard]] bool follow(const Start& start, const StepQuartic& y);
  /// The next way has nothing to do with this one.
  void forget() { size_ = before_ = 0; }

  [[nodiscard]] std::span<const Knot> knots() const { return {knots_.data(), size_}; }
  /// On the curve behind the last knot, where there is one.
  [[nodiscard]] const CurveFollower& follower() const { return follower_; }
  /// The same for one that goes on from there; until the next way there is none here.
  [[nodiscard]] CurveFollower& follower() { return follower_; }

 private:
  [[nodiscard]] double first_turn() const;
  [[nodiscard]] bool pass_kinks(const StepQuartic& y, double from, double to);
  [[nodiscard]] bool turn(const StepQuartic& y, double share, double force);
  [[nodiscard]] bool add(const Knot& knot);

  static constexpr std::size_t kMostKnots = 6;

  CurveFollower follower_;
  int direction_ = 0;
  double compliance_ = 0.0;
  std::array<Knot, kMostKnots> knots_{};
  std::size_t size_ = 0;
  std::size_t before_ = 0;  ///< knots of the way before, from which new ones are looked for
};

}  // namespace microslip
