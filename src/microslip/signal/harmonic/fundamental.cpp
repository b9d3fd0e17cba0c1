// SPDX-License-Identifier: MIT
#include "microslip/signal/harmonic/fundamental.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "microslip/signal/harmonic/line_spectrum.hpp"

namespace microslip {
namespace {

using Eigen::Index;

constexpr double kLargestShareOfRate = 0.45;  // of a harmonic in the sampling rate
constexpr double kLineWidth = 0.75;           // cycles a record: how far a line may be off its peak
constexpr double kLeastShare = 1e-4;          // power of lines that make a longer period
constexpr double kNoiseFactor = 10.0;         // and over what noise would make of them
constexpr Index kLargestDivisor = 10;
constexpr Index kLargestTrialOrder = 60;
constexpr double kFewCycles = 6.0;  // lines so close that their spectra overlap

/// The search, with what its steps share.
class Search {
 public:
  Search(const HarmonicRegression& regression, const Eigen::MatrixXd& signals,
         const FourierFitOptions& options)
      : regression_(regression), options_(options) {
    if (!options.fit_frequency) return;
    const double highest = options.frequency_guess
                               ? cycles_of_guess(*options.frequency_guess) *
                                     (1.0 + options.guess_tolerance) * options.order
                               : points();
    spectrum_ = std::make_unique<LineSpectrum>(regression.times(), signals, highest);
  }

  Fundamental near_guess(double guess);
  Fundamental at_guess(double guess);
  Fundamental anywhere();

 private:
  double points() const { return static_cast<double>(regression_.times().points()); }
  /// Ω of a frequency in cycles a record.
  double big_omega(double cycles) const {
    return std::numbers::pi * cycles * (points() - 1.0) / points();
  }
  double cycles_of(double omega) const {
    return omega * points() / ((points() - 1.0) * std::numbers::pi);
  }
  double hertz(double cycles) const { return cycles / regression_.times().length(); }
  double cycles_of_guess(double guess) const { return guess * regression_.times().length(); }

  Index largest_order(double cycles, Index wanted) const;
  Descent descend_from(double cycles, Index order, OmegaRange range);
  double refined_line(double cycles);
  double start_near(double cycles, OmegaRange range, Index order);
  bool needed(const HarmonicFit& fit, Index divisor) const;
  double leakage(double cycles, double place, Index signal) const;
  bool worth_trying(double cycles, Index divisor) const;
  double information_criterion(const HarmonicFit& fit) const;
  double longest_period(double cycles);
  Fundamental finish(Descent descent, std::string_view where);
  Fundamental failed(std::string reason) const;
  std::string too_few_cycles(double cycles) const;
  std::string too_few_points(double cycles) const;
  OmegaRange line_range(double cycles) const {
    return {big_omega(std::max(0.5, cycles - kLineWidth)), big_omega(cycles + kLineWidth)};
  }

  const HarmonicRegression& regression_;
  std::unique_ptr<const LineSpectrum> spectrum_;  // nothing where the frequency is given
  const FourierFitOptions& options_;
  int iterations_ = 0;
};

Fundamental Search::failed(std::string reason) const {
  Fundamental result;
  result.failure = std::move(reason);
  result.iterations = iterations_;
  return result;
}

std::string Search::too_few_cycles(double cycles) const {
  return fmt::format("{:.3g} cycles of {:.5g} Hz in the record, fewer than {:g}", cycles,
                     hertz(cycles), kLeastCycles);
}

std::string Search::too_few_points(double cycles) const {
  return fmt::format("{:.3g} points per cycle of {:.5g} Hz, too few for its first harmonic",
                     points() / cycles, hertz(cycles));
}

/// The order that the sampling rate and the number of points allow; 0 where they allow none.
Index Search::largest_order(double cycles, Index wanted) const {
  const auto by_rate = static_cast<Index>(kLargestShareOfRate * points() / cycles);
  const Index by_points = (regression_.times().points() / 2 - 1 - regression_.degree()) / 2;
  return std::max<Index>(0, std::min({wanted, by_rate, by_points}));
}

Descent Search::descend_from(double cycles, Index order, OmegaRange range) {
  Descent descent = descend(regression_, big_omega(cycles), order, range, options_.max_iterations);
  iterations_ += descent.iterations;
  return descent;
}

/// A single line, as its own fundamental of order 1.
double Search::refined_line(double cycles) {
  if (largest_order(cycles, 1) < 1) return cycles;
  const Descent line = descend_from(cycles, 1, line_range(cycles));
  return line.converged ? cycles_of(line.fit.big_omega) : cycles;
}

/// Where to begin near a guess: the comb of lines with the largest power, made precise by its
/// strongest line. Of few cycles the lines overlap, and fits at points across the range decide.
double Search::start_near(double cycles, OmegaRange range, Index order) {
  const double lowest = cycles_of(range.lowest);
  const double highest = cycles_of(range.highest);
  const double comb = spectrum_->strongest_comb(lowest, highest, order);
  const auto multiple = spectrum_->strongest_multiple(comb, order);
  const double n = static_cast<double>(multiple);
  const double best = std::clamp(refined_line(comb * n) / n, lowest, highest);
  if (cycles >= kFewCycles) return best;
  const double width = range.highest - range.lowest;
  const auto steps = 1 + static_cast<int>(width * static_cast<double>(order) / 2.0);
  std::pair<double, double> lowest_loss{INFINITY, best};
  for (int i = -1; i <= steps; ++i) {
    const double at = i < 0 ? best : std::lerp(lowest, highest, static_cast<double>(i) / steps);
    const HarmonicFit fit = regression_.fit(big_omega(at), order);
    ++iterations_;
    if (fit.determined) lowest_loss = std::min(lowest_loss, {loss(regression_, fit), at});
  }
  return lowest_loss.second;
}

/// Whether the harmonics of the fit that are not multiples of the divisor contain, in some signal,
/// more than noise and trifles: the period is then not a divisor-th of that of the fit.
bool Search::needed(const HarmonicFit& fit, Index divisor) const {
  const Eigen::MatrixXd power = 0.5 * fit.harmonics().cwiseAbs2();
  for (Index j = 0; j < regression_.signals(); ++j) {
    const double variance = regression_.square()(j) / points();
    const double noise_of_line = 2.0 / points() * std::max(0.0, fit.squares(j)) /
                                 (points() - static_cast<double>(fit.unknowns()));
    double sum = 0.0;
    double noise = 0.0;
    for (Index n = 1; n <= fit.order; ++n) {
      if (n % divisor == 0) continue;
      sum += power(n - 1, j);
      noise += noise_of_line;
    }
    if (sum > kLeastShare * variance && sum > kNoiseFactor * noise) return true;
  }
  return false;
}

/// Twice the leakage to a place from the lines at the multiples of `cycles` beside it.
double Search::leakage(double cycles, double place, Index signal) const {
  const double below = std::floor(place / cycles) * cycles;
  const auto from = [&](double line) {
    return line > 0.0 ? spectrum_->power(line, signal) * LineSpectrum::leakage(place - line) : 0.0;
  };
  return 2.0 * (from(below) + from(below + cycles));
}

/// Whether the spectrum has a line at a multiple of cycles/divisor; the fit then decides. Half of
/// the power may be lost between the bins of the spectrum.
bool Search::worth_trying(double cycles, Index divisor) const {
  for (Index j = 0; j < regression_.signals(); ++j) {
    for (Index k = 1; k <= 3 * divisor; ++k) {
      if (k % divisor == 0) continue;
      const double place = cycles * static_cast<double>(k) / static_cast<double>(divisor);
      const double power = spectrum_->power(place, j);
      const double lines = 3.0 * static_cast<double>(divisor);
      if (power > 0.5 * kLeastShare / lines && power > kNoiseFactor * spectrum_->noise(j) / 4.0 &&
          power > leakage(cycles, place, j)) {
        return true;
      }
    }
  }
  return false;
}

/// Minus the likelihood's logarithm with a price for each unknown [G. Schwarz, Ann. Statist. 6
/// (1978) 461]: fits of different order compare by it.
double Search::information_criterion(const HarmonicFit& fit) const {
  const double signals = static_cast<double>(regression_.signals());
  const double unknowns = signals * static_cast<double>(fit.unknowns());
  return points() * loss(regression_, fit) + 0.5 * unknowns * std::log(points());
}

/// The fundamental to which the strongest line belongs: it, or its fraction that has lines of its
/// own and explains the signals best; and so on from that. A multiple of a divisor that holds is
/// left to the next round, where it must have lines that the divisor does not have.
double Search::longest_period(double cycles) {
  std::vector<Index> accepted;
  std::pair<double, double> best{INFINITY, cycles};
  for (Index m = 2; m <= kLargestDivisor; ++m) {
    const double divided = cycles / static_cast<double>(m);
    const bool repeats = std::ranges::any_of(accepted, [m](Index h) { return m % h == 0; });
    if (repeats || divided < kLeastCycles || !worth_trying(cycles, m)) continue;
    const Index order =
        largest_order(divided, std::min(kLargestTrialOrder, m * Index{options_.order}));
    const Descent trial = descend_from(divided, order, line_range(divided));
    if (!trial.converged || !needed(trial.fit, m)) continue;
    accepted.push_back(m);
    best = std::min(best, {information_criterion(trial.fit), cycles_of(trial.fit.big_omega)});
  }
  return accepted.empty() ? cycles : longest_period(best.second);
}

Fundamental Search::finish(Descent descent, std::string_view where) {
  Fundamental result;
  result.iterations = iterations_;
  result.fit = std::move(descent.fit);
  if (!result.fit.determined) {
    result.failure = "the times of the points do not determine the coefficients";
    return result;
  }
  const HarmonicFit& fit = result.fit;
  result.step = std::abs(descent.step) / fit.big_omega;
  const double cycles = cycles_of(fit.big_omega);
  const Eigen::ArrayXd left = fit.squares.array() / regression_.square().array();
  const double freedom = (points() - 1.0 - static_cast<double>(regression_.degree())) /
                         (points() - static_cast<double>(fit.unknowns()));
  const double explained = 1.0 - freedom * left.minCoeff();
  if (fit.order < options_.order) {
    result.warnings.push_back(
        {"order_reduced",
         fmt::format("order {} instead of {}: {:.4g} points per cycle, {} in all, allow no more",
                     fit.order, options_.order, points() / cycles, points())});
  }
  if (cycles < kLeastCycles) {
    result.failure = too_few_cycles(cycles);
  } else if (explained < options_.least_explained) {
    result.failure = fmt::format(
        "no periodic content {}: {:.5g} Hz and its harmonics explain {:.2g} of the variance", where,
        hertz(cycles), std::max(0.0, explained));
  } else if (!descent.converged) {
    result.failure =
        fmt::format("the frequency {} has no best value after {} iterations", where, iterations_);
  }
  return result;
}

Fundamental Search::near_guess(double guess) {
  const double cycles = cycles_of_guess(guess);
  const double tolerance = options_.guess_tolerance;
  if (cycles * (1.0 + tolerance) < kLeastCycles) return failed(too_few_cycles(cycles));
  const OmegaRange range{big_omega(cycles * (1.0 - tolerance)),
                         big_omega(cycles * (1.0 + tolerance))};
  const Index order = largest_order(cycles * (1.0 + tolerance), options_.order);
  if (order < 1) return failed(too_few_points(cycles));
  const double start = start_near(cycles, range, order);
  const std::string where =
      fmt::format("within {:g} % of the guess {:.5g} Hz", 100.0 * tolerance, guess);
  Fundamental result = finish(descend_from(start, order, range), where);
  for (Index m = 2; m <= order && result.failure.empty(); ++m) {
    if (needed(result.fit, m)) continue;
    result.failure = fmt::format(
        "only each {}. multiple of the guess {:.5g} Hz is present: the "
        "fundamental is {:.5g} Hz",
        m, guess, static_cast<double>(m) * hertz(cycles_of(result.fit.big_omega)));
  }
  return result;
}

Fundamental Search::at_guess(double guess) {
  const double cycles = cycles_of_guess(guess);
  if (cycles < kLeastCycles) return failed(too_few_cycles(cycles));
  const Index order = largest_order(cycles, options_.order);
  if (order < 1) return failed(too_few_points(cycles));
  Descent fixed;
  fixed.fit = regression_.fit(big_omega(cycles), order);
  fixed.converged = true;
  iterations_ = 1;
  return finish(std::move(fixed), fmt::format("at {:.5g} Hz", guess));
}

Fundamental Search::anywhere() {
  const std::optional<double> line = spectrum_->strongest(kLeastCycles - 0.5, 0.5 * points());
  if (!line) return failed("no periodic content: the spectrum is empty");
  if (largest_order(*line, 1) < 1) return failed(too_few_points(*line));
  const double alone = refined_line(*line);
  const double cycles = options_.seek_longer_period ? longest_period(alone) : alone;
  const Index order = largest_order(cycles, options_.order);
  return finish(descend_from(cycles, order, line_range(cycles)), "in the record");
}

}  // namespace

Fundamental find_fundamental(const HarmonicRegression& regression, const Eigen::MatrixXd& signals,
                             const FourierFitOptions& options) {
  Search search(regression, signals, options);
  if (!options.frequency_guess) return search.anywhere();
  const double guess = *options.frequency_guess;
  return options.fit_frequency ? search.near_guess(guess) : search.at_guess(guess);
}

}  // namespace microslip
