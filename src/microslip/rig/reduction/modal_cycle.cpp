// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/modal_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/algebra/lu.hpp"
#include "microslip/rig/reduction/loop_stiffness.hpp"
#include "microslip/signal/harmonic/turning_points.hpp"

namespace microslip {
namespace {

using CycleComplex = std::complex<double>;

std::vector<std::string> points_of(const std::vector<PointSensor>& sensors) {
  std::vector<std::string> points;
  for (const PointSensor& sensor : sensors) points.push_back(sensor.point);
  return points;
}

/// π Σ n Im(F_n conj u_n).
double loss_of(const FourierSeries& force, const FourierSeries& displacement) {
  double sum = 0.0;
  for (std::size_t n = 1; n <= force.order(); ++n) {
    sum += static_cast<double>(n) * (force.c(n) * std::conj(displacement.c(n))).imag();
  }
  return std::numbers::pi * sum;
}

/// δ_j = h_j1/w_j1, w_j the displacement with what lies in series: k′ − F_1/w_1.
std::vector<CycleComplex> beyond_sticking(const StructureTest& test, const JointsMotion& motion) {
  std::vector<CycleComplex> delta;
  const std::span<const StructuralJoint> joints = test.structure.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const CycleComplex force = motion.force[j].c(1);
    const CycleComplex ends = motion.displacement[j].c(1) + joints[j].series_compliance * force;
    delta.push_back(std::abs(ends) > 0.0 ? joints[j].stuck_stiffness() - force / ends : 0.0);
  }
  return delta;
}

/// The receptance of the response point, joints with h_j = δ_j w_j: condensed onto them.
class EquivalentStructure {
 public:
  EquivalentStructure(const StructureTest& test, std::span<const CycleComplex> delta)
      : structure_(test.structure),
        response_(structure_.linear().shape(test.response)),
        excitation_(structure_.linear().shape(structure_.excitations().front().point)) {
    const std::span<const StructuralJoint> joints = structure_.joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      taken_.push_back(delta[j] - joints[j].stuck_stiffness() + joints[j].spring_in_modes);
    }
  }

  [[nodiscard]] CycleComplex receptance(double omega) const {
    const auto count = static_cast<Eigen::Index>(taken_.size());
    CycleComplex direct = 0.0;
    Eigen::RowVectorXcd to_response = Eigen::RowVectorXcd::Zero(count);
    Eigen::VectorXcd from_force = Eigen::VectorXcd::Zero(count);
    Eigen::MatrixXcd between = Eigen::MatrixXcd::Zero(count, count);
    for (std::size_t i = 0; i < structure_.linear().size(); ++i) {
      const Mode& mode = structure_.linear().modes()[i];
      CycleComplex stiffness = modal_stiffness(mode, omega, structure_.damping());
      stiffness +=
          CycleComplex(0.0, 1e-13 * omega * omega);  // without loss, at a natural frequency
      Eigen::VectorXd shape(count);
      for (Eigen::Index j = 0; j < count; ++j) {
        shape[j] = structure_.joints()[static_cast<std::size_t>(j)].shape[i];
      }
      direct += response_[i] * excitation_[i] / stiffness;
      to_response += (response_[i] / stiffness) * shape.transpose();
      from_force += (excitation_[i] / stiffness) * shape;
      between += (1.0 / stiffness) * (shape * shape.transpose()).cast<CycleComplex>();
    }
    const Eigen::Map<const Eigen::VectorXcd> taken(taken_.data(), count);
    const Eigen::MatrixXcd joints =
        Eigen::MatrixXcd::Identity(count, count) - taken.asDiagonal() * between;
    const Eigen::VectorXcd loads =
        joints.partialPivLu().solve(taken.cwiseProduct(from_force).eval());
    return direct + (to_response * loads).value();
  }

 private:
  const JointedStructure& structure_;
  std::span<const double> response_;
  std::span<const double> excitation_;
  std::vector<CycleComplex> taken_;  ///< of the springs in the modes
};

}  // namespace

std::optional<double> phase_resonance(const StructureTest& test,
                                      std::span<const std::complex<double>> delta, double omega) {
  constexpr int kMostSteps = 50;
  constexpr double kFarthest = 0.1;
  // Of one mode it is linear in ω², so that the first secant is exact.
  const EquivalentStructure structure(test, delta);
  const auto in_phase = [&](double at) { return (1.0 / structure.receptance(at)).real(); };
  double before = omega * (1.0 + 1e-5);
  double now = omega;
  double value_before = in_phase(before);
  for (int step = 0; step < kMostSteps; ++step) {
    const double value = in_phase(now);
    const double slope = (value - value_before) / (now - before);
    if (!std::isfinite(slope) || slope == 0.0) return std::nullopt;
    const double next = now - value / slope;
    if (!(std::abs(next / omega - 1.0) <= kFarthest)) return std::nullopt;
    if (std::abs(next - now) <= 1e-12 * omega) return next / (2.0 * std::numbers::pi);
    before = now;
    value_before = value;
    now = next;
  }
  return std::nullopt;
}

double ModalCycle::energy_difference() const {
  double sum = 0.0;
  for (const JointCycleValues& joint : joints) sum += joint.dissipation;
  return sum - dissipation();
}

ModalCycleReduction::ModalCycleReduction(const StructureTest& test, double omega,
                                         std::size_t harmonics, const JointsObserverScales& scales)
    : test_(test),
      observer_(test.structure, points_of(test.accelerometers), omega, harmonics, scales) {}

std::complex<double> ModalCycleReduction::displacement_at(std::span<const FourierSeries> series,
                                                          const JointsMotion& motion,
                                                          const std::string& point,
                                                          std::size_t harmonic) const {
  const std::size_t n = harmonic;
  const auto sensor = std::ranges::find(test_.accelerometers, point, &PointSensor::point);
  if (sensor != test_.accelerometers.end()) {
    const auto index = static_cast<std::size_t>(sensor - test_.accelerometers.begin());
    const double omega = static_cast<double>(n) * motion.excitation.omega;
    return -series[1 + index].c(n) / (omega * omega);
  }
  CycleComplex sum = 0.0;
  const std::span<const double> shape = test_.structure.linear().shape(point);
  for (std::size_t i = 0; i < shape.size(); ++i) sum += shape[i] * motion.modal[i].c(n);
  return sum;
}

double ModalCycleReduction::input_energy(std::span<const FourierSeries> series,
                                         const JointsMotion& motion) const {
  const std::string& point = test_.structure.excitations().front().point;
  double sum = 0.0;
  for (std::size_t n = 1; n <= series[0].order(); ++n) {
    const CycleComplex motion_there = displacement_at(series, motion, point, n);
    sum += static_cast<double>(n) * (series[0].c(n) * std::conj(motion_there)).imag();
  }
  return std::numbers::pi * sum;
}

double ModalCycleReduction::linear_dissipation(const JointsMotion& motion) const {
  const std::span<const Mode> modes = test_.structure.linear().modes();
  double sum = 0.0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (std::size_t n = 1; n <= motion.modal[i].order(); ++n) {
      const double omega = static_cast<double>(n) * motion.modal[i].omega;
      const double loss = modal_stiffness(modes[i], omega, test_.structure.damping()).imag();
      sum += static_cast<double>(n) * loss * std::norm(motion.modal[i].c(n));
    }
  }
  return std::numbers::pi * sum;
}

ModalCycle ModalCycleReduction::cycle_of(std::span<const FourierSeries> series,
                                         JointsMotion motion) const {
  ModalCycle result;
  result.displacement = std::abs(displacement_at(series, motion, test_.response, 1));
  result.input_energy = input_energy(series, motion);
  result.linear_dissipation = linear_dissipation(motion);
  result.resonance =
      phase_resonance(test_, beyond_sticking(test_, motion), motion.excitation.omega);
  for (std::size_t j = 0; j < motion.force.size(); ++j) {
    const FourierSeries& u = motion.displacement[j];
    result.joints.push_back({peak_to_peak(u).amplitude(), loss_of(motion.force[j], u),
                             loop_stiffness(motion.force[j], u)});
  }
  result.motion = std::move(motion);
  return result;
}

ModalCycle ModalCycleReduction::reduce(std::span<const FourierSeries> series) const {
  return cycle_of(series, observer_.observe(series[0], series.subspan(1)));
}

ModalCycle ModalCycleReduction::reduce_with(std::span<const FourierSeries> series,
                                            std::size_t direction, double phase) const {
  return cycle_of(series, observer_.observe_with(series[0], series.subspan(1), direction, phase));
}

}  // namespace microslip
