// SPDX-License-Identifier: MIT
#include "microslip/calibrate/linearisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "microslip/calibrate/mode_offsets.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip {
namespace {

/// Prior deviation of a k that is identified too, about the given one: the levels count far more.
constexpr double kSoughtStiffness = 0.5;
/// A loss counts with a deviation of this share of the largest at least: a negligible loss must not
/// dominate.
constexpr double kLeastLoss = 1e-9;

/// Derivatives of the quantities of a level by the loss and the stiffness of each joint there.
class AnswersOfLevel {
 public:
  AnswersOfLevel(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                 const LevelStates& states, std::size_t level)
      : evidence_(evidence),
        unknowns_(unknowns),
        states_(states),
        level_(level),
        vibration_(*states.at(level)),
        sensitivity_(level_sensitivity(states.structure(), states.response(), vibration_,
                                       evidence.forcing)) {
    for (std::size_t j = 0; j < unknowns.count(); ++j) {
      const double a = used_amplitude(evidence, states, level, unknowns.index(j));
      amplitude_.push_back(a);
    }
  }

  /// D of one joint of the structure, and its derivative.
  [[nodiscard]] Eigen::RowVectorXd loss(std::size_t joint, double& value) const {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(size());
    const StructuralJoint& placed = states_.structure().joints()[joint];
    const double a = used_amplitude(evidence_, states_, level_, joint);
    value = dissipation(placed.joint, a) + placed.linear_damping * a * a;
    for (std::size_t j = 0; j < unknowns_.count(); ++j) {
      if (unknowns_.index(j) != joint) continue;
      row(static_cast<Eigen::Index>(2 * j)) += 1.0;
    }
    if (evidence_.stuck_shapes || evidence_.sensor_replaces(level_, joint)) return row;
    row += loss_slope(joint) * amplitude(joint);
    return row;
  }

  /// The derivative of the amplitude of one joint of the structure.
  [[nodiscard]] Eigen::RowVectorXd amplitude(std::size_t joint) const {
    const auto at = static_cast<Eigen::Index>(joint);
    return answer(sensitivity_.amplitude.row(at), sensitivity_.amplitude_by_mode.row(at));
  }

  /// ω: its derivative.
  [[nodiscard]] Eigen::RowVectorXd frequency() const {
    return answer(sensitivity_.frequency, sensitivity_.frequency_by_mode);
  }

  /// Effect of one standard deviation of the displacement of the response point on measured minus
  /// fitted ω.
  [[nodiscard]] double frequency_share() const {
    return -sensitivity_.frequency_by_response * displacement_deviation();
  }
  /// The effect on the amplitude of one joint of the structure.
  [[nodiscard]] double amplitude_share(std::size_t joint) const {
    return -amplitude_by_response(joint) * displacement_deviation();
  }

  /// The effect on the loss of all joints together. Amplitudes that sensors replace do not
  /// follow; a loss of ζ does, with the square.
  [[nodiscard]] double loss_share(double measured_slope) const {
    double slope = measured_slope;
    for (std::size_t joint = 0; joint < states_.structure().joints().size(); ++joint) {
      slope -= loss_slope(joint) * amplitude_by_response(joint);
    }
    return slope * displacement_deviation();
  }
  /// The effect on the loss of one joint.
  [[nodiscard]] double loss_share_of(std::size_t joint) const {
    return loss_slope(joint) * amplitude_share(joint);
  }

  [[nodiscard]] const SteadyVibration& vibration() const { return vibration_; }

 private:
  [[nodiscard]] Eigen::Index size() const { return unknowns_.answers(); }

  [[nodiscard]] double displacement_deviation() const {
    const double given = ModalLevels::value(evidence_.levels.displacement_std, level_);
    return std::isnan(given) ? 0.0 : given;
  }

  /// dD/da of a joint.
  [[nodiscard]] double loss_slope(std::size_t joint) const {
    const StructuralJoint& placed = states_.structure().joints()[joint];
    const double a = used_amplitude(evidence_, states_, level_, joint);
    return dissipation_slope(placed.joint, a) + 2.0 * placed.linear_damping * a;
  }

  [[nodiscard]] double amplitude_by_response(std::size_t joint) const {
    if (evidence_.sensor_replaces(level_, joint)) return 0.0;
    if (!evidence_.stuck_shapes) {
      return sensitivity_.amplitude_by_response(static_cast<Eigen::Index>(joint));
    }
    return states_.stuck_amplitude(level_, joint) / evidence_.levels.displacement[level_];
  }

  /// The row of a quantity with the derivative `by_kappa` with respect to κ of each joint of the
  /// structure, and `by_mode` with respect to ln ω of each mode.
  [[nodiscard]] Eigen::RowVectorXd answer(const Eigen::RowVectorXcd& by_kappa,
                                          const Eigen::RowVectorXd& by_mode) const {
    Eigen::RowVectorXd row(size());
    row.tail(unknowns_.mode_count()) = by_mode.head(unknowns_.mode_count());
    for (std::size_t j = 0; j < unknowns_.count(); ++j) {
      const std::complex<double> by = by_kappa(static_cast<Eigen::Index>(unknowns_.index(j)));
      const auto at = static_cast<Eigen::Index>(2 * j);
      row(at) = -by.imag() / (std::numbers::pi * amplitude_[j] * amplitude_[j]);
      row(at + 1) = by.real();
    }
    return row;
  }

  const CalibrationEvidence& evidence_;
  const AllUnknowns& unknowns_;
  const LevelStates& states_;
  std::size_t level_;
  const SteadyVibration& vibration_;
  LevelSensitivity sensitivity_;
  std::vector<double> amplitude_;  // of the joints that are sought
};

/// D and k_eq of each joint that is sought at a level, from coefficients.
class JointRows {
 public:
  /// @param amplitude  of each joint that is sought, m.
  JointRows(const AllUnknowns& unknowns, const std::vector<double>& amplitude)
      : unknowns_(unknowns) {
    for (std::size_t j = 0; j < unknowns.count(); ++j) {
      dissipation_.push_back(unknowns.of(j).dissipation_row(amplitude[j]));
      secant_.push_back(unknowns.of(j).secant_row(amplitude[j]));
    }
  }

  /// The row with the derivatives `by`, by coefficients.
  [[nodiscard]] Eigen::RowVectorXd of(const Eigen::RowVectorXd& by) const {
    Eigen::RowVectorXd row(unknowns_.size());
    for (std::size_t j = 0; j < unknowns_.count(); ++j) {
      const auto at = static_cast<Eigen::Index>(2 * j);
      row.segment(unknowns_.begin(j), unknowns_.of(j).size()) =
          by(at) * dissipation_[j] + by(at + 1) * secant_[j];
    }
    const ModeUnknowns& modes = unknowns_.modes();
    for (Eigen::Index i = 0; i < unknowns_.mode_count(); ++i) {
      row(unknowns_.modes_begin() + i) = by(static_cast<Eigen::Index>(2 * unknowns_.count()) + i) *
                                         modes.unit[static_cast<std::size_t>(i)];
    }
    return row;
  }

 private:
  const AllUnknowns& unknowns_;
  std::vector<Eigen::RowVectorXd> dissipation_;
  std::vector<Eigen::RowVectorXd> secant_;
};

std::vector<double> amplitudes_of(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                                  const LevelStates& states, std::size_t level) {
  std::vector<double> all;
  for (std::size_t j = 0; j < unknowns.count(); ++j) {
    all.push_back(used_amplitude(evidence, states, level, unknowns.index(j)));
  }
  return all;
}

double joint_entry(const CalibrationEvidence& evidence, std::size_t joint, std::size_t level,
                   std::vector<double> JointLevels::*values) {
  const std::size_t column = evidence.column[joint];
  if (column == CalibrationEvidence::kNone) return std::numeric_limits<double>::quiet_NaN();
  return ModalLevels::value(evidence.levels.joints[column].*values, level);
}

/// Effect of ± σ of the amplitude of a sensor that replaces that of the structure on D.
double sensor_share(const CalibrationEvidence& evidence, const LevelStates& states,
                    std::size_t level, std::size_t joint) {
  const double sigma = joint_entry(evidence, joint, level, &JointLevels::amplitude_std);
  if (std::isnan(sigma) || !evidence.sensor_replaces(level, joint)) return 0.0;
  const double a = used_amplitude(evidence, states, level, joint);
  return dissipation_slope(states.structure().joints()[joint].joint, a) * sigma;
}

/// The loss of each joint that is known by itself, and that of all together where it is: the parts
/// are often known far less well than their sum.
void add_losses(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                const LevelStates& states, std::size_t level, const AnswersOfLevel& answers,
                std::vector<LevelRow>& rows) {
  double sum = 0.0;
  double variance = 0.0;
  LevelRow together{.by = Eigen::RowVectorXd::Zero(unknowns.answers())};
  for (std::size_t j = 0; j < states.structure().joints().size(); ++j) {
    double value = 0.0;
    LevelRow row{.by = answers.loss(j, value)};
    together.by += row.by;
    sum += value;
    const double share = sensor_share(evidence, states, level, j);
    variance += share * share;
    const double measured = joint_entry(evidence, j, level, &JointLevels::dissipation);
    if (std::isnan(measured)) continue;
    row.data = measured - value;
    row.size = measured;
    const double given = joint_entry(evidence, j, level, &JointLevels::dissipation_std);
    row.level = level;
    row.joint = j;
    row.deviation = evidence.loss_std_given ? std::hypot(given, share) : std::max(value, measured);
    if (evidence.loss_std_given) row.by_displacement = answers.loss_share_of(j);
    rows.push_back(std::move(row));
  }
  const MeasuredLoss measured = measured_loss(evidence.levels, level, answers.vibration());
  if (std::isnan(measured.value)) return;
  together.data = measured.value - sum;
  together.size = measured.value;
  together.level = level;
  together.deviation = evidence.loss_std_given ? std::hypot(measured.deviation, std::sqrt(variance))
                                               : std::max(sum, measured.scattered);
  if (evidence.loss_std_given) {
    together.by_displacement = answers.loss_share(measured.by_displacement);
  }
  rows.push_back(std::move(together));
}

/// The displacements of joints that sensors observe.
void add_sensors(const CalibrationEvidence& evidence, const LevelStates& states, std::size_t level,
                 const AnswersOfLevel& answers, std::vector<LevelRow>& rows) {
  for (std::size_t joint = 0; joint < states.structure().joints().size(); ++joint) {
    if (!evidence.sensor_observes(level, joint)) continue;
    rows.push_back(
        {.by = answers.amplitude(joint),
         .data = evidence.measured_amplitude(level, joint) - states.amplitude(level, joint),
         .deviation = joint_entry(evidence, joint, level, &JointLevels::amplitude_std),
         .by_displacement = answers.amplitude_share(joint),
         .level = level,
         .joint = joint});
  }
}

/// Repeated levels, of one mode at one displacement, share the error of that, and their mean is
/// known no better than it. Each has an error of its own here, in place of c_i
///
///     c_i σ_i √(Σ_r 1/σ_r²)   over the rows r of the same quantity at such levels,
///
/// with which the mean has the variance 1/Σ_r(1/σ_r²) + c². Of a level alone that is c_i.
void share_displacement_errors(const ModalLevels& levels, std::vector<LevelRow>& rows) {
  std::map<std::tuple<std::size_t, double, std::size_t>, double> precision;
  const auto key = [&](const LevelRow& row) {
    return std::tuple(levels.mode[row.level], levels.displacement[row.level], row.joint);
  };
  for (const LevelRow& row : rows) precision[key(row)] += 1.0 / (row.deviation * row.deviation);
  for (LevelRow& row : rows) row.by_displacement *= row.deviation * std::sqrt(precision[key(row)]);
}

/// The error of the displacement of a level, over its standard deviation, as the rows so far show
/// it: the mean by − data, and the variance.
struct DisplacementError {
  Eigen::RowVectorXd by;
  double data = 0.0;
  double variance = 1.0;
};

/// Takes from each row what the rows before it show of the error of the displacement that they
/// share: with e ~ N(m, P) after these a row of σ and the share c of e becomes
///
///     b − cm with the variance σ² + c²P,   after which m ← m + K(b − cm), P ← P(1 − Kc),
///     K = cP/(σ² + c²P)
///
/// as in a Kalman filter, so that all rows together have the covariance diag σ² + ccᵀ.
void take_displacement_errors(std::map<std::size_t, DisplacementError>& errors,
                              std::vector<LevelRow>& rows) {
  for (LevelRow& row : rows) {
    const double c = row.by_displacement;
    if (c == 0.0) continue;  // where deviations are not known, too
    DisplacementError& error = errors[row.level];
    if (error.by.size() == 0) error.by = Eigen::RowVectorXd::Zero(row.by.size());
    row.by -= c * error.by;
    row.data -= c * error.data;
    const double variance = row.deviation * row.deviation + c * c * error.variance;
    const double gain = c * error.variance / variance;
    error.by += gain * row.by;
    error.data += gain * row.data;
    error.variance *= 1.0 - gain * c;
    row.deviation = std::sqrt(variance);
  }
}

LevelRow frequency_row(const CalibrationEvidence& evidence, std::size_t level,
                       const AnswersOfLevel& answers, double measured) {
  const double omega = answers.vibration().angular_frequency;
  LevelRow row{.by = answers.frequency() / omega,
               .data = frequency_error(evidence.levels, level, answers.vibration()),
               .level = level};
  if (!evidence.frequency_std_given) return row;
  row.deviation = ModalLevels::value(evidence.levels.frequency_std, level) / measured;
  row.by_displacement = answers.frequency_share() / omega;
  return row;
}

std::vector<JointRows> joint_rows(const AllUnknowns& unknowns, const LinearisedLevels& levels) {
  std::vector<JointRows> all;
  for (const std::vector<double>& amplitude : levels.amplitude) {
    all.emplace_back(unknowns, amplitude);
  }
  return all;
}

WeightedRows weighed(const std::vector<LevelRow>& rows, Eigen::Index columns,
                     const std::vector<JointRows>& of_level) {
  WeightedRows result;
  result.design.resize(static_cast<Eigen::Index>(rows.size()), columns);
  result.data.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    result.design.row(at) = of_level[rows[i].place].of(rows[i].by) / rows[i].deviation;
    result.data(at) = rows[i].data / rows[i].deviation;
  }
  return result;
}

/// Subtracts the common offset of all levels of a mode in a session from their frequencies, which
/// no joint has to explain. Where levels tell the offsets of the modes it is a row of its own, to
/// kFrequencyResolution: changes are known better than what is common to them.
void centre_modes(const CalibrationEvidence& evidence, const ModeUnknowns& modes,
                  const std::vector<LevelRow>& raw, WeightedRows& rows) {
  const ModalLevels& levels = evidence.levels;
  const double resolution =
      kFrequencyResolution / (evidence.frequency_std_given ? 1.0 : kLeastFrequencyScatter);
  std::vector<Eigen::RowVectorXd> common;
  std::vector<double> common_data;
  std::vector<bool> centred(raw.size(), false);
  for (std::size_t first = 0; first < raw.size(); ++first) {
    if (centred[first]) continue;
    std::vector<Eigen::Index> of_mode;  // a single one becomes nothing
    for (std::size_t i = first; i < raw.size(); ++i) {
      if (!levels.same_offset(raw[first].level, raw[i].level)) continue;
      of_mode.push_back(static_cast<Eigen::Index>(i));
      centred[i] = true;
    }
    // An offset of 1 changes a row by 1/σ.
    Eigen::VectorXd offset(static_cast<Eigen::Index>(of_mode.size()));
    for (Eigen::Index i = 0; i < offset.size(); ++i) {
      offset(i) =
          1.0 / raw[static_cast<std::size_t>(of_mode[static_cast<std::size_t>(i)])].deviation;
    }
    const double size = offset.norm() * resolution;
    offset.normalize();
    const Eigen::MatrixXd design = rows.design(of_mode, Eigen::all);
    const Eigen::VectorXd data = rows.data(of_mode);
    rows.design(of_mode, Eigen::all) = design - offset * (offset.transpose() * design);
    rows.data(of_mode) = data - offset * offset.dot(data);
    rows.freedom_taken += 1.0;
    const std::size_t level = raw[first].level;
    if (modes.determined.empty() || !modes.determined[levels.mode[level]]) continue;
    if (!of_first_session(levels, level)) continue;
    common.emplace_back(offset.transpose() * design / size);
    common_data.push_back(offset.dot(data) / size);
  }
  const Eigen::Index before = rows.data.size();
  const auto more = static_cast<Eigen::Index>(common.size());
  rows.design.conservativeResize(before + more, Eigen::NoChange);
  rows.data.conservativeResize(before + more);
  for (Eigen::Index i = 0; i < more; ++i) {
    rows.design.row(before + i) = common[static_cast<std::size_t>(i)];
    rows.data(before + i) = common_data[static_cast<std::size_t>(i)];
  }
}

/// k of each joint, and the offsets of the modes.
void add_priors(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                LinearEvidence& linear) {
  const double deviation = evidence.fit_stiffness ? kSoughtStiffness : kKnownStiffness;
  const auto count = static_cast<Eigen::Index>(unknowns.count());
  WeightedRows& offsets = linear.of(RowKind::kMode);
  const Eigen::Index modes = unknowns.mode_count();
  offsets.design = Eigen::MatrixXd::Zero(modes, unknowns.size());
  offsets.design.rightCols(modes).setIdentity();
  offsets.data = Eigen::VectorXd::Constant(modes, ModeUnknowns::kInside);
  WeightedRows& rows = linear.of(RowKind::kStiffness);
  rows.design = Eigen::MatrixXd::Zero(count, unknowns.size());
  rows.data = Eigen::VectorXd::Constant(count, 1.0 / deviation);
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto own = static_cast<std::size_t>(j);
    rows.design.row(j).segment(unknowns.begin(own), unknowns.of(own).size()) =
        unknowns.of(own).stiffness_row() / deviation;
  }
}

}  // namespace

AllUnknowns::AllUnknowns(std::vector<std::size_t> which, std::vector<JointUnknowns> joints,
                         ModeUnknowns modes)
    : which_(std::move(which)), joints_(std::move(joints)), modes_(std::move(modes)) {
  begin_.push_back(0);
  for (const JointUnknowns& joint : joints_) begin_.push_back(begin_.back() + joint.size());
}

AllUnknowns AllUnknowns::with(std::size_t j, JointUnknowns joint) const {
  std::vector<JointUnknowns> joints = joints_;
  joints[j] = std::move(joint);
  return {which_, std::move(joints), modes_};
}

Eigen::VectorXd AllUnknowns::projected(const AllUnknowns& before, const Eigen::VectorXd& x) const {
  Eigen::VectorXd found(size());
  for (std::size_t j = 0; j < count(); ++j) {
    found.segment(begin(j), of(j).size()) = of(j).projected(before.of(j), before.part(j, x));
  }
  found.tail(mode_count()) =
      modes_.coefficients(before.mode_count() > 0 ? before.offsets(x) : modes_.start);
  return found;
}

double CalibrationEvidence::measured_amplitude(std::size_t level, std::size_t joint) const {
  return joint_entry(*this, joint, level, &JointLevels::amplitude);
}

bool loss_deviation_known(const CalibrationEvidence& evidence, std::size_t level) {
  const auto missing = [](double value, double deviation) {
    return !std::isnan(value) && !(deviation > 0.0);
  };
  for (std::size_t j = 0; j < evidence.column.size(); ++j) {
    if (missing(joint_entry(evidence, j, level, &JointLevels::dissipation),
                joint_entry(evidence, j, level, &JointLevels::dissipation_std))) {
      return false;
    }
  }
  const ModalLevels& levels = evidence.levels;
  const double loss = ModalLevels::value(levels.dissipation, level);
  if (!std::isnan(loss)) return !missing(loss, ModalLevels::value(levels.dissipation_std, level));
  return !missing(ModalLevels::value(levels.damping_ratio, level),
                  ModalLevels::value(levels.damping_ratio_std, level));
}

double frequency_error(const ModalLevels& levels, std::size_t level,
                       const SteadyVibration& vibration) {
  const double omega = 2.0 * std::numbers::pi * ModalLevels::value(levels.frequency, level);
  return omega / vibration.angular_frequency - 1.0;
}

bool CalibrationEvidence::sensor_observes(std::size_t level, std::size_t joint) const {
  return !stuck_shapes && !std::isnan(measured_amplitude(level, joint)) &&
         joint_entry(*this, joint, level, &JointLevels::amplitude_std) > 0.0;
}

bool CalibrationEvidence::sensor_replaces(std::size_t level, std::size_t joint) const {
  return !std::isnan(measured_amplitude(level, joint)) && !sensor_observes(level, joint);
}

double used_amplitude(const CalibrationEvidence& evidence, const LevelStates& states,
                      std::size_t level, std::size_t joint) {
  if (evidence.sensor_replaces(level, joint)) return evidence.measured_amplitude(level, joint);
  return evidence.stuck_shapes ? states.stuck_amplitude(level, joint)
                               : states.amplitude(level, joint);
}

MeasuredLoss measured_loss(const ModalLevels& levels, std::size_t level,
                           const SteadyVibration& vibration) {
  const auto known = [](double deviation) { return std::isnan(deviation) ? 0.0 : deviation; };
  const double loss = ModalLevels::value(levels.dissipation, level);
  if (!std::isnan(loss)) {
    return {loss, known(ModalLevels::value(levels.dissipation_std, level)), loss, 0.0};
  }
  double square = 0.0;  // of the modal amplitude
  for (const auto& harmonics : vibration.modal) square += std::norm(harmonics[1]);
  const double omega = vibration.angular_frequency;
  const double unit = 2.0 * std::numbers::pi * omega * omega * square;
  const double all = unit * ModalLevels::value(levels.damping_ratio, level);
  const double of_joints = all - vibration.linear_dissipation;
  return {of_joints, unit * known(ModalLevels::value(levels.damping_ratio_std, level)), all,
          2.0 * of_joints / levels.displacement[level]};
}

std::vector<LinearLoss> losses_about(const CalibrationEvidence& evidence,
                                     const AllUnknowns& unknowns, const LevelStates& states,
                                     std::size_t level) {
  const AnswersOfLevel answers(evidence, unknowns, states, level);
  const JointRows rows(unknowns, amplitudes_of(evidence, unknowns, states, level));
  std::vector<LinearLoss> losses;
  for (std::size_t j = 0; j < unknowns.count(); ++j) {
    LinearLoss& loss = losses.emplace_back();
    loss.slope = rows.of(answers.loss(unknowns.index(j), loss.value));
  }
  return losses;
}

LevelDeviations deviations_about(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                                 const LevelStates& states, std::size_t level) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const AnswersOfLevel answers(evidence, unknowns, states, level);
  const auto whole = [](const LevelRow& row) {
    return std::hypot(row.deviation, row.by_displacement);
  };
  LevelDeviations found{kUnknown, std::vector(evidence.column.size(), kUnknown), kUnknown, {}};
  for (std::size_t joint = 0; joint < evidence.column.size(); ++joint) {
    found.by_displacement.push_back(answers.loss_share_of(joint));
  }
  std::vector<LevelRow> losses;
  add_losses(evidence, unknowns, states, level, answers, losses);
  for (const LevelRow& row : losses) {
    (row.joint == LevelRow::kAllJoints ? found.loss : found.joints[row.joint]) = whole(row);
  }
  const double frequency = ModalLevels::value(evidence.levels.frequency, level);
  if (!std::isnan(frequency)) {
    found.frequency = whole(frequency_row(evidence, level, answers, frequency));
  }
  return found;
}

LinearisedLevels linearise(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                           const LevelStates& states, const std::vector<std::size_t>& which,
                           const Eigen::VectorXd& x) {
  LinearisedLevels linear;
  double largest = 0.0;
  for (const std::size_t level : which) {
    if (!states.at(level)) continue;
    const std::size_t place = linear.amplitude.size();
    linear.amplitude.push_back(amplitudes_of(evidence, unknowns, states, level));
    const AnswersOfLevel answers(evidence, unknowns, states, level);
    const std::size_t before = linear.losses.size();
    add_losses(evidence, unknowns, states, level, answers, linear.losses);
    for (std::size_t i = before; i < linear.losses.size(); ++i) linear.losses[i].place = place;
    const std::size_t sensors = linear.sensors.size();
    add_sensors(evidence, states, level, answers, linear.sensors);
    for (std::size_t i = sensors; i < linear.sensors.size(); ++i) linear.sensors[i].place = place;
    const double frequency = ModalLevels::value(evidence.levels.frequency, level);
    if (evidence.frequency == FrequencyUse::kIgnore || std::isnan(frequency)) continue;
    linear.frequencies.push_back(frequency_row(evidence, level, answers, frequency));
    linear.frequencies.back().place = place;
  }
  // Frequencies last: their offset, which centre_modes() takes, is then in no other row.
  std::map<std::size_t, DisplacementError> errors;
  for (std::vector<LevelRow>* rows : {&linear.losses, &linear.sensors, &linear.frequencies}) {
    share_displacement_errors(evidence.levels, *rows);
    take_displacement_errors(errors, *rows);
  }
  for (const LevelRow& row : linear.losses) largest = std::max(largest, row.deviation);
  for (LevelRow& row : linear.losses) {
    row.deviation = std::max(row.deviation, kLeastLoss * largest);
  }
  const std::vector<JointRows> of_level = joint_rows(unknowns, linear);
  for (std::vector<LevelRow>* rows : {&linear.losses, &linear.sensors, &linear.frequencies}) {
    for (LevelRow& row : *rows) row.data += of_level[row.place].of(row.by).dot(x);
  }
  return linear;
}

LinearEvidence in_terms_of(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                           const LinearisedLevels& levels) {
  const std::vector<JointRows> of_level = joint_rows(unknowns, levels);
  LinearEvidence linear;
  linear.of(RowKind::kLoss) = weighed(levels.losses, unknowns.size(), of_level);
  linear.of(RowKind::kAmplitude) = weighed(levels.sensors, unknowns.size(), of_level);
  WeightedRows& frequencies = linear.of(RowKind::kFrequency);
  frequencies = weighed(levels.frequencies, unknowns.size(), of_level);
  if (evidence.frequency == FrequencyUse::kChange) {
    centre_modes(evidence, unknowns.modes(), levels.frequencies, frequencies);
  }
  add_priors(evidence, unknowns, linear);
  for (std::size_t j = 0; j < unknowns.count(); ++j) {
    linear.roughness.push_back({unknowns.begin(j), unknowns.of(j).size() - 1,
                                unknowns.of(j).penalty(), unknowns.of(j).ranges()});
  }
  return linear;
}

}  // namespace microslip
