// SPDX-License-Identifier: MIT
#include "microslip/calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/calibrate/calibration_reading.hpp"
#include "microslip/calibrate/evidence_chain.hpp"
#include "microslip/calibrate/growing_range.hpp"

namespace microslip {
namespace {

/// Bounds of the frequency of a level over that of its mode with all joints stuck.
constexpr double kLeastFrequencyRatio = 0.2;
constexpr double kMostFrequencyRatio = 2.0;
/// The usual number of passes, for the progress.
constexpr std::size_t kUsualPasses = 40;

void check_sought(const JointedStructure& structure, const std::vector<std::size_t>& sought) {
  if (sought.empty()) {
    throw InputError("number of joints to find", 0.0, "must be 1 or more",
                     "Give a joint of the model a stiffness and no file.");
  }
  for (const std::size_t joint : sought) {
    if (joint < structure.joints().size()) continue;
    throw InputError("index of a joint to find", static_cast<double>(joint),
                     fmt::format("must be below {}", structure.joints().size()));
  }
}

void check_levels_of(const JointedStructure& structure, const std::vector<std::size_t>& sought,
                     const ModalLevels& levels) {
  check_modal_levels(levels);
  const std::size_t fewest = kFewestModalLevels * sought.size();
  const std::size_t count = distinct_levels(levels);
  if (count < fewest) {
    throw InputError("number of levels", static_cast<double>(count),
                     fmt::format("must be {} or more, without repetitions, for {} joint{}", fewest,
                                 sought.size(), sought.size() == 1 ? "" : "s"),
                     "Measure more levels, or more modes.");
  }
  const std::size_t modes = structure.linear().vibrations();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels.mode[i] < modes) continue;
    throw InputError(fmt::format("mode of level {}", i + 1),
                     static_cast<double>(levels.mode[i] + 1),
                     fmt::format("must be from 1 to {}, the modes of the model", modes));
  }
  for (const JointLevels& measured : levels.joints) {
    if (std::ranges::find(structure.joints(), measured.name, &StructuralJoint::name) !=
        structure.joints().end()) {
      continue;
    }
    throw InputError("joint of the levels", measured.name, "must be the name of one in the model");
  }
}

/// A resonance far from that of its mode is of another one, or in another unit.
void check_frequencies(const JointedStructure& structure, const ModalLevels& levels) {
  const std::vector<double> stuck = structure.stuck_frequencies();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double frequency = ModalLevels::value(levels.frequency, i);
    const double expected = stuck[levels.mode[i]] / (2.0 * std::numbers::pi);
    const double ratio = frequency / expected;
    if (std::isnan(frequency) || (ratio > kLeastFrequencyRatio && ratio < kMostFrequencyRatio)) {
      continue;
    }
    throw InputError(fmt::format("frequency of level {}", i + 1), frequency,
                     fmt::format("must be near that of mode {} with all joints stuck, {:.5g} Hz",
                                 levels.mode[i] + 1, expected),
                     "Check the number of the mode, the unit and the model.");
  }
}

/// A joint that stands still in all measured modes cannot be identified.
void check_motion(const JointedStructure& structure, const std::vector<std::size_t>& sought,
                  const ModalLevels& levels) {
  for (const std::size_t j : sought) {
    const StructuralJoint& joint = structure.joints()[j];
    const bool moves = std::ranges::any_of(levels.mode, [&](std::size_t mode) {
      const std::vector<double> q = structure.stuck_mode(mode);
      double u = 0.0;
      double size = 0.0;
      for (std::size_t i = 0; i < q.size(); ++i) {
        u += joint.shape[i] * q[i];
        size += std::abs(joint.shape[i] * q[i]);
      }
      return std::abs(u) > 1e-9 * size;
    });
    if (moves) continue;
    throw InputError(fmt::format("displacement of {}", joint.name), 0.0,
                     "must not be 0 in all modes of the levels",
                     "Measure a mode that exercises this joint.");
  }
}

CalibrationEvidence evidence_of(const JointedStructure& structure, const ModalLevels& levels,
                                const CalibrationOptions& options) {
  CalibrationEvidence evidence{.levels = levels,
                               .frequency = options.frequency,
                               .fit_stiffness = options.fit_stiffness,
                               .stuck_shapes = options.stuck_shapes,
                               .forcing = options.balance.forcing,
                               .column = {},
                               .loss_std_given = true,
                               .frequency_std_given = true};
  for (const StructuralJoint& joint : structure.joints()) {
    const auto same = std::ranges::find(levels.joints, joint.name, &JointLevels::name);
    evidence.column.push_back(same == levels.joints.end()
                                  ? CalibrationEvidence::kNone
                                  : static_cast<std::size_t>(same - levels.joints.begin()));
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    evidence.loss_std_given = evidence.loss_std_given && loss_deviation_known(evidence, i);
    const bool measured = !std::isnan(ModalLevels::value(levels.frequency, i));
    if (measured && !(ModalLevels::value(levels.frequency_std, i) > 0.0)) {
      evidence.frequency_std_given = false;
    }
  }
  return evidence;
}

}  // namespace

CalibrationResult calibrate(const JointedStructure& structure,
                            const std::vector<std::size_t>& sought, const std::string& response,
                            const ModalLevels& levels, const CalibrationOptions& options) {
  Stopwatch watch;
  options.check();
  check_sought(structure, sought);
  check_levels_of(structure, sought, levels);
  check_motion(structure, sought, levels);
  check_frequencies(structure, levels);
  const CalibrationEvidence evidence = evidence_of(structure, levels, options);
  LevelStates states(structure, response, options.balance, levels, options.execution);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (states.shows(levels.mode[i])) continue;
    throw InputError(
        fmt::format("mode of level {}", i + 1), static_cast<double>(levels.mode[i] + 1),
        "must be one that moves the response point", "Measure elsewhere, or leave the mode out.");
  }
  GrowingRange range(evidence, sought, options, states);

  std::size_t done = 0;
  const auto tick = [&] {
    ++done;
    const std::size_t total = std::max(done + 1, kUsualPasses);
    if (options.progress && !options.progress(done, total)) throw Cancelled();
  };
  CalibratedState state = range.find(tick);
  CalibrationResult result;
  result.summary = range.summary();
  result.summary.timings.push_back(watch.lap("joints and their displacements"));
  read_calibration(evidence, options, state, range, states, result);
  result.summary.timings.push_back(watch.lap("draws"));
  if (options.progress) (void)options.progress(done + 1, done + 1);
  result.outliers = loss_outliers(result);
  result.warnings = diagnose(result, levels, options.level_names);
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
