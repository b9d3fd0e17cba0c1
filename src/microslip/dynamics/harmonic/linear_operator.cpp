// SPDX-License-Identifier: MIT
#include <cmath>

#include "microslip/algebra/lu.hpp"
#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/dynamics/harmonic/held_modes.hpp"
#include "microslip/dynamics/harmonic/structure_operator.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// a b, without a look at what is not finite.
Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// 1/a of what is far from the smallest and the largest number.
Complex reciprocal(Complex a) { return std::conj(a) / std::norm(a); }

void put(VectorXd& vector, Index at, Complex z) {
  vector[at] = z.real();
  vector[at + 1] = z.imag();
}

/// Without shortening all is linear, and harmonic n apart from the others. With the displacement
/// v = u − cN of the modes alone, a spring κ that they contain is taken out by the load s = N + κv:
///
///     v_j = Σ_l H_jl(nω) s_l + A E_j,     H = ψᵀK⁻¹ψ,   E = ψᵀK⁻¹L,   K = diag(Z_i)
///
/// For the mean κ also includes the stuck stiffness of the joint, with a spring of that stiffness
/// added to the modes: a body restrained only by its joints then has a receptance too. A body
/// restrained by nothing has no mean motion. The same is done, with a complex spring, for a
/// harmonic at which some Z_i nearly vanishes against the stiffness of the joints in the mode: H
/// would be infinite at the pole of an undamped mode, at which the joints move as everywhere.
class LinearOperator final : public StructureOperator {
 public:
  LinearOperator(const JointedStructure& structure, std::string_view response_point,
                 std::size_t harmonics, Forcing forcing)
      : m_(structure, response_point, harmonics, forcing),
        stuck_(m_.joints),
        motion_(m_.modes, static_cast<Index>(harmonics) + 1),
        load_(m_.joints),
        held_load_(m_.modes),
        passages_(harmonics + 1) {
    for (Index j = 0; j < m_.joints; ++j) {
      stuck_[j] = structure.joints()[static_cast<std::size_t>(j)].joint.stiffness();
    }
    held_ = (m_.shapes.cwiseAbs2() * stuck_).cwiseAbs();
    static_spring_ = m_.spring_in_modes + stuck_;
    VectorXd stiffness(m_.modes);
    for (Index i = 0; i < m_.modes; ++i) stiffness[i] = m_.stiffness(i, 0, 0.0, 0.0).real();
    MatrixXd loads(m_.modes, m_.joints + 1);
    loads << m_.shapes, m_.static_load;
    const MatrixXd displaced = held_displacements(stiffness, m_.shapes, stuck_, loads);
    static_modal_ = displaced.leftCols(m_.joints);
    static_receptance_ = m_.shapes.transpose() * static_modal_;
    resting_modal_ = displaced.col(m_.joints);
    resting_joints_ = m_.shapes.transpose() * resting_modal_;
  }

  void evaluate(const Input& input, Values& values) override {
    values.residual.resize(m_.joints * coefficient_count(m_.harmonics));
    for (Passage& passage : passages_) passage.ready = false;
    evaluate_mean(input, values);
    for (std::size_t h = 1; h <= m_.harmonics; ++h) {
      if (input.odd_wave && h % 2 == 0) {
        motion_.col(static_cast<Index>(h)).setZero();
        for (Index j = 0; j < m_.joints; ++j) put(values.residual, at(j, h), 0.0);
      } else {
        evaluate_harmonic(h, input, values);
      }
    }
    values.response = 0.0;
    for (Index i = 0; i < m_.modes; ++i) values.response += m_.response_shape[i] * motion_(i, 1);
  }

  void differentiate(const Input& input, Derivatives& output) override {
    const Index n = m_.joints * coefficient_count(m_.harmonics);
    output.by_frequency.setZero(n);
    output.by_force.setZero(n);
    output.response_by_displacement.setZero(n);
    output.response_by_tension.setZero(n);
    odd_wave_ = input.odd_wave;
    couple(passages_[0], static_receptance_, MatrixXd::Zero(m_.joints, m_.joints),
           static_spring_.cast<Complex>());
    for (std::size_t h = 1; h <= m_.harmonics; h += odd_wave_ ? 2 : 1) harmonic(h, input, output);
  }

  // The structure couples joints and not harmonics, a joint couples harmonics and not joints: a
  // column is that of a tangent, its harmonics each through the receptances of the joint.
  [[nodiscard]] MatrixXd by_motion(const std::vector<MatrixXd>& tangents) const override {
    const std::vector<Index> kept =
        coefficients_of(odd_wave_ ? Wave::kOdd : Wave::kAny, m_.harmonics);
    const auto block = static_cast<Index>(kept.size());
    MatrixXd result(m_.joints * block, m_.joints * block);
    for (Index l = 0; l < m_.joints; ++l) {
      for (Index c = 0; c < block; ++c) {
        const Index i = kept[static_cast<std::size_t>(c)];
        double* column = result.col(l * block + c).data();
        pass(l, tangents[static_cast<std::size_t>(l)].row(i), kept, column);
        for (Index j = 0; j < m_.joints; ++j) add_own(j, l, i, column + j * block + c);
      }
    }
    return result;
  }

  [[nodiscard]] MatrixXcd modal() const override { return motion_; }

 private:
  [[nodiscard]] Index at(Index joint, std::size_t h) const {
    return joint * coefficient_count(m_.harmonics) + coefficient_index(h);
  }

  [[nodiscard]] Complex coefficient(const VectorXd& x, Index joint, std::size_t h) const {
    const Index i = at(joint, h);
    return h == 0 ? Complex(x[i]) : Complex(x[i], x[i + 1]);
  }

  /// The structure in one harmonic.
  struct Passage {
    bool ready = false;      ///< impedance and spring are those of the input
    bool near_pole = false;  ///< then K holds κ, and is factored
    VectorXcd inverse;       ///< 1/Z of each mode
    VectorXcd spring;        ///< κ
    Eigen::PartialPivLU<MatrixXcd> held_solver;
    MatrixXcd by_displacement;  ///< joints × joints, of the residual
    MatrixXcd by_tension;
  };

  /// s_l = N_l + κ_l (u_l − c_l N_l) in harmonic h.
  template <typename Springs>
  void take_load(std::size_t h, const Input& input, const Springs& spring) {
    for (Index l = 0; l < m_.joints; ++l) {
      load_[l] = coefficient(input.tension, l, h) + times(Complex(spring[l]), own(input, l, h));
    }
  }

  /// u_j − c_j N_j in harmonic h: the displacement by the modes.
  [[nodiscard]] Complex own(const Input& input, Index j, std::size_t h) const {
    return coefficient(input.displacement, j, h) -
           m_.compliance[j] * coefficient(input.tension, j, h);
  }

  void evaluate_mean(const Input& input, Values& values) {
    take_load(0, input, static_spring_);
    const VectorXd load = load_.real();
    motion_.col(0) = (static_modal_ * load + resting_modal_).cast<Complex>();
    for (Index j = 0; j < m_.joints; ++j) {
      values.residual[at(j, 0)] =
          own(input, j, 0).real() - resting_joints_[j] - static_receptance_.row(j).dot(load);
    }
  }

  void evaluate_harmonic(std::size_t h, const Input& input, Values& values) {
    const auto column = static_cast<Index>(h);
    prepare(h, input);
    const Passage& passage = passages_[h];
    take_load(h, input, passage.spring);
    held_load_ = input.force * m_.load.col(column);
    for (Index l = 0; l < m_.joints; ++l) {
      for (Index i = 0; i < m_.modes; ++i) held_load_[i] += m_.shapes(i, l) * load_[l];
    }
    for (Index i = 0; i < m_.modes; ++i) {
      motion_(i, column) = times(passage.inverse[i], held_load_[i]);
    }
    if (passage.near_pole) motion_.col(column) = passage.held_solver.solve(held_load_);
    for (Index j = 0; j < m_.joints; ++j) {
      Complex made = 0.0;
      for (Index i = 0; i < m_.modes; ++i) made += m_.shapes(i, j) * motion_(i, column);
      put(values.residual, at(j, h), own(input, j, h) - made);
    }
  }

  /// How the joints feel each other in a harmonic, by real and imaginary receptances.
  void couple(Passage& passage, const MatrixXd& real, const MatrixXd& imaginary,
              const VectorXcd& spring) const {
    passage.by_displacement.resize(m_.joints, m_.joints);
    passage.by_tension.resize(m_.joints, m_.joints);
    for (Index l = 0; l < m_.joints; ++l) {
      const Complex passed = 1.0 - spring[l] * m_.compliance[l];
      for (Index j = 0; j < m_.joints; ++j) {
        const Complex receptance(real(j, l), imaginary(j, l));
        passage.by_displacement(j, l) = (j == l ? 1.0 : 0.0) - times(receptance, spring[l]);
        passage.by_tension(j, l) = -times(receptance, passed) - (j == l ? m_.compliance[l] : 0.0);
      }
    }
  }

  /// Effect of a tension of joint l with these harmonics on the kept coefficients of all joints.
  template <typename Row>
  void pass(Index l, const Row& tangent, const std::vector<Index>& kept, double* column) const {
    for (Index j = 0; j < m_.joints; ++j) {
      for (std::size_t r = 0; r < kept.size();) {
        const Index i = kept[r];
        const Complex g = passages_[harmonic_at(i)].by_tension(j, l);
        if (i == 0) {
          *column++ = -g.real() * tangent[0];
          ++r;
          continue;
        }
        const Complex made = times(g, {tangent[i], tangent[i + 1]});
        *column++ = -made.real();
        *column++ = -made.imag();
        r += 2;
      }
    }
  }

  /// Adds the displacement itself, coefficient i of joint l, in the rows of joint j.
  void add_own(Index j, Index l, Index i, double* row) const {
    const Complex made = passages_[harmonic_at(i)].by_displacement(j, l);
    *row += made.real();
    if (i == 0) return;
    if (is_real_part(i)) {
      row[1] += made.imag();
    } else {
      row[-1] -= made.imag();
    }
  }

  [[nodiscard]] static std::size_t harmonic_at(Index i) {
    return static_cast<std::size_t>((i + 1) / 2);
  }
  [[nodiscard]] static bool is_real_part(Index i) { return i == 0 || i % 2 == 1; }

  /// Takes K and κ of harmonic h, once for an input.
  void prepare(std::size_t h, const Input& input) {
    constexpr double kNearPole = 1e-6;
    Passage& passage = passages_[h];
    if (passage.ready) return;
    passage.ready = true;
    passage.inverse.resize(m_.modes);
    // Modal forcing makes a free vibration, at a pole of the modes where the joints hardly hold.
    passage.near_pole = m_.forcing == Forcing::kModal;
    for (Index i = 0; i < m_.modes; ++i) {
      const Complex impedance = m_.stiffness(i, h, input.angular_frequency, input.force);
      passage.near_pole = passage.near_pole || std::abs(impedance) < kNearPole * held_[i];
      passage.inverse[i] = reciprocal(impedance);
    }
    passage.spring = m_.spring_in_modes.cast<Complex>();
    if (passage.near_pole) hold(h, input);
  }

  /// With a complex spring in place of each joint.
  void hold(std::size_t h, const Input& input) {
    Passage& passage = passages_[h];
    const VectorXcd added = Complex(1.0, 1.0) * stuck_;
    passage.spring += added;
    MatrixXcd stiffness = m_.shapes * added.asDiagonal() * m_.shapes.transpose();
    for (Index i = 0; i < m_.modes; ++i) {
      stiffness(i, i) += m_.stiffness(i, h, input.angular_frequency, input.force);
    }
    passage.held_solver.compute(stiffness);
  }

  /// K⁻¹ψ, real and imaginary.
  void weigh(const Passage& passage) {
    if (passage.near_pole) {
      const MatrixXcd weighted = passage.held_solver.solve(m_.shapes.cast<Complex>());
      real_ = weighted.real();
      imaginary_ = weighted.imag();
      return;
    }
    real_.resize(m_.modes, m_.joints);
    imaginary_.resize(m_.modes, m_.joints);
    for (Index j = 0; j < m_.joints; ++j) {
      for (Index i = 0; i < m_.modes; ++i) {
        real_(i, j) = passage.inverse[i].real() * m_.shapes(i, j);
        imaginary_(i, j) = passage.inverse[i].imag() * m_.shapes(i, j);
      }
    }
  }

  void harmonic(std::size_t h, const Input& input, Derivatives& output) {
    const auto column = static_cast<Index>(h);
    prepare(h, input);
    Passage& passage = passages_[h];
    shift_.resize(m_.modes);
    unit_.resize(m_.modes);
    for (Index i = 0; i < m_.modes; ++i) {
      const Complex slope = m_.stiffness_slope(i, h, input.angular_frequency, input.force);
      shift_[i] = -times(slope, motion_(i, column));
      unit_[i] = m_.load_by_force(i, h, input.angular_frequency, motion_(i, column));
    }
    weigh(passage);
    for (Index j = 0; j < m_.joints; ++j) {
      Complex driven = 0.0;
      Complex shifted = 0.0;
      for (Index i = 0; i < m_.modes; ++i) {
        const Complex weighted(real_(i, j), imaginary_(i, j));
        driven += times(weighted, unit_[i]);
        shifted += times(weighted, shift_[i]);
      }
      const Index row = at(j, h);
      put(output.by_frequency, row, -shifted);
      put(output.by_force, row, -driven);
    }
    receptance_.noalias() = m_.shapes.transpose() * real_;
    receptance_loss_.noalias() = m_.shapes.transpose() * imaginary_;
    couple(passage, receptance_, receptance_loss_, passage.spring);
    if (h == 1) respond(output);
  }

  void respond(Derivatives& output) {
    const Passage& passage = passages_[1];
    VectorXcd point = passage.inverse.cwiseProduct(m_.response_shape);
    if (passage.near_pole) point = passage.held_solver.solve(m_.response_shape.cast<Complex>());
    output.response_by_force = (point.array() * unit_.array()).sum();
    output.response_by_frequency = (point.array() * shift_.array()).sum();
    for (Index l = 0; l < m_.joints; ++l) {
      const Complex transfer(real_.col(l).dot(m_.response_shape),
                             imaginary_.col(l).dot(m_.response_shape));
      const Complex by_displacement = transfer * passage.spring[l];
      const Complex by_tension = transfer * (1.0 - passage.spring[l] * m_.compliance[l]);
      const Index column = at(l, 1);
      const Complex i(0.0, 1.0);
      output.response_by_displacement[column] = by_displacement;
      output.response_by_displacement[column + 1] = i * by_displacement;
      output.response_by_tension[column] = by_tension;
      output.response_by_tension[column + 1] = i * by_tension;
    }
  }

  ModalMatrices m_;
  VectorXd stuck_;              // k of each joint
  VectorXd held_;               // Σ_j k_j ψ_ij²: their stiffness in mode i
  VectorXd static_spring_;      // κ of the mean
  MatrixXd static_modal_;       // K⁻¹ψ of the mean
  MatrixXd static_receptance_;  // ψᵀK⁻¹ψ of the mean
  VectorXd resting_modal_;      // K⁻¹p of the static loads
  VectorXd resting_joints_;     // ψᵀK⁻¹p
  MatrixXcd motion_;            // q
  VectorXcd load_;              // of the joints in the harmonic at hand, s
  VectorXcd held_load_;         // of the modes
  std::vector<Passage> passages_;
  bool odd_wave_ = false;  // where the derivatives were taken
  VectorXcd shift_;        // −Z_i′q_i, the load that acts as dω does
  VectorXcd unit_;         // the load of a unit of force
  MatrixXd real_;          // K⁻¹ψ, modes × joints
  MatrixXd imaginary_;
  MatrixXd receptance_;  // H, real
  MatrixXd receptance_loss_;
};

}  // namespace

std::unique_ptr<StructureOperator> make_linear_operator(const JointedStructure& structure,
                                                        std::string_view response_point,
                                                        std::size_t harmonics, Forcing forcing) {
  return std::make_unique<LinearOperator>(structure, response_point, harmonics, forcing);
}

}  // namespace microslip
