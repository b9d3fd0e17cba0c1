// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/modal_level_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "microslip/base/percent.hpp"
#include "microslip/base/plausibility.hpp"
#include "microslip/rig/reduction/record_flags.hpp"

namespace microslip {
namespace {

constexpr double kSignificantModal = 3.0;  // standard deviations
/// Largest relative offset of the drive from the stuck frequency of its mode: beyond it the model
/// is not that of the measurement.
constexpr double kFarFromStuck = 0.2;
constexpr double kMostSecant = 1.1;
/// Participation from which a joint takes part in an unobserved direction.
constexpr double kTakesPart = 0.1;
/// Share of a resonance's frequency that is rounding.
constexpr double kSameFrequency = 1e-9;

const std::string& name_of(const ModalRecord& record, std::size_t joint) {
  return record.test.structure.joints()[joint].name;
}

/// "0.8 of 'joint1' with 0.6 of 'joint2'".
std::string direction_text(const UnseenDirection& direction, const ModalRecord& record) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t j = 0; j < direction.participant.size(); ++j) {
    if (direction.participant[j] < kTakesPart) continue;
    text += count++ == 0 ? "" : " with ";
    text += fmt::format("{:.2g} of '{}'", direction.participant[j], name_of(record, j));
  }
  return text;
}

void flag_unseen(ModalLevel& level, const ModalRecord& record) {
  std::string text;
  for (const UnseenDirection& direction : record.observer.unseen()) {
    if (direction.harmonic > 1) continue;
    text += (text.empty() ? "" : "; ") + direction_text(direction, record);
  }
  if (text.empty()) return;
  add_flag_once(
      level.flags, kJointNotSeen,
      fmt::format("The accelerometers, {}, do not resolve the motion of all {} joints: below noise "
                  "is {}. There the joint is taken to stick, with a standard deviation for the "
                  "unknown motion; D of all joints together does not need it. Add accelerometers "
                  "that move with those joints, or calibrate by the model.",
                  record.test.accelerometers.size(), level.joints.size(), text));
}

void flag_joint(ModalLevel& level, std::size_t index, const StructuralJoint& joint) {
  const JointLevel& found = level.joints[index];
  if (found.reversals > 2) {
    add_flag_once(
        level.flags, kInnerReversals,
        fmt::format("Joint '{}' has {} reversals per cycle: a density follows from D where "
                    "there are 2.",
                    joint.name, found.reversals));
  }
  if (found.unseen > kTakesPart) return;
  const double k = joint.joint.stiffness();
  const Measured& d = found.dissipation;
  const double bound = k * found.amplitude.value * found.amplitude.value;
  if (d.value - kSignificantModal * d.std > bound) {
    add_flag_once(level.flags, "dissipation_above_bound",
                  fmt::format("D = {:.3g} J of joint '{}' is above k A^2 = {:.3g} J, the most that "
                              "a joint of stiffness k can lose. Check units and the shapes.",
                              d.value, joint.name, bound));
  } else if (d.value < kSignificantModal * d.std) {
    add_flag_once(level.flags, "joint_in_noise",
                  fmt::format("D = {:.3g} J of joint '{}' has a standard deviation of {:.3g} J.",
                              d.value, joint.name, d.std));
  }
  const Measured& secant = found.secant_stiffness;
  if (secant.value - kSignificantModal * secant.std > kMostSecant * k) {
    add_flag_once(
        level.flags, "secant_above_stuck",
        fmt::format("k_eq = {:.3g} N/m of joint '{}' is above k = {:.3g} N/m of the stuck "
                    "joint. Check the frequencies of the model and its stiffness.",
                    secant.value, joint.name, k));
  }
}

void flag_energy(ModalLevel& level) {
  const Measured& d = level.dissipation;
  if (d.value < 0.0) {
    add_flag_once(level.flags, kNegativeDissipation,
                  fmt::format("D = {:.3g} J: the input of {:.3g} J is below the linear loss of "
                              "{:.3g} J. Check sign and unit of the force, and the damping of the "
                              "structure.",
                              d.value, level.input_energy, level.linear_dissipation));
  } else if (d.value < kSignificantModal * d.std) {
    add_flag_once(
        level.flags, "dissipation_in_noise",
        fmt::format("D = {:.3g} J has a standard deviation of {:.3g} J.", d.value, d.std));
  }
  auto flag = implausible_value("The structure", kLength, level.displacement.value);
  if (!flag) flag = implausible_value("The structure", kEnergy, d.value);
  if (flag) add_flag_once(level.flags, flag->code, flag->text);
}

void flag_balance(ModalLevel& level) {
  const Measured& difference = level.energy_difference;
  const double rounding = 1e-6 * std::abs(level.input_energy);
  if (std::abs(difference.value) <= std::max(kSignificantModal * difference.std, rounding)) return;
  add_flag_once(
      level.flags, "energies_differ",
      fmt::format("The joints together lose {:.4g} J by their forces and {:.4g} J by the input "
                  "minus the linear loss. Check shapes, frequencies and damping of the model.",
                  level.dissipation.value + difference.value, level.dissipation.value));
}

void flag_frequency(ModalLevel& level, const ModalRecord& record) {
  const double stuck = record.stuck_frequency;
  if (std::abs(level.drive_frequency / stuck - 1.0) > kFarFromStuck) {
    add_flag_once(level.flags, "far_from_mode",
                  fmt::format("{:.5g} Hz is far from {:.5g} Hz of mode {} with stuck joints. Check "
                              "the frequencies of the model, or which mode it is.",
                              level.drive_frequency, stuck, level.mode));
  }
  if (!record.resonance_found) {
    add_flag_once(level.flags, "resonance_not_found",
                  fmt::format("No phase resonance of the response point is near {:.6g} Hz: the "
                              "frequency is that of the drive.",
                              level.drive_frequency));
    return;
  }
  const double off = level.drive_frequency - level.frequency.value;
  const double error =
      std::max(kSignificantModal * level.frequency.std, kSameFrequency * level.drive_frequency);
  if (std::abs(off) <= error) return;
  add_flag_once(
      level.flags, "off_resonance",
      fmt::format("Driven at {:.7g} Hz, {:+.2g} Hz off the resonance, which is known within "
                  "{:.1g} Hz. The frequency is that of the resonance; D and amplitudes "
                  "are as measured.",
                  level.drive_frequency, off, level.frequency.std));
}

void flag_model(ModalLevel& level, const ModalRecord& record) {
  const double most = record.options.most_misfit;
  if (level.misfit <= most) return;
  const auto worst =
      static_cast<std::size_t>(std::ranges::max_element(record.misfit) - record.misfit.begin());
  add_flag_once(
      level.flags, "model_misfit",
      fmt::format("The model leaves {} of channel '{}' unexplained, more than {:.2g} %. Check "
                  "point, sign and unit of the accelerometers, and the modes.",
                  percent_text(level.misfit), record.test.accelerometers[worst].channel,
                  100.0 * most));
}

}  // namespace

void add_flags(ModalLevel& level, const ModalRecord& record) {
  flag_unseen(level, record);
  for (std::size_t j = 0; j < level.joints.size(); ++j) {
    flag_joint(level, j, record.test.structure.joints()[j]);
  }
  flag_energy(level);
  if (!level.has_flag(kJointNotSeen)) flag_balance(level);
  flag_frequency(level, record);
  flag_model(level, record);
  flag_force_distortion(level.flags, level.force_distortion, record.options.most_distortion);
  flag_record(level.flags, record.record, record.options.most_phase);
}

}  // namespace microslip
