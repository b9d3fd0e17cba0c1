// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/modal_offsets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "microslip/algebra/eigenvalues.hpp"
#include "microslip/algebra/qr.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

/// A vibration by the stiffness that the joints have in it.
struct SecantMode {
  double square = 0.0;    ///< Ω², rad²/s²
  Eigen::VectorXd shape;  ///< over the modes, of length 1
};

Eigen::VectorXd squares_of_modes(const JointedStructure& structure) {
  const auto modes = structure.linear().modes();
  Eigen::VectorXd squares(static_cast<Eigen::Index>(modes.size()));
  std::ranges::transform(modes, squares.begin(), [](const Mode& mode) {
    return mode.angular_frequency * mode.angular_frequency;
  });
  return squares;
}

/// The mode most similar to that of the stuck structure: frequencies may cross as joints slip.
SecantMode secant_mode(const JointedStructure& structure, const StructureOffset& measured) {
  Eigen::MatrixXd stiffness = squares_of_modes(structure).asDiagonal();
  for (std::size_t j = 0; j < structure.joints().size(); ++j) {
    const StructuralJoint& joint = structure.joints()[j];
    const double own = measured.joint_stiffness.at(j);
    const Eigen::Map<const Eigen::VectorXd> shape(joint.shape.data(), stiffness.rows());
    stiffness += (own / (1.0 + own * joint.series_compliance) - joint.spring_in_modes) * shape *
                 shape.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness);
  const std::vector<double> stuck = structure.stuck_mode(measured.mode);
  const Eigen::Map<const Eigen::VectorXd> alike(stuck.data(), stiffness.rows());
  Eigen::Index most = 0;
  (solver.eigenvectors().transpose() * alike).cwiseAbs().maxCoeff(&most);
  return {solver.eigenvalues()(most), solver.eigenvectors().col(most)};
}

/// S_mi of a vibration; static modes are no part of what is off.
Eigen::RowVectorXd answer_of(const JointedStructure& structure, const SecantMode& mode) {
  Eigen::RowVectorXd row =
      (squares_of_modes(structure).array() * mode.shape.array().square() / mode.square).transpose();
  row.tail(static_cast<Eigen::Index>(structure.linear().static_modes())).setZero();
  return row;
}

}  // namespace

double secant_frequency(const JointedStructure& structure, const StructureOffset& measured) {
  return std::sqrt(secant_mode(structure, measured).square);
}

double share_of_modes(const JointedStructure& structure, const StructureOffset& measured) {
  return answer_of(structure, secant_mode(structure, measured)).sum();
}

double VibrationShares::of_modes() const {
  return std::accumulate(modes.begin(), modes.end(), 0.0);
}

double VibrationShares::without_joints() const {
  return of_modes() - std::accumulate(springs.begin(), springs.end(), 0.0);
}

VibrationShares vibration_shares(const JointedStructure& structure,
                                 const StructureOffset& measured) {
  const SecantMode mode = secant_mode(structure, measured);
  const Eigen::RowVectorXd row = answer_of(structure, mode);
  VibrationShares shares{.modes = {row.begin(), row.end()}};
  for (const StructuralJoint& joint : structure.joints()) {
    const Eigen::Map<const Eigen::VectorXd> shape(joint.shape.data(), mode.shape.size());
    const double moved = shape.dot(mode.shape);
    shares.springs.push_back(joint.spring_in_modes * moved * moved / mode.square);
  }
  return shares;
}

ModalOffsets modal_offsets(const JointedStructure& structure,
                           std::span<const StructureOffset> measured, double others,
                           std::span<const double> springs) {
  constexpr int kMostSteps = 20;
  constexpr double kSmall = 1e-10;  // of a logarithm: far below what a frequency is read to
  const auto modes = static_cast<Eigen::Index>(structure.linear().size());
  const auto count = static_cast<Eigen::Index>(measured.size());
  Eigen::VectorXd squares(count);  // before
  for (Eigen::Index m = 0; m < count; ++m) {
    squares(m) = secant_mode(structure, measured[static_cast<std::size_t>(m)]).square;
  }
  Eigen::VectorXd offset = Eigen::VectorXd::Constant(modes, others);
  const auto static_modes = static_cast<Eigen::Index>(structure.linear().static_modes());
  if (springs.empty()) offset.tail(static_modes).setZero();
  Eigen::MatrixXd by_measured = Eigen::MatrixXd::Zero(modes, count);
  Eigen::VectorXd left = Eigen::VectorXd::Ones(modes);
  double missed = count > 0 ? 1.0 : 0.0;
  for (int step = 0; step < kMostSteps && missed > kSmall; ++step) {
    const JointedStructure moved =
        with_modal_offsets(structure, {offset.data(), static_cast<std::size_t>(modes)}, springs);
    Eigen::MatrixXd answers(count, modes);
    Eigen::VectorXd off(count);
    for (Eigen::Index m = 0; m < count; ++m) {
      const StructureOffset& one = measured[static_cast<std::size_t>(m)];
      const SecantMode mode = secant_mode(moved, one);
      answers.row(m) = answer_of(moved, mode);
      off(m) = one.offset - 0.5 * std::log(mode.square / squares(m));
    }
    by_measured = answers.completeOrthogonalDecomposition().pseudoInverse();
    left = Eigen::VectorXd::Ones(modes) - (by_measured * answers).diagonal();
    missed = off.cwiseAbs().maxCoeff();
    offset += by_measured * off;
  }
  if (!(missed <= kSmall)) {
    throw InputError("offsets of frequencies", fmt::format("{:.3g} of one is left", missed),
                     "must be such that modes without joints can produce them",
                     "Check the stiffnesses of the joints and the frequencies of the model.");
  }
  left.tail(static_modes).setConstant(springs.empty() ? 0.0 : 1.0);
  ModalOffsets found{.offset = {offset.begin(), offset.end()}};
  for (Eigen::Index i = 0; i < modes; ++i) {
    const Eigen::RowVectorXd row = by_measured.row(i);
    found.by_measured.emplace_back(row.begin(), row.end());
    found.left.push_back(std::clamp(left(i), 0.0, 1.0));
  }
  return found;
}

JointedStructure with_modal_offsets(const JointedStructure& structure,
                                    std::span<const double> offset,
                                    std::span<const double> springs) {
  std::vector<Mode> modes(structure.linear().modes().begin(), structure.linear().modes().end());
  for (std::size_t i = 0; i < modes.size(); ++i) modes[i].angular_frequency *= std::exp(offset[i]);
  std::vector<StructuralJoint> joints(structure.joints().begin(), structure.joints().end());
  for (std::size_t j = 0; j < springs.size(); ++j) {
    joints[j].spring_in_modes *= std::exp(2.0 * springs[j]);
  }
  return {structure.linear().with_modes(std::move(modes)),
          std::move(joints),
          {structure.excitations().begin(), structure.excitations().end()},
          structure.damping(),
          {structure.static_loads().begin(), structure.static_loads().end()}};
}

}  // namespace microslip
