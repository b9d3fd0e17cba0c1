// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "microslip/dynamics/march/step_cubic.hpp"
#include "microslip/dynamics/march/virgin_curve_cursor.hpp"

namespace microslip {

/// The path of a joint over one step of a march, by the quartic of y = u + cF over it: the places
/// where the joint turns and where its tangent jumps, with its force there. Internal to dynamics.
///
/// With these breakpoints the force over a step is a piecewise cubic, so that the step need not be
/// cut.
class JointPath {
 public:
  struct Breakpoint {
    double share;         ///< of the step
    double displacement;  ///< u, m
    double force;         ///< F, N
    double before;        ///< dF over the share, N; from the left
    double after;         ///< from the right
    bool turns;           ///< or else its tangent jumps
  };

  /// The path begins without breakpoints.
  explicit JointPath(const Joint& joint) : follower_(joint) {}

  struct Start {
    const CurveFollower& follower;  ///< at the beginning of the step
    int direction;                  ///< of the motion there; 0 where it has not begun
    double force;                   ///< F, N
    double kink;                    ///< y of the next kink, m
    double compliance;              ///< c, m/N
    double quiet;                   ///< changes of y below this are rounding, m
  };
  /// Follows y over the step.
  /// @return false where it starts against its direction, or there are too many breakpoints:
  ///         shorter steps are then needed.
  [[nodiscard]] bool follow(const Start& start, const StepQuartic& y);
  /// Forgets the path: the next one is unrelated.
  void forget() { size_ = before_ = 0; }

  [[nodiscard]] std::span<const Breakpoint> breakpoints() const {
    return {breakpoints_.data(), size_};
  }
  /// The follower on the curve behind the last of the breakpoints, if any.
  [[nodiscard]] const CurveFollower& follower() const { return follower_; }
  /// The follower, to be taken over by one that continues from there; until the next path there is
  /// none here.
  [[nodiscard]] CurveFollower& follower() { return follower_; }

 private:
  [[nodiscard]] double first_turn() const;
  [[nodiscard]] bool pass_kinks(const StepQuartic& y, double from, double to);
  [[nodiscard]] bool turn(const StepQuartic& y, double share, double force);
  [[nodiscard]] bool add(const Breakpoint& breakpoint);

  static constexpr std::size_t kMostBreakpoints = 6;

  CurveFollower follower_;
  int direction_ = 0;
  double compliance_ = 0.0;
  std::array<Breakpoint, kMostBreakpoints> breakpoints_{};
  std::size_t size_ = 0;
  std::size_t before_ = 0;  ///< breakpoints of the previous path, to start the search of new ones
};

}  // namespace microslip
