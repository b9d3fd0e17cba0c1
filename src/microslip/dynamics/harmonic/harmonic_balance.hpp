// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance_options.hpp"
#include "microslip/dynamics/harmonic/steady_vibration.hpp"
#include "microslip/dynamics/harmonic/target.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Steady periodic vibrations of a jointed structure by the harmonic balance method, with the exact
/// memory of the joints (HarmonicForce) and the linear modes eliminated: J(2H + 1) unknowns for J
/// joints, whatever the number of modes.
///
///     u_j − Σ_l H_jl(nω) N_l,n − A E_j,n = 0,   N_l = −F_l(u_l),     n = 0 … H
///
/// u and N the displacement and tension of a joint, H_jl and E_j the receptances of the linear
/// structure to the joints and to the excitation. Newton's method with the exact derivative solves
/// it; curves are followed by pseudo-arclength continuation [Keller, in: Applications of
/// Bifurcation Theory, Academic Press 1977], past points where they turn back.
///
/// Immutable: one object serves any number of threads.
class HarmonicBalance {
 public:
  /// @throws InputError  for options out of their range; where the response point is missing; where
  ///                     no excited mode moves it.
  HarmonicBalance(JointedStructure structure, ResponsePoint response,
                  HarmonicBalanceOptions options = {});

  /// The structure, as given.
  [[nodiscard]] const JointedStructure& structure() const { return structure_; }
  /// The response point, as given.
  [[nodiscard]] const ResponsePoint& response() const { return response_; }
  /// The options, as given.
  [[nodiscard]] const HarmonicBalanceOptions& options() const { return options_; }

  /// The vibration with two given quantities, for instance frequency and force; phase resonance and
  /// response; phase resonance and frequency. From the linear solution with all joints stuck, and
  /// where Newton's method does not converge, by amplitude continuation from there.
  /// @param first   one of them, with its value.
  /// @param second  the other.
  /// @param mode    where no frequency is given: the mode of the stuck structure (see
  ///                JointedStructure::stuck_frequencies) whose resonance is sought, from 0.
  /// @throws InputError  for targets out of their range or twice the same; force and response
  ///                     without a start, which leave a choice of two frequencies.
  [[nodiscard]] VibrationResult solve(const Target& first, const Target& second,
                                      std::size_t mode = 0) const;

  /// The vibration with two given quantities, from a vibration near it, of this structure.
  /// @throws InputError  also where the number of harmonics or joints of `start` is another.
  [[nodiscard]] VibrationResult solve(const Target& first, const Target& second,
                                      const SteadyVibration& start) const;

  /// The curve of vibrations that keep one target while another quantity, not the phase, goes from
  /// one value to another, up or down, with both ends on it.
  ///
  /// The length of a step is such that neither the response nor the motion of a joint changes by
  /// more than `largest_change`; it is halved where Newton's method does not converge or where the
  /// curve bends too sharply for it, as at a narrow superharmonic resonance. Where an atom of a
  /// density starts to slip the curve has a corner, which becomes a point; so do peaks and points
  /// where it turns back, and over the frequency as many others as `accuracy` requires. The summary
  /// states why the curve ended and where; a curve that did not reach its end, or whose energy
  /// balance is below rounding (an undamped mode at its pole), is not converged, and has the points
  /// up to there.
  /// @param kept      the target, with its value.
  /// @param along     the quantity that changes.
  /// @param from, to  its first and its last value, in its unit; not the same.
  /// @param mode      as in solve().
  /// @param progress  called for each point when it is found, with the part of the curve in
  ///                  thousandths of the range, which never falls; once more, with the whole, at
  ///                  its end, after which only points between others follow.
  /// @throws InputError  for values out of their range, or no range.
  /// @throws Cancelled   where progress says so.
  [[nodiscard]] ResponseCurve follow(const Target& kept, Quantity along, double from, double to,
                                     std::size_t mode = 0, const Progress& progress = {}) const;

  /// Over ω at constant force amplitude.
  /// @param force     A, N.
  /// @param from, to  rad/s.
  /// @param progress  as in follow().
  [[nodiscard]] ResponseCurve frequency_response(double force, double from, double to,
                                                 const Progress& progress = {}) const;

  /// Over ω at constant response: the force is what is found. [AR14 Fig. 4]
  /// @param response  in the kind of the response point.
  /// @param from, to  rad/s.
  /// @param progress  as in follow().
  [[nodiscard]] ResponseCurve constant_response(double response, double from, double to,
                                                const Progress& progress = {}) const;

  /// The vibrations at phase resonance at each of these responses, in this order.
  /// @param responses  > 0, at least one, in the kind of the response point.
  /// @param mode       as in solve().
  /// @param progress   called after each; may cancel (Cancelled).
  [[nodiscard]] ResponseCurve backbone(std::span<const double> responses, std::size_t mode = 0,
                                       const Progress& progress = {}) const;

  /// The curve of phase resonance over the response, followed from where all joints stick, round
  /// the folds where it turns back: then a response may occur more than once, and the rows are
  /// those of the curve in its order, folds among them (turning_points). With Forcing::kModal the
  /// nonlinear mode, which exists whatever the excitation.
  ///
  /// With a force at a point phase resonance may begin or end: the summary is not converged then
  /// and states the range where it exists and why it ends, and the curve has all points found.
  /// @param responses  > 0, rising, at least one, in the kind of the response point.
  /// @param mode       as in solve().
  /// @param progress   called after each; may cancel (Cancelled).
  /// @throws InputError  also where modal forcing is requested for a mode in which no joint takes
  ///                     part, or which does not move the response point: it is linear, or not
  ///                     observable.
  [[nodiscard]] ResponseCurve resonances(std::span<const double> responses, std::size_t mode = 0,
                                         const Progress& progress = {}) const;

 private:
  JointedStructure structure_;
  ResponsePoint response_;
  HarmonicBalanceOptions options_;
};

}  // namespace microslip
