// SPDX-License-Identifier: MIT
#include "microslip/calibrate/level_sensitivity.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "microslip/algebra/lu.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/secant.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
constexpr Complex kI{0.0, 1.0};
/// Relative step of a difference quotient of κ over the amplitude: far above rounding, far below
/// its curvature.
constexpr double kAmplitudeStep = 1e-4;

Eigen::Map<const Eigen::VectorXd> view(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// κ of a joint without its linear damping, which does not depend on the amplitude.
Complex describing_function(const Joint& joint, double a) {
  return {secant_stiffness(joint, a), dissipation(joint, a) / (std::numbers::pi * a * a)};
}

/// The first harmonic of a vibration, and its excitation.
struct FirstHarmonic {
  Eigen::VectorXcd modal;        // q
  Eigen::VectorXcd flexibility;  // 1/(Z − iωξ) of each mode
  Eigen::VectorXcd slope;        // its dZ/dω
  Eigen::VectorXcd stiffening;   // dZ/d ln ω_i
  Eigen::VectorXcd drive;        // of q over the force amplitude, or over ξ
  Eigen::MatrixXd shapes;        // ψ: modes × joints
  Eigen::VectorXcd u;
  Eigen::VectorXcd compliance;  // 1 + cκ: Ψᵀq over u
  Eigen::VectorXcd stiffness;   // κ − k_s(1 + cκ): action of a joint on the modes over u
  Eigen::VectorXcd softening;   // dκ/da
  Eigen::VectorXd series;       // c
  Eigen::VectorXd share;        // 1 − k_s c
};

/// The forcing that maintains a free mode that no joint changes cancels all of its dynamic
/// stiffness: the remainder is rounding, of any size down to 0, and its size cancels from the
/// derivatives.
Complex above_rounding(Complex stiffness, const Mode& mode) {
  const double rounding =
      std::numeric_limits<double>::epsilon() * mode.angular_frequency * mode.angular_frequency;
  return std::abs(stiffness) > rounding ? stiffness : Complex(rounding);
}

void read_modes(const JointedStructure& structure, const SteadyVibration& vibration,
                Forcing forcing, FirstHarmonic& first) {
  const std::span<const Mode> modes = structure.linear().modes();
  const auto n = static_cast<Eigen::Index>(modes.size());
  const double omega = vibration.angular_frequency;
  const Complex fed =
      forcing == Forcing::kModal ? kI * omega * (2.0 * vibration.damping_ratio() * omega) : 0.0;
  first.modal.resize(n);
  first.flexibility.resize(n);
  first.slope.resize(n);
  first.stiffening.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Mode& mode = modes[static_cast<std::size_t>(i)];
    first.modal(i) = vibration.modal[static_cast<std::size_t>(i)][1];
    first.flexibility(i) =
        1.0 / above_rounding(modal_stiffness(mode, omega, structure.damping()) - fed, mode);
    first.slope(i) = -2.0 * omega - (omega > 0.0 ? fed / omega : 0.0);
    const double square = mode.angular_frequency * mode.angular_frequency;
    first.stiffening(i) =
        structure.damping() == DampingLaw::kViscous
            ? Complex(2.0 * square, mode.loss_factor * mode.angular_frequency * omega)
            : 2.0 * square * Complex(1.0, mode.loss_factor);
    if (structure.damping() == DampingLaw::kViscous) {
      first.slope(i) += kI * mode.loss_factor * mode.angular_frequency;
    }
  }
  if (forcing == Forcing::kModal) {
    first.drive = kI * omega * first.flexibility.cwiseProduct(first.modal);
    return;
  }
  first.drive = Eigen::VectorXcd::Zero(n);
  for (const Excitation& excitation : structure.excitations()) {
    const auto shape = view(structure.linear().load(excitation.point));
    first.drive += excitation.harmonics[0] * shape.cast<Complex>();
  }
  first.drive = first.flexibility.cwiseProduct(first.drive).eval();
}

void read_joints(const JointedStructure& structure, const SteadyVibration& vibration,
                 FirstHarmonic& first) {
  const std::span<const StructuralJoint> joints = structure.joints();
  const auto n = static_cast<Eigen::Index>(joints.size());
  first.shapes.resize(first.modal.size(), n);
  for (Eigen::VectorXcd* vector :
       {&first.u, &first.stiffness, &first.softening, &first.compliance}) {
    vector->resize(n);
  }
  first.series.resize(n);
  first.share.resize(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const StructuralJoint& joint = joints[static_cast<std::size_t>(j)];
    const JointCycle& cycle = vibration.joints[static_cast<std::size_t>(j)];
    first.shapes.col(j) = view(joint.shape);
    first.u(j) = cycle.displacement[1];
    const bool moves = std::abs(first.u(j)) > 0.0 && cycle.amplitude > 0.0;
    const Complex kappa = moves ? cycle.force[1] / first.u(j) : Complex(joint.joint.stiffness());
    first.series(j) = joint.series_compliance;
    first.share(j) = 1.0 - joint.spring_in_modes * joint.series_compliance;
    first.compliance(j) = 1.0 + joint.series_compliance * kappa;
    first.stiffness(j) = kappa - joint.spring_in_modes * first.compliance(j);
    first.softening(j) = 0.0;
    if (!moves) continue;
    const double step = kAmplitudeStep * cycle.amplitude;
    first.softening(j) = (describing_function(joint.joint, cycle.amplitude + step) -
                          describing_function(joint.joint, cycle.amplitude - step)) /
                         (2.0 * step);
  }
}

/// The displacements of the joints, and last of the response point, caused by forces across the
/// joints, the frequency and the drive.
struct SeenMotion {
  Eigen::MatrixXcd by_force;
  Eigen::VectorXcd by_frequency;
  Eigen::MatrixXcd by_mode;
  Eigen::VectorXcd by_drive;
  Eigen::VectorXcd direction;  ///< u/|u|; 0 of a joint that stands still
  Complex response;            ///< the same for the response point, over its displacement, 1/m
};

SeenMotion seen_motion(const JointedStructure& structure, std::string_view response,
                       const SteadyVibration& vibration, const FirstHarmonic& first) {
  const Eigen::Index joints = first.u.size();
  const Eigen::MatrixXcd reach = first.flexibility.asDiagonal() * first.shapes.cast<Complex>();
  Eigen::MatrixXcd seen(joints + 1, first.modal.size());
  seen.topRows(joints) = first.shapes.transpose().cast<Complex>();
  seen.row(joints) = view(structure.linear().shape(response)).transpose().cast<Complex>();
  SeenMotion motion;
  motion.by_force = seen * reach;
  motion.by_frequency =
      seen * first.flexibility.cwiseProduct(first.slope.cwiseProduct(first.modal));
  const Eigen::Index modes = first.modal.size();
  Eigen::MatrixXcd forces = Eigen::MatrixXcd::Zero(modes, modes + joints);
  forces.leftCols(modes).diagonal() = first.stiffening.cwiseProduct(first.modal);
  for (Eigen::Index j = 0; j < joints; ++j) {
    const double spring = structure.joints()[static_cast<std::size_t>(j)].spring_in_modes;
    forces.col(modes + j) =
        -2.0 * spring * first.compliance(j) * first.u(j) * first.shapes.col(j).cast<Complex>();
  }
  motion.by_mode = seen * first.flexibility.asDiagonal() * forces;
  motion.by_drive = seen * first.drive;
  motion.direction = Eigen::VectorXcd::Zero(joints);
  for (Eigen::Index j = 0; j < joints; ++j) {
    const double size = std::abs(first.u(j));
    if (size > 0.0) motion.direction(j) = first.u(j) / size;
  }
  motion.response = (seen.row(joints) * first.modal)(0) / vibration.response;
  return motion;
}

/// Matrix of the equations below in Re δu, Im δu, δω and s: real parts of all, then imaginary
/// ones.
Eigen::MatrixXd system_of(const FirstHarmonic& first, const SeenMotion& motion) {
  const Eigen::Index joints = first.u.size();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * joints + 2, 2 * joints + 2);
  const auto put = [&](Eigen::Index column, const Eigen::VectorXcd& values) {
    system.col(column).head(joints + 1) = values.real();
    system.col(column).tail(joints + 1) = values.imag();
  };
  for (Eigen::Index j = 0; j < joints; ++j) {
    for (const Complex unit : {Complex(1.0), kI}) {
      const double da = (std::conj(motion.direction(j)) * unit).real();
      const Complex softened = first.u(j) * first.softening(j) * da;
      Eigen::VectorXcd values =
          motion.by_force.col(j) * (first.stiffness(j) * unit + first.share(j) * softened);
      values(j) += first.compliance(j) * unit + first.series(j) * softened;
      put(unit == kI ? joints + j : j, values);
    }
  }
  put(2 * joints, motion.by_frequency);
  put(2 * joints + 1, -motion.by_drive);
  return system;
}

/// Minus the terms of Re δκ, Im δκ of each joint, of the displacement of the response point, of
/// ln ω_i of each mode and of half of ln k_s,j of each joint.
Eigen::MatrixXd right_hand_sides(const FirstHarmonic& first, const SeenMotion& motion) {
  const Eigen::Index joints = first.u.size();
  const Eigen::Index modes = motion.by_mode.cols();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(2 * joints + 2, 2 * joints + 1 + modes);
  for (Eigen::Index l = 0; l < joints; ++l) {
    for (const Complex unit : {Complex(1.0), kI}) {
      const Complex force = first.u(l) * unit;
      Eigen::VectorXcd values = -motion.by_force.col(l) * (first.share(l) * force);
      values(l) -= first.series(l) * force;
      const Eigen::Index column = unit == kI ? joints + l : l;
      right.col(column).head(joints + 1) = values.real();
      right.col(column).tail(joints + 1) = values.imag();
    }
  }
  right(joints, 2 * joints) = -motion.response.real();
  right(2 * joints + 1, 2 * joints) = -motion.response.imag();
  right.topRightCorner(joints + 1, modes) = -motion.by_mode.real();
  right.bottomRightCorner(joints + 1, modes) = -motion.by_mode.imag();
  return right;
}

}  // namespace

// Unknowns: Re δu, Im δu, δω and the change s of the drive. With Y the flexibility of the modes,
//   (1 + cκ)δu + c u δκ_t = Ψᵀδq,   φᵀδq = (φᵀq/X) δX,
//   δq = −YΨ{[κ − k_s(1 + cκ)]δu + (1 − k_s c)u δκ_t} − Y (Z′δω + Ż) q + drive s,
//   Ż = ∂Z_i/∂ln ω_i δln ω_i − Σ_j k_s,j ψ_jψ_jᵀ δln k_s,j,
//   δκ_t = κ′δa + δκ,   δa = Re(ū δu)/|u|.
LevelSensitivity level_sensitivity(const JointedStructure& structure, std::string_view response,
                                   const SteadyVibration& vibration, Forcing forcing) {
  FirstHarmonic first;
  read_modes(structure, vibration, forcing, first);
  read_joints(structure, vibration, first);
  const Eigen::Index joints = first.u.size();
  const SeenMotion motion = seen_motion(structure, response, vibration, first);
  const Eigen::MatrixXd system = system_of(first, motion);
  // Rows and columns in their own sizes: displacements and forces are far apart.
  const Eigen::VectorXd column_size = system.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = system * column_size.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd moved = column_size.cwiseInverse().asDiagonal() *
                                scaled.partialPivLu().solve(right_hand_sides(first, motion));

  LevelSensitivity found;
  const auto as_complex = [joints](const Eigen::RowVectorXd& row) {
    const Eigen::RowVectorXd real = row.head(joints);
    const Eigen::RowVectorXd imaginary = row.segment(joints, joints);
    return Eigen::RowVectorXcd(real.cast<Complex>() - kI * imaginary.cast<Complex>());
  };
  found.frequency = as_complex(moved.row(2 * joints));
  found.frequency_by_response = moved(2 * joints, 2 * joints);
  const Eigen::Index modes = motion.by_mode.cols();
  found.frequency_by_mode = moved.row(2 * joints).tail(modes);
  found.amplitude_by_mode.resize(joints, modes);
  found.amplitude.resize(joints, joints);
  found.amplitude_by_response.resize(joints);
  for (Eigen::Index j = 0; j < joints; ++j) {
    const Eigen::RowVectorXd da = motion.direction(j).real() * moved.row(j) +
                                  motion.direction(j).imag() * moved.row(joints + j);
    found.amplitude.row(j) = as_complex(da);
    found.amplitude_by_response(j) = da(2 * joints);
    found.amplitude_by_mode.row(j) = da.tail(modes);
  }
  return found;
}

}  // namespace microslip
