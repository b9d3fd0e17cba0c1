// SPDX-License-Identifier: MIT
#include "microslip/rig/virtual_test/shaken_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "microslip/rig/setup/shaker.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

constexpr double kTolerance = 1e-9;  // of r_n over F_1
constexpr int kMostTrials = 40;

}  // namespace

HarmonicBalance RigInMotion::balance(std::vector<Complex> force) const {
  return HarmonicBalance(rig_structure(rig_, state_, joint_, std::move(force), linear_damping_),
                         {rig_.excitation.channel, ResponseKind::kAcceleration}, options_);
}

double RigInMotion::stuck_stiffness() const {
  return state_.stiffness > 0.0 ? state_.stiffness : joint_.stiffness();
}

std::vector<Complex> RigInMotion::exciter_displacement(const SteadyVibration& vibration) const {
  return vibration.displacement(modes_, rig_.excitation.channel);
}

Complex RigInMotion::receptance(double angular_frequency, Complex softening) const {
  Complex exciter = 0.0;
  Complex between = 0.0;
  Complex joint = 0.0;
  for (std::size_t i = 0; i < state_.modes(); ++i) {
    const Mode mode{state_.omega[i], state_.loss_factor[i]};
    const Complex one = 1.0 / modal_stiffness(mode, angular_frequency, DampingLaw::kHysteretic);
    exciter += state_.excitation[i] * state_.excitation[i] * one;
    between += state_.excitation[i] * state_.joint[i] * one;
    joint += state_.joint[i] * state_.joint[i] * one;
  }
  return exciter + between * between * softening / (1.0 - softening * joint);
}

ShakenStructure::ShakenStructure(const RigInMotion& motion, const RigShaker& shaker,
                                 double angular_frequency, double response, SteadyVibration start)
    : motion_(motion),
      angular_frequency_(angular_frequency),
      response_(response),
      per_voltage_(motion.harmonics() + 1),
      per_displacement_(motion.harmonics() + 1),
      loaded_(motion.harmonics() + 1),
      last_(std::move(start)),
      shape_(VectorXcd::Zero(static_cast<Index>(motion.harmonics()) - 1)),
      broyden_(shape_.size()) {
  const JointCycle& joint = last_.joints[0];
  const Complex softening = motion.stuck_stiffness() - joint.force[1] / joint.displacement[1];
  for (std::size_t n = 1; n <= motion.harmonics(); ++n) {
    const double omega = static_cast<double>(n) * angular_frequency;
    const ShakerTransfer transfer = shaker_transfer(shaker, omega);
    per_voltage_[n] = transfer.voltage;
    per_displacement_[n] = transfer.displacement;
    loaded_[n] = 1.0 + transfer.displacement * motion.receptance(omega, softening);
  }
  find_voltage();
  shape_ = -residual(VectorXcd::Zero(shape_.size()));
  voltage_.clear();
}

void ShakenStructure::solve() {
  std::vector<Complex> force{1.0};
  force.insert(force.end(), shape_.begin(), shape_.end());
  VibrationResult result = motion_.balance(force).solve(
      {Quantity::kAngularFrequency, angular_frequency_}, {Quantity::kResponse, response_}, last_);
  summary_.stop = result.summary.stop;
  summary_.reason = result.summary.reason;
  summary_.residual = result.summary.residual;
  ++summary_.iterations;
  if (!summary_.converged()) return;
  last_ = std::move(result.vibration);
  find_voltage();
}

void ShakenStructure::find_voltage() {
  const std::vector<Complex> w = motion_.exciter_displacement(last_);
  voltage_.assign(w.size(), 0.0);
  for (std::size_t n = 1; n < w.size(); ++n) {
    const Complex share = n == 1 ? 1.0 : shape_[static_cast<Index>(n) - 2];
    voltage_[n] = (last_.force_amplitude * share + per_displacement_[n] * w[n]) / per_voltage_[n];
  }
}

VectorXcd ShakenStructure::residual(const VectorXcd& generator) const {
  const Complex turn = voltage_[1] / std::abs(voltage_[1]);
  VectorXcd r(shape_.size());
  Complex phase = turn;
  for (Index i = 0; i < r.size(); ++i) {
    const auto n = static_cast<std::size_t>(i) + 2;
    phase *= turn;
    r[i] = per_voltage_[n] * (voltage_[n] - generator[i] * phase) /
           (loaded_[n] * last_.force_amplitude);
  }
  return r;
}

ShakenStructure::Outcome ShakenStructure::settle(const VectorXcd& generator) {
  Summary& s = summary_;
  s = {.method = "harmonic balance with shaker"};
  broyden_.begin_again();
  if (voltage_.empty()) {
    solve();
    if (!s.converged()) return {.driven = {}, .force = {}, .drive = 0.0, .summary = s};
  }
  s.stop = Stop::kConverged;
  VectorXcd r = residual(generator);
  double error = r.cwiseAbs().maxCoeff();
  while (s.converged() && error > kTolerance && s.iterations < kMostTrials) {
    shape_ = broyden_.next(shape_, r);
    solve();
    r = residual(generator);
    error = r.cwiseAbs().maxCoeff();
  }
  if (s.converged() && !(error <= kTolerance)) {
    s.stop = Stop::kLimit;
    s.reason = fmt::format(
        "the harmonics of the force of the shaker do not converge: after {} trials "
        "they are off by {:.2g} of the fundamental",
        s.iterations, error);
  }
  s.residual = std::max(s.residual, error);
  return outcome();
}

VectorXcd ShakenStructure::linear_transfer() const {
  VectorXcd transfer(shape_.size());
  for (Index i = 0; i < transfer.size(); ++i) {
    const auto n = static_cast<std::size_t>(i) + 2;
    transfer[i] = per_voltage_[n] / loaded_[n];
  }
  return transfer;
}

ShakenStructure::Outcome ShakenStructure::outcome() const {
  Outcome outcome;
  outcome.driven.vibration = last_;
  outcome.driven.voltage = voltage_;
  outcome.driven.force.assign(voltage_.size(), 0.0);
  outcome.driven.force[1] = last_.force_amplitude;
  outcome.force.resize(shape_.size());
  outcome.drive = std::abs(voltage_[1]);
  const Complex back = std::conj(voltage_[1]) / outcome.drive;
  Complex phase = back;
  for (Index i = 0; i < shape_.size(); ++i) {
    phase *= back;
    outcome.driven.force[static_cast<std::size_t>(i) + 2] = last_.force_amplitude * shape_[i];
    outcome.force[i] = shape_[i] * phase;
  }
  outcome.summary = summary_;
  return outcome;
}

}  // namespace microslip
