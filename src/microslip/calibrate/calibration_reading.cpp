// SPDX-License-Identifier: MIT
#include "microslip/calibrate/calibration_reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/random.hpp"
#include "microslip/calibrate/calibration_draws.hpp"
#include "microslip/calibrate/level_residuals.hpp"
#include "microslip/calibrate/losses_of_joints.hpp"
#include "microslip/calibrate/mode_offsets.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/joint/dissipation.hpp"

namespace microslip {
namespace {

/// Random stream of the errors of the displacement of the first level, far above those of the
/// chains; the others follow below it.
constexpr std::uint64_t kDisplacementStream = std::numeric_limits<std::uint64_t>::max();

Estimate band_of(std::vector<double> values, double confidence) {
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  const auto [lower, upper] = quantile_pair_above_zero(values, confidence);
  return {mean, lower, upper};
}

/// Losses of joints lie between 0 and the loss of all together: where one has almost none, draws of
/// it press against 0 and those of another against the sum. The shortest interval contains both
/// ends; the least draw of a loss that may be 0 stands for 0.
std::pair<double, double> band_of_loss(std::vector<double> values, double confidence) {
  auto [lower, upper] = shortest_interval(values, confidence);
  if (lower == values.front() && lower < upper - lower) lower = 0.0;
  return {lower, upper};
}

/// Sums of a linear map of draws, for their variance.
class Spread {
 public:
  explicit Spread(Eigen::Index size)
      : sum_(Eigen::VectorXd::Zero(size)), square_(Eigen::VectorXd::Zero(size)) {}

  void add(const Eigen::VectorXd& value) {
    sum_ += value;
    square_ += value.cwiseAbs2();
    ++count_;
  }

  [[nodiscard]] Eigen::Index size() const { return sum_.size(); }

  [[nodiscard]] Eigen::VectorXd variance() const {
    const auto n = static_cast<double>(count_);
    return (square_ / n - (sum_ / n).cwiseAbs2()).cwiseMax(0.0);
  }

 private:
  Eigen::VectorXd sum_;
  Eigen::VectorXd square_;
  std::size_t count_ = 0;
};

/// 1 − var(ψ | levels)/var(ψ), at the knots of each joint.
void read_variance_reduction(const CalibrationDraws& draws, CalibrationResult& result) {
  for (std::size_t j = 0; j < draws.unknowns.count(); ++j) {
    const Eigen::MatrixXd& density = draws.unknowns.of(j).density_matrix();
    const auto variance_of = [&](const std::vector<Eigen::VectorXd>& all) {
      Spread spread(density.rows());
      for (const Eigen::VectorXd& x : all) spread.add(density * draws.unknowns.part(j, x));
      return spread.variance();
    };
    const Eigen::VectorXd prior = variance_of(draws.prior);
    const Eigen::VectorXd posterior = variance_of(draws.posterior);
    for (Eigen::Index i = 0; i < prior.size(); ++i) {
      const double share = prior(i) > 0.0 ? 1.0 - posterior(i) / prior(i) : 0.0;
      result.joints[j].variance_reduction.push_back(std::clamp(share, 0.0, 1.0));
    }
  }
}

StiffnessDraw read_draw(const JointUnknowns& unknowns, const Eigen::VectorXd& x) {
  const Eigen::VectorXd psi = (unknowns.density_matrix() * x).cwiseMax(0.0);
  return {{psi.begin(), psi.end()}, unknowns.stiffness() * unknowns.stiffness_row().dot(x), 0.0};
}

/// φ at f* = k x* of each draw by its own k.
DensityBand band_of_density(const CalibratedJoint& joint, double confidence) {
  DensityBand band;
  std::vector<double> values(joint.draws.size());
  for (const double x : joint.slip_displacement) {
    std::ranges::transform(joint.draws, values.begin(), [&](const StiffnessDraw& draw) {
      const double at = x * joint.stiffness.value / draw.stiffness;
      return interpolate(joint.slip_displacement, draw.density, at) /
             (draw.stiffness * draw.stiffness);
    });
    const auto [lower, upper] = quantile_pair_above_zero(values, confidence);
    band.lower.push_back(lower);
    band.upper.push_back(upper);
  }
  return band;
}

void read_bands(double confidence, CalibratedJoint& joint, std::vector<double> elastic) {
  std::vector<double> values(joint.draws.size());
  for (std::size_t i = 0; i < joint.slip_displacement.size(); ++i) {
    std::ranges::transform(joint.draws, values.begin(),
                           [i](const StiffnessDraw& draw) { return draw.density[i]; });
    const Estimate psi = band_of(values, confidence);
    joint.density.push_back(psi.value);
    joint.lower.push_back(psi.lower);
    joint.upper.push_back(psi.upper);
  }
  std::ranges::transform(joint.draws, values.begin(), &StiffnessDraw::stiffness);
  joint.stiffness = band_of(values, confidence);
  joint.elastic_stiffness = band_of(std::move(elastic), confidence);
  joint.band = band_of_density(joint, confidence);
}

void read_joints(const CalibrationEvidence& evidence, const CalibrationOptions& options,
                 const CalibratedState& state, const CalibrationDraws& draws,
                 const std::vector<Joint>& joints, const LevelStates& states,
                 CalibrationResult& result) {
  for (std::size_t j = 0; j < draws.unknowns.count(); ++j) {
    const JointUnknowns& unknowns = draws.unknowns.of(j);
    const std::size_t index = draws.unknowns.index(j);
    CalibratedJoint found{
        .name = states.structure().joints()[index].name, .index = index, .joint = joints[index]};
    found.slip_displacement = unknowns.slip_displacement();
    found.exponent = state.unknowns.of(j).exponent();
    found.edf = state.settled.edf_by_joint.at(j);
    std::vector<double> elastic;
    for (const Eigen::VectorXd& x : draws.posterior) {
      const Eigen::VectorXd own = draws.unknowns.part(j, x);
      found.draws.push_back(read_draw(unknowns, own));
      elastic.push_back(unknowns.stiffness() * own(own.size() - 1));
    }
    read_bands(options.confidence, found, std::move(elastic));
    found.least_amplitude = std::numeric_limits<double>::infinity();
    for (std::size_t level = 0; level < evidence.levels.size(); ++level) {
      if (!states.at(level)) continue;
      const double a = used_amplitude(evidence, states, level, index);
      found.least_amplitude = std::min(found.least_amplitude, a);
      found.largest_amplitude = std::max(found.largest_amplitude, a);
    }
    result.joints.push_back(std::move(found));
  }
}

/// Slip forces of the edges, by the stiffness found.
void read_edges(const GrowingRange& range, CalibrationResult& result) {
  for (std::size_t j = 0; j < result.joints.size(); ++j) {
    const FoundEdges& found = range.edges()[j];
    CalibratedJoint& joint = result.joints[j];
    joint.edges_evidence = found.evidence;
    for (std::size_t e = 0; e < found.slip_displacement.size(); ++e) {
      const double k = joint.joint.stiffness();
      joint.edges.push_back({k * found.slip_displacement[e], k * found.deviation[e]});
    }
  }
}

/// D of each joint that was found at a level, draw by draw, J, at the amplitude that the joint has
/// in that draw; at the one amplitude of a level that the structure does not have.
std::vector<std::vector<double>> losses_of_draws(const CalibrationEvidence& evidence,
                                                 const CalibrationDraws& draws,
                                                 const LevelStates& states, std::size_t level) {
  std::vector<std::vector<double>> losses(draws.unknowns.count());
  if (states.at(level)) {
    const std::vector<LinearLoss> about = losses_about(evidence, draws.unknowns, states, level);
    Eigen::VectorXd mean = draws.mean();
    mean.tail(draws.unknowns.mode_count()) = offset_coefficients(draws.unknowns.modes(), states);
    for (std::size_t j = 0; j < losses.size(); ++j) {
      // The joint is the mean of the draws; linear damping beside it is added to its band later.
      const std::size_t index = draws.unknowns.index(j);
      const double a = used_amplitude(evidence, states, level, index);
      const double slip =
          about[j].value - states.structure().joints()[index].linear_damping * a * a;
      for (const Eigen::VectorXd& x : draws.posterior) {
        losses[j].push_back(std::max(0.0, slip + about[j].slope.dot(x - mean)));
      }
    }
    return losses;
  }
  for (std::size_t j = 0; j < losses.size(); ++j) {
    const double a = used_amplitude(evidence, states, level, draws.unknowns.index(j));
    const Eigen::RowVectorXd row = draws.unknowns.of(j).dissipation_row(a);
    for (const Eigen::VectorXd& x : draws.posterior) {
      losses[j].push_back(std::max(0.0, row.dot(draws.unknowns.part(j, x))));
    }
  }
  return losses;
}

/// The losses at the true displacement of the response point, of which the measured one has an
/// error: the same one for all joints in each draw.
/// @param share   change of the loss of each joint of the structure by one standard deviation of
///                that, J.
/// @param losses  [joint][draw], J.
std::vector<std::vector<double>> at_true_displacement(const AllUnknowns& unknowns,
                                                      const std::vector<double>& share,
                                                      RandomStream& random,
                                                      std::vector<std::vector<double>> losses) {
  if (std::ranges::all_of(share, [](double each) { return each == 0.0; })) return losses;
  for (std::size_t i = 0; i < losses.front().size(); ++i) {
    const double error = random.normal();
    for (std::size_t j = 0; j < losses.size(); ++j) {
      losses[j][i] = std::max(0.0, losses[j][i] + share[unknowns.index(j)] * error);
    }
  }
  return losses;
}

void read_vibration(const CalibrationEvidence& evidence, const LevelStates& states,
                    std::size_t level, CalibratedLevel& fitted) {
  const SteadyVibration& vibration = *states.at(level);
  fitted.found = true;
  fitted.frequency =
      vibration.frequency() * std::exp(-states.offset_taken(evidence.levels.mode[level]));
  fitted.damping_ratio = vibration.damping_ratio();
  fitted.dissipation = 0.0;
  for (std::size_t j = 0; j < fitted.joints.size(); ++j) {
    fitted.dissipation += fitted.joints[j].dissipation.value;
  }
  const MeasuredLoss measured = measured_loss(evidence.levels, level, vibration);
  fitted.measured_dissipation = measured.value;
  if (measured.deviation > 0.0) fitted.measured_dissipation_std = measured.deviation;
  if (!std::isnan(fitted.measured_dissipation)) return;
  fitted.measured_dissipation = 0.0;  // of the parts, or NaN where one is missing
  for (const std::size_t column : evidence.column) {
    fitted.measured_dissipation +=
        column == CalibrationEvidence::kNone
            ? std::numeric_limits<double>::quiet_NaN()
            : ModalLevels::value(evidence.levels.joints[column].dissipation, level);
  }
}

CalibratedLevel read_level(const CalibrationEvidence& evidence, const AllUnknowns& unknowns,
                           const std::vector<std::vector<double>>& losses,
                           const CalibrationOptions& options, const LevelStates& states,
                           std::size_t level) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  CalibratedLevel fitted;
  fitted.measured_frequency = ModalLevels::value(evidence.levels.frequency, level);
  fitted.measured_dissipation = ModalLevels::value(evidence.levels.dissipation, level);
  fitted.frequency = fitted.dissipation = fitted.damping_ratio = kUnknown;
  fitted.measured_dissipation_std = kUnknown;
  fitted.residual = fitted.frequency_residual = kUnknown;
  for (std::size_t joint = 0; joint < states.structure().joints().size(); ++joint) {
    const StructuralJoint& placed = states.structure().joints()[joint];
    const double a = used_amplitude(evidence, states, level, joint);
    const double loss = dissipation(placed.joint, a) + placed.linear_damping * a * a;
    fitted.joints.push_back({states.amplitude(level, joint),
                             evidence.measured_amplitude(level, joint),
                             {loss, loss, loss}});
  }
  for (std::size_t j = 0; j < losses.size(); ++j) {
    JointAtLevel& joint = fitted.joints[unknowns.index(j)];
    const auto [lower, upper] = band_of_loss(losses[j], options.confidence);
    const StructuralJoint& placed = states.structure().joints()[unknowns.index(j)];
    const double a = used_amplitude(evidence, states, level, unknowns.index(j));
    const double beside = placed.linear_damping * a * a;
    joint.dissipation.lower = lower + beside;
    joint.dissipation.upper = upper + beside;
  }
  if (states.at(level)) read_vibration(evidence, states, level, fitted);
  return fitted;
}

/// The offsets of the modes of the draws.
FoundModes modes_of_draws(const CalibrationDraws& draws, std::size_t modes) {
  Spread spread(draws.unknowns.mode_count());
  for (const Eigen::VectorXd& x : draws.posterior) {
    const std::vector<double> offsets = draws.unknowns.offsets(x);
    spread.add(Eigen::Map<const Eigen::VectorXd>(offsets.data(), spread.size()));
  }
  const std::vector<double> mean = draws.unknowns.offsets(draws.mean());
  const auto end = mean.begin() + static_cast<std::ptrdiff_t>(modes);
  FoundModes found{.offset = {mean.begin(), end}, .springs = {end, mean.end()}};
  const Eigen::VectorXd variance = spread.variance();
  for (std::size_t i = 0; i < modes; ++i) {
    found.deviation.push_back(std::sqrt(variance(static_cast<Eigen::Index>(i))));
  }
  return found;
}

/// The modes that explain the offsets; nothing where no structure has them.
void read_found_modes(const CalibrationEvidence& evidence, const CalibrationDraws& draws,
                      const LevelStates& states, CalibrationResult& result) {
  if (evidence.frequency != FrequencyUse::kChange) return;
  if (draws.unknowns.mode_count() > 0) {
    result.modes = modes_of_draws(draws, states.structure().linear().size());
    return;
  }
  try {
    result.modes = found_modes(states.given(), level_offsets(evidence.levels, states));
  } catch (const InputError&) {
  }
}

}  // namespace

void read_calibration(const CalibrationEvidence& evidence, const CalibrationOptions& options,
                      const CalibratedState& state, GrowingRange& range, LevelStates& states,
                      CalibrationResult& result) {
  const CalibrationDraws draws =
      draw_all(range.with_others(state), range.least_scatter(), options.draws, options.seed);
  const std::vector<Joint> joints = range.joints(draws.unknowns, draws.mean());
  states.set_joints(joints);
  if (draws.unknowns.mode_count() > 0) states.correct(draws.unknowns.offsets(draws.mean()));
  std::vector<std::size_t> all(evidence.levels.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::size_t> left_out;  // of the fit: their results now are not reliable
  for (const std::size_t level : all) {
    if (!states.at(level)) left_out.push_back(level);
  }
  states.solve(all);
  for (const std::size_t level : left_out) states.drop(level);

  result.confidence = options.confidence;
  result.loss_std_given = evidence.loss_std_given;
  result.frequency_std_given = evidence.frequency_std_given;
  result.loss_scatter = state.settled.weights.of(RowKind::kLoss);
  result.frequency_scatter = state.evidence.of(RowKind::kFrequency).has_freedom()
                                 ? state.settled.weights.of(RowKind::kFrequency)
                                 : 0.0;
  result.sensor_scatter = state.evidence.of(RowKind::kAmplitude).has_freedom()
                              ? state.settled.weights.of(RowKind::kAmplitude)
                              : 0.0;
  result.edges_sought = range.edges_sought();
  result.edf = state.settled.edf;
  read_joints(evidence, options, state, draws, joints, states, result);
  read_edges(range, result);
  read_variance_reduction(draws, result);
  std::vector<std::vector<std::vector<double>>> losses;
  for (const std::size_t level : all) {
    losses.push_back(losses_of_draws(evidence, draws, states, level));
    std::vector<std::vector<double>> banded = losses.back();
    if (states.at(level)) {
      RandomStream random(options.seed, kDisplacementStream - level);
      const LevelDeviations deviations = deviations_about(evidence, draws.unknowns, states, level);
      banded = at_true_displacement(draws.unknowns, deviations.by_displacement, random,
                                    std::move(banded));
    }
    result.levels.push_back(read_level(evidence, draws.unknowns, banded, options, states, level));
  }
  read_losses(losses, result);
  read_offsets(evidence, states, result);
  read_found_modes(evidence, draws, states, result);
  read_deviations(evidence, draws.unknowns, states, losses, result);
}

}  // namespace microslip
