// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/march_damper.hpp"
#include "microslip/dynamics/march_state.hpp"

namespace microslip {
namespace {

/// Squares of the motions it makes must stay numbers.
constexpr double kLargestForce = 1e12;  // N

using Clock = std::chrono::steady_clock;

constexpr double kStepsPerPeriod = 20.0;
// Of second order: as many as keep the energy to half of 1e-4.
constexpr double kStepsWithManyAtoms = 80.0;
constexpr double kStepsWithNormalLoad = 400.0;
/// The difference of two marches with h and 2h, over the error of that with h: 2ᵖ − 1 with the order p
/// between 3 and 4, and with that of 2.
constexpr double kDifferenceOverError = 10.0;
constexpr double kDifferenceOverErrorOfSecondOrder = 3.0;
/// Lengths of intervals that differ by no more are the same: rounding of the time axis.
constexpr double kSameLength = 1e-9;
/// Steps between two words to the progress, and what is left of the interval.
constexpr std::size_t kStepsAWord = 4096;
/// More steps than this, an hour or so of one joint, are a mistake of units.
constexpr double kMostSteps = 1e10;

void require(bool holds, std::string_view what, double value, std::string_view rule) {
  if (!holds) throw InputError(what, value, rule);
}

// ---- Checks. ----

void check_time(const std::vector<double>& time) {
  require(time.size() >= 2, "number of times", static_cast<double>(time.size()),
          "must be at least 2");
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool rises = i == 0 || time[i] > time[i - 1];
    if (std::isfinite(time[i]) && rises) continue;
    throw InputError(fmt::format("time[{}]", i), time[i],
                     rises ? "must be finite" : "must be later than the time before it");
  }
}

void check_length(const std::string& what, std::size_t found, std::size_t wanted) {
  if (found == wanted) return;
  throw InputError(what, fmt::format("{} values", found), fmt::format("must have {}", wanted));
}

void check_forces(const LoadHistory& loads, const ModalModel& linear) {
  std::set<std::string_view> names;
  for (const PointForce& at : loads.forces) {
    (void)linear.shape(at.point);  // throws where there is none
    const std::string what = fmt::format("force at '{}'", at.point);
    if (!names.insert(at.point).second) throw InputError(what, "twice", "must be given once");
    check_length(what, at.force.size(), loads.time.size());
    for (std::size_t i = 0; i < at.force.size(); ++i) {
      if (std::abs(at.force[i]) <= kLargestForce) continue;
      throw InputError(fmt::format("{}, value {}", what, i), at.force[i],
                       fmt::format("must be finite, and {} N at most", kLargestForce));
    }
  }
}

void check_normal_loads(const LoadHistory& loads, const JointedStructure& structure) {
  std::set<std::string_view> names;
  for (const JointNormalLoad& given : loads.normal_loads) {
    const std::string what = fmt::format("normal load of joint '{}'", given.joint);
    if (!names.insert(given.joint).second) throw InputError(what, "twice", "must be given once");
    if (std::ranges::none_of(structure.joints(),
                             [&](const auto& joint) { return joint.name == given.joint; })) {
      throw InputError(what, given.joint, "must be that of a joint of the structure");
    }
    check_length(what, given.load.size(), loads.time.size());
    for (std::size_t i = 0; i < given.load.size(); ++i) {
      if (std::isfinite(given.load[i]) && given.load[i] >= 0.0) continue;
      throw InputError(fmt::format("{}, value {}", what, i), given.load[i],
                       "must be 0 or more, and finite");
    }
  }
}

void check_start(const std::vector<double>& values, const std::string& what, std::size_t modes) {
  if (!values.empty()) check_length(what, values.size(), modes);
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(std::isfinite(values[i]), fmt::format("{}[{}]", what, i), values[i], "must be finite");
  }
}

void check_options(const MarchOptions& o, const ModalModel& linear) {
  require(std::isfinite(o.step) && o.step >= 0.0, "step", o.step,
          "must be positive and finite, or 0 to have it chosen");
  require(o.every >= 1, "every", static_cast<double>(o.every), "must be at least 1");
  require(o.tolerance >= 1e-14 && o.tolerance <= 1e-4, "tolerance", o.tolerance,
          "must be from 1e-14 to 1e-4");
  require(o.max_iterations >= 2, "max_iterations", o.max_iterations, "must be at least 2");
  require(o.largest_imbalance > 0.0, "largest_imbalance", o.largest_imbalance, "must be positive");
  require(o.largest_error > 0.0, "largest_error", o.largest_error, "must be positive");
  std::set<std::string_view> names;
  for (const std::string& point : o.points) {
    (void)linear.shape(point);
    if (names.insert(point).second) continue;
    throw InputError("recorded point", point, "must be given once");
  }
  check_start(o.start.displacement, "start displacement", linear.size());
  check_start(o.start.velocity, "start velocity", linear.size());
}

// ---- The march. ----

bool has_many_atoms(const JointedStructure& structure) {
  return std::ranges::any_of(structure.joints(), [](const StructuralJoint& joint) {
    const SlipDensity& density = joint.joint.density();
    return !density.atoms().slip_force.empty() && corners_of(density).empty();
  });
}

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
  if (length / step <= kMostSteps) return;
  throw InputError("step", step,
                   fmt::format("must be at least {:.9g} s, {:.0e} of the time axis",
                               length / kMostSteps, 1.0 / kMostSteps),
                   "Take longer steps, or march over less time.");
}

std::vector<MarchedJoint> hysteresis(const JointedStructure& structure, const LoadHistory& loads,
                                     std::size_t elements) {
  std::vector<MarchedJoint> result;
  for (const StructuralJoint& joint : structure.joints()) {
    const auto load = std::ranges::find(loads.normal_loads, joint.name, &JointNormalLoad::joint);
    if (load == loads.normal_loads.end()) {
      result.emplace_back(joint);
    } else {
      result.emplace_back(joint, load->law, elements, load->load.front());
    }
  }
  return result;
}

/// What acts on the modes and joints over the intervals of the time axis.
class LoadsOfIntervals {
 public:
  LoadsOfIntervals(const JointedStructure& structure, const LoadHistory& loads) : history_(loads) {
    const std::size_t lanes = padded(structure.linear().size());
    for (const PointForce& at : loads.forces) {
      const auto shape = structure.linear().shape(at.point);
      shapes_.emplace_back(shape.begin(), shape.end()).resize(lanes, 0.0);
    }
    for (const JointNormalLoad& given : loads.normal_loads) {
      const auto joint = std::ranges::find(structure.joints(), given.joint, &StructuralJoint::name);
      joints_.push_back(static_cast<std::size_t>(joint - structure.joints().begin()));
    }
  }

  /// Sets all that is not constant.
  void set(std::size_t interval, MarchState::Loads& loads) const {
    const double length = history_.time[interval + 1] - history_.time[interval];
    std::ranges::fill(loads.force, 0.0);
    std::ranges::fill(loads.slope, 0.0);
    for (std::size_t p = 0; p < shapes_.size(); ++p) {
      const double* values = history_.forces[p].force.data() + interval;
      const double slope = (values[1] - values[0]) / length;
      for (std::size_t i = 0; i < shapes_[p].size(); ++i) {
        loads.force[i] += shapes_[p][i] * values[0];
        loads.slope[i] += shapes_[p][i] * slope;
      }
    }
    for (std::size_t n = 0; n < joints_.size(); ++n) {
      const double* values = history_.normal_loads[n].load.data() + interval;
      loads.normal[joints_[n]] = values[0];
      loads.normal_slope[joints_[n]] = (values[1] - values[0]) / length;
    }
  }

 private:
  const LoadHistory& history_;
  std::vector<std::vector<double>> shapes_;  // of the points with a force, padded
  std::vector<std::size_t> joints_;          // whose normal load varies
};

/// Makes a row of the state at a recorded time.
class Recorder {
 public:
  Recorder(const JointedStructure& structure, const MarchOptions& options, const MarchSink& sink)
      : sink_(sink),
        joint_displacement_(structure.joints().size()),
        joint_force_(structure.joints().size()) {
    for (const std::string& point : options.points) {
      shapes_.push_back(structure.linear().shape(point));
    }
    for (auto* values : {&displacement_, &velocity_, &acceleration_}) {
      values->resize(shapes_.size());
    }
  }

  void record(std::size_t index, double time, const MarchState& state) {
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
    }
    for (std::size_t j = 0; j < joint_displacement_.size(); ++j) {
      joint_displacement_[j] = state.joint(j).displacement();
      joint_force_[j] = state.joint(j).force();
    }
    sink_(
        {index, time, displacement_, velocity_, acceleration_, joint_displacement_, joint_force_});
  }

 private:
  const MarchSink& sink_;
  std::vector<std::span<const double>> shapes_;
  std::vector<double> displacement_, velocity_, acceleration_, joint_displacement_, joint_force_;
};

/// The steps over one interval. @return how many were taken; fewer than wanted where one failed.
struct Interval {
  std::size_t wanted;
  std::size_t taken;
};

/// Steps of equal length over an interval.
class Steps {
 public:
  explicit Steps(const JointedStructure& structure) : weights_(structure.linear().modes()) {}

  Interval take(double length, std::size_t count, MarchState& state) {
    const double step = length / static_cast<double>(count);
    if (std::abs(step - weights_.length()) > kSameLength * step) weights_.set_length(step);
    for (std::size_t i = 0; i < count; ++i) {
      if (!state.step(weights_)) return {count, i};
    }
    return {count, count};
  }

 private:
  StepWeights weights_;
};

/// The least number of steps over an interval, in pairs where that is asked for.
std::size_t step_count(double length, double longest, bool in_pairs) {
  const double pieces = in_pairs ? 2.0 : 1.0;
  return static_cast<std::size_t>(
      pieces * std::max(1.0, std::ceil(length / (pieces * longest) * (1.0 - kSameLength))));
}

/// A march with twice the step beside the one whose error it tells.
class CoarseMarch {
 public:
  CoarseMarch(const JointedStructure& structure, const LoadHistory& loads,
              const MarchOptions& options)
      : state_(structure, hysteresis(structure, loads, options.elements), options),
        steps_(structure),
        second_order_(!loads.normal_loads.empty() || has_many_atoms(structure)) {
    for (const std::string& point : options.points) {
      shapes_.push_back(structure.linear().shape(point));
    }
    differences_.resize(shapes_.empty() ? structure.joints().size() : shapes_.size());
  }

  void start(const LoadsOfIntervals& acting, const InitialState& start) {
    acting.set(0, state_.loads());
    state_.start(start);
  }

  /// Over an interval, to be held against where the other came to.
  void take(const LoadsOfIntervals& acting, std::size_t interval, double length, std::size_t count,
            const MarchState& fine) {
    if (failed_) return;
    acting.set(interval, state_.loads());
    const Interval done = steps_.take(length, count, state_);
    failed_ = done.taken < done.wanted;
    if (!failed_) compare(fine);
  }

  /// None where it failed, or there was nothing to be held against.
  [[nodiscard]] std::optional<double> error() const {
    if (failed_ || !compared_) return std::nullopt;
    double worst = 0.0;
    for (const Difference& d : differences_) {
      if (d.difference > 0.0) worst = std::max(worst, d.difference / d.largest);
    }
    return worst / (second_order_ ? kDifferenceOverErrorOfSecondOrder : kDifferenceOverError);
  }

 private:
  struct Difference {
    double difference = 0.0;  ///< largest so far, m
    double largest = 0.0;     ///< displacement so far, m
  };

  void compare(const MarchState& fine) {
    compared_ = true;
    for (std::size_t p = 0; p < differences_.size(); ++p) {
      double w = 0.0;
      double miss = 0.0;
      if (shapes_.empty()) {
        w = fine.joint(p).displacement();
        miss = w - state_.joint(p).displacement();
      } else {
        for (std::size_t i = 0; i < shapes_[p].size(); ++i) {
          w += shapes_[p][i] * fine.displacement()[i];
          miss += shapes_[p][i] * (fine.displacement()[i] - state_.displacement()[i]);
        }
      }
      Difference& d = differences_[p];
      d.difference = std::max(d.difference, std::abs(miss));
      d.largest = std::max(d.largest, std::abs(w));
    }
  }

  MarchState state_;
  Steps steps_;
  bool second_order_;
  bool failed_ = false;
  bool compared_ = false;
  std::vector<std::span<const double>> shapes_;
  std::vector<Difference> differences_;
};

void finish(const JointedStructure& structure, const MarchState& state, MarchResult& result) {
  result.energy = state.energy();
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
  s.status = Status::kNotConverged;
  if (s.residual > options.largest_imbalance || std::isnan(s.residual)) {
    s.reason = fmt::format("the energy balance is off by {:.2g}, above {:.2g}; take shorter steps",
                           s.residual, options.largest_imbalance);
  } else if (result.error_estimate && !(*result.error_estimate <= options.largest_error)) {
    s.reason = fmt::format(
        "the error of the displacements is estimated at {:.2g} of the largest, above {:.2g}; take "
        "shorter steps",
        *result.error_estimate, options.largest_error);
  } else {
    s.status = Status::kConverged;
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
                             "the error is not known: the march with twice the step, which tells "
                             "it, did not get on; take shorter steps."});
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
                   "linear damping of '{}', {:.6g} J/m^2, has no form in time; it is marched "
                   "as a viscous damper of {:.6g} N s/m, which loses the same at {:.5g} Hz, "
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
  if (structure.damping() != DampingLaw::kHysteretic) return;
  result.warnings.push_back({"hysteretic_as_viscous",
                             "hysteretic damping has no form in time; the damping is viscous with "
                             "the same loss factor at each natural frequency."});
}

}  // namespace

double MarchEnergy::joint_dissipation() const {
  double sum = 0.0;
  for (const JointEnergy& joint : joints) sum += joint.dissipation;
  return sum;
}

double MarchEnergy::joint_stored() const {
  double sum = 0.0;
  for (const JointEnergy& joint : joints) sum += joint.stored;
  return sum;
}

double MarchEnergy::joint_linear_dissipation() const {
  double sum = 0.0;
  for (const JointEnergy& joint : joints) sum += joint.linear_dissipation;
  return sum;
}

double MarchEnergy::imbalance() const {
  const double left = initial + input;
  const double right = kinetic + elastic + linear_dissipation + joint_dissipation() +
                       joint_linear_dissipation() + joint_stored();
  const double size = std::max(std::abs(left), std::abs(right));
  return left == right ? 0.0 : std::abs(left - right) / size;
}

MarchResult march_rows(const JointedStructure& structure, const LoadHistory& loads,
                       const MarchOptions& options, const MarchSink& sink,
                       const Progress& progress) {
  const auto begin = Clock::now();
  check_time(loads.time);
  check_forces(loads, structure.linear());
  check_normal_loads(loads, structure);
  check_options(options, structure.linear());
  const double longest = chosen_step(structure, loads, options);
  check_step(longest, loads.time);
  MarchResult result;
  result.summary.method = "time march, exponential Hermite";
  MarchState state(structure, hysteresis(structure, loads, options.elements), options);
  const LoadsOfIntervals acting(structure, loads);
  Steps steps(structure);
  Recorder recorder(structure, options, sink);
  std::optional<CoarseMarch> coarse;
  if (options.estimate_error && !structure.joints().empty()) {
    coarse.emplace(structure, loads, options);
    coarse->start(acting, options.start);
  }
  acting.set(0, state.loads());
  state.start(options.start);
  recorder.record(0, loads.time.front(), state);
  const std::size_t intervals = loads.time.size() - 1;
  std::string failure;
  std::size_t told = 0;  // steps
  for (std::size_t k = 0; k < intervals; ++k) {
    acting.set(k, state.loads());
    const double length = loads.time[k + 1] - loads.time[k];
    const std::size_t count = step_count(length, longest, coarse.has_value());
    const Interval interval = steps.take(length, count, state);
    if (interval.taken < interval.wanted) {
      const double share =
          static_cast<double>(interval.taken) / static_cast<double>(interval.wanted);
      failure = fmt::format(
          "step {}, from {:.9g} s on, did not converge in {} iterations, nor did pieces of it: the "
          "joint forces still change by {:.2g}; take shorter steps",
          state.steps() + 1, loads.time[k] + share * length, options.max_iterations,
          state.last_change());
      break;
    }
    if (coarse) coarse->take(acting, k, length, count / 2, state);
    if ((k + 1) % options.every == 0 || k + 1 == intervals) {
      recorder.record(k + 1, loads.time[k + 1], state);
    }
    if (progress && (state.steps() - told >= kStepsAWord || k + 1 == intervals)) {
      told = state.steps();
      if (!progress(k + 1, intervals)) throw Cancelled();
    }
  }
  finish(structure, state, result);
  add_error(coarse, structure, result);
  add_damping(structure, result);
  judge(options, loads.time.back(), result);
  if (!failure.empty()) {
    result.summary.status = Status::kNotConverged;
    result.summary.reason = failure;
  }
  result.summary.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return result;
}

MarchResult march(const JointedStructure& structure, const LoadHistory& loads,
                  const MarchOptions& options, const Progress& progress) {
  MarchResult rows;
  for (const std::string& point : options.points) rows.points.push_back({point, {}, {}, {}});
  for (const StructuralJoint& joint : structure.joints()) {
    rows.joints.push_back({joint.name, {}, {}});
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
