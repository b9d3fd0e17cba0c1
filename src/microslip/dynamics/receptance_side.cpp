// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "microslip/dynamics/structure_side.hpp"
#include "microslip/dynamics/trigonometric_basis.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

void put(VectorXd& vector, Index at, Complex z) {
  vector[at] = z.real();
  vector[at + 1] = z.imag();
}

/// Without shortening all is linear, and harmonic n apart from the others. With the displacement
/// v = u − cN of the modes alone, a spring κ that they contain is taken out by the load s = N + κv:
///
///     v_j = Σ_l H_jl(nω) s_l + A E_j,     H = ψᵀK⁻¹ψ,   E = ψᵀK⁻¹L,   K = diag(Z_i)
///
/// For the mean κ also holds the stuck stiffness of the joint, with a spring of that stiffness
/// added to the modes: a body that only its joints hold has a receptance then too. What not even
/// those hold has no mean motion. So it is done, with a complex spring, for a harmonic at which
/// some Z_i nearly vanishes beside what the joints give to the mode: H would be infinite at the
/// pole of an undamped mode, at which the joints move as everywhere.
class ReceptanceSide final : public StructureSide {
 public:
  ReceptanceSide(const JointedStructure& structure, std::string_view response_point,
                 std::size_t harmonics, Forcing forcing)
      : m_(structure, response_point, harmonics, forcing),
        stuck_(m_.joints),
        motion_(m_.modes, static_cast<Index>(harmonics) + 1) {
    for (Index j = 0; j < m_.joints; ++j) {
      stuck_[j] = structure.joints()[static_cast<std::size_t>(j)].joint.stiffness();
    }
    held_ = (m_.shapes.cwiseAbs2() * stuck_).cwiseAbs();
    static_spring_ = m_.spring_in_modes + stuck_;
    MatrixXd stiffness = m_.shapes * stuck_.asDiagonal() * m_.shapes.transpose();
    for (Index i = 0; i < m_.modes; ++i) stiffness(i, i) += m_.stiffness(i, 0, 0.0, 0.0).real();
    const MatrixXd flexibility = inverse_of_held(stiffness);
    static_modal_ = flexibility * m_.shapes;
    static_receptance_ = m_.shapes.transpose() * static_modal_;
    resting_modal_ = flexibility * m_.static_load;
    resting_joints_ = m_.shapes.transpose() * resting_modal_;
  }

  void evaluate(const Input& input, Values& values) override {
    values.residual.resize(m_.joints * coefficient_count(m_.harmonics));
    motion_.col(0) = static_modal_ * load(0, input, static_spring_) + resting_modal_;
    for (Index j = 0; j < m_.joints; ++j) {
      values.residual[at(j, 0)] =
          own(input, j, 0).real() - resting_joints_[j] -
          (static_receptance_.row(j) * load(0, input, static_spring_)).value().real();
    }
    for (std::size_t h = 1; h <= m_.harmonics; ++h) {
      const auto column = static_cast<Index>(h);
      if (input.odd_wave && h % 2 == 0) {
        motion_.col(column).setZero();
        for (Index j = 0; j < m_.joints; ++j) put(values.residual, at(j, h), 0.0);
        continue;
      }
      prepare(h, input);
      motion_.col(column) =
          solve(m_.shapes * load(h, input, spring_) + input.force * m_.load.col(column));
      const VectorXcd made = m_.shapes.transpose() * motion_.col(column);
      for (Index j = 0; j < m_.joints; ++j) {
        put(values.residual, at(j, h), own(input, j, h) - made[j]);
      }
    }
    values.response = (m_.response_shape.array() * motion_.col(1).array()).sum();
  }

  void differentiate(const Input& input, Derivatives& output) override {
    const Index n = m_.joints * coefficient_count(m_.harmonics);
    output.by_frequency.setZero(n);
    output.by_force.setZero(n);
    output.response_by_displacement.setZero(n);
    output.response_by_tension.setZero(n);
    odd_wave_ = input.odd_wave;
    by_displacement_.resize(m_.harmonics + 1);
    by_tension_.resize(m_.harmonics + 1);
    mean();
    for (std::size_t h = 1; h <= m_.harmonics; h += odd_wave_ ? 2 : 1) harmonic(h, input, output);
  }

  // The structure couples joints and not harmonics, a joint couples harmonics and not joints: a
  // column is that of a tangent, its harmonics each through the receptances of the joint.
  [[nodiscard]] MatrixXd by_motion(const std::vector<MatrixXd>& tangents) const override {
    std::vector<Index> kept;
    for (Index i = 0; i < coefficient_count(m_.harmonics); ++i) {
      if (!odd_wave_ || !is_even_coefficient(i)) kept.push_back(i);
    }
    const auto block = static_cast<Index>(kept.size());
    MatrixXd result(m_.joints * block, m_.joints * block);
    MatrixXd of_real(block, m_.joints);
    MatrixXd of_imaginary(block, m_.joints);
    VectorXd real(block);
    VectorXd imaginary(block);
    for (Index l = 0; l < m_.joints; ++l) {
      const MatrixXd& tangent = tangents[static_cast<std::size_t>(l)];
      spread(l, kept, of_real, of_imaginary);
      for (Index c = 0; c < block; ++c) {
        split(tangent.row(kept[static_cast<std::size_t>(c)]), kept, real, imaginary);
        Eigen::Map<MatrixXd> column(result.col(l * block + c).data(), block, m_.joints);
        column = -(of_real.array().colwise() * real.array() +
                   of_imaginary.array().colwise() * imaginary.array());
        add_own(l, kept[static_cast<std::size_t>(c)], c, column);
      }
    }
    return result;
  }

  [[nodiscard]] MatrixXcd modal() const override { return motion_; }

 private:
  /// A generalised inverse of a stiffness: what nothing holds does not move. In the scale of its
  /// diagonal, for modes whose frequencies lie decades apart.
  static MatrixXd inverse_of_held(const MatrixXd& stiffness) {
    VectorXd scale = stiffness.diagonal();
    for (double& value : scale) value = value > 0.0 ? 1.0 / std::sqrt(value) : 0.0;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scale.asDiagonal() * stiffness *
                                                         scale.asDiagonal());
    VectorXd inverse = solver.eigenvalues();
    for (double& value : inverse) value = value > 1e-12 ? 1.0 / value : 0.0;
    const MatrixXd vectors = scale.asDiagonal() * solver.eigenvectors();
    return vectors * inverse.asDiagonal() * vectors.transpose();
  }

  [[nodiscard]] Index at(Index joint, std::size_t h) const {
    return joint * coefficient_count(m_.harmonics) + coefficient_index(h);
  }

  [[nodiscard]] Complex coefficient(const VectorXd& x, Index joint, std::size_t h) const {
    const Index i = at(joint, h);
    return h == 0 ? Complex(x[i]) : Complex(x[i], x[i + 1]);
  }

  /// s_l = N_l + κ_l (u_l − c_l N_l) in harmonic h.
  [[nodiscard]] VectorXcd load(std::size_t h, const Input& input, const VectorXcd& spring) const {
    VectorXcd s(m_.joints);
    for (Index l = 0; l < m_.joints; ++l) {
      const Complex tension = coefficient(input.tension, l, h);
      const Complex displacement = coefficient(input.displacement, l, h);
      s[l] = tension + spring[l] * (displacement - m_.compliance[l] * tension);
    }
    return s;
  }

  /// u_j − c_j N_j in harmonic h: what the modes are to make.
  [[nodiscard]] Complex own(const Input& input, Index j, std::size_t h) const {
    return coefficient(input.displacement, j, h) -
           m_.compliance[j] * coefficient(input.tension, j, h);
  }

  void mean() { couple(0, static_receptance_.cast<Complex>(), static_spring_.cast<Complex>()); }

  /// How the joints feel each other in a harmonic.
  void couple(std::size_t h, const MatrixXcd& receptance, const VectorXcd& spring) {
    by_displacement_[h] = -receptance * spring.asDiagonal();
    by_displacement_[h].diagonal().array() += 1.0;
    const VectorXcd compliance = m_.compliance.cast<Complex>();
    const VectorXcd passed = VectorXcd::Ones(m_.joints) - spring.cwiseProduct(compliance);
    by_tension_[h] = -receptance * passed.asDiagonal();
    by_tension_[h].diagonal() -= compliance;
  }

  /// What real and imaginary tensions in joint l do to the kept coefficients of all joints.
  void spread(Index l, const std::vector<Index>& kept, MatrixXd& of_real,
              MatrixXd& of_imaginary) const {
    for (Index j = 0; j < m_.joints; ++j) {
      for (Index r = 0; r < of_real.rows(); ++r) {
        const Index i = kept[static_cast<std::size_t>(r)];
        const Complex g = by_tension_[harmonic_at(i)](j, l);
        of_real(r, j) = is_real_part(i) ? g.real() : g.imag();
        of_imaginary(r, j) = is_real_part(i) ? -g.imag() : g.real();
      }
    }
  }

  /// The real and the imaginary part in the harmonic of each kept coefficient.
  template <typename Row>
  static void split(const Row& tangent, const std::vector<Index>& kept, VectorXd& real,
                    VectorXd& imaginary) {
    for (Index r = 0; r < real.size(); ++r) {
      const Index i = kept[static_cast<std::size_t>(r)];
      const Index first = coefficient_index(harmonic_at(i));
      real[r] = tangent[first];
      imaginary[r] = i == 0 ? 0.0 : tangent[first + 1];
    }
  }

  /// By the displacement itself, coefficient i of joint l, which is the c-th that is kept.
  void add_own(Index l, Index i, Index c, Eigen::Map<MatrixXd>& column) const {
    const MatrixXcd& matrix = by_displacement_[harmonic_at(i)];
    if (i == 0) {
      column.row(c) += matrix.col(l).real().transpose();
    } else if (is_real_part(i)) {
      column.row(c) += matrix.col(l).real().transpose();
      column.row(c + 1) += matrix.col(l).imag().transpose();
    } else {
      column.row(c - 1) -= matrix.col(l).imag().transpose();
      column.row(c) += matrix.col(l).real().transpose();
    }
  }

  [[nodiscard]] static std::size_t harmonic_at(Index i) {
    return static_cast<std::size_t>((i + 1) / 2);
  }
  [[nodiscard]] static bool is_real_part(Index i) { return i == 0 || i % 2 == 1; }

  /// Takes K and κ of harmonic h.
  void prepare(std::size_t h, const Input& input) {
    constexpr double kNearPole = 1e-6;
    impedance_.resize(m_.modes);
    // Modal forcing makes a free vibration, at a pole of the modes where the joints hardly hold.
    near_pole_ = m_.forcing == Forcing::kModal;
    for (Index i = 0; i < m_.modes; ++i) {
      impedance_[i] = m_.stiffness(i, h, input.angular_frequency, input.force);
      near_pole_ = near_pole_ || std::abs(impedance_[i]) < kNearPole * held_[i];
    }
    spring_ = m_.spring_in_modes;
    if (!near_pole_) return;
    const VectorXcd added = Complex(1.0, 1.0) * stuck_;
    spring_ += added;
    MatrixXcd stiffness = m_.shapes * added.asDiagonal() * m_.shapes.transpose();
    stiffness.diagonal() += impedance_;
    held_solver_.compute(stiffness);
  }

  /// K⁻¹ of these loads.
  template <typename Loads>
  [[nodiscard]] MatrixXcd solve(const Loads& loads) const {
    if (near_pole_) return held_solver_.solve(loads.template cast<Complex>());
    return impedance_.cwiseInverse().asDiagonal() * loads;
  }

  void harmonic(std::size_t h, const Input& input, Derivatives& output) {
    const auto column = static_cast<Index>(h);
    prepare(h, input);
    VectorXcd shift = motion_.col(column);  // −Z_i′q_i, the load that acts as dω does
    VectorXcd unit(m_.modes);               // the load of a unit of force
    for (Index i = 0; i < m_.modes; ++i) {
      shift[i] *= -m_.stiffness_slope(i, h, input.angular_frequency, input.force);
      unit[i] = m_.load_by_force(i, h, input.angular_frequency, motion_(i, column));
    }
    const MatrixXcd weighted = solve(m_.shapes);  // K⁻¹ψ
    const MatrixXcd receptance = m_.shapes.transpose() * weighted;
    const VectorXcd driven = weighted.transpose() * unit;
    const VectorXcd shifted = weighted.transpose() * shift;
    for (Index j = 0; j < m_.joints; ++j) {
      const Index row = at(j, h);
      put(output.by_frequency, row, -shifted[j]);
      put(output.by_force, row, -driven[j]);
    }
    couple(h, receptance, spring_);
    if (h == 1) respond(weighted, unit, shift, output);
  }

  void respond(const MatrixXcd& weighted, const VectorXcd& unit, const VectorXcd& shift,
               Derivatives& output) const {
    const VectorXcd transfer = weighted.transpose() * m_.response_shape;
    const VectorXcd point = solve(m_.response_shape);
    output.response_by_force = (point.array() * unit.array()).sum();
    output.response_by_frequency = (point.array() * shift.array()).sum();
    for (Index l = 0; l < m_.joints; ++l) {
      const Complex by_displacement = transfer[l] * spring_[l];
      const Complex by_tension = transfer[l] * (1.0 - spring_[l] * m_.compliance[l]);
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
  VectorXd held_;               // Σ_j k_j ψ_ij²: what they give to the stiffness of mode i
  VectorXd static_spring_;      // κ of the mean
  MatrixXd static_modal_;       // K⁻¹ψ of the mean
  MatrixXd static_receptance_;  // ψᵀK⁻¹ψ of the mean
  VectorXd resting_modal_;      // K⁻¹p of the static loads
  VectorXd resting_joints_;     // ψᵀK⁻¹p
  MatrixXcd motion_;            // q
  bool odd_wave_ = false;       // where the derivatives were taken
  std::vector<MatrixXcd> by_displacement_;  // of each harmonic, joints × joints
  std::vector<MatrixXcd> by_tension_;
  VectorXcd impedance_;     // Z of the harmonic at hand
  VectorXcd spring_;        // κ
  bool near_pole_ = false;  // then K holds κ, and is factored
  Eigen::PartialPivLU<MatrixXcd> held_solver_;
};

}  // namespace

std::unique_ptr<StructureSide> make_receptance_side(const JointedStructure& structure,
                                                    std::string_view response_point,
                                                    std::size_t harmonics, Forcing forcing) {
  return std::make_unique<ReceptanceSide>(structure, response_point, harmonics, forcing);
}

}  // namespace microslip
