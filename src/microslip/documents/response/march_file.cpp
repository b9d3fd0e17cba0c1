// SPDX-License-Identifier: MIT
#include "microslip/documents/response/march_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/documents/response/load_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/cells/csv_cells.hpp"
#include "microslip/io/cells/warning_comment.hpp"
#include "microslip/io/output/table_stream.hpp"

namespace microslip {
namespace {

/// Comments on a march, without their marks.
std::vector<std::string> comments_on(const MarchResult& result) {
  const Summary& s = result.summary;
  const MarchEnergy& energy = result.energy;
  std::vector<std::string> lines{
      fmt::format("{}: {}: {}", s.method, s.converged() ? "converged" : "NOT CONVERGED", s.reason)};
  if (result.error_estimate) {
    lines.push_back(fmt::format("estimated error of the displacements: {:.2g} of the largest",
                                *result.error_estimate));
  }
  lines.push_back(fmt::format(
      "energy: input {:.9g} J, linear_dissipation {:.9g} J, initial {:.9g} J, kinetic {:.9g} J, "
      "elastic {:.9g} J, imbalance {:.3g}",
      energy.input, energy.linear_dissipation, energy.initial, energy.kinetic, energy.elastic,
      energy.imbalance()));
  for (const JointEnergy& joint : energy.joints) {
    lines.push_back(fmt::format("energy of joint '{}': dissipation {:.9g} J, stored {:.9g} J",
                                joint.joint, joint.dissipation, joint.stored));
    if (joint.linear_dissipation == 0.0) continue;
    lines.back() += fmt::format(", linear_dissipation {:.9g} J", joint.linear_dissipation);
  }
  for (const Warning& warning : result.warnings) lines.push_back(warning_comment(warning));
  return lines;
}

std::string comment_lines(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) append_comment(lines, text);
  return lines;
}

std::string header_line(const JointedStructure& structure, const LoadHistory& loads,
                        bool with_band) {
  std::string line;
  const auto add = [&](std::string_view name, const Dimension& dimension) {
    check_column_name(name);
    if (!line.empty()) line += ',';
    append_text_cell(line, fmt::format("{} [{}]", name, si_unit(dimension)));
  };
  add("time", kTime);
  for (const PointForce& at : loads.forces) {
    const TableColumn column = load_column(structure, loads, at);
    add(column.name, column.dimension);
  }
  const std::vector<TableColumn> columns = march_columns(structure, loads);
  for (const TableColumn& column : columns) add(column.name, column.dimension);
  for (const TableColumn& column : columns) {
    if (!with_band) break;
    add(column.name + "_lower", column.dimension);
    add(column.name + "_upper", column.dimension);
  }
  return line + '\n';
}

bool moves_a_base(const JointedStructure& structure, const LoadHistory& loads) {
  return std::ranges::any_of(
      loads.forces, [&](const PointForce& at) { return structure.linear().is_base(at.point); });
}

}  // namespace

std::vector<TableColumn> march_columns(const JointedStructure& structure,
                                       const LoadHistory& loads) {
  std::vector<TableColumn> columns{
      {"displacement", kLength}, {"velocity", kVelocity}, {"acceleration", kAcceleration}};
  for (const StructuralJoint& joint : structure.joints()) {
    columns.push_back({fmt::format("{} displacement", joint.name), kLength});
    columns.push_back({fmt::format("{} force", joint.name), kForce});
  }
  if (!moves_a_base(structure, loads)) return columns;
  columns.push_back({"absolute_displacement", kLength});
  columns.push_back({"absolute_velocity", kVelocity});
  columns.push_back({"absolute_acceleration", kAcceleration});
  return columns;
}

MarchTable::MarchTable(const std::string& path, const JointedStructure& structure,
                       const LoadHistory& loads, std::string_view heading, bool with_band)
    : loads_(loads),
      stream_(std::make_unique<TableStream>(
          path, heading.empty() ? std::string() : comment_lines({std::string(heading)}),
          header_line(structure, loads, with_band))) {}

MarchTable::~MarchTable() = default;

void MarchTable::add(const MarchRow& row, std::span<const double> band) {
  line_.clear();
  const auto put = [&](double value) {
    finite_ = finite_ && std::isfinite(value);
    if (!line_.empty()) line_ += ',';
    append_number(line_, value);
  };
  put(row.time);
  for (const PointForce& at : loads_.forces) put(at.force[row.index]);
  put(row.displacement[0]);
  put(row.velocity[0]);
  put(row.acceleration[0]);
  for (std::size_t j = 0; j < row.joint_displacement.size(); ++j) {
    put(row.joint_displacement[j]);
    put(row.joint_force[j]);
  }
  if (!row.absolute_displacement.empty()) {
    put(row.absolute_displacement[0]);
    put(row.absolute_velocity[0]);
    put(row.absolute_acceleration[0]);
  }
  for (const double edge : band) put(edge);
  line_ += '\n';
  if (finite_) stream_->add(line_);
}

void MarchTable::finish(const MarchResult& result) {
  stream_->finish(comment_lines(comments_on(result)));
}

}  // namespace microslip
