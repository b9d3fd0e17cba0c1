// SPDX-License-Identifier: MIT
#include "microslip/dynamics/structure/static_equilibrium.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "microslip/algebra/qr.hpp"
#include "microslip/base/error.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostNewtonSteps = 200;
constexpr int kMostStepHalvings = 40;
constexpr double kEquilibriumTolerance = 1e-12;  // of the residual, over the sum of the loads
constexpr double kEquilibriumRounding =
    1e-9;                                // good enough where the residual does not fall any more
constexpr double kNothingHolds = 1e-12;  // of the largest pivot
constexpr double kNothingLoads = 1e-6;   // of the residual: a load on what nothing holds

Eigen::Map<const VectorXd> view(const std::vector<double>& values) {
  return {values.data(), static_cast<Index>(values.size())};
}

/// u of a joint whose ends move apart by w with the compliance in series: u + cF(u) = w.
/// @param c  compliance in series, times the normal load.
double displaced(const Joint& joint, double c, double w) {
  if (c == 0.0) return w;
  double u = w / (1.0 + c * joint.stiffness());  // F is concave: from here u only grows
  for (int i = 0; i < kMostNewtonSteps; ++i) {
    const double miss = w - u - c * joint.virgin_force(u);
    const double step = miss / (1.0 + c * joint.tangent_stiffness(u));
    if (std::abs(step) <= 1e-15 * std::abs(u)) break;
    u += step;
  }
  return u;
}

class Equilibrium {
 public:
  Equilibrium(const JointedStructure& structure, std::span<const double> normal_loads)
      : structure_(structure),
        normal_loads_(normal_loads),
        load_(view(structure.static_modal_load())),
        linear_(MatrixXd::Zero(load_.size(), load_.size())) {
    for (Index i = 0; i < load_.size(); ++i) {
      const double natural =
          structure.linear().modes()[static_cast<std::size_t>(i)].angular_frequency;
      linear_(i, i) = natural * natural;
    }
    for (const StructuralJoint& joint : structure.joints()) {
      const VectorXd shape = view(joint.shape);
      linear_ -= joint.spring_in_modes * shape * shape.transpose();
    }
  }

  StaticEquilibrium find() {
    VectorXd q = VectorXd::Zero(load_.size());
    double miss = evaluate(q);
    int iterations = 0;
    while (miss > kEquilibriumTolerance * size_) {
      if (++iterations > kMostNewtonSteps) throw nothing_found();
      const VectorXd step = newton_step();
      double share = 1.0;
      double next = evaluate(q + step);
      for (int i = 0; i < kMostStepHalvings && !(next < miss); ++i) {
        share /= 2.0;
        next = evaluate(q + share * step);
      }
      if (!(next < miss)) {
        if (miss > kEquilibriumRounding * size_) throw nothing_found();
        (void)evaluate(q);
        break;
      }
      q += share * step;
      miss = next;
    }
    return {{q.begin(), q.end()}, displacement_, force_, iterations};
  }

 private:
  /// |residual| at q; keeps the state of the joints there.
  double evaluate(const VectorXd& q) {
    displacement_.clear();
    force_.clear();
    const VectorXd elastic = linear_ * q;
    residual_ = elastic - load_;
    tangent_ = linear_;
    size_ = elastic.norm() + load_.norm();
    for (std::size_t j = 0; j < structure_.joints().size(); ++j) {
      add(structure_.joints()[j], normal_loads_.empty() ? 1.0 : normal_loads_[j], q);
    }
    return residual_.norm();
  }

  void add(const StructuralJoint& joint, double normal_load, const VectorXd& q) {
    VectorXd g = view(joint.shape);
    double w = g.dot(q);
    MatrixXd shortening;
    if (!joint.shortening.empty()) {
      shortening = Eigen::Map<const MatrixXd>(joint.shortening.data(), q.size(), q.size());
      const VectorXd slope = shortening * q;
      w -= 0.5 * q.dot(slope);
      g -= slope;
    }
    const double u = displaced(joint.joint, joint.series_compliance * normal_load, w);
    const double force = normal_load * joint.joint.virgin_force(u);
    const double tangent = normal_load * joint.joint.tangent_stiffness(u);
    residual_ += force * g;
    tangent_ += tangent / (1.0 + tangent * joint.series_compliance) * g * g.transpose();
    if (shortening.size() > 0) tangent_ -= force * shortening;
    size_ += std::abs(force) * g.norm();
    displacement_.push_back(u);
    force_.push_back(force);
  }

  /// In the scale of the diagonal, for modes whose frequencies lie decades apart.
  [[nodiscard]] VectorXd newton_step() const {
    VectorXd scale = tangent_.diagonal().cwiseAbs();
    const double least = kNothingHolds * scale.maxCoeff();
    for (double& value : scale) value = 1.0 / std::sqrt(std::max(value, least));
    const MatrixXd scaled = scale.asDiagonal() * tangent_ * scale.asDiagonal();
    const VectorXd right = scale.asDiagonal() * residual_;
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors(scaled.rows(), scaled.cols());
    factors.setThreshold(kNothingHolds);
    factors.compute(scaled);
    const VectorXd solution = factors.solve(right);  // unrestrained and unloaded motions are 0
    if (!((scaled * solution - right).norm() <= kNothingLoads * right.norm())) {
      throw nothing_found();
    }
    return -(scale.asDiagonal() * solution);
  }

  [[nodiscard]] InputError nothing_found() const {
    std::string text;
    for (const StaticLoad& load : structure_.static_loads()) {
      text += fmt::format("{}{:g} {} at '{}'", text.empty() ? "" : ", ", load.value,
                          structure_.linear().is_base(load.place) ? "m/s^2" : "N", load.place);
    }
    return {"static loads", text,
            "must have an equilibrium: the structure slips without limit or floats",
            "Take smaller loads, or joints with an elastic remainder."};
  }

  const JointedStructure& structure_;
  std::span<const double> normal_loads_;
  VectorXd load_;
  MatrixXd linear_;
  VectorXd residual_;
  MatrixXd tangent_;
  double size_ = 0.0;
  std::vector<double> displacement_;
  std::vector<double> force_;
};

}  // namespace

StaticEquilibrium static_equilibrium(const JointedStructure& structure,
                                     std::span<const double> normal_loads) {
  return Equilibrium(structure, normal_loads).find();
}

}  // namespace microslip
