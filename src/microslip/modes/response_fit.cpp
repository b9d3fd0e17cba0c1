// SPDX-License-Identifier: MIT
#include "microslip/modes/response_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/modes/response_basis.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr std::size_t kMostFitted = 100;  // modes; a band with more is to be cut
constexpr int kLongSearch = 200;
constexpr int kShortSearch = 30;  // between two additions
/// Noise explained by a mode, in the mean of its unknowns: more is a mode.
constexpr double kShows = 10.0;
/// Share of the power of all responses at its frequency: a mode with less only corrects the others.
constexpr double kLeastPower = 0.01;
/// Consecutive rejected peaks, after which the rest is noise or misfit.
constexpr std::size_t kMostRefused = 5;
constexpr double kHighestLoss = 0.6;   // η of a mode that a peak determines
constexpr double kLeastMisfit = 1e-3;  // of a response: no noise is taken for less
constexpr double kNothingLeft = 1e-6;  // of the rms: better than any measurement
constexpr double kFrequencySettled = 1e-12;
constexpr double kLossSettled = 1e-8;
constexpr double kFarthestStep = 0.5;  // of ln ω in half-widths, of ln η

/// Responses, and the search for modes in them.
class ResponseSearch {
 public:
  ResponseSearch(std::span<const BandResponse> responses, const ResponseFitOptions& options)
      : responses_(responses), options_(options) {
    set_band();
    for (const BandResponse& response : responses) {
      weights_.push_back(1.0 / std::max(scaled_rms(response), 1e-300));
    }
    make_groups();
  }

  ResponseFit run() {
    const Stopwatch watch;
    if (options_.start.empty()) {
      search();
    } else {
      begin_at_starts();
    }
    (void)settle(kLongSearch);
    weigh_by_rest();
    Summary summary = settle(kLongSearch);
    check_settled();
    std::ranges::sort(poles_, {}, &ResponsePole::log_frequency);
    ResponseFit fit = result();
    fit.summary = std::move(summary);
    fit.summary.wall_seconds = watch.seconds();
    return fit;
  }

 private:
  void set_band() {
    lowest_ = responses_.front().omega.front();
    highest_ = responses_.front().omega.back();
    for (const BandResponse& response : responses_) {
      lowest_ = std::min(lowest_, response.omega.front());
      highest_ = std::max(highest_, response.omega.back());
    }
    middle_ = std::sqrt(lowest_ * highest_);
  }

  [[nodiscard]] double scale(const BandResponse& response) const {
    return std::pow(middle_, -response.derivatives);
  }

  [[nodiscard]] double scaled_rms(const BandResponse& response) const {
    double sum = 0.0;
    for (const Complex& value : response.values) sum += std::norm(value);
    return scale(response) * std::sqrt(sum / static_cast<double>(response.values.size()));
  }

  void make_groups() {
    groups_.clear();
    std::vector<std::size_t> first;
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      const BandResponse& response = responses_[j];
      const auto same = std::ranges::find_if(first, [&](std::size_t i) {
        return responses_[i].derivatives == response.derivatives &&
               responses_[i].omega == response.omega;
      });
      const auto at = static_cast<std::size_t>(same - first.begin());
      if (same == first.end()) {
        first.push_back(j);
        const Eigen::Map<const VectorXd> omega(response.omega.data(),
                                               static_cast<Index>(response.omega.size()));
        groups_.push_back({omega / middle_, response.derivatives, {}, {}});
      }
      groups_[at].members.push_back(j);
    }
    for (ResponseGroup& group : groups_) set_values(group);
  }

  void set_values(ResponseGroup& group) const {
    Eigen::MatrixXcd values(group.x.size(), static_cast<Index>(group.members.size()));
    for (std::size_t m = 0; m < group.members.size(); ++m) {
      const BandResponse& response = responses_[group.members[m]];
      const Eigen::Map<const Eigen::VectorXcd> its(response.values.data(), values.rows());
      values.col(static_cast<Index>(m)) = its * (scale(response) * weights_[group.members[m]]);
    }
    group.values = parts_of_complex(values);
  }

  [[nodiscard]] double cost(std::span<const ResponsePole> poles) const {
    double sum = 0.0;
    for (const ResponseGroup& group : groups_) {
      sum += fit_linearly(group, response_basis(group, poles, options_.law, Numerators::kComplex))
                 .rest.squaredNorm();
    }
    return sum;
  }

  [[nodiscard]] double power() const {
    double sum = 0.0;
    for (const ResponseGroup& group : groups_) sum += group.values.squaredNorm();
    return sum;
  }

  /// JᵀJ and Jᵀe of the unknowns ln ω_r, ln η_r.
  void add_normal_equations(const ResponseGroup& group, MatrixXd& square, VectorXd& slope) const {
    const LinearFit fit =
        fit_linearly(group, response_basis(group, poles_, options_.law, Numerators::kComplex));
    MatrixXd slopes = response_slopes(group, poles_, options_.law);
    const Index modes = static_cast<Index>(poles_.size());
    const MatrixXd numerators = fit.coefficients.topRows(2 * modes);
    const MatrixXd along = slopes.transpose() * fit.rest;  // 4 per mode × members
    slopes -= fit.basis_directions * (fit.basis_directions.transpose() * slopes);
    const MatrixXd products = slopes.transpose() * slopes;
    const MatrixXd common = numerators * numerators.transpose();
    for (Index i = 0; i < 2 * modes; ++i) {
      for (Index a = 0; a < 2; ++a) {
        const Index of_i = 2 * (i / 2) + a;
        slope(i) -= along.row(2 * i + a).dot(numerators.row(of_i));
        for (Index j = 0; j < 2 * modes; ++j) {
          for (Index b = 0; b < 2; ++b) {
            square(i, j) += products(2 * i + a, 2 * j + b) * common(of_i, 2 * (j / 2) + b);
          }
        }
      }
    }
  }

  [[nodiscard]] std::vector<ResponsePole> moved(const VectorXd& step) const {
    std::vector<ResponsePole> poles = poles_;
    for (std::size_t r = 0; r < poles.size(); ++r) {
      const Index at = 2 * static_cast<Index>(r);
      const double farthest = kFarthestStep * std::min(1.0, poles[r].loss() + line_step());
      poles[r].log_frequency += std::clamp(step(at), -farthest, farthest);
      poles[r].log_loss += std::clamp(step(at + 1), -kFarthestStep, kFarthestStep);
    }
    return poles;
  }

  /// Between lines, over the middle of the band.
  [[nodiscard]] double line_step() const {
    const VectorXd& x = groups_.front().x;
    return (x(x.size() - 1) - x(0)) / static_cast<double>(x.size() - 1);
  }

  [[nodiscard]] static double largest(const VectorXd& step, Index offset) {
    double most = 0.0;
    for (Index i = offset; i < step.size(); i += 2) most = std::max(most, std::abs(step(i)));
    return most;
  }

  /// Levenberg–Marquardt from where the poles are.
  Summary settle(int most) {
    Summary summary{.stop = Stop::kLimit, .method = "fit of frequency responses"};
    summary.reason = fmt::format("the limit of {} iterations was reached", most);
    const double all = power();
    double now = cost(poles_);
    double damping = 1e-3;
    const Index unknowns = 2 * static_cast<Index>(poles_.size());
    while (summary.iterations < most) {
      ++summary.iterations;
      MatrixXd square = MatrixXd::Zero(unknowns, unknowns);
      VectorXd slope = VectorXd::Zero(unknowns);
      for (const ResponseGroup& group : groups_) add_normal_equations(group, square, slope);
      const VectorXd diagonal = square.diagonal().cwiseMax(1e-300);
      VectorXd step;
      bool better = false;
      for (; damping < 1e12; damping *= 10.0) {
        MatrixXd damped = square;
        damped.diagonal() += damping * diagonal;
        step = -damped.ldlt().solve(slope);
        std::vector<ResponsePole> next = moved(step);
        const double there = cost(next);
        better = there < now;
        if (!better && !(there <= now * (1.0 + 1e-12))) continue;
        poles_ = std::move(next);
        now = std::min(now, there);
        damping = std::max(damping / 30.0, 1e-15);
        break;
      }
      const bool settled = largest(step, 0) < kFrequencySettled && largest(step, 1) < kLossSettled;
      // Where rounding is all that is left, no step is better.
      const bool exact = now <= 1e-24 * all;
      if (settled || exact || !better) {
        summary.stop = Stop::kConverged;
        summary.reason = exact ? "no residual is left" : "no step is better";
        break;
      }
    }
    summary.residual = std::sqrt(now / all);
    return summary;
  }

  /// Σ|e|² at each line of a group, as measured: there noise is about the same at all of them.
  [[nodiscard]] static VectorXd indicator(const MatrixXd& rest) {
    const Index lines = rest.rows() / 2;
    return rest.topRows(lines).rowwise().squaredNorm() +
           rest.bottomRows(lines).rowwise().squaredNorm();
  }

  /// With the width of the peak at half its height.
  [[nodiscard]] static ResponsePole peak_at(const VectorXd& x, const VectorXd& heights, Index top) {
    Index left = top;
    Index right = top;
    while (left > 0 && heights(left) > 0.5 * heights(top)) --left;
    while (right + 1 < x.size() && heights(right) > 0.5 * heights(top)) ++right;
    const double loss = 0.5 * (x(right) - x(left)) / x(top);
    return {std::log(x(top)), std::log(std::clamp(loss, 1e-6, 0.5 * kHighestLoss))};
  }

  [[nodiscard]] ResponsePole started_at(double x) const {
    const ResponseGroup& group = groups_.front();
    Index nearest = 0;
    (group.x.array() - x).abs().minCoeff(&nearest);
    ResponsePole pole = peak_at(group.x, indicator(group.values), nearest);
    pole.log_frequency = std::log(x);
    return pole;
  }

  [[nodiscard]] bool near_refused(double x, double width) const {
    return std::ranges::any_of(
        refused_, [&](double other) { return std::abs(other - x) < std::max(width, x * 1e-3); });
  }

  /// The highest peak of what is left.
  [[nodiscard]] std::optional<ResponsePole> next_peak() const {
    std::optional<ResponsePole> found;
    double highest = 0.0;
    for (const ResponseGroup& group : groups_) {
      MatrixXd rest = group.values;
      if (!poles_.empty()) {
        rest =
            fit_linearly(group, response_basis(group, poles_, options_.law, Numerators::kComplex))
                .rest;
      }
      const VectorXd heights = indicator(rest);
      for (Index i = 1; i + 1 < heights.size(); ++i) {
        const bool peak = heights(i) >= heights(i - 1) && heights(i) > heights(i + 1);
        if (!peak || heights(i) <= highest) continue;
        if (near_refused(group.x(i), group.x(i + 1) - group.x(i - 1))) continue;
        highest = heights(i);
        found = peak_at(group.x, heights, i);
      }
    }
    return found;
  }

  [[nodiscard]] std::size_t unknowns_of_mode() const { return 2 + 2 * responses_.size(); }

  [[nodiscard]] double freedom() const {
    double values = 0.0;
    for (const ResponseGroup& group : groups_) values += static_cast<double>(group.values.size());
    const std::size_t unknowns = poles_.size() * unknowns_of_mode() + 2 * responses_.size();
    return std::max(1.0, values - static_cast<double>(unknowns));
  }

  [[nodiscard]] bool in_band(const ResponsePole& pole) const {
    const double omega = pole.frequency() * middle_;
    const double width = pole.loss() * omega;
    return omega > lowest_ && omega < highest_ && pole.loss() < kHighestLoss &&
           width < highest_ - lowest_;
  }

  /// N_jr of all responses, weighed, and which share of the power at its frequency a mode has.
  [[nodiscard]] double share_of(std::size_t mode) const {
    double own = 0.0;
    double all = 0.0;
    for (const ResponseGroup& group : groups_) {
      const MatrixXd basis = response_basis(group, poles_, options_.law, Numerators::kComplex);
      const LinearFit fit = fit_linearly(group, basis);
      Index i = 0;
      (group.x.array() - poles_[mode].frequency()).abs().minCoeff(&i);
      const Index at = 2 * static_cast<Index>(mode);
      for (const Index line : {i, i + group.x.size()}) {
        own += (basis.row(line).segment(at, 2) * fit.coefficients.middleRows(at, 2)).squaredNorm();
        all += group.values.row(line).squaredNorm();
      }
    }
    return own / all;
  }

  /// Re N of the drive point for each pole, weighed.
  [[nodiscard]] VectorXd drive_residues() const {
    for (const ResponseGroup& group : groups_) {
      const auto member = std::ranges::find(group.members, options_.drive);
      if (member == group.members.end()) continue;
      const MatrixXd basis = response_basis(group, poles_, options_.law, Numerators::kReal);
      const Index modes = static_cast<Index>(poles_.size());
      return fit_linearly(group, basis)
          .coefficients.col(member - group.members.begin())
          .head(modes);
    }
    return VectorXd::Zero(static_cast<Index>(poles_.size()));
  }

  /// Whether the mode that was added last is one; `before` is the cost without it.
  [[nodiscard]] bool shows(double before) {
    if (!std::ranges::all_of(poles_, [&](const ResponsePole& pole) { return in_band(pole); }))
      return false;
    const double now = cost(poles_);
    const double explained = (before - now) / static_cast<double>(unknowns_of_mode());
    if (!(explained > kShows * now / freedom())) return false;
    if (share_of(poles_.size() - 1) < kLeastPower) return false;
    const VectorXd residues = drive_residues();
    // Of either sign: the caller reports a negative one.
    if (residues(0) * residues(residues.size() - 1) > 0.0) return true;
    undriven_.push_back(poles_.back().frequency() * middle_);
    return false;
  }

  void begin_at_starts() {
    for (const double omega : options_.start) {
      if (!(omega > lowest_ && omega < highest_)) {
        throw InputError(
            "start_frequency_Hz", omega / kTurn,
            fmt::format("must be within the band of the responses, {:.6g} to {:.6g} Hz",
                        lowest_ / kTurn, highest_ / kTurn));
      }
      poles_.push_back(started_at(omega / middle_));
    }
  }

  void check_settled() const {
    for (const ResponsePole& pole : poles_) {
      if (in_band(pole)) continue;
      throw InputError("a mode of the frequency responses",
                       fmt::format("{:.6g} Hz with a loss factor of {:.3g}",
                                   pole.frequency() * middle_ / kTurn, pole.loss()),
                       fmt::format("must be between {:.6g} and {:.6g} Hz, and narrower",
                                   lowest_ / kTurn, highest_ / kTurn),
                       "There is no peak at its start. Give other start_frequency_Hz, fewer "
                       "modes, or another band_Hz.");
    }
  }

  void search() {
    const double all = power();
    const std::size_t wanted = options_.count.value_or(kMostFitted);
    while (poles_.size() < wanted && refused_.size() < kMostRefused) {
      const std::optional<ResponsePole> peak = next_peak();
      if (!peak) break;
      const std::vector<ResponsePole> before = poles_;
      const double cost_before = poles_.empty() ? all : cost(poles_);
      if (std::sqrt(cost_before / all) < kNothingLeft) break;
      poles_.push_back(*peak);
      (void)settle(kShortSearch);
      const bool taken = options_.count ? in_band(poles_.back()) : shows(cost_before);
      if (taken) {
        refused_.clear();
        continue;
      }
      refused_.push_back(peak->frequency());
      poles_ = before;
    }
    check_found(wanted);
  }

  void check_found(std::size_t wanted) const {
    if (poles_.empty()) {
      throw InputError("modes in the frequency responses", "none",
                       "must show as peaks between the ends of the band",
                       "Give another band_Hz, or start_frequency_Hz.");
    }
    if (!options_.count || poles_.size() == wanted) return;
    throw InputError("modes in the frequency responses", static_cast<double>(poles_.size()),
                     fmt::format("must be {}, as count requests", wanted),
                     "Give fewer, or start_frequency_Hz.");
  }

  /// Each response by what is left of it: the weights of greatest likelihood.
  void weigh_by_rest() {
    for (const ResponseGroup& group : groups_) {
      const MatrixXd rest =
          fit_linearly(group, response_basis(group, poles_, options_.law, Numerators::kComplex))
              .rest;
      for (std::size_t m = 0; m < group.members.size(); ++m) {
        const auto column = static_cast<Index>(m);
        const double misfit = rest.col(column).norm() / group.values.col(column).norm();
        weights_[group.members[m]] /= std::max(misfit, kLeastMisfit);
      }
    }
    make_groups();
  }

  /// N of a + b iω/ω_r at the pole, or of a + ib.
  [[nodiscard]] Complex numerator_of(const ResponsePole& pole, double a, double b) const {
    if (options_.law == DampingLaw::kHysteretic) return {a, b};
    const double ratio = 0.5 * pole.loss();
    return a + b * Complex(-ratio, std::sqrt(std::max(0.0, 1.0 - ratio * ratio)));
  }

  /// Covariance of the unknowns ln ω_r, ln η_r, by what is left.
  [[nodiscard]] MatrixXd pole_covariance() const {
    const Index unknowns = 2 * static_cast<Index>(poles_.size());
    MatrixXd square = MatrixXd::Zero(unknowns, unknowns);
    VectorXd slope = VectorXd::Zero(unknowns);
    for (const ResponseGroup& group : groups_) add_normal_equations(group, square, slope);
    const MatrixXd inverse = square.ldlt().solve(MatrixXd::Identity(unknowns, unknowns));
    return inverse * (cost(poles_) / freedom());
  }

  [[nodiscard]] ResponseFit result() const {
    const auto count = static_cast<Index>(responses_.size());
    const Index modes = static_cast<Index>(poles_.size());
    ResponseFit fit;
    fit.residues.resize(count, modes);
    fit.errors.resize(count, modes);
    fit.numerators.resize(count, modes);
    fit.upper.resize(count);
    fit.misfits.resize(responses_.size());
    fit.undriven = undriven_;
    for (const ResponsePole& pole : poles_) {
      fit.modes.push_back(
          {.angular_frequency = pole.frequency() * middle_, .loss_factor = pole.loss()});
    }
    const MatrixXd covariance = pole_covariance();
    for (const ResponseGroup& group : groups_) set_residues(group, covariance, fit);
    return fit;
  }

  /// Derivatives of the real coefficients of one response by ln ω_r, ln η_r.
  [[nodiscard]] MatrixXd coefficient_slopes(const MatrixXd& slopes, const LinearFit& real,
                                            const MatrixXd& basis, Index member) const {
    const Index modes = static_cast<Index>(poles_.size());
    MatrixXd by_pole(basis.rows(), 2 * modes);
    for (Index k = 0; k < 2 * modes; ++k) {
      by_pole.col(k) = slopes.col(2 * k) * real.coefficients(k / 2, member);
    }
    return -real.inverse * (basis.transpose() * by_pole);
  }

  void set_residues(const ResponseGroup& group, const MatrixXd& covariance,
                    ResponseFit& fit) const {
    const MatrixXd basis = response_basis(group, poles_, options_.law, Numerators::kReal);
    const MatrixXd slopes = response_slopes(group, poles_, options_.law);
    const LinearFit real = fit_linearly(group, basis);
    const LinearFit complex =
        fit_linearly(group, response_basis(group, poles_, options_.law, Numerators::kComplex));
    const Index modes = static_cast<Index>(poles_.size());
    for (std::size_t m = 0; m < group.members.size(); ++m) {
      const auto member = static_cast<Index>(m);
      const std::size_t response = group.members[m];
      const auto j = static_cast<Index>(response);
      const double unweighed = 1.0 / weights_[response];
      const double freedom =
          std::max<double>(1.0, static_cast<double>(2 * group.x.size() - modes - 2));
      const double scatter = real.rest.col(member).norm() / std::sqrt(freedom);
      fit.misfits[response] = real.rest.col(member).norm() / group.values.col(member).norm();
      const MatrixXd by_poles = coefficient_slopes(slopes, real, basis, member);
      fit.upper(j) = real.coefficients(modes + 1, member) * unweighed;
      for (Index r = 0; r < modes; ++r) {
        const double to_si = unweighed * middle_ * middle_;
        const ResponsePole& pole = poles_[static_cast<std::size_t>(r)];
        fit.residues(j, r) = real.coefficients(r, member) * to_si;
        const double of_poles = by_poles.row(r) * covariance * by_poles.row(r).transpose();
        fit.errors(j, r) =
            to_si * std::sqrt(scatter * scatter * real.inverse(r, r) + std::max(0.0, of_poles));
        fit.numerators(j, r) = to_si * numerator_of(pole, complex.coefficients(2 * r, member),
                                                    complex.coefficients(2 * r + 1, member));
      }
    }
  }

  std::span<const BandResponse> responses_;
  const ResponseFitOptions& options_;
  double lowest_ = 0.0;   // rad/s
  double highest_ = 0.0;  // rad/s
  double middle_ = 1.0;   // rad/s
  std::vector<double> weights_;
  std::vector<ResponseGroup> groups_;
  std::vector<ResponsePole> poles_;
  std::vector<double> refused_;
  std::vector<double> undriven_;
};

}  // namespace

ResponseFit fit_responses(std::span<const BandResponse> responses,
                          const ResponseFitOptions& options) {
  return ResponseSearch(responses, options).run();
}

}  // namespace microslip
