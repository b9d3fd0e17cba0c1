// SPDX-License-Identifier: MIT
#include "microslip/calibrate/growing_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/calibrate/mode_offsets.hpp"
#include "microslip/calibrate/step_share.hpp"

namespace microslip {
namespace {

/// The range of amplitudes grows by this factor from pass to pass: joints are extrapolated no
/// further.
constexpr double kGrowth = 1.3;
/// Levels of the first range: a quarter, and so many for each joint at least.
constexpr std::size_t kFirstShare = 4;
constexpr std::size_t kFirstOfJoint = 6;
/// Passes over one range: the first from far away, the others follow their range closely.
constexpr int kFirstPasses = 3;
constexpr int kRangePasses = 2;
/// Halvings of a step that makes levels fit worse.
constexpr int kMostHalvings = 5;
/// Passes that try an exponent: enough for its joints to match their amplitudes.
constexpr int kTrialPasses = 2;
constexpr int kMostPasses = 30;
/// Passes after which λ and τ are kept: where two pairs of them are equally likely they may
/// alternate.
constexpr int kPassesOfWeights = 8;
/// Largest relative change of an amplitude that counts as none: far below its uncertainty.
constexpr double kSmallestChange = 1e-5;
/// A change of what a level shows over its standard deviation that is none in the result.
constexpr double kNegligible = 0.1;
/// Share of the steps with kept weights, at first.
constexpr double kShareOfSteps = 0.5;
/// The same before exponents are compared: a tenth of its uncertainty.
constexpr double kSteady = 1e-3;
/// χ₀ that are tried beside 0, and the required gain of their −2 ln likelihood, as for
/// records.
constexpr std::array kTriedExponents = {-0.25, -0.5, -0.75};
constexpr std::array kAllExponents = {0.0, -0.25, -0.5, -0.75};
constexpr double kStrongEvidence = 6.0;
/// Losses without a deviation scatter by this at least, relative: few levels leave no residual.
constexpr double kLeastLossScatter = 1e-3;
/// Factor from the largest amplitude of a joint at the levels found to one far beyond them.
constexpr double kFarBeyond = 3.0;
/// Times that the mean of the offsets is estimated again, which no step changes.
constexpr int kMostCorrections = 10;
/// Modes are off where their offsets are so many times what a resonance is known to, rms.
constexpr double kOffAtLeast = 2.0;
/// A level without a resonance is not explained: its rows count as off by so many times the
/// scatter.
constexpr double kOffWhereLost = 3.0;
/// The lowest amplitude that a basis is made for, over the largest.
constexpr double kLeastRange = 1e-4;

/// Whether joints have the same exponents and edges.
bool same_laws(const AllUnknowns& one, const AllUnknowns& other) {
  for (std::size_t j = 0; j < one.count(); ++j) {
    if (one.of(j).exponent() != other.of(j).exponent()) return false;
    if (one.of(j).edges() != other.of(j).edges()) return false;
  }
  return true;
}

double rows_of(const LinearEvidence& evidence) {
  double rows = 0.0;
  for (const RowKind kind : kRowKinds) rows += static_cast<double>(evidence.of(kind).data.size());
  return std::max(rows, 1.0);
}

/// The misfit of the criterion that settle() minimises, over the number of levels, which may have
/// grown.
double misfit(const NormalEquations& equations, const EvidenceWeights& weights,
              const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (const RowKind kind : kRowKinds) {
    const double scatter = weights.of(kind);
    sum += equations.residual(kind, x) / (scatter * scatter);
  }
  return sum / rows_of(equations.evidence());
}

/// The roughness of that criterion. λ is of one basis: with that of another range the same
/// densities have another roughness.
double roughness(const NormalEquations& equations, const EvidenceWeights& weights,
                 const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (std::size_t j = 0; j < weights.lambda.size(); ++j) {
    sum += weights.lambda[j] * equations.roughness(j, x);
  }
  return sum / rows_of(equations.evidence());
}

}  // namespace

GrowingRange::GrowingRange(CalibrationEvidence evidence, const std::vector<std::size_t>& sought,
                           const CalibrationOptions& options, LevelStates& states)
    : evidence_(std::move(evidence)),
      sought_(sought),
      options_(options),
      states_(states),
      // Given deviations are not reduced: few levels leave no residual, and an error common to
      // neighbouring ones does not show in it.
      least_{evidence_.loss_std_given ? 1.0 : kLeastLossScatter,
             evidence_.frequency_std_given ? 1.0 : kLeastFrequencyScatter, 1.0, 1.0, 1.0},
      all_(evidence_.levels.size()),
      exponents_(sought.size(), 0.0),
      edges_(sought.size()) {
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  std::ranges::stable_sort(all_, {},
                           [&](std::size_t i) { return evidence_.levels.displacement[i]; });
  for (const std::size_t joint : sought) {
    given_stiffness_.push_back(states.structure().joints()[joint].joint.stiffness());
  }
}

/// Given deviations are used unchanged until the displacements are steady: about wrong joints the
/// error of the joints can be taken for scatter, which keeps them wrong.
ScatterBounds GrowingRange::bounds() const {
  ScatterBounds bounds{.least = least_};
  if (!deviations_believed_) return bounds;
  const auto believe = [&](RowKind kind) {
    bounds.most[static_cast<std::size_t>(kind)] = bounds.least[static_cast<std::size_t>(kind)];
  };
  if (evidence_.loss_std_given) believe(RowKind::kLoss);
  if (evidence_.frequency_std_given) believe(RowKind::kFrequency);
  believe(RowKind::kAmplitude);
  return bounds;
}

/// Least and largest amplitude of a joint. A level that was not found counts where it is not far
/// beyond the others, as it may be found later, or where none of the others moves the joint.
std::pair<double, double> GrowingRange::reach(std::size_t joint) const {
  const bool moves = std::ranges::any_of(all_, [&](std::size_t level) {
    return !states_.missed(level) && used_amplitude(evidence_, states_, level, joint) > 0.0;
  });
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const std::size_t level : all_) {
    if (moves && states_.missed(level)) continue;
    const double a = used_amplitude(evidence_, states_, level, joint);
    least = std::min(least, a);
    largest = std::max(largest, a);
  }
  double with_missed = largest;
  for (const std::size_t level : all_) {
    const double a = used_amplitude(evidence_, states_, level, joint);
    if (states_.missed(level) && a < kFarBeyond * largest) with_missed = std::max(with_missed, a);
  }
  return {least, with_missed};
}

/// Edges and empty ranges as they were found.
GrowingRange::Variant GrowingRange::found_with(const std::vector<double>& exponents) const {
  Variant variant{exponents, std::vector(sought_.size(), kFound), {}};
  for (const FoundEdges& found : edges_) variant.empty.push_back(found.empty);
  return variant;
}

AllUnknowns GrowingRange::unknowns(const Variant& variant) const {
  std::vector<JointUnknowns> joints;
  for (std::size_t j = 0; j < sought_.size(); ++j) {
    const auto [least, largest] = reach(sought_[j]);
    const std::vector<double>& edges = variant.places[j] == kFound
                                           ? edges_[j].slip_displacement
                                           : edges_[j].elsewhere[variant.places[j]];
    joints.emplace_back(given_stiffness_[j], largest, std::clamp(least / largest, kLeastRange, 0.5),
                        variant.exponents[j], options_.coefficients, edges);
    const std::vector<bool>& empty = variant.empty[j];
    const bool any = std::ranges::find(empty, true) != empty.end();
    if (any && joints.back().ranges().size() == empty.size()) {
      joints.back() = joints.back().without(empty);
    }
  }
  return {sought_, std::move(joints), modes_};
}

std::vector<Joint> GrowingRange::joints(const AllUnknowns& unknowns,
                                        const Eigen::VectorXd& x) const {
  std::vector<Joint> joints;
  for (const StructuralJoint& joint : states_.structure().joints()) joints.push_back(joint.joint);
  for (std::size_t j = 0; j < unknowns.count(); ++j) {
    joints[unknowns.index(j)] = unknowns.of(j).joint(unknowns.part(j, x), !evidence_.fit_stiffness);
  }
  return joints;
}

/// The structure with the offsets of its modes, or with the nearest that one has.
void GrowingRange::take_offsets(const AllUnknowns& unknowns, Eigen::VectorXd& x) {
  if (unknowns.mode_count() == 0) return;
  states_.correct(unknowns.offsets(x));
  x.tail(unknowns.mode_count()) = offset_coefficients(unknowns.modes(), states_);
}

/// The levels about given joints; not settled yet.
CalibratedState GrowingRange::linear_about(const std::vector<std::size_t>& which,
                                           AllUnknowns unknowns, Eigen::VectorXd x) {
  states_.set_joints(joints(unknowns, x));
  take_offsets(unknowns, x);
  states_.solve(which);
  LinearisedLevels linear = linearise(evidence_, unknowns, states_, which, x);
  LinearEvidence evidence = in_terms_of(evidence_, unknowns, linear);
  const std::size_t found = found_of(which);
  return {std::move(unknowns), which, found, std::move(x), std::move(linear),
          std::move(evidence), {}};
}

/// Steps to the settled joints, or a part of that step where the levels, which are nonlinear, fit
/// worse there.
CalibratedState GrowingRange::step(const std::vector<std::size_t>& which,
                                   const CalibratedState& before,
                                   const std::vector<double>& exponents) {
  const AllUnknowns now = unknowns(found_with(exponents));
  const Eigen::VectorXd from = now.projected(before.unknowns, before.about);
  const Eigen::VectorXd full = now.projected(before.unknowns, before.settled.x) - from;
  double share = keep_weights_ ? share_ : 1.0;  // where full steps oscillate
  const NormalEquations equations(before.evidence);
  const EvidenceWeights& weights = before.settled.weights;
  const auto prior = [&](double part) {
    const Eigen::VectorXd x = before.about + part * (before.settled.x - before.about);
    return roughness(equations, weights, x);
  };
  const double present = misfit(equations, weights, before.about) + prior(0.0);
  const LevelStates::Vibrations start = states_.vibrations();
  // Another law makes other joints of the same coefficients: no part of a step leads back.
  const bool comparable = which == before.levels && same_laws(now, before.unknowns);
  const auto worse = [&](const CalibratedState& next) {
    if (found_of(before.levels) < before.found) return true;
    return comparable &&
           misfit(NormalEquations(next.evidence), weights, next.about) + prior(share) > present;
  };
  CalibratedState next = linear_about(which, now, from + share * full);
  for (int i = 0; i < kMostHalvings && worse(next); ++i) {
    share *= 0.5;
    states_.set_vibrations(start);  // a step too far may lead to other vibrations
    next = linear_about(which, now, from + share * full);
  }
  return next;
}

std::size_t GrowingRange::found_of(const std::vector<std::size_t>& levels) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      levels, [&](std::size_t level) { return states_.at(level).has_value(); }));
}

CalibratedState GrowingRange::pass(const std::vector<std::size_t>& which,
                                   const CalibratedState* before,
                                   const std::vector<double>& exponents) {
  CalibratedState state = [&] {
    if (before) return step(which, *before, exponents);
    AllUnknowns first = unknowns(found_with(exponents));
    Eigen::VectorXd x(first.size());
    for (std::size_t j = 0; j < first.count(); ++j) {
      x.segment(first.begin(j), first.of(j).size()) = first.of(j).stuck();
    }
    x.tail(first.mode_count()) = first.modes().coefficients(first.modes().start);
    return linear_about(which, std::move(first), std::move(x));
  }();
  const NormalEquations equations(state.evidence);
  if (keep_weights_ && before) {
    state.settled = settle_with(equations, before->settled.weights);
    if (tick_) tick_();
    return state;
  }
  state.settled = settle_from_afar(equations, bounds());
  if (before) {
    SettledEvidence near = settle(equations, before->settled.weights, bounds());
    if (near.likelihood < state.settled.likelihood) state.settled = std::move(near);
  }
  if (tick_) tick_();
  return state;
}

/// For each level the largest ratio of the amplitude of a joint sought to its largest of all
/// levels.
std::vector<double> GrowingRange::amplitude_shares() const {
  std::vector<double> shares(all_.size(), 0.0);
  for (const std::size_t joint : sought_) {
    const double largest = reach(joint).second;
    for (const std::size_t level : all_) {
      shares[level] =
          std::max(shares[level], used_amplitude(evidence_, states_, level, joint) / largest);
    }
  }
  return shares;
}

CalibratedState GrowingRange::grow(std::optional<ModesOff> off) {
  std::vector<double> sorted = amplitude_shares();
  std::ranges::sort(sorted);
  const std::size_t begin = std::min(
      sorted.size(), std::max(sorted.size() / kFirstShare, kFirstOfJoint * sought_.size()));
  double share = sorted[begin - 1];
  std::optional<CalibratedState> state;
  while (true) {
    std::vector<std::size_t> which;
    const std::vector<double> shares = amplitude_shares();
    for (const std::size_t level : all_) {
      if (shares[level] <= share || share >= 1.0) which.push_back(level);
    }
    const int passes = state ? kRangePasses : kFirstPasses;
    for (int i = 0; i < passes; ++i) state = pass(which, state ? &*state : nullptr, exponents_);
    if (share >= 1.0) return std::move(*state);
    if (off && modes_.count() == 0) correct_modes(*off);
    share = std::min(1.0, kGrowth * share);
  }
}

/// Passes until displacements hardly change: likelihoods of exponents compare where the levels are
/// linear about the joints that they are of.
CalibratedState GrowingRange::steadied(CalibratedState state) {
  keep_weights_ = false;
  for (int i = 0; i < kPassesOfWeights; ++i) {
    const std::vector<LevelVibration> before = vibrations();
    state = pass(all_, &state, exponents_);
    if (largest_change(before, vibrations()) < kSteady) break;
  }
  return state;
}

/// Passes with exponents, from a state of other ones.
CalibratedState GrowingRange::tried(const CalibratedState& start,
                                    const std::vector<double>& exponents) {
  CalibratedState state = start;
  for (int i = 0; i < kTrialPasses; ++i) state = pass(all_, &state, exponents);
  return state;
}

/// Accepts the exponents where they are much likelier than those in use.
void GrowingRange::take_if_likelier(const CalibratedState& start,
                                    const std::vector<double>& exponents, CalibratedState& best) {
  CalibratedState other = tried(start, exponents);
  if (other.found < best.found) return;
  const double gain = exponents == exponents_ ? 0.0 : kStrongEvidence;
  if (other.settled.likelihood + gain >= best.settled.likelihood) return;
  best = std::move(other);
  exponents_ = exponents;
}

// One for all joints first: joints that contribute alike would share the loss by the order in which
// theirs are chosen.
CalibratedState GrowingRange::choose_exponents(const CalibratedState& start) {
  exponents_.assign(sought_.size(), 0.0);
  CalibratedState best = tried(start, exponents_);
  for (const double exponent : kTriedExponents) {
    take_if_likelier(start, std::vector<double>(sought_.size(), exponent), best);
  }
  for (std::size_t j = 0; j < sought_.size() && sought_.size() > 1; ++j) {
    const std::vector<double> others = exponents_;
    for (const double exponent : kAllExponents) {
      std::vector<double> exponents = others;
      exponents[j] = exponent;
      if (exponent != others[j]) take_if_likelier(start, exponents, best);
    }
  }
  return best;
}

std::vector<LevelVibration> GrowingRange::vibrations() const {
  return vibrations_of(states_, evidence_.levels.size(), sought_);
}

/// The verdict on passes that have not converged: they have where what they still change is far
/// below what the levels are known to.
/// @param change  relative, by a whole step. @param over_deviations  the same of what rows show.
void GrowingRange::judge_limit(const CalibratedState& state, double change,
                               double over_deviations) {
  summary_.residual = change;
  summary_.reason = fmt::format(
      "joint displacements still change by {:.1e}, relative, after {} passes: losses, frequencies "
      "and displacements by {:.2g} of their standard deviations at most",
      change, kMostPasses, over_deviations);
  const bool within = over_deviations <= kNegligible && state.settled.solution.optimal();
  summary_.stop = within ? Stop::kConverged : Stop::kLimit;
}

/// A level that is lost while the joints hardly change any more is found again and lost again: what
/// it shows there is of another vibration.
void GrowingRange::leave_out_lost(const std::vector<LevelVibration>& before,
                                  std::vector<std::size_t>& which) const {
  std::erase_if(which, [&](std::size_t level) {
    return before[level].angular_frequency > 0.0 && !states_.at(level);
  });
}

CalibratedState GrowingRange::converge(CalibratedState state) {
  summary_.method = "levels of several joints";
  keep_weights_ = false;
  StepShare share(kShareOfSteps);
  double over_deviations = 0.0;
  std::vector<std::size_t> which = all_;
  for (int i = 0; i < kMostPasses; ++i) {
    const std::vector<LevelVibration> before = vibrations();
    keep_weights_ = i >= kPassesOfWeights;
    share_ = keep_weights_ ? share.share() : 1.0;
    state = pass(which, &state, exponents_);
    const double change = largest_change(before, vibrations());
    if (keep_weights_) leave_out_lost(before, which);
    summary_.residual = change;
    summary_.iterations = i + 1;
    if (change > kSmallestChange * std::min(1.0, share_ / kShareOfSteps)) {
      over_deviations = change_over_deviations(before, vibrations(), state.linear,
                                               state.settled.weights, states_, sought_) /
                        share_;
      if (keep_weights_) share.take(change);
      continue;
    }
    read_optimality(state.settled.solution, "optimality conditions", summary_);
    if (!state.settled.solution.optimal()) return state;
    summary_.residual = change;
    summary_.stop = Stop::kConverged;
    summary_.reason =
        fmt::format("no joint displacement changes by more than {:.1e}, relative", kSmallestChange);
    return state;
  }
  judge_limit(state, summary_.residual / share_, over_deviations);
  return state;
}

/// With too few resonances the joints cannot be identified.
void GrowingRange::require_levels(const CalibratedState& state) const {
  const std::size_t fewest = kFewestModalLevels * sought_.size();
  if (state.found >= fewest) return;
  throw InputError("levels with a resonance of the structure", static_cast<double>(state.found),
                   fmt::format("must be {} or more for {} joint{}", fewest, sought_.size(),
                               sought_.size() == 1 ? "" : "s"),
                   "Check the unit of the displacements, the numbers of the modes and the model.");
}

/// Damping ratios below those of the structure leave nothing to the joints.
void GrowingRange::require_losses(const CalibratedState& state) const {
  for (const std::size_t level : state.levels) {
    if (!states_.at(level)) continue;
    const double loss = measured_loss(evidence_.levels, level, *states_.at(level)).value;
    if (!(loss <= 0.0)) return;
  }
  throw InputError("loss of the joints in all levels", InputState{"0 or less"},
                   "must be above 0 in one of them",
                   "Damping ratios must include the loss of the structure, as the model does.");
}

// Stiffnesses that are sought are found last: with wrong joints frequencies would be attributed to
// them. The exponents are then chosen anew, as a wrong stiffness leads to a wrong tail.
CalibratedState GrowingRange::find(const std::function<void()>& tick) {
  tick_ = tick;
  const bool fit_stiffness = evidence_.fit_stiffness;
  if (fit_stiffness) {
    evidence_.fit_stiffness = false;
    evidence_.frequency = FrequencyUse::kChange;
  }
  CalibratedState state = found_with_likelier_modes();
  if (!fit_stiffness) {
    state = converge(with_edges(std::move(state)));
    require_levels(state);
    weigh_edges(state);
    return state;
  }
  state = converge(std::move(state));
  require_levels(state);
  evidence_.fit_stiffness = true;
  evidence_.frequency = FrequencyUse::kAbsolute;
  keep_weights_ = false;
  state = converge(with_edges(choose_exponents(relinearised(state))));
  weigh_edges(state);
  return state;
}

CalibratedState GrowingRange::found_with_modes(std::optional<ModesOff> off) {
  deviations_believed_ = true;
  CalibratedState state = grow(off);
  require_levels(state);
  require_losses(state);
  state = steadied(std::move(state));
  for (int i = 0; i < kMostCorrections && off; ++i) {
    const double before = modes_.mean;
    correct_modes(*off);
    state = steadied(relinearised(state));
    if (std::abs(modes_.mean - before) < kFrequencyResolution) break;
  }
  deviations_believed_ = false;
  return choose_exponents(state);
}

/// −2 ln of the likelihood, with that of the offsets in their units.
double GrowingRange::likelihood_with_modes(const CalibratedState& state) {
  double sum = state.settled.likelihood;
  for (const double unit : state.unknowns.modes().unit) {
    sum += unit > 0.0 ? 2.0 * std::log(unit) : 0.0;
  }
  return sum;
}

/// What further rows, of levels that another state alone has found, would add to −2 ln of the
/// likelihood if each were off by kOffWhereLost times the scatter of this one.
double GrowingRange::likelihood_of_missing(const CalibratedState& state,
                                           const CalibratedState& other) {
  double sum = 0.0;
  for (const RowKind kind : kMeasuredKinds) {
    const auto more = static_cast<double>(other.evidence.of(kind).data.size() -
                                          state.evidence.of(kind).data.size());
    const double each = kOffWhereLost * kOffWhereLost;
    sum += std::max(0.0, more) * (each + 2.0 * std::log(state.settled.weights.of(kind)));
  }
  return sum;
}

bool GrowingRange::likelier(const CalibratedState& one, const CalibratedState& other) {
  return likelihood_with_modes(one) + likelihood_of_missing(one, other) <
         likelihood_with_modes(other) + likelihood_of_missing(other, one);
}

GrowingRange::Solution GrowingRange::solution(CalibratedState state) const {
  return {std::move(state), exponents_, modes_, states_.vibrations()};
}

CalibratedState GrowingRange::returned_to(Solution solution) {
  exponents_ = std::move(solution.exponents);
  modes_ = std::move(solution.modes);
  if (modes_.count() == 0) states_.correct(std::vector<double>(states_.unknown_offsets(), 0.0));
  states_.set_vibrations(solution.vibrations);
  return relinearised(solution.state);
}

CalibratedState GrowingRange::found_anew(ModesOff off) {
  exponents_.assign(sought_.size(), 0.0);
  modes_ = {};
  states_.begin_anew();
  return found_with_modes(off);
}

// What joints soften below the least levels and an offset of the modes look alike by the changes of
// the frequencies: modes are as given where that explains the levels as well.
CalibratedState GrowingRange::found_with_likelier_modes() {
  CalibratedState given = found_with_modes(std::nullopt);
  if (!modes_may_be_off()) return given;
  Solution best = solution(given);
  correct_modes(ModesOff::kWithSpringsAsGiven);
  const bool off = std::ranges::any_of(modes_.start, [](double each) {
    return std::abs(each) > kOffAtLeast * kFrequencyResolution;
  });
  if (!off) {
    modes_ = {};
    return given;
  }
  modes_ = modes_.as_given();
  CalibratedState to_compare = relinearised(given);
  for (const ModesOff how : {ModesOff::kWithSpringsAsGiven, ModesOff::kAllAlike}) {
    CalibratedState found = found_anew(how);
    if (!likelier(found, to_compare)) continue;
    to_compare = found;
    best = solution(std::move(found));
  }
  return returned_to(std::move(best));
}

/// Softening is relative to the frequencies of the structure, and the displacements of the joints
/// to its shapes: where they are off, losses and frequencies of the levels are of no joints
/// together. Offsets of the modes are then unknowns, too, as far off as the levels show.
void GrowingRange::correct_modes(ModesOff off) {
  modes_ = mode_unknowns(states_.given(), level_offsets(evidence_.levels, states_), off);
}

bool GrowingRange::modes_may_be_off() const {
  return options_.correct_modes && !options_.fit_stiffness && !evidence_.stuck_shapes &&
         evidence_.frequency == FrequencyUse::kChange;
}

/// The same joints in the terms of other evidence.
CalibratedState GrowingRange::relinearised(const CalibratedState& state) {
  AllUnknowns now = unknowns(found_with(exponents_));
  Eigen::VectorXd x = now.projected(state.unknowns, state.settled.x);
  CalibratedState anew = linear_about(all_, std::move(now), std::move(x));
  anew.settled = settle_from_afar(NormalEquations(anew.evidence), bounds());
  return anew;
}

}  // namespace microslip
