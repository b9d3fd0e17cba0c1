// SPDX-License-Identifier: MIT
#include "support/force_records.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace microslip::testing {

ForceRecord reference_record(const std::string& name) {
  const ReferenceTable table = reference_table("force_records/" + name + ".csv");
  ForceRecord record;
  for (const double um : table["displacement [um]"]) record.displacement.push_back(1e-6 * um);
  record.force = table["force [N]"];
  record.time_step = table["time [s]"].back() / static_cast<double>(table.rows() - 1);
  return record;
}

Joint record_joint() {
  return read_joint(std::string(MICROSLIP_TEST_DATA) + "/force_records/joint.json").joint;
}

std::vector<double> forces_on(const Joint& joint, const std::vector<double>& path) {
  Memory memory(joint);
  std::vector<double> force;
  for (const double x : path) {
    memory.advance(x);
    force.push_back(memory.force());
  }
  return force;
}

std::vector<double> random_motion(std::size_t count, double largest, std::uint64_t seed,
                                  std::size_t finer) {
  constexpr int kSines = 20;
  RandomStream random(seed, 77);
  std::vector<double> path(count * finer, 0.0);
  for (int j = 0; j < kSines; ++j) {
    const double cycles = (0.001 + 0.014 * random.uniform()) / static_cast<double>(finer);
    const double phase = 2.0 * std::numbers::pi * random.uniform();
    for (std::size_t i = 0; i < path.size(); ++i) {
      path[i] += std::sin(2.0 * std::numbers::pi * cycles * static_cast<double>(i) + phase) -
                 std::sin(phase);
    }
  }
  double most = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i] *= std::min(1.0, 5.0 * static_cast<double>(i) / static_cast<double>(path.size()));
    most = std::max(most, std::abs(path[i]));
  }
  for (double& x : path) x *= largest / most;
  return path;
}

ForceRecord simulated_record(const Joint& joint, const std::vector<double>& path,
                             std::uint64_t seed, const RecordNoise& noise, double time_step) {
  RandomStream random(seed, 78);
  ForceRecord record{path, forces_on(joint, path), time_step};
  const auto largest = [](const std::vector<double>& values) {
    const auto [low, high] = std::ranges::minmax(values);
    return std::max(-low, high);
  };
  const double u = largest(record.displacement);
  const double f = largest(record.force);
  for (double& value : record.displacement) value += noise.displacement * u * random.normal();
  for (double& value : record.force) value += f * (noise.offset + noise.force * random.normal());
  return record;
}

double error_of_density(const Joint& found, const Joint& truth, double reach) {
  double square = 0.0;
  double scale = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double f = reach * (0.05 + 0.85 * i / 1000);
    const double expected = truth.density().density(f);
    const double error = found.density().density(f) - expected;
    square += error * error;
    scale += expected * expected;
  }
  return std::sqrt(square / scale);
}

}  // namespace microslip::testing
