// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/structure_operator.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd to_vector(std::span<const double> values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

ModalMatrices::ModalMatrices(const JointedStructure& structure, std::string_view response_point,
                             std::size_t harmonic_count, Forcing what_drives)
    : modes(static_cast<Index>(structure.linear().size())),
      joints(static_cast<Index>(structure.joints().size())),
      harmonics(harmonic_count),
      mode(structure.linear().modes().begin(), structure.linear().modes().end()),
      damping(structure.damping()),
      forcing(what_drives),
      shapes(modes, joints),
      response_shape(to_vector(structure.linear().shape(response_point))),
      load(Eigen::MatrixXcd::Zero(modes, static_cast<Index>(harmonics) + 1)),
      static_load(to_vector(structure.static_modal_load())),
      spring_in_modes(joints),
      compliance(joints) {
  for (Index j = 0; j < joints; ++j) {
    const StructuralJoint& joint = structure.joints()[static_cast<std::size_t>(j)];
    shapes.col(j) = to_vector(joint.shape);
    spring_in_modes[j] = joint.spring_in_modes;
    compliance[j] = joint.series_compliance;
  }
  if (forcing == Forcing::kModal) return;
  for (const Excitation& excitation : structure.excitations()) {
    const VectorXd shape = to_vector(structure.linear().load(excitation.point));
    for (std::size_t n = 1; n <= std::min(excitation.harmonics.size(), harmonics); ++n) {
      load.col(static_cast<Index>(n)) += shape * excitation.harmonics[n - 1];
    }
  }
}

std::complex<double> ModalMatrices::stiffness(Index i, std::size_t n, double angular_frequency,
                                              double force) const {
  const Mode& m = mode[static_cast<std::size_t>(i)];
  if (n == 0) return m.angular_frequency * m.angular_frequency;
  const double omega = static_cast<double>(n) * angular_frequency;
  const double excited = forcing == Forcing::kModal ? force * omega : 0.0;
  return modal_stiffness(m, omega, damping) - std::complex<double>(0.0, excited);
}

std::complex<double> ModalMatrices::stiffness_slope(Index i, std::size_t n,
                                                    double angular_frequency, double force) const {
  const Mode& m = mode[static_cast<std::size_t>(i)];
  const auto order = static_cast<double>(n);
  const bool viscous = damping == DampingLaw::kViscous;
  const double damped = viscous ? m.loss_factor * m.angular_frequency : 0.0;
  const double excited = forcing == Forcing::kModal ? force : 0.0;
  return {-2.0 * order * order * angular_frequency, order * (damped - excited)};
}

std::complex<double> ModalMatrices::load_by_force(Index i, std::size_t n, double angular_frequency,
                                                  std::complex<double> q) const {
  if (forcing == Forcing::kExcitation) return load(i, static_cast<Index>(n));
  return std::complex<double>(0.0, static_cast<double>(n) * angular_frequency) * q;
}

std::unique_ptr<StructureOperator> make_structure_operator(const JointedStructure& structure,
                                                           std::string_view response_point,
                                                           std::size_t harmonics, Forcing forcing) {
  return structure.shortens()
             ? make_shortening_operator(structure, response_point, harmonics, forcing)
             : make_linear_operator(structure, response_point, harmonics, forcing);
}

}  // namespace microslip
