// SPDX-License-Identifier: MIT
#include "microslip/identify/posterior/density_posterior.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "microslip/algebra/core.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/identify/posterior/plain_matrix_view.hpp"
#include "microslip/identify/posterior/possible_coefficients.hpp"
#include "microslip/identify/posterior/posterior_chain.hpp"
#include "microslip/identify/smoothing/eigen_view.hpp"

namespace microslip {
namespace {

/// Streams of the common errors of single draws come after those of the chains.
constexpr std::uint64_t kErrorStreams = std::uint64_t{1} << 32U;
/// λ of extremes over the smallest of a posterior, and that of few levels.
constexpr double kHardlySmooth = 1e-3;
constexpr double kHardlySmoothOfFewest = 1e-8;
/// One draw of so many is an extreme, where there are any.
constexpr std::size_t kEachExtreme = 4;

/// Memory of a draw, and of its copy in the result.
double bytes_of_draw(std::size_t knots) {
  return 2.0 * static_cast<double>(sizeof(DensitySample) + knots * sizeof(double));
}

constexpr std::string_view kUnchanged = "Take a posterior of a result of invert(), unchanged.";

void check_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(fmt::format("number of values of {} in the posterior", what),
                   static_cast<double>(length), fmt::format("must be {}", expected),
                   std::string(kUnchanged));
}

void check_shape(std::string_view what, const PlainMatrix& m, std::size_t columns,
                 std::size_t rows) {
  check_length(fmt::format("a row of {}", what), m.columns, columns);
  check_length(what, m.values.size(), rows * columns);
}

/// Checks a matrix with any number of rows.
void check_columns(std::string_view what, const PlainMatrix& m, std::size_t columns) {
  check_shape(what, m, m.values.empty() ? m.columns : columns, m.rows());
}

void check_positive(std::string_view what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(fmt::format("{} of the posterior", what), value, "must be positive and finite",
                   std::string(kUnchanged));
}

void check_rows(std::string_view what, const PosteriorRows& rows, std::size_t columns,
                bool with_loss) {
  check_columns(what, rows.factor, columns);
  check_length(fmt::format("data of {}", what), rows.data.size(), rows.factor.rows());
  if (with_loss) {
    check_length(fmt::format("linear loss of {}", what), rows.linear_loss.size(),
                 rows.factor.rows());
  }
  if (rows.factor.rows() > 0) check_positive(fmt::format("count of {}", what), rows.count);
}

ChainRows chain_rows(const PosteriorRows& rows) {
  ChainRows all;
  all.design = matrix_of(rows.factor);
  all.data = view_of(rows.data);
  all.shift = view_of(rows.linear_loss);
  all.more_square = rows.more_square;
  all.count = rows.count;
  all.least_scale = rows.least_scatter;
  if (rows.most_scatter > 0.0) all.most_scale = rows.most_scatter;
  return all;
}

ChainTarget chain_target(const DensityPosterior& posterior) {
  ChainTarget target;
  target.rows.push_back(chain_rows(posterior.dissipation));
  if (posterior.secant.factor.rows() > 0) target.rows.push_back(chain_rows(posterior.secant));
  target.penalty = matrix_of(posterior.penalty);
  target.limits = {static_cast<Eigen::Index>(posterior.area.size()), view_of(posterior.area)};
  target.local_deviation = posterior.local_deviation;
  target.least_lambda = posterior.smoothing.least;
  target.most_lambda = posterior.smoothing.most;
  return target;
}

ChainStart chain_start(const DensityPosterior& posterior, const ChainTarget& target) {
  return {view_of(posterior.start), posterior.smoothing.chosen,
          std::vector<double>(target.rows.size(), posterior.scatter)};
}

/// With true D = e·D and true A = c·A, (7) holds for φ(f*) = e/c³ φ_found(f*/c).
void apply_gains(const std::vector<double>& knots, const CommonErrorDraw& draw,
                 DensitySample& sample) {
  const double e = draw.dissipation_gain;
  const double c = draw.amplitude_gain;
  if (e == 1.0 && c == 1.0) return;
  const std::vector<double> found = sample.density;
  for (std::size_t j = 0; j < knots.size(); ++j) {
    sample.density[j] = e / (c * c * c) * interpolate(knots, found, knots[j] / c);
  }
  sample.atom_weight *= e / (c * c);
  sample.linear_damping *= e / (c * c);
  sample.area = sample.atom_weight + integral(knots, sample.density);
  // More stiffness than k cannot slip: such gains are not possible with that much density.
  if (sample.area <= 1.0) return;
  for (double& value : sample.density) value /= sample.area;
  sample.atom_weight /= sample.area;
  sample.area = 1.0;
}

DensitySample read_sample(const DensityPosterior& posterior, const Eigen::VectorXd& x) {
  DensitySample sample;
  const Eigen::VectorXd at_knots = matrix_of(posterior.density) * x;
  sample.density.assign(at_knots.begin(), at_knots.end());
  sample.area = view_of(posterior.area).dot(x);
  sample.linear_damping = view_of(posterior.linear_damping).dot(x);
  sample.atom_weight = view_of(posterior.atom_weight).dot(x);
  return sample;
}

/// The draw that is brought within the limits, or the last one where that fails.
Eigen::VectorXd within_limits(const PosteriorChain& chain, RandomStream& random) {
  const QuadraticProgram::Solution solution = chain.projected(random);
  return solution.optimal() ? solution.x : chain.coefficients();
}

/// The draws with the largest values of the goals.
std::vector<DensitySample> extremes(const DensityPosterior& posterior) {
  std::vector<DensitySample> ends;
  const std::size_t columns = posterior.goals.columns;
  for (std::size_t i = 0; i < posterior.goals.rows(); ++i) {
    const auto row = posterior.goals.values.begin() + static_cast<std::ptrdiff_t>(i * columns);
    const std::vector<double> goal(row, row + static_cast<std::ptrdiff_t>(columns));
    const std::vector<double> x =
        posterior.extreme([&goal](const std::vector<double>&) { return goal; }, posterior.rises[i]);
    ends.push_back(read_sample(posterior, view_of(x)));
    ends.back().extreme = true;
  }
  return ends;
}

/// Counts draws of all chains, one call at a time.
class DrawCounter {
 public:
  DrawCounter(std::size_t total, const Progress& progress) : total_(total), progress_(progress) {}

  void count() {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    if (!progress_(++done_, total_)) throw Cancelled();
  }

 private:
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::size_t total_;
  const Progress& progress_;
};

}  // namespace

void DensityPosterior::check() const {
  const std::size_t n = area.size();
  if (n == 0 || start.empty() || slip_force.empty()) {
    throw InputError("posterior", "empty", "must not be empty", std::string(kUnchanged));
  }
  check_shape("density", density, n, slip_force.size());
  check_length("linear_damping", linear_damping.size(), n);
  check_length("atom_weight", atom_weight.size(), n);
  check_length("start", start.size(), n);
  common_errors.check();
  check_rows("dissipation", dissipation, n, common_errors.loss_factor_std > 0.0);
  check_rows("secant", secant, n, false);
  check_columns("penalty", penalty, n);
  check_columns("goals", goals, n);
  check_length("rises", rises.size(), goals.rows());
  for (const double rise : rises) check_positive("rise", rise);
  check_positive("scatter", scatter);
  check_positive("local deviation", local_deviation);
  check_positive("smallest smoothing", smoothing.least);
  check_positive("smoothing", smoothing.chosen);
  if (!(smoothing.most >= smoothing.least)) {
    throw InputError("largest smoothing of the posterior", smoothing.most,
                     "must not be below the smallest", std::string(kUnchanged));
  }
  for (const DensityPosterior& other : others) {
    other.check();
    check_length("slip_force of another", other.slip_force.size(), slip_force.size());
    check_length("others of another", other.others.size(), 0);
  }
}

std::vector<double> DensityPosterior::extreme(
    const std::function<std::vector<double>(const std::vector<double>&)>& gradient,
    double rise) const {
  const bool given = smoothing.least == smoothing.most;
  const double share = reaches_limits ? kHardlySmoothOfFewest : kHardlySmooth;
  PossibleCoefficients possible(matrix_of(penalty),
                                given ? smoothing.chosen : share * smoothing.least, view_of(area));
  possible.add(matrix_of(dissipation.factor), view_of(dissipation.data), scatter);
  if (secant.factor.rows() > 0) {
    possible.add(matrix_of(secant.factor), view_of(secant.data),
                 std::max(scatter, secant.least_scatter));
  }
  const Eigen::VectorXd x = possible.extreme(
      [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
        return view_of(gradient({at.begin(), at.end()}));
      },
      rise);
  return {x.begin(), x.end()};
}

std::vector<DensitySample> DensityPosterior::samples(std::uint64_t seed, std::size_t count,
                                                     const Execution& execution,
                                                     const Progress& progress) const {
  check();
  check_memory("draws of the density", static_cast<double>(count), bytes_of_draw(slip_force.size()),
               "Take fewer.");
  std::vector<const DensityPosterior*> posteriors{this};
  for (const DensityPosterior& other : others) posteriors.push_back(&other);
  std::vector<ChainTarget> targets;
  for (const DensityPosterior* posterior : posteriors) targets.push_back(chain_target(*posterior));
  std::vector<DensitySample> all(count);
  const std::vector<DensitySample> ends = extremes(*this);
  DrawCounter counter(count, progress);
  const std::size_t length = chain_length();
  execution.for_each((count + length - 1) / length, [&](std::size_t number) {
    const DensityPosterior& drawn = *posteriors[number % posteriors.size()];
    const ChainTarget& target = targets[number % posteriors.size()];
    PosteriorChain chain(target, chain_start(drawn, target));
    RandomStream random(seed, number);
    chain.settle(random);
    for (std::size_t i = number * length; i < std::min(count, (number + 1) * length); ++i) {
      RandomStream of_errors(seed, kErrorStreams + i);
      const CommonErrorDraw errors = common_errors.draw(of_errors);
      if (common_errors.loss_factor_std > 0.0) chain.set_error(errors.loss_factor);
      const Eigen::VectorXd& x = chain.next(random);
      if (!ends.empty() && i % kEachExtreme == kEachExtreme - 1) {
        all[i] = ends[i / kEachExtreme % ends.size()];
      } else if (reaches_limits && i % 2 == 1) {
        all[i] = read_sample(drawn, within_limits(chain, random));
      } else {
        all[i] = read_sample(drawn, x);
      }
      apply_gains(slip_force, errors, all[i]);
      counter.count();
    }
  });
  return all;
}

}  // namespace microslip
