// SPDX-License-Identifier: MIT
#include "microslip/identify/records/drift_rows.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "microslip/identify/records/draw_reader.hpp"
#include "microslip/joint/memory.hpp"

namespace microslip {
namespace {

/// From τ^(p−1) of each sample to τ^p.
void raise(std::vector<double>& powers) {
  const auto last = static_cast<double>(powers.size() - 1);
  for (std::size_t i = 0; i < powers.size(); ++i) powers[i] *= static_cast<double>(i) / last;
}

/// The force of a joint along a path from its first sample, where the joint is virgin, N.
std::vector<double> force_along(const Joint& joint, std::vector<double> path) {
  Memory memory(joint);
  memory.march(path, path);
  return path;
}

}  // namespace

Eigen::VectorXd means_of_rows(const std::vector<PathRow>& rows, const std::vector<double>& values) {
  Eigen::VectorXd means(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index r = 0; r < means.size(); ++r) {
    const PathRow& row = rows[static_cast<std::size_t>(r)];
    double sum = 0.0;
    for (std::size_t i = row.first; i < row.first + row.count; ++i) sum += values[i];
    means(r) = sum / static_cast<double>(row.count);
  }
  return means;
}

Eigen::MatrixXd force_drift_rows(const SettledRecords& settled, std::size_t record,
                                 Eigen::Index terms) {
  const RecordEvidence& evidence = settled.records->records[record];
  const std::vector<PathRow>& rows = evidence.rows().rows;
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(rows.size()), terms);
  std::vector<double> powers(evidence.measured().size(), 1.0);
  for (Eigen::Index p = 0; p < terms; ++p) {
    raise(powers);
    columns.col(p) = means_of_rows(rows, powers);
  }
  return columns;
}

Eigen::MatrixXd displacement_drift_rows(const SettledRecords& settled, std::size_t record,
                                        Eigen::Index terms, double size) {
  const ScaledRecords& records = *settled.records;
  const RecordEvidence& evidence = records.records[record];
  const std::size_t count = evidence.measured().size();
  const std::vector<PathRow>& rows = evidence.rows().rows;
  const StiffnessDraw found = DrawReader(settled.model, records).read(settled.best.solution.x);
  const Joint joint =
      joint_of_stiffness_density(slip_displacements(settled), found.density, found.stiffness);
  std::vector<double> path = evidence.path().displacement;
  for (std::size_t i = count; i-- > 0;) path[i] -= path[0];
  const std::vector<double> force = force_along(joint, path);
  const double scale = 1.0 / (records.stiffness * records.length * size);
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(rows.size()), terms);
  std::vector<double> powers(count, 1.0);
  for (Eigen::Index p = 0; p < terms; ++p) {
    raise(powers);
    std::vector<double> moved = path;
    for (std::size_t i = 0; i < count; ++i) moved[i] -= size * records.length * powers[i];
    std::vector<double> change = force_along(joint, std::move(moved));
    for (std::size_t i = 0; i < count; ++i) change[i] -= force[i];
    columns.col(p) = scale * means_of_rows(rows, change);
  }
  return columns;
}

}  // namespace microslip
