// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/base/work_size.hpp"
#include "microslip/dynamics/march/base_motion.hpp"
#include "microslip/dynamics/march/coarse_march.hpp"
#include "microslip/dynamics/march/march_checks.hpp"
#include "microslip/dynamics/march/march_damper.hpp"
#include "microslip/dynamics/march/march_loads.hpp"
#include "microslip/dynamics/march/march_state.hpp"
#include "microslip/dynamics/structure/density_corners.hpp"

namespace microslip {
namespace {

constexpr double kStepsPerPeriod = 20.0;
// Steps per period at second order: as many as keep the energy to half of 1e-4.
constexpr double kStepsWithManyAtoms = 80.0;
constexpr double kStepsWithNormalLoad = 400.0;
/// Steps between two words to the progress, and what is left of the interval.
constexpr std::size_t kStepsAWord = 4096;

double steps_per_period(const JointedStructure& structure, const LoadHistory& loads) {
  if (!loads.normal_loads.empty()) return kStepsWithNormalLoad;
  return has_many_atoms(structure) ? kStepsWithManyAtoms : kStepsPerPeriod;
}

double chosen_step(const JointedStructure& structure, const LoadHistory& loads,
                   const MarchOptions& options) {
  if (options.step > 0.0) return options.step;
  const double count = steps_per_period(structure, loads);
  const double highest = structure.stuck_frequencies().back();
  return highest > 0.0 ? 2.0 * std::numbers::pi / (count * highest) : HUGE_VAL;
}

void check_step(double step, const std::vector<double>& time) {
  const double length = time.back() - time.front();
  if (length / step <= kMostTimeSteps) return;
  throw InputError(
      "step", step,
      fmt::format("must be at least {:.9g} s: the time axis is {:.4g} s long, and {:.0e} "
                  "steps take an hour or more",
                  length / kMostTimeSteps, length, kMostTimeSteps),
      "Check the unit of time. March over a shorter time, or take longer steps.");
}

/// Peak and ∫ x² dt of signals, by the trapezium rule over times that need not be equally far
/// apart.
class SizeSums {
 public:
  explicit SizeSums(std::size_t signals) : peak_(signals), before_(signals), square_(signals) {}

  void add(double time, std::span<const double> values) {
    const double step = begun_ ? time - time_ : 0.0;
    for (std::size_t s = 0; s < values.size(); ++s) {
      const double now = values[s] * values[s];
      peak_[s] = std::max(peak_[s], std::abs(values[s]));
      square_[s] += 0.5 * step * (before_[s] + now);
      before_[s] = now;
    }
    length_ += step;
    time_ = time;
    begun_ = true;
  }

  [[nodiscard]] std::vector<SignalSize> sizes() const {
    std::vector<SignalSize> sizes;
    for (std::size_t s = 0; s < peak_.size(); ++s) {
      sizes.push_back({peak_[s], length_ > 0.0 ? std::sqrt(square_[s] / length_) : peak_[s]});
    }
    return sizes;
  }

 private:
  std::vector<double> peak_;
  std::vector<double> before_;  // x² at the last time
  std::vector<double> square_;
  double time_ = 0.0;
  double length_ = 0.0;
  bool begun_ = false;
};

/// Takes the state at each time of the axis: makes rows, and keeps the largest values.
class Recorder {
 public:
  /// @param result  receives the largest values.
  Recorder(const JointedStructure& structure, const LoadHistory& loads, const MarchOptions& options,
           const MarchSink& sink, MarchResult& result)
      : sink_(sink),
        result_(result),
        joint_displacement_(structure.joints().size()),
        joint_force_(structure.joints().size()),
        bases_(structure, loads, options.points),
        signals_((bases_.any() ? 2 : 1) * kOfPoint * options.points.size() +
                 kOfJoint * structure.joints().size()),
        sums_(signals_.size()) {
    for (const std::string& point : options.points) {
      shapes_.push_back(structure.linear().shape(point));
    }
    for (auto* values : {&displacement_, &velocity_, &acceleration_}) {
      values->resize(shapes_.size());
    }
    if (bases_.any()) absolute_.assign(kOfPoint, std::vector<double>(shapes_.size()));
  }

  /// Called at every step: the largest values need not be at a time of the axis.
  void watch(const MarchState& state, double time) {
    move_points(state);
    move_joints(state);
    move_along(time);
    sums_.add(time, signals_);
  }

  void finish() {
    result_.sizes = sums_.sizes();
    const auto peak = [&](std::size_t signal) { return result_.sizes[signal].peak; };
    for (std::size_t p = 0; p < shapes_.size(); ++p) {
      const std::size_t at = kOfPoint * p;
      result_.largest.push_back({peak(at), peak(at + 1), peak(at + 2)});
    }
    for (std::size_t j = 0; j < joint_force_.size(); ++j) {
      result_.reach.push_back(peak(place_of_joint(j)));
    }
  }

  /// Takes the state watched last, at a time of the axis.
  void take(std::size_t index, double time, bool recorded) {
    result_.reached = time;
    if (!recorded) return;
    MarchRow row{index,       time, displacement_, velocity_, acceleration_, joint_displacement_,
                 joint_force_};
    if (bases_.any()) {
      row.absolute_displacement = absolute_[0];
      row.absolute_velocity = absolute_[1];
      row.absolute_acceleration = absolute_[2];
    }
    sink_(row);
  }

 private:
  static constexpr std::size_t kOfPoint = 3;  // w, ẇ, ẅ
  static constexpr std::size_t kOfJoint = 2;  // u, F

  [[nodiscard]] std::size_t place_of_joint(std::size_t j) const {
    return kOfPoint * shapes_.size() + kOfJoint * j;
  }

  void move_points(const MarchState& state) {
    for (std::size_t p = 0; p < shapes_.size(); ++p) {
      double w = 0.0;
      double v = 0.0;
      double a = 0.0;
      for (std::size_t i = 0; i < shapes_[p].size(); ++i) {
        w += shapes_[p][i] * state.displacement()[i];
        v += shapes_[p][i] * state.velocity()[i];
        a += shapes_[p][i] * state.acceleration(i);
      }
      displacement_[p] = w;
      velocity_[p] = v;
      acceleration_[p] = a;
      std::ranges::copy(std::array{w, v, a},
                        signals_.begin() + static_cast<std::ptrdiff_t>(kOfPoint * p));
    }
  }

  void move_joints(const MarchState& state) {
    for (std::size_t j = 0; j < joint_force_.size(); ++j) {
      joint_displacement_[j] = state.joint(j).displacement();
      joint_force_[j] = state.joint(j).force();
      const std::size_t at = place_of_joint(j);
      signals_[at] = joint_displacement_[j];
      signals_[at + 1] = joint_force_[j];
    }
  }

  /// Adds the motion of bases to the points, after the points and the joints have moved.
  void move_along(double time) {
    if (!bases_.any()) return;
    bases_.advance_to(time);
    auto signal =
        signals_.begin() + static_cast<std::ptrdiff_t>(place_of_joint(joint_force_.size()));
    for (std::size_t p = 0; p < shapes_.size(); ++p) {
      const std::array<double, kOfPoint> carried = bases_.of(p);
      absolute_[0][p] = displacement_[p] + carried[0];
      absolute_[1][p] = velocity_[p] + carried[1];
      absolute_[2][p] = acceleration_[p] + carried[2];
      for (const std::vector<double>& values : absolute_) *signal++ = values[p];
    }
  }

  const MarchSink& sink_;
  MarchResult& result_;
  std::vector<std::span<const double>> shapes_;
  std::vector<double> displacement_, velocity_, acceleration_, joint_displacement_, joint_force_;
  BaseMotion bases_;
  std::vector<std::vector<double>> absolute_;  // w, ẇ, ẅ; one per point; empty without bases
  std::vector<double> signals_;  // all of these, one point after the other, then the joints
  SizeSums sums_;
};

/// The parts of a march over the time axis.
struct March {
  March(const JointedStructure& structure, const LoadHistory& of_time, const MarchOptions& given)
      : loads(of_time),
        options(given),
        acting(structure, of_time),
        state(structure, marched_joints(structure, of_time, given.elements), given),
        steps(structure) {
    if (given.estimate_error && !structure.joints().empty()) {
      coarse.emplace(structure, of_time, given);
      coarse->start(acting, acting.start(given.start));
    }
    acting.set(0, state.loads());
    state.start(acting.start(given.start));
  }

  /// To the end of the axis, or to where a step fails. @return why it failed; empty where it did
  /// not.
  [[nodiscard]] std::string run(double longest, Recorder& recorder, const Progress& progress) {
    const std::size_t intervals = loads.time.size() - 1;
    std::size_t reported = 0;  // steps
    recorder.watch(state, loads.time.front());
    recorder.take(0, loads.time.front(), true);
    for (std::size_t k = 0; k < intervals; ++k) {
      if (std::string failure = pass(k, longest, recorder); !failure.empty()) {
        return failure;
      }
      const bool last = k + 1 == intervals;
      recorder.take(k + 1, loads.time[k + 1], last || (k + 1) % options.every == 0);
      if (progress && (last || state.steps() - reported >= kStepsAWord)) {
        reported = state.steps();
        if (!progress(k + 1, intervals)) throw Cancelled();
      }
    }
    return "";
  }

  /// Over one interval. @return as run().
  [[nodiscard]] std::string pass(std::size_t interval, double longest, Recorder& recorder) {
    acting.set(interval, state.loads());
    const double begin = loads.time[interval];
    const double length = loads.time[interval + 1] - begin;
    const std::size_t count = EvenSteps::count(length, longest, coarse.has_value());
    steps.set(length, count);
    if (coarse) coarse->set(acting, interval, length, count / 2);
    for (std::size_t i = 0; i < count; ++i) {
      if (!steps.take(state)) {
        return failure(begin + length * static_cast<double>(i) / static_cast<double>(count));
      }
      recorder.watch(state,
                     begin + length * static_cast<double>(i + 1) / static_cast<double>(count));
      if (coarse && i % 2 == 1) coarse->take(state);
    }
    return "";
  }

  [[nodiscard]] std::string failure(double time) const {
    return fmt::format(
        "step {}, from {:.9g} s on, did not converge in {} iterations, nor did pieces of it: the "
        "joint forces still change by {:.2g}; take shorter steps",
        state.steps() + 1, time, options.max_iterations, state.last_change());
  }

  const LoadHistory& loads;
  const MarchOptions& options;
  MarchLoads acting;
  MarchState state;
  EvenSteps steps;
  std::optional<CoarseMarch> coarse;
};

void finish(const JointedStructure& structure, const MarchOptions& options, const MarchState& state,
            MarchResult& result) {
  result.energy = state.energy();
  if (!structure.static_loads().empty()) {
    double moving = 0.0;
    for (const double v : options.start.velocity) moving += 0.5 * v * v;
    result.energy.at_rest = result.energy.initial - moving;
  }
  for (std::size_t j = 0; j < result.energy.joints.size(); ++j) {
    result.energy.joints[j].joint = structure.joints()[j].name;
  }
  result.steps = state.steps();
  result.reversals = state.reversals();
  result.kinks = state.kinks();
  result.summary.iterations = static_cast<int>(std::min<std::size_t>(
      state.evaluations(), static_cast<std::size_t>(std::numeric_limits<int>::max())));
  result.summary.residual = result.energy.imbalance();
}

/// Why the march ended, where all its steps were taken.
void judge(const MarchOptions& options, double last, MarchResult& result) {
  Summary& s = result.summary;
  s.stop = Stop::kDoubtful;
  if (s.residual > options.largest_imbalance || std::isnan(s.residual)) {
    s.reason = fmt::format("the energy balance is off by {:.2g}, above {:.2g}; take shorter steps",
                           s.residual, options.largest_imbalance);
  } else if (result.error_estimate && !(*result.error_estimate <= options.largest_error)) {
    s.reason = fmt::format(
        "the error of the displacements is estimated at {:.2g} of the largest, above {:.2g}; take "
        "shorter steps",
        *result.error_estimate, options.largest_error);
  } else {
    s.stop = Stop::kConverged;
    s.reason = fmt::format("marched to {:.9g} s", last);
  }
}

void add_error(const std::optional<CoarseMarch>& coarse, const JointedStructure& structure,
               MarchResult& result) {
  if (structure.joints().empty()) result.error_estimate = 0.0;
  if (!coarse) return;
  result.error_estimate = coarse->error();
  if (result.error_estimate) return;
  result.warnings.push_back({"error_not_estimated",
                             "the error was not estimated: the march with twice the step, which it "
                             "needs, did not converge; take shorter steps."});
}

void add_damping_of_joints(const JointedStructure& structure, MarchResult& result) {
  for (std::size_t j = 0; j < structure.joints().size(); ++j) {
    const StructuralJoint& joint = structure.joints()[j];
    if (joint.linear_damping == 0.0) continue;
    const double omega = frequency_of_joint(structure, j);
    result.warnings.push_back(
        {"damping_as_viscous",
         omega > 0.0
             ? fmt::format(
                   "linear damping of '{}', {:.6g} J/m^2, has no time-domain form; it is marched "
                   "as a viscous damper of {:.6g} N s/m, which has the same loss at {:.5g} Hz, "
                   "the lowest natural frequency at which the stuck joint moves, and more "
                   "above.",
                   joint.name, joint.linear_damping, damper_of_joint(structure, j),
                   omega / (2.0 * std::numbers::pi))
             : fmt::format(
                   "linear damping of '{}', {:.6g} J/m^2, is not marched: the joint moves at "
                   "no natural frequency.",
                   joint.name, joint.linear_damping)});
  }
}

void add_damping(const JointedStructure& structure, MarchResult& result) {
  add_damping_of_joints(structure, result);
  const bool damped = std::ranges::any_of(structure.linear().modes(),
                                          [](const Mode& m) { return m.loss_factor > 0.0; });
  if (structure.damping() != DampingLaw::kHysteretic || !damped) return;
  result.warnings.push_back(
      {"hysteretic_as_viscous",
       "hysteretic damping has no time-domain form; the damping is viscous with "
       "the same loss factor at each natural frequency."});
}

}  // namespace

MarchResult march_rows(const JointedStructure& structure, const LoadHistory& loads,
                       const MarchOptions& options, const MarchSink& sink,
                       const Progress& progress) {
  const Stopwatch watch;
  check_march(structure, loads, options);
  const double longest = chosen_step(structure, loads, options);
  check_step(longest, loads.time);
  MarchResult result;
  result.summary.method = "time march, exponential Hermite";
  Recorder recorder(structure, loads, options, sink, result);
  March march(structure, loads, options);
  const std::string failure = march.run(longest, recorder, progress);
  recorder.finish();
  finish(structure, options, march.state, result);
  add_error(march.coarse, structure, result);
  add_damping(structure, result);
  judge(options, loads.time.back(), result);
  if (!failure.empty()) {
    result.summary.stop = Stop::kNoProgress;
    result.summary.reason = failure;
  }
  result.summary.wall_seconds = watch.seconds();
  return result;
}

MarchResult march(const JointedStructure& structure, const LoadHistory& loads,
                  const MarchOptions& options, const Progress& progress) {
  MarchResult rows;
  for (const std::string& point : options.points) rows.points.push_back({point, {}, {}, {}});
  for (const StructuralJoint& joint : structure.joints()) {
    rows.joints.push_back({joint.name, {}, {}});
  }
  const std::size_t most = loads.time.size() / std::max<std::size_t>(options.every, 1) + 2;
  rows.time.reserve(most);
  for (PointMotion& point : rows.points) {
    for (auto* values : {&point.displacement, &point.velocity, &point.acceleration}) {
      values->reserve(most);
    }
  }
  for (JointMotion& joint : rows.joints) {
    for (auto* values : {&joint.displacement, &joint.force}) values->reserve(most);
  }
  const auto keep = [&](const MarchRow& row) {
    rows.time.push_back(row.time);
    for (std::size_t p = 0; p < rows.points.size(); ++p) {
      rows.points[p].displacement.push_back(row.displacement[p]);
      rows.points[p].velocity.push_back(row.velocity[p]);
      rows.points[p].acceleration.push_back(row.acceleration[p]);
    }
    for (std::size_t j = 0; j < rows.joints.size(); ++j) {
      rows.joints[j].displacement.push_back(row.joint_displacement[j]);
      rows.joints[j].force.push_back(row.joint_force[j]);
    }
  };
  MarchResult result = march_rows(structure, loads, options, keep, progress);
  result.time = std::move(rows.time);
  result.points = std::move(rows.points);
  result.joints = std::move(rows.joints);
  return result;
}

}  // namespace microslip
