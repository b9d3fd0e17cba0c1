// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/load_synthesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr double kTimesAPeriod = 256.0;        // a chord lies 8e-5 of the amplitude beside the sine
constexpr double kTimesAPulse = 200.0;         // 3e-5 of a half-sine
constexpr double kTimesAPeriodOfNoise = 32.0;  // 5e-3 at the highest frequency, less below
constexpr double kTimesAPeriodOfShock = 20.0;  // 1e-2; the spectrum is that of the chords
constexpr double kLeastTimes = 8.0;            // in a period or pulse
constexpr double kRounding = 1e-12;
/// Of the imaginary part of a harmonic that has no phase but 0 or π.
constexpr double kNoPhase = 1e-9;

/// Times in a second that a shape takes at `number` in its period or pulse.
double rate_of(const JointedStructure& structure, const LoadPlan& plan, double number) {
  switch (plan.shape) {
    case LoadShape::kSine:
      return number * plan.frequency * static_cast<double>(structure.excited_harmonics());
    case LoadShape::kSweep:
      return number * std::max(plan.frequency, plan.last_frequency);
    case LoadShape::kHalfSine:
      return number / plan.pulse;
    case LoadShape::kShock:
      return number * plan.required.frequency.back();
    case LoadShape::kNoise:
      break;
  }
  return number * plan.density.frequency.back();
}

double usual_times(LoadShape shape) {
  switch (shape) {
    case LoadShape::kSine:
    case LoadShape::kSweep:
      return kTimesAPeriod;
    case LoadShape::kHalfSine:
      return kTimesAPulse;
    case LoadShape::kShock:
      return kTimesAPeriodOfShock;
    case LoadShape::kNoise:
      break;
  }
  return kTimesAPeriodOfNoise;
}

/// Whether the function of a shape checks the sampling rate itself.
bool checks_rate(LoadShape shape) {
  return shape == LoadShape::kNoise || shape == LoadShape::kShock;
}

/// Chosen so that the duration is a whole number of steps.
double sampling_rate_of(const JointedStructure& structure, const LoadPlan& plan) {
  if (plan.sampling_rate > 0.0) {
    const double least = rate_of(structure, plan, kLeastTimes);
    if (checks_rate(plan.shape) || plan.sampling_rate >= least) return plan.sampling_rate;
    throw InputError("sampling rate", plan.sampling_rate,
                     fmt::format("must be {:.6g} Hz or more, {} times per {}", least, kLeastTimes,
                                 plan.shape == LoadShape::kHalfSine ? "pulse" : "period"));
  }
  const double rate = rate_of(structure, plan, usual_times(plan.shape));
  const double steps = std::ceil(plan.duration * rate * (1.0 - kRounding));
  return plan.duration > 0.0 && std::isfinite(steps) ? steps / plan.duration : rate;
}

void check_pulse(const LoadPlan& plan) {
  if (plan.shape != LoadShape::kHalfSine && plan.shape != LoadShape::kShock) return;
  const double latest = plan.duration - plan.pulse;
  if (latest < -kRounding * plan.pulse) {
    throw InputError("duration", plan.duration,
                     fmt::format("must be {:.6g} s or more, the length of the {}", plan.pulse,
                                 to_string(plan.shape)));
  }
  if (plan.begin >= 0.0 && plan.begin <= latest * (1.0 + kRounding)) return;
  throw InputError(
      fmt::format("start of the {}", to_string(plan.shape)), plan.begin,
      fmt::format("must be from 0 s to {:.6g} s: all of its {:.6g} s must lie in the duration",
                  std::max(latest, 0.0), plan.pulse));
}

/// Factor of an excitation on a load without harmonics.
double share_of(const Excitation& excitation, LoadShape shape) {
  const std::complex<double> first = excitation.harmonics.front();
  if (std::abs(first.imag()) > kNoPhase * std::abs(first) || first.real() == 0.0) {
    throw InputError(fmt::format("first harmonic of the excitation at '{}'", excitation.point),
                     fmt::format("{:g} with a phase of {:g} rad", std::abs(first), std::arg(first)),
                     fmt::format("must not be 0 and must have no phase for a {}", to_string(shape)),
                     "A sine can have phases.");
  }
  if (shape == LoadShape::kShock && std::abs(first.real()) != 1.0) {
    throw InputError(fmt::format("first harmonic of the excitation at '{}'", excitation.point),
                     first.real(), "must be 1 or -1 for a shock: its spectrum is the required one",
                     "Scale the required levels.");
  }
  return first.real();
}

std::vector<double> values_of(const Excitation& excitation, const LoadPlan& plan,
                              const std::vector<double>& time, double rate, std::uint64_t number) {
  switch (plan.shape) {
    case LoadShape::kSine:
      return sine_burst(
          time, excitation.harmonics, plan.frequency,
          plan.cycles ? *plan.cycles / plan.frequency : std::numeric_limits<double>::infinity());
    case LoadShape::kSweep:
      return sine_sweep(time, plan.frequency, plan.last_frequency, plan.logarithmic);
    case LoadShape::kHalfSine:
      return half_sine(time, plan.begin, plan.pulse);
    case LoadShape::kNoise:
    case LoadShape::kShock:  // which is made once, for all excitations
      break;
  }
  return stationary_noise(time.size(), rate, plan.density, plan.seed, number);
}

void check_base_driven(const JointedStructure& structure) {
  if (structure.base_driven()) return;
  throw InputError("excitation of the model", "a force",
                   "must be a base for a shock: its spectrum is of the acceleration of one");
}

/// With rest before and after it.
std::vector<double> placed(const SynthesizedShock& shock, const LoadPlan& plan, std::size_t times,
                           double rate) {
  const auto begin = static_cast<std::size_t>(plan.begin * rate * (1.0 + kRounding));
  std::vector<double> values(std::max(times, begin + shock.acceleration.size()), 0.0);
  std::ranges::copy(shock.acceleration, values.begin() + static_cast<std::ptrdiff_t>(begin));
  values.resize(times);
  return values;
}

SynthesizedShock make_shock(const LoadPlan& plan, double rate, const Progress& progress) {
  ShockOptions options = plan.shock;
  options.length = plan.pulse;
  options.sampling_rate = rate;
  options.seed = plan.seed;
  return synthesize_shock(plan.required, options, progress);
}

std::string worst_text(const SynthesizedShock& shock) {
  return fmt::format("{:+.3g} dB at {:.5g} Hz, {:+.3g} dB between the {} frequencies", shock.worst,
                     shock.worst_frequency, shock.worst_between, shock.frequency.size());
}

std::string motion_text(const SynthesizedShock& shock) {
  return fmt::format("peak velocity {:.4g} m/s, peak displacement {:.4g} m, both 0 at the end",
                     shock.peak_velocity, shock.peak_displacement);
}

}  // namespace

std::string_view to_string(LoadShape shape) {
  switch (shape) {
    case LoadShape::kSine:
      return "sine";
    case LoadShape::kSweep:
      return "sweep";
    case LoadShape::kHalfSine:
      return "half-sine";
    case LoadShape::kShock:
      return "shock";
    case LoadShape::kNoise:
      break;
  }
  return "noise";
}

SynthesisedLoad synthesise_load(const JointedStructure& structure, const LoadPlan& asked,
                                const Progress& progress) {
  LoadPlan plan = asked;
  const bool is_shock = plan.shape == LoadShape::kShock;
  if (is_shock) check_base_driven(structure);
  if (is_shock && plan.pulse == 0.0) plan.pulse = shortest_shock(plan.required);
  check_pulse(plan);
  const double rate = sampling_rate_of(structure, plan);
  SynthesisedLoad load{{even_times(plan.duration, rate), {}}, {}};
  LoadHistory& history = load.history;
  if (is_shock) load.shock = make_shock(plan, rate, progress);
  const bool has_peak = plan.shape != LoadShape::kNoise && !is_shock;
  std::uint64_t number = 0;
  for (const Excitation& excitation : structure.excitations()) {
    const auto same = std::ranges::find(history.forces, excitation.point, &PointForce::point);
    if (same != history.forces.end()) {
      throw InputError(fmt::format("excitation at '{}'", excitation.point), "twice",
                       "must be only one at each place");
    }
    std::vector<double> values = is_shock
                                     ? placed(*load.shock, plan, history.time.size(), rate)
                                     : values_of(excitation, plan, history.time, rate, number++);
    double scale = has_peak ? plan.peak : 1.0;
    if (plan.shape != LoadShape::kSine) scale *= share_of(excitation, plan.shape);
    for (double& value : values) value *= scale;
    history.forces.push_back({excitation.point, std::move(values)});
  }
  return load;
}

std::string describe_load(const JointedStructure& structure, const SynthesisedLoad& load) {
  const LoadHistory& history = load.history;
  std::string text = line("times", fmt::format("{}, {:g} s to {:g} s", history.time.size(),
                                               history.time.front(), history.time.back()));
  for (const PointForce& at : history.forces) {
    const bool base = structure.linear().is_base(at.point);
    double peak = 0.0;
    double square = 0.0;
    for (const double value : at.force) {
      peak = std::max(peak, std::abs(value));
      square += value * value;
    }
    const std::string_view unit = base ? "m/s^2" : "N";
    text += line(base ? "acceleration of" : "force at",
                 fmt::format("{}: peak {:.5g} {}, rms {:.5g} {}", at.point, peak, unit,
                             std::sqrt(square / static_cast<double>(at.force.size())), unit));
  }
  if (!load.shock) return text;
  const Summary& summary = load.shock->summary;
  text += line("spectrum",
               fmt::format("{}{}", load.converged() ? "" : "NOT CONVERGED: ", summary.reason));
  text += line("worst deviation", worst_text(*load.shock));
  return text + line("base", motion_text(*load.shock));
}

std::string load_comment(const LoadPlan& plan, const SynthesisedLoad& load) {
  if (!load.shock) return {};
  const SynthesizedShock& shock = *load.shock;
  return fmt::format(
      "{}: {}: {}\n"
      "shock of a required response spectrum from {:g} Hz to {:g} Hz, damping ratio {:g} (Q "
      "{:.4g})\n"
      "worst deviation: {}\n{}",
      shock.summary.method, load.converged() ? "converged" : "NOT CONVERGED", shock.summary.reason,
      shock.frequency.front(), shock.frequency.back(), plan.shock.damping_ratio,
      0.5 / plan.shock.damping_ratio, worst_text(shock), motion_text(shock));
}

}  // namespace microslip
