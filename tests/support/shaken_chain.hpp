// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "microslip/dynamics/structure/jointed_structure.hpp"

/// @file Three masses on a shaken support, in physical coordinates that stand still: an integration
/// that knows no modes, no participation and no memory of a joint but its sliders.

namespace microslip::testing {

/// support –k₀– m₁ –joint and spring k₁– m₂ –k₂– m₃, with dashpots beside the springs that make the
/// damping matrix a multiple of the stiffness matrix.
struct ShakenChain {
  std::array<double, 3> mass{2.0, 1.0, 0.5};          // kg
  std::array<double, 3> spring{4.0e4, 6.0e3, 9.0e3};  // N/m
  double dashpot = 2.0e-4;                            // over the stiffness, s
  double stiffness = 1.2e4;                           // k of the joint between m₁ and m₂, N/m
  std::vector<double> slip_force{0.3, 0.9, 2.0, 4.0, 9.0};  // N
  std::vector<double> weight{0.12, 0.2, 0.25, 0.2, 0.13};   // of k; the rest is elastic

  [[nodiscard]] Joint joint() const;

  /// By modes relative to the support, all three, with the base "table" that it is: ζ_i = ½ dashpot
  /// ω_i.
  /// @param driven  a point "m1", "m2", "m3", or the base "table".
  [[nodiscard]] JointedStructure modal(const std::string& driven,
                                       std::vector<StaticLoad> static_loads = {}) const;

  /// Load at a time.
  struct Acting {
    double support = 0.0;           // displacement, m
    double support_velocity = 0.0;  // m/s
    std::array<double, 3> force{};  // N
  };
  using Loads = std::function<Acting(double)>;

  struct State {
    std::array<double, 3> x{};  // absolute, m
    std::array<double, 3> v{};
    std::array<double, 3> a{};
    double joint_force = 0.0;
  };

  /// RK4 with steps of h from the state given and virgin sliders, or those that were pulled along
  /// the displacement u to there at once. Sliders move in one direction in a stage, so that the
  /// error of a reversal is of the order h².
  /// @param every  called with the state at the end of each step.
  void integrate(const Loads& loads, State state, double end, double h,
                 const std::function<void(double, const State&)>& every) const;

 private:
  /// Moves the sliders on. @return their force with the elastic rest, N.
  double pull(std::vector<double>& slider, double& u, double to) const;

  [[nodiscard]] std::array<double, 3> accelerations(const std::array<double, 3>& x,
                                                    const std::array<double, 3>& v,
                                                    double joint_force, const Acting& acting) const;
};

}  // namespace microslip::testing
