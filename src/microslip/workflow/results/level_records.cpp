// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/level_records.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/signal/harmonic/fourier_fit.hpp"

namespace microslip {
namespace {

constexpr double kCycles = 2.0;
// Of a signal.
constexpr std::size_t kFewestPoints = 200;
constexpr std::size_t kMostPoints = 4000;

bool is_signal(const Channel& channel) {
  return channel.dimension.has_value() && channel.imaginary.empty();
}

std::vector<const Channel*> signals_of(const Recording& recording) {
  std::vector<const Channel*> signals;
  for (const Channel& channel : recording.channels) {
    if (is_signal(channel)) signals.push_back(&channel);
  }
  return signals;
}

FourierFit fit_of(const Recording& recording, const std::vector<const Channel*>& channels) {
  std::vector<std::span<const double>> signals;
  for (const Channel* channel : channels) signals.emplace_back(channel->values);
  FourierFit fit = fit_fourier(recording.axis, signals, {.seek_longer_period = false});
  if (fit.summary.converged()) return fit;
  throw InputError(recording.source, "this record", "must contain a steady vibration",
                   fit.summary.reason);
}

/// When the fundamental of the first signal rises through 0 for the first time.
double start_of(const Recording& recording, const FourierFit& fit) {
  // cos(ωt + phase) is sin(ωt + phase + π/2).
  const double phase = std::arg(fit.series.front().c(1)) + 0.5 * std::numbers::pi;
  const double cycle = 2.0 * std::numbers::pi;
  const double first = recording.axis.at(0);
  const double behind = std::fmod(fit.omega * first + phase, cycle);
  return first + (behind <= 0.0 ? -behind : cycle - behind) / fit.omega;
}

/// The points of two cycles, every n-th of them.
std::vector<std::size_t> points_of(const Recording& recording, double start, double period,
                                   std::size_t most) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double t = recording.axis.at(i) - start;
    if (t >= 0.0 && t <= kCycles * period) points.push_back(i);
  }
  const std::size_t step = std::max((points.size() + most - 1) / most, std::size_t{1});
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

/// Two cycles of each channel, at the same times.
std::vector<SignalPair> histories(const Recording& recording,
                                  const std::vector<const Channel*>& channels,
                                  const FourierFit& fit, std::size_t most) {
  const double start = start_of(recording, fit);
  const std::vector<std::size_t> points = points_of(recording, start, 1.0 / fit.frequency(), most);
  std::vector<SignalPair> signals;
  for (const Channel* channel : channels) {
    SignalPair signal{channel->name, si_unit(*channel->dimension), {}, {}, {}, {}};
    for (const std::size_t i : points) {
      signal.time.push_back(recording.axis.at(i) - start);
      signal.recorded.push_back(channel->values[i]);
    }
    signals.push_back(std::move(signal));
  }
  return signals;
}

/// |F_n|/|F_1|, n from 2.
std::vector<double> relative_harmonics(const DrivenVibration& driven, std::size_t harmonics) {
  std::vector<double> shares;
  for (std::size_t n = 2; n < driven.force.size() && n <= harmonics; ++n) {
    shares.push_back(std::abs(driven.force[n]) / std::abs(driven.force[1]));
  }
  return shares;
}

/// Every n-th point of a signal.
void thin(std::vector<double>& values, std::size_t step) {
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); i += step) some.push_back(values[i]);
  values = std::move(some);
}

}  // namespace

LevelRecord level_record(const Recording& recording, const std::string& name,
                         std::size_t most_points) {
  const std::vector<const Channel*> channels = signals_of(recording);
  if (channels.empty()) {
    throw InputError(recording.source, "this record", "must have a channel with a unit");
  }
  const FourierFit fit = fit_of(recording, channels);
  LevelRecord record{name, {}, {}};
  if (most_points > 0) {
    record.signals =
        histories(recording, channels, fit,
                  std::clamp(most_points / channels.size(), kFewestPoints, kMostPoints));
  }
  for (std::size_t j = 0; j < channels.size(); ++j) {
    HarmonicsPair harmonics{channels[j]->name, si_unit(*channels[j]->dimension), {}, {}};
    for (std::size_t n = 1; n <= fit.order(); ++n) {
      harmonics.recorded.push_back(std::abs(fit.series[j].c(n)));
    }
    record.harmonics.push_back(std::move(harmonics));
  }
  return record;
}

void add_other(const LevelRecord& other, LevelRecord& record) {
  for (SignalPair& signal : record.signals) {
    const auto same = std::ranges::find(other.signals, signal.name, &SignalPair::name);
    if (same == other.signals.end() || same->unit != signal.unit) continue;
    signal.other_time = same->time;
    signal.other = same->recorded;
  }
  for (HarmonicsPair& channel : record.harmonics) {
    const auto same = std::ranges::find(other.harmonics, channel.name, &HarmonicsPair::name);
    if (same != other.harmonics.end()) channel.other = same->recorded;
  }
}

std::vector<std::string> spread(const std::vector<std::string>& names, std::size_t count) {
  if (names.size() <= count) return names;
  std::vector<std::string> some;
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(names[i * (names.size() - 1) / std::max(count - 1, std::size_t{1})]);
  }
  return some;
}

std::vector<LevelRecord> some_records(std::vector<LevelRecord> records, std::size_t count,
                                      std::size_t most_points) {
  std::vector<std::string> names;
  for (const LevelRecord& record : records) names.push_back(record.source);
  const std::vector<std::string> kept = spread(names, count);
  std::erase_if(records, [&](const LevelRecord& record) {
    return std::ranges::find(kept, record.source) == kept.end();
  });
  std::size_t points = 0;
  for (const LevelRecord& record : records) {
    for (const SignalPair& signal : record.signals) points += 2 * signal.time.size();
  }
  const std::size_t step = points / most_points + 1;
  for (LevelRecord& record : records) {
    for (SignalPair& signal : record.signals) {
      for (auto* values : {&signal.time, &signal.recorded, &signal.other_time, &signal.other}) {
        thin(*values, step);
      }
    }
  }
  return records;
}

std::vector<ForceControlLevel> force_controls(std::span<const VirtualLevel> levels,
                                              std::size_t harmonics) {
  std::vector<ForceControlLevel> controls;
  for (const VirtualLevel& level : levels) {
    controls.push_back({"", level.response, relative_harmonics(level.uncontrolled, harmonics),
                        relative_harmonics(level.controlled, harmonics)});
  }
  return controls;
}

Curve force_over_cycle(const DrivenVibration& driven, std::size_t points) {
  Curve curve;
  const double period = 2.0 * std::numbers::pi / driven.vibration.angular_frequency;
  for (std::size_t i = 0; i <= points; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points);
    double force = 0.0;
    for (std::size_t n = 1; n < driven.force.size(); ++n) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(n) * share;
      force += (driven.force[n] * std::polar(1.0, angle)).real();
    }
    curve.x.push_back(share * period);
    curve.y.push_back(force);
  }
  return curve;
}

}  // namespace microslip
