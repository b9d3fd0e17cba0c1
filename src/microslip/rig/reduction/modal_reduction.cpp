// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/modal_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/fitted_record.hpp"
#include "microslip/rig/reduction/modal_cycle.hpp"
#include "microslip/rig/reduction/modal_level_flags.hpp"
#include "microslip/rig/reduction/parallel_records.hpp"
#include "microslip/rig/reduction/record_flags.hpp"
#include "microslip/signal/harmonic/cycle_scatter.hpp"
#include "microslip/signal/harmonic/signal_quality.hpp"

namespace microslip {
namespace {

using CycleQuantity = std::function<double(const ModalCycle&)>;

// ---- What a record must have. ----

/// The only channel of a force over time.
std::string only_force(const Recording& recording) {
  std::vector<std::string> found;
  for (const Channel& channel : recording.channels) {
    if (channel.dimension == kForce) found.push_back(channel.name);
  }
  if (found.size() == 1) return found.front();
  throw InputError(fmt::format("{}: channel of the force", recording.source),
                   InputState{found.empty() ? "missing" : "there several times"},
                   "must be the only one of a force, or be named",
                   fmt::format("The channels are {}.", names_of_channels(recording)));
}

RecordSignals modal_signals(const Recording& recording, const StructureTest& test) {
  RecordSignals signals;
  signals.add(recording, test.force_channel.empty() ? only_force(recording) : test.force_channel,
              kForce);
  for (const PointSensor& sensor : test.accelerometers) {
    signals.add(recording, sensor.channel, kAcceleration);
  }
  return signals;
}

void check_test(const StructureTest& test) {
  const ModalModel& linear = test.structure.linear();
  (void)linear.shape(test.response);  // throws where there is none
  for (auto sensor = test.accelerometers.begin(); sensor != test.accelerometers.end(); ++sensor) {
    (void)linear.shape(sensor->point);
    const auto same =
        std::find_if(test.accelerometers.begin(), sensor,
                     [&](const PointSensor& other) { return other.channel == sensor->channel; });
    if (same == sensor && sensor->channel != test.force_channel) continue;
    throw InputError("channel of an accelerometer", sensor->channel,
                     "must differ from those of the other sensors");
  }
}

void check_modal_options(const ModalReductionOptions& options, std::size_t modes) {
  const auto require = [](std::string_view name, double value) {
    if (!(value > 0.0)) throw InputError(name, value, "must be above 0");
  };
  require("most_distortion", options.most_distortion);
  require("most_misfit", options.most_misfit);
  require("most_phase", options.most_phase);
  if (!options.mode || (*options.mode >= 1 && *options.mode <= modes)) return;
  throw InputError("mode", static_cast<double>(*options.mode),
                   fmt::format("must be from 1 to {}, the modes of the model", modes));
}

// ---- How much the joints can do. ----

std::size_t nearest_mode(const std::vector<double>& stuck, double frequency) {
  const auto nearest =
      std::ranges::min_element(stuck, {}, [&](double mode) { return std::abs(mode - frequency); });
  return static_cast<std::size_t>(nearest - stuck.begin());
}

/// The forces of the stuck joints in a mode with the amplitude that the accelerometers show. The
/// shape of a slipping structure differs, so that a joint at rest in this one may have a force.
std::vector<double> joint_forces(const StructureTest& test, std::size_t mode,
                                 const FourierFit& fit) {
  constexpr double kStill = 1e-4;
  constexpr double kLeastShare = 0.1;
  const std::vector<double> shape = test.structure.stuck_mode(mode);
  const auto moved = [&](std::span<const double> place) {
    double sum = 0.0;
    for (std::size_t i = 0; i < shape.size(); ++i) sum += place[i] * shape[i];
    return sum;
  };
  std::complex<double> match = 0.0;
  double size = 0.0;
  double whole = 0.0;
  for (std::size_t s = 0; s < test.accelerometers.size(); ++s) {
    const auto place = test.structure.linear().shape(test.accelerometers[s].point);
    const double there = moved(place);
    match -= there * fit.series[1 + s].c(1) / (fit.omega * fit.omega);
    size += there * there;
    for (const double value : place) whole += value * value;
  }
  if (!(size > kStill * kStill * whole)) {
    throw InputError("accelerometers", fmt::format("all at nodes of mode {}", mode + 1),
                     "must include one that the mode moves");
  }
  const double amplitude = std::abs(match) / size;
  std::vector<double> forces;
  for (const StructuralJoint& joint : test.structure.joints()) {
    forces.push_back(joint.stuck_stiffness() * std::abs(moved(joint.shape)) * amplitude);
  }
  const double least = kLeastShare * *std::ranges::max_element(forces);
  for (double& force : forces) force = std::max(force, least);
  return forces;
}

// ---- Standard deviations. ----

/// Standard deviation by the noise of each coefficient of the first harmonic.
double noise_std(const ModalCycleReduction& reduction, const FourierFit& fit,
                 const CycleQuantity& quantity, double value) {
  double square = 0.0;
  std::vector<FourierSeries> series = fit.series;
  for (std::size_t j = 0; j < series.size(); ++j) {
    for (const std::complex<double> step : {std::complex(1.0, 0.0), std::complex(0.0, 1.0)}) {
      series[j].harmonic[0] += fit.harmonic_std[j][0] * step;
      const double change = quantity(reduction.reduce(series)) - value;
      square += change * change;
      series[j] = fit.series[j];
    }
  }
  return std::sqrt(square);
}

/// Standard deviation by unobserved directions: both phases of each are half of its variance.
double unseen_std(const ModalCycleReduction& reduction, const FourierFit& fit,
                  const CycleQuantity& quantity, double value) {
  double square = 0.0;
  for (std::size_t d = 0; d < reduction.observer().unseen().size(); ++d) {
    for (const double phase : {0.0, 0.5 * std::numbers::pi}) {
      const double change = quantity(reduction.reduce_with(fit.series, d, phase)) - value;
      square += 0.5 * change * change;
    }
  }
  return std::sqrt(square);
}

/// The record reduced, whole and by cycles.
struct ModalAnalysis {
  FittedRecord record;
  ModalCycleReduction reduction;
  ModalCycle whole;
  std::vector<ModalCycle> each;

  [[nodiscard]] Measured measured(const CycleQuantity& quantity) const {
    const double value = quantity(whole);
    std::vector<double> values;
    for (const ModalCycle& cycle : each) values.push_back(quantity(cycle));
    double std = values.empty() ? std::nan("") : scatter(values).standard_error;
    if (!std::isfinite(std)) std = noise_std(reduction, record.fit, quantity, value);
    return {value, std::hypot(std, unseen_std(reduction, record.fit, quantity, value))};
  }
};

// ---- The level. ----

JointLevel joint_level(const ModalAnalysis& analysis, std::size_t j) {
  JointLevel level;
  level.amplitude =
      analysis.measured([j](const ModalCycle& cycle) { return cycle.joints[j].amplitude; });
  level.dissipation =
      analysis.measured([j](const ModalCycle& cycle) { return cycle.joints[j].dissipation; });
  level.secant_stiffness =
      analysis.measured([j](const ModalCycle& cycle) { return cycle.joints[j].secant_stiffness; });
  const JointsObserver& observer = analysis.reduction.observer();
  level.reversals =
      reversals(analysis.whole.motion.displacement[j], observer.displacement_std(j)).count();
  double square = 0.0;
  for (const UnseenDirection& direction : observer.unseen()) {
    if (direction.harmonic == 1) square += direction.participant[j] * direction.participant[j];
  }
  level.unseen = std::min(1.0, std::sqrt(square));
  return level;
}

/// The frequency of the drive where there is no phase resonance. That of the drive is common to all
/// cycles, so that its error is in none of them.
Measured resonance_of(const ModalAnalysis& analysis) {
  const double drive = analysis.record.fit.frequency();
  const double drive_std = analysis.record.fit.omega_std / (2.0 * std::numbers::pi);
  if (!analysis.whole.resonance) return {drive, drive_std};
  Measured found = analysis.measured(
      [drive](const ModalCycle& cycle) { return cycle.resonance.value_or(drive); });
  found.std = std::hypot(found.std, drive_std);
  return found;
}

void require_finite(const ModalLevel& level) {
  const auto finite = [](const JointLevel& joint) {
    return std::isfinite(joint.amplitude.value) && std::isfinite(joint.dissipation.value) &&
           std::isfinite(joint.secant_stiffness.value);
  };
  if (std::ranges::all_of(level.joints, finite) && std::isfinite(level.dissipation.value)) return;
  throw InputError(level.source + ": motion of the joints", "not finite", "must be finite",
                   "Check the shapes and frequencies of the model.");
}

}  // namespace

ModalReducer::ModalReducer(StructureTest test, ModalReductionOptions options)
    : test_(std::move(test)),
      options_(options),
      stuck_frequencies_(test_.structure.stuck_frequencies()) {
  for (double& frequency : stuck_frequencies_) frequency /= 2.0 * std::numbers::pi;
  check_test(test_);
  check_modal_options(options_, stuck_frequencies_.size());
  check_observable(test_.structure, test_.accelerometers.size());
}

ModalLevel ModalReducer::reduce(const Recording& recording) const {
  check_recording(recording);
  FittedRecord record = fit_record(recording, modal_signals(recording, test_), options_.fit);
  const FourierFit& fit = record.fit;
  const std::size_t mode =
      options_.mode ? *options_.mode - 1 : nearest_mode(stuck_frequencies_, fit.frequency());
  JointsObserverScales scales{fit.harmonic_std[0],
                              {fit.harmonic_std.begin() + 1, fit.harmonic_std.end()},
                              joint_forces(test_, mode, fit)};
  ModalCycleReduction reduction(test_, fit.omega, fit.order(), scales);
  ModalCycle whole = reduction.reduce(fit.series);
  std::vector<ModalCycle> each;
  for (const auto& cycle : record.cycles.block) each.push_back(reduction.reduce(cycle));
  const ModalAnalysis analysis{std::move(record), std::move(reduction), std::move(whole),
                               std::move(each)};

  const ModalCycle& cycle = analysis.whole;
  const FourierSeries& force = analysis.record.fit.series[0];
  ModalLevel level{
      .source = recording.source,
      .mode = mode + 1,
      .drive_frequency = analysis.record.fit.frequency(),
      .force_amplitude = std::abs(force.c(1)),
      .input_energy = cycle.input_energy,
      .linear_dissipation = cycle.linear_dissipation,
      .force_distortion = force_distortion_of(force, analysis.record.fit.harmonic_std[0]),
      .misfit = *std::ranges::max_element(cycle.motion.misfit),
      .cycles = analysis.record.fit.cycles};
  level.displacement = analysis.measured(std::mem_fn(&ModalCycle::displacement));
  level.frequency = resonance_of(analysis);
  level.dissipation = analysis.measured(std::mem_fn(&ModalCycle::dissipation));
  level.energy_difference = analysis.measured(std::mem_fn(&ModalCycle::energy_difference));
  for (std::size_t j = 0; j < cycle.joints.size(); ++j) {
    level.joints.push_back(joint_level(analysis, j));
  }
  require_finite(level);
  add_flags(level,
            {analysis.record, analysis.reduction.observer(), cycle.motion.misfit,
             cycle.resonance.has_value(), test_, options_, stuck_frequencies_[level.mode - 1]});
  return level;
}

ModalReductionBatch reduce_batch(const ModalReducer& reducer, std::size_t count,
                                 const RecordReader& read, const RecordBatchOptions& options) {
  ModalReductionBatch batch;
  batch.rejected = work_on_records(
      count, read, [&](const Recording& recording) { return reducer.reduce(recording); }, options,
      batch.levels);
  return batch;
}

}  // namespace microslip
