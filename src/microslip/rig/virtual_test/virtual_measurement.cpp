// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/virtual_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/requirement.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/rig/virtual_test/force_control.hpp"
#include "microslip/rig/virtual_test/shaken_structure.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

constexpr double kWholeTurn = 2.0 * std::numbers::pi;
constexpr double kCycles = 3.0;     // of a record at least
constexpr double kCoarsest = 0.01;  // resolution of the drive over the stuck resonance
/// Voltage of a harmonic over the fundamental for the measurement of H: its force then compares
/// with that of the fundamental, which is small at resonance.
constexpr double kProbe = 0.005;

const RigTest& test_of(const Rig& rig) {
  if (rig.test) return *rig.test;
  throw InputError("test", "none", "must be given for a virtual test",
                   "Add a test with its responses, sampling rate and duration.");
}

void check_options(const VirtualMeasurementOptions& options) {
  require(options.controlled_harmonics >= 2 && options.controlled_harmonics <= 100,
          "controlled_harmonics", static_cast<double>(options.controlled_harmonics),
          "must be from 2 to 100");
  require(options.force_distortion > 0.0, "force_distortion", options.force_distortion,
          "must be above 0");
  require(options.max_control_iterations >= 0, "max_control_iterations",
          options.max_control_iterations, "must be 0 or more");
}

/// Given modes can have a node of them all there, a beam cannot.
void check_exciter(const StickState& state) {
  if (std::ranges::any_of(state.excitation, [](double shape) { return shape != 0.0; })) return;
  throw InputError("modes.excitation", 0.0, "must differ from 0 in one mode at least",
                   "At a node of all modes the exciter moves nothing.");
}

/// @param of  what has the frequency, for the message.
void check_sampling_rate(const RigTest& test, double frequency, std::size_t harmonics,
                         std::string_view of) {
  const double least = 2.0 * static_cast<double>(harmonics) * frequency;
  if (test.sampling_rate > least) return;
  throw InputError("test.sampling_rate", test.sampling_rate,
                   fmt::format("must be above {:.0f}: twice harmonic {} of {}, {:.1f} Hz", least,
                               harmonics, of, frequency),
                   "Slower sampling would alias the high harmonics.");
}

/// Checks against the stuck resonance, Hz.
void check_test(const RigTest& test, double frequency, std::size_t harmonics) {
  check_sampling_rate(test, frequency, harmonics, "the stuck resonance");
  if (test.duration * frequency < kCycles) {
    throw InputError("test.duration", test.duration,
                     fmt::format("must be at least {:.3g}: {:.0f} cycles of the stuck resonance, "
                                 "{:.3g} Hz",
                                 kCycles / frequency, kCycles, frequency),
                     "Record longer, or check the units of the beam.");
  }
  if (test.frequency_resolution > kCoarsest * frequency) {
    throw InputError("test.frequency_resolution", test.frequency_resolution,
                     fmt::format("must be at most {:.3g}: {:.0f} % of the stuck resonance, {:.1f} "
                                 "Hz",
                                 kCoarsest * frequency, 100.0 * kCoarsest, frequency),
                     "A coarser drive would not be at resonance.");
  }
}

/// The multiple of the resolution next to a frequency; of 0.1 Hz per decimal, not its 0.1-fold.
double to_resolution(double frequency, double resolution) {
  if (!(resolution > 0.0)) return frequency;
  const double steps = std::max(std::round(frequency / resolution), 1.0);
  const double per_hertz = std::round(1.0 / resolution);
  const bool decimal = std::abs(per_hertz * resolution - 1.0) < 1e-12;
  return decimal ? steps / per_hertz : steps * resolution;
}

/// Data common to all levels.
struct Setup {
  const VirtualMeasurementOptions& options;
  const RigInMotion& motion;
  RigShaker shaker;
  double stuck_frequency;  // Hz
  VectorXcd transfer;      // H_2 … H_N, N/V
};

/// Harmonics 2 … N of a force, N.
VectorXcd seen(const Setup& setup, const ShakenStructure::Outcome& state) {
  const auto count = static_cast<Index>(setup.options.controlled_harmonics) - 1;
  return state.force.head(count) * state.driven.vibration.force_amplitude;
}

VectorXcd generator_of(const Setup& setup, const VectorXcd& voltage) {
  VectorXcd generator = VectorXcd::Zero(static_cast<Index>(setup.motion.harmonics()) - 1);
  generator.head(voltage.size()) = voltage;
  return generator;
}

ShakenStructure shaken(const Setup& setup, const VirtualLevel& level) {
  return {setup.motion, setup.shaker, kWholeTurn * level.frequency, level.response,
          level.controlled.vibration};
}

/// H by small voltages in all harmonics at once: the structure is next to linear at the lowest
/// level. None where a vibration is not found, or a harmonic has no response.
std::optional<VectorXcd> measured_transfer(const Setup& setup, ShakenStructure& structure) {
  const auto count = static_cast<Index>(setup.options.controlled_harmonics) - 1;
  const ShakenStructure::Outcome at_rest =
      structure.settle(generator_of(setup, VectorXcd::Zero(count)));
  if (!at_rest.summary.converged()) return std::nullopt;
  const double probe = kProbe * at_rest.drive;
  const ShakenStructure::Outcome probed =
      structure.settle(generator_of(setup, VectorXcd::Constant(count, probe)));
  if (!probed.summary.converged()) return std::nullopt;
  VectorXcd transfer = (seen(setup, probed) - seen(setup, at_rest)) / probe;
  const bool usable = transfer.allFinite() && transfer.cwiseAbs().minCoeff() > 0.0;
  return usable ? std::optional(std::move(transfer)) : std::nullopt;
}

/// H as measured at a level, or else as the linear structure has it.
VectorXcd transfer_at(const Setup& setup, VirtualLevel& level) {
  ShakenStructure structure = shaken(setup, level);
  if (std::optional<VectorXcd> measured = measured_transfer(setup, structure)) return *measured;
  level.warnings.push_back(
      {std::string(kTransferNotMeasured),
       fmt::format("level {}: the transfer function from voltage to force could not be measured; "
                   "the force control of all levels begins with that of the linear structure",
                   level.number)});
  const auto count = static_cast<Index>(setup.options.controlled_harmonics) - 1;
  return structure.linear_transfer().head(count);
}

void add_iterations(Summary& sum, const Summary& more) {
  sum.stop = more.stop;
  sum.reason = more.reason;
  sum.residual = std::max(sum.residual, more.residual);
  sum.iterations += more.iterations;
}

void control_force(const Setup& setup, VirtualLevel& level) {
  ShakenStructure structure = shaken(setup, level);
  ForceController controller(setup.transfer);
  ShakenStructure::Outcome state = structure.settle(generator_of(setup, controller.voltage()));
  add_iterations(level.summary, state.summary);
  level.uncontrolled = state.driven;
  const auto distortion = [&] {
    return force_distortion(state.driven, setup.options.controlled_harmonics);
  };
  while (level.summary.converged() && distortion() > setup.options.force_distortion &&
         level.control_iterations < setup.options.max_control_iterations) {
    state = structure.settle(generator_of(setup, controller.step(seen(setup, state))));
    add_iterations(level.summary, state.summary);
    ++level.control_iterations;
  }
  level.controlled = state.driven;
  if (!level.summary.converged() || distortion() <= setup.options.force_distortion) return;
  level.warnings.push_back(
      {std::string(kForceNotControlled),
       fmt::format("level {}: after {} steps of the force control a harmonic of the force is {} "
                   "of the first, above {:.2g} %",
                   level.number, level.control_iterations, percent_text(distortion()),
                   100.0 * setup.options.force_distortion)});
}

void drive_purely(const Setup& setup, VirtualLevel& level) {
  VibrationResult result = setup.motion.balance().solve(
      {Quantity::kAngularFrequency, kWholeTurn * level.frequency},
      {Quantity::kResponse, level.response}, level.controlled.vibration);
  result.summary.iterations = 1;  // balances
  add_iterations(level.summary, result.summary);
  level.controlled.vibration = std::move(result.vibration);
  level.controlled.force.assign(setup.motion.harmonics() + 1, 0.0);
  level.controlled.force[1] = level.controlled.vibration.force_amplitude;
}

void warn_of_macro_slip(const Joint& joint, VirtualLevel& level) {
  const double amplitude = level.controlled.vibration.joints[0].amplitude;
  const double all_slip = joint.density().largest_slip_force() / joint.stiffness();
  if (amplitude < all_slip) return;
  level.warnings.push_back({std::string(kMacroSlip),
                            fmt::format("level {}: the joint moves {:.3g} m; from {:.3g} m on all "
                                        "sliders slip, and D(A) determines no more of the "
                                        "density",
                                        level.number, amplitude, all_slip)});
}

void solve_level(const Setup& setup, const Joint& joint, VirtualLevel& level) {
  if (!level.summary.converged()) return;  // no resonance
  if (setup.options.shaker) {
    control_force(setup, level);
  } else {
    drive_purely(setup, level);
  }
  if (!level.summary.converged()) return;
  warn_of_macro_slip(joint, level);
}

/// The responses of the levels from `first` on, with others between them where they are far apart:
/// a long step on the backbone may end at an antiresonance, which has the same phase.
struct Climb {
  Climb(const std::vector<VirtualLevel>& levels, std::size_t first) {
    constexpr double kRatio = 1.25;
    for (std::size_t i = first; i < levels.size(); ++i) {
      const double to = levels[i].response;
      while (!responses.empty() && kRatio * responses.back() < to) {
        responses.push_back(kRatio * responses.back());
        level.push_back(i);
      }
      responses.push_back(to);
      level.push_back(i);
    }
  }

  std::vector<double> responses;
  std::vector<std::size_t> level;  // that a response leads to
};

void set_resonance(const Setup& setup, const RigTest& test, SteadyVibration vibration,
                   VirtualLevel& level) {
  // The shortening stiffens a little; slip softens.
  constexpr double kAboveStuck = 1.05;
  level.resonance_frequency = vibration.frequency();
  level.frequency = to_resolution(level.resonance_frequency, test.frequency_resolution);
  level.controlled.vibration = std::move(vibration);
  level.summary.stop = Stop::kConverged;
  if (level.resonance_frequency <= kAboveStuck * setup.stuck_frequency) return;
  level.summary.stop = Stop::kNoProgress;
  level.summary.reason = fmt::format(
      "no resonance at this response: phase resonance is at {:.4g} Hz, that of the stuck "
      "joint at {:.4g} Hz",
      level.resonance_frequency, setup.stuck_frequency);
}

/// Whether a point of a curve that did not converge is one of it: the last may be where it failed.
bool is_resonance(const Setup& setup, const SteadyVibration& point) {
  return setup.motion.balance()
      .solve({Quantity::kPhaseLag, kWholeTurn / 4.0}, {Quantity::kResponse, point.response}, point)
      .summary.converged();
}

/// The backbone at the levels from `first` on, as far as it goes; returns the level after it.
std::size_t find_resonances(const Setup& setup, const RigTest& test, std::size_t first,
                            std::vector<VirtualLevel>& levels) {
  const Climb climb(levels, first);
  ResponseCurve curve = setup.motion.balance().backbone(climb.responses);
  std::size_t reached = curve.points.size();
  if (!curve.summary.converged() && reached > 0) {
    reached -= is_resonance(setup, curve.points.back()) ? 0 : 1;
  }
  for (std::size_t p = 0; p < reached; ++p) {
    VirtualLevel& level = levels[climb.level[p]];
    if (climb.responses[p] != level.response) continue;
    set_resonance(setup, test, std::move(curve.points[p]), level);
    if (!level.summary.converged()) return level.number;
  }
  if (reached == climb.responses.size()) return levels.size();
  VirtualLevel& level = levels[climb.level[reached]];
  level.summary.stop = Stop::kNoProgress;
  level.summary.reason = "no resonance: " + curve.summary.reason;
  return level.number;
}

/// All resonances that can be found. Above two levels in succession without one there are no more.
void find_resonances(const Setup& setup, const RigTest& test, std::vector<VirtualLevel>& levels) {
  std::size_t i = 0;
  while (i < levels.size()) {
    const std::size_t first = i;
    i = find_resonances(setup, test, first, levels);
    if (i != first + 1 || first == 0 || levels[first - 1].summary.converged()) continue;
    for (; i < levels.size(); ++i) {
      levels[i].summary.stop = Stop::kNotRun;
      levels[i].summary.reason = "not tried: two levels before it have no resonance";
    }
  }
}

/// Slip lowers the frequency of a drive; its resolution and the shortening may raise it.
void check_drives(const RigTest& test, std::size_t harmonics,
                  const std::vector<VirtualLevel>& levels) {
  const VirtualLevel* highest = nullptr;
  for (const VirtualLevel& level : levels) {
    if (!level.summary.converged()) continue;
    if (!highest || level.frequency > highest->frequency) highest = &level;
  }
  if (!highest) return;
  check_sampling_rate(test, highest->frequency, harmonics,
                      fmt::format("the drive of level {}", highest->number));
}

/// Levels in parallel, with progress after each.
void solve_levels(const Setup& setup, const Joint& joint, std::vector<VirtualLevel>& levels) {
  setup.options.execution.for_each(
      levels.size(), [&](std::size_t i) { solve_level(setup, joint, levels[i]); },
      setup.options.progress);
}

void summarise(VirtualMeasurement& test) {
  Summary& s = test.summary;
  std::size_t found = 0;
  const VirtualLevel* missing = nullptr;
  for (const VirtualLevel& level : test.levels) {
    s.iterations += level.summary.iterations;
    s.residual = std::max(s.residual, level.summary.residual);
    found += level.summary.converged() ? 1 : 0;
    if (!level.summary.converged() && !missing) missing = &level;
  }
  s.stop = missing ? Stop::kIncomplete : Stop::kConverged;
  s.reason = missing ? fmt::format("{} of {} levels found; level {}, {:.4g} m/s^2: {}", found,
                                   test.levels.size(), missing->number, missing->response,
                                   missing->summary.reason)
                     : "all levels found";
}

std::vector<VirtualLevel> levels_to_find(const RigTest& test) {
  std::vector<VirtualLevel> levels;
  for (const double response : response_levels(test)) {
    VirtualLevel& level = levels.emplace_back();
    level.number = levels.size();
    level.response = response;
    level.summary.method = "virtual level";
  }
  return levels;
}

}  // namespace

std::vector<double> response_levels(const RigTest& test) {
  std::vector<double> responses;
  for (std::size_t i = 0; i < test.count; ++i) {
    const double share =
        i == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(test.count - 1);
    responses.push_back(test.logarithmic
                            ? test.response_from *
                                  std::pow(test.response_to / test.response_from, share)
                            : test.response_from + share * (test.response_to - test.response_from));
  }
  return responses;
}

VirtualMeasurement measure_virtually(const Rig& rig, const Joint& joint,
                                     const VirtualMeasurementOptions& options) {
  const Stopwatch watch;
  const RigTest& test = test_of(rig);
  check_options(options);
  const StickState state = stick_state(rig, test.modes);
  check_exciter(state);
  const std::size_t harmonics =
      options.shaker ? std::max(test.harmonics, options.controlled_harmonics) : test.harmonics;
  const double stuck_frequency = natural_frequency(state, 0.0);
  check_test(test, stuck_frequency, harmonics);
  const RigInMotion motion(rig, state, joint, {.harmonics = harmonics, .samples = options.samples},
                           options.linear_damping);
  Setup setup{options, motion, rig.shaker.value_or(RigShaker{}), stuck_frequency, {}};

  VirtualMeasurement result;
  result.levels = levels_to_find(test);
  find_resonances(setup, test, result.levels);
  check_drives(test, harmonics, result.levels);
  const auto lowest = std::ranges::find_if(
      result.levels, [](const VirtualLevel& level) { return level.summary.converged(); });
  if (options.shaker && lowest != result.levels.end()) {
    setup.transfer = transfer_at(setup, *lowest);
  }
  solve_levels(setup, joint, result.levels);
  summarise(result);
  result.summary.method = "virtual test";
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
