// SPDX-License-Identifier: MIT
#include "microslip/identify/parametric/parametric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "microslip/algebra/svd.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/parametric/parametric_form.hpp"
#include "microslip/identify/parametric/parametric_search.hpp"
#include "microslip/identify/posterior/serial_correlation.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/identify/smoothing/infinity.hpp"
#include "microslip/identify/smoothing/signed_density.hpp"

namespace microslip {
namespace {

using Vector = std::vector<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::string with_unit(const FittedParameter& p) {
  return p.unit == "1" ? fmt::format("{:.6g}", p.value) : fmt::format("{:.6g} {}", p.value, p.unit);
}

void check_count(const LevelEvidence& evidence, std::size_t parameters) {
  if (evidence.size() > parameters) return;
  throw InputError("number of distinct amplitudes", static_cast<double>(evidence.size()),
                   fmt::format("must be at least {}, one more than the parameters", parameters + 1),
                   "Measure more levels, or fit a model with fewer parameters");
}

double sum_of_squares(const Vector& v) { return view_of(v).squaredNorm(); }

/// The mean of two columns; of squares for those that are deviations.
void mix(const Vector& before, double weight, bool squares, Vector& column) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    column[i] = squares
                    ? std::hypot(std::sqrt(weight) * column[i], std::sqrt(1.0 - weight) * before[i])
                    : weight * column[i] + (1.0 - weight) * before[i];
  }
}

double largest_log_ratio(const Vector& a, const Vector& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(std::log(a[i] / b[i])));
  }
  return largest;
}

void check_dissipation(const LevelEvidence& evidence) {
  const Levels& levels = evidence.levels();
  if (evidence.dissipation_std_given() || std::ranges::max(levels.dissipation) > 0.0) return;
  throw InputError(
      "dissipation", "0 at all levels",
      "must be positive at one level at least unless all standard deviations are given");
}

/// One fit from levels to result.
class Fit {
 public:
  Fit(const LevelEvidence& evidence, double stiffness, ParametricModel model,
      const ParametricOptions& options)
      : evidence_(evidence),
        levels_(evidence.levels()),
        stiffness_(stiffness),
        options_(options),
        form_(make_parametric_form(model, levels_, stiffness)),
        weighing_(evidence.typical()),
        model_(model) {
    problem_.coordinates = form_->coordinates();
    if (options.linear_damping) problem_.coordinates.push_back(damping_coordinate());
    check_count(evidence, problem_.coordinates.size());
    check_dissipation(evidence);
    if (!evidence.dissipation_std_given()) scatter_.dissipation = kFirstScatter;
    if (unknown_secant()) scatter_.secant_stiffness = kFirstScatter * stiffness;
    sigma_ = evidence_.deviations(weighing_, scatter_);
    problem_.residuals = [this](std::span<const double> q) { return residuals(q); };
  }

  ParametricResult run() {
    const Stopwatch watch;
    const Minimum best = search();
    ParametricResult result{.model = model_,
                            .joint = form_->joint(best.q),
                            .linear_damping = damping(best.q),
                            .parameters = {},
                            .covariance = {},
                            .dissipation_noise = {},
                            .secant_noise = {},
                            .summary = summary(best),
                            .warnings = form_->limits(best.q)};
    add_parameters(best, result);
    add_quality(best, result);
    add_warnings(result);
    add_misfit_warning(level_residuals(best.q).dissipation, result);
    result.summary.wall_seconds = watch.seconds();
    return result;
  }

 private:
  /// βl, J/m², from 0; its scale is the limit of one level alone.
  [[nodiscard]] Coordinate damping_coordinate() const {
    double scale = kInfinity;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const double ratio = levels_.dissipation[i] / (levels_.amplitude[i] * levels_.amplitude[i]);
      if (ratio > 0.0) scale = std::min(scale, ratio);
    }
    return {0.0, kInfinity, std::isfinite(scale) ? scale : 1.0, true, false};
  }

  [[nodiscard]] double damping(std::span<const double> q) const {
    return options_.linear_damping ? q.back() : 0.0;
  }

  [[nodiscard]] bool unknown_secant() const {
    return !levels_.secant_stiffness.empty() && !evidence_.secant_std_given();
  }

  /// Rows of D, those of repeated levels too; and of k_eq.
  [[nodiscard]] double loss_rows() const {
    return static_cast<double>(evidence_.measured().size());
  }
  [[nodiscard]] double secant_rows() const {
    return static_cast<double>(levels_.secant_stiffness.size());
  }
  [[nodiscard]] double rows() const { return loss_rows() + secant_rows(); }

  [[nodiscard]] LevelRows prediction(std::span<const double> q) const {
    return evidence_.predict(form_->joint(q), damping(q));
  }

  [[nodiscard]] LevelRows level_residuals(std::span<const double> q) const {
    return evidence_.residuals(prediction(q), sigma_);
  }

  [[nodiscard]] VectorXd residuals(std::span<const double> q) const {
    const LevelRows left = level_residuals(q);
    const auto n = static_cast<Index>(left.dissipation.size());
    const auto m = static_cast<Index>(left.secant_stiffness.size());
    VectorXd result(n + m);
    result.head(n) = view_of(left.dissipation);
    result.tail(m) = view_of(left.secant_stiffness);
    return result;
  }

  /// Σ of (rounding of the values/σ)².
  [[nodiscard]] double rounding() const {
    const LevelRows share = evidence_.residuals(
        {Vector(levels_.size(), 0.0), Vector(levels_.secant_stiffness.size(), 0.0)}, sigma_);
    constexpr double kRounding = 1e-10;
    return kRounding * kRounding *
           (sum_of_squares(share.dissipation) + sum_of_squares(share.secant_stiffness));
  }

  [[nodiscard]] std::vector<Vector> candidates() const {
    std::vector<Vector> grid = form_->grid();
    if (!options_.linear_damping) return grid;
    std::vector<Vector> result;
    for (const Vector& q : grid) {
      for (const double share : {0.05, 0.5, 0.95}) {
        result.push_back(q);
        result.back().push_back(share * problem_.coordinates.back().scale);
      }
    }
    return result;
  }

  /// The smallest sum from these starts, and from those beyond its kinks as long as it improves.
  [[nodiscard]] Minimum minimise_from(const std::vector<Vector>& from) {
    constexpr int kMostRounds = 10;
    problem_.rounding = rounding();
    Minimum best = minimise(problem_, from, options_.starts, options_.max_evaluations);
    for (int round = 0; round < kMostRounds; ++round) {
      const std::vector<Vector> beyond = neighbours(best.q);
      if (beyond.empty()) break;
      Minimum next = minimise(problem_, beyond, options_.starts, options_.max_evaluations);
      const bool lower =
          next.sum_of_squares < best.sum_of_squares * (1.0 - 1e-6) - problem_.rounding;
      next.iterations += best.iterations;
      best.iterations = next.iterations;
      if (!lower) break;
      best = std::move(next);
    }
    return best;
  }

  [[nodiscard]] std::vector<Vector> neighbours(const Vector& q) const {
    const Vector start = inside(q);
    auto result = form_->neighbours(std::span(start).first(form_->names().size()));
    if (options_.linear_damping) {
      for (Vector& other : result) other.push_back(start.back());
    }
    return result;
  }

  /// Updates σ where they are a share of the prediction, or include the effect of those of the
  /// amplitude, by the best joint so far. Where two minima are nearly as good the alternation may
  /// cycle: later updates count less and less.
  /// @return  the largest change of ln σ.
  double update_prediction(const Minimum& best, int turn) {
    constexpr int kFullTurns = 4;
    const double weight = 1.0 / std::max(1, turn - kFullTurns);
    const LevelPrediction before = weighing_;
    weighing_ = {.value = prediction(best.q),
                 .change = evidence_.amplitude_change(form_->joint(best.q), damping(best.q))};
    mix(before.value.dissipation, weight, false, weighing_.value.dissipation);
    mix(before.value.secant_stiffness, weight, false, weighing_.value.secant_stiffness);
    mix(before.change.dissipation, weight, true, weighing_.change.dissipation);
    mix(before.change.secant_stiffness, weight, true, weighing_.change.secant_stiffness);
    const LevelRows sigma = evidence_.deviations(weighing_, scatter_);
    const LevelRows last = std::exchange(sigma_, sigma);
    return std::max(largest_log_ratio(sigma.dissipation, last.dissipation),
                    largest_log_ratio(sigma.secant_stiffness, last.secant_stiffness));
  }

  /// Fit and σ alternately, unless all σ are known. The iteration follows the best start, and
  /// when σ has settled all starts are tried again.
  Minimum search() {
    constexpr int kMostTurns = 60;
    constexpr double kStill = 1.0;  // see update_weights()
    const std::vector<Vector> grid = candidates();
    const bool known =
        evidence_.dissipation_std_given() && !unknown_secant() && !evidence_.amplitude_std_counts();
    Minimum best = minimise_from(grid);
    double change = known ? 0.0 : update_weights(best, 0);
    bool all_tried = known;
    for (int turn = 0; turn < kMostTurns && !(all_tried && change < kStill); ++turn) {
      all_tried = change < kStill;
      std::vector<Vector> from = all_tried ? grid : std::vector<Vector>{};
      from.push_back(inside(best.q));
      Minimum next = minimise_from(from);
      next.iterations += best.iterations;
      best = std::move(next);
      change = update_weights(best, turn + 1);
    }
    noise_settled_ = change < kStill;
    best.sum_of_squares = residuals(best.q).squaredNorm();
    return best;
  }

  /// @return  the largest change of a noise or a σ, relative to a change that affects the result
  ///          far less than its own error: σ only weights the levels against each other.
  double update_weights(const Minimum& best, int turn) {
    constexpr double kStillNoise = 1e-3;
    constexpr double kStillSigma = 1e-2;
    const double noise = estimate_noise(best);
    sigma_ = evidence_.deviations(weighing_, scatter_);
    const double shape = update_prediction(best, turn);
    // One scatter of all rows changes no weight against another.
    const bool weighs = levels_.secant_stiffness.size() > 0;
    return std::max(weighs ? noise / kStillNoise : 0.0, shape / kStillSigma);
  }

  /// A start near q that is inside of all ranges.
  [[nodiscard]] Vector inside(Vector q) const {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Coordinate& c = problem_.coordinates[i];
      const double margin = 1e-3 * (std::isfinite(c.upper) ? c.upper - c.lower : c.scale);
      if (q[i] <= c.lower) q[i] = c.lower + margin;
      if (q[i] >= c.upper) q[i] = c.upper - margin;
    }
    return q;
  }

  /// The degrees of freedom of the residual are shared among the kinds of row by their numbers.
  double estimate_noise(const Minimum& best) {
    constexpr double kSmallestScatter = 1e-9;  // below it a misfit is rounding
    const LevelRows left = level_residuals(best.q);
    const double freedom = (rows() - static_cast<double>(best.free().size())) / rows();
    double change = 0.0;
    const auto update = [&](double sum, double count, double least, double& scatter) {
      const double next = std::max(least, scatter * std::sqrt(sum / (freedom * count)));
      change = std::max(change, std::abs(std::log(next / scatter)));
      scatter = next;
    };
    if (!evidence_.dissipation_std_given()) {
      update(sum_of_squares(left.dissipation) + evidence_.repeat_sum(sigma_), loss_rows(),
             kSmallestScatter, scatter_.dissipation);
    }
    if (unknown_secant()) {
      update(sum_of_squares(left.secant_stiffness), secant_rows(), kSmallestScatter * stiffness_,
             scatter_.secant_stiffness);
    }
    return change;
  }

  [[nodiscard]] Summary summary(const Minimum& best) const {
    Summary summary{.method = fmt::format("least squares, {} density", to_string(model_)),
                    .iterations = best.iterations};
    summary.residual = step_left(best);
    summary.stop = best.converged && noise_settled_ ? Stop::kConverged : Stop::kLimit;
    summary.reason = !best.converged ? "the best start ran out of evaluations"
                     : !noise_settled_
                         ? "the estimated noise does not settle"
                         : fmt::format("smallest sum of squares; {} of {} starts ended there",
                                       best.agreeing, best.starts);
    return summary;
  }

  /// The remaining Gauss–Newton step, in u, which is relative.
  [[nodiscard]] double step_left(const Minimum& best) const {
    if (best.free().empty()) return 0.0;
    Eigen::JacobiSVD<MatrixXd> svd(free_jacobian(problem_, best),
                                   Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(kRankTolerance);
    return svd.solve(residuals(best.q)).cwiseAbs().maxCoeff();
  }

  void add_parameters(const Minimum& best, ParametricResult& result) const {
    const auto report = [this](std::span<const double> q) {
      Vector p = form_->parameters(q.first(form_->names().size()));
      if (options_.linear_damping) p.push_back(q.back());
      return VectorXd(Eigen::Map<const VectorXd>(p.data(), static_cast<Index>(p.size())));
    };
    auto names = form_->names();
    if (options_.linear_damping) names.push_back({"linear_damping", "J/m^2"});
    const VectorXd value = report(best.q);
    const MatrixXd covariance = this->covariance(best, report, value.size());
    for (Index i = 0; i < value.size(); ++i) {
      const auto place = static_cast<std::size_t>(i);
      const bool at_bound = best.hold[place] != Hold::kFree;
      result.parameters.push_back({.name = names[place].name,
                                   .unit = names[place].unit,
                                   .value = value[i],
                                   .standard_error = std::sqrt(covariance(i, i)),
                                   .at_bound = at_bound});
      for (Index j = 0; j < value.size(); ++j) result.covariance.push_back(covariance(i, j));
    }
  }

  /// G(JᵀJ)⁻¹Gᵀ, with J of the residuals and G of the parameters over the free u. Directions
  /// of u to which the residuals are insensitive make the parameters that change along them
  /// unknown: ∞.
  template <class Report>
  [[nodiscard]] MatrixXd covariance(const Minimum& best, const Report& report, Index size) const {
    MatrixXd result = MatrixXd::Zero(size, size);
    if (best.free().empty()) return result;
    const Eigen::JacobiSVD<MatrixXd> svd(free_jacobian(problem_, best),
                                         Eigen::ComputeThinU | Eigen::ComputeThinV);
    const MatrixXd along = free_jacobian(problem_, best, report) * svd.matrixV();
    const VectorXd& singular = svd.singularValues();
    for (Index k = 0; k < singular.size(); ++k) {
      if (singular[k] > kRankTolerance * singular[0]) {
        result += along.col(k) * along.col(k).transpose() / (singular[k] * singular[k]);
      }
    }
    for (Index k = 0; k < singular.size(); ++k) {
      if (singular[k] > kRankTolerance * singular[0]) continue;
      for (Index i = 0; i < size; ++i) {
        const double share = std::abs(along(i, k)) / along.row(i).norm();
        if (share > 1e-3) result(i, i) = kInfinity;  // not for 0/0, which is a fixed parameter
      }
    }
    return result;
  }

  void add_quality(const Minimum& best, ParametricResult& result) const {
    result.chi_squared = best.sum_of_squares + evidence_.repeat_sum(sigma_);
    result.degrees_of_freedom = static_cast<int>(rows()) - static_cast<int>(best.free().size());
    if (!evidence_.dissipation_std_given()) result.dissipation_noise = scatter_.dissipation;
    if (unknown_secant()) result.secant_noise = scatter_.secant_stiffness;
    const Vector model = prediction(best.q).dissipation;
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < model.size(); ++i) {
      if (!(levels_.dissipation[i] > 0.0)) continue;
      sum += std::pow(model[i] / levels_.dissipation[i] - 1.0, 2);
      count += 1.0;
    }
    result.misfit = count > 0.0 ? std::sqrt(sum / count) : 0.0;
    add_criteria(best, result);
  }

  /// Criteria with each unknown scatter at its most likely value.
  void add_criteria(const Minimum& best, ParametricResult& result) const {
    constexpr double kLeast = 1e-12;  // an exact fit is not infinitely likely
    const LevelRows left = level_residuals(best.q);
    LevelScatter likely = scatter_;
    double count = static_cast<double>(result.parameters.size());
    const auto maximise = [&](double sum, double rows, double& scatter) {
      scatter *= std::sqrt(std::max(sum / rows, kLeast));
      count += 1.0;
    };
    if (result.dissipation_noise) {
      maximise(sum_of_squares(left.dissipation) + evidence_.repeat_sum(sigma_), loss_rows(),
               likely.dissipation);
    }
    if (result.secant_noise) {
      maximise(sum_of_squares(left.secant_stiffness), secant_rows(), likely.secant_stiffness);
    }
    const LevelPrediction fitted{.value = prediction(best.q), .change = weighing_.change};
    const double deviance = -2.0 * evidence_.log_likelihood(fitted, likely);
    result.aic = deviance + 2.0 * count;
    result.bic = deviance + count * std::log(rows());
  }

  void add_warnings(ParametricResult& result) const {
    for (const FittedParameter& p : result.parameters) {
      if (p.at_bound) {
        result.warnings.push_back(
            {"parameter_at_bound", fmt::format("{} = {} is at the end of its range: standard "
                                               "errors of the others assume it fixed there.",
                                               p.name, with_unit(p))});
      }
      if (std::isinf(p.standard_error)) {
        result.warnings.push_back(
            {"not_identifiable",
             fmt::format("the levels do not determine {}; {} is one of many values.", p.name,
                         with_unit(p))});
      }
    }
    const bool unusable = !levels_.dissipation_std.empty() && !evidence_.dissipation_std_given();
    if (unusable) {
      result.warnings.push_back(
          {"noise_not_given",
           "dissipation_std is 0 at some level: it was not used, and noise in "
           "proportion to D was estimated from the misfit."});
    }
  }

  /// @param residual  of the energies.
  void add_misfit_warning(const Vector& residual, ParametricResult& result) const {
    constexpr double kRounding = 1e-6;
    constexpr double kSignificant =
        4.0;  // standard deviations: once in 3e4 fits of the right model
    if (result.misfit < kRounding) return;
    const SerialCorrelation serial = serial_correlation(residual);
    if (serial.deviations < kSignificant) return;
    result.warnings.push_back(
        {"systematic_misfit",
         fmt::format("the misfit, {} of D, is not scatter: errors of neighbouring levels have a "
                     "correlation of {:.2f}. The joint does not follow this model, which the "
                     "standard errors do not include. Take the free density or another model.",
                     percent_text(result.misfit), serial.correlation)});
  }

  static constexpr double kRankTolerance = 1e-7;  // above the error of the differences

  static constexpr double kFirstScatter = 0.01;  // where the search for it starts

  const LevelEvidence& evidence_;
  const Levels& levels_;
  double stiffness_;
  const ParametricOptions& options_;
  std::unique_ptr<ParametricForm> form_;
  LevelPrediction weighing_;  // from which σ is computed
  LevelScatter scatter_;
  LevelRows sigma_;
  ParametricModel model_;
  LeastSquares problem_;
  bool noise_settled_ = true;
};

}  // namespace

void ParametricOptions::check() const {
  if (starts < 1) throw InputError("starts", starts, "must be at least 1");
  if (max_evaluations < 1) {
    throw InputError("max_evaluations", max_evaluations, "must be at least 1");
  }
}

ParametricResult fit_parametric(const LevelEvidence& evidence, double stiffness,
                                ParametricModel model, const ParametricOptions& options) {
  check_stiffness(stiffness);
  options.check();
  return Fit(evidence, stiffness, model, options).run();
}

}  // namespace microslip
