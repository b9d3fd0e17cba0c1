// SPDX-License-Identifier: MIT
#include "microslip/io/march_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"

namespace microslip {
namespace {

std::size_t finite_prefix(const std::vector<double>& values) {
  const auto end = std::ranges::find_if(values, [](double x) { return !std::isfinite(x); });
  return static_cast<std::size_t>(end - values.begin());
}

void add_energies(const MarchEnergy& energy, CsvWriter& table) {
  table.add_comment(
      fmt::format("energy: input {:.9g} J, linear_dissipation {:.9g} J, initial {:.9g} J, kinetic "
                  "{:.9g} J, elastic {:.9g} J, imbalance {:.3g}",
                  energy.input, energy.linear_dissipation, energy.initial, energy.kinetic,
                  energy.elastic, energy.imbalance()));
  for (const JointEnergy& joint : energy.joints) {
    table.add_comment(fmt::format("energy of joint '{}': dissipation {:.9g} J, stored {:.9g} J",
                                  joint.joint, joint.dissipation, joint.stored));
  }
}

/// The values at the recorded times.
std::vector<double> recorded(const std::vector<double>& values, std::size_t every,
                             std::size_t count) {
  std::vector<double> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(values[std::min(i * every, values.size() - 1)]);
  }
  return result;
}

}  // namespace

std::size_t finite_records(const MarchResult& result) {
  std::size_t count = result.time.size();
  for (const PointMotion& point : result.points) {
    for (const auto* values : {&point.displacement, &point.velocity, &point.acceleration}) {
      count = std::min(count, finite_prefix(*values));
    }
  }
  for (const JointMotion& joint : result.joints) {
    count = std::min({count, finite_prefix(joint.displacement), finite_prefix(joint.force)});
  }
  return count;
}

CsvWriter march_table(const MarchResult& result, const LoadHistory& loads, std::size_t every,
                      std::string_view heading) {
  const std::size_t count = finite_records(result);
  CsvWriter table;
  const auto add = [&](std::string_view name, const Dimension& dimension,
                       const std::vector<double>& values) {
    table.add_numbers(name, dimension, std::span(values).first(count));
  };
  if (!heading.empty()) table.add_comment(heading);
  const Summary& s = result.summary;
  table.add_comment(
      fmt::format("{}: {}: {}", s.method, s.converged() ? "converged" : "NOT CONVERGED", s.reason));
  add_energies(result.energy, table);
  add("time", kTime, result.time);
  for (const PointForce& at : loads.forces) {
    const bool alone = loads.forces.size() == 1;
    add(alone ? "force" : fmt::format("force at {}", at.point), kForce,
        recorded(at.force, every, count));
  }
  for (const PointMotion& point : result.points) {
    add("displacement", kLength, point.displacement);
    add("velocity", kVelocity, point.velocity);
    add("acceleration", kAcceleration, point.acceleration);
  }
  for (const JointMotion& joint : result.joints) {
    add(fmt::format("{} displacement", joint.joint), kLength, joint.displacement);
    add(fmt::format("{} force", joint.joint), kForce, joint.force);
  }
  return table;
}

}  // namespace microslip
