// SPDX-License-Identifier: MIT
#include "microslip/identify/parametric.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/identify/infinity.hpp"
#include "microslip/identify/parametric_form.hpp"
#include "microslip/identify/parametric_search.hpp"
#include "microslip/identify/serial_correlation.hpp"
#include "microslip/identify/signed_density.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

using Vector = std::vector<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One kind of row: what was measured, and its standard deviation or that it is the share `scale`
/// of the measured value.
class Measured {
 public:
  Measured(const Vector& value, const Vector& deviation)
      : value_(value),
        known_(!deviation.empty() &&
               std::ranges::all_of(deviation, [](double s) { return s > 0.0; })),
        sigma_(known_ ? deviation : value) {}

  [[nodiscard]] std::size_t size() const { return value_.size(); }
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] double value(std::size_t i) const { return value_[i]; }
  [[nodiscard]] double scale() const { return scale_; }
  void set_scale(double scale) { scale_ = std::max(scale, kSmallestScale); }

  [[nodiscard]] double sigma(std::size_t i) const {
    if (!known_) return scale_ * sigma_[i];
    return through_slope_.empty() ? sigma_[i] : std::hypot(sigma_[i], through_slope_[i]);
  }

  /// What deviations of the amplitude make of a known σ.
  /// @param through_slope  of the joint, one a level.
  /// @param weight         that it has in the mean of squares with what was set before.
  /// @return  the largest change of ln σ.
  double set_through_slope(Vector through_slope, double weight) {
    for (std::size_t i = 0; i < through_slope_.size(); ++i) {
      through_slope[i] = std::hypot(std::sqrt(weight) * through_slope[i],
                                    std::sqrt(1.0 - weight) * through_slope_[i]);
    }
    const Vector before = std::exchange(through_slope_, std::move(through_slope));
    double change = 0.0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double old = before.empty() ? sigma_[i] : std::hypot(sigma_[i], before[i]);
      change = std::max(change, std::abs(std::log(sigma(i) / old)));
    }
    return change;
  }
  [[nodiscard]] double residual(std::size_t i, double model) const {
    return (model - value_[i]) / sigma(i);
  }

  /// Σ of (rounding of the values/σ)².
  [[nodiscard]] double rounding() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size(); ++i) sum += std::pow(1e-10 * value_[i] / sigma(i), 2);
    return sum;
  }

 private:
  static constexpr double kSmallestScale = 1e-9;  // below it a misfit is rounding

  Vector value_;
  bool known_;
  Vector sigma_;
  Vector through_slope_;  // empty, or one a level
  double scale_ = 0.01;   // where the search for it starts
};

std::string with_unit(const FittedParameter& p) {
  return p.unit == "1" ? fmt::format("{:.6g}", p.value) : fmt::format("{:.6g} {}", p.value, p.unit);
}

void check_options(const ParametricOptions& options) {
  if (options.starts < 1) throw InputError("starts", options.starts, "must be at least 1");
  if (options.max_evaluations < 1) {
    throw InputError("max_evaluations", options.max_evaluations, "must be at least 1");
  }
}

void check_count(const Levels& levels, std::size_t parameters) {
  const std::set<double> distinct(levels.amplitude.begin(), levels.amplitude.end());
  if (distinct.size() > parameters) return;
  throw InputError("number of distinct amplitudes", static_cast<double>(distinct.size()),
                   fmt::format("must be at least {}, one more than the parameters", parameters + 1),
                   "Measure more levels, or fit a model with fewer parameters");
}

void check_relative(const Levels& levels, const Measured& dissipation) {
  if (dissipation.known()) return;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels.dissipation[i] > 0.0) continue;
    throw InputError(fmt::format("dissipation of level {}", i + 1), levels.dissipation[i],
                     "must be positive where the standard deviations are not all given",
                     "Leave the level out or give dissipation_std at every level");
  }
}

/// One fit from levels to result.
class Fit {
 public:
  Fit(const Levels& levels, double stiffness, ParametricModel model,
      const ParametricOptions& options)
      : levels_(levels),
        options_(options),
        form_(make_parametric_form(model, levels, stiffness)),
        loss_(levels.dissipation, levels.dissipation_std),
        secant_(levels.secant_stiffness, levels.secant_stiffness_std),
        model_(model) {
    problem_.coordinates = form_->coordinates();
    if (options.linear_damping) problem_.coordinates.push_back(damping_coordinate());
    check_count(levels, problem_.coordinates.size());
    check_relative(levels, loss_);
    problem_.residuals = [this](std::span<const double> q) { return residuals(q); };
  }

  ParametricResult run() {
    const auto start = std::chrono::steady_clock::now();
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
    add_misfit_warning(residuals(best.q), result);
    result.summary.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

 private:
  /// βl, J/m², from 0; its scale is what one level alone would allow.
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

  [[nodiscard]] std::size_t rows() const { return loss_.size() + secant_.size(); }

  [[nodiscard]] double modelled_loss(const Joint& joint, double linear, std::size_t i) const {
    const double a = levels_.amplitude[i];
    return dissipation(joint, a) + linear * a * a;
  }

  [[nodiscard]] VectorXd residuals(std::span<const double> q) const {
    const Joint joint = form_->joint(q);
    VectorXd result(static_cast<Index>(rows()));
    Index row = 0;
    for (std::size_t i = 0; i < loss_.size(); ++i) {
      result[row++] = loss_.residual(i, modelled_loss(joint, damping(q), i));
    }
    for (std::size_t i = 0; i < secant_.size(); ++i) {
      result[row++] = secant_.residual(i, secant_stiffness(joint, levels_.amplitude[i]));
    }
    return result;
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

  /// The smallest sum from these starts, and from those beyond its kinks as long as that helps.
  [[nodiscard]] Minimum minimise_from(const std::vector<Vector>& from) {
    constexpr int kMostRounds = 10;
    problem_.rounding = loss_.rounding() + secant_.rounding();
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

  /// Deviations of the amplitude act through the slopes of D and k_eq, which the joint tells.
  [[nodiscard]] bool weighs_amplitude() const {
    return !levels_.amplitude_std.empty() && (loss_.known() || secant_.known());
  }

  /// Before there is a joint: D grows with A³ or so.
  void guess_slopes() {
    if (!weighs_amplitude() || !loss_.known()) return;
    Vector loss;
    for (std::size_t i = 0; i < loss_.size(); ++i) {
      loss.push_back(3.0 * loss_.value(i) * levels_.amplitude_std[i] / levels_.amplitude[i]);
    }
    loss_.set_through_slope(std::move(loss), 1.0);
  }

  /// What ± σ_A makes of D and k_eq of the best joint so far. Not their slopes at A, which jump
  /// where an atom slips: the turns would go round in circles. Where two minima are
  /// nearly as good they still may: later turns count less and less.
  /// @return  the largest change of ln σ.
  double update_slopes(const Minimum& best, int turn) {
    if (!weighs_amplitude()) return 0.0;
    constexpr int kFullTurns = 4;
    const double weight = 1.0 / std::max(1, turn - kFullTurns);
    const Joint joint = form_->joint(best.q);
    const double linear = damping(best.q);
    Vector loss;
    Vector secant;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const double above = levels_.amplitude[i] + levels_.amplitude_std[i];
      const double below = std::max(0.0, levels_.amplitude[i] - levels_.amplitude_std[i]);
      const auto half_change = [&](const auto& value) {
        return 0.5 * std::abs(value(above) - value(below));
      };
      loss.push_back(half_change([&](double a) { return dissipation(joint, a) + linear * a * a; }));
      secant.push_back(half_change([&](double a) { return secant_stiffness(joint, a); }));
    }
    double change = 0.0;
    if (loss_.known()) change = loss_.set_through_slope(std::move(loss), weight);
    if (secant_.size() > 0 && secant_.known()) {
      change = std::max(change, secant_.set_through_slope(std::move(secant), weight));
    }
    return change;
  }

  /// Fit and unknown noise in turns, and weights by slopes of the fit. A single unknown noise of
  /// all rows changes no weight against another: then the first turn is the last. Otherwise the
  /// turns follow the best start, and when the noise has settled all starts are tried again.
  Minimum search() {
    constexpr int kMostTurns = 60;
    constexpr double kStill = 1.0;  // see update_weights()
    const std::vector<Vector> grid = candidates();
    guess_slopes();
    Minimum best = minimise_from(grid);
    double change = update_weights(best, 0);
    const bool mixed =
        (secant_.size() > 0 && !(loss_.known() && secant_.known())) || weighs_amplitude();
    bool all_tried = !mixed;
    for (int turn = 0; turn < kMostTurns && !(all_tried && (change < kStill || !mixed)); ++turn) {
      all_tried = change < kStill;
      std::vector<Vector> from = all_tried ? grid : std::vector<Vector>{};
      from.push_back(inside(best.q));
      Minimum next = minimise_from(from);
      next.iterations += best.iterations;
      best = std::move(next);
      change = update_weights(best, turn + 1);
    }
    noise_settled_ = !mixed || change < kStill;
    best.sum_of_squares = residuals(best.q).squaredNorm();
    return best;
  }

  /// @return  the largest change of a noise or a σ, over what changes the result far less than its
  ///          own error: σ weighs the levels against each other only.
  double update_weights(const Minimum& best, int turn) {
    constexpr double kStillNoise = 1e-3;
    constexpr double kStillSlopes = 1e-2;
    const double noise = estimate_noise(best);
    return std::max(noise / kStillNoise, update_slopes(best, turn) / kStillSlopes);
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
    const VectorXd r = residuals(best.q);
    const auto all = static_cast<double>(rows());
    const double freedom = (all - static_cast<double>(best.free().size())) / all;
    double change = 0.0;
    const auto update = [&](Measured& kind, const VectorXd& part) {
      if (kind.known() || kind.size() == 0) return;
      const double before = kind.scale();
      kind.set_scale(before *
                     std::sqrt(part.squaredNorm() / (freedom * static_cast<double>(kind.size()))));
      change = std::max(change, std::abs(std::log(kind.scale() / before)));
    };
    update(loss_, r.head(static_cast<Index>(loss_.size())));
    update(secant_, r.tail(static_cast<Index>(secant_.size())));
    return change;
  }

  [[nodiscard]] Summary summary(const Minimum& best) const {
    Summary summary{.method = fmt::format("least squares, {} density", to_string(model_)),
                    .iterations = best.iterations};
    summary.residual = step_left(best);
    summary.status = best.converged && noise_settled_ ? Status::kConverged : Status::kNotConverged;
    summary.reason = !best.converged ? "the best start ran out of evaluations"
                     : !noise_settled_
                         ? "the estimated noise does not settle"
                         : fmt::format("smallest sum of squares; {} of {} starts ended there",
                                       best.agreeing, best.starts);
    return summary;
  }

  /// The Gauss–Newton step that is left, in u, which is relative.
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

  /// G(JᵀJ)⁻¹Gᵀ, with J of the residuals and G of the parameters over the free u. Directions of u
  /// that the residuals do not feel make the parameters that change along them unknown: ∞.
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
        if (share > 1e-3) result(i, i) = kInfinity;  // not for 0/0, which is a held parameter
      }
    }
    return result;
  }

  void add_quality(const Minimum& best, ParametricResult& result) const {
    result.chi_squared = best.sum_of_squares;
    result.degrees_of_freedom = static_cast<int>(rows() - best.free().size());
    if (!loss_.known()) result.dissipation_noise = loss_.scale();
    if (secant_.size() > 0 && !secant_.known()) result.secant_noise = secant_.scale();
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < loss_.size(); ++i) {
      if (!(loss_.value(i) > 0.0)) continue;
      const double model = modelled_loss(result.joint, result.linear_damping, i);
      sum += std::pow(model / loss_.value(i) - 1.0, 2);
      count += 1.0;
    }
    result.misfit = count > 0.0 ? std::sqrt(sum / count) : 0.0;
    add_criteria(best, result);
  }

  /// −2 ln of the likelihood of one kind of row, with an unknown scale at its most likely value.
  static double deviance(const Measured& kind, const VectorXd& residual) {
    const auto n = static_cast<double>(kind.size());
    if (n == 0.0) return 0.0;
    double logs = n * std::log(2.0 * std::numbers::pi);
    for (std::size_t i = 0; i < kind.size(); ++i) logs += 2.0 * std::log(kind.sigma(i));
    if (kind.known()) return logs + residual.squaredNorm();
    constexpr double kLeast = 1e-12;  // an exact fit is not infinitely likely
    return logs + n * std::log(std::max(residual.squaredNorm() / n, kLeast)) + n;
  }

  void add_criteria(const Minimum& best, ParametricResult& result) const {
    const VectorXd r = residuals(best.q);
    const double both = deviance(loss_, r.head(static_cast<Index>(loss_.size()))) +
                        deviance(secant_, r.tail(static_cast<Index>(secant_.size())));
    double count = static_cast<double>(result.parameters.size());
    if (result.dissipation_noise) count += 1.0;
    if (result.secant_noise) count += 1.0;
    result.aic = both + 2.0 * count;
    result.bic = both + count * std::log(static_cast<double>(rows()));
  }

  void add_warnings(ParametricResult& result) const {
    for (const FittedParameter& p : result.parameters) {
      if (p.at_bound) {
        result.warnings.push_back(
            {"parameter_at_bound",
             fmt::format("{} = {} is at the end of its range: standard errors of the others hold "
                         "for it fixed there.",
                         p.name, with_unit(p))});
      }
      if (std::isinf(p.standard_error)) {
        result.warnings.push_back(
            {"not_identifiable", fmt::format("the levels do not tell {}; {} is one of many values.",
                                             p.name, with_unit(p))});
      }
    }
    const bool unusable = !levels_.dissipation_std.empty() && !loss_.known();
    if (unusable) {
      result.warnings.push_back(
          {"noise_not_given",
           "dissipation_std is 0 at some level: it was not used, and noise in "
           "proportion to D was estimated from the misfit."});
    }
  }

  /// Of the energies, in the order of their amplitudes.
  void add_misfit_warning(const VectorXd& residual, ParametricResult& result) const {
    constexpr double kRounding = 1e-6;
    constexpr double kTelling = 4.0;  // standard deviations: once in 3e4 fits of the right model
    if (result.misfit < kRounding) return;
    std::vector<std::size_t> order(loss_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [this](std::size_t i) { return levels_.amplitude[i]; });
    std::vector<double> ordered;
    for (const std::size_t i : order) ordered.push_back(residual[static_cast<Index>(i)]);
    const SerialCorrelation serial = serial_correlation(ordered);
    if (serial.deviations < kTelling) return;
    result.warnings.push_back(
        {"systematic_misfit",
         fmt::format("the misfit, {} of D, is not scatter: levels beside each other err "
                     "alike, with a correlation of {:.2f}. The joint is not of this model, which "
                     "the standard errors do not count. Take the free density or another model.",
                     percent_text(result.misfit), serial.correlation)});
  }

  static constexpr double kRankTolerance = 1e-7;  // above the error of the differences

  const Levels& levels_;
  const ParametricOptions& options_;
  std::unique_ptr<ParametricForm> form_;
  Measured loss_;
  Measured secant_;
  ParametricModel model_;
  LeastSquares problem_;
  bool noise_settled_ = true;
};

}  // namespace

std::string_view to_string(ParametricModel model) {
  switch (model) {
    case ParametricModel::kPowerLaw:
      return "power_law";
    case ParametricModel::kUniform:
      return "uniform";
    case ParametricModel::kFourParameter:
      break;
  }
  return "four_parameter";
}

ParametricResult fit_parametric(const Levels& levels, double stiffness, ParametricModel model,
                                const ParametricOptions& options) {
  check_stiffness(stiffness);
  check_levels(levels);
  check_options(options);
  return Fit(levels, stiffness, model, options).run();
}

}  // namespace microslip
