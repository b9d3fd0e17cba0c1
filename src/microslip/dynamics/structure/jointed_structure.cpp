// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/jointed_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/base/error.hpp"
#include "microslip/dynamics/structure/spring_shares.hpp"

namespace microslip {
namespace {

using Eigen::Index;

std::string member(const StructuralJoint& joint, const char* what) {
  return fmt::format("{} of joint '{}'", what, joint.name);
}

void require_non_negative(const StructuralJoint& joint, const char* what, double value) {
  if (std::isfinite(value) && value >= 0.0) return;
  throw InputError(member(joint, what), value, "must be 0 or more, and finite");
}

void require_values(const StructuralJoint& joint, const char* what,
                    const std::vector<double>& values, std::size_t count) {
  if (values.size() != count) {
    throw InputError(member(joint, what), fmt::format("{} values", values.size()),
                     fmt::format("must have {}", count));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(values[i])) continue;
    throw InputError(member(joint, fmt::format("{}[{}]", what, i).c_str()), values[i],
                     "must be finite");
  }
}

void check_shortening(const StructuralJoint& joint, const ModalModel& linear) {
  if (joint.shortening.empty()) return;
  const std::size_t modes = linear.size();
  require_values(joint, "shortening", joint.shortening, modes * modes);
  for (std::size_t i = 0; i < modes; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double here = joint.shortening[i * modes + j];
      const double mirrored = joint.shortening[j * modes + i];
      if (std::abs(here - mirrored) <= 1e-9 * (std::abs(here) + std::abs(mirrored))) continue;
      throw InputError(member(joint, fmt::format("shortening[{}, {}]", i, j).c_str()), here,
                       fmt::format("must be that of [{}, {}], {}", j, i, mirrored));
    }
    if (linear.modes()[i].angular_frequency > 0.0) continue;
    throw InputError(fmt::format("angular_frequency[{}]", i), 0.0,
                     fmt::format("must be positive where joint '{}' shortens", joint.name),
                     "Take the modes with a spring across the joint and give spring_in_modes.");
  }
}

void check_joints(const std::vector<StructuralJoint>& joints, const ModalModel& linear) {
  for (auto joint = joints.begin(); joint != joints.end(); ++joint) {
    const auto same = std::find_if(joints.begin(), joint, [&](const StructuralJoint& other) {
      return other.name == joint->name;
    });
    if (joint->name.empty() || same != joint) {
      throw InputError("name of a joint", fmt::format("'{}'", joint->name),
                       "must not be empty, and no two the same");
    }
    require_values(*joint, "shape", joint->shape, linear.size());
    require_non_negative(*joint, "spring_in_modes", joint->spring_in_modes);
    require_non_negative(*joint, "series_compliance", joint->series_compliance);
    require_non_negative(*joint, "linear_damping", joint->linear_damping);
    check_shortening(*joint, linear);
  }
}

/// diag(ω_i²) + Σ_j (k_j − k_s,j) ψ_j ψ_jᵀ with stiffnesses k of the joints.
template <typename Stiffness>
Eigen::MatrixXd stiffness_matrix(const ModalModel& linear,
                                 const std::vector<StructuralJoint>& joints, Stiffness stiffness) {
  const auto modes = static_cast<Index>(linear.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(modes, modes);
  for (Index i = 0; i < modes; ++i) {
    const double natural = linear.modes()[static_cast<std::size_t>(i)].angular_frequency;
    matrix(i, i) = natural * natural;
  }
  for (const StructuralJoint& joint : joints) {
    const Eigen::Map<const Eigen::VectorXd> shape(joint.shape.data(), modes);
    matrix += (stiffness(joint) - joint.spring_in_modes) * shape * shape.transpose();
  }
  return matrix;
}

/// A share of k with the compliance in series, N/m.
double with_compliance(const StructuralJoint& joint, double share) {
  const double k = share * joint.joint.stiffness();
  return k / (1.0 + k * joint.series_compliance);
}

double stuck_stiffness(const StructuralJoint& joint) { return joint.stuck_stiffness(); }

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

/// @throws InputError  where each spring alone could be in the modes, as they are not together.
/// @param most  the largest eigenvalue of spring_shares().
[[noreturn]] void refuse_springs_together(const std::vector<StructuralJoint>& joints, double most) {
  std::string names;
  std::string values;
  for (const StructuralJoint& joint : joints) {
    if (joint.spring_in_modes == 0.0) continue;
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", joint.name);
    values += fmt::format("{}{:g}", values.empty() ? "" : ", ", joint.spring_in_modes);
  }
  throw InputError("spring_in_modes of joints " + names, values + " N/m",
                   fmt::format("must be in the modes together: without all of them the structure "
                               "is unstable; they contain {:.6g} % of these stiffnesses at most",
                               100.0 / most),
                   "Give the stiffnesses of the joints that the modes were computed with.");
}

/// @param most  that the modes can contain of it, N/m.
[[noreturn]] void refuse_spring(const StructuralJoint& joint, double most) {
  throw InputError(member(joint, "spring_in_modes"), fmt::format("{:g} N/m", joint.spring_in_modes),
                   fmt::format("must be in the modes: without it the structure is unstable; they "
                               "contain {:.6g} N/m at most",
                               most),
                   "Give the stiffness of the joint that the modes were computed with.");
}

/// The largest k ψ_i² of the modes without frequency, which contain no spring, rad²/s².
double held_without_stiffness(const StructuralJoint& joint, std::span<const Mode> modes) {
  double most = 0.0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].angular_frequency > 0.0) continue;
    most = std::max(most, joint.spring_in_modes * joint.shape[i] * joint.shape[i]);
  }
  return most;
}

/// The stiffness without the springs of the joints must not be negative.
void check_springs(const std::vector<StructuralJoint>& joints, const ModalModel& linear) {
  constexpr double kRounding = 1e-6;  // of the stiffest mode; modes may be measured
  const Eigen::VectorXd squares =
      eigenvalues(stiffness_matrix(linear, joints, [](const auto&) { return 0.0; }));
  if (squares.minCoeff() >= -kRounding * squares.cwiseAbs().maxCoeff()) return;
  const auto held = [&](const StructuralJoint& joint) {
    return held_without_stiffness(joint, linear.modes());
  };
  const StructuralJoint& loosest = *std::ranges::max_element(joints, {}, held);
  if (held(loosest) > 0.0) refuse_spring(loosest, 0.0);
  const Eigen::MatrixXd shares = spring_shares(linear.modes(), joints);
  const double together = eigenvalues(shares).maxCoeff();
  if (together <= 1.0 + kSpringTolerance) return;
  Index most = 0;
  if (shares.diagonal().maxCoeff(&most) <= 1.0) refuse_springs_together(joints, together);
  const StructuralJoint& stiffest = joints[static_cast<std::size_t>(most)];
  refuse_spring(stiffest, stiffest.spring_in_modes / shares(most, most));
}

void check_excitations(const std::vector<Excitation>& excitations, const ModalModel& linear) {
  bool drives = false;
  for (const Excitation& excitation : excitations) {
    (void)linear.load(excitation.point);  // throws where there is none
    if (linear.is_base(excitation.point) != linear.is_base(excitations.front().point)) {
      throw InputError(
          fmt::format("excitation at '{}'", excitation.point),
          fmt::format("with one at '{}'", excitations.front().point),
          "must be a force where the others are forces, and the acceleration of a base "
          "where they are accelerations");
    }
    for (std::size_t i = 0; i < excitation.harmonics.size(); ++i) {
      const std::complex<double> value = excitation.harmonics[i];
      if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) {
        throw InputError(
            fmt::format("harmonic {} of the excitation at '{}'", i + 1, excitation.point),
            "not a number", "must be finite");
      }
      drives = drives || value != 0.0;
    }
  }
  if (!drives) {
    throw InputError("number of excitations", static_cast<double>(excitations.size()),
                     "must be at least 1, and one of their harmonics not 0");
  }
}

void check_static_loads(const std::vector<StaticLoad>& loads, const ModalModel& linear) {
  for (const StaticLoad& load : loads) {
    (void)linear.load(load.place);  // throws where there is none
    if (std::isfinite(load.value)) continue;
    throw InputError(fmt::format("static load at '{}'", load.place), load.value, "must be finite");
  }
}

}  // namespace

double StructuralJoint::stuck_stiffness() const { return with_compliance(*this, 1.0); }

JointedStructure::JointedStructure(ModalModel linear, std::vector<StructuralJoint> joints,
                                   std::vector<Excitation> excitations, DampingLaw damping,
                                   std::vector<StaticLoad> static_loads)
    : linear_(std::move(linear)),
      joints_(std::move(joints)),
      excitations_(std::move(excitations)),
      damping_(damping),
      static_loads_(std::move(static_loads)) {
  check_joints(joints_, linear_);
  check_springs(joints_, linear_);
  check_excitations(excitations_, linear_);
  check_static_loads(static_loads_, linear_);
}

bool JointedStructure::base_driven() const { return linear_.is_base(excitations_.front().point); }

std::vector<double> JointedStructure::static_modal_load() const {
  std::vector<double> sum(linear_.size(), 0.0);
  for (const StaticLoad& load : static_loads_) {
    const std::span<const double> shape = linear_.load(load.place);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += shape[i] * load.value;
  }
  return sum;
}

JointedStructure JointedStructure::with_joints(std::vector<StructuralJoint> joints) const {
  return {linear_, std::move(joints), excitations_, damping_, static_loads_};
}

bool JointedStructure::shortens() const {
  return std::ranges::any_of(joints_, [](const auto& joint) { return !joint.shortening.empty(); });
}

std::size_t JointedStructure::excited_harmonics() const {
  std::size_t most = 0;
  for (const Excitation& excitation : excitations_) {
    for (std::size_t i = 0; i < excitation.harmonics.size(); ++i) {
      if (excitation.harmonics[i] != 0.0) most = std::max(most, i + 1);
    }
  }
  return most;
}

std::vector<double> JointedStructure::stuck_frequencies() const {
  std::vector<double> result;
  for (const double square : eigenvalues(stiffness_matrix(linear_, joints_, stuck_stiffness))) {
    result.push_back(std::sqrt(std::max(square, 0.0)));
  }
  result.resize(linear_.vibrations());  // static modes are the stiffest
  return result;
}

std::vector<double> JointedStructure::stuck_mode(std::size_t mode) const {
  if (mode >= linear_.vibrations()) {
    throw InputError("mode", static_cast<double>(mode), "must be below the number of modes");
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness_matrix(linear_, joints_, stuck_stiffness));
  const Eigen::VectorXd shape = solver.eigenvectors().col(static_cast<Index>(mode));
  return {shape.begin(), shape.end()};
}

SoftenedModes JointedStructure::softened_modes(std::span<const double> shares) const {
  if (shares.size() != joints_.size()) {
    throw InputError("shares of stiffness", fmt::format("{}", shares.size()),
                     fmt::format("must be one per joint, {}", joints_.size()));
  }
  const auto stiffness = [&](const StructuralJoint& joint) {
    return with_compliance(joint, shares[static_cast<std::size_t>(&joint - joints_.data())]);
  };
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness_matrix(linear_, joints_, stiffness));
  SoftenedModes modes;
  for (Index i = 0; i < solver.eigenvalues().size(); ++i) {
    const Eigen::VectorXd shape = solver.eigenvectors().col(i);
    modes.angular_frequency.push_back(std::sqrt(std::max(solver.eigenvalues()(i), 0.0)));
    modes.shape.emplace_back(shape.begin(), shape.end());
  }
  return modes;
}

}  // namespace microslip
