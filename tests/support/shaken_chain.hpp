// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/dynamics/jointed_structure.hpp"

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

  [[nodiscard]] Joint joint() const {
    return {stiffness, SlipDensity({AtomsPart{slip_force, weight}})};
  }

  /// By modes relative to the support, all three, with the base "table" that it is: ζ_i = ½ dashpot
  /// ω_i.
  /// @param driven  a point "m1", "m2", "m3", or the base "table".
  [[nodiscard]] JointedStructure modal(const std::string& driven,
                                       std::vector<StaticLoad> static_loads = {}) const {
    Eigen::Matrix3d k;
    k << spring[0] + spring[1], -spring[1], 0.0,        //
        -spring[1], spring[1] + spring[2], -spring[2],  //
        0.0, -spring[2], spring[2];
    const Eigen::Vector3d m(mass.data());
    const Eigen::Matrix3d root = m.cwiseSqrt().cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(root * k * root);
    const Eigen::Matrix3d shapes = root * eigen.eigenvectors();
    std::vector<Mode> modes;
    std::vector<ModalPoint> points(3);
    ModalBase base{"table", {}, {1.0, 1.0, 1.0}};
    std::vector<double> across;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double omega = std::sqrt(eigen.eigenvalues()(i));
      modes.push_back({omega, dashpot * omega});
      base.participation.push_back(shapes.col(i).dot(m));
      across.push_back(shapes(1, i) - shapes(0, i));
    }
    for (Eigen::Index p = 0; p < 3; ++p) {
      points[static_cast<std::size_t>(p)].name = "m" + std::to_string(p + 1);
      const Eigen::RowVector3d row = shapes.row(p);
      points[static_cast<std::size_t>(p)].shape = {row.begin(), row.end()};
    }
    return {ModalModel(std::move(modes), std::move(points), {std::move(base)}),
            {{.name = "lap", .joint = joint(), .shape = across}},
            {{driven}},
            DampingLaw::kViscous,
            std::move(static_loads)};
  }

  /// What acts at a time.
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
  /// the way u to there at once. Sliders move one way in a stage, so that the error of a reversal
  /// is of the order h².
  /// @param every  told of the state at the end of each step.
  void integrate(const Loads& loads, State state, double end, double h,
                 const std::function<void(double, const State&)>& every) const {
    std::vector<double> slider(slip_force.size(), 0.0);
    double u = 0.0;
    pull(slider, u, state.x[1] - state.x[0]);
    const auto steps = static_cast<std::size_t>(std::llround(end / h));
    for (std::size_t n = 0; n < steps; ++n) {
      const double t = static_cast<double>(n) * h;
      std::array<std::array<double, 3>, 4> dx{};
      std::array<std::array<double, 3>, 4> dv{};
      constexpr std::array<double, 4> kAt{0.0, 0.5, 0.5, 1.0};
      for (std::size_t stage = 0; stage < 4; ++stage) {
        std::array<double, 3> x = state.x;
        std::array<double, 3> v = state.v;
        for (std::size_t i = 0; stage > 0 && i < 3; ++i) {
          x[i] += kAt[stage] * h * dx[stage - 1][i];
          v[i] += kAt[stage] * h * dv[stage - 1][i];
        }
        dx[stage] = v;
        std::vector<double> tried = slider;
        double at = u;
        dv[stage] = accelerations(x, v, pull(tried, at, x[1] - x[0]), loads(t + kAt[stage] * h));
      }
      for (std::size_t i = 0; i < 3; ++i) {
        state.x[i] += h / 6.0 * (dx[0][i] + 2.0 * dx[1][i] + 2.0 * dx[2][i] + dx[3][i]);
        state.v[i] += h / 6.0 * (dv[0][i] + 2.0 * dv[1][i] + 2.0 * dv[2][i] + dv[3][i]);
      }
      state.joint_force = pull(slider, u, state.x[1] - state.x[0]);
      state.a = accelerations(state.x, state.v, state.joint_force, loads(t + h));
      every(t + h, state);
    }
  }

 private:
  /// Moves the sliders on. @return their force with the elastic rest, N.
  double pull(std::vector<double>& slider, double& u, double to) const {
    double elastic = 1.0;
    double force = 0.0;
    for (std::size_t s = 0; s < slider.size(); ++s) {
      slider[s] += stiffness * weight[s] * (to - u);
      const double most = weight[s] * slip_force[s];
      slider[s] = std::clamp(slider[s], -most, most);
      force += slider[s];
      elastic -= weight[s];
    }
    u = to;
    return force + elastic * stiffness * u;
  }

  [[nodiscard]] std::array<double, 3> accelerations(const std::array<double, 3>& x,
                                                    const std::array<double, 3>& v,
                                                    double joint_force,
                                                    const Acting& acting) const {
    const auto pulls = [&](std::size_t s, double stretch, double rate) {
      return spring[s] * (stretch + dashpot * rate);
    };
    const double foot = pulls(0, x[0] - acting.support, v[0] - acting.support_velocity);
    const double middle = pulls(1, x[1] - x[0], v[1] - v[0]) + joint_force;
    const double top = pulls(2, x[2] - x[1], v[2] - v[1]);
    return {(acting.force[0] + middle - foot) / mass[0], (acting.force[1] + top - middle) / mass[1],
            (acting.force[2] - top) / mass[2]};
  }
};

}  // namespace microslip::testing
