// SPDX-License-Identifier: MIT
#include "microslip/identify/records/draw_reader.hpp"

#include <cstddef>
#include <utility>

namespace microslip {
namespace {

/// Knot behind the end of a density, over it: from there it is 0.
constexpr double kJustBeyond = 1.0 + 1e-12;

}  // namespace

DrawReader::DrawReader(const RecordModel& model, const ScaledRecords& records)
    : records_(records),
      density_(model.density_matrix() * (records.stiffness / records.length)),
      area_(records.stiffness * model.area_row()),
      elastic_(records.stiffness * model.elastic_row()),
      viscous_(records.stiffness * model.viscous_row()) {}

StiffnessDraw DrawReader::read(const Eigen::VectorXd& x) const {
  StiffnessDraw draw;
  const Eigen::VectorXd psi = density_ * x;
  draw.density.push_back(psi(0));
  draw.density.insert(draw.density.end(), psi.begin(), psi.end());
  if (records_.top < 1.0) draw.density.insert(draw.density.end(), 2, 0.0);
  draw.stiffness = records_.stiffness_known ? records_.stiffness : (area_ + elastic_).dot(x);
  draw.viscous = viscous_.dot(x);
  return draw;
}

double DrawReader::elastic(const Eigen::VectorXd& x) const {
  return records_.stiffness_known ? records_.stiffness - area_.dot(x) : elastic_.dot(x);
}

Eigen::VectorXd DrawReader::stiffness_row() const {
  if (records_.stiffness_known) return Eigen::VectorXd::Zero(area_.size());
  return area_ + elastic_;
}

Eigen::VectorXd DrawReader::elastic_row() const {
  return records_.stiffness_known ? Eigen::VectorXd(-area_) : elastic_;
}

std::vector<double> slip_displacements(const SettledRecords& settled) {
  const ScaledRecords& records = *settled.records;
  std::vector<double> all{0.0};
  for (const double s : settled.model.basis().knots()) all.push_back(records.length * s);
  if (records.top < 1.0) {
    all.push_back(all.back() * kJustBeyond);
    all.push_back(records.length);
  }
  return all;
}

Joint joint_of_stiffness_density(std::span<const double> slip_displacement,
                                 std::span<const double> density, double stiffness) {
  PiecewiseLinearPart part;
  for (std::size_t j = 0; j < density.size(); ++j) {
    part.slip_force.push_back(stiffness * slip_displacement[j]);
    part.density.push_back(density[j] / (stiffness * stiffness));
  }
  return {stiffness, SlipDensity({std::move(part)})};
}

}  // namespace microslip
