// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/ring_down_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>

#include "microslip/base/codes.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/plausibility.hpp"
#include "microslip/signal/decay/ring_down_reading.hpp"

namespace microslip {
namespace {

void require_positive(std::string_view name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) {
    throw InputError(name, value, "must be above 0 and finite");
  }
}

void check_ratio(double joint_ratio) {
  if (std::isfinite(joint_ratio) && joint_ratio != 0.0) return;
  throw InputError("joint_ratio", joint_ratio, "must be finite and not 0");
}

void check(const RingDownLevelsOptions& options) {
  require_positive("modal_mass", options.modal_mass);
  check_ratio(options.joint_ratio);
  if (!(options.loss_factor >= 0.0 && std::isfinite(options.loss_factor))) {
    throw InputError("loss_factor", options.loss_factor, "must be 0 or more and finite");
  }
  if (options.stick_frequency) require_positive("stick_frequency", *options.stick_frequency);
  if (!options.joint_stiffness) return;
  require_positive("joint_stiffness", *options.joint_stiffness);
  if (!options.stick_frequency) {
    throw InputError("stick_frequency", "none", "must be given with joint_stiffness",
                     "Take it from a test at low level.");
  }
}

/// Windows whose centres are half a window apart, on the mean of their lengths.
std::vector<std::size_t> independent_windows(const RingDown& decay) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < decay.size(); ++i) {
    constexpr double kRounding = 1.0 - 1e-9;
    if (!chosen.empty()) {
      const std::size_t last = chosen.back();
      const double apart = decay.time[i] - decay.time[last];
      if (apart < 0.25 * (decay.window[i] + decay.window[last]) * kRounding) continue;
    }
    chosen.push_back(i);
  }
  return chosen;
}

/// A window that is chosen as a level.
struct ChosenWindow {
  std::size_t index;
  std::string flags;  ///< its own, and those of the windows beside it that are nearer to no other
};

std::vector<ChosenWindow> chosen_windows(const RingDown& decay) {
  std::vector<ChosenWindow> chosen;
  for (const std::size_t i : independent_windows(decay)) chosen.push_back({i, {}});
  if (decay.flags.empty()) return chosen;
  for (std::size_t i = 0; i < decay.size(); ++i) {
    ChosenWindow& nearest = *std::ranges::min_element(chosen, {}, [&](const ChosenWindow& level) {
      return std::abs(decay.time[level.index] - decay.time[i]);
    });
    std::istringstream codes(decay.flags[i]);
    for (std::string code; codes >> code;) add_code(nearest.flags, code);
  }
  return chosen;
}

double stick_omega(const RingDown& decay, const RingDownLevelsOptions& options) {
  const double highest = decay.frequency.empty() ? 0.0 : *std::ranges::max_element(decay.frequency);
  return 2.0 * std::numbers::pi * options.stick_frequency.value_or(highest);
}

void add_secant(const RingDown& decay, std::size_t i, double omega0,
                const RingDownLevelsOptions& options, RingDownLevels& levels) {
  if (!options.joint_stiffness) return;
  const double omega = 2.0 * std::numbers::pi * decay.frequency[i];
  const double scale = options.modal_mass / (options.joint_ratio * options.joint_ratio);
  levels.secant_stiffness.push_back(*options.joint_stiffness +
                                    scale * (omega * omega - omega0 * omega0));
  levels.secant_stiffness_std.push_back(scale * 2.0 * omega * 2.0 * std::numbers::pi *
                                        decay.frequency_std[i]);
}

/// Adds the quantities that need no modal mass.
void add_motion(const RingDown& decay, const ChosenWindow& window, double joint_ratio,
                RingDownLevels& levels) {
  const std::size_t i = window.index;
  levels.amplitude.push_back(std::abs(joint_ratio) * decay.amplitude[i]);
  levels.amplitude_std.push_back(std::abs(joint_ratio) * decay.amplitude_std[i]);
  levels.time.push_back(decay.time[i]);
  levels.frequency.push_back(decay.frequency[i]);
  levels.frequency_std.push_back(decay.frequency_std[i]);
  levels.damping_ratio.push_back(decay.damping_ratio[i]);
  levels.damping_ratio_std.push_back(decay.damping_ratio_std[i]);
  levels.flags.push_back(window.flags);
}

/// One that is not positive shows that k, ω₀, m and the ratio are inconsistent.
void drop_impossible_secants(RingDownLevels& levels) {
  const bool good = std::ranges::all_of(levels.secant_stiffness, [](double k) { return k > 0.0; });
  if (good) return;
  levels.secant_stiffness.clear();
  levels.secant_stiffness_std.clear();
  levels.warnings.push_back(
      {"secant_not_positive",
       "The change of frequency exceeds the joint's stiffness: no secant stiffness is "
       "given. Check joint_stiffness, stick_frequency, joint_ratio and modal_mass."});
}

}  // namespace

RingDownLevels levels_of(const RingDown& decay, const RingDownLevelsOptions& options) {
  check(options);
  const double omega0 = stick_omega(decay, options);
  const double m = options.modal_mass;
  const double linear = std::numbers::pi * options.loss_factor * m * omega0 * omega0;
  RingDownLevels levels;
  std::size_t left_out = 0;
  for (const ChosenWindow& window : chosen_windows(decay)) {
    const std::size_t i = window.index;
    const double a = decay.amplitude[i];
    const double d = m * decay.loss[i] - linear * a * a;
    if (!(d > 0.0)) {
      ++left_out;
      continue;
    }
    add_motion(decay, window, options.joint_ratio, levels);
    levels.dissipation.push_back(d);
    // The subtracted loss has little scatter of its own: that of A² against that of ζ.
    levels.dissipation_std.push_back(m * decay.loss_std[i]);
    add_secant(decay, i, omega0, options, levels);
  }
  drop_impossible_secants(levels);
  warn_of_implausible("The largest amplitude", kLength, levels.amplitude, levels.warnings);
  warn_of_implausible("The largest dissipation", kEnergy, levels.dissipation, levels.warnings);
  if (left_out > 0) {
    levels.warnings.push_back(
        {"linear_loss_exceeds_all",
         fmt::format("{} levels are left out: the linear loss of loss_factor {:g} exceeds their "
                     "whole loss. Check loss_factor.",
                     left_out, options.loss_factor)});
  }
  return levels;
}

RingDownLevels damping_levels_of(const RingDown& decay, double joint_ratio) {
  check_ratio(joint_ratio);
  RingDownLevels levels;
  for (const ChosenWindow& window : chosen_windows(decay)) {
    add_motion(decay, window, joint_ratio, levels);
  }
  return levels;
}

}  // namespace microslip
