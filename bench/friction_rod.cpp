// SPDX-License-Identifier: MIT
#include "friction_rod.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/random.hpp"

namespace microslip::bench {
namespace {

constexpr double kFirstFrequency = 2.0 * std::numbers::pi * 20.0;  // rad/s
constexpr double kSlipForce = 100.0;                               // N, of all joints

std::vector<double> shape_at(double place, std::size_t modes) {
  std::vector<double> shape;
  for (std::size_t i = 0; i < modes; ++i) {
    const double waves = (static_cast<double>(i) + 0.5) * std::numbers::pi;
    shape.push_back(std::numbers::sqrt2 * std::sin(waves * place));
  }
  return shape;
}

}  // namespace

JointedStructure friction_rod(std::size_t modes, std::size_t joints) {
  std::vector<Mode> of_rod;
  for (std::size_t i = 0; i < modes; ++i) {
    of_rod.push_back({kFirstFrequency * (2.0 * static_cast<double>(i) + 1.0), 0.01});
  }
  RandomStream random(1, 0);
  std::vector<StructuralJoint> placed;
  const auto count = static_cast<double>(joints);
  const double stiffness = kFirstFrequency * kFirstFrequency / count;
  for (std::size_t j = 0; j < joints; ++j) {
    const double place = (static_cast<double>(j) + random.uniform()) / count;
    const double slip = kSlipForce / count * (0.5 + random.uniform());
    placed.push_back({.name = "joint " + std::to_string(j),
                      .joint = Joint::four_parameter(slip, stiffness, -0.7 * random.uniform(), 0.0),
                      .shape = shape_at(place, modes)});
  }
  return {
      ModalModel(std::move(of_rod), {{"tip", shape_at(1.0, modes)}}), std::move(placed), {{"tip"}}};
}

}  // namespace microslip::bench
