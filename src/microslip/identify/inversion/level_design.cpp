// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/level_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/identify/posterior/plain_matrix_view.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"

namespace microslip {
namespace {

/// An exchange counts where it lowers S by this share: rounding is far below.
constexpr double kExchangeGain = 1e-7;
constexpr int kMostSweeps = 20;

void check_number(std::string_view what, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  throw InputError(fmt::format("number of {}", what), static_cast<double>(found),
                   fmt::format("must be {}", expected));
}

void check_deviations(std::string_view what, const std::vector<double>& values,
                      std::size_t expected) {
  check_number(what, values.size(), expected);
  for (const double value : values) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw InputError(what, value, "must be above 0 and finite");
  }
}

void check_finite(std::string_view what, const PlainMatrix& draws) {
  for (const double value : draws.values) {
    if (!std::isfinite(value)) throw InputError(what, value, "must be finite");
  }
}

void check_design(const FurtherLevels& further, const DesignTarget& target, std::size_t count) {
  const std::size_t m = further.amplitude.size();
  const std::size_t draws = further.dissipation.rows();
  if (m == 0) throw InputError("amplitudes to choose from", "none", "must be one or more");
  if (draws < 2) {
    throw InputError("number of draws", static_cast<double>(draws), "must be 2 or more");
  }
  if (count < 1 || count > kMostDesigned) {
    throw InputError("number of further levels", static_cast<double>(count),
                     fmt::format("must be 1 to {}", kMostDesigned));
  }
  check_number("dissipations of a draw", further.dissipation.columns, m);
  check_finite("dissipation of a draw", further.dissipation);
  check_deviations("standard deviation of a further dissipation", further.dissipation_std, m);
  check_number("draws of the target", target.draws.rows(), draws);
  check_number("weights of the target", target.weight.size(), target.draws.columns);
  check_finite("target of a draw", target.draws);
  if (further.secant_stiffness.values.empty()) return;
  check_number("secant stiffnesses of a draw", further.secant_stiffness.columns, m);
  check_number("draws of the secant stiffness", further.secant_stiffness.rows(), draws);
  check_finite("secant stiffness of a draw", further.secant_stiffness);
  check_deviations("standard deviation of a further secant stiffness", further.secant_stiffness_std,
                   m);
}

/// The remaining covariance of the measurements of the candidates and of the target.
class Knowledge {
 public:
  Knowledge(const FurtherLevels& further, const DesignTarget& target)
      : candidates_(static_cast<Eigen::Index>(further.amplitude.size())),
        kinds_(further.secant_stiffness.values.empty() ? 1 : 2),
        weight_(view_of(target.weight)),
        variance_(kinds_ * candidates_) {
    const Eigen::Index draws = static_cast<Eigen::Index>(further.dissipation.rows());
    Eigen::MatrixXd all(draws, target_begin() + weight_.size());
    all.leftCols(candidates_) = matrix_of(further.dissipation);
    variance_.head(candidates_) = view_of(further.dissipation_std).cwiseAbs2();
    if (kinds_ == 2) {
      all.middleCols(candidates_, candidates_) = matrix_of(further.secant_stiffness);
      variance_.tail(candidates_) = view_of(further.secant_stiffness_std).cwiseAbs2();
    }
    all.rightCols(weight_.size()) = matrix_of(target.draws);
    all.rowwise() -= all.colwise().mean().eval();
    covariance_ = all.transpose() * all / static_cast<double>(draws - 1);
    if (kinds_ == 2) {
      covariance_.block(candidates_, candidates_, candidates_, candidates_).array() +=
          further.secant_offset_std * further.secant_offset_std;
    }
  }

  [[nodiscard]] Eigen::Index candidates() const { return candidates_; }

  /// S.
  [[nodiscard]] double deviation() const { return deviation_of(variances()); }

  /// S with one more level.
  /// @param noise  over its variance: 1; 0 for endless repeats.
  [[nodiscard]] double deviation_with(Eigen::Index candidate, double noise = 1.0) const {
    if (kinds_ == 1) {
      return deviation_of(variances() - gain(candidate, noise) * of_target(candidate).cwiseAbs2());
    }
    const Eigen::Index d = candidate;
    const Eigen::Index k = candidates_ + candidate;
    const double to_d = gain(d, noise);
    const Eigen::VectorXd left_k = of_target(k) - to_d * covariance_(d, k) * of_target(d);
    const double left_variance =
        covariance_(k, k) - to_d * covariance_(d, k) * covariance_(d, k) + noise * variance_(k);
    const double to_k = share(left_variance, covariance_(k, k));
    return deviation_of(variances() - to_d * of_target(d).cwiseAbs2() - to_k * left_k.cwiseAbs2());
  }

  /// The candidate after which S is least.
  [[nodiscard]] Eigen::Index best() const {
    Eigen::Index best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index c = 0; c < candidates_; ++c) {
      const double here = deviation_with(c);
      if (here < least) {
        least = here;
        best = c;
      }
    }
    return best;
  }

  void add(Eigen::Index candidate) {
    for (Eigen::Index kind = 0; kind < kinds_; ++kind) change(kind * candidates_ + candidate, 1.0);
  }

  /// Takes back a level that was added.
  void remove(Eigen::Index candidate) {
    for (Eigen::Index kind = kinds_ - 1; kind >= 0; --kind) {
      change(kind * candidates_ + candidate, -1.0);
    }
  }

 private:
  [[nodiscard]] Eigen::Index target_begin() const { return kinds_ * candidates_; }
  [[nodiscard]] Eigen::VectorXd of_target(Eigen::Index row) const {
    return covariance_.col(row).tail(weight_.size());
  }
  [[nodiscard]] Eigen::VectorXd variances() const {
    return covariance_.diagonal().tail(weight_.size());
  }
  [[nodiscard]] double deviation_of(const Eigen::VectorXd& variances) const {
    return weight_.dot(variances.cwiseMax(0.0).cwiseSqrt());
  }
  /// 1 over a remaining variance, 0 where that is rounding of the original one.
  [[nodiscard]] static double share(double variance, double of) {
    return variance > 1e-12 * of ? 1.0 / variance : 0.0;
  }
  [[nodiscard]] double gain(Eigen::Index row, double noise) const {
    return share(covariance_(row, row) + noise * variance_(row), covariance_(row, row));
  }
  /// Adds a measurement of a row, or with a sign of −1 removes it.
  void change(Eigen::Index row, double sign) {
    const Eigen::VectorXd column = covariance_.col(row);
    covariance_.noalias() -=
        sign / (variance_(row) + sign * column(row)) * column * column.transpose();
  }

  Eigen::Index candidates_;
  Eigen::Index kinds_;
  Eigen::VectorXd weight_;
  Eigen::VectorXd variance_;    // of the noise of each row
  Eigen::MatrixXd covariance_;  // candidates' D, their k_eq, target
};

/// Chooses the levels one by one, then exchanges them; returns the number exchanged.
std::size_t choose_levels(const Knowledge& start, std::size_t count,
                          std::vector<Eigen::Index>& chosen) {
  Knowledge left = start;
  for (std::size_t i = 0; i < count; ++i) {
    chosen.push_back(left.best());
    left.add(chosen.back());
  }
  std::size_t exchanges = 0;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool better = false;
    for (Eigen::Index& level : chosen) {
      const double with = left.deviation();
      left.remove(level);
      const Eigen::Index best = left.best();
      if (left.deviation_with(best) < (1.0 - kExchangeGain) * with) {
        level = best;
        better = true;
        ++exchanges;
      }
      left.add(level);
    }
    if (!better) break;
  }
  return exchanges;
}

/// By rank: next come all levels at the amplitude at which they lower S most.
std::vector<DesignedLevel> ranked_levels(Knowledge left, const std::vector<Eigen::Index>& chosen,
                                         LevelDesign& design) {
  std::vector<std::size_t> repeats(static_cast<std::size_t>(left.candidates()));
  for (const Eigen::Index c : chosen) ++repeats[static_cast<std::size_t>(c)];
  std::vector<DesignedLevel> levels;
  for (;;) {
    DesignedLevel next;
    next.after = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < repeats.size(); ++c) {
      if (repeats[c] == 0) continue;
      const double after =
          left.deviation_with(static_cast<Eigen::Index>(c), 1.0 / static_cast<double>(repeats[c]));
      if (after < next.after) next = {c, repeats[c], left.deviation(), after, 0.0};
    }
    if (next.repeats == 0) break;
    const auto row = static_cast<Eigen::Index>(next.candidate);
    next.endless = left.deviation_with(row, 0.0);
    for (std::size_t i = 0; i < next.repeats; ++i) left.add(row);
    repeats[next.candidate] = 0;
    levels.push_back(next);
  }
  design.after = left.deviation();
  design.one_more = left.deviation_with(left.best());
  return levels;
}

}  // namespace

LevelDesign design_levels(const FurtherLevels& further, const DesignTarget& target,
                          std::size_t count) {
  check_design(further, target, count);
  const Knowledge start(further, target);
  LevelDesign design;
  design.now = start.deviation();
  std::vector<Eigen::Index> chosen;
  design.exchanges = choose_levels(start, count, chosen);
  design.levels = ranked_levels(start, chosen, design);
  return design;
}

}  // namespace microslip
