// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/joint/joint.hpp"

namespace microslip {

/// The memory of a joint under constant normal load of its displacement history, exact (Madelung's
/// rules, which Masing's rule makes explicit; the same as a play-operator Prandtl–Ishlinskii
/// model):
///
///   * first loading follows the virgin curve F;
///   * after a reversal at (x_r, f_r):  f = f_r ± 2F(|x − x_r|/2)                     [AR14 (3)]
///   * where the path passes the previous extreme of the loop it is on, that minor loop is closed
///     and erased from the memory, and the path continues on the curve it was on before;
///   * where |x| exceeds the largest |x| ever reached, the virgin curve continues.
///
/// The state is a stack of reversal points: O(1) amortised per step, whatever the number of
/// sliders.
///
/// A step is a straight move of x from the present displacement. trial() evaluates a step without
/// taking it, so an implicit integrator tries as many as it likes and then takes one by advance().
/// A Memory is a value: a copy is a snapshot of several steps to return to. Displacements within
/// reach are those that are not beyond kFarthestDisplacement (path.hpp).
class Memory {
 public:
  /// A reversal of the path.
  struct ReversalPoint {
    double displacement;  ///< x_r, m
    double force;         ///< f_r, N
  };

  /// Force and tangent after a step.
  struct Response {
    double force;    ///< f, N
    double tangent;  ///< df/dx in the direction of the move, N/m
  };

  /// A smooth piece of the hysteresis, f = force + scale·F(k·reach·(x − displacement)·sign), as
  /// long as sign·x grows and stays below `end`.
  struct Curve {
    double displacement;  ///< m; where it begins
    double force;         ///< N; there
    double sign;          ///< +1 loading, −1 unloading
    double scale;         ///< ±1 on the virgin curve, ±2 after a reversal
    double reach;         ///< 1 on the virgin curve, ½ after a reversal
    double end;           ///< sign·x where it joins an older curve; infinite on the virgin curve
  };

  /// Virgin, at rest at x = 0. @param joint  kept by reference; must outlive the Memory.
  explicit Memory(const Joint& joint) : joint_(&joint) {}
  explicit Memory(const Joint&&) = delete;

  /// The present displacement x, m.
  [[nodiscard]] double displacement() const { return x_; }
  /// The present force f, N.
  [[nodiscard]] double force() const { return force_; }

  /// The reversals that still matter, oldest first; empty on the virgin curve.
  [[nodiscard]] std::span<const ReversalPoint> reversals() const { return reversals_; }

  /// Force and tangent stiffness after a step to x, which is not taken. Where x is the present
  /// displacement: the present force and the tangent of going on. @param x  m, within reach.
  /// @throws InputError  where x is beyond it.
  [[nodiscard]] Response trial(double x) const;

  /// The curve of a motion in this direction from the present displacement, or from x on where that
  /// lies ahead: minor loops that close before x are left behind.
  /// @param direction  +1 or −1. @param x  m, within reach.
  [[nodiscard]] Curve curve_ahead(int direction, double x) const;

  /// The energy that the sliders would dissipate in a step to x, J: ∫ Φ1(s)|dx| along the
  /// branches, s = k|x| on the virgin curve and ½k|x − x_r| on the others, in closed form.
  /// @param x  m, within reach.
  /// @throws InputError  where x is beyond it.
  [[nodiscard]] double dissipation(double x) const;

  /// Σ ½κ_i(x − z_i)² of the springs of all elements, J, in closed form: those that slipped at the
  /// reversal r and stuck since are stretched by x − x_r ± f*/k. With it
  /// ∫ f dx = dissipated + change of the stored energy along any path.
  [[nodiscard]] double stored_energy() const;

  /// Takes the step to x. @param x  m, within reach. @return the force there, N.
  /// @throws InputError  where x is beyond it; then no step is taken.
  double advance(double x);

  /// Takes a step whose force is known, as from trial() or the curve of curve_ahead().
  /// @param x  m, within reach. @param force  f there, N. @throws InputError  as advance().
  void settle(double x, double force) {
    if (goes_on(x)) {
      x_ = x;
    } else {
      move_to(x);
    }
    force_ = force;
  }

  /// Takes a step to each x in turn and writes the forces.
  /// @param x      displacements, m; each within reach.
  /// @param force  N; of the length of x; may be x itself.
  /// @throws InputError  for another length, or naming the first x (0-based) that is beyond it;
  ///                     then no step is taken.
  void march(std::span<const double> x, std::span<double> force);

  /// Returns to the virgin state at x = 0.
  void reset();

 private:
  /// The curve that a step ends on: from the present point if the step reverses, else from the
  /// reversal at the top of the first `depth` of the stack, or the virgin curve if there is none.
  struct Branch {
    std::size_t depth;
    bool from_present;
    int direction;  ///< +1 loading, −1 unloading
  };

  struct Step {
    Branch branch;
    Curve curve;
  };

  /// Whether a step to x neither turns nor closes a loop, and is within reach.
  [[nodiscard]] bool goes_on(double x) const {
    const double ahead = direction_ * x;
    return ahead >= direction_ * x_ && ahead < end_;
  }
  [[nodiscard]] Branch first_branch(double x) const;
  static void close_loop(Branch& branch);
  [[nodiscard]] Step step_to(double x) const;
  [[nodiscard]] Curve curve(const Branch& branch) const;
  Curve move_to(double x);
  [[nodiscard]] double force_on(const Curve& on, double x) const;
  [[nodiscard]] std::size_t run_length(const Curve& on, std::span<const double> x) const;

  const Joint* joint_;
  std::vector<ReversalPoint> reversals_;
  double x_ = 0.0;
  double force_ = 0.0;
  int direction_ = 0;  ///< of the last move; 0 in the virgin state
  double end_ = 0.0;   ///< of the curve of the last move, or of the reach; 0 at rest
};

}  // namespace microslip
