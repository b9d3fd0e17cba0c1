// SPDX-License-Identifier: MIT
#include "microslip/identify/edge_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace microslip {
namespace {

constexpr std::size_t kMostEdges = 8;
/// So many edges together may be needed before one of them tells.
constexpr std::size_t kLookAhead = 3;
constexpr double kVeryStrong = 10.0;
/// Of what holds a knot in place, so that one that nothing else holds is no division by 0.
constexpr double kHeld = 1e-9;
/// Steps of λ while places are compared, and while one is moved.
constexpr double kCoarseStep = 10.0;
constexpr double kFineStep = 2.0;
/// Of the trend: its prior deviation, the step in which it is sought, and how far.
constexpr double kTrendDeviation = 3.0;
constexpr double kTrendStep = 2.0;
constexpr double kMostTrend = 6.0;
constexpr double kMostTrendOnTheWay = 20.0;  ///< until all edges are found
/// By which the evidence must rise for a step of the trend: it is one number more.
constexpr double kTrendPrice = 2.0;
/// Steps of λ without success before the search of it ends.
constexpr int kPatience = 4;
constexpr int kMostSteps = 60;
/// Knots that are tried for another edge.
constexpr std::size_t kPlaces = 6;
/// On either side of a knot, within one spacing; the minimum lies between two of them.
constexpr int kPlacesOfCell = 4;
constexpr std::uintmax_t kMostOfBrent = 8;
/// How far from an edge its deviation is sought first, in spacings, and how often.
constexpr double kFirstDistance = 0.1;
constexpr int kDistances = 9;
/// Of a row of numbers mod 1 that fills 0 to 1 evenly: the golden section.
constexpr double kEven = 0.6180339887498949;
/// Rounds in which all edges are moved, and what the evidence must fall by for another.
constexpr int kMostRounds = 4;
constexpr double kWorthARound = 2.0;
/// Levels in a range between edges: a straight line, and something that it may be wrong by.
constexpr Eigen::Index kLeastLevels = 3;

/// A model with edges and a trend at its likeliest λ.
struct EdgedFit {
  std::vector<BasisEdge> edges;
  double trend = 0.0;
  double lambda = 0.0;
  double evidence = std::numeric_limits<double>::infinity();
};

class EdgeSearch {
 public:
  EdgeSearch(const ScaledLevels& levels, PassOptions pass, InnerSolutions& inner)
      : levels_(levels),
        pass_(std::move(pass)),
        inner_(inner),
        uniform_(levels.amplitude(0), pass_.top, pass_.exponent, pass_.coefficients),
        price_(kVeryStrong + 2.0 * std::log(static_cast<double>(pass_.coefficients))) {}

  /// With λ sought from a start on, in steps of a factor.
  EdgedFit fit(std::vector<BasisEdge> edges, double trend, double start, double factor);

  /// With the likeliest trend.
  EdgedFit bent(EdgedFit fit);

  /// With the most likely edge more; nothing where there is no room.
  std::optional<EdgedFit> with_another(const EdgedFit& fit);

  /// With each edge where it is likeliest.
  EdgedFit moved(EdgedFit fit);

  /// Standard deviation of the place of an edge, in spacings.
  double deviation(const EdgedFit& fit, std::size_t edge);

  /// Without those that are not worth their price.
  EdgedFit thinned(EdgedFit fit);

  [[nodiscard]] double price() const { return price_; }

  /// Whether edges are far enough from each other.
  [[nodiscard]] bool has_room(const std::vector<BasisEdge>& edges) const;

 private:
  [[nodiscard]] std::vector<BasisEdge> with(const std::vector<BasisEdge>& edges, int knot) const;
  [[nodiscard]] std::vector<int> likely_places(const EdgedFit& fit);
  EdgedFit moved(EdgedFit fit, std::size_t edge);
  EdgedFit at(const EdgedFit& fit, std::size_t edge, double place);

  const ScaledLevels& levels_;
  PassOptions pass_;
  InnerSolutions& inner_;
  InversionBasis uniform_;  // without edges
  double price_;
};

EdgedFit EdgeSearch::fit(std::vector<BasisEdge> edges, double trend, double start, double factor) {
  pass_.edges = edges;
  pass_.trend = trend;
  const InversionModel model(levels_, pass_);
  const double most_edf =
      most_degrees_of_freedom(model.problem().rows(), model.problem().unpenalised());
  EdgedFit best;
  best.edges = std::move(edges);
  best.trend = trend;
  best.lambda = start;
  std::vector<bool> free(static_cast<std::size_t>(model.problem().size()), true);
  bool too_flexible = false;
  const auto improves = [&](double lambda) {
    too_flexible = false;
    if (lambda > model.problem().stiffest()) return false;
    const SmoothingPoint point = model.problem().solve(lambda, free);
    inner_.add(point.solution);
    too_flexible = point.edf > most_edf;
    if (too_flexible) return false;
    const double evidence = model.evidence(point) + std::pow(trend / kTrendDeviation, 2);
    if (!(evidence < best.evidence)) return false;
    free = point.solution.free;
    best.lambda = lambda;
    best.evidence = evidence;
    return true;
  };
  improves(start);
  // An edge may ask for far more smoothing than there was, with less likely λ in between.
  const int patience = factor >= kCoarseStep ? kPatience : 1;
  for (const double step : {factor, 1.0 / factor}) {
    double lambda = start;
    for (int in_vain = 0, i = 0; in_vain < patience && i < kMostSteps; ++i) {
      lambda *= step;
      in_vain = improves(lambda) || too_flexible ? 0 : in_vain + 1;
    }
    if (best.lambda != start) break;
  }
  return best;
}

EdgedFit EdgeSearch::bent(EdgedFit fit) {
  const double most = fit.edges.empty() ? kMostTrend : kMostTrendOnTheWay;
  for (const double step : {kTrendStep, -kTrendStep}) {
    while (std::abs(fit.trend + step) <= most) {
      EdgedFit tried = this->fit(fit.edges, fit.trend + step, fit.lambda, kFineStep);
      if (!(tried.evidence < fit.evidence - kTrendPrice)) break;
      fit = std::move(tried);
    }
  }
  return fit;
}

bool EdgeSearch::has_room(const std::vector<BasisEdge>& edges) const {
  const auto below = [&](double at) {
    return (levels_.amplitude.array() < uniform_.slip_force(at)).count();
  };
  int knot = 0;
  Eigen::Index levels = 0;
  const auto room_until = [&](int next_knot, Eigen::Index next_levels) {
    const bool room =
        next_knot - knot >= InversionBasis::kLeastBetween && next_levels - levels >= kLeastLevels;
    knot = next_knot;
    levels = next_levels;
    return room;
  };
  return std::ranges::all_of(edges,
                             [&](const BasisEdge& e) { return room_until(e.knot, below(e.at)); }) &&
         room_until(pass_.coefficients - 1, levels_.amplitude.size());
}

std::vector<BasisEdge> EdgeSearch::with(const std::vector<BasisEdge>& edges, int knot) const {
  std::vector<BasisEdge> more = edges;
  const auto next = std::ranges::find_if(more, [&](const BasisEdge& e) { return e.knot > knot; });
  more.insert(next, BasisEdge{knot, static_cast<double>(knot)});
  return more;
}

// Where the solution gains most from leaving out the penalty around a knot: by
// λyᵀ(I − λLH⁻¹Lᵀ)⁻¹y, y = Lx, L the rows that reach it.
std::vector<int> EdgeSearch::likely_places(const EdgedFit& fit) {
  pass_.edges = fit.edges;
  pass_.trend = fit.trend;
  const InversionModel model(levels_, pass_);
  const SmoothingProblem& problem = model.problem();
  const SmoothingPoint point =
      problem.solve(fit.lambda, std::vector<bool>(static_cast<std::size_t>(problem.size()), true));
  inner_.add(point.solution);
  const std::vector<Eigen::Index> free = free_coefficients(point.solution);
  const Eigen::MatrixXd penalty = problem.penalty()(Eigen::all, free);
  const Eigen::LLT<Eigen::MatrixXd> factor(problem.hessian(fit.lambda)(free, free));
  const Eigen::MatrixXd bound = fit.lambda * penalty * factor.solve(penalty.transpose());
  const Eigen::VectorXd bend = problem.penalty() * point.solution.x;
  const Eigen::VectorXd middles = model.basis().middles();

  std::vector<std::pair<double, int>> gains;
  for (int knot = 1; knot + 1 < pass_.coefficients; ++knot) {
    if (!has_room(with(fit.edges, knot))) continue;
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < middles.size(); ++i) {
      if (std::abs(middles(i) - knot) < 1.5) rows.push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(rows.size());
    const Eigen::MatrixXd left =
        (1.0 + kHeld) * Eigen::MatrixXd::Identity(n, n) - bound(rows, rows);
    gains.emplace_back(bend(rows).dot(left.ldlt().solve(bend(rows))), knot);
  }
  std::ranges::sort(gains, std::greater());
  std::vector<int> places;
  for (const auto& [gain, knot] : gains) {
    const auto near = [&, at = knot](int place) { return std::abs(place - at) < 2; };
    if (std::ranges::none_of(places, near)) places.push_back(knot);
    if (places.size() == kPlaces) break;
  }
  return places;
}

std::optional<EdgedFit> EdgeSearch::with_another(const EdgedFit& fit) {
  std::optional<EdgedFit> best;
  for (const int knot : likely_places(fit)) {
    EdgedFit tried = this->fit(with(fit.edges, knot), fit.trend, fit.lambda, kCoarseStep);
    if (!best || tried.evidence < best->evidence) best = std::move(tried);
  }
  if (!best || fit.trend == 0.0) return best;
  // An edge may have been what the trend was for.
  EdgedFit level = this->fit(best->edges, 0.0, fit.lambda, kCoarseStep);
  if (level.evidence < best->evidence) best = std::move(level);
  return best;
}

EdgedFit EdgeSearch::at(const EdgedFit& fit, std::size_t edge, double place) {
  std::vector<BasisEdge> edges = fit.edges;
  edges[edge] = {static_cast<int>(std::lround(place)), place};
  if (!has_room(edges)) return {};
  return this->fit(std::move(edges), fit.trend, fit.lambda, kFineStep);
}

EdgedFit EdgeSearch::moved(EdgedFit fit, std::size_t edge) {
  const double centre = fit.edges[edge].at;
  const auto keep_better = [&](EdgedFit tried) {
    const double evidence = tried.evidence;
    if (evidence < fit.evidence) fit = std::move(tried);
    return evidence;
  };
  const EdgedFit start = fit;
  for (int i = -kPlacesOfCell; i <= kPlacesOfCell; ++i) {
    if (i != 0) keep_better(at(start, edge, centre + static_cast<double>(i) / kPlacesOfCell));
  }
  const double around = fit.edges[edge].at;
  std::uintmax_t iterations = kMostOfBrent;
  boost::math::tools::brent_find_minima(
      [&](double place) { return keep_better(at(start, edge, place)); },
      around - 1.0 / kPlacesOfCell, around + 1.0 / kPlacesOfCell, 20, iterations);
  return fit;
}

EdgedFit EdgeSearch::moved(EdgedFit fit) {
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = fit.evidence;
    for (std::size_t i = 0; i < fit.edges.size(); ++i) fit = moved(std::move(fit), i);
    if (before - fit.evidence < kWorthARound) break;
  }
  return fit;
}

// From how far the evidence falls on either side, at a distance where it does so by about 1.
double EdgeSearch::deviation(const EdgedFit& fit, std::size_t edge) {
  double sum = 0.0;
  int sides = 0;
  for (const double side : {-1.0, 1.0}) {
    double shorter = 0.0;
    double longer = 1.0;
    double distance = kFirstDistance;
    double variance = 0.0;
    for (int i = 0; i < kDistances; ++i) {
      const double fall =
          at(fit, edge, fit.edges[edge].at + side * distance).evidence - fit.evidence;
      if (fall > 0.0 && std::isfinite(fall)) variance = distance * distance / fall;
      if (fall > 0.5 && fall < 2.0) break;
      (fall < 1.0 ? shorter : longer) = distance;
      distance = shorter > 0.0 ? std::sqrt(shorter * longer) : 0.25 * distance;
    }
    if (variance > 0.0) ++sides;
    sum += variance;
  }
  return sides > 0 ? std::min(1.0, std::sqrt(sum / sides)) : 0.0;
}

EdgedFit EdgeSearch::thinned(EdgedFit fit) {
  for (std::size_t i = 0; i < fit.edges.size();) {
    std::vector<BasisEdge> others = fit.edges;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    EdgedFit without = this->fit(std::move(others), fit.trend, fit.lambda, kFineStep);
    if (without.evidence < fit.evidence + price_) {
      fit = std::move(without);
      i = 0;
    } else {
      ++i;
    }
  }
  return fit;
}

}  // namespace

void find_shape(const ScaledLevels& levels, double lambda, PassOptions& pass,
                InnerSolutions& inner) {
  EdgeSearch search(levels, pass, inner);
  EdgedFit accepted = search.bent(search.fit({}, 0.0, lambda, kFineStep));
  EdgedFit tried = accepted;
  while (tried.edges.size() < kMostEdges &&
         tried.edges.size() < accepted.edges.size() + kLookAhead) {
    std::optional<EdgedFit> another = search.with_another(tried);
    if (!another) break;
    EdgedFit better = search.bent(search.moved(std::move(*another)));
    if (!(better.evidence < tried.evidence)) break;
    tried = std::move(better);
    const auto more = static_cast<double>(tried.edges.size() - accepted.edges.size());
    if (accepted.evidence - tried.evidence >= more * search.price()) accepted = tried;
  }
  accepted = search.thinned(std::move(accepted));
  pass.edges = std::move(accepted.edges);
  pass.trend = accepted.trend;
}

std::vector<std::vector<BasisEdge>> edges_elsewhere(const ScaledLevels& levels, double lambda,
                                                    const PassOptions& pass, std::size_t count,
                                                    InnerSolutions& inner) {
  EdgeSearch search(levels, pass, inner);
  const EdgedFit fit = search.fit(pass.edges, pass.trend, lambda, kFineStep);
  std::vector<std::vector<BasisEdge>> all(count, pass.edges);
  const boost::math::normal standard;
  for (std::size_t e = 0; e < pass.edges.size(); ++e) {
    const double deviation = search.deviation(fit, e);
    for (std::size_t i = 0; i < count; ++i) {
      // The places of one edge are even; those of two edges are in another order each.
      const double row = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const double share = std::fmod(row + static_cast<double>(e * (i + 1)) * kEven, 1.0);
      const double place =
          pass.edges[e].at +
          deviation * boost::math::quantile(standard, std::clamp(share, 0.02, 0.98));
      all[i][e] = {static_cast<int>(std::lround(place)), place};
    }
  }
  std::erase_if(all, [&](const auto& edges) { return !search.has_room(edges); });
  return all;
}

}  // namespace microslip
