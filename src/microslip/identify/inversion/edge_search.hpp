// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/inversion/inversion_basis.hpp"

/// @file
/// Slip forces at which populations of sliders end abruptly. Internal: Eigen stays out of the
/// installed headers.

namespace microslip {

/// A model with edges and a trend at its likeliest weights.
struct EdgedFit {
  std::vector<BasisEdge> edges = {};
  double trend = 0.0;
  std::vector<double> weights = {};  ///< λ, and further weights of the model
  /// −2 log of the likelihood; infinite where there is none
  double evidence = std::numeric_limits<double>::infinity();
};

/// How a solution bends: y = Lx of the rows of its penalty, the share λLH⁻¹Lᵀ of the penalty
/// in it, and where the middle of each row is among the equally spaced knots.
struct SolutionBends {
  Eigen::VectorXd bend = {};
  Eigen::MatrixXd bound = {};
  Eigen::VectorXd middles = {};
};

/// A linear model with one density whose edges are sought.
class EdgedModel {
 public:
  virtual ~EdgedModel() = default;

  /// The likeliest weights.
  /// @param edges   with room for each.
  /// @param trend   trend of the smoothness.
  /// @param start   a fit whose weights are near.
  /// @param coarse  whether the likeliest may be far from them.
  [[nodiscard]] virtual EdgedFit fit(std::vector<BasisEdge> edges, double trend,
                                     const EdgedFit& start, bool coarse) = 0;

  /// The bends of the solution of a fit.
  [[nodiscard]] virtual SolutionBends bends(const EdgedFit& fit) = 0;
};

/// The basis of the density, and the extent of the search.
struct EdgeSearchOptions {
  InversionBasis uniform;     ///< without edges
  Eigen::VectorXd amplitude;  ///< of the levels, scaled as the basis is
  int coefficients = 0;       ///< of `uniform`
  /// So many edges together may be needed before one of them is significant.
  std::size_t look_ahead = 3;
  bool trend = true;  ///< whether the smoothness may change along the density
  /// Fewest levels in a range between edges: what they show must be more than its straight line.
  Eigen::Index least_levels = 3;
};

/// Search of edges and of a trend: how the smoothness of a density changes along it.
///
/// Each edge needs "very strong" evidence: −2 log of the likelihood falls by 10 [Kass & Raftery,
/// J. Am. Stat. Assoc. 90 (1995) 773] and by the price of having looked at n places for it, 2 ln n,
/// or more, on average over edges that are significant only together, as the two ends of a narrow
/// population may. They are sought one by one among the knots, each then moved between them to
/// where it is likeliest, and those that the others make redundant are removed. The trend is the
/// likeliest, with a prior deviation of 3.
class EdgeSearch {
 public:
  /// Steps of λ while places are compared, and while one is moved.
  static constexpr double kCoarseStep = 10.0;
  static constexpr double kFineStep = 2.0;
  static constexpr double kTrendDeviation = 3.0;  ///< prior deviation of the trend

  /// @param model  must outlive this.
  EdgeSearch(EdgedModel& model, EdgeSearchOptions options);

  /// All edges that are worth their price. @param start  a fit whose weights are near.
  [[nodiscard]] EdgedFit find(const EdgedFit& start);

  /// The fit with each edge where it is likeliest, and without those that are not worth their
  /// price.
  [[nodiscard]] EdgedFit renewed(EdgedFit fit);

  /// Standard deviation of the place of each edge, in spacings: −2 log of the likelihood rises by 1
  /// there.
  [[nodiscard]] std::vector<double> deviations(const EdgedFit& fit);

  /// Other places of all edges together, each as likely as another to the extent that the
  /// likelihood of each place falls as that of a normal distribution.
  /// @param fit         with edges.
  /// @param deviations  of their places.
  /// @param count       of places; fewer where there is no room.
  [[nodiscard]] std::vector<std::vector<BasisEdge>> elsewhere(const EdgedFit& fit,
                                                              const std::vector<double>& deviations,
                                                              std::size_t count) const;

 private:
  [[nodiscard]] bool has_room(const std::vector<BasisEdge>& edges) const;
  [[nodiscard]] EdgedFit bent(EdgedFit fit);
  [[nodiscard]] std::optional<EdgedFit> with_another(const EdgedFit& fit);
  [[nodiscard]] EdgedFit moved(EdgedFit fit);
  [[nodiscard]] EdgedFit moved(EdgedFit fit, std::size_t edge);
  [[nodiscard]] EdgedFit at(const EdgedFit& fit, std::size_t edge, double place);
  [[nodiscard]] EdgedFit thinned(EdgedFit fit);
  [[nodiscard]] std::vector<int> likely_places(const EdgedFit& fit);
  [[nodiscard]] double deviation(const EdgedFit& fit, std::size_t edge);

  EdgedModel& model_;
  EdgeSearchOptions options_;
  double price_;
};

}  // namespace microslip
