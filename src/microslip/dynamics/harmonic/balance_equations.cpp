// SPDX-License-Identifier: MIT
#include "microslip/dynamics/harmonic/balance_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "microslip/dynamics/cycle/trigonometric_basis.hpp"
#include "microslip/dynamics/structure/density_corners.hpp"
#include "microslip/dynamics/structure/static_equilibrium.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using std::numbers::pi;

/// The power of ω that makes the kind of response from a displacement.
double rate_power(ResponseKind kind) {
  switch (kind) {
    case ResponseKind::kAcceleration:
      return 2.0;
    case ResponseKind::kVelocity:
      return 1.0;
    case ResponseKind::kDisplacement:
      break;
  }
  return 0.0;
}

std::span<const double> to_span(const VectorXd& x, Index first, Index count) {
  return {x.data() + first, static_cast<std::size_t>(count)};
}

/// ∮ f ẋ dt of two functions by their harmonics: Σ_n −nπ Im(f_n* x_n).
double work(std::span<const Complex> force, std::span<const Complex> displacement) {
  double sum = 0.0;
  for (std::size_t n = 1; n < std::min(force.size(), displacement.size()); ++n) {
    sum -= static_cast<double>(n) * pi * std::imag(std::conj(force[n]) * displacement[n]);
  }
  return sum;
}

/// Σ_n nπ |f_n| |x_n|: the work of a force that is in phase with the velocity.
double apparent_work(std::span<const Complex> force, std::span<const Complex> displacement) {
  double sum = 0.0;
  for (std::size_t n = 1; n < std::min(force.size(), displacement.size()); ++n) {
    sum += static_cast<double>(n) * pi * std::abs(force[n]) * std::abs(displacement[n]);
  }
  return sum;
}

/// Input energy of modal forcing with ξ = 1/s, J: Σ_i Σ_n n²π ω |q_i,n|².
double input_of_unit_excitation(const SteadyVibration& vibration) {
  double sum = 0.0;
  for (const auto& harmonics : vibration.modal) {
    for (std::size_t n = 1; n < harmonics.size(); ++n) {
      const auto order = static_cast<double>(n);
      sum += order * order * pi * vibration.angular_frequency * std::norm(harmonics[n]);
    }
  }
  return sum;
}

/// None of the harmonics of the excitations is even; modal forcing knows no others than the motion.
bool excites_odd_harmonics(const JointedStructure& structure) {
  for (const Excitation& excitation : structure.excitations()) {
    for (std::size_t n = 2; n <= excitation.harmonics.size(); n += 2) {
      if (excitation.harmonics[n - 1] != 0.0) return false;
    }
  }
  return true;
}

/// Share of the displacement of a joint under static loads. Its rounding, 1e-16, cannot be
/// distinguished from its motion, and a resonance in a harmonic amplifies it by hundreds; with this
/// measure Newton's method ends where a motion of 1e-5 of the rest is found to nine digits.
constexpr double kRestRounding = 1e-3;
constexpr double kReactive = 1e-3;  // less work than this share of the apparent is a difference

}  // namespace

BalanceEquations::BalanceEquations(const JointedStructure& structure, const ResponsePoint& response,
                                   std::size_t harmonics, std::size_t samples, Forcing forcing)
    : structure_(structure),
      kind_(response.kind),
      harmonics_(harmonics),
      forcing_(forcing),
      joint_force_(harmonics, samples),
      operator_(make_structure_operator(structure, response.point, harmonics, forcing)),
      count_(static_cast<Index>(structure.joints().size()) * coefficient_count(harmonics)),
      displacement_(count_),
      tension_(count_),
      force_(coefficient_count(harmonics)),
      tangents_(structure.joints().size(),
                Eigen::MatrixXd(coefficient_count(harmonics), coefficient_count(harmonics))),
      cycles_(structure.joints().size()),
      branches_(structure.joints().size()),
      turns_(structure.joints().size()) {
  // An odd number of samples does not fall on itself half a period later.
  odd_forces_ = samples % 2 == 0 && !structure.shortens() && excites_odd_harmonics(structure) &&
                structure.static_loads().empty();
  if (!structure.static_loads().empty()) {
    resting_ = static_equilibrium(structure).joint_displacement;
  }
  for (const StructuralJoint& joint : structure.joints()) {
    atoms_.push_back(heavy_atoms(joint.joint.density()));
  }
  for (Index i = 0; i < count_ + 2; ++i) {
    all_.push_back(i);
    if (i >= count_ || !is_even_coefficient(i % coefficient_count(harmonics))) odd_.push_back(i);
  }
}

StructureOperator::Input BalanceEquations::input() const {
  return {displacement_, tension_, z_[count_], z_[count_ + 1], odd_wave_};
}

bool BalanceEquations::is_odd_wave() const {
  if (!odd_forces_) return false;
  const Index block = coefficient_count(harmonics_);
  for (Index i = 0; i < count_; ++i) {
    if (is_even_coefficient(i % block) && z_[i] != 0.0) return false;
  }
  return true;
}

void BalanceEquations::evaluate(const VectorXd& z) {
  if (z.size() == z_.size() && z == z_) return;
  z_ = z;
  differentiated_ = false;
  assembled_ = false;
  odd_wave_ = is_odd_wave();
  if (!z.allFinite()) {
    values_.residual.setConstant(count_, NAN);
    values_.response = NAN;
    return;
  }
  displacement_ = z.head(count_);
  const Index block = coefficient_count(harmonics_);
  for (std::size_t j = 0; j < cycles_.size(); ++j) {
    const Index first = static_cast<Index>(j) * block;
    Eigen::MatrixXd& tangent = tangents_[j];  // filled by rows: it is transposed
    cycles_[j] =
        joint_force_.evaluate(structure_.joints()[j].joint, to_span(displacement_, first, block),
                              {force_.data(), static_cast<std::size_t>(block)},
                              {tangent.data(), static_cast<std::size_t>(tangent.size())});
    add_linear_damping(j);
    tension_.segment(first, block) = -force_;
    keep_branches(j);
    keep_turns(j);
  }
  operator_->evaluate(input(), values_);
}

/// Keeps the branches of the motion that was evaluated last.
void BalanceEquations::keep_branches(std::size_t joint) {
  if (atoms_[joint].empty()) return;
  Branches& branches = branches_[joint];
  const Index block = coefficient_count(harmonics_);
  branches.reaches.resize(joint_force_.reaches());
  branches.gradients.resize(block, static_cast<Index>(joint_force_.reaches()));
  for (std::size_t rank = 0; rank < branches.reaches.size(); ++rank) {
    branches.reaches[rank] = joint_force_.reach(rank);
    joint_force_.reach_gradient(rank, {branches.gradients.col(static_cast<Index>(rank)).data(),
                                       static_cast<std::size_t>(block)});
  }
}

void BalanceEquations::keep_turns(std::size_t joint) {
  Turns& turns = turns_[joint];
  turns.at.clear();
  const std::size_t count = joint_force_.turns();
  if (count <= 2) return;
  const Index block = coefficient_count(harmonics_);
  turns.gradients.resize(block, static_cast<Index>(count));
  for (std::size_t i = 0; i < count; ++i) {
    turns.at.push_back(joint_force_.turn(i));
    joint_force_.turn_gradient(
        i, {turns.gradients.col(static_cast<Index>(i)).data(), static_cast<std::size_t>(block)});
  }
}

std::vector<Tie> BalanceEquations::ties() const {
  std::vector<Tie> ties;
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    const std::vector<HarmonicForce::Turn>& turns = turns_[j].at;
    const double size = 0.5 * (cycles_[j].highest - cycles_[j].lowest);
    for (std::size_t i = 0; i < turns.size(); ++i) {
      for (std::size_t k = i + 2; k < turns.size(); k += 2) {
        ties.push_back({j, turns[i].angle, turns[k].angle, size});
      }
    }
  }
  return ties;
}

/// The one next to an angle.
std::size_t BalanceEquations::turn_at(std::size_t joint, double angle) const {
  const auto distance = [angle](const HarmonicForce::Turn& turn) {
    return std::abs(std::remainder(turn.angle - angle, 2.0 * pi));
  };
  const std::vector<HarmonicForce::Turn>& turns = turns_[joint].at;
  return static_cast<std::size_t>(std::ranges::min_element(turns, {}, distance) - turns.begin());
}

double BalanceEquations::miss(const Tie& tie) const {
  const std::vector<HarmonicForce::Turn>& turns = turns_[tie.joint].at;
  const std::size_t first = turn_at(tie.joint, tie.first);
  const std::size_t second = turn_at(tie.joint, tie.second);
  if (first == second) return 1.0;
  return (turns[first].displacement - turns[second].displacement) / tie.size;
}

RowVectorXd BalanceEquations::miss_gradient(const Tie& tie) const {
  RowVectorXd gradient = RowVectorXd::Zero(count_ + 2);
  const std::size_t first = turn_at(tie.joint, tie.first);
  const std::size_t second = turn_at(tie.joint, tie.second);
  if (first == second) return gradient;
  const Index block = coefficient_count(harmonics_);
  const Eigen::MatrixXd& gradients = turns_[tie.joint].gradients;
  gradient.segment(static_cast<Index>(tie.joint) * block, block) =
      (gradients.col(static_cast<Index>(first)) - gradients.col(static_cast<Index>(second)))
          .transpose() /
      tie.size;
  return gradient;
}

double BalanceEquations::miss(const Onset& onset) const {
  const std::vector<double>& reaches = branches_[onset.joint].reaches;
  return onset.rank < reaches.size() ? reaches[onset.rank] / onset.displacement - 1.0 : -1.0;
}

RowVectorXd BalanceEquations::miss_gradient(const Onset& onset) const {
  RowVectorXd gradient = RowVectorXd::Zero(count_ + 2);
  const Branches& branches = branches_[onset.joint];
  if (onset.rank >= branches.reaches.size()) return gradient;
  const Index block = coefficient_count(harmonics_);
  gradient.segment(static_cast<Index>(onset.joint) * block, block) =
      branches.gradients.col(static_cast<Index>(onset.rank)).transpose() / onset.displacement;
  return gradient;
}

std::vector<std::size_t> BalanceEquations::slipping() const {
  std::vector<std::size_t> counts;
  for (std::size_t j = 0; j < branches_.size(); ++j) {
    counts.push_back(branches_[j].reaches.size());
    for (const double slip_force : atoms_[j]) {
      const double least = slip_force / structure_.joints()[j].joint.stiffness();
      counts.push_back(static_cast<std::size_t>(std::ranges::count_if(
          branches_[j].reaches, [least](double reach) { return reach > least; })));
    }
  }
  return counts;
}

bool BalanceEquations::slips_otherwise(const std::vector<std::size_t>& one,
                                       const std::vector<std::size_t>& other) const {
  auto a = one.begin();
  auto b = other.begin();
  for (const std::vector<double>& atoms : atoms_) {
    const auto count = static_cast<std::ptrdiff_t>(1 + atoms.size());
    const auto end = a + count;
    if (*a == *b && !std::equal(a, end, b)) return true;
    a = end;
    b += count;
  }
  return false;
}

/// i(β/π) u_n to harmonic n of the force, with its derivatives.
void BalanceEquations::add_linear_damping(std::size_t joint) {
  const double factor = structure_.joints()[joint].linear_damping / pi;
  if (factor == 0.0) return;
  const Index first = static_cast<Index>(joint) * coefficient_count(harmonics_);
  Eigen::MatrixXd& tangent = tangents_[joint];  // transposed
  for (std::size_t n = 1; n <= harmonics_; ++n) {
    const Index real = coefficient_index(n);
    const Index imaginary = real + 1;
    force_[real] -= factor * displacement_[first + imaginary];
    force_[imaginary] += factor * displacement_[first + real];
    tangent(imaginary, real) -= factor;
    tangent(real, imaginary) += factor;
  }
}

/// The structure's part of the derivatives and, by the chain rule, the joints'.
void BalanceEquations::differentiate() {
  if (differentiated_) return;
  differentiated_ = true;
  operator_->differentiate(input(), change_);
  const Index block = coefficient_count(harmonics_);
  gradient_.resize(count_ + 2);
  gradient_.head(count_) = change_.response_by_displacement;
  for (std::size_t j = 0; j < cycles_.size(); ++j) {
    const Index first = static_cast<Index>(j) * block;
    for (Index i = 0; i < block; ++i) {  // by harmonic 1 of the tension alone, as a rule
      const Complex by_tension = change_.response_by_tension[first + i];
      if (by_tension == 0.0) continue;
      gradient_.segment(first, block) -= by_tension * tangents_[j].col(i).transpose();
    }
  }
  gradient_[count_] = change_.response_by_frequency;
  gradient_[count_ + 1] = change_.response_by_force;
}

const Eigen::MatrixXd& BalanceEquations::jacobian() {
  differentiate();
  if (assembled_) return jacobian_;
  assembled_ = true;
  const auto size = static_cast<Index>(moving().size()) - 2;
  jacobian_.resize(size, size + 2);
  jacobian_.leftCols(size) = operator_->by_motion(tangents_);
  const std::vector<Index> rows(moving().begin(), moving().end() - 2);
  jacobian_.col(size) = change_.by_frequency(rows);
  jacobian_.col(size + 1) = change_.by_force(rows);
  return jacobian_;
}

const Eigen::RowVectorXcd& BalanceEquations::response_gradient() {
  differentiate();
  return gradient_;
}

Eigen::MatrixXd BalanceEquations::damped_jacobian(double loss_factor) {
  StructureOperator::Input all = input();
  all.odd_wave = false;
  operator_->differentiate(all, change_);
  differentiated_ = false;
  std::vector<MatrixXd> damped = tangents_;
  for (std::size_t j = 0; j < cycles_.size(); ++j) {
    const double damping = loss_factor * structure_.joints()[j].joint.stiffness();
    for (std::size_t n = 1; n <= harmonics_; ++n) {  // as a loss in addition to F; transposed
      const Index real = coefficient_index(n);
      damped[j](real + 1, real) -= damping;
      damped[j](real, real + 1) += damping;
    }
  }
  return operator_->by_motion(damped);
}

double BalanceEquations::log_response() const {
  return std::log(std::abs(values_.response)) + rate_power(kind_) * std::log(z_[count_]);
}

RowVectorXd BalanceEquations::log_response_gradient() {
  RowVectorXd gradient = (response_gradient() / values_.response).real();
  gradient[count_] += rate_power(kind_) / z_[count_];
  return gradient;
}

double BalanceEquations::value(Quantity quantity) const {
  switch (quantity) {
    case Quantity::kAngularFrequency:
      return z_[count_];
    case Quantity::kForceAmplitude:
      return z_[count_ + 1];
    case Quantity::kResponse:
      return std::exp(log_response());
    case Quantity::kPhaseLag:
      break;
  }
  return -std::arg(values_.response);
}

double BalanceEquations::miss(const Target& target) const {
  const double present = value(target.quantity);
  if (target.quantity != Quantity::kPhaseLag) return present / target.value - 1.0;
  return std::sin(target.value - present);  // has no jump at ±π
}

RowVectorXd BalanceEquations::miss_gradient(const Target& target) {
  RowVectorXd gradient = RowVectorXd::Zero(count_ + 2);
  const double present = value(target.quantity);
  switch (target.quantity) {
    case Quantity::kAngularFrequency:
      gradient[count_] = 1.0 / target.value;
      break;
    case Quantity::kForceAmplitude:
      gradient[count_ + 1] = 1.0 / target.value;
      break;
    case Quantity::kResponse:
      gradient = log_response_gradient() * (present / target.value);
      break;
    case Quantity::kPhaseLag:
      gradient = std::cos(target.value - present) * (response_gradient() / values_.response).imag();
      break;
  }
  return gradient;
}

VectorXd BalanceEquations::scale() const {
  const Index block = coefficient_count(harmonics_);
  VectorXd scale(count_ + 2);
  double largest = 0.0;
  for (Index first = 0; first < count_; first += block) {
    const double size = displacement_.segment(first + 1, block - 1).norm();  // without the mean
    scale.segment(first, block).setConstant(size);
    largest = std::max(largest, size);
  }
  // Where the modes cancel at a joint it is at rest while the structure moves: its own motion is
  // then no measure of the rounding error.
  if (std::isfinite(std::abs(values_.response))) {
    largest = std::max(largest, std::abs(values_.response));
  }
  const double least = largest > 0.0 ? 1e-6 * largest : 1.0;
  scale.head(count_) = scale.head(count_).cwiseMax(least);
  for (std::size_t j = 0; j < resting_.size(); ++j) {
    auto motion = scale.segment(static_cast<Index>(j) * block, block);
    motion = motion.cwiseMax(kRestRounding * std::abs(resting_[j]));
  }
  scale[count_] = z_[count_];
  scale[count_ + 1] = std::abs(z_[count_ + 1]);
  return scale;
}

VectorXd BalanceEquations::enlarged(VectorXd z, double n) const {
  const Index block = coefficient_count(harmonics_);
  const Index kept = resting_.empty() ? 0 : 1;  // the mean: static loads do not grow
  for (Index first = 0; first < count_; first += block) {
    z.segment(first + kept, block - kept) *= n;
  }
  if (forcing_ == Forcing::kExcitation) z[count_ + 1] *= n;
  return z;
}

void BalanceEquations::set_at_rest(VectorXd& z) const {
  const Index block = coefficient_count(harmonics_);
  for (std::size_t j = 0; j < resting_.size(); ++j) {
    z[static_cast<Index>(j) * block] = resting_[j];
  }
}

VectorXd BalanceEquations::unknowns(const SteadyVibration& vibration) const {
  VectorXd z(count_ + 2);
  Index at = 0;
  for (const JointCycle& joint : vibration.joints) {
    z[at++] = joint.displacement[0].real();
    for (std::size_t n = 1; n <= harmonics_; ++n) {
      z[at++] = joint.displacement[n].real();
      z[at++] = joint.displacement[n].imag();
    }
  }
  z[at++] = vibration.angular_frequency;
  z[at] = forcing_ == Forcing::kExcitation
              ? vibration.force_amplitude
              : vibration.input_energy / input_of_unit_excitation(vibration);
  return z;
}

RowVectorXd BalanceEquations::lag_gradient() {
  return -(response_gradient() / values_.response).imag();
}

SteadyVibration BalanceEquations::vibration() {
  SteadyVibration result;
  result.angular_frequency = z_[count_];
  result.force_amplitude = z_[count_ + 1];
  result.response = value(Quantity::kResponse);
  result.phase_lag = value(Quantity::kPhaseLag);
  const Eigen::MatrixXcd q = operator_->modal();
  for (Index i = 0; i < q.rows(); ++i) {
    const Eigen::VectorXcd row = q.row(i);
    result.modal.emplace_back(row.begin(), row.end());
  }
  add_joint_cycles(result);
  add_energies(result);
  return result;
}

void BalanceEquations::add_joint_cycles(SteadyVibration& vibration) const {
  const Index block = coefficient_count(harmonics_);
  for (std::size_t j = 0; j < cycles_.size(); ++j) {
    JointCycle cycle{.name = structure_.joints()[j].name, .displacement = {}, .force = {}};
    const Index first = static_cast<Index>(j) * block;
    for (std::size_t n = 0; n <= harmonics_; ++n) {
      cycle.displacement.push_back(harmonic_of(displacement_.segment(first, block), n));
      cycle.force.push_back(-harmonic_of(tension_.segment(first, block), n));
    }
    cycle.amplitude = 0.5 * (cycles_[j].highest - cycles_[j].lowest);
    cycle.reversals = cycles_[j].reversals;
    cycle.dissipation = work(cycle.force, cycle.displacement);
    const double beta = structure_.joints()[j].linear_damping;
    for (std::size_t n = 1; n <= harmonics_; ++n) {
      cycle.linear_dissipation += static_cast<double>(n) * beta * std::norm(cycle.displacement[n]);
    }
    vibration.joints.push_back(std::move(cycle));
  }
}

/// Returns the apparent work.
double BalanceEquations::add_input(SteadyVibration& vibration) const {
  if (forcing_ == Forcing::kModal) {
    vibration.input_energy = z_[count_ + 1] * input_of_unit_excitation(vibration);
    vibration.force_amplitude = vibration.input_energy / (pi * std::abs(values_.response));
    return std::abs(vibration.input_energy);
  }
  double apparent = 0.0;
  for (const Excitation& excitation : structure_.excitations()) {
    std::vector<Complex> force{0.0};
    for (const Complex s : excitation.harmonics) force.push_back(vibration.force_amplitude * s);
    const auto displacement = vibration.worked_on(structure_.linear(), excitation.point);
    vibration.input_energy += work(force, displacement);
    apparent += apparent_work(force, displacement);
  }
  return apparent;
}

void BalanceEquations::add_energies(SteadyVibration& vibration) const {
  const double apparent = add_input(vibration);
  for (std::size_t i = 0; i < vibration.modal.size(); ++i) {
    const Mode& mode = structure_.linear().modes()[i];
    for (std::size_t n = 1; n <= harmonics_; ++n) {
      const auto order = static_cast<double>(n);
      const Complex stiffness =
          modal_stiffness(mode, order * vibration.angular_frequency, structure_.damping());
      vibration.linear_dissipation +=
          order * pi * stiffness.imag() * std::norm(vibration.modal[i][n]);
    }
  }
  double left = vibration.input_energy - vibration.linear_dissipation;
  for (const JointCycle& joint : vibration.joints) left -= joint.dissipation;
  const double size = std::max(std::abs(vibration.input_energy), kReactive * apparent);
  vibration.energy_imbalance = std::abs(left) / size;
}

std::string energy_doubt(const SteadyVibration& vibration, double tolerance) {
  const double most = std::max(1e-8, 1e4 * tolerance);
  if (vibration.energy_imbalance <= most) return "";
  return fmt::format("the energy balance is off by {:.1e} of the input; at most {:.1e} is rounding",
                     vibration.energy_imbalance, most);
}

}  // namespace microslip
