// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/requirement.hpp"
#include "microslip/base/work_size.hpp"

namespace microslip {
namespace {

/// Squares of the motions it makes must stay numbers.
constexpr double kLargestForce = 1e12;  // N

/// The steps keep dense matrices over all joints: as much memory as 28 of them; measured 29 and 26,
/// of 250 and 500 joints.
void check_joints(const JointedStructure& structure) {
  constexpr double kMatrices = 28.0;
  const double most = std::floor(std::sqrt(kMostMemory / (kMatrices * sizeof(double))));
  require(static_cast<double>(structure.joints().size()) <= most, "number of joints",
          static_cast<double>(structure.joints().size()),
          fmt::format("must be {:.0f} at most: the steps keep {:.0f} matrices of joints × joints, "
                      "and the limit is 1 GiB",
                      most, kMatrices),
          "Take fewer joints.");
}

void check_time(const std::vector<double>& time) {
  require(time.size() >= 2, "number of times", static_cast<double>(time.size()),
          "must be at least 2");
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool rises = i == 0 || time[i] > time[i - 1];
    if (std::isfinite(time[i]) && rises) continue;
    throw InputError(fmt::format("time[{}]", i), time[i],
                     rises ? "must be finite" : "must be later than the previous time");
  }
}

void check_length(const std::string& what, std::size_t found, std::size_t wanted) {
  if (found == wanted) return;
  throw InputError(what, fmt::format("{} values", found), fmt::format("must have {}", wanted));
}

void check_forces(const LoadHistory& loads, const ModalModel& linear) {
  std::set<std::string_view> names;
  for (const PointForce& at : loads.forces) {
    (void)linear.load(at.point);  // throws where there is none
    const std::string what = linear.is_base(at.point)
                                 ? fmt::format("acceleration of '{}'", at.point)
                                 : fmt::format("force at '{}'", at.point);
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

}  // namespace

void check_march(const JointedStructure& structure, const LoadHistory& loads,
                 const MarchOptions& options) {
  check_joints(structure);
  check_time(loads.time);
  check_forces(loads, structure.linear());
  check_normal_loads(loads, structure);
  check_options(options, structure.linear());
  if (!structure.static_loads().empty() && !options.start.displacement.empty()) {
    throw InputError("start displacement", "given with static loads",
                     "must be left out: the march begins at rest under them",
                     "Give a start velocity, or a force that is released.");
  }
}

}  // namespace microslip
