// SPDX-License-Identifier: MIT
#include "microslip/calibrate/level_states.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <utility>

#include "microslip/dynamics/structure/modal_offsets.hpp"

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
  const auto joints = balance_.structure().joints();
  return given_.with_joints({joints.begin(), joints.end()});
}

void LevelStates::correct(const std::vector<double>& modes, std::vector<double> taken) {
  balance_ =
      HarmonicBalance(with_modal_offsets(given(), modes), balance_.response(), balance_.options());
  taken_ = std::move(taken);
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

// All levels start from the previous states, so that the order in which they run does not matter.
void LevelStates::solve(const std::vector<std::size_t>& which) {
  std::vector<std::optional<SteadyVibration>> found(which.size());
  execution_.for_each(which.size(), [&](std::size_t i) { found[i] = find(which[i]); });
  for (std::size_t i = 0; i < which.size(); ++i) {
    states_[which[i]] = std::move(found[i]);
    tried_[which[i]] = true;
  }
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
