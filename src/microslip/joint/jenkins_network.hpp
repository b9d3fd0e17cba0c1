// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "microslip/joint/joint.hpp"

namespace microslip {

/// One Jenkins element: a spring in series with a Coulomb slider.
struct JenkinsElement {
  double stiffness;   ///< κ, N/m; > 0
  double slip_force;  ///< of this element, N; > 0: it slips at the stretch slip_force/κ
};

/// A joint as a finite number of Jenkins elements in parallel, beside a linear spring: the model
/// that other programs march, and that a varying normal load needs. Immutable; its state is a
/// NetworkMemory.
class JenkinsNetwork {
 public:
  /// @param elements           at least one element or a spring.
  /// @param elastic_stiffness  of the spring that never slips, N/m; ≥ 0.
  /// @throws InputError  naming the element and the value that breaks a rule.
  explicit JenkinsNetwork(std::span<const JenkinsElement> elements, double elastic_stiffness = 0.0);

  /// n elements that keep the moments of a joint. Atoms are kept. The rest of the density is cut
  /// into bins of equal weight, and in each bin two elements keep Φ0, Φ1 and Φ2 of that bin: F
  /// and D of the network equal those of the joint wherever kA is at the edge of a bin, and the
  /// macro-slip force is exact. With an odd number left for the rest, one bin has a single element,
  /// which keeps Φ0 and Φ1.
  /// @param joint  any.
  /// @param n      from 1 to 1e8, and above the number of atoms where the density has more than
  ///               atoms.
  /// @throws InputError  for another n.
  static JenkinsNetwork discretise(const Joint& joint, std::size_t n);

  /// The number of elements.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// κ_i, N/m.
  [[nodiscard]] std::span<const double> stiffness() const {
    return std::span(stiffness_).first(size_);
  }

  /// The stretch at which element i slips, f_i/κ_i, m.
  [[nodiscard]] std::span<const double> slip_displacement() const {
    return std::span(slip_displacement_).first(size_);
  }

  /// N/m.
  [[nodiscard]] double elastic_stiffness() const { return elastic_stiffness_; }

 private:
  friend class NetworkMemory;

  std::size_t size_;
  std::vector<double> stiffness_;          // padded to whole groups of vector lanes
  std::vector<double> slip_displacement_;  // padded as well
  double elastic_stiffness_;
};

/// The response of an element to a varying normal load p(t) = P_N(t)/P_0 [AR14 App. B]. Its
/// stiffness and its slip force both scale with p; the laws differ in the force of a stuck element
/// when p changes. At constant p = 1 they are the same.
enum class NormalLoadLaw {
  /// ḟ = κ p ẋ while stuck, |f| ≤ f_i p: a change of load alone leaves the force of a stuck
  /// element.
  kIncremental,
  /// f = κ p (x − z) with the slider at z: the force is p times that under constant load.
  kTotal,
};

/// State of a JenkinsNetwork in one simulation, from the virgin state at x = 0.
class NetworkMemory {
 public:
  /// @param network  kept by reference; must outlive the memory.
  /// @param law      normal-load law of all its elements.
  explicit NetworkMemory(const JenkinsNetwork& network,
                         NormalLoadLaw law = NormalLoadLaw::kIncremental);
  explicit NetworkMemory(const JenkinsNetwork&&,
                         NormalLoadLaw law = NormalLoadLaw::kIncremental) = delete;

  /// Moves to x at the load p = 1. @param x  m. @return force, N.
  /// @throws InputError  where x is beyond kFarthestDisplacement (path.hpp); then no step is taken.
  double advance(double x);

  /// Moves to x while the load goes to p, both along a straight line. Within a step the incremental
  /// law takes the mean load for the stiffness and the load at its end for the slip force: of
  /// second order in the step. The total law is exact.
  /// @param x  m.
  /// @param p  1; ≥ 0.
  /// @return force, N.
  /// @throws InputError  where x is beyond it, p is not finite or p < 0; then no step is taken.
  double advance(double x, double p);

  /// A whole path; lengths equal. @throws InputError  as check_path() (see path.hpp).
  void march(std::span<const double> x, std::span<double> force);
  /// A whole path under a normal load p at each point, 1; ≥ 0.
  void march(std::span<const double> x, std::span<const double> normal_load,
             std::span<double> force);

 private:
  double move_to(double x, double p);

  const JenkinsNetwork* network_;
  NormalLoadLaw law_;
  double x_ = 0.0;
  double p_ = 1.0;
  bool load_known_ = false;  ///< the first load of a history starts it; it is no change
  double spring_ = 0.0;      ///< force of the linear spring over its stiffness, incremental law, m
  /// Total law: slider positions z_i, m. Incremental law: stretch at p = 1 that gives the present
  /// force, f_i/κ_i, m.
  std::vector<double> state_;
};

}  // namespace microslip
