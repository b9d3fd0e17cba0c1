// SPDX-License-Identifier: MIT
#include "microslip/observe/record_force.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace microslip {
namespace {

/// Contribution of the stretches behind a row.
double force_behind(const std::vector<PathStretch>& turns, const Joint& joint) {
  double force = 0.0;
  for (const PathStretch& turn : turns) {
    force += turn.coefficient * joint.virgin_force(turn.half_range);
  }
  return force;
}

/// Contribution of the stretch of a row, at a displacement offset from its mean.
double force_on(const PathRow& row, double more, const Joint& joint) {
  const double c = row.last.coefficient;
  if (std::abs(c) == 1.0) return joint.virgin_force(row.displacement + more);
  // The half range goes as the path over its coefficient.
  return c * joint.virgin_force(std::max(0.0, row.last.half_range + more / c));
}

/// Mean of the path over a row.
double mean_of(const std::vector<double>& path, const PathRow& row) {
  double sum = 0.0;
  for (std::size_t i = row.first; i < row.first + row.count; ++i) sum += path[i];
  return sum / static_cast<double>(row.count);
}

/// u̇ at a sample, m per sample.
double velocity_at(const std::vector<double>& path, std::size_t i) {
  const std::size_t before = i == 0 ? 0 : i - 1;
  const std::size_t after = std::min(path.size() - 1, i + 1);
  return (path[after] - path[before]) / static_cast<double>(after - before);
}

/// Mean of measured less found over each group of rows.
std::vector<double> offsets_of(const RecordEvidence& evidence, const std::vector<double>& found) {
  std::vector<double> sum(evidence.rows().groups, 0.0);
  std::vector<double> count(evidence.rows().groups, 0.0);
  for (const PathRow& row : evidence.rows().rows) {
    for (std::size_t i = row.first; i < row.first + row.count; ++i) {
      sum[row.group] += evidence.measured().force[i] - found[i];
    }
    count[row.group] += static_cast<double>(row.count);
  }
  for (std::size_t g = 0; g < sum.size(); ++g) sum[g] /= count[g];
  return sum;
}

}  // namespace

std::vector<double> found_force(const RecordEvidence& evidence, const Joint& joint,
                                double viscous) {
  const std::vector<double>& path = evidence.path().displacement;
  const PathRows& rows = evidence.rows();
  const double step = evidence.measured().time_step;
  const double damping = step > 0.0 ? viscous / step : 0.0;
  std::vector<double> found(path.size(), std::numeric_limits<double>::quiet_NaN());
  std::optional<std::size_t> turns;  // that `behind` belongs to
  double behind = 0.0;
  for (const PathRow& row : rows.rows) {
    if (turns != row.turns) {
      turns = row.turns;
      behind = force_behind(rows.turns[row.turns], joint);
    }
    const double mean = mean_of(path, row);
    for (std::size_t i = row.first; i < row.first + row.count; ++i) {
      found[i] = behind + force_on(row, path[i] - mean, joint) + damping * velocity_at(path, i);
    }
  }
  const std::vector<double> offset = offsets_of(evidence, found);
  for (const PathRow& row : rows.rows) {
    for (std::size_t i = row.first; i < row.first + row.count; ++i) found[i] += offset[row.group];
  }
  return found;
}

double rms_of_known(const std::vector<double>& measured, const std::vector<double>& found) {
  double count = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!std::isfinite(found[i])) continue;
    count += 1.0;
    const double before = measured[i] - mean;
    mean += before / count;
    square += before * (measured[i] - mean);
  }
  return count > 0.0 ? std::sqrt(square / count) : 0.0;
}

double unexplained_share(const std::vector<double>& measured, const std::vector<double>& found) {
  double count = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!std::isfinite(found[i])) continue;
    count += 1.0;
    square += (measured[i] - found[i]) * (measured[i] - found[i]);
  }
  return std::sqrt(square / count) / rms_of_known(measured, found);
}

}  // namespace microslip
