// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/ring_down_sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "microslip/base/codes.hpp"
#include "microslip/base/median.hpp"
#include "microslip/signal/decay/ring_down_reading.hpp"
#include "microslip/signal/decay/sensor_means.hpp"

namespace microslip {
namespace {

constexpr double kSure = 2.0;  // standard deviations
// Allowed change of a ratio of amplitudes: D goes with A², so a shape that moves by 1 % makes 2 %
// of D, as much as counts as a leaking neighbour.
constexpr double kFixedShape = 0.01;

/// The values of a sensor in a window: with its full standard deviations, and with noise alone.
struct SensorPoint {
  DecayPoint all;
  DecayPoint noise;
  double shape = 0.0;  ///< see ShapeCourse::log_motion

  /// ln of the amplitude that it would have in the shape with stuck joints.
  [[nodiscard]] double log_amplitude() const { return std::log(all.amplitude) - shape; }
};

SensorPoint sensor_point(const DecayTrack& track, const DecayPoint& all, const DecayPoint& noise) {
  return {all, noise, track.task.measured.shape.log_motion_at(all.omega)};
}

/// The point of each window; none where the sensor does not show the decay.
using SensorPoints = std::vector<std::optional<SensorPoint>>;

/// Whether windows that are off by more than kSure deviations are more than noise makes of that
/// many: the worst by Bonferroni's inequality, or as many as noise makes five per cent of. Windows
/// overlap by three quarters, so a few in a row are one event.
bool beyond_chance(std::size_t windows, std::size_t apart, double worst) {
  constexpr double kFalseAlarm = 0.01;
  constexpr std::size_t kFewest = 4;
  const double chance = static_cast<double>(windows) * std::erfc(worst / std::numbers::sqrt2);
  return (apart > 0 && chance < kFalseAlarm) || (apart >= kFewest && 4 * apart > windows);
}

double median_error(const DecayTrack& track) {
  std::vector<double> errors;
  for (const DecayPoint& point : track.points) errors.push_back(point.loss_std / point.loss);
  return median(std::move(errors));
}

double length_of(const DecayTrack& track) {
  return track.walk.windows.back().centre - track.walk.windows.front().centre;
}

/// The one that knows the loss best, of those that follow it long.
std::size_t leader_of(const std::vector<SensorTrack>& tracks) {
  // Share of the longest track: amplitudes fall by e³ or more over a decay, so 0.7 of it loses the
  // last factor e at the least; a sensor that ends at the half would take half of the levels with
  // it.
  constexpr double kLong = 0.7;
  double longest = 0.0;
  for (const SensorTrack& sensor : tracks) longest = std::max(longest, length_of(sensor.track));
  std::size_t leader = tracks.size();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (length_of(tracks[i].track) < kLong * longest) continue;
    if (leader == tracks.size() ||
        median_error(tracks[i].track) < median_error(tracks[leader].track)) {
      leader = i;
    }
  }
  return leader;
}

DecayPoint noise_point(const DecayTrack& track, const DecayWindow& window) {
  return decay_point(window, track.task.measured, track.walk.noise_variance);
}

/// The points of a sensor in the windows of another.
SensorPoints points_in(const DecayTrack& track, const DecayTrack& leader) {
  SensorPoints points(leader.walk.windows.size());
  std::vector<DecayWindow> windows;
  std::vector<std::size_t> places;
  std::vector<DecayPoint> noisy;
  const double shift = leader.offset - track.offset;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DecayWindow& wanted = leader.walk.windows[i];
    const double centre = wanted.centre + shift;
    if (centre - wanted.length / 2.0 < 0.0 || centre + wanted.length / 2.0 > track.task.to)
      continue;
    const auto found = fit_decay_window(track.task.signal, track.task.rate, centre, wanted.length,
                                        track.task.lowest, track.task.highest, track.task.others);
    if (!found) continue;
    const DecayPoint noise = noise_point(track, *found);
    if (!(noise.damping_std < track.task.largest_std * noise.damping)) continue;
    windows.push_back(*found);
    places.push_back(i);
    noisy.push_back(noise);
  }
  std::vector<DecayPoint> found = points_of(track.task, windows, track.walk.noise_variance);
  add_second(track, windows, found);
  for (std::size_t i = 0; i < places.size(); ++i) {
    points[places[i]] = sensor_point(track, found[i], noisy[i]);
  }
  return points;
}

SensorPoints points_in_own(const DecayTrack& track) {
  SensorPoints points;
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    points.emplace_back(
        sensor_point(track, track.points[i], noise_point(track, track.walk.windows[i])));
  }
  return points;
}

/// ln of a sensor's amplitude over the leader's: mean weighted by the variances, and the windows
/// where both are.
struct RatioOverDecay {
  double mean = 0.0;
  double variance = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
};

double square_of(double x) { return x * x; }

double relative_variance(const DecayPoint& point) {
  return square_of(point.amplitude_std / point.amplitude);
}

RatioOverDecay log_ratio_of(const SensorPoints& points, const SensorPoints& leader) {
  RatioOverDecay ratio{.lowest = 1e300, .highest = -1e300};
  double weights = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i] || !leader[i]) continue;
    const double log = points[i]->log_amplitude() - leader[i]->log_amplitude();
    const double weight =
        1.0 / (relative_variance(points[i]->all) + relative_variance(leader[i]->all) + 1e-16);
    weights += weight;
    sum += weight * log;
    ratio.lowest = std::min(ratio.lowest, log);
    ratio.highest = std::max(ratio.highest, log);
  }
  if (weights > 0.0) {
    ratio.mean = sum / weights;
    ratio.variance = 1.0 / weights;
  }
  return ratio;
}

class Combination {
 public:
  explicit Combination(const std::vector<SensorTrack>& tracks) : tracks_(tracks) {
    result_.leader = leader_of(tracks);
    for (const SensorTrack& sensor : tracks) {
      points_.push_back(&sensor.track == &leader() ? points_in_own(leader())
                                                   : points_in(sensor.track, leader()));
    }
    for (const SensorPoints& points : points_) {
      ratios_.push_back(log_ratio_of(points, points_[result_.leader]));
    }
    for (const RatioOverDecay& ratio : ratios_) largest_ = std::max(largest_, std::exp(ratio.mean));
    result_.flags.resize(leader().walk.windows.size());
  }

  CombinedDecay run() {
    combine();
    name_sensors();
    compare_pairs();
    compare_ratios();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const DecayTrack& leader() const { return tracks_[result_.leader].track; }

  /// The windows whose centres are within half a window, and the index of the requested one among
  /// them.
  [[nodiscard]] std::vector<std::size_t> windows_about(std::size_t i) const {
    const std::vector<DecayWindow>& windows = leader().walk.windows;
    std::vector<std::size_t> about;
    for (std::size_t j = 0; j < windows.size(); ++j) {
      if (std::abs(windows[j].centre - windows[i].centre) <= 0.5 * windows[i].length) {
        about.push_back(j);
      }
    }
    return about;
  }

  /// @param value  of a sensor's point: SensorValue(sensor, point)
  template <typename Value>
  [[nodiscard]] SensorMean mean_at(std::size_t window, const Value& value) const {
    std::vector<std::vector<SensorValue>> times;
    std::size_t wanted = 0;
    for (const std::size_t j : windows_about(window)) {
      std::vector<SensorValue> values;
      for (std::size_t s = 0; s < points_.size(); ++s) {
        if (!points_[s][j]) continue;
        values.push_back(value(s, *points_[s][j]));
        values.back().size = std::exp(ratios_[s].mean) / largest_;
      }
      if (j == window) wanted = times.size();
      times.push_back(std::move(values));
    }
    return sensor_mean(times, wanted);
  }

  void combine() {
    const double to_first = ratios_.front().mean;
    for (std::size_t i = 0; i < leader().walk.windows.size(); ++i) {
      const SensorMean damping = mean_at(i, [](std::size_t, const SensorPoint& p) {
        return SensorValue{p.all.damping, square_of(p.all.damping_std),
                           square_of(p.noise.damping_std)};
      });
      const SensorMean omega = mean_at(i, [](std::size_t, const SensorPoint& p) {
        return SensorValue{p.all.omega, square_of(p.all.omega_std), square_of(p.noise.omega_std)};
      });
      const SensorMean log = mean_at(i, [&](std::size_t s, const SensorPoint& p) {
        return SensorValue{p.log_amplitude() + to_first - ratios_[s].mean, relative_variance(p.all),
                           relative_variance(p.noise)};
      });
      const SensorMean loss = mean_at(i, [&](std::size_t s, const SensorPoint& p) {
        return SensorValue{std::log(p.all.loss) + 2.0 * (to_first - ratios_[s].mean - p.shape),
                           square_of(p.all.loss_std / p.all.loss),
                           square_of(p.noise.loss_std / p.noise.loss)};
      });
      add_point(damping, omega, log, loss.variance);
    }
  }

  /// @param loss_variance  relative.
  void add_point(const SensorMean& damping, const SensorMean& omega, const SensorMean& log,
                 double loss_variance) {
    DecayPoint point;
    const ShapeCourse& first = tracks_.front().track.task.measured.shape;
    point.amplitude = std::exp(log.value + first.log_motion_at(omega.value));
    point.amplitude_std = point.amplitude * std::sqrt(log.variance);
    point.omega = omega.value;
    point.omega_std = std::sqrt(omega.variance);
    point.damping = damping.value;
    point.damping_std = std::sqrt(damping.variance);
    point.loss = 2.0 * std::numbers::pi * damping.value * omega.value * omega.value *
                 point.amplitude * point.amplitude;
    point.loss_std = point.loss * std::sqrt(loss_variance);
    result_.points.push_back(point);
  }

  void name_sensors() {
    for (std::size_t s = 0; s < points_.size(); ++s) {
      const RatioOverDecay& ratio = ratios_[s];
      const double over_first = std::exp(ratio.mean - ratios_.front().mean);
      result_.sensors.push_back(
          {.name = tracks_[s].name,
           .ratio = over_first,
           .ratio_std =
               s == 0 ? 0.0 : over_first * std::sqrt(ratio.variance + ratios_.front().variance),
           .ratio_range = std::max(0.0, std::exp(ratio.highest - ratio.lowest) - 1.0)});
    }
  }

  /// ζ and ω of each pair.
  void compare_pairs() {
    // First harmonics themselves move ω by some 1e−4 where a joint slips.
    constexpr double kSameFrequency = 1e-4;
    for (std::size_t a = 0; a < points_.size(); ++a) {
      for (std::size_t b = a + 1; b < points_.size(); ++b) {
        compare(a, b, "damping", &DecayPoint::damping, &DecayPoint::damping_std, 0.0);
        compare(a, b, "frequency", &DecayPoint::omega, &DecayPoint::omega_std, kSameFrequency);
      }
    }
  }

  /// @param same  a relative difference that counts as none.
  void compare(std::size_t a, std::size_t b, std::string_view quantity, double DecayPoint::*value,
               double DecayPoint::*deviation, double same) {
    std::size_t common = 0;
    std::size_t apart = 0;
    double worst = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < result_.flags.size(); ++i) {
      if (!points_[a][i] || !points_[b][i]) continue;
      ++common;
      const DecayPoint& one = points_[a][i]->all;
      const DecayPoint& other = points_[b][i]->all;
      const double off =
          std::abs(one.*value - other.*value) / std::hypot(one.*deviation, other.*deviation);
      const double relative = one.*value / other.*value - 1.0;
      if (off <= kSure || std::abs(relative) <= same) continue;
      ++apart;
      flag(i, "sensors_differ");
      if (off <= worst) continue;
      worst = off;
      difference = relative;
    }
    if (!beyond_chance(common, apart, worst)) return;
    result_.warnings.push_back(
        {"sensors_differ",
         fmt::format(
             "{} and {} differ in {} by more than twice its standard deviation in {} of "
             "{} windows, at worst {:.1f} of them ({:+.2g} %): one of them contains another "
             "oscillation. The standard deviations of the levels include it.",
             tracks_[a].name, tracks_[b].name, quantity, apart, common, worst,
             100.0 * difference)});
  }

  void compare_ratios() {
    const SensorPoints& lead = points_[result_.leader];
    for (std::size_t s = 0; s < points_.size(); ++s) {
      if (s == result_.leader) continue;
      std::size_t common = 0;
      std::size_t apart = 0;
      double worst = 0.0;
      for (std::size_t i = 0; i < result_.flags.size(); ++i) {
        if (!points_[s][i] || !lead[i]) continue;
        ++common;
        const double off =
            std::abs(points_[s][i]->log_amplitude() - lead[i]->log_amplitude() - ratios_[s].mean);
        const double deviation =
            std::sqrt(relative_variance(points_[s][i]->all) + relative_variance(lead[i]->all));
        if (off <= std::max(kSure * deviation, kFixedShape)) continue;
        ++apart;
        worst = std::max(worst, off / deviation);
        flag(i, "shape_moves");
      }
      if (beyond_chance(common, apart, worst)) warn_of_shape(s, apart);
    }
  }

  void warn_of_shape(std::size_t sensor, std::size_t apart) {
    const RingDownSensor& moved = result_.sensors[sensor];
    result_.warnings.push_back(
        {"shape_moves",
         fmt::format(
             "The amplitude of {} over that of {} moves by {:.2g} % over the decay, beyond its "
             "standard deviation in {} windows: the mode's shape is not fixed there, or {} also "
             "measures another motion.",
             moved.name, tracks_[result_.leader].name, 100.0 * moved.ratio_range, apart,
             moved.name)});
  }

  void flag(std::size_t window, std::string_view code) { add_code(result_.flags[window], code); }

  const std::vector<SensorTrack>& tracks_;
  CombinedDecay result_;
  std::vector<SensorPoints> points_;    ///< a sensor each
  std::vector<RatioOverDecay> ratios_;  ///< a sensor each, over the leader
  double largest_ = 0.0;
};

}  // namespace

CombinedDecay combine_sensors(const std::vector<SensorTrack>& tracks) {
  return Combination(tracks).run();
}

}  // namespace microslip
