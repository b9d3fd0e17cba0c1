// SPDX-License-Identifier: MIT
#include "microslip/ensemble/rig_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/rig/virtual_test/virtual_record.hpp"
#include "microslip/workflow/measure/measurement_run.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"

namespace microslip {
namespace {

/// Channels that can be chosen.
std::vector<std::string> channels_of(const Rig& rig) {
  std::vector<std::string> channels;
  for (const RigSensor& sensor : rig.accelerometers) channels.push_back(sensor.channel);
  if (rig.vibrometer) channels.push_back(rig.vibrometer->channel);
  return channels;
}

/// The rig as it is known to somebody with these sensors alone.
Rig with_sensors(Rig rig, const std::vector<std::string>& chosen) {
  const auto is_left_out = [&](const std::string& channel) {
    return std::ranges::find(chosen, channel) == chosen.end();
  };
  std::erase_if(rig.accelerometers,
                [&](const RigSensor& sensor) { return is_left_out(sensor.channel); });
  if (rig.vibrometer && is_left_out(rig.vibrometer->channel)) rig.vibrometer.reset();
  return rig;
}

/// Errors found only by solving the rig name its file.
InputError of_file(const InputError& error, const std::string& file) {
  return error.renamed(fmt::format("{}: {}", input_name(file), rig_key(error.name())));
}

}  // namespace

RigTests::RigTests(const DesignPlan& design, const std::string& plan)
    : file_(design.rig),
      rig_(read_rig(design.rig)),
      files_{design.rig, true_joint_path(rig_, design.rig)},
      truth_(read_joint(files_.back())) {
  if (!rig_.test) {
    throw InputError(input_name(file_) + ": test", "none", "must be given for virtual tests",
                     "Add the section [test].");
  }
  const bool scaled =
      std::ranges::any_of(design.sensor_noise, [](double factor) { return factor != 1.0; });
  if (scaled && !rig_.noise) {
    throw InputError(fmt::format("{}: design.sensor_noise", plan), "factors",
                     "must have a noise of the rig to scale",
                     "Add the section [noise] to the rig.");
  }
  make_reducers(design, plan);
  try {
    measure(design);
  } catch (const InputError& error) {
    throw of_file(error, file_);
  }
}

void RigTests::make_reducers(const DesignPlan& design, const std::string& plan) {
  const std::vector<std::string> channels = channels_of(rig_);
  const std::vector<std::vector<std::string>> choices =
      design.sensors.empty() ? std::vector<std::vector<std::string>>{channels} : design.sensors;
  for (std::size_t s = 0; s < choices.size(); ++s) {
    for (const std::string& channel : choices[s]) {
      if (std::ranges::find(channels, channel) != channels.end()) continue;
      throw InputError(fmt::format("{}: design.sensors[{}]", plan, s), in_quotes(channel),
                       fmt::format("must be one of {}", fmt::join(channels, ", ")));
    }
    try {
      reducers_.emplace_back(with_sensors(rig_, choices[s]));
    } catch (const InputError& error) {
      if (design.sensors.empty()) throw of_file(error, file_);
      throw error.renamed(fmt::format("{}: design.sensors[{}]: {}", plan, s, error.name()));
    }
  }
  if (stiffness() > 0.0) return;
  throw InputError(input_name(file_) + ": contact.stiffness_N_per_m", "none",
                   "must be known to identify a density");
}

void RigTests::measure(const DesignPlan& design) {
  VirtualMeasurementOptions options{.shaker = false};
  options.linear_damping = identified_damping(truth_).value_or(0.0);
  options.execution = Execution::serial();  // other ranks do the same
  state_ = stick_state(rig_, rig_.test->modes);
  lowest_ = std::numeric_limits<double>::infinity();
  for (const std::size_t levels : design.levels) {
    Rig rig = rig_;
    rig.test->count = levels;
    tests_.push_back(measure_virtually(rig, truth_.joint, options));
    for (const VirtualLevel& level : tests_.back().levels) {
      if (!level.summary.converged()) {
        throw InputError(fmt::format("level {} of {}", level.number, levels), "not converged",
                         fmt::format("must have a vibration: {}", level.summary.reason));
      }
      const double amplitude = level.controlled.vibration.joints.front().amplitude;
      lowest_ = std::min(lowest_, amplitude);
      highest_ = std::max(highest_, amplitude);
      for (const Warning& warning : level.warnings) {
        if (std::ranges::find(warnings_, warning.code, &Warning::code) != warnings_.end()) continue;
        warnings_.push_back(
            {warning.code, fmt::format("Level {} of {}: {}", level.number, levels, warning.text)});
      }
    }
  }
}

Levels RigTests::levels(std::size_t levels, double noise, std::size_t sensors,
                        std::uint64_t seed) const {
  // All sensors record, whichever are used: those chosen have the same noise in each choice.
  Rig rig = rig_;
  if (rig.noise) {
    for (double* std : {&rig.noise->force, &rig.noise->acceleration, &rig.noise->vibrometer}) {
      *std *= noise;
    }
  }
  std::vector<ReducedLevel> reduced;
  for (const VirtualLevel& level : tests_[levels].levels) {
    Recording record = virtual_record(rig, state_, level.controlled, seed, record_number(level));
    record.source = fmt::format("level {}", level.number);
    ReducedLevel found = reducers_[sensors].reduce(record);
    if (found.dissipation.value > 0.0 && !found.has_flag(kInnerReversals)) {
      reduced.push_back(std::move(found));
    }
  }
  if (reduced.empty()) {
    throw InputError("levels", "none", "must include one whose dissipation is above noise");
  }
  return measured_levels(reduced).levels;
}

}  // namespace microslip
