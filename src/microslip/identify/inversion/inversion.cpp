// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/inversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "microslip/algebra/cholesky.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/median.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/inversion/inversion_model.hpp"
#include "microslip/identify/inversion/inversion_passes.hpp"
#include "microslip/identify/inversion/inversion_reading.hpp"
#include "microslip/identify/inversion/level_edges.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"
#include "microslip/identify/smoothing/signed_density.hpp"

namespace microslip {
namespace {

/// Places of the edges that draws take, beside the likeliest.
constexpr std::size_t kPlacesOfEdges = 8;
/// Slip forces at which an atom is sought first, and the levels that it takes.
constexpr int kAtomCandidates = 41;
constexpr int kAtomPlacesNear = 13;
constexpr Eigen::Index kFewestForAtom = 20;
/// Fewer levels hardly distinguish an edge or a trend from a smooth density.
constexpr Eigen::Index kFewestForShape = 40;
/// Difference of Schwarz's criterion: "very strong" [Kass & Raftery, J. Am. Stat. Assoc. 90 (1995)
/// 773].
constexpr double kStrongEvidence = 10.0;
/// The least share of an atom in the area.
constexpr double kLeastAtom = 1e-2;

/// The basis follows a density with steps and atoms to about this share of D: less scatter proves
/// nothing about limits.
constexpr double kResolution = 5e-3;
/// A slider below all levels, over the lowest of them: D of all that slips there lies between that
/// of this one and of one at the lowest level.
constexpr double kBelowLevels = 1e-3;
constexpr double kSliderRidge = 1e-12;

void check_count(const Levels& merged) {
  if (merged.size() < kFewestLevels) {
    throw InputError("number of different amplitudes", static_cast<double>(merged.size()),
                     fmt::format("must be {} or more to identify a density", kFewestLevels),
                     "Measure more levels, or fit a model with fewer parameters.");
  }
  if (std::ranges::all_of(merged.dissipation, [](double d) { return d == 0.0; })) {
    throw InputError("dissipation", "0 at all levels", "must be positive at one level at least");
  }
}

/// Whether edges are requested and the levels sufficient.
bool seeks_shape(const ScaledLevels& levels, const InversionOptions& options) {
  return options.edges && levels.amplitude.size() >= kFewestForShape;
}

/// A model, and others with its edges at places that are as likely.
struct ShapedModel {
  InversionModel model;
  std::vector<InversionModel> elsewhere = {};
};

/// The model with the same smoothing and scatter, and edges elsewhere.
InversionModel moved_edges(const ScaledLevels& levels, PassOptions pass,
                           std::vector<BasisEdge> edges, const InversionModel& like,
                           InnerSolutions& inner) {
  pass.edges = std::move(edges);
  InversionModel model(levels, pass);
  model.take_smoothing(like);
  const SmoothingPoint& start = like.solution();
  model.path[model.chosen] = model.problem().solve(start.lambda, start.solution.free);
  inner.add(model.solution().solution);
  return model;
}

/// The model with edges, and a trend of the smoothness, where they are likely.
ShapedModel shaped(const PassedModel& passed, const ScaledLevels& levels,
                   const InversionOptions& options, InnerSolutions& inner) {
  PassOptions pass = passed.pass;
  const bool sought = seeks_shape(levels, options);
  if (sought) find_shape(levels, passed.model.solution().lambda, pass, inner);
  const bool same = pass.edges.empty() && pass.trend == 0.0 && !options.lambda;
  ShapedModel found{same ? passed.model : InversionModel(levels, pass)};
  found.model.shape_sought = sought;
  found.model.trend = pass.trend;
  if (same) return found;
  run_path(found.model, options, options.path_points, inner);
  separate_scatter(found.model, levels);
  if (pass.edges.empty()) return found;
  for (std::vector<BasisEdge>& edges :
       edges_elsewhere(levels, found.model.solution().lambda, pass, kPlacesOfEdges, inner)) {
    found.elsewhere.push_back(moved_edges(levels, pass, std::move(edges), found.model, inner));
  }
  return found;
}

/// Schwarz's criterion of a model: m ln rss + edf ln m, with residuals relative to the same d for
/// all models, whatever their weights. An edge costs as much as the place of an atom.
double schwarz_criterion(const ScaledLevels& levels, const InversionModel& model) {
  const SmoothingPoint& point = model.solution();
  const Eigen::ArrayXd typical = levels.typical.cwiseMax(levels.floor).array();
  const Eigen::ArrayXd left = (levels.dissipation - model.dissipation(point.solution.x)).array();
  const double residual = std::max(1e-20, (left / typical).square().sum());
  const auto m = static_cast<double>(levels.amplitude.size());
  const auto places = static_cast<double>(model.basis().edges().size());
  return m * std::log(residual) + point.edf * std::log(m) +
         places * (std::log(m) + kStrongEvidence);
}

/// Seeks an atom at macro-slip beside the edges that the density may have.
class AtomSearch {
 public:
  AtomSearch(const ScaledLevels& levels, const InversionOptions& options, InnerSolutions& inner)
      : levels_(levels), options_(options), inner_(inner) {
    options_.lambda.reset();
  }

  /// Its slip force as a share of kA_max: it ends the density, and above it D grows linearly.
  /// Nothing where the density continues to the end of the data or ends without an atom, or where
  /// the levels are too few to decide.
  [[nodiscard]] std::optional<double> find();

 private:
  [[nodiscard]] double without_atom();
  [[nodiscard]] double criterion_of_atom(const InversionModel& model) const;
  [[nodiscard]] double with_atom(double top, std::size_t edges);
  [[nodiscard]] std::pair<double, double> likeliest(std::size_t edges);
  [[nodiscard]] double with_atom_and_new_edges(double top);
  [[nodiscard]] InversionModel pathed(const PassOptions& pass);

  const ScaledLevels& levels_;
  InversionOptions options_;
  InnerSolutions& inner_;
  std::vector<double> edges_;  // of the density without an atom, as shares of kA_max
};

InversionModel AtomSearch::pathed(const PassOptions& pass) {
  InversionModel model(levels_, pass);
  run_path(model, options_, kFirstPassPoints, inner_);
  return model;
}

double AtomSearch::without_atom() {
  const PassedModel smooth = two_passes(levels_, options_, 1.0, false, inner_);
  if (!seeks_shape(levels_, options_)) return schwarz_criterion(levels_, smooth.model);
  PassOptions pass = smooth.pass;
  find_shape(levels_, smooth.model.solution().lambda, pass, inner_);
  const InversionModel model = pathed(pass);
  edges_ = model.basis().edges();
  return schwarz_criterion(levels_, model);
}

/// Infinite where the atom has no weight: the density just ends there.
double AtomSearch::criterion_of_atom(const InversionModel& model) const {
  const Eigen::VectorXd& x = model.solution().solution.x;
  const bool has_weight = model.atom_weight(x) > kLeastAtom * model.problem().area().dot(x);
  return has_weight ? schwarz_criterion(levels_, model) : std::numeric_limits<double>::infinity();
}

/// The criterion with the atom and the first of the edges found without it: those next to an atom
/// may have replaced it.
double AtomSearch::with_atom(double top, std::size_t edges) {
  const PassedModel smooth = two_passes(levels_, options_, top, true, inner_);
  if (edges == 0) return criterion_of_atom(smooth.model);
  PassOptions pass = smooth.pass;
  int free_from = InversionBasis::kLeastBetween;
  for (std::size_t e = 0; e < edges; ++e) {
    const double place = smooth.model.basis().place(edges_[e]);
    const int knot = static_cast<int>(std::lround(place));
    if (knot < free_from || knot + InversionBasis::kLeastBetween >= pass.coefficients) {
      return std::numeric_limits<double>::infinity();
    }
    pass.edges.push_back({knot, place});
    free_from = knot + InversionBasis::kLeastBetween;
  }
  return criterion_of_atom(pathed(pass));
}

/// The place where the criterion is least, and its value there. It is not smooth: λ is chosen anew
/// everywhere, so the best of some places around the best of all comes before the search between
/// two.
std::pair<double, double> AtomSearch::likeliest(std::size_t edges) {
  // Two levels at least must lie beyond an atom to show the straight line.
  const double first = levels_.amplitude(2);
  const double last = levels_.amplitude(levels_.amplitude.size() - 3);
  double best = first;
  double lowest = std::numeric_limits<double>::infinity();
  const auto look = [&](double from, double to, int places) {
    const double ratio = std::pow(to / from, 1.0 / (places - 1));
    for (int i = 0; i < places; ++i) {
      const double top = from * std::pow(ratio, i);
      const double value = with_atom(top, edges);
      if (value < lowest) {
        best = top;
        lowest = value;
      }
    }
    return ratio;
  };
  const double coarse = look(first, last, kAtomCandidates);
  if (lowest == std::numeric_limits<double>::infinity()) return {best, lowest};
  const double fine = look(best / coarse, std::min(best * coarse, last), kAtomPlacesNear);
  std::uintmax_t iterations = 20;
  const std::pair<double, double> found = boost::math::tools::brent_find_minima(
      [&](double top) { return with_atom(top, edges); }, best / fine, std::min(best * fine, last),
      12, iterations);
  return found.second < lowest ? found : std::pair{best, lowest};
}

double AtomSearch::with_atom_and_new_edges(double top) {
  const PassedModel smooth = two_passes(levels_, options_, top, true, inner_);
  const double least = criterion_of_atom(smooth.model);
  if (!seeks_shape(levels_, options_)) return least;
  PassOptions pass = smooth.pass;
  find_shape(levels_, smooth.model.solution().lambda, pass, inner_);
  return std::min(least, criterion_of_atom(pathed(pass)));
}

std::optional<double> AtomSearch::find() {
  const Eigen::Index count = levels_.amplitude.size();
  if (count < kFewestForAtom) return std::nullopt;
  const double without = without_atom();
  std::pair<double, double> best = likeliest(0);
  for (std::size_t edges = 1; edges <= edges_.size(); ++edges) {
    const std::pair<double, double> found = likeliest(edges);
    if (found.second < best.second) best = found;
  }
  // The position is a parameter of its own. A density that ends at once does so at an edge: that it
  // is an atom must be likely beyond that edge.
  const double parameters = edges_.empty() ? 1.0 : 2.0;
  const double price = parameters * std::log(static_cast<double>(count)) + kStrongEvidence;
  if (!(with_atom_and_new_edges(best.first) + price < without)) return std::nullopt;
  return best.first;
}

/// σ̂ in units of 1/W from a residual, not below what the basis resolves.
double scatter_beyond_resolution(const InversionModel& model, const ScaledLevels& levels,
                                 const SmoothingPoint& point) {
  const Eigen::ArrayXd signal_to_noise =
      model.problem().data().head(levels.amplitude.size());  // d/σ
  const double typical = median({signal_to_noise.begin(), signal_to_noise.end()});
  return std::max(
      {estimate_scatter(model, point.residual, point.edf).value, kResolution * typical, 1e-150});
}

/// The likeliest solution without any limit.
SmoothingPoint unlimited_solution(const InversionModel& model) {
  SmoothingPoint best;
  best.likelihood = std::numeric_limits<double>::infinity();
  for (const SmoothingPoint& point : model.path) {
    SmoothingPoint unlimited = model.problem().solve_unlimited(point.lambda);
    const bool allowed = unlimited.edf <= model.most_edf;
    if (allowed && unlimited.likelihood < best.likelihood) best = std::move(unlimited);
  }
  return best;
}

/// Sliders whose sums are nearly all joints at these levels: one below them, and one at each, or at
/// every so many, of which the convex d between is linear to kResolution and far less.
Eigen::VectorXd sliders_of_any_joint(const Eigen::VectorXd& amplitude) {
  constexpr Eigen::Index kMostSliders = 300;
  const Eigen::Index n = amplitude.size();
  const Eigen::Index each = (n + kMostSliders - 1) / kMostSliders;
  const Eigen::Index count = (n - 1 + each - 1) / each;  // one at the largest level does not slip
  Eigen::VectorXd sliders(count + 1);
  sliders(0) = kBelowLevels * amplitude(0);
  for (Eigen::Index j = 0; j < count; ++j) sliders(j + 1) = amplitude(j * each);
  return sliders;
}

/// What is left of the weighted D beside the nearest of all joints, d = 4 Σ ψ_j x_j (a − x_j)₊ with
/// ψ_j ≥ 0. At the levels all convex d with d(0) = 0 are those of sliders at them and of one below.
Eigen::VectorXd left_of_any_joint(const ScaledLevels& levels, const Eigen::VectorXd& weights) {
  constexpr Eigen::Index kRows = 4096;  // at once: of many levels all are no matrix to keep
  const Eigen::Index n = levels.amplitude.size();
  const Eigen::VectorXd sliders = sliders_of_any_joint(levels.amplitude);
  const Eigen::VectorXd data = weights.cwiseProduct(levels.dissipation);
  const auto rows = [&](Eigen::Index first) {
    const Eigen::Index count = std::min(kRows, n - first);
    Eigen::MatrixXd block(count, sliders.size());
    for (Eigen::Index j = 0; j < sliders.size(); ++j) {
      const auto slip = (levels.amplitude.segment(first, count).array() - sliders(j)).max(0.0);
      block.col(j) = weights.segment(first, count).array() * slip;
    }
    return block;
  };
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(sliders.size(), sliders.size());
  Eigen::VectorXd linear = Eigen::VectorXd::Zero(sliders.size());
  for (Eigen::Index first = 0; first < n; first += kRows) {
    const Eigen::MatrixXd block = rows(first);
    hessian.noalias() += block.transpose() * block;
    linear.noalias() += block.transpose() * data.segment(first, block.rows());
  }
  const Eigen::VectorXd unit = hessian.diagonal().cwiseSqrt().cwiseInverse();
  hessian = unit.asDiagonal() * hessian * unit.asDiagonal();
  hessian.diagonal().array() += kSliderRidge;
  const QuadraticProgram::Solution solution =
      QuadraticProgram(Eigen::VectorXd::Zero(sliders.size()), 1.0)
          .solve(hessian, unit.cwiseProduct(linear),
                 std::vector<bool>(static_cast<std::size_t>(sliders.size()), false));
  const Eigen::VectorXd weight = unit.cwiseProduct(solution.x);
  Eigen::VectorXd left = data;
  for (Eigen::Index first = 0; first < n; first += kRows) {
    const Eigen::MatrixXd block = rows(first);
    left.segment(first, block.rows()) -= block * weight;
  }
  return left;
}

// A test of the unlimited density itself would find every peak and edge guilty, as a smoother rings
// beside them. What the nearest of all joints leaves of D contains no peaks and edges any more,
// wherever they lie between the knots of the basis, only what no density ≥ 0 can explain.
void judge_sign(const InversionModel& model, const ScaledLevels& levels, InversionResult& result,
                InnerSolutions& inner) {
  const SmoothingProblem& problem = model.problem();
  const SmoothingPoint unlimited = unlimited_solution(model);
  if (unlimited.lambda == 0.0) return;
  QuadraticProgram no_budget(problem.area(), 1e9);
  const SmoothingPoint& last = model.path.back();
  const double lambda = std::max(1e-3 * unlimited.lambda, last.lambda);
  const QuadraticProgram::Solution solution =
      no_budget.solve(problem.hessian(lambda), problem.linear(), last.solution.free);
  inner.add(solution);
  const Eigen::VectorXd& flexible = solution.x;
  const Eigen::Index of_d = model.dissipation_rows();
  const Eigen::VectorXd left = left_of_any_joint(levels, model.weights().head(of_d));

  // Posterior covariance of the coefficients: variance·H⁻¹; of the densities row by row.
  // Beside k_eq that of D alone may be larger than that of all rows.
  const double scatter = std::max(1.0, model.dissipation_scatter) *
                         scatter_beyond_resolution(model, levels, unlimited);
  const Eigen::LLT<Eigen::MatrixXd> factor(problem.hessian(unlimited.lambda));
  const Eigen::VectorXd change = factor.solve(problem.design().topRows(of_d).transpose() * left);
  const Eigen::MatrixXd to_density = model.density_matrix();
  const Eigen::MatrixXd whitened = factor.matrixL().solve(to_density.transpose());
  const Eigen::ArrayXd deviation = scatter * whitened.colwise().norm().transpose().array();
  const Eigen::ArrayXd changed = (to_density * (flexible + change)).array();
  const Eigen::ArrayXd score =
      (changed < 0.0).select((to_density * change).array() / deviation, 0.0);
  Eigen::Index lowest = 0;
  result.lowest_score = std::min(0.0, score.minCoeff(&lowest));
  result.lowest_at =
      model.largest_slip_force() * model.basis().knots()[static_cast<std::size_t>(lowest)];
}

/// The cost of area ≤ 1: the solution without it, at the same λ.
void judge_area(const InversionModel& model, const ScaledLevels& levels, InversionResult& result,
                InnerSolutions& inner) {
  const SmoothingPoint& point = model.solution();
  const SmoothingProblem& problem = model.problem();
  const auto objective = [&](const Eigen::VectorXd& x) {
    return (problem.data() - problem.design() * x).squaredNorm() +
           point.lambda * (problem.penalty() * x).squaredNorm();
  };
  QuadraticProgram unlimited(problem.area(), 1e9);
  const QuadraticProgram::Solution solution =
      unlimited.solve(problem.hessian(point.lambda), problem.linear(), point.solution.free);
  inner.add(solution);
  const Eigen::VectorXd& positive = solution.x;
  result.unlimited_area = problem.area().dot(positive);
  const double scatter =
      scatter_beyond_resolution(model, levels, problem.solve_unlimited(point.lambda));
  result.area_cost =
      std::max(0.0, objective(point.solution.x) - objective(positive)) / (scatter * scatter);
}

}  // namespace

InversionResult invert(const LevelEvidence& evidence, double stiffness,
                       const InversionOptions& options) {
  Stopwatch watch;
  check_stiffness(stiffness);
  options.check();
  check_count(evidence.levels());
  const ScaledLevels scaled(evidence, stiffness);

  InversionResult result;
  InnerSolutions inner;
  std::vector<Summary::Timing> timings;
  double top = 1.0;
  if (options.atom) {
    if (const std::optional<double> found = AtomSearch(scaled, options, inner).find()) {
      top = *found;
      result.atom_slip_force = top * scaled.largest_slip_force;
    }
    timings.push_back(watch.lap("search of an atom"));
  }
  const PassedModel smooth =
      two_passes(scaled, options, top, result.atom_slip_force.has_value(), inner);
  timings.push_back(watch.lap("choice of the smoothing"));
  const auto [model, elsewhere] = shaped(smooth, scaled, options, inner);
  read_model(model, elsewhere, scaled, result);
  if (options.linear_damping) {
    result.linear_damping = stiffness * model.linear_damping(model.solution().solution.x);
  }
  timings.push_back(watch.lap("search of edges"));
  // Edges would absorb the contradiction of a density at one place.
  judge_sign(smooth.model, scaled, result, inner);
  judge_area(smooth.model, scaled, result, inner);
  // The chosen point of the path is the result itself.
  result.inner_solutions = inner.count - 1;
  result.inner_not_converged = inner.not_converged - (result.summary.converged() ? 0 : 1);
  timings.push_back(watch.lap("judgement"));
  result.summary.timings = std::move(timings);
  result.summary.wall_seconds = watch.seconds();
  return result;
}

}  // namespace microslip
