// SPDX-License-Identifier: MIT
#include "microslip/calibrate/mode_offsets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

/// Of the stiffness of a vibration that must not be of its joints.
constexpr double kLeastOfModes = 0.1;
/// Offsets that tell their scatter.
constexpr std::size_t kFewestOfScatter = 3;

/// A mode as its levels show it.
struct MeasuredMode {
  StructureOffset mean;
  double scatter = 0.0;  ///< of its levels about the offset, rms
};

MeasuredMode measured_mode(std::size_t mode, const std::vector<const LevelOffset*>& levels) {
  const auto n = static_cast<double>(levels.size());
  MeasuredMode measured{
      {.mode = mode,
       .joint_stiffness = std::vector<double>(levels.front()->joint_stiffness.size(), 0.0)}};
  for (const LevelOffset* level : levels) {
    measured.mean.offset += level->offset / n;
    for (std::size_t j = 0; j < level->joint_stiffness.size(); ++j) {
      measured.mean.joint_stiffness[j] += level->joint_stiffness[j] / n;
    }
  }
  double squares = 0.0;
  for (const LevelOffset* level : levels)
    squares += std::pow(level->offset - measured.mean.offset, 2);
  measured.scatter = std::sqrt(squares / n);
  return measured;
}

std::vector<MeasuredMode> measured_modes(const JointedStructure& structure,
                                         const std::vector<LevelOffset>& levels) {
  std::vector<MeasuredMode> all;
  for (std::size_t mode = 0; mode < structure.linear().vibrations(); ++mode) {
    std::vector<const LevelOffset*> own;
    for (const LevelOffset& level : levels) {
      if (level.mode == mode) own.push_back(&level);
    }
    if (own.empty()) continue;
    MeasuredMode measured = measured_mode(mode, own);
    if (share_of_modes(structure, measured.mean) >= kLeastOfModes)
      all.push_back(std::move(measured));
  }
  return all;
}

/// Of the modes whose offset is not determined: the mean of the others, and its standard deviation.
std::pair<double, double> offset_of_others(const std::vector<double>& offsets) {
  const auto n = static_cast<double>(offsets.size());
  double mean = 0.0;
  for (const double one : offsets) mean += one / n;
  double squares = 0.0;
  for (const double one : offsets) squares += std::pow(one - mean, 2);
  if (offsets.size() < kFewestOfScatter) return {mean, std::sqrt(mean * mean + squares / n)};
  return {mean, std::sqrt(squares / (n - 1.0) * (1.0 + 1.0 / n))};
}

}  // namespace

bool of_first_session(const ModalLevels& levels, std::size_t level) {
  const auto first = std::ranges::find(levels.mode, levels.mode[level]) - levels.mode.begin();
  return levels.same_offset(static_cast<std::size_t>(first), level);
}

ModeUnknowns mode_unknowns(const JointedStructure& structure,
                           const std::vector<LevelOffset>& levels, ModesOff off) {
  const bool alike = off == ModesOff::kAllAlike;
  std::vector<StructureOffset> measured;
  std::vector<double> offsets;
  const std::size_t modes = structure.linear().size();
  ModeUnknowns unknowns{.determined = std::vector<bool>(modes, false)};
  for (const MeasuredMode& one : measured_modes(structure, levels)) {
    const VibrationShares shares = vibration_shares(structure, one.mean);
    if (shares.without_joints() < kLeastOfModes) continue;
    unknowns.determined[one.mean.mode] = true;
    measured.push_back(one.mean);
    offsets.push_back(one.mean.offset / (alike ? shares.without_joints() : shares.of_modes()));
  }
  if (measured.empty()) return {};
  const auto [mean, deviation] = offset_of_others(offsets);
  const std::vector<double> springs(structure.joints().size(), alike ? mean : 0.0);
  unknowns.mean = mean;
  unknowns.unit.assign(modes, std::max(deviation, kFrequencyResolution));
  unknowns.unit.resize(modes + springs.size(), 0.0);
  unknowns.start.assign(modes, mean);
  try {
    unknowns.start = modal_offsets(structure, measured, mean, springs).offset;
  } catch (const InputError&) {  // no structure has them: one that is off alike is near
  }
  unknowns.start.insert(unknowns.start.end(), springs.begin(), springs.end());
  return unknowns;
}

bool FoundModes::any() const {
  return std::ranges::any_of(offset,
                             [](double each) { return std::abs(each) > kFrequencyResolution; });
}

std::vector<LevelOffset> level_offsets(const ModalLevels& levels, const LevelStates& states) {
  std::vector<LevelOffset> all;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double measured = ModalLevels::value(levels.frequency, i);
    if (!states.at(i) || std::isnan(measured) || !of_first_session(levels, i)) continue;
    LevelOffset level{levels.mode[i], std::log(2.0 * std::numbers::pi * measured /
                                               states.at(i)->angular_frequency) +
                                          states.offset_taken(levels.mode[i])};
    for (std::size_t j = 0; j < states.structure().joints().size(); ++j) {
      level.joint_stiffness.push_back(
          secant_stiffness(states.structure().joints()[j].joint, states.amplitude(i, j)));
    }
    all.push_back(std::move(level));
  }
  return all;
}

Eigen::VectorXd offset_coefficients(const ModeUnknowns& modes, const LevelStates& states) {
  std::vector<double> present = states.offsets();
  present.resize(modes.count(), 0.0);
  return modes.coefficients(present);
}

FoundModes found_modes(const JointedStructure& structure, const std::vector<LevelOffset>& levels) {
  const std::vector<MeasuredMode> modes = measured_modes(structure, levels);
  if (modes.empty()) return {};
  std::vector<StructureOffset> measured;
  std::vector<double> means;
  for (const MeasuredMode& one : modes) {
    measured.push_back(one.mean);
    means.push_back(one.mean.offset);
  }
  const auto [others, others_std] = offset_of_others(means);
  const ModalOffsets offsets = modal_offsets(structure, measured, others);
  FoundModes all{.offset = offsets.offset};
  for (std::size_t i = 0; i < offsets.offset.size(); ++i) {
    double variance = offsets.left[i] * others_std * others_std;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      variance += std::pow(offsets.by_measured[i][m] * modes[m].scatter, 2);
    }
    all.deviation.push_back(std::sqrt(variance));
  }
  return all;
}

}  // namespace microslip
