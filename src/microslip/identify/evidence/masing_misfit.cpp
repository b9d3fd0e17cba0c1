// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/masing_misfit.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/observe/neighbour_scatter.hpp"

namespace microslip {
namespace {

constexpr std::size_t kFewestLevels = 4;
/// F of a cause, of one joint for D and another for k_eq, and of each further slider of these. None
/// of 1700 tables of exact joints came near; chosen in view of half of them.
constexpr double kCauseLimit = 10.0;
/// The same of frequencies: the share of the joint in the mode may change with k_eq.
constexpr double kFrequencyLimit = 30.0;
constexpr double kApartLimit = 15.0;
constexpr double kApartOfEach = 3.0;
constexpr double kApartLimitOfScatter = 30.0;
constexpr double kApartOfEachOfScatter = 8.0;
/// Deviations of χ² by which a misfit of any kind exceeds its mean.
constexpr double kAloneDeviations = 8.0;
/// Scatter counts so many times that about a smooth curve at most, of so many rows or more: that is
/// of cubics through two neighbours on either side then, of lines through one of fewer.
constexpr double kMostOverCurve = 2.0;
constexpr Eigen::Index kFewestForCurve = 9;
constexpr double kReachOfCubics = 2.0;
constexpr double kReachOfLines = 1.0;
/// Of the misfit, the least that a cause explains where it is named.
constexpr double kMostOfMisfit = 0.6;
/// The least noise, over k and over f: models of both are no better.
constexpr double kLeastSecantNoise = 1e-3;
constexpr double kLeastFrequencyNoise = 1e-4;
/// σ of D and of f that count where none are given, and the least of f.
constexpr double kUsualDissipationStd = 0.01;
constexpr double kLeastDissipationStd = 0.003;
constexpr double kLeastFrequencyStd = 2e-5;
/// Scatter of k_eq, over k: limits where it is not given.
constexpr double kLeastSecantStd = 5e-4;
/// Degrees of freedom that the usual scatter counts where 12 levels or fewer show theirs; none of
/// 20 or more.
constexpr double kFreedomOfStd = 10.0;
constexpr double kFreedomOfScatter = 4.0;
constexpr double kFewLevels = 12.0;
constexpr double kManyLevels = 20.0;
/// Rows of each kind: of more levels neighbours are added.
constexpr Eigen::Index kMostRows = 60;
/// Sliders: ratio of neighbours between levels, most of them between two, and below all.
constexpr double kSliderRatio = 0.07;
constexpr int kMostBetween = 6;
constexpr int kSlidersBelow = 27;
constexpr double kLowestSlider = 1.0 / 40.0;
constexpr double kSliderRidge = 1e-12;
constexpr int kMostSteps = 11;
constexpr int kScatterPasses = 3;
/// Departures that are fitted again with another scatter.
constexpr std::size_t kKept = 12;

/// A change of the model: amplitudes over the relative load, and further columns.
struct Departure {
  LevelCause cause = LevelCause::kUnknown;
  double size = 0.0;
  double at = 0.0;         // scaled amplitude of a step
  Eigen::VectorXd load{};  // of each level; empty for 1
  double loss = 1.0;       // D over that of the joint
  bool damping = false;
};

/// The best joint for rows that are weighted.
struct BestFit {
  double square = std::numeric_limits<double>::infinity();
  double sliders = 0.0;         // number of coefficients above 0
  Eigen::VectorXd left_of_d{};  // weighted
  Eigen::VectorXd left_of_k{};
  Eigen::VectorXd x{};   // coefficients
  double damping = 0.0;  // βa²
  double slope = 1.0;    // of frequencies: k_eq over f², scaled
};

/// Sums of so many neighbouring rows, over the root of their number: noise keeps its size.
template <typename Matrix>
Matrix added(const Matrix& rows, Eigen::Index each) {
  if (each == 1) return rows;
  const Eigen::Index count = (rows.rows() + each - 1) / each;
  Matrix sums = Matrix::Zero(count, rows.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index number = std::min(each, rows.rows() - i * each);
    sums.row(i) =
        rows.middleRows(i * each, number).colwise().sum() / std::sqrt(static_cast<double>(number));
  }
  return sums;
}

/// Levels, scaled by k and the largest amplitude, against any joint.
class AnyJoint {
 public:
  AnyJoint(const LevelEvidence& levels, double stiffness, bool damping, bool frequencies);

  [[nodiscard]] MasingMisfit misfit();

 private:
  /// The best joint alone, and with the departure that helps it most.
  struct Fits {
    BestFit none;
    BestFit cause;
    Departure named;
  };
  /// By how many times χ² of the best joint exceeds what noise gives at most.
  struct Excess {
    double over;
    double limit;
  };
  [[nodiscard]] Fits fits();
  [[nodiscard]] Excess excess_of(const Fits& fits, double rows) const;
  void name_cause(const Fits& fits, double rows, MasingMisfit& misfit) const;
  /// s² of what is left.
  [[nodiscard]] double variance(double square, double parameters, double rows) const;
  [[nodiscard]] double most_variance() const;
  /// σ of all levels together, as a share of k_eq or f.
  [[nodiscard]] double relative_deviation() const;
  [[nodiscard]] bool given() const { return d_given_ && k_given_; }
  /// Parameters beside the sliders.
  [[nodiscard]] double offset() const { return frequencies_ ? 2.0 : 1.0; }
  [[nodiscard]] BestFit fitted(const Departure& departure, bool with_d, bool with_k,
                               double slope) const;
  [[nodiscard]] BestFit best(const Departure& departure, double range) const;
  [[nodiscard]] BestFit good(const Departure& departure) const;
  [[nodiscard]] std::vector<Departure> departures() const;
  void correct_common_errors();
  void read_scatter(const BestFit& fit);
  /// Of both kinds of rows, over σ.
  struct Scatter {
    double d = std::numeric_limits<double>::infinity();
    double k = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] Scatter scatter_about_curves() const;
  [[nodiscard]] Scatter most_scatter() const;
  [[nodiscard]] double least_of_curve() const;
  [[nodiscard]] double start_slope() const;

  const LevelEvidence& evidence_;
  bool damping_;
  bool frequencies_;
  bool d_given_;
  bool k_given_;
  Eigen::VectorXd a_;
  Eigen::VectorXd d_;
  Eigen::VectorXd k_;        // k_eq/k, or f² over that of the first level
  Eigen::VectorXd sigma_d_;  // scaled
  Eigen::VectorXd least_d_;  // of σ where it is not given: sliders enough interpolate any D, and
                             // sums of rows are no better than the sliders
  Eigen::VectorXd sigma_k_;
  Eigen::VectorXd sliders_;
  Eigen::Index each_;
  double known_d_;  // degrees of freedom
  double known_k_;
  double slope_ = 1.0;
};

AnyJoint::AnyJoint(const LevelEvidence& levels, double stiffness, bool damping, bool frequencies)
    : evidence_(levels),
      damping_(damping),
      frequencies_(frequencies),
      d_given_(levels.dissipation_std_given()),
      k_given_(frequencies ? !levels.levels().frequency_std.empty() : levels.secant_std_given()) {
  const Levels& all = levels.levels();
  const auto n = static_cast<Eigen::Index>(all.size());
  const double top = all.amplitude.back();
  const double energy = stiffness * top * top;
  a_ = view_of(all.amplitude) / top;
  d_ = view_of(all.dissipation) / energy;
  const LevelScatter scatter = levels.expected_scatter(stiffness);
  const LevelRows sigma =
      levels.deviations(levels.typical(), {.dissipation = d_given_ ? 1.0 : kUsualDissipationStd,
                                           .secant_stiffness = scatter.secant_stiffness});
  sigma_d_ = view_of(sigma.dissipation) / energy;
  least_d_ = kLeastDissipationStd / kUsualDissipationStd * sigma_d_;
  if (frequencies) {
    k_ = (view_of(all.frequency) / all.frequency.front()).cwiseAbs2();
    sigma_k_ = Eigen::VectorXd::Constant(n, kLeastFrequencyStd);
    if (k_given_) {
      sigma_k_ =
          sigma_k_.cwiseMax(view_of(all.frequency_std).cwiseQuotient(view_of(all.frequency)));
    }
    sigma_k_ = 2.0 * sigma_k_.cwiseProduct(k_);
  } else {
    k_ = view_of(all.secant_stiffness) / stiffness;
    sigma_k_ = view_of(sigma.secant_stiffness) / stiffness;
  }
  each_ = 1 + (n - 1) / kMostRows;
  least_d_ *= std::sqrt(static_cast<double>(each_));
  const double few =
      std::clamp((kManyLevels - static_cast<double>(n)) / (kManyLevels - kFewLevels), 0.0, 1.0);
  known_d_ = few * (d_given_ ? kFreedomOfStd : kFreedomOfScatter);
  known_k_ = few * (k_given_ ? kFreedomOfStd : kFreedomOfScatter);

  std::vector<double> at;
  for (int i = 0; i < kSlidersBelow; ++i) {
    at.push_back(a_(0) * std::pow(kLowestSlider, 1.0 - static_cast<double>(i) / kSlidersBelow));
  }
  for (Eigen::Index i = 0; i + 1 < n; i += each_) {
    const double from = a_(i);
    const double ratio = std::log(a_(std::min(i + each_, n - 1)) / from);
    const int parts =
        std::clamp(static_cast<int>(std::ceil(ratio / kSliderRatio)), 1, kMostBetween);
    for (int j = 0; j < parts; ++j) at.push_back(from * std::exp(ratio * j / parts));
  }
  for (const double above : {1.0, 1.15, 1.35}) at.push_back(above);
  sliders_ = view_of(at);
}

// Columns: the sliders, K_e, b of frequencies where it is found, βa².
BestFit AnyJoint::fitted(const Departure& departure, bool with_d, bool with_k, double slope) const {
  const Eigen::Index n = a_.size();
  const Eigen::Index count = sliders_.size();
  const bool damping = damping_ || departure.damping;
  const Eigen::Index columns = count + 1 + (damping ? 1 : 0);
  const auto load = [&](Eigen::Index i) {
    return departure.load.size() > 0 ? departure.load(i) : 1.0;
  };
  Eigen::MatrixXd rows_d = Eigen::MatrixXd::Zero(with_d ? n : 0, columns);
  Eigen::MatrixXd rows_k = Eigen::MatrixXd::Zero(with_k ? n : 0, columns);
  Eigen::VectorXd of_d(rows_d.rows());
  Eigen::VectorXd of_k(rows_k.rows());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double q = load(i);
    const double a = a_(i) / q;
    if (with_d) {
      const double weight = departure.loss * q * q / sigma_d_(i);
      rows_d.row(i).head(count) =
          (4.0 * weight * sliders_.array() * (a - sliders_.array()).max(0.0)).matrix().transpose();
      if (damping) rows_d(i, count + 1) = a_(i) * a_(i) / sigma_d_(i);
      of_d(i) = d_(i) / sigma_d_(i);
    }
    if (!with_k) continue;
    const double weight = 1.0 / (slope * sigma_k_(i));
    for (Eigen::Index j = 0; j < count; ++j) {
      rows_k(i, j) = weight * jenkins_secant(sliders_(j) / a);
    }
    rows_k(i, count) = weight;
    of_k(i) = weight * slope * k_(i);
  }
  const Eigen::MatrixXd short_d = added(rows_d, each_);
  const Eigen::MatrixXd short_k = added(rows_k, each_);
  Eigen::MatrixXd design(short_d.rows() + short_k.rows(), columns);
  design << short_d, short_k;
  Eigen::VectorXd data(design.rows());
  data << added(of_d, each_), added(of_k, each_);

  const Eigen::VectorXd size = design.colwise().norm().transpose().cwiseMax(1e-300);
  design = design * size.cwiseInverse().asDiagonal();
  Eigen::MatrixXd hessian = design.transpose() * design;
  hessian.diagonal().array() += kSliderRidge;
  const QuadraticProgram::Solution solution =
      QuadraticProgram(Eigen::VectorXd::Zero(columns), 1.0)
          .solve(hessian, design.transpose() * data,
                 std::vector<bool>(static_cast<std::size_t>(columns), false));
  const Eigen::VectorXd left = data - design * solution.x;
  BestFit fit;
  fit.square = left.squaredNorm();
  fit.sliders = static_cast<double>((solution.x.array() > 0.0).count());
  fit.left_of_d = left.head(short_d.rows());
  fit.left_of_k = left.tail(short_k.rows());
  fit.x = solution.x.cwiseQuotient(size);
  if (damping) fit.damping = fit.x(columns - 1);
  fit.slope = slope;
  return fit;
}

// k_eq over f²: as D alone requires it between the first and the last level.
double AnyJoint::start_slope() const {
  const Eigen::VectorXd x = fitted({}, true, false, 1.0).x;
  const Eigen::Index last = a_.size() - 1;
  double softened = 0.0;
  for (Eigen::Index j = 0; j < sliders_.size(); ++j) {
    softened +=
        x(j) * (jenkins_secant(sliders_(j) / a_(0)) - jenkins_secant(sliders_(j) / a_(last)));
  }
  return std::max(1e-6, softened) / std::max(1e-6, k_(0) - k_(last));
}

/// The fit with the best b of frequencies, within a factor of the last one.
BestFit AnyJoint::best(const Departure& departure, double range) const {
  if (!frequencies_) return fitted(departure, true, true, 1.0);
  constexpr int kBits = 10;
  std::uintmax_t iterations = 12;
  const double middle = std::log(slope_);
  const auto square = [&](double log_slope) {
    return fitted(departure, true, true, std::exp(log_slope)).square;
  };
  const double found =
      boost::math::tools::brent_find_minima(square, middle - std::log(range),
                                            middle + std::log(range), kBits, iterations)
          .first;
  return fitted(departure, true, true, std::exp(found));
}

/// The same, roughly: of some values of b.
BestFit AnyJoint::good(const Departure& departure) const {
  BestFit found;
  for (const double times : {0.7, 1.0, 1.4}) {
    if (!frequencies_ && times != 1.0) continue;
    BestFit fit = fitted(departure, true, true, frequencies_ ? times * slope_ : 1.0);
    if (fit.square < found.square) found = std::move(fit);
  }
  return found;
}

std::vector<Departure> AnyJoint::departures() const {
  const Eigen::Index n = a_.size();
  std::vector<Departure> all;
  if (!frequencies_ && !damping_) {
    all.push_back({.cause = LevelCause::kLinearDamping, .damping = true});
  }
  if (!frequencies_) {
    for (const double loss : {0.3, 0.5, 0.7, 0.85, 1.18, 1.4, 2.0, 3.0}) {
      all.push_back({.cause = LevelCause::kLossFactor, .size = loss, .loss = loss});
    }
  }
  const std::vector<double> changes = {-0.35, -0.25, -0.15, -0.07, 0.07, 0.15, 0.25, 0.35};
  const auto add_trend = [&](LevelCause cause, const Eigen::VectorXd& place) {
    for (const double change : changes) {
      all.push_back({.cause = cause, .size = change, .load = (1.0 + change * place.array())});
    }
  };
  // The share of a joint in a mode may change with its stiffness: a trend may be that.
  if (!frequencies_) add_trend(LevelCause::kTrend, Eigen::VectorXd::LinSpaced(n, 0.0, 1.0));
  const std::vector<double>& order = evidence_.measured().amplitude;
  if (order.size() == evidence_.size() && !std::ranges::is_sorted(order) &&
      !std::ranges::is_sorted(order, std::ranges::greater())) {
    std::vector<std::size_t> by_amplitude(order.size());
    std::iota(by_amplitude.begin(), by_amplitude.end(), std::size_t{0});
    std::ranges::sort(by_amplitude, {}, [&](std::size_t i) { return order[i]; });
    Eigen::VectorXd place(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      place(i) = static_cast<double>(by_amplitude[static_cast<std::size_t>(i)]) /
                 static_cast<double>(n - 1);
    }
    add_trend(LevelCause::kOrder, place);
  }
  // As many levels on either side as show their own load.
  const Eigen::Index side = std::max<Eigen::Index>(2, n / 12);
  const Eigen::Index steps = std::min<Eigen::Index>(kMostSteps, n - 2 * side + 1);
  for (Eigen::Index s = 0; s < steps; ++s) {
    const Eigen::Index from = steps == 1 ? side : side + s * (n - 2 * side) / (steps - 1);
    for (const double change : changes) {
      Departure step{.cause = LevelCause::kStep, .size = change, .at = a_(from)};
      step.load = Eigen::VectorXd::Ones(n);
      step.load.tail(n - from).setConstant(1.0 + change);
      all.push_back(std::move(step));
    }
  }
  return all;
}

// Errors of D and A act as one of D: with A → cA the density is another, and D is c² times as
// large.
void AnyJoint::correct_common_errors() {
  const CommonErrors& errors = evidence_.common_errors();
  const Eigen::VectorXd measured = d_;
  const auto choose = [&](double deviation, const auto& d_with) {
    if (!(deviation > 0.0)) return;
    const Eigen::VectorXd start = d_;
    double least = std::numeric_limits<double>::infinity();
    Eigen::VectorXd chosen = d_;
    for (const double times : {-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
      d_ = d_with(start, times * deviation).cwiseMax(0.0);
      const double square = best({}, 2.0).square + times * times;
      if (square >= least) continue;
      least = square;
      chosen = d_;
    }
    d_ = chosen;
  };
  if (!frequencies_) {
    choose(std::hypot(errors.dissipation_gain_std, 2.0 * errors.amplitude_gain_std),
           [](const Eigen::VectorXd& d, double error) -> Eigen::VectorXd {
             return d * std::exp(error);
           });
  }
  if (errors.loss_factor_std > 0.0) {
    const Eigen::VectorXd linear =
        view_of(evidence_.levels().linear_dissipation) *
        (measured(measured.size() - 1) / evidence_.levels().dissipation.back());
    choose(errors.loss_factor_std, [&](const Eigen::VectorXd& d, double error) -> Eigen::VectorXd {
      return d + error * linear;
    });
  }
}

/// Scatter of ln D and k_eq about smooth curves, which need no joint.
AnyJoint::Scatter AnyJoint::scatter_about_curves() const {
  std::vector<double> x;
  std::vector<double> log_d;
  for (Eigen::Index i = 0; i < a_.size(); ++i) {
    x.push_back(std::log(a_(i)));
    log_d.push_back(std::log(std::max(d_(i), sigma_d_(i))));
  }
  const std::vector<double> k(k_.begin(), k_.end());
  const Eigen::VectorXd share = sigma_d_.cwiseQuotient(d_.cwiseMax(sigma_d_));
  const std::vector<double> relative(share.begin(), share.end());
  const std::vector<double> sigma(sigma_k_.begin(), sigma_k_.end());
  return {scatter_about_curve(x, log_d, relative), scatter_about_curve(x, k, sigma)};
}

/// The most that D and k_eq scatter: a smooth contradiction is no scatter. Infinite where the
/// levels are too few.
AnyJoint::Scatter AnyJoint::most_scatter() const {
  if (a_.size() < kFewestForCurve) return {};
  const Scatter about = scatter_about_curves();
  return {kMostOverCurve * about.d, kMostOverCurve * about.k};
}

/// The least that they scatter, over that about the curves: one load that steps disturbs those
/// through levels on either side of it, and only the share of the others is scatter for certain.
double AnyJoint::least_of_curve() const {
  const double reach = a_.size() < kFewestForCurve ? kReachOfLines : kReachOfCubics;
  const double curves = static_cast<double>(a_.size()) - 2.0 * reach;
  return std::max(0.0, 1.0 - 2.0 * reach / curves);
}

/// σ of the rows that have none, from what the best cause leaves. Weighed by it, sliders enough fit
/// either D or k_eq ever more closely: so it is not less than that about smooth curves.
void AnyJoint::read_scatter(const BestFit& fit) {
  const Scatter most = most_scatter();
  const Scatter about = scatter_about_curves();
  const double least_share = least_of_curve();
  const double used = 0.5 * fit.sliders;
  const auto scatter = [&](const Eigen::VectorXd& left, double known, double curve, double limit) {
    const auto rows = static_cast<double>(left.size());
    const double freedom = std::max(rows - used, 0.2 * rows);
    const double found = std::sqrt((left.squaredNorm() + known) / (freedom + known));
    return std::clamp(found, least_share * curve, limit);
  };
  if (!d_given_) {
    sigma_d_ = (scatter(fit.left_of_d, known_d_, about.d, most.d) * sigma_d_).cwiseMax(least_d_);
  }
  if (k_given_) return;
  const double least = std::sqrt(static_cast<double>(each_)) *
                       (frequencies_ ? 2.0 * kLeastFrequencyStd : kLeastSecantStd);
  sigma_k_ = (scatter(fit.left_of_k, known_k_, about.k, most.k) * sigma_k_).cwiseMax(least);
}

// Where the deviations are not given they are read from the best cause, and all is fitted anew.
AnyJoint::Fits AnyJoint::fits() {
  std::vector<Departure> all = departures();
  Fits found;
  for (int pass = 0; pass < (given() ? 1 : kScatterPasses); ++pass) {
    if (pass > 0) read_scatter(found.cause.square < found.none.square ? found.cause : found.none);
    found.none = best({}, 2.0);
    slope_ = found.none.slope;
    std::vector<std::pair<double, Departure>> tried;
    found.cause = {};
    for (const Departure& departure : all) {
      BestFit fit = good(departure);
      tried.emplace_back(fit.square, departure);
      if (!(fit.square < found.cause.square)) continue;
      found.cause = std::move(fit);
      found.named = departure;
    }
    if (frequencies_ && !all.empty()) found.cause = best(found.named, 2.0);
    // Another scatter changes the order of the best ones at most.
    std::ranges::stable_sort(tried, {}, &std::pair<double, Departure>::first);
    all.clear();
    for (std::size_t i = 0; i < std::min(kKept, tried.size()); ++i) all.push_back(tried[i].second);
  }
  return found;
}

double AnyJoint::variance(double square, double parameters, double rows) const {
  const double known = known_d_ + known_k_;
  const double found = (square + known) / (std::max(1.0, rows - parameters) + known);
  return std::min(most_variance(), given() ? std::max(1.0, found) : found);
}

double AnyJoint::most_variance() const {
  const Scatter limits = most_scatter();
  return std::max(1.0, 0.5 * (limits.d * limits.d + limits.k * limits.k));
}

AnyJoint::Excess AnyJoint::excess_of(const Fits& fits, double rows) const {
  const BestFit of_d = fitted({}, true, false, slope_);
  const BestFit of_k = fitted({}, false, true, slope_);
  const double square = fits.none.square;
  const double of_cause = (frequencies_ ? kFrequencyLimit : kCauseLimit) *
                          variance(fits.cause.square, fits.cause.sliders + offset(), rows);
  const Excess cause{std::max(0.0, square - fits.cause.square) / of_cause, of_cause};
  // A mode whose share of the joint changes fits D as little.
  if (frequencies_) return cause;

  const double sliders = of_d.sliders + of_k.sliders;
  const double more = std::max(1.0, sliders - fits.none.sliders);
  const double of_apart = (given() ? kApartLimit + kApartOfEach * more
                                   : kApartLimitOfScatter + kApartOfEachOfScatter * more) *
                          variance(of_d.square + of_k.square, sliders, rows);
  const Excess apart{std::max(0.0, square - of_d.square - of_k.square) / of_apart, of_apart};

  const double of_alone = (rows + kAloneDeviations * std::sqrt(2.0 * rows)) * most_variance();
  const Excess alone{std::isfinite(of_alone) ? square / of_alone : 0.0, of_alone};
  return std::max({cause, apart, alone},
                  [](const Excess& one, const Excess& other) { return one.over < other.over; });
}

double AnyJoint::relative_deviation() const {
  const Eigen::VectorXd relative =
      frequencies_ ? Eigen::VectorXd(0.5 * sigma_k_.cwiseQuotient(k_)) : sigma_k_;
  return std::sqrt(static_cast<double>(relative.size()) / relative.cwiseInverse().squaredNorm());
}

MasingMisfit AnyJoint::misfit() {
  if (frequencies_) {
    slope_ = start_slope();
    for (int i = 0; i < 2; ++i) slope_ = best({}, 8.0).slope;
  }
  correct_common_errors();
  const Fits found = fits();
  const auto rows = static_cast<double>(found.none.left_of_d.size() + found.none.left_of_k.size());
  const Excess excess = excess_of(found, rows);
  MasingMisfit misfit;
  misfit.noise = relative_deviation() * std::sqrt(excess.limit / rows);
  misfit.share = misfit.noise * std::sqrt(excess.over);
  misfit.noise = std::max(misfit.noise, frequencies_ ? kLeastFrequencyNoise : kLeastSecantNoise);
  name_cause(found, rows, misfit);
  return misfit;
}

void AnyJoint::name_cause(const Fits& fits, double rows, MasingMisfit& misfit) const {
  Eigen::Index worst = 0;
  fits.none.left_of_k.cwiseAbs().maxCoeff(&worst);
  const double top = evidence_.levels().amplitude.back();
  misfit.at = top * a_(std::min(worst * each_, a_.size() - 1));
  const double s2 = variance(fits.cause.square, fits.cause.sliders + offset(), rows);
  const double expected = s2 * std::max(1.0, rows - fits.none.sliders - offset());
  if (fits.none.square - fits.cause.square < kMostOfMisfit * (fits.none.square - expected)) {
    // The share of the joint in the mode may change: that is no step.
    if (frequencies_) misfit.share = std::min(misfit.share, misfit.noise);
    return;
  }
  misfit.cause = fits.named.cause;
  misfit.size = fits.named.size;
  if (misfit.cause == LevelCause::kStep) misfit.at = top * fits.named.at;
  if (misfit.cause == LevelCause::kLinearDamping) {
    misfit.size = fits.cause.damping / std::max(1e-300, d_(d_.size() - 1));
  }
}

}  // namespace

std::optional<MasingMisfit> secant_misfit(const LevelEvidence& levels, double stiffness,
                                          bool linear_damping) {
  if (levels.levels().secant_stiffness.empty()) return std::nullopt;
  if (levels.size() < kFewestLevels) return std::nullopt;
  return AnyJoint(levels, stiffness, linear_damping, false).misfit();
}

std::optional<MasingMisfit> frequency_misfit(const LevelEvidence& levels, double stiffness,
                                             bool linear_damping) {
  if (levels.levels().frequency.empty() || levels.size() < kFewestLevels) return std::nullopt;
  return AnyJoint(levels, stiffness, linear_damping, true).misfit();
}

}  // namespace microslip
