// SPDX-License-Identifier: MIT
#pragma once

#include "microslip/algebra/core.hpp"
#include "microslip/base/random.hpp"

/// @file
/// A smoothness that changes along the density. Internal: Eigen stays out of the installed headers.

namespace microslip {

/// Factors l_j of λ, one per row of the penalty: a density may bend sharply at one place and be
/// smooth at another, as a peak on a plain is. With nodes that are equally spaced along the rows,
///
///     ln l = Bw less its mean,   w ~ N(0, S²),
///
/// and B interpolates between the nodes. Ten nodes are as many as the details of a density that
/// levels or records resolve; with S = 3 one standard deviation changes λ by a factor of 20, and
/// the usual curvature by 4; 2 is enough where L has a trend already.
class LocalSmoothing {
 public:
  /// @param rows  of the penalty. @param deviation  S; 0: l = 1, and nothing is drawn.
  LocalSmoothing(Eigen::Index rows, double deviation);

  [[nodiscard]] bool varies() const { return nodes_.size() > 0; }
  [[nodiscard]] const Eigen::VectorXd& factors() const { return factors_; }  ///< l

  /// Another w of the prior, near this one or independent of it: reversible with respect to the
  /// prior.
  [[nodiscard]] LocalSmoothing proposed(RandomStream& random) const;

  /// A draw of w given λ‖·‖² of each row: of  Π √l_j exp(−½l_j s_j) · N(w; 0, S²)  by slices of
  /// ellipses, which have no step to choose [Murray, Adams & MacKay, AISTATS 2010].
  /// @param squares  s_j = λ(Lx)_j².
  void draw(const Eigen::VectorXd& squares, RandomStream& random);

 private:
  void set(const Eigen::VectorXd& nodes);
  [[nodiscard]] double log_likelihood(const Eigen::VectorXd& nodes,
                                      const Eigen::VectorXd& squares) const;

  double deviation_;
  Eigen::MatrixXd interpolation_;  // B, less its mean
  Eigen::VectorXd nodes_;          // w
  Eigen::VectorXd factors_;
};

}  // namespace microslip
