// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/evidence/joint_evidence.hpp"
#include "microslip/identify/inversion/inversion_basis.hpp"
#include "microslip/identify/smoothing/smoothing_path.hpp"
#include "microslip/observe/record_evidence.hpp"

/// @file
/// Force–displacement records and levels as one smoothing problem, in scaled variables:
/// displacements over X, the largest half range or amplitude, stiffnesses over k₀, forces over k₀X.
/// Internal: Eigen stays out of the installed headers.

namespace microslip {

/// The evidence in the variables of the problem, and the parts that no pass changes.
struct ScaledRecords {
  /// @param evidence      must outlive this; records with rows, and levels: not both empty.
  /// @param known         k, N/m; needed without records.
  /// @param coefficients  of the density.
  ScaledRecords(const JointEvidence& evidence, std::optional<double> known, int coefficients);

  /// The same with a density that ends at another slip displacement. @param end  over X.
  [[nodiscard]] ScaledRecords up_to(double end) const;

  /// The same with the knots of the density at other places, see InversionBasis.
  [[nodiscard]] ScaledRecords with_knots(std::vector<double> at) const;

  /// The basis of the density. @param exponent  χ₀ of the prior.
  [[nodiscard]] InversionBasis basis(double exponent) const;

  std::span<const RecordEvidence> records;
  std::span<const LevelEvidence> levels;
  int coefficients;
  bool stiffness_known;
  double length;               ///< X, m
  double stiffness;            ///< k₀, N/m: k where it is known
  double finest;               ///< scaled slip displacement below which all is noise
  double top = 1.0;            ///< where the density ends, scaled
  double lowest;               ///< smallest scaled slip displacement at which it is sought
  std::vector<double> places;  ///< of the knots among equally spaced ones

  // Of p at the knots, which are those of all exponents.
  std::vector<Eigen::MatrixXd> stop;         ///< force of the rows of each record
  std::vector<Eigen::MatrixXd> dissipation;  ///< d of each table of levels
  std::vector<Eigen::MatrixXd> softening;    ///< of those with k_eq, else without rows

  /// k₀X², J.
  [[nodiscard]] double energy() const { return stiffness * length * length; }

 private:
  void set_range();
  void set_rows();
};

/// Assumptions of a pass on a table of levels.
struct LevelPass {
  LevelScatter scatter;
  std::vector<double> dissipation;  ///< of an earlier fit, from which σ is computed, J
};

/// Assumptions of a pass.
struct RecordPass {
  double exponent = 0.0;  ///< χ₀
  bool viscous = false;
  std::vector<double> scatter;      ///< s of one sample of each record, over k₀X
  std::vector<double> correlation;  ///< of neighbouring rows of each
  /// Deviation of the force of each row of each record by the noise of the path, over k₀X, for one
  /// sample: that times the slope of the loop. Empty: none.
  std::vector<Eigen::VectorXd> by_path;
  /// That by the error of the turn behind the row, which its whole branch shares, over k₀X: times
  /// the slope of the loop less that at the end of the branch. Empty: none.
  std::vector<Eigen::VectorXd> by_turn;
  /// Rows of which one is worth as much as of independent ones, where they are weighed as such
  /// though neighbours are alike; ≥ 1.
  double alike_rows = 1.0;
  std::vector<LevelPass> levels;  ///< of each table
};

/// A linear model of the records with its coefficients, and how to read them.
class RecordModel {
 public:
  RecordModel(const ScaledRecords& records, const RecordPass& pass);

  [[nodiscard]] const SmoothingProblem& problem() const { return *problem_; }
  [[nodiscard]] const InversionBasis& basis() const { return basis_; }

  /// θ of coefficients, at the scale of 1.
  [[nodiscard]] Eigen::VectorXd theta(const Eigen::VectorXd& x) const {
    return x.head(basis_.size());
  }

  /// The matrix that gives p at the knots of the basis from coefficients.
  [[nodiscard]] Eigen::MatrixXd density_matrix() const;
  /// The rows that give ∫p ds, K_e/k₀ and c/(k₀Δt) from coefficients. Where k is known K_e
  /// is the remainder of it.
  [[nodiscard]] Eigen::VectorXd area_row() const;
  [[nodiscard]] Eigen::VectorXd elastic_row() const;
  [[nodiscard]] Eigen::VectorXd viscous_row() const;

  /// Weights further columns of the rows of a record as its rows enter the problem: offsets
  /// subtracted, over their scatter.
  void weight(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const;

  /// Subtracts the offset of each group from columns of the rows of a record.
  void centre(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const;

  /// D, J, and where it was measured k_eq, N/m, of the levels of a table from coefficients.
  [[nodiscard]] LevelRows levels_of(std::size_t table, const Eigen::VectorXd& x) const;
  /// Measured minus fitted levels of a table, over their σ: D, followed by k_eq.
  [[nodiscard]] Eigen::VectorXd level_residual(std::size_t table, const Eigen::VectorXd& x) const;
  /// σ of the rows of a table, J and N/m.
  [[nodiscard]] const LevelRows& level_deviations(std::size_t table) const {
    return levels_[table].deviation;
  }
  /// The first of the rows of a table in the problem.
  [[nodiscard]] Eigen::Index first_row(std::size_t table) const { return levels_[table].first; }

  /// Matrices that give d and k_eq/k₀ of any levels from coefficients.
  /// @param dissipation, softening  of p at the knots of the basis.
  [[nodiscard]] Eigen::MatrixXd dissipation_matrix(const Eigen::MatrixXd& dissipation) const;
  [[nodiscard]] Eigen::MatrixXd secant_matrix(const Eigen::MatrixXd& softening) const;
  /// The part of k_eq/k₀ that does not depend on the coefficients: 1 where k is known.
  [[nodiscard]] double secant_given() const { return records_->stiffness_known ? 1.0 : 0.0; }

  /// Fitted force of each row of a record, over k₀X, without offset.
  [[nodiscard]] Eigen::VectorXd found(std::size_t record, const Eigen::VectorXd& x) const;
  /// Measured minus fitted force of each row of a record, over k₀X; offsets subtracted.
  [[nodiscard]] Eigen::VectorXd residual(std::size_t record, const Eigen::VectorXd& x) const;
  /// Slope dF/du of the fitted force at each row of a record, over k₀.
  [[nodiscard]] Eigen::VectorXd slope(std::size_t record, const Eigen::VectorXd& x) const;
  /// Norm of the force of its rows, over k₀X; offsets subtracted.
  [[nodiscard]] double force_norm(std::size_t record) const;
  /// F₀ of each group of a record, over k₀X.
  [[nodiscard]] Eigen::VectorXd offsets(std::size_t record, const Eigen::VectorXd& x) const;

 private:
  struct Block {
    Eigen::MatrixXd design;                 // rows × coefficients, neither centred nor weighted
    Eigen::VectorXd data;                   // less k u where k is known
    Eigen::VectorXd force;                  // as measured
    Eigen::VectorXd count;                  // of samples of each row
    std::vector<Eigen::Index> group_begin;  // and the end of the last
    std::vector<Eigen::Index> branch_begin;
  };
  struct LevelBlock {
    Eigen::MatrixXd design;  // D, then k_eq: rows × coefficients, neither centred nor weighted
    Eigen::VectorXd data;    // minus the part that does not depend on the coefficients
    Eigen::VectorXd weight;
    LevelRows deviation;
    Eigen::Index first = 0;  // row in the problem
  };
  [[nodiscard]] Block block_of(std::size_t record) const;
  [[nodiscard]] LevelBlock level_block(std::size_t table) const;
  void add_blocks();
  void set_problem();
  static void centre(const Block& block, Eigen::Ref<Eigen::MatrixXd> columns);
  void whiten(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const;
  void set_independent(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const;

  const ScaledRecords* records_;
  RecordPass pass_;
  InversionBasis basis_;
  double theta_scale_ = 1.0;
  double viscous_scale_ = 1.0;
  Eigen::Index columns_;
  std::vector<Block> blocks_;
  std::vector<LevelBlock> levels_;
  std::optional<SmoothingProblem> problem_;
};

}  // namespace microslip
