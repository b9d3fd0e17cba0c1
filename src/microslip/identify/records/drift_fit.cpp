// SPDX-License-Identifier: MIT
#include "microslip/identify/records/drift_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/identify/records/drift_rows.hpp"
#include "microslip/identify/records/joined_columns.hpp"

namespace microslip {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Terms of a polynomial, and turns that one more of them takes.
constexpr Index kMostTerms = 3;
constexpr std::size_t kTurnsPerTerm = 2;
/// Gain of the terms of both sensors from which on there is a drift, over that of one beside the
/// other: the joint is found without it, and its error looks like a small one.
constexpr double kOfBoth = 4.0;
/// Size of the columns of a displacement, over X: of the first pass and the least of the others.
constexpr double kFirstSize = 0.05;
constexpr double kLeastSize = 1e-3;
/// A pass that changes the drifts by less of their deviations is the last.
constexpr double kConverged = 0.05;
constexpr int kMostPasses = 8;

/// Which sensors drift.
struct Sensors {
  bool displacement = false;
  bool force = false;
};

/// One pass: the joint as it is found without the drift so far, and the columns of both sensors.
class DriftPass {
 public:
  DriftPass(const RecordEvidence& evidence, std::optional<double> stiffness,
            const RecordInversionOptions& options, Index terms, double size)
      : records_({.records = {&evidence, 1}}, stiffness, options.coefficients),
        settled_(settle_records(records_, options.viscous)),
        joined_(settled_),
        displacement_(
            columns_among_all(settled_, 0, displacement_drift_rows(settled_, 0, terms, size))),
        force_(columns_among_all(settled_, 0, force_drift_rows(settled_, 0, terms))) {}

  [[nodiscard]] JoinedColumns::Explained explain(Sensors sensors) const {
    if (!sensors.force) return joined_.explain(displacement_);
    if (!sensors.displacement) return joined_.explain(force_);
    MatrixXd both(force_.rows(), displacement_.cols() + force_.cols());
    both << displacement_, force_;
    return joined_.explain(both);
  }

  /// Gain from which on the terms of a sensor are no noise beside those of the other: that of BIC.
  [[nodiscard]] double least_gain() const {
    const auto rows = static_cast<double>(settled_.model.problem().rows());
    return std::log(rows) * static_cast<double>(force_.cols());
  }

  /// Lengths and forces that coefficients are over.
  [[nodiscard]] double length() const { return records_.length; }
  [[nodiscard]] double force() const { return records_.length * records_.stiffness; }

 private:
  ScaledRecords records_;
  SettledRecords settled_;
  JoinedColumns joined_;
  MatrixXd displacement_;
  MatrixXd force_;
};

/// χ² of coefficients.
double chi_squared_of(const VectorXd& coefficients, const MatrixXd& covariance) {
  return coefficients.dot(Eigen::LDLT<MatrixXd>(covariance).solve(coefficients));
}

/// The drift of one sensor in the course of the passes; of one that is left out all is 0.
struct SensorFit {
  std::vector<double> drift = {};  // coefficients
  VectorXd scaled = {};            // the same over the unit of the last pass
  double deviation = 0.0;          // at the last sample
  double change = 0.0;             // there, by the last pass
  double gain = 0.0;               // of the drift beside that of the other sensor

  [[nodiscard]] bool settled() const { return std::abs(change) <= kConverged * deviation; }

  /// Takes the terms of a pass from `first` on. @param unit  of its coefficients.
  void add(const JoinedColumns::Explained& found, Index first, Index terms, double unit) {
    drift.resize(static_cast<std::size_t>(terms));
    scaled.resize(terms);
    for (Index p = 0; p < terms; ++p) {
      double& one = drift[static_cast<std::size_t>(p)];
      one += unit * found.coefficients(first + p);
      scaled(p) = one / unit;
    }
    change = unit * found.coefficients.segment(first, terms).sum();
    const MatrixXd covariance = found.covariance.block(first, first, terms, terms);
    deviation = unit * std::sqrt(std::max(0.0, covariance.sum()));
    gain = chi_squared_of(scaled, covariance);
  }
};

/// Gauss–Newton on the drifts of the sensors of a record.
class DriftSearch {
 public:
  DriftSearch(const RecordEvidence& evidence, std::optional<double> stiffness,
              const RecordInversionOptions& options)
      : evidence_(evidence),
        stiffness_(stiffness),
        options_(options),
        terms_(std::clamp(static_cast<Index>(evidence.rows().reversals / kTurnsPerTerm), Index{1},
                          kMostTerms)) {}

  DriftFit run() {
    Sensors sensors{true, true};
    settle(sensors);
    if (gain_ < kOfBoth * least_) return {};
    sensors = {displacement_.gain >= least_, force_.gain >= least_};
    // Either alone would do: the one that explains more beside the other stays.
    if (!sensors.displacement && !sensors.force) {
      sensors = {displacement_.gain >= force_.gain, displacement_.gain < force_.gain};
    }
    if (!sensors.displacement) displacement_ = {};
    if (!sensors.force) force_ = {};
    if (!sensors.displacement || !sensors.force) settle(sensors);
    return {{displacement_.drift, force_.drift}, displacement_.deviation, force_.deviation};
  }

 private:
  /// Passes until the drifts of these sensors no longer change.
  void settle(Sensors sensors) {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const RecordEvidence now(
          without_drift(evidence_.measured(), {displacement_.drift, force_.drift}),
          evidence_.start());
      const DriftPass one(now, stiffness_, options_, terms_, size_);
      least_ = one.least_gain();
      const JoinedColumns::Explained found = one.explain(sensors);
      if (sensors.displacement) {
        displacement_.add(found, 0, terms_, one.length());
        size_ = std::max(kLeastSize, std::abs(displacement_.change) / one.length());
      }
      if (sensors.force) {
        force_.add(found, sensors.displacement ? terms_ : 0, terms_, one.force());
      }
      VectorXd all(displacement_.scaled.size() + force_.scaled.size());
      all << displacement_.scaled, force_.scaled;
      gain_ = chi_squared_of(all, found.covariance);
      if (displacement_.settled() && force_.settled()) break;
    }
  }

  const RecordEvidence& evidence_;
  std::optional<double> stiffness_;
  const RecordInversionOptions& options_;
  Index terms_;
  double size_ = kFirstSize;
  double least_ = 0.0;  // gain of one sensor
  double gain_ = 0.0;   // of all that are sought
  SensorFit displacement_ = {};
  SensorFit force_ = {};
};

}  // namespace

DriftFit fit_drift(const RecordEvidence& evidence, std::optional<double> stiffness,
                   const RecordInversionOptions& options) {
  return DriftSearch(evidence, stiffness, options).run();
}

}  // namespace microslip
