// SPDX-License-Identifier: MIT
#include "microslip/workflow/made_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/workflow/summary_text.hpp"

namespace microslip {
namespace {

constexpr double kTimesAPeriod = 256.0;        // a chord lies 8e-5 of the amplitude beside the sine
constexpr double kTimesAPulse = 200.0;         // likewise 3e-5 of a half-sine
constexpr double kTimesAPeriodOfNoise = 32.0;  // 5e-3 at the highest frequency, less below
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
    case LoadShape::kNoise:
      break;
  }
  return number * plan.density.frequency.back();
}

/// Chosen so that the duration is a whole number of steps.
double sampling_rate_of(const JointedStructure& structure, const LoadPlan& plan) {
  if (plan.sampling_rate > 0.0) {
    const double least = rate_of(structure, plan, kLeastTimes);
    if (plan.shape == LoadShape::kNoise || plan.sampling_rate >= least) return plan.sampling_rate;
    throw InputError("sampling rate", plan.sampling_rate,
                     fmt::format("must be {:.6g} Hz or more, {} times in a {}", least, kLeastTimes,
                                 plan.shape == LoadShape::kHalfSine ? "pulse" : "period"));
  }
  const double number = plan.shape == LoadShape::kNoise      ? kTimesAPeriodOfNoise
                        : plan.shape == LoadShape::kHalfSine ? kTimesAPulse
                                                             : kTimesAPeriod;
  const double rate = rate_of(structure, plan, number);
  const double steps = std::ceil(plan.duration * rate * (1.0 - kRounding));
  return plan.duration > 0.0 && std::isfinite(steps) ? steps / plan.duration : rate;
}

void check_pulse(const LoadPlan& plan) {
  if (plan.shape != LoadShape::kHalfSine) return;
  const double latest = plan.duration - plan.pulse;
  if (plan.begin >= 0.0 && plan.begin <= latest * (1.0 + kRounding)) return;
  throw InputError("begin of the half-sine", plan.begin,
                   fmt::format("must be from 0 s to {:.6g} s: all of the pulse of {:.6g} s lies in "
                               "the duration",
                               std::max(latest, 0.0), plan.pulse));
}

/// What an excitation has of a load without harmonics.
double share_of(const Excitation& excitation, LoadShape shape) {
  const std::complex<double> first = excitation.harmonics.front();
  if (std::abs(first.imag()) > kNoPhase * std::abs(first) || first.real() == 0.0) {
    throw InputError(
        fmt::format("first harmonic of the excitation at '{}'", excitation.point),
        fmt::format("{:g} with a phase of {:g} rad", std::abs(first), std::arg(first)),
        fmt::format("must be other than 0 and have no phase for a {}", to_string(shape)),
        "A sine knows phases.");
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
      break;
  }
  return stationary_noise(time.size(), rate, plan.density, plan.seed, number);
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
    case LoadShape::kNoise:
      break;
  }
  return "noise";
}

LoadHistory make_load(const JointedStructure& structure, const LoadPlan& plan) {
  check_pulse(plan);
  const double rate = sampling_rate_of(structure, plan);
  LoadHistory load{even_times(plan.duration, rate), {}};
  std::uint64_t number = 0;
  for (const Excitation& excitation : structure.excitations()) {
    const auto same = std::ranges::find(load.forces, excitation.point, &PointForce::point);
    if (same != load.forces.end()) {
      throw InputError(fmt::format("excitation at '{}'", excitation.point), "twice",
                       "must be one of each place");
    }
    std::vector<double> values = values_of(excitation, plan, load.time, rate, number++);
    double scale = plan.shape == LoadShape::kNoise ? 1.0 : plan.peak;
    if (plan.shape != LoadShape::kSine) scale *= share_of(excitation, plan.shape);
    for (double& value : values) value *= scale;
    load.forces.push_back({excitation.point, std::move(values)});
  }
  return load;
}

std::string describe_load(const JointedStructure& structure, const LoadHistory& load) {
  std::string text = line("times", fmt::format("{}, {:g} s to {:g} s", load.time.size(),
                                               load.time.front(), load.time.back()));
  for (const PointForce& at : load.forces) {
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
  return text;
}

}  // namespace microslip
