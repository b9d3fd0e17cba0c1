// SPDX-License-Identifier: MIT
#include "microslip/calibrate/level_states.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

/// A point that moves by less than this share of the motion possible with the modes stands still,
/// to rounding.
constexpr double kLeastMotion = 1e-9;
/// Two shapes are of one mode where the modal assurance criterion of their first harmonics is above
/// this; neighbouring levels differ by far less.
constexpr double kLeastLikeness = 0.8;
/// From one level to the next above it, and from the stuck structure to the first, a resonance
/// falls; beyond these shares of its frequency lies another place where the phase is the same.
constexpr double kMostRise = 1.02;
constexpr double kLeastFall = 0.7;
/// The least part of a correction that is tried.
constexpr double kLeastCorrection = 1.0 / 64.0;
/// A point of a curve of resonances is at a response to this, relative.
constexpr double kSameResponse = 1e-6;

JointedStructure with_joints(const JointedStructure& structure, const std::vector<Joint>& joints) {
  std::vector<StructuralJoint> placed(structure.joints().begin(), structure.joints().end());
  for (std::size_t j = 0; j < joints.size(); ++j) placed[j].joint = joints[j];
  return structure.with_joints(std::move(placed));
}

double dot_product(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

std::vector<std::vector<double>> stuck_modes(const JointedStructure& structure) {
  std::vector<std::vector<double>> modes;
  for (std::size_t mode = 0; mode < structure.linear().vibrations(); ++mode) {
    modes.push_back(structure.stuck_mode(mode));
  }
  return modes;
}

/// |u_j| over the response of each mode of the stuck structure.
std::vector<std::vector<double>> stuck_shapes(const JointedStructure& structure,
                                              const std::string& response) {
  std::vector<std::vector<double>> shapes;
  for (const std::vector<double>& q : stuck_modes(structure)) {
    const std::span<const double> seen = structure.linear().shape(response);
    double moved = std::abs(dot_product(seen, q));
    if (moved < kLeastMotion * std::sqrt(dot_product(seen, seen))) moved = 0.0;
    std::vector<double>& over = shapes.emplace_back();
    for (const StructuralJoint& joint : structure.joints()) {
      over.push_back(moved > 0.0 ? std::abs(dot_product(joint.shape, q)) / moved : 0.0);
    }
  }
  return shapes;
}

}  // namespace

LevelStates::LevelStates(JointedStructure structure, std::string response,
                         HarmonicBalanceOptions balance, const ModalLevels& levels,
                         Execution execution)
    : levels_(levels),
      given_(structure),
      execution_(std::move(execution)),
      balance_(std::move(structure), ResponsePoint{std::move(response)}, std::move(balance)),
      states_(levels.size()),
      tried_(levels.size(), false) {
  read_stuck();
}

void LevelStates::read_stuck() {
  stuck_mode_ = stuck_modes(balance_.structure());
  stuck_frequency_ = balance_.structure().stuck_frequencies();
  stuck_shape_ = stuck_shapes(balance_.structure(), balance_.response().point);
}

void LevelStates::set_joints(const std::vector<Joint>& joints) {
  balance_ = HarmonicBalance(with_joints(balance_.structure(), joints), balance_.response(),
                             balance_.options());
  read_stuck();
}

JointedStructure LevelStates::given() const {
  std::vector<Joint> joints;
  for (const StructuralJoint& joint : balance_.structure().joints()) joints.push_back(joint.joint);
  return with_joints(given_, joints);
}

/// Of each joint, in the levels of a mode that were found; stuck where none was.
std::vector<double> LevelStates::mean_stiffness(std::size_t mode) const {
  std::vector<double> sum(balance_.structure().joints().size(), 0.0);
  double count = 0.0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!states_[i] || levels_.mode[i] != mode) continue;
    count += 1.0;
    for (std::size_t j = 0; j < sum.size(); ++j) {
      sum[j] +=
          secant_stiffness(balance_.structure().joints()[j].joint, states_[i]->joints[j].amplitude);
    }
  }
  for (std::size_t j = 0; j < sum.size(); ++j) {
    sum[j] = count > 0.0 ? sum[j] / count : balance_.structure().joints()[j].joint.stiffness();
  }
  return sum;
}

// With all modes off as the springs are there is always one: a stiffness that is scaled.
void LevelStates::correct(const std::vector<double>& modes) {
  const JointedStructure before = given();
  const double springs = before.joints().empty() ? 0.0 : modes.back();
  for (double share = 1.0;; share = share > kLeastCorrection ? 0.5 * share : 0.0) {
    std::vector<double> part(modes.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      part[i] = springs + share * (modes[i] - springs);
    }
    try {
      take(before, std::move(part));
      return;
    } catch (const InputError&) {  // no structure has these
      if (share == 0.0) throw;
    }
  }
}

void LevelStates::begin_anew() {
  balance_ = HarmonicBalance(given_, balance_.response(), balance_.options());
  offsets_.clear();
  taken_.clear();
  states_.assign(levels_.size(), std::nullopt);
  tried_.assign(levels_.size(), false);
  read_stuck();
}

/// @throws InputError  as JointedStructure.
void LevelStates::take(const JointedStructure& before, std::vector<double> modes) {
  const std::span<const double> all(modes);
  const std::size_t count = before.linear().size();
  JointedStructure after = with_modal_offsets(before, all.first(count), all.subspan(count));
  offsets_ = std::move(modes);
  taken_.assign(stuck_mode_.size(), 0.0);
  for (std::size_t mode = 0; mode < taken_.size(); ++mode) {
    if (std::ranges::find(levels_.mode, mode) == levels_.mode.end()) continue;
    const StructureOffset there{.mode = mode, .joint_stiffness = mean_stiffness(mode)};
    taken_[mode] = std::log(secant_frequency(after, there) / secant_frequency(before, there));
  }
  balance_ = HarmonicBalance(std::move(after), balance_.response(), balance_.options());
  read_stuck();
}

std::optional<std::size_t> LevelStates::nearest(std::size_t level) const {
  std::optional<std::size_t> best;
  double least = 0.0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!states_[i] || levels_.mode[i] != levels_.mode[level]) continue;
    const double far = std::abs(std::log(levels_.displacement[i] / levels_.displacement[level]));
    if (best && far >= least) continue;
    best = i;
    least = far;
  }
  return best;
}

std::optional<std::size_t> LevelStates::below(std::size_t level) const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (!states_[i] || levels_.mode[i] != levels_.mode[level]) continue;
    if (levels_.displacement[i] >= levels_.displacement[level]) continue;
    if (!best || levels_.displacement[i] > levels_.displacement[*best]) best = i;
  }
  return best;
}

/// Whether a vibration is of the mode of a level: shaped as at the nearest level below, or as with
/// the joints stuck, and not far from there in frequency.
bool LevelStates::of_mode(std::size_t level, const SteadyVibration& vibration) const {
  const std::size_t mode = levels_.mode[level];
  const std::optional<std::size_t> lower = below(level);
  std::complex<double> product = 0.0;
  double square = 0.0;
  double reference = 0.0;
  for (std::size_t m = 0; m < vibration.modal.size(); ++m) {
    const std::complex<double> q = vibration.modal[m][1];
    const std::complex<double> expected =
        lower ? states_[*lower]->modal[m][1] : std::complex<double>(stuck_mode_[mode][m]);
    product += std::conj(expected) * q;
    square += std::norm(q);
    reference += std::norm(expected);
  }
  const double frequency = lower ? states_[*lower]->angular_frequency : stuck_frequency_[mode];
  return std::norm(product) > kLeastLikeness * square * reference &&
         vibration.angular_frequency < kMostRise * frequency &&
         vibration.angular_frequency > kLeastFall * frequency;
}

std::optional<SteadyVibration> LevelStates::find(std::size_t level) const {
  const Target response{Quantity::kResponse, levels_.displacement[level]};
  const std::optional<std::size_t> starts[] = {nearest(level), below(level)};
  for (const std::optional<std::size_t>& start : starts) {
    if (!start) continue;
    VibrationResult found = balance_.solve(kPhaseResonance, response, *states_[*start]);
    if (found.summary.converged() && of_mode(level, found.vibration)) {
      return std::move(found.vibration);
    }
  }
  VibrationResult found = balance_.solve(kPhaseResonance, response, levels_.mode[level]);
  if (!found.summary.converged() || !of_mode(level, found.vibration)) return std::nullopt;
  return std::move(found.vibration);
}

/// Levels of one mode that Newton's method did not find, by the curve of resonances from rest,
/// which goes round folds and corners.
void LevelStates::trace(std::size_t mode, const std::vector<std::size_t>& missed) {
  std::vector<std::size_t> rising;
  std::ranges::copy_if(missed, std::back_inserter(rising),
                       [&](std::size_t level) { return levels_.mode[level] == mode; });
  if (rising.empty() || !shows(mode)) return;
  std::ranges::sort(rising, {}, [&](std::size_t level) { return levels_.displacement[level]; });
  std::vector<double> responses;
  for (const std::size_t level : rising) {
    const double response = levels_.displacement[level];
    if (responses.empty() || response > responses.back()) responses.push_back(response);
  }
  const ResponseCurve curve = balance_.resonances(responses, mode);
  for (const std::size_t level : rising) {
    const double response = levels_.displacement[level];
    const auto reached = std::ranges::find_if(curve.points, [&](const SteadyVibration& point) {
      return std::abs(point.response / response - 1.0) < kSameResponse && of_mode(level, point);
    });
    if (reached != curve.points.end()) states_[level] = *reached;
  }
}

// All levels start from the previous states, so that the order in which they run does not matter.
void LevelStates::solve(const std::vector<std::size_t>& which) {
  std::vector<std::optional<SteadyVibration>> found(which.size());
  execution_.for_each(which.size(), [&](std::size_t i) { found[i] = find(which[i]); });
  for (std::size_t i = 0; i < which.size(); ++i) {
    states_[which[i]] = std::move(found[i]);
    tried_[which[i]] = true;
  }
  std::vector<std::size_t> missed;
  std::ranges::copy_if(which, std::back_inserter(missed),
                       [&](std::size_t level) { return this->missed(level); });
  if (missed.empty()) return;
  for (std::size_t mode = 0; mode < stuck_mode_.size(); ++mode) trace(mode, missed);
}

bool LevelStates::shows(std::size_t mode) const {
  return std::ranges::any_of(stuck_shape_[mode], [](double over) { return over > 0.0; });
}

double LevelStates::amplitude(std::size_t level, std::size_t joint) const {
  if (states_[level]) return states_[level]->joints[joint].amplitude;
  if (const std::optional<std::size_t> near = nearest(level)) {
    return states_[*near]->joints[joint].amplitude * levels_.displacement[level] /
           levels_.displacement[*near];
  }
  return stuck_amplitude(level, joint);
}

}  // namespace microslip
