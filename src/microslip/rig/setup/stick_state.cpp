// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/stick_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/error.hpp"
#include "microslip/structure/beam.hpp"
#include "microslip/structure/beam_modes.hpp"

namespace microslip {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Beam beam_of(const Rig& rig) {
  const RigBeam& beam = *rig.beam();
  Beam result{.length = beam.length,
              .bending_stiffness = beam.bending_stiffness(),
              .mass_per_length = beam.mass_density * beam.area()};
  for (const RigMass& mass : rig.masses) result.masses.push_back({mass.position, mass.mass});
  return result;
}

/// k from the stick frequency: the spring by the frequency includes the axial compliance in series
/// with the joint.
double stiffness_from_stick_frequency(const Rig& rig, const Beam& beam, double axial_compliance) {
  const double frequency = *rig.contact.stick_frequency;
  const double radius = rig.contact.rod_radius;
  double spring = 0.0;
  try {
    spring = spring_for_first_frequency(beam, frequency);
  } catch (const InputError& error) {
    throw error.renamed("contact.stick_frequency");
  }
  const double in_series = spring / (radius * radius);
  if (spring > 0.0 && in_series * axial_compliance < 1.0) {
    return in_series / (1.0 - in_series * axial_compliance);
  }
  throw InputError(
      "contact.stick_frequency", frequency,
      fmt::format("must leave a stiffness for the joint: the torsional spring would be "
                  "{:.4g} N m/rad, that of the beam's axial compliance alone is {:.4g}",
                  spring, radius * radius / axial_compliance),
      "Check it, the rod radius and the dimensions of the beam.");
}

StickState state_of_beam(const Rig& rig, std::size_t modes) {
  Beam beam = beam_of(rig);
  const double radius = rig.contact.rod_radius;
  StickState state;
  state.axial_compliance = rig.beam()->length / (rig.beam()->area() * rig.beam()->youngs_modulus);
  state.stiffness = rig.contact.stiffness
                        ? *rig.contact.stiffness
                        : stiffness_from_stick_frequency(rig, beam, state.axial_compliance);
  beam.tip_stiffness = state.stiffness * radius * radius;
  const BeamModes solved(beam, modes);
  state.omega.assign(solved.angular_frequencies().begin(), solved.angular_frequencies().end());
  state.excitation = solved.shapes(rig.excitation.position);
  for (const RigSensor& sensor : rig.accelerometers) {
    state.accelerometer.push_back(solved.shapes(sensor.position));
  }
  for (const double slope : solved.tip_slopes()) state.joint.push_back(radius * slope);
  for (std::size_t i = 0; i < modes; ++i) {
    for (std::size_t r = 0; r < modes; ++r) {
      state.shortening.push_back(solved.slope_integral(i, r));
    }
  }
  return state;
}

StickState state_of_modes(const Rig& rig) {
  const RigModes& modes = *rig.modes();
  StickState state;
  for (const double frequency : modes.frequency) state.omega.push_back(kTurn * frequency);
  state.excitation = modes.excitation;
  state.joint = modes.joint;
  for (const RigSensor& sensor : rig.accelerometers) state.accelerometer.push_back(sensor.shape);
  state.stiffness = rig.contact.stiffness.value_or(0.0);
  return state;
}

std::size_t number_of_modes(const Rig& rig, std::size_t wanted) {
  if (wanted > 0) return wanted;
  return rig.test ? rig.test->modes : kBeamModes;
}

}  // namespace

StickState stick_state(const Rig& rig, std::size_t modes) {
  check_rig(rig);
  StickState state =
      rig.beam() ? state_of_beam(rig, number_of_modes(rig, modes)) : state_of_modes(rig);
  for (std::size_t i = 0; i < state.modes(); ++i) {
    state.loss_factor.push_back(rig.loss_factor_of(i));
  }
  return state;
}

double natural_frequency(const StickState& state, double softening) {
  const auto modes = static_cast<Eigen::Index>(state.modes());
  const Eigen::Map<const Eigen::VectorXd> omega(state.omega.data(), modes);
  const Eigen::Map<const Eigen::VectorXd> joint(state.joint.data(), modes);
  Eigen::MatrixXd stiffness = -softening * joint * joint.transpose();
  stiffness.diagonal() += omega.cwiseAbs2();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[0], 0.0)) / kTurn;
}

}  // namespace microslip
