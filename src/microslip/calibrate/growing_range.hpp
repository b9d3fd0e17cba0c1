// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/calibrate/calibration_options.hpp"
#include "microslip/calibrate/linearisation.hpp"
#include "microslip/calibrate/mode_offsets.hpp"
#include "microslip/calibrate/vibration_change.hpp"

/// @file
/// The joints and their displacements at the levels, found together. Internal to calibrate.

namespace microslip {

/// The levels linearised about the most likely joints.
struct CalibratedState {
  AllUnknowns unknowns;
  std::vector<std::size_t> levels;  ///< used by it
  std::size_t found = 0;            ///< how many of them have a resonance of the structure
  Eigen::VectorXd about;            ///< coefficients about which it is linearised
  LinearisedLevels linear;
  LinearEvidence evidence;  ///< of them
  SettledEvidence settled;
};

/// A state, and the number of its draws.
struct WeighedState {
  CalibratedState state;
  std::size_t weight = 0;
};

/// Edges found in the density of a joint.
struct FoundEdges {
  std::vector<double> slip_displacement = {};  ///< x*, m; rising
  std::vector<double> deviation = {};          ///< standard deviation of each place, m
  /// Decrease of −2 ln of the likelihood by all of them
  double evidence = 0.0;
  std::vector<std::vector<double>> elsewhere = {};  ///< other places of all, as likely, m
  /// Ranges between them, from 0 to the first on: whether nothing slips there, and how likely
  /// that is.
  std::vector<bool> empty = {};
  std::vector<double> emptiness = {};
};

/// Fixed-point iteration: the joints settled with given joints are those joints.
class GrowingRange {
 public:
  /// @param sought, options, states  must outlive this; `sought` are indices in the structure.
  GrowingRange(CalibrationEvidence evidence, const std::vector<std::size_t>& sought,
               const CalibrationOptions& options, LevelStates& states);

  /// Finds the fixed point. @param tick  called after each pass; throws to stop.
  [[nodiscard]] CalibratedState find(const std::function<void()>& tick);

  /// The state found, and states with other exponents of the joints, weighted by their likelihood,
  /// and with edges at other places: levels hardly determine how a joint continues below the
  /// amplitudes at which it shows, and a band for one exponent alone is far too narrow there. The
  /// likelihood of an exponent is computed with those of the other joints as found.
  /// @param found  by find(). @return at least one.
  [[nodiscard]] std::vector<WeighedState> with_others(const CalibratedState& found);

  /// Whether edges are requested and the levels sufficient.
  [[nodiscard]] bool edges_sought() const;
  /// Edges of each joint that is sought; after find().
  [[nodiscard]] const std::vector<FoundEdges>& edges() const { return edges_; }

  /// Smallest admissible τ of each kind of rows.
  [[nodiscard]] const std::array<double, kRowKinds.size()>& least_scatter() const { return least_; }

  /// Why it ended, iterations and the last change of an amplitude.
  [[nodiscard]] const Summary& summary() const { return summary_; }

  /// The joints of the structure with those sought given by coefficients.
  [[nodiscard]] std::vector<Joint> joints(const AllUnknowns& unknowns,
                                          const Eigen::VectorXd& x) const;

 private:
  [[nodiscard]] CalibratedState linear_about(const std::vector<std::size_t>& which,
                                             AllUnknowns unknowns, Eigen::VectorXd x);
  [[nodiscard]] CalibratedState step(const std::vector<std::size_t>& which,
                                     const CalibratedState& before,
                                     const std::vector<double>& exponents);
  [[nodiscard]] CalibratedState pass(const std::vector<std::size_t>& which,
                                     const CalibratedState* before,
                                     const std::vector<double>& exponents);
  [[nodiscard]] ScatterBounds bounds() const;
  [[nodiscard]] std::pair<double, double> reach(std::size_t joint) const;
  /// Discrete variables drawn in addition to the coefficients, of each joint: χ₀, which of
  /// FoundEdges::elsewhere or kFound, and empty ranges.
  struct Variant {
    std::vector<double> exponents;
    std::vector<std::size_t> places;
    std::vector<std::vector<bool>> empty;
    auto operator<=>(const Variant&) const = default;
  };
  static constexpr std::size_t kFound = static_cast<std::size_t>(-1);
  [[nodiscard]] Variant found_with(const std::vector<double>& exponents) const;
  [[nodiscard]] AllUnknowns unknowns(const Variant& variant) const;
  [[nodiscard]] std::vector<double> amplitude_shares() const;
  /// What was found, and what to return to it takes.
  struct Solution {
    CalibratedState state;
    std::vector<double> exponents;
    ModeUnknowns modes;
    LevelStates::Vibrations vibrations;
  };
  [[nodiscard]] Solution solution(CalibratedState state) const;
  [[nodiscard]] CalibratedState returned_to(Solution solution);
  [[nodiscard]] bool modes_may_be_off() const;
  /// @param off  how the modes without joints are off; nothing: they are as given.
  [[nodiscard]] CalibratedState grow(std::optional<ModesOff> off);
  [[nodiscard]] CalibratedState found_with_modes(std::optional<ModesOff> off);
  [[nodiscard]] CalibratedState found_anew(ModesOff off);
  [[nodiscard]] CalibratedState found_with_likelier_modes();
  [[nodiscard]] static bool likelier(const CalibratedState& one, const CalibratedState& other);
  [[nodiscard]] static double likelihood_with_modes(const CalibratedState& state);
  [[nodiscard]] static double likelihood_of_missing(const CalibratedState& state,
                                                    const CalibratedState& other);
  void leave_out_lost(const std::vector<LevelVibration>& before,
                      std::vector<std::size_t>& which) const;
  void correct_modes(ModesOff off);
  void take_offsets(const AllUnknowns& unknowns, Eigen::VectorXd& x);
  [[nodiscard]] CalibratedState tried(const CalibratedState& start,
                                      const std::vector<double>& exponents);
  void take_if_likelier(const CalibratedState& start, const std::vector<double>& exponents,
                        CalibratedState& best);
  [[nodiscard]] CalibratedState choose_exponents(const CalibratedState& start);
  [[nodiscard]] CalibratedState steadied(CalibratedState state);
  [[nodiscard]] CalibratedState converge(CalibratedState state);

  [[nodiscard]] bool find_edges(const CalibratedState& state);
  [[nodiscard]] bool thin_edges(const CalibratedState& state);
  [[nodiscard]] CalibratedState with_edges(CalibratedState state);
  [[nodiscard]] CalibratedState with_new_edges(const CalibratedState& before);
  void find_emptiness(const CalibratedState& state);
  void weigh_edges(const CalibratedState& found);
  using VariantStates = std::map<Variant, WeighedState>;
  [[nodiscard]] CalibratedState beside(const CalibratedState& found, const Variant& variant);
  [[nodiscard]] WeighedState& state_with(const Variant& variant, const CalibratedState& found,
                                         VariantStates& states);
  [[nodiscard]] std::vector<double> likely_exponents(std::size_t joint,
                                                     const CalibratedState& found,
                                                     VariantStates& states);
  [[nodiscard]] CalibratedState relinearised(const CalibratedState& state);
  void require_levels(const CalibratedState& state) const;
  void require_losses(const CalibratedState& state) const;
  [[nodiscard]] std::vector<LevelVibration> vibrations() const;
  [[nodiscard]] std::size_t found_of(const std::vector<std::size_t>& levels) const;
  void judge_limit(const CalibratedState& state, double change, double over_deviations);

  CalibrationEvidence evidence_;
  const std::vector<std::size_t>& sought_;
  const CalibrationOptions& options_;
  LevelStates& states_;
  std::array<double, kRowKinds.size()> least_;
  std::vector<std::size_t> all_;  // levels by rising displacement
  std::vector<double> given_stiffness_;
  std::vector<double> exponents_;
  std::vector<FoundEdges> edges_;
  ModeUnknowns modes_;
  bool keep_weights_ = false;
  double share_ = 1.0;  // of a step with kept weights
  bool deviations_believed_ = false;
  std::function<void()> tick_;
  Summary summary_;
};

}  // namespace microslip
