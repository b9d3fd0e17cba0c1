// SPDX-License-Identifier: MIT

#include "microslip/algebra/lu.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/dynamics/harmonic/structure_operator.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// With shortening the modes feel the tensions twice: as a load and, by NΓq, as a stiffness that
/// varies over the cycle. Given N they are still the solution of a linear system over modes ×
/// harmonics, and the displacements follow from them. With C(·) the multiplication by a function of
/// time (its harmonics up to H kept) and Z_i that by the modal stiffness,
///
///     A q = A_f L + Σ_j ψ_j N_j,      A = diag(Z_i) − Σ_j k_s,j ψ_j ψ_jᵀ + Σ_j Γ^j C(N_j)
///     u_j = Σ_i ψ_ij q_i − ½ Σ_i C(g_i^j) q_i + c_j N_j,     g^j = Γ^j q
///
/// The derivative of u by N has the form BᵀA⁻¹B with B_ij = ψ_ij − C(g_i^j), as every receptance
/// has. Truncated in this way the equations come from one potential, as the exact ones do: the
/// energy balance of the harmonics kept is exact.
class ShorteningOperator final : public StructureOperator {
 public:
  ShorteningOperator(const JointedStructure& structure, std::string_view response_point,
                     std::size_t harmonics, Forcing forcing)
      : m_(structure, response_point, harmonics, forcing), count_(coefficient_count(harmonics)) {
    for (const StructuralJoint& joint : structure.joints()) {
      MatrixXd gamma = MatrixXd::Zero(m_.modes, m_.modes);
      if (!joint.shortening.empty()) {
        gamma = Eigen::Map<const MatrixXd>(joint.shortening.data(), m_.modes, m_.modes);
      }
      shortening_.push_back(std::move(gamma));
    }
    load_.setZero(m_.modes * count_);
    static_load_.setZero(m_.modes * count_);
    for (Index i = 0; i < m_.modes; ++i) {
      static_load_[i * count_] = m_.static_load[i];
      for (std::size_t h = 1; h <= m_.harmonics; ++h) {
        const std::complex<double> value = m_.load(i, static_cast<Index>(h));
        load_[i * count_ + coefficient_index(h)] = value.real();
        load_[i * count_ + coefficient_index(h) + 1] = value.imag();
      }
    }
  }

  void evaluate(const Input& input, Values& values) override {
    solve_modes(input);
    assemble_tangents();
    values.residual = input.displacement - displacements(input.tension);
    values.response = (response_row() * q_).value();
  }

  void differentiate(const Input& input, Derivatives& output) override {
    const Index n = m_.joints * count_;
    change_.resize(load_.size(), n + 2);
    right_.resize(load_.size(), n + 2);
    right_ << from_tension_, load_by_force(input), frequency_load(input);
    change_ = solver_.solve(right_);

    const MatrixXd made = to_displacement_ * change_;
    by_tension_ = -made.leftCols(n);
    for (Index j = 0; j < m_.joints; ++j) {
      by_tension_.diagonal().segment(j * count_, count_).array() -= m_.compliance[j];
    }
    output.by_force = -made.col(n);
    output.by_frequency = -made.col(n + 1);

    const Eigen::RowVectorXcd response = response_row() * change_;
    output.response_by_displacement.setZero(n);
    output.response_by_tension = response.head(n);
    output.response_by_force = response[n];
    output.response_by_frequency = response[n + 1];
  }

  [[nodiscard]] MatrixXd by_motion(const std::vector<MatrixXd>& tangents) const override {
    MatrixXd result = MatrixXd::Identity(by_tension_.rows(), by_tension_.cols());
    for (std::size_t j = 0; j < tangents.size(); ++j) {
      const Index first = static_cast<Index>(j) * count_;
      result.middleCols(first, count_).noalias() -=
          by_tension_.middleCols(first, count_) * tangents[j].transpose();
    }
    return result;
  }

  [[nodiscard]] MatrixXcd modal() const override {
    MatrixXcd q(m_.modes, static_cast<Index>(m_.harmonics) + 1);
    for (Index i = 0; i < m_.modes; ++i) {
      for (std::size_t h = 0; h <= m_.harmonics; ++h) {
        q(i, static_cast<Index>(h)) = harmonic_of(q_.segment(i * count_, count_), h);
      }
    }
    return q;
  }

 private:
  void solve_modes(const Input& input) {
    stiffness_.setZero(load_.size(), load_.size());
    for (Index i = 0; i < m_.modes; ++i) add_modal_stiffness(i, input);
    VectorXd right = input.force * load_ + static_load_;
    for (Index j = 0; j < m_.joints; ++j) {
      const auto tension = input.tension.segment(j * count_, count_);
      const MatrixXd product = multiplication_matrix(tension, m_.harmonics);
      const MatrixXd& gamma = shortening_[static_cast<std::size_t>(j)];
      for (Index i = 0; i < m_.modes; ++i) {
        right.segment(i * count_, count_) += m_.shapes(i, j) * tension;
        for (Index r = 0; r < m_.modes; ++r) {
          auto block = stiffness_.block(i * count_, r * count_, count_, count_);
          block += gamma(i, r) * product;
          block.diagonal().array() -= m_.spring_in_modes[j] * m_.shapes(i, j) * m_.shapes(r, j);
        }
      }
    }
    solver_.compute(stiffness_);
    q_ = solver_.solve(right);
  }

  void add_modal_stiffness(Index i, const Input& input) {
    const Index first = i * count_;
    stiffness_(first, first) += m_.stiffness(i, 0, 0.0, 0.0).real();
    for (std::size_t h = 1; h <= m_.harmonics; ++h) {
      const std::complex<double> z = m_.stiffness(i, h, input.angular_frequency, input.force);
      const Index at = first + coefficient_index(h);
      stiffness_(at, at) += z.real();
      stiffness_(at, at + 1) -= z.imag();
      stiffness_(at + 1, at) += z.imag();
      stiffness_(at + 1, at + 1) += z.real();
    }
  }

  /// B and, because C is self-adjoint only in the product of functions, its counterpart by rows.
  void assemble_tangents() {
    from_tension_.resize(load_.size(), m_.joints * count_);
    to_displacement_.resize(m_.joints * count_, load_.size());
    for (Index j = 0; j < m_.joints; ++j) {
      for (Index i = 0; i < m_.modes; ++i) {
        MatrixXd block = -multiplication_matrix(shortening_slope(i, j), m_.harmonics);
        block.diagonal().array() += m_.shapes(i, j);
        from_tension_.block(i * count_, j * count_, count_, count_) = block;
        to_displacement_.block(j * count_, i * count_, count_, count_) = block;
      }
    }
  }

  /// g_i = Σ_r Γ_ir q_r of joint j.
  [[nodiscard]] VectorXd shortening_slope(Index i, Index j) const {
    const Eigen::Map<const MatrixXd> q(q_.data(), count_, m_.modes);
    return q * shortening_[static_cast<std::size_t>(j)].row(i).transpose();
  }

  /// u. As B holds the whole of g and the displacement half of it, B q + ½ C(g) q.
  [[nodiscard]] VectorXd displacements(const VectorXd& tension) const {
    VectorXd u(m_.joints * count_);
    for (Index j = 0; j < m_.joints; ++j) {
      auto own = u.segment(j * count_, count_);
      own = m_.compliance[j] * tension.segment(j * count_, count_);
      for (Index i = 0; i < m_.modes; ++i) {
        const auto tangent = to_displacement_.block(j * count_, i * count_, count_, count_);
        const auto q = q_.segment(i * count_, count_);
        own += 0.5 * (tangent * q + m_.shapes(i, j) * q);
      }
    }
    return u;
  }

  /// The coefficients of a load that depends on the motion: a function of mode, harmonic, and q
  /// there.
  template <typename Load>
  [[nodiscard]] VectorXd load_of(const Load& load) const {
    VectorXd result = VectorXd::Zero(load_.size());
    for (Index i = 0; i < m_.modes; ++i) {
      for (std::size_t h = 1; h <= m_.harmonics; ++h) {
        const std::complex<double> value =
            load(i, h, harmonic_of(q_.segment(i * count_, count_), h));
        result[i * count_ + coefficient_index(h)] = value.real();
        result[i * count_ + coefficient_index(h) + 1] = value.imag();
      }
    }
    return result;
  }

  /// −(dZ/dω) q.
  [[nodiscard]] VectorXd frequency_load(const Input& input) const {
    return load_of([&](Index i, std::size_t h, std::complex<double> q) {
      return -m_.stiffness_slope(i, h, input.angular_frequency, input.force) * q;
    });
  }

  [[nodiscard]] VectorXd load_by_force(const Input& input) const {
    return load_of([&](Index i, std::size_t h, std::complex<double> q) {
      return m_.load_by_force(i, h, input.angular_frequency, q);
    });
  }

  [[nodiscard]] Eigen::RowVectorXcd response_row() const {
    Eigen::RowVectorXcd row = Eigen::RowVectorXcd::Zero(load_.size());
    for (Index i = 0; i < m_.modes; ++i) {
      row[i * count_ + 1] = m_.response_shape[i];
      row[i * count_ + 2] = std::complex<double>(0.0, m_.response_shape[i]);
    }
    return row;
  }

  ModalMatrices m_;
  Index count_;                       // 2H + 1
  std::vector<MatrixXd> shortening_;  // Γ of each joint
  VectorXd load_;                     // L
  VectorXd static_load_;              // in the mean alone
  MatrixXd stiffness_;                // A
  Eigen::PartialPivLU<MatrixXd> solver_;
  VectorXd q_;
  MatrixXd from_tension_;
  MatrixXd to_displacement_;
  MatrixXd right_;   // derivatives of the load by N, by A_f, by ω
  MatrixXd change_;  // of q by them
  MatrixXd by_tension_;
};

}  // namespace

std::unique_ptr<StructureOperator> make_shortening_operator(const JointedStructure& structure,
                                                            std::string_view response_point,
                                                            std::size_t harmonics,
                                                            Forcing forcing) {
  return std::make_unique<ShorteningOperator>(structure, response_point, harmonics, forcing);
}

}  // namespace microslip
