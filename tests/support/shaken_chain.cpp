// SPDX-License-Identifier: MIT
#include "support/shaken_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"

namespace microslip::testing {

Joint ShakenChain::joint() const {
  return {stiffness, SlipDensity({AtomsPart{slip_force, weight}})};
}

JointedStructure ShakenChain::modal(const std::string& driven,
                                    std::vector<StaticLoad> static_loads) const {
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

void ShakenChain::integrate(const Loads& loads, State state, double end, double h,
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

double ShakenChain::pull(std::vector<double>& slider, double& u, double to) const {
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

std::array<double, 3> ShakenChain::accelerations(const std::array<double, 3>& x,
                                                 const std::array<double, 3>& v, double joint_force,
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

}  // namespace microslip::testing
