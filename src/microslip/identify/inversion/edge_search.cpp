// SPDX-License-Identifier: MIT
#include "microslip/identify/inversion/edge_search.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "microslip/algebra/cholesky.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostEdges = 8;
constexpr double kVeryStrong = 10.0;
/// Ridge on the share of the penalty, so that a knot without data is no division by 0.
constexpr double kPenaltyRidge = 1e-9;
/// The step and the range of the search of the trend.
constexpr double kTrendStep = 2.0;
constexpr double kMostTrend = 6.0;
constexpr double kMostTrendDuringSearch = 20.0;  ///< until all edges are found
/// Gain of the evidence required for a step of the trend, which is one more parameter.
constexpr double kTrendPrice = 2.0;
/// Knots that are tried for another edge.
constexpr std::size_t kPlaces = 6;
/// Places on either side of a knot, within one spacing; the minimum lies between two of them.
constexpr int kPlacesOfCell = 4;
constexpr std::uintmax_t kMostOfBrent = 8;
/// Distance from an edge at which its deviation is sought first, in spacings, and the number of
/// tries.
constexpr double kFirstDistance = 0.1;
constexpr int kDistances = 9;
/// Step of a sequence mod 1 that fills 0 to 1 evenly: the golden section.
constexpr double kEven = 0.6180339887498949;
/// Rounds in which all edges are moved, and the decrease of the evidence required for another.
constexpr int kMostRounds = 4;
constexpr double kWorthARound = 2.0;

std::vector<BasisEdge> with_edge(const std::vector<BasisEdge>& edges, int knot) {
  std::vector<BasisEdge> more = edges;
  const auto next = std::ranges::find_if(more, [&](const BasisEdge& e) { return e.knot > knot; });
  more.insert(next, BasisEdge{knot, static_cast<double>(knot)});
  return more;
}

}  // namespace

EdgeSearch::EdgeSearch(EdgedModel& model, EdgeSearchOptions options)
    : model_(model),
      options_(std::move(options)),
      price_(kVeryStrong + 2.0 * std::log(static_cast<double>(options_.coefficients))) {}

EdgedFit EdgeSearch::bent(EdgedFit fit) {
  if (!options_.trend) return fit;
  const double most = fit.edges.empty() ? kMostTrend : kMostTrendDuringSearch;
  for (const double step : {kTrendStep, -kTrendStep}) {
    while (std::abs(fit.trend + step) <= most) {
      EdgedFit tried = model_.fit(fit.edges, fit.trend + step, fit, false);
      if (!(tried.evidence < fit.evidence - kTrendPrice)) break;
      fit = std::move(tried);
    }
  }
  return fit;
}

bool EdgeSearch::has_room(const std::vector<BasisEdge>& edges) const {
  const auto below = [&](double at) {
    return (options_.amplitude.array() < options_.uniform.slip_force(at)).count();
  };
  int knot = 0;
  Eigen::Index levels = 0;
  const auto room_until = [&](int next_knot, Eigen::Index next_levels) {
    const bool room = next_knot - knot >= InversionBasis::kLeastBetween &&
                      next_levels - levels >= options_.least_levels;
    knot = next_knot;
    levels = next_levels;
    return room;
  };
  return std::ranges::all_of(edges,
                             [&](const BasisEdge& e) { return room_until(e.knot, below(e.at)); }) &&
         room_until(options_.coefficients - 1, options_.amplitude.size());
}

// The knots where the solution gains most from leaving out the penalty around them: by λyᵀ(I −
// λLH⁻¹Lᵀ)⁻¹y, y = Lx, L the rows that reach it.
std::vector<int> EdgeSearch::likely_places(const EdgedFit& fit) {
  const SolutionBends bends = model_.bends(fit);
  std::vector<std::pair<double, int>> gains;
  for (int knot = 1; knot + 1 < options_.coefficients; ++knot) {
    if (!has_room(with_edge(fit.edges, knot))) continue;
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < bends.middles.size(); ++i) {
      if (std::abs(bends.middles(i) - knot) < 1.5) rows.push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(rows.size());
    const Eigen::MatrixXd left =
        (1.0 + kPenaltyRidge) * Eigen::MatrixXd::Identity(n, n) - bends.bound(rows, rows);
    gains.emplace_back(bends.bend(rows).dot(left.ldlt().solve(bends.bend(rows))), knot);
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
    EdgedFit tried = model_.fit(with_edge(fit.edges, knot), fit.trend, fit, true);
    if (!best || tried.evidence < best->evidence) best = std::move(tried);
  }
  if (!best || fit.trend == 0.0) return best;
  // An edge may replace the trend.
  EdgedFit level = model_.fit(best->edges, 0.0, fit, true);
  if (level.evidence < best->evidence) best = std::move(level);
  return best;
}

EdgedFit EdgeSearch::at(const EdgedFit& fit, std::size_t edge, double place) {
  std::vector<BasisEdge> edges = fit.edges;
  edges[edge] = {static_cast<int>(std::lround(place)), place};
  if (!has_room(edges)) return {};
  return model_.fit(std::move(edges), fit.trend, fit, false);
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

// Computed from the change of the evidence on either side, at a distance where it is about 1.
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
    EdgedFit without = model_.fit(std::move(others), fit.trend, fit, false);
    if (without.evidence < fit.evidence + price_) {
      fit = std::move(without);
      i = 0;
    } else {
      ++i;
    }
  }
  return fit;
}

EdgedFit EdgeSearch::find(const EdgedFit& start) {
  EdgedFit accepted = bent(model_.fit({}, 0.0, start, false));
  EdgedFit tried = accepted;
  while (tried.edges.size() < kMostEdges &&
         tried.edges.size() < accepted.edges.size() + options_.look_ahead) {
    std::optional<EdgedFit> another = with_another(tried);
    if (!another) break;
    EdgedFit better = bent(moved(std::move(*another)));
    if (!(better.evidence < tried.evidence)) break;
    tried = std::move(better);
    const auto more = static_cast<double>(tried.edges.size() - accepted.edges.size());
    if (accepted.evidence - tried.evidence >= more * price_) accepted = tried;
  }
  return thinned(std::move(accepted));
}

EdgedFit EdgeSearch::renewed(EdgedFit fit) { return thinned(moved(std::move(fit))); }

std::vector<double> EdgeSearch::deviations(const EdgedFit& fit) {
  std::vector<double> all;
  for (std::size_t e = 0; e < fit.edges.size(); ++e) all.push_back(deviation(fit, e));
  return all;
}

std::vector<std::vector<BasisEdge>> EdgeSearch::elsewhere(const EdgedFit& fit,
                                                          const std::vector<double>& deviations,
                                                          std::size_t count) const {
  std::vector<std::vector<BasisEdge>> all(count, fit.edges);
  const boost::math::normal standard;
  for (std::size_t e = 0; e < fit.edges.size(); ++e) {
    for (std::size_t i = 0; i < count; ++i) {
      // The places of one edge are even; those of two edges are in another order each.
      const double row = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const double share = std::fmod(row + static_cast<double>(e * (i + 1)) * kEven, 1.0);
      const double place =
          fit.edges[e].at +
          deviations[e] * boost::math::quantile(standard, std::clamp(share, 0.02, 0.98));
      all[i][e] = {static_cast<int>(std::lround(place)), place};
    }
  }
  std::erase_if(all, [&](const auto& edges) { return !has_room(edges); });
  return all;
}

}  // namespace microslip
