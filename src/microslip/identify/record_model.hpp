// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "microslip/identify/inversion_basis.hpp"
#include "microslip/identify/smoothing_path.hpp"
#include "microslip/observe/record_evidence.hpp"

/// @file
/// Force–displacement records as one smoothing problem, in scaled variables: displacements over X,
/// the largest half range, stiffnesses over k₀, forces over k₀X. Internal: Eigen stays out of the
/// installed headers.

namespace microslip {

/// The records in the variables of the problem.
struct ScaledRecords {
  /// @param evidence  must outlive this; not empty, with rows. @param known  k, N/m, where known.
  ScaledRecords(std::span<const RecordEvidence> evidence, std::optional<double> known);

  std::span<const RecordEvidence> records;
  bool stiffness_known;
  double length;     ///< X, m
  double stiffness;  ///< k₀, N/m: k where it is known
  double lowest;     ///< smallest scaled slip displacement that the records resolve
};

/// What a pass is to assume.
struct RecordPass {
  double exponent = 0.0;  ///< χ₀
  int coefficients = 0;
  bool viscous = false;
  std::vector<double> scatter;      ///< s of one sample of each record, over k₀X
  std::vector<double> correlation;  ///< of neighbouring rows of each
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

  /// Makes p at the knots of the basis from coefficients.
  [[nodiscard]] Eigen::MatrixXd density_matrix() const;
  /// Make ∫p ds, K_e/k₀ and c/(k₀Δt) from coefficients. Where k is known K_e is what is left of it.
  [[nodiscard]] Eigen::VectorXd area_row() const;
  [[nodiscard]] Eigen::VectorXd elastic_row() const;
  [[nodiscard]] Eigen::VectorXd viscous_row() const;

  /// Further columns of the rows of a record as its rows enter the problem: offsets taken out,
  /// over their scatter.
  void weight(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const;

  /// Takes the offset of each group from columns of the rows of a record.
  void centre(std::size_t record, Eigen::Ref<Eigen::MatrixXd> columns) const;

  /// Force of each row of a record as found, over k₀X, without offset.
  [[nodiscard]] Eigen::VectorXd found(std::size_t record, const Eigen::VectorXd& x) const;
  /// What the force of each row of a record is more than found, over k₀X; offsets taken out.
  [[nodiscard]] Eigen::VectorXd residual(std::size_t record, const Eigen::VectorXd& x) const;
  /// Norm of the force of its rows, over k₀X; offsets taken out.
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
  };
  [[nodiscard]] Block block_of(const RecordEvidence& record) const;
  static void centre(const Block& block, Eigen::Ref<Eigen::MatrixXd> columns);
  static void whiten(const Block& block, double scatter, double correlation,
                     Eigen::Ref<Eigen::MatrixXd> columns);

  const ScaledRecords* records_;
  RecordPass pass_;
  InversionBasis basis_;
  double theta_scale_ = 1.0;
  double viscous_scale_ = 1.0;
  std::vector<Block> blocks_;
  std::optional<SmoothingProblem> problem_;
};

}  // namespace microslip
