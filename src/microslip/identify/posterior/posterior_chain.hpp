// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/random.hpp"
#include "microslip/identify/posterior/truncated_gaussian.hpp"
#include "microslip/identify/smoothing/local_smoothing.hpp"
#include "microslip/identify/smoothing/quadratic_program.hpp"

/// @file
/// Draws from the posterior of data and prior. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// Rows of one kind, with a scatter of their own.
struct ChainRows {
  Eigen::MatrixXd design =
      {};  ///< D, rows × coefficients; an equivalent smaller set of rows will do
  Eigen::VectorXd data = {};   ///< d
  Eigen::VectorXd shift = {};  ///< w: with an error δ the data are d + δw; empty for none
  double more_square = 0.0;    ///< the part of the squared residual that does not depend on x
  double count = 0.0;          ///< m, of independent data: rows as measured, and repeats
  double least_scale = 0.0;    ///< of τ; 0 where it is free
  double most_scale = std::numeric_limits<double>::infinity();  ///< of τ
  bool scale_known = false;  ///< τ keeps its initial value: the rows are prior knowledge
};

/// Rows of L with a λ and local factors of their own: those of one density among several.
struct ChainBlock {
  Eigen::Index rows = 0;  ///< number of rows
  double least_lambda = 0.0;
  double most_lambda = 0.0;
};

/// The distribution that is drawn from: with coefficients x, a scale τ_g of the scatter of each
/// kind of rows, the smoothing λ and its local factors l,
///
///     p ∝ Π_g τ_g^−(m_g + 2) exp(−(‖D_g x − d_g‖² + more_g)/2τ_g²)
///         · λ^(r/2 − 1) Π_j √l_j exp(−½λ l_j (Lx)_j²) · p(l)
///
/// within limits: the priors of ln λ and ln τ are flat. λ stays between two ends: where a
/// density as smooth as can be is possible, so is any λ above. Where the two are equal, l is 1
/// too. With blocks the second line is a product of those of each.
struct ChainTarget {
  std::vector<ChainRows> rows;
  Eigen::MatrixXd penalty;  ///< L, r × coefficients
  LinearLimits limits;
  double least_lambda = 0.0;
  double most_lambda = 0.0;
  /// The blocks of all rows of L, from above; empty: one block between the two ends.
  std::vector<ChainBlock> blocks = {};
  double local_deviation = 3.0;  ///< of LocalSmoothing
};

/// Start of a chain: a good solution.
struct ChainStart {
  Eigen::VectorXd x;
  double lambda = 0.0;        ///< of every block
  std::vector<double> scale;  ///< τ of each kind of rows
};

/// A Markov chain of that distribution. x given all else by TruncatedGaussian; λ and l once with x
/// moved along, at the same place of the distribution given them, and once given x, λ from its
/// Gamma distribution and l by LocalSmoothing; τ from its scaled inverse χ² distribution.
///
/// Coefficients that data press against their limit far more tightly than the prior are reflected
/// thousands of times on one trajectory. Near those a normal number a_j ~ N(x_j, w_j²) is drawn
/// first, and x given a: the distribution of x is unchanged, for any w, and the trajectory is kept
/// near a.
class PosteriorChain {
 public:
  /// @param target  must outlive this. @param start  may lie on limits.
  PosteriorChain(const ChainTarget& target, ChainStart start);

  /// Steps until the start is forgotten, during which w is found.
  void settle(RandomStream& random);

  /// Reads rows and limits of the target again after a change, as by a step of another chain that
  /// moves the quantities they depend on. The last draw is within the new limits.
  void renew();

  /// Sets the error of the data in the draws to come: δ of the shifts of all rows. Data do not
  /// correct it.
  void set_error(double error);

  /// The next draw, some steps on; correlated with the one before it.
  const Eigen::VectorXd& next(RandomStream& random);

  /// Another x for the λ, l and τ of the last draw: one of the Gaussian without limits, brought
  /// within them,
  ///
  ///     x = argmin (y − z)ᵀH(y − z)  over y within the limits,   z ~ N(H⁻¹g, H⁻¹),
  ///
  /// independent of all others [Lin & Dunson, Biometrika 101 (2014) 303; Astfalck et al., arXiv
  /// 1812.05741]. next() hardly ever comes near limits that many coefficients have in common: where
  /// all are 0 in truth, their sum is above it in every draw. Here those that may be 0 are 0 as
  /// often as noise puts them below.
  /// @return  x, and whether it is the minimiser.
  [[nodiscard]] QuadraticProgram::Solution projected(RandomStream& random) const;

  /// Coefficients of the last draw.
  [[nodiscard]] const Eigen::VectorXd& coefficients() const { return x_; }
  /// λ of the last draw. @param block  of the penalty.
  [[nodiscard]] double lambda(std::size_t block = 0) const { return smoothing_[block].lambda; }
  /// τ of the last draw. @param kind  of the rows.
  [[nodiscard]] double scale(std::size_t kind = 0) const { return scale_[kind]; }

 private:
  void read_rows();
  void step(RandomStream& random, int most_reflections);
  void gather_data(RandomStream& random);
  void add_data(Eigen::MatrixXd& hessian, Eigen::VectorXd& linear) const;
  /// λ and l of a block, with its roughness.
  struct Smoothing {
    Eigen::Index begin;  // of its rows of L
    ChainBlock block;
    double lambda;
    LocalSmoothing local;
    Eigen::MatrixXd roughness;  // Lᵀ diag(l) L
  };

  [[nodiscard]] bool moves_along(double log_ratio, RandomStream& random);
  void move_with_lambda(Smoothing& smoothing, RandomStream& random);
  void move_with_local(Smoothing& smoothing, RandomStream& random);
  [[nodiscard]] Eigen::MatrixXd roughness(const Smoothing& smoothing,
                                          const LocalSmoothing& local) const;
  [[nodiscard]] Eigen::VectorXd bends(const Smoothing& smoothing) const;
  [[nodiscard]] Eigen::MatrixXd whole_hessian() const;
  [[nodiscard]] Eigen::MatrixXd hessian_with(const Smoothing& own, double lambda,
                                             const Eigen::MatrixXd& roughness) const;
  void draw_lambda(Smoothing& smoothing, RandomStream& random);
  void draw_scales(RandomStream& random);
  void draw_local(Smoothing& smoothing, RandomStream& random);
  void hold_near();

  const ChainTarget& target_;
  std::vector<Eigen::MatrixXd> information_;          // DᵀD of each kind
  std::vector<Eigen::VectorXd> data_;                 // d + δw
  std::vector<Eigen::VectorXd> projected_;            // Dᵀ of that
  std::vector<std::vector<Eigen::Index>> penalised_;  // columns of each row of L
  Eigen::MatrixXd hessian_;                           // of all but the smoothing
  Eigen::VectorXd linear_;
  Eigen::VectorXd nearness_;  // 1/w²
  std::vector<Smoothing> smoothing_;
  std::vector<double> scale_;
  Eigen::VectorXd x_;
  TruncatedGaussian gaussian_;  // x given all else
  TruncatedGaussian moved_;     // the same with another λ or l
  std::vector<int> reflections_;
};

}  // namespace microslip
