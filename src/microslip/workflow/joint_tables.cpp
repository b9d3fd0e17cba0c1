// SPDX-License-Identifier: MIT
#include "microslip/workflow/joint_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "microslip/io/csv_writer.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/joint/memory.hpp"
#include "microslip/joint/secant.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/provenance.hpp"

namespace microslip {
namespace {

/// Constant normal load has an exact memory; a varying one needs elements that are marched.
std::vector<double> forces_along(const DisplacementPath& path, const Joint& joint,
                                 NormalLoadLaw law, std::size_t elements) {
  std::vector<double> force(path.displacement.size());
  if (path.normal_load.empty()) {
    Memory(joint).march(path.displacement, force);
    return force;
  }
  const JenkinsNetwork network = JenkinsNetwork::discretise(joint, elements);
  NetworkMemory(network, law).march(path.displacement, path.normal_load, force);
  return force;
}

/// Sliders slip that lie below k times the farthest displacement, as in a cycle of that amplitude.
double farthest(const DisplacementPath& path) {
  double result = 0.0;
  for (const double x : path.displacement) result = std::max(result, std::abs(x));
  return result;
}

/// A loss of βA² whatever the frequency is known for harmonics alone.
std::optional<Warning> damping_warning(const JointFile& file) {
  const double beta = identified_damping(file).value_or(0.0);
  if (beta == 0.0) return std::nullopt;
  return Warning{
      "linear_damping_left_out",
      fmt::format("The joint was identified with a linear damping of {}, which is not in "
                  "the force: a loss that grows with the square of the amplitude and does "
                  "not depend on the rate has no force along a path. Per cycle of "
                  "amplitude A the joint loses {:.6g} J/m^2 A^2 more than the area of "
                  "the loop.",
                  damping_text(beta), beta)};
}

/// D and the loss factor are those of slip and linear damping together, as levels have them.
CsvWriter dissipation_table(const JointFile& file, const std::vector<double>& amplitude) {
  const Joint& joint = file.joint;
  const double beta = identified_damping(file).value_or(0.0);
  std::vector<double> force;
  std::vector<double> energy;
  std::vector<double> secant;
  std::vector<double> loss;
  std::vector<double> linear;
  for (const double a : amplitude) {
    force.push_back(joint.virgin_force(a));
    linear.push_back(beta * a * a);
    energy.push_back(dissipation(joint, a) + linear.back());
    secant.push_back(secant_stiffness(joint, a));
    loss.push_back(loss_factor(joint, a) + beta / (std::numbers::pi * secant.back()));
  }
  CsvWriter table;
  if (beta > 0.0) table.add_comment("linear damping of the joint: " + damping_text(beta));
  table.add_numbers("amplitude", kLength, amplitude);
  table.add_numbers("force", kForce, force);
  table.add_numbers("dissipation", kEnergy, energy);
  table.add_numbers("secant_stiffness", kStiffness, secant);
  table.add_numbers("loss_factor", kDimensionless, loss);
  if (beta > 0.0) table.add_numbers("joint_linear_dissipation", kEnergy, linear);
  return table;
}

JointTable with_comments(CsvWriter table, std::vector<Warning> warnings) {
  add_warnings(warnings, table);
  return {table.str(), std::move(warnings)};
}

}  // namespace

std::vector<double> loading_and_cycle(double amplitude, std::size_t points) {
  std::vector<double> x;
  x.reserve(3 * points + 1);
  const auto branch = [&](double from, double to) {
    for (std::size_t i = 1; i <= points; ++i) {
      x.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(points));
    }
  };
  x.push_back(0.0);
  branch(0.0, amplitude);
  branch(amplitude, -amplitude);
  branch(-amplitude, amplitude);
  return x;
}

JointTable loop_of(const JointFile& file, const DisplacementPath& path, NormalLoadLaw law,
                   std::size_t elements) {
  std::vector<Warning> warnings = reach_warnings(file, farthest(path));
  if (const auto warning = damping_warning(file)) warnings.push_back(*warning);
  return with_comments(loop_table(path, forces_along(path, file.joint, law, elements)),
                       std::move(warnings));
}

JointTable dissipation_of(const JointFile& file, const std::vector<double>& amplitude) {
  return with_comments(dissipation_table(file, amplitude), reach_warnings(file, amplitude.back()));
}

}  // namespace microslip
