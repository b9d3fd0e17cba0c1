// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/shock_synthesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/signal/shock/load_shapes.hpp"
#include "microslip/signal/shock/log_log_line.hpp"
#include "microslip/signal/shock/response_spectrum.hpp"
#include "microslip/signal/shock/shock_wavelets.hpp"

namespace microslip {
namespace {

constexpr double kRoundingOfLength = 1e-9;
constexpr double kLeastTimesAPeriod = 10.0;
constexpr double kAmplification = 5.0;  // of a wavelet by a mass of its frequency, to begin with
constexpr double kScalingPower = 0.7;   // below 1, as neighbours have a part in each peak
constexpr int kScalings = 8;
constexpr int kMostImprovements = 40;
constexpr int kMostDraws = 3;
constexpr int kMostEvaluations = kMostDraws * (kScalings + kMostImprovements);
constexpr int kMostRejected = 8;        // steps one after the other
constexpr int kMostSlow = 4;            // consecutive steps that gain less than kSlow
constexpr double kSlow = 0.97;          // of the sum before
constexpr double kLongestStep = 0.7;    // of an amplitude, relative
constexpr double kLeastWeight = 0.1;    // of a deviation, over that of one of the tolerance
constexpr double kLeastDamping = 1e-6;  // of a step
constexpr std::size_t kFiner = 4;

double in_decibels(double ratio) { return 20.0 * std::log10(ratio); }

/// In equal ratios, the ends with them.
std::vector<double> analysis_frequencies(const RequiredSpectrum& required, double per_octave) {
  const double from = required.frequency.front();
  const double ratio = required.frequency.back() / from;
  const double pieces = std::max(1.0, std::ceil(per_octave * std::log2(ratio) * (1.0 - 1e-12)));
  std::vector<double> frequency;
  for (double i = 0.0; i < pieces; i += 1.0) {
    frequency.push_back(from * std::pow(ratio, i / pieces));
  }
  frequency.push_back(required.frequency.back());
  return frequency;
}

void check_shock(const RequiredSpectrum& required, const ShockOptions& options) {
  required.check();
  const auto within = [](std::string_view what, double value, double from, double to) {
    if (value >= from && value <= to) return;
    throw InputError(what, value, fmt::format("must be from {:g} to {:g}", from, to));
  };
  within("frequencies per octave", options.per_octave, 6.0, 48.0);
  within("tolerance in dB", options.tolerance, 0.1, 12.0);
  const double shortest = shortest_shock(required);
  if (!(options.length >= shortest * (1.0 - kRoundingOfLength)) || !std::isfinite(options.length)) {
    throw InputError("length of the shock", options.length,
                     fmt::format("must be {:.6g} s or more, three half-cycles of the lowest "
                                 "frequency, {:g} Hz",
                                 shortest, required.frequency.front()));
  }
  const double least = kLeastTimesAPeriod * required.frequency.back();
  if (options.sampling_rate >= least) return;
  throw InputError("sampling rate", options.sampling_rate,
                   fmt::format("must be {:.6g} Hz or more, {:g} times the highest frequency of the "
                               "required spectrum, {:g} Hz",
                               least, kLeastTimesAPeriod, required.frequency.back()));
}

/// Amplitudes that were tried, and what their shock has.
struct Trial {
  Eigen::VectorXd amplitude;
  std::vector<double> acceleration;
  std::vector<double> reached;
  Eigen::VectorXd deviation;  // 20 lg(S/R), dB
  double cost = 0.0;          // Σ (deviation/tolerance)⁴

  [[nodiscard]] double worst() const { return deviation.cwiseAbs().maxCoeff(); }
};

class ShockSearch {
 public:
  ShockSearch(const RequiredSpectrum& required, const ShockOptions& options,
              const Progress& progress)
      : options_(options),
        progress_(progress),
        frequency_(analysis_frequencies(required, options.per_octave)),
        time_(even_times(options.length, options.sampling_rate)) {
    for (const double f : frequency_) required_.push_back(required.at(f));
  }

  void run() {
    for (; draws_ < kMostDraws && !met(); ++draws_) {
      const ShockWavelets wavelets(frequency_, time_.size() - 1, options_.sampling_rate,
                                   options_.seed, static_cast<std::uint64_t>(draws_));
      const Trial scaled = scale(wavelets);
      if (!met()) improve(wavelets, scaled);
    }
  }

  [[nodiscard]] SynthesizedShock result(const RequiredSpectrum& required) const {
    SynthesizedShock shock;
    shock.acceleration = best_.acceleration;
    shock.frequency = frequency_;
    shock.required = required_;
    shock.reached = best_.reached;
    Eigen::Index at = 0;
    best_.deviation.cwiseAbs().maxCoeff(&at);
    shock.worst = best_.deviation[at];
    shock.worst_frequency = frequency_[static_cast<std::size_t>(at)];
    shock.worst_between = worst_between(required);
    set_motion(shock);
    set_summary(shock);
    return shock;
  }

 private:
  [[nodiscard]] bool met() const {
    return best_.amplitude.size() > 0 && best_.worst() <= options_.tolerance;
  }

  Trial judged(const ShockWavelets& wavelets, Eigen::VectorXd amplitude) {
    Trial trial;
    trial.acceleration = wavelets.sum(amplitude);
    trial.amplitude = std::move(amplitude);
    trial.reached =
        response_spectrum(time_, trial.acceleration, frequency_, options_.damping_ratio).maximax();
    trial.deviation.resize(static_cast<Eigen::Index>(frequency_.size()));
    for (std::size_t j = 0; j < frequency_.size(); ++j) {
      trial.deviation[static_cast<Eigen::Index>(j)] = in_decibels(trial.reached[j] / required_[j]);
    }
    trial.cost = (trial.deviation / options_.tolerance).array().pow(4).sum();
    ++evaluations_;
    if (best_.amplitude.size() == 0 || trial.worst() < best_.worst()) best_ = trial;
    const auto done = static_cast<std::size_t>(std::min(evaluations_, kMostEvaluations));
    if (progress_ && !progress_(done, kMostEvaluations)) throw Cancelled();
    return trial;
  }

  /// A_k ∝ R/S at the frequency of each wavelet.
  Trial scale(const ShockWavelets& wavelets) {
    const Eigen::Map<const Eigen::VectorXd> required(required_.data(),
                                                     static_cast<Eigen::Index>(required_.size()));
    Trial now = judged(wavelets, wavelets.sign().cwiseProduct(required) / kAmplification);
    Trial best = now;
    for (int i = 0; i < kScalings && !met(); ++i) {
      const Eigen::ArrayXd factor =
          (now.deviation.array() * (-kScalingPower * std::log(10.0) / 20.0)).exp();
      now = judged(wavelets, now.amplitude.array() * factor);
      if (now.worst() < best.worst()) best = now;
    }
    return best;
  }

  /// ∂(20 lg S_j)/∂ ln|A_k|.
  [[nodiscard]] Eigen::MatrixXd sensitivity(const ShockWavelets& wavelets, const Trial& at) const {
    const Eigen::Index size = at.amplitude.size();
    Eigen::MatrixXd sensitivity(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      const ShockWavelets::Peak peak = wavelets.peak(
          at.acceleration, frequency_[static_cast<std::size_t>(j)], options_.damping_ratio);
      sensitivity.row(j) = 20.0 / std::log(10.0) *
                           peak.derivative.cwiseProduct(at.amplitude.cwiseAbs()).transpose() /
                           peak.value;
    }
    return sensitivity;
  }

  void improve(const ShockWavelets& wavelets, Trial now) {
    double damping = 0.1;
    int slow = 0;
    for (int i = 0; i < kMostImprovements && slow < kMostSlow && !met(); ++i) {
      const Eigen::MatrixXd g = sensitivity(wavelets, now);
      const Eigen::VectorXd weight =
          (now.deviation / options_.tolerance).array().square().max(kLeastWeight);
      const Eigen::MatrixXd normal = g.transpose() * weight.asDiagonal() * g;
      const Eigen::VectorXd downhill = -g.transpose() * weight.asDiagonal() * now.deviation;
      const double before = now.cost;
      if (!step(wavelets, normal, downhill, damping, now)) return;
      slow = now.cost > kSlow * before ? slow + 1 : 0;
    }
  }

  /// Takes a step with a lower sum. @return whether one was found.
  bool step(const ShockWavelets& wavelets, const Eigen::MatrixXd& normal,
            const Eigen::VectorXd& downhill, double& damping, Trial& now) {
    for (int rejected = 0; rejected < kMostRejected; ++rejected) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal().array() += damping * normal.diagonal().maxCoeff();
      const Eigen::ArrayXd change =
          damped.ldlt().solve(downhill).array().max(-kLongestStep).min(kLongestStep);
      Trial next = judged(wavelets, now.amplitude.array() + change * now.amplitude.array().abs());
      if (next.cost < now.cost) {
        now = std::move(next);
        damping = std::max(damping / 3.0, kLeastDamping);
        return true;
      }
      if (met()) return false;
      damping *= 4.0;
    }
    return false;
  }

  [[nodiscard]] double worst_between(const RequiredSpectrum& required) const {
    std::vector<double> finer;
    for (std::size_t j = 0; j + 1 < frequency_.size(); ++j) {
      const double ratio = frequency_[j + 1] / frequency_[j];
      for (std::size_t i = 0; i < kFiner; ++i) {
        finer.push_back(frequency_[j] * std::pow(ratio, static_cast<double>(i) / kFiner));
      }
    }
    const std::vector<double> reached =
        response_spectrum(time_, best_.acceleration, finer, options_.damping_ratio).maximax();
    double worst = 0.0;
    for (std::size_t i = 0; i < finer.size(); ++i) {
      const double deviation = in_decibels(reached[i] / required.at(finer[i]));
      if (std::abs(deviation) > std::abs(worst)) worst = deviation;
    }
    return worst;
  }

  /// Sets the motion of the base, whose acceleration is linear between the times.
  void set_motion(SynthesizedShock& shock) const {
    const double h = 1.0 / options_.sampling_rate;
    const std::vector<double>& a = shock.acceleration;
    double v = 0.0;
    double x = 0.0;
    for (std::size_t i = 1; i < a.size(); ++i) {
      x += h * (v + h * (2.0 * a[i - 1] + a[i]) / 6.0);
      v += 0.5 * h * (a[i - 1] + a[i]);
      shock.peak_velocity = std::max(shock.peak_velocity, std::abs(v));
      shock.peak_displacement = std::max(shock.peak_displacement, std::abs(x));
    }
  }

  void set_summary(SynthesizedShock& shock) const {
    Summary& summary = shock.summary;
    summary.method = fmt::format("sum of {} wavelets", frequency_.size());
    summary.stop = met() ? Stop::kConverged : Stop::kNoProgress;
    summary.residual = best_.worst() / options_.tolerance;
    summary.iterations = evaluations_;
    summary.wall_seconds = watch_.seconds();
    summary.reason =
        fmt::format("the spectrum is within {:.3g} dB of the required one", options_.tolerance);
    if (met()) return;
    summary.reason = fmt::format(
        "the spectrum lies {:.3g} dB {} the required one at {:.5g} Hz, more than the tolerance of "
        "{:.3g} dB; one that rises by more than 12 dB per octave, falls steeply or jumps is not "
        "that of a short shock: try a longer one, another seed or a wider tolerance",
        std::abs(shock.worst), shock.worst < 0.0 ? "below" : "above", shock.worst_frequency,
        options_.tolerance);
  }

  ShockOptions options_;
  const Progress& progress_;
  std::vector<double> frequency_;
  std::vector<double> required_;
  std::vector<double> time_;
  Trial best_;
  int draws_ = 0;
  int evaluations_ = 0;
  Stopwatch watch_;
};

}  // namespace

void RequiredSpectrum::check() const {
  check_log_log_line("a required spectrum", "maximax", frequency, maximax);
}

double RequiredSpectrum::at(double f) const { return log_log_value(frequency, maximax, f); }

double shortest_shock(const RequiredSpectrum& required) {
  required.check();
  return 1.5 / required.frequency.front();
}

SynthesizedShock synthesize_shock(const RequiredSpectrum& required, const ShockOptions& options,
                                  const Progress& progress) {
  check_shock(required, options);
  ShockSearch search(required, options, progress);
  search.run();
  return search.result(required);
}

}  // namespace microslip
