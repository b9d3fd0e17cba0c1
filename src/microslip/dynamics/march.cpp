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
#include "microslip/dynamics/march_state.hpp"

namespace microslip {
namespace {

/// Squares of the motions it makes must stay numbers.
constexpr double kLargestForce = 1e12;  // N

using Clock = std::chrono::steady_clock;

constexpr double kStepsPerPeriod = 20.0;
// Of second order: as many as keep the energy to half of 1e-4.
constexpr double kStepsWithAtoms = 80.0;
constexpr double kStepsWithNormalLoad = 400.0;
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

double steps_per_period(const JointedStructure& structure, const LoadHistory& loads) {
  if (!loads.normal_loads.empty()) return kStepsWithNormalLoad;
  const bool atoms = std::ranges::any_of(structure.joints(), [](const StructuralJoint& joint) {
    return !joint.joint.density().atoms().slip_force.empty();
  });
  return atoms ? kStepsWithAtoms : kStepsPerPeriod;
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

/// Writes the state down at a recorded time.
class Recorder {
 public:
  Recorder(const JointedStructure& structure, const MarchOptions& options, std::size_t times,
           MarchResult& result)
      : result_(result) {
    const std::size_t records = (times - 1) / options.every + 2;
    result.time.reserve(records);
    for (const std::string& point : options.points) {
      shapes_.push_back(structure.linear().shape(point));
      result.points.push_back({point, {}, {}, {}});
      result.points.back().displacement.reserve(records);
      result.points.back().velocity.reserve(records);
      result.points.back().acceleration.reserve(records);
    }
    for (const StructuralJoint& joint : structure.joints()) {
      result.joints.push_back({joint.name, {}, {}});
      result.joints.back().displacement.reserve(records);
      result.joints.back().force.reserve(records);
    }
  }

  void record(double time, const MarchState& state) {
    result_.time.push_back(time);
    for (std::size_t p = 0; p < shapes_.size(); ++p) {
      double w = 0.0;
      double v = 0.0;
      double a = 0.0;
      for (std::size_t i = 0; i < shapes_[p].size(); ++i) {
        w += shapes_[p][i] * state.displacement()[i];
        v += shapes_[p][i] * state.velocity()[i];
        a += shapes_[p][i] * state.acceleration(i);
      }
      result_.points[p].displacement.push_back(w);
      result_.points[p].velocity.push_back(v);
      result_.points[p].acceleration.push_back(a);
    }
    for (std::size_t j = 0; j < result_.joints.size(); ++j) {
      result_.joints[j].displacement.push_back(state.joint(j).displacement());
      result_.joints[j].force.push_back(state.joint(j).force());
    }
  }

 private:
  std::vector<std::span<const double>> shapes_;
  MarchResult& result_;
};

/// The steps over one interval. @return how many were taken; fewer than wanted where one failed.
struct Interval {
  std::size_t wanted;
  std::size_t taken;
};

class Steps {
 public:
  Steps(const JointedStructure& structure, double longest)
      : weights_(structure.linear().modes()), longest_(longest) {}

  Interval take(double length, MarchState& state) {
    const double count = std::max(1.0, std::ceil(length / longest_ * (1.0 - kSameLength)));
    const double step = length / count;
    if (std::abs(step - weights_.length()) > kSameLength * step) weights_.set_length(step);
    const auto wanted = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < wanted; ++i) {
      if (!state.step(weights_)) return {wanted, i};
    }
    return {wanted, wanted};
  }

 private:
  StepWeights weights_;
  double longest_;
};

void finish(const MarchState& state, MarchResult& result) {
  result.energy = state.energy();
  for (std::size_t j = 0; j < result.joints.size(); ++j) {
    result.energy.joints[j].joint = result.joints[j].joint;
  }
  result.steps = state.steps();
  result.reversals = state.reversals();
  result.summary.iterations = static_cast<int>(std::min<std::size_t>(
      state.evaluations(), static_cast<std::size_t>(std::numeric_limits<int>::max())));
  result.summary.residual = result.energy.imbalance();
}

/// Why the march ended, where all its steps were taken.
void judge(const MarchOptions& options, double last, MarchResult& result) {
  Summary& s = result.summary;
  const bool balanced = s.residual <= options.largest_imbalance;
  s.status = balanced ? Status::kConverged : Status::kNotConverged;
  s.reason = balanced ? fmt::format("marched to {:.9g} s", last)
                      : fmt::format(
                            "the energy balance is off by {:.2g}, above {:.2g}; take "
                            "shorter steps",
                            s.residual, options.largest_imbalance);
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

double MarchEnergy::imbalance() const {
  const double left = initial + input;
  const double right =
      kinetic + elastic + linear_dissipation + joint_dissipation() + joint_stored();
  const double size = std::max(std::abs(left), std::abs(right));
  return left == right ? 0.0 : std::abs(left - right) / size;
}

MarchResult march(const JointedStructure& structure, const LoadHistory& loads,
                  const MarchOptions& options, const Progress& progress) {
  const auto begin = Clock::now();
  check_time(loads.time);
  check_forces(loads, structure.linear());
  check_normal_loads(loads, structure);
  check_options(options, structure.linear());
  const double step = chosen_step(structure, loads, options);
  check_step(step, loads.time);
  MarchResult result;
  result.summary.method = "time march, exponential Hermite";
  MarchState state(structure, hysteresis(structure, loads, options.elements), options);
  LoadsOfIntervals acting(structure, loads);
  Steps steps(structure, step);
  Recorder recorder(structure, options, loads.time.size(), result);
  const std::size_t intervals = loads.time.size() - 1;
  std::string failure;
  std::size_t told = 0;  // steps
  for (std::size_t k = 0; k < intervals && failure.empty(); ++k) {
    acting.set(k, state.loads());
    if (k == 0) {
      state.start(options.start);
      recorder.record(loads.time.front(), state);
    }
    const double length = loads.time[k + 1] - loads.time[k];
    const Interval interval = steps.take(length, state);
    if (interval.taken < interval.wanted) {
      const double share =
          static_cast<double>(interval.taken) / static_cast<double>(interval.wanted);
      failure = fmt::format(
          "step {}, from {:.9g} s on, did not converge in {} iterations: the joint forces still "
          "change by {:.2g}; take shorter steps",
          state.steps() + 1, loads.time[k] + share * length, options.max_iterations,
          state.last_change());
      break;
    }
    if ((k + 1) % options.every == 0 || k + 1 == intervals) {
      recorder.record(loads.time[k + 1], state);
    }
    if (progress && (state.steps() - told >= kStepsAWord || k + 1 == intervals)) {
      told = state.steps();
      if (!progress(k + 1, intervals)) throw Cancelled();
    }
  }
  finish(state, result);
  judge(options, loads.time.back(), result);
  if (!failure.empty()) {
    result.summary.status = Status::kNotConverged;
    result.summary.reason = failure;
  }
  result.summary.wall_seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return result;
}

}  // namespace microslip
