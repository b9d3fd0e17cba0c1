// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/cycle_energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/signal/harmonic/cycle_scatter.hpp"

namespace microslip {
namespace {

constexpr double kSameOmega = 1e-12;  // relative; two fits never agree by chance
constexpr double kRounding = 1e-9;    // cycles: a whole number of them must not lose one

void check_omegas(const FourierSeries& force, const FourierSeries& acceleration) {
  if (!(force.omega > 0.0 && std::isfinite(force.omega))) {
    throw InputError("omega of the force", force.omega, "must be above 0 and finite");
  }
  if (std::abs(acceleration.omega - force.omega) <= kSameOmega * force.omega) return;
  throw InputError("omega of the acceleration", acceleration.omega,
                   fmt::format("must be {:.17g} rad/s, that of the force", force.omega),
                   "Fit both signals together.");
}

void check_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == 0 || length == expected) return;
  throw InputError(what, static_cast<double>(length),
                   fmt::format("must be {}, one per harmonic, or 0", expected));
}

double std_of(std::span<const double> errors, std::size_t n) {
  return n <= errors.size() ? errors[n - 1] : 0.0;
}

/// ∫ y dt from the first point on, as a function of time. Between points the cubic with the values
/// and slopes at both; at the points of even steps the fourth-order sum
/// h/24 (−y_{i−1} + 13 y_i + 13 y_{i+1} − y_{i+2}) a step, else the trapezoid.
class RunningIntegral {
 public:
  RunningIntegral(const Axis& axis, std::vector<double> values)
      : axis_(axis), values_(std::move(values)), sums_(values_.size(), 0.0) {
    const std::vector<double>& y = values_;
    for (std::size_t i = 0; i + 1 < y.size(); ++i) {
      const double step = axis.at(i + 1) - axis.at(i);
      const bool inside = axis.even() && i > 0 && i + 2 < y.size();
      sums_[i + 1] =
          sums_[i] + (inside ? axis.step / 24.0 * (13.0 * (y[i] + y[i + 1]) - y[i - 1] - y[i + 2])
                             : 0.5 * step * (y[i] + y[i + 1]));
    }
  }

  [[nodiscard]] double at(double t) const {
    const std::size_t i = cell(t);
    const double step = axis_.at(i + 1) - axis_.at(i);
    const double x = (t - axis_.at(i)) / step;
    const double rise = sums_[i + 1] - sums_[i];
    const double begin = step * values_[i];
    const double end = step * values_[i + 1];
    return sums_[i] +
           x * (begin + x * (3.0 * rise - 2.0 * begin - end + x * (begin + end - 2.0 * rise)));
  }

  [[nodiscard]] double between(double a, double b) const { return at(b) - at(a); }
  [[nodiscard]] const std::vector<double>& sums() const { return sums_; }

 private:
  /// The cell that holds t.
  [[nodiscard]] std::size_t cell(double t) const {
    std::size_t low = 0;
    std::size_t high = values_.size() - 1;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (axis_.at(middle) <= t ? low : high) = middle;
    }
    return low;
  }

  const Axis& axis_;
  std::vector<double> values_;
  std::vector<double> sums_;
};

/// The samples less mean and trend of their series.
std::vector<double> without_trend(const Axis& axis, std::span<const double> samples,
                                  FourierSeries series) {
  series.harmonic.clear();
  std::vector<double> result(samples.begin(), samples.end());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= series.value(axis.at(i));
  return result;
}

std::vector<double> velocity_at_points(const Axis& axis, std::span<const double> acceleration,
                                       const FourierSeries& series, VelocityFrom from) {
  if (from == VelocityFrom::kSeries) return values(integral(series), axis, acceleration.size());
  return RunningIntegral(axis, without_trend(axis, acceleration, series)).sums();
}

void check_samples(const Axis& axis, std::size_t force, std::size_t acceleration) {
  constexpr std::size_t kLeastPoints = 8;
  if (force < kLeastPoints) {
    throw InputError("number of points", static_cast<double>(force), "must be at least 8");
  }
  if (acceleration == force && (axis.even() || axis.values.size() == force)) return;
  throw InputError("length of the acceleration or the axis",
                   static_cast<double>(acceleration == force ? axis.values.size() : acceleration),
                   fmt::format("must be {}, that of the force", force));
}

}  // namespace

EnergyEstimate cycle_energy(const FourierSeries& force, const FourierSeries& acceleration,
                            std::span<const double> force_std,
                            std::span<const double> acceleration_std) {
  check_omegas(force, acceleration);
  check_length("number of force_std", force_std.size(), force.order());
  check_length("number of acceleration_std", acceleration_std.size(), acceleration.order());
  const double factor = std::numbers::pi / (force.omega * force.omega);
  double sum = 0.0;
  double variance = 0.0;
  for (std::size_t n = 1; n <= std::min(force.order(), acceleration.order()); ++n) {
    const double number = static_cast<double>(n);
    sum -= std::imag(force.c(n) * std::conj(acceleration.c(n))) / number;
    const double of_acceleration = std::abs(force.c(n)) * std_of(acceleration_std, n) / number;
    const double of_force = std::abs(acceleration.c(n)) * std_of(force_std, n) / number;
    variance += of_acceleration * of_acceleration + of_force * of_force;
  }
  return {factor * sum, factor * std::sqrt(variance)};
}

SampledEnergy cycle_energy_from_samples(const Axis& axis, std::span<const double> force,
                                        std::span<const double> acceleration,
                                        const FourierSeries& force_series,
                                        const FourierSeries& acceleration_series,
                                        VelocityFrom velocity) {
  check_omegas(force_series, acceleration_series);
  check_samples(axis, force.size(), acceleration.size());
  std::vector<double> f = without_trend(axis, force, force_series);
  std::vector<double> v = velocity_at_points(axis, acceleration, acceleration_series, velocity);
  std::vector<double> product(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) product[i] = f[i] * v[i];
  const RunningIntegral power(axis, std::move(product));
  const RunningIntegral impulse(axis, std::move(f));
  const RunningIntegral path(axis, std::move(v));

  const double period = force_series.period();
  const double begin = axis.at(1);  // the first and the last step have no neighbours to sum with
  const double length = axis.at(force.size() - 2) - begin;
  const double ratio = length / period + kRounding;
  if (!(ratio >= 1.0)) {
    throw InputError("length of the record", length, fmt::format("must be a cycle, {} s", period));
  }
  if (ratio > static_cast<double>(force.size())) {
    throw InputError("length of the record", length,
                     fmt::format("must be at most a cycle, {} s, per point", period));
  }
  const auto cycles = static_cast<std::size_t>(ratio);
  SampledEnergy result;
  for (std::size_t i = 0; i < cycles; ++i) {
    const double a = begin + static_cast<double>(i) * period;
    const double b = begin + static_cast<double>(i + 1) * period;
    result.per_cycle.push_back(power.between(a, b) -
                               path.between(a, b) / period * impulse.between(a, b));
  }
  const Scatter over_cycles = scatter(result.per_cycle);
  result.energy = over_cycles.mean;
  result.std_error = over_cycles.standard_error;
  return result;
}

EnergyEstimate linear_dissipation(std::span<const FourierSeries> modal,
                                  std::span<const double> loss_factor,
                                  std::span<const double> natural_omega,
                                  std::span<const std::vector<double>> modal_std) {
  if (loss_factor.size() != modal.size() || natural_omega.size() != modal.size() ||
      (!modal_std.empty() && modal_std.size() != modal.size())) {
    throw InputError("number of modes", static_cast<double>(modal.size()),
                     "must be the same in modal, loss_factor, natural_omega and modal_std");
  }
  double sum = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < modal.size(); ++i) {
    if (!(loss_factor[i] >= 0.0)) {
      throw InputError(fmt::format("loss_factor {}", i + 1), loss_factor[i], "must be 0 or more");
    }
    if (!(natural_omega[i] >= 0.0)) {
      throw InputError(fmt::format("natural_omega {}", i + 1), natural_omega[i],
                       "must be 0 rad/s or more");
    }
    const std::span<const double> errors =
        modal_std.empty() ? std::span<const double>{} : std::span<const double>(modal_std[i]);
    check_length(fmt::format("number of modal_std {}", i + 1), errors.size(), modal[i].order());
    const double factor = std::numbers::pi * loss_factor[i] * natural_omega[i] * natural_omega[i];
    for (std::size_t n = 1; n <= modal[i].order(); ++n) {
      const double weight = factor * static_cast<double>(n);
      sum += weight * std::norm(modal[i].c(n));
      const double error = 2.0 * weight * std::abs(modal[i].c(n)) * std_of(errors, n);
      variance += error * error;
    }
  }
  return {sum, std::sqrt(variance)};
}

}  // namespace microslip
