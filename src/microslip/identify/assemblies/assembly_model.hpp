// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/identify/inversion/inversion_model.hpp"
#include "microslip/observe/level_evidence.hpp"

/// @file
/// Levels of several assemblies as functions of one density and of the deviations of each assembly.
/// Internal: Eigen stays out of the installed headers.

namespace microslip {

/// Deviations of assemblies from their middle: one row per assembly, the columns of AssemblyModel.
using AssemblyDeviations = Eigen::MatrixXd;

/// Levels of one assembly over their σ: D; changes of k_eq; its mean.
struct AssemblyRows {
  Eigen::VectorXd dissipation;
  Eigen::VectorXd secant;     ///< less their weighted mean; empty where not measured
  Eigen::VectorXd stiffness;  ///< that mean; empty where k is not sought
};

/// Rows of the levels by coefficients: one column per coefficient.
struct AssemblyDesign {
  Eigen::MatrixXd dissipation;
  Eigen::MatrixXd secant;
  Eigen::MatrixXd stiffness;
};

/// Assembly j has, with the density p(s) of the middle in the scaled variables of InversionBasis,
/// kₘA_ref being the unit of slip forces,
///
///     k_j = κ_j kₘ,   p_j(s) = p(s/S_j)/S_j · exp(Φ(s/S_j)γ_j),
///     D = κ_j kₘA² t(κ_j A/(S_j A_ref)),  k_eq = κ_j kₘ(1 − soft(κ_j A/(S_j A_ref))),
///
/// t(a) = d(a)/a² and soft(a) those of p exp(Φγ_j). Columns of its deviations: ln κ where it is
/// sought, ln S, and γ. Φγ is smooth: of γ ~ N(0, 1) it is a Gaussian process of variance 1 and
/// correlation exp(−½(Δ/ℓ)²) over the place among the knots.
class AssemblyModel {
 public:
  /// ℓ, of the range of the knots: a shape may bend two or three times.
  static constexpr double kShapeLength = 0.35;

  /// @param levels         of each assembly; must outlive this.
  /// @param log_stiffness  ln κ of each where it is known; else its initial value.
  /// @param sought         whether κ is sought by k_eq, which all have then.
  /// @param common         the model of all levels together, with knots and scale.
  /// @param secant         whether k_eq counts.
  AssemblyModel(std::vector<const LevelEvidence*> levels, Eigen::VectorXd log_stiffness,
                bool sought, const InversionModel& common, bool secant);

  [[nodiscard]] Eigen::Index assemblies() const { return log_stiffness_.size(); }
  [[nodiscard]] Eigen::Index columns() const { return shape_column() + shapes_.cols(); }
  [[nodiscard]] bool stiffness_sought() const { return sought_; }
  [[nodiscard]] Eigen::Index force_column() const { return sought_ ? 1 : 0; }  ///< of ln S
  [[nodiscard]] Eigen::Index shape_column() const { return force_column() + 1; }
  [[nodiscard]] const Eigen::MatrixXd& shapes() const { return shapes_; }  ///< Φ at the knots
  [[nodiscard]] bool has_secant() const { return !softening_table_.empty(); }

  /// ln κ of an assembly.
  [[nodiscard]] double log_stiffness(const AssemblyDeviations& all, Eigen::Index j) const {
    return sought_ ? all(j, 0) : log_stiffness_(j);
  }

  /// p of the middle at the knots from coefficients.
  [[nodiscard]] Eigen::VectorXd middle(const Eigen::VectorXd& x) const { return nodal_ * x; }
  /// p exp(Φγ) of an assembly at the knots.
  [[nodiscard]] Eigen::VectorXd density(const Eigen::VectorXd& middle,
                                        const AssemblyDeviations& all, Eigen::Index j) const;
  /// Its area.
  [[nodiscard]] double area(const Eigen::VectorXd& density) const {
    return knot_area_.dot(density);
  }
  [[nodiscard]] const Eigen::VectorXd& knot_area() const { return knot_area_; }
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }

  /// Whether the deviations are admissible: area ≤ 1, levels within reach.
  [[nodiscard]] bool possible(const Eigen::VectorXd& middle, const AssemblyDeviations& all,
                              Eigen::Index j) const;

  /// Matrix of the rows of an assembly by coefficients, and the row of its area.
  [[nodiscard]] AssemblyDesign design(const AssemblyDeviations& all, Eigen::Index j) const;
  [[nodiscard]] Eigen::VectorXd area_row(const AssemblyDeviations& all, Eigen::Index j) const;

  /// Rows of an assembly as predicted from p of the middle, and as measured.
  [[nodiscard]] AssemblyRows predicted(const Eigen::VectorXd& middle, const AssemblyDeviations& all,
                                       Eigen::Index j) const;
  [[nodiscard]] const AssemblyRows& measured(Eigen::Index j) const {
    return data_[static_cast<std::size_t>(j)];
  }

  /// D of an assembly at any amplitudes, J, and at its levels k_eq, N/m.
  [[nodiscard]] Eigen::VectorXd dissipation(const Eigen::VectorXd& middle,
                                            const AssemblyDeviations& all, Eigen::Index j,
                                            const Eigen::VectorXd& amplitude) const;

  /// Sets σ of all rows from the prediction.
  void set_weights(const Eigen::VectorXd& middle, const AssemblyDeviations& all);

  /// 1/σ of the mean of k_eq of an assembly, of k_eq/kₘ; where κ is sought.
  [[nodiscard]] double stiffness_weight(Eigen::Index j) const {
    return weights_[static_cast<std::size_t>(j)].stiffness;
  }

  /// The least scatter of k_eq over its σ: given deviations may be an error common to neighbouring
  /// levels, which their scatter does not show.
  [[nodiscard]] double least_secant_scale() const;

  /// The number of independent data of D, the part of its squared residual from repeated levels,
  /// and the number of independent changes of k_eq.
  [[nodiscard]] double dissipation_count() const { return dissipation_count_; }
  [[nodiscard]] double repeat_square() const { return repeat_square_; }
  [[nodiscard]] double secant_count() const { return secant_count_; }

 private:
  /// Rows of p at the knots over ln a; interpolated, as S and κ move a.
  class Table {
   public:
    Table() = default;
    Table(const Eigen::VectorXd& amplitude, Eigen::MatrixXd rows);
    [[nodiscard]] bool empty() const { return rows_.size() == 0; }
    [[nodiscard]] bool reaches(double log_amplitude) const;
    [[nodiscard]] Eigen::MatrixXd at(const Eigen::VectorXd& log_amplitude) const;

   private:
    double first_ = 0.0;
    double step_ = 1.0;
    Eigen::MatrixXd rows_;  // knots × amplitudes
  };

  struct Weights {
    Eigen::VectorXd dissipation;  // 1/σ of D/(kₘA_ref²)
    Eigen::VectorXd secant;       // of k_eq/kₘ
    Eigen::VectorXd share;        // of each k_eq in their weighted mean
    double stiffness = 0.0;       // of that mean
  };

  void set_shapes(const Eigen::VectorXd& places);
  void set_tables(bool secant);
  void set_weights_of(Eigen::Index j, const Eigen::VectorXd& middle, const AssemblyDeviations& all);
  [[nodiscard]] Eigen::VectorXd log_scaled(const AssemblyDeviations& all, Eigen::Index j,
                                           const Eigen::VectorXd& log_amplitude) const;
  [[nodiscard]] Eigen::VectorXd shape_factor(const AssemblyDeviations& all, Eigen::Index j) const;
  /// Design by p at the knots; secant without the constant part.
  [[nodiscard]] AssemblyDesign knot_design(const AssemblyDeviations& all, Eigen::Index j) const;

  std::vector<const LevelEvidence*> levels_;
  Eigen::VectorXd log_stiffness_;
  bool sought_;
  double stiffness_;  // kₘ
  double length_;     // A_ref
  double energy_;     // kₘA_ref²
  std::vector<double> knots_;
  Eigen::VectorXd knot_area_;
  Eigen::MatrixXd nodal_;
  Eigen::MatrixXd shapes_;
  Table dissipation_table_;
  Table softening_table_;
  std::vector<Eigen::VectorXd> log_amplitude_;  // ln A/A_ref of the levels of each
  std::vector<Weights> weights_;
  std::vector<AssemblyRows> data_;
  double dissipation_count_ = 0.0;
  double repeat_square_ = 0.0;
  double secant_count_ = 0.0;
};

}  // namespace microslip
