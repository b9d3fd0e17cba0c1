// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/sensor_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr double kModel = 0.2;  // of the slope: what softer joints miss of those that slip

/// Shares of stiffness that are gone through, from all of it on.
constexpr int kShares = 40;

/// Points at which a mode is looked at, by rising frequency.
struct Softening {
  std::vector<double> log_omega;
  std::vector<double> log_motion;

  /// Of ln ω, from the softest to the stuck joints.
  [[nodiscard]] double reach() const {
    return log_omega.empty() ? 0.0 : log_omega.back() - log_omega.front();
  }
};

double motion_at(const std::vector<double>& shape, std::span<const double> point) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) sum += shape[i] * point[i];
  return std::abs(sum);
}

/// @param softens  whether a joint loses stiffness, one per joint.
Softening soften(const JointedStructure& structure, std::size_t mode, std::span<const double> point,
                 const std::vector<bool>& softens) {
  constexpr double kSame = 1e-10;    // of ω: no change
  constexpr double kVanished = 0.1;  // of the motion with stuck joints: a node passes the point
  std::vector<double> shape = structure.stuck_mode(mode);
  const double stuck = motion_at(shape, point);
  Softening course;
  if (!(stuck > 0.0)) return course;
  for (int i = 0; i < kShares; ++i) {
    const double share = 1.0 - static_cast<double>(i) / kShares;
    std::vector<double> shares;
    for (const bool each : softens) shares.push_back(each ? share : 1.0);
    SoftenedMode softer = structure.softened_mode(shares, shape);
    const double motion = motion_at(softer.shape, point) / stuck;
    const double log_omega = std::log(std::max(softer.angular_frequency, 1e-300));
    if (!(motion > kVanished)) break;
    if (i > 0 && !(log_omega < course.log_omega.back() - kSame)) break;
    course.log_omega.push_back(log_omega);
    course.log_motion.push_back(std::log(motion));
    shape = std::move(softer.shape);
  }
  std::ranges::reverse(course.log_omega);
  std::ranges::reverse(course.log_motion);
  return course;
}

/// d ln φ/d ln ω, by differences over the neighbours.
std::vector<double> slope_of(const Softening& course) {
  const std::size_t n = course.log_omega.size();
  std::vector<double> slope(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, n - 1);
    slope[i] = (course.log_motion[after] - course.log_motion[before]) /
               (course.log_omega[after] - course.log_omega[before]);
  }
  return slope;
}

ShapeCourse course_of(const Softening& softening) {
  if (softening.log_omega.size() < 2) return {};
  return {softening.log_omega, softening.log_motion, slope_of(softening), {}};
}

/// The courses in which one joint alone loses stiffness.
std::vector<Softening> of_each_joint(const JointedStructure& structure, std::size_t mode,
                                     std::span<const double> point) {
  std::vector<Softening> each;
  const std::size_t joints = structure.joints().size();
  if (joints < 2) return each;
  for (std::size_t j = 0; j < joints; ++j) {
    std::vector<bool> alone(joints, false);
    alone[j] = true;
    each.push_back(soften(structure, mode, point, alone));
  }
  return each;
}

}  // namespace

ShapeCourse shape_course(const JointedStructure& structure, std::size_t mode,
                         std::span<const double> point) {
  ShapeCourse course =
      course_of(soften(structure, mode, point, std::vector<bool>(structure.joints().size(), true)));
  if (course.empty()) return course;
  struct Alone {
    ShapeCourse course;
    double reach;
  };
  std::vector<Alone> alone;
  for (const Softening& each : of_each_joint(structure, mode, point)) {
    ShapeCourse own = course_of(each);
    if (!own.empty()) alone.push_back({std::move(own), each.reach()});
  }
  for (std::size_t i = 0; i < course.log_omega.size(); ++i) {
    const double omega = std::exp(course.log_omega[i]);
    const double change = course.log_omega.back() - course.log_omega[i];
    double squares = 0.0;
    double weights = 0.0;
    for (const Alone& joint : alone) {
      const double weight = change > joint.reach ? joint.reach / change : 1.0;
      const double off = joint.course.slope_at(omega) - course.slope[i];
      squares += weight * off * off;
      weights += weight;
    }
    const double scatter = weights > 0.0 ? std::sqrt(squares / weights) : 0.0;
    course.slope_std.push_back(std::hypot(kModel * course.slope[i], scatter));
  }
  return course;
}

}  // namespace microslip
