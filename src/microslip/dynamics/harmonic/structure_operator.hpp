// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/dynamics/harmonic/target.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// The linear operator of the structure at its joints: from the harmonics of the tensions N in them
/// to the displacement u of each joint. The modes are eliminated, so that the harmonic balance has
/// J(2H + 1) unknowns, whatever the number of modes. Internal to dynamics.
///
/// Vectors over the joints hold the coefficients (trigonometric_basis.hpp) of joint 0, then
/// joint 1, …
class StructureOperator {
 public:
  struct Input {
    const Eigen::VectorXd& displacement;  ///< u, m
    const Eigen::VectorXd& tension;       ///< N = −F(u), N
    double angular_frequency;             ///< ω, rad/s
    double force;                         ///< amplitude A, N; with modal forcing ξ, 1/s
    bool odd_wave;  ///< whether even harmonics of u, N and all that acts are 0 exactly
  };

  /// The residuals, and the response at the point.
  struct Values {
    Eigen::VectorXd residual;       ///< u minus what the structure makes of N, m
    std::complex<double> response;  ///< first harmonic of the displacement w_1, m
  };

  /// Their derivatives, except those of the residual by u and N.
  struct Derivatives {
    Eigen::VectorXd by_frequency;
    Eigen::VectorXd by_force;
    Eigen::RowVectorXcd response_by_displacement;
    Eigen::RowVectorXcd response_by_tension;
    std::complex<double> response_by_frequency;
    std::complex<double> response_by_force;
  };

  virtual ~StructureOperator() = default;
  StructureOperator(const StructureOperator&) = delete;
  StructureOperator& operator=(const StructureOperator&) = delete;

  virtual void evaluate(const Input& input, Values& values) = 0;

  /// At the input that was evaluated last.
  virtual void differentiate(const Input& input, Derivatives& derivatives) = 0;

  /// The derivatives of the residual by u, N following by ∂N/∂u = −∂F/∂u, where differentiate() was
  /// last. Of an odd wave without the rows and columns of even harmonics.
  /// @param tangents  ∂F/∂u of each joint, transposed.
  [[nodiscard]] virtual Eigen::MatrixXd by_motion(
      const std::vector<Eigen::MatrixXd>& tangents) const = 0;

  /// q_{i,n}, modes × (H + 1), kg^½ m; at the input that was evaluated last.
  [[nodiscard]] virtual Eigen::MatrixXcd modal() const = 0;

 protected:
  StructureOperator() = default;
};

/// The suitable kind: by receptances, or with the modes solved for where a joint has shortening.
[[nodiscard]] std::unique_ptr<StructureOperator> make_structure_operator(
    const JointedStructure& structure, std::string_view response_point, std::size_t harmonics,
    Forcing forcing);

[[nodiscard]] std::unique_ptr<StructureOperator> make_linear_operator(
    const JointedStructure& structure, std::string_view response_point, std::size_t harmonics,
    Forcing forcing);
[[nodiscard]] std::unique_ptr<StructureOperator> make_shortening_operator(
    const JointedStructure& structure, std::string_view response_point, std::size_t harmonics,
    Forcing forcing);

/// The matrices of a structure that both kinds need.
struct ModalMatrices {
  ModalMatrices(const JointedStructure& structure, std::string_view response_point,
                std::size_t harmonics, Forcing forcing);

  /// ω_i² − n²ω² + damping, and its derivative by ω; no damping of the mean. Modal forcing ξ is a
  /// negative damping, −i nω ξ.
  [[nodiscard]] std::complex<double> stiffness(Eigen::Index mode, std::size_t n,
                                               double angular_frequency, double force) const;
  [[nodiscard]] std::complex<double> stiffness_slope(Eigen::Index mode, std::size_t n,
                                                     double angular_frequency, double force) const;

  /// Load by a unit force on a mode that moves by q.
  [[nodiscard]] std::complex<double> load_by_force(Eigen::Index mode, std::size_t n,
                                                   double angular_frequency,
                                                   std::complex<double> q) const;

  Eigen::Index modes;
  Eigen::Index joints;
  std::size_t harmonics;   ///< H
  std::vector<Mode> mode;  ///< ω_i, η_i
  DampingLaw damping;
  Forcing forcing;
  Eigen::MatrixXd shapes;          ///< ψ, modes × joints
  Eigen::VectorXd response_shape;  ///< φ_i of the response point
  Eigen::MatrixXcd load;        ///< on mode i in harmonic n at A = 1 N, modes × (H + 1); modal: 0
  Eigen::VectorXd static_load;  ///< on mode i, whatever A
  Eigen::VectorXd spring_in_modes;  ///< k_s, one per joint
  Eigen::VectorXd compliance;       ///< c
};

}  // namespace microslip
