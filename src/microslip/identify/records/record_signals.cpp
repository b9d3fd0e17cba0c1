// SPDX-License-Identifier: MIT
#include "microslip/identify/records/record_signals.hpp"

#include <algorithm>
#include <cmath>

#include "microslip/identify/records/draw_reader.hpp"
#include "microslip/identify/records/drift_rows.hpp"
#include "microslip/observe/record_rows.hpp"
#include "microslip/observe/turning_samples.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kVirginPoints = 256;
/// The force passes zero within this share of its largest.
constexpr double kAboutZero = 0.05;
/// Terms of a drift of the displacement, and its size over the largest half range.
constexpr Index kDriftTerms = 2;
constexpr double kDriftSize = 0.02;

VectorXd to_largest_1(VectorXd values) {
  const double largest = values.cwiseAbs().maxCoeff();
  return largest > 0.0 ? VectorXd(values / largest) : values;
}

/// Scales values to −1 to 1.
VectorXd from_end_to_end(VectorXd values) {
  const double low = values.minCoeff();
  const double width = values.maxCoeff() - low;
  if (width > 0.0) values = (2.0 / width * (values.array() - low) - 1.0).matrix();
  return values;
}

/// Direction of the motion to each sample, turns of noise ignored.
std::vector<double> directions_of(const SmoothedPath& path) {
  const std::vector<double>& u = path.displacement;
  std::vector<double> direction(u.size(), 0.0);
  const std::vector<std::size_t> at = turning_samples(u, path.smallest_turn());
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const double sign = u[at[k + 1]] > u[at[k]] ? 1.0 : -1.0;
    for (std::size_t i = at[k] + 1; i <= at[k + 1]; ++i) direction[i] = sign;
  }
  return direction;
}

/// Integrals of the hat functions of knots, constant below the first.
std::vector<double> widths_of(const std::vector<double>& knots) {
  std::vector<double> widths(knots.size(), 0.0);
  widths.front() = knots.front();
  for (std::size_t j = 1; j < knots.size(); ++j) {
    widths[j - 1] += 0.5 * (knots[j] - knots[j - 1]);
    widths[j] += 0.5 * (knots[j] - knots[j - 1]);
  }
  return widths;
}

}  // namespace

RecordSignals::RecordSignals(const SettledRecords& settled, std::size_t record)
    : settled_(&settled),
      record_(record),
      length_(settled.records->length),
      knots_(settled.model.basis().knots()),
      density_(settled.model.density_matrix() * settled.best.solution.x) {
  const ScaledRecords& records = *settled.records;
  const double elastic =
      DrawReader(settled.model, records).elastic(settled.best.solution.x) / records.stiffness;
  for (std::size_t i = 0; i < kVirginPoints; ++i) {
    const double h = static_cast<double>(i) / static_cast<double>(kVirginPoints - 1);
    virgin_.push_back(elastic * h + virgin_row(h, knots_).dot(density_));
  }
  read_samples();
  read_rows();
  stops_ = stops_along(path_);
}

double RecordSignals::virgin(double half_range) const {
  const double place = std::clamp(half_range, 0.0, 1.0) * static_cast<double>(kVirginPoints - 1);
  const auto i = std::min(static_cast<std::size_t>(place), kVirginPoints - 2);
  return virgin_[i] + (place - static_cast<double>(i)) * (virgin_[i + 1] - virgin_[i]);
}

void RecordSignals::read_samples() {
  const ScaledRecords& records = *settled_->records;
  const RecordEvidence& evidence = records.records[record_];
  const double unit = records.stiffness * length_;
  const VectorXd offsets = settled_->model.offsets(record_, settled_->best.solution.x);
  const double offset = offsets(offsets.size() - 1);
  path_ = evidence.path().displacement;
  for (std::size_t i = path_.size(); i-- > 0;) path_[i] = (path_[i] - path_[0]) / length_;
  way_ = directions_of(evidence.path());
  double largest = 0.0;
  for (const double force : evidence.measured().force) {
    force_.push_back(force / unit - offset);
    largest = std::max(largest, std::abs(force_.back()));
  }
  for (double& force : force_) force /= largest;
}

void RecordSignals::read_rows() {
  const ScaledRecords& records = *settled_->records;
  const std::vector<PathRow>& rows = records.records[record_].rows().rows;
  const auto n = static_cast<Index>(rows.size());
  measured = means_of_rows(rows, force_);
  found = to_largest_1(settled_->model.found(record_, settled_->best.solution.x));
  displacement.resize(n);
  velocity.resize(n);
  direction.resize(n);
  time.resize(n);
  work.resize(n);
  double sum = 0.0;
  for (Index i = 0; i < n; ++i) {
    const PathRow& row = rows[static_cast<std::size_t>(i)];
    displacement(i) = row.displacement / length_;
    velocity(i) = row.velocity;
    direction(i) = row.last.coefficient > 0.0 ? 1.0 : -1.0;
    time(i) = static_cast<double>(row.first) + 0.5 * static_cast<double>(row.count);
    if (i > 0) {
      sum += 0.5 * (measured(i) + measured(i - 1)) * (displacement(i) - displacement(i - 1));
    }
    work(i) = sum;
  }
  velocity = to_largest_1(velocity);
  time = from_end_to_end(time);
  work = from_end_to_end(work);
  read_slipped();
}

// v(h) − h v′(h): what the sliders that have slipped by h carry.
double RecordSignals::saturated(double half_range) const {
  constexpr double kStep = 1e-3;
  const double from = std::max(0.0, half_range - kStep);
  const double to = half_range + kStep;
  return virgin(half_range) - half_range * (virgin(to) - virgin(from)) / (to - from);
}

void RecordSignals::read_slipped() {
  const PathRows& path = settled_->records->records[record_].rows();
  const auto part = [this](const PathStretch& one) {
    return one.coefficient * saturated(one.half_range / length_);
  };
  std::vector<double> behind;
  for (const std::vector<PathStretch>& turns : path.turns) {
    double sum = 0.0;
    for (const PathStretch& one : turns) sum += part(one);
    behind.push_back(sum);
  }
  slipped.resize(static_cast<Index>(path.rows.size()));
  for (std::size_t i = 0; i < path.rows.size(); ++i) {
    slipped(static_cast<Index>(i)) = behind[path.rows[i].turns] + part(path.rows[i].last);
  }
}

Eigen::MatrixXd RecordSignals::hysteretic(double exponent, double spring) const {
  std::vector<double> z(force_.size());
  const double chord = 1.0 / displacement.cwiseAbs().maxCoeff();
  double most = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    z[i] = force_[i] - spring * chord * path_[i];
    most = std::max(most, std::abs(z[i]));
  }
  std::vector<double> either(z.size(), 0.0);
  std::vector<double> with_way(z.size(), 0.0);
  for (std::size_t i = 1; i < z.size(); ++i) {
    const double middle = 0.5 * (z[i] + z[i - 1]) / most;
    const double step = std::pow(std::abs(middle), exponent) * (path_[i] - path_[i - 1]);
    either[i] = either[i - 1] + step;
    with_way[i] = with_way[i - 1] + (middle * way_[i] > 0.0 ? step : -step);
  }
  const std::vector<PathRow>& rows = settled_->records->records[record_].rows().rows;
  MatrixXd both(static_cast<Index>(rows.size()), 2);
  both << means_of_rows(rows, either), means_of_rows(rows, with_way);
  return both;
}

MovedPath RecordSignals::moved_to(const std::vector<double>& path) const {
  std::vector<double> change(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) change[i] = path[i] - path_[i];
  const std::vector<PathRow>& rows = settled_->records->records[record_].rows().rows;
  return {stops_along(path) - stops_, means_of_rows(rows, change)};
}

MovedPath RecordSignals::behind_play(double play) const {
  std::vector<double> path(path_.size(), 0.0);
  const double first = play * std::tanh(force_.front() / kAboutZero);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double to = path_[i] - play * std::tanh(force_[i] / kAboutZero) + first;
    // A joint behind a play moves with the whole or not at all.
    path[i] = way_[i] > 0.0 ? std::max(to, path[i - 1]) : std::min(to, path[i - 1]);
  }
  return moved_to(path);
}

MovedPath RecordSignals::without_drift(double size, double power) const {
  std::vector<double> path = path_;
  const auto last = static_cast<double>(path.size() - 1);
  for (std::size_t i = 0; i < path.size(); ++i) {
    path[i] -= size * std::pow(static_cast<double>(i) / last, power);
  }
  return moved_to(path);
}

Eigen::MatrixXd RecordSignals::displacement_drift() const {
  return displacement_drift_rows(*settled_, record_, kDriftTerms, kDriftSize);
}

Eigen::MatrixXd RecordSignals::stops_along(const std::vector<double>& path) const {
  const std::vector<PathRow>& rows = settled_->records->records[record_].rows().rows;
  const std::vector<double> widths = widths_of(knots_);
  MatrixXd stops(static_cast<Index>(rows.size()), static_cast<Index>(knots_.size()));
  std::vector<double> force(path.size());
  for (std::size_t j = 0; j < knots_.size(); ++j) {
    double stretch = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      stretch = std::clamp(stretch + path[i] - path[i == 0 ? 0 : i - 1], -knots_[j], knots_[j]);
      force[i] = stretch;
    }
    stops.col(static_cast<Index>(j)) = widths[j] * means_of_rows(rows, force);
  }
  return stops;
}

}  // namespace microslip
