// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/sensor_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace microslip {
namespace {

constexpr double kModel = 0.2;  // of the slope: what softer joints miss of those that slip

/// Shares of stiffness that are gone through, from all of it on.
constexpr int kShares = 40;

/// Points at which a mode is looked at, by falling frequency.
struct Softening {
  std::vector<double> log_omega;
  std::vector<double> log_motion;
  bool ended = false;  ///< no further points: the frequency falls no more, or a node passes

  void add(double log, double motion) {
    constexpr double kSame = 1e-10;    // of ω: no change
    constexpr double kVanished = 0.1;  // of the motion with stuck joints: a node passes the point
    ended =
        ended || !(motion > kVanished) || (!log_omega.empty() && !(log < log_omega.back() - kSame));
    if (ended) return;
    log_omega.push_back(log);
    log_motion.push_back(std::log(motion));
  }

  /// Of ln ω, from the softest to the stuck joints.
  [[nodiscard]] double reach() const {
    return log_omega.empty() ? 0.0 : log_omega.front() - log_omega.back();
  }
};

/// Of each vibration that at each point.
using Softenings = std::vector<std::vector<Softening>>;

/// The vibration whose shape overlaps most with another: a mode followed while joints soften.
std::size_t nearest_shape(const SoftenedModes& modes, const std::vector<double>& shape) {
  std::size_t nearest = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < modes.shape.size(); ++i) {
    const double overlap = motion_at(modes.shape[i], shape);
    if (overlap > most) nearest = i;
    most = std::max(most, overlap);
  }
  return nearest;
}

/// @param softens  whether a joint loses stiffness, one per joint.
Softenings soften(const JointedStructure& structure,
                  std::span<const std::span<const double>> points,
                  const std::vector<bool>& softens) {
  const std::size_t count = structure.linear().vibrations();
  const SoftenedModes stuck =
      structure.softened_modes(std::vector<double>(structure.joints().size(), 1.0));
  std::vector<std::vector<double>> followed(stuck.shape.begin(),
                                            stuck.shape.begin() + static_cast<long>(count));
  Softenings courses(count, std::vector<Softening>(points.size()));
  for (int i = 0; i < kShares; ++i) {
    const double share = 1.0 - static_cast<double>(i) / kShares;
    std::vector<double> shares;
    for (const bool each : softens) shares.push_back(each ? share : 1.0);
    const SoftenedModes modes = structure.softened_modes(shares);
    for (std::size_t mode = 0; mode < count; ++mode) {
      const std::size_t now = nearest_shape(modes, followed[mode]);
      followed[mode] = modes.shape[now];
      const double log = std::log(std::max(modes.angular_frequency[now], 1e-300));
      for (std::size_t p = 0; p < points.size(); ++p) {
        const double before = motion_at(stuck.shape[mode], points[p]);
        const double motion = before > 0.0 ? motion_at(followed[mode], points[p]) / before : 0.0;
        courses[mode][p].add(log, motion);
      }
    }
  }
  return courses;
}

/// d ln φ/d ln ω, by differences over the neighbours.
std::vector<double> slope_of(const ShapeCourse& course) {
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
  ShapeCourse course{{softening.log_omega.rbegin(), softening.log_omega.rend()},
                     {softening.log_motion.rbegin(), softening.log_motion.rend()}};
  course.slope = slope_of(course);
  return course;
}

/// A course in which one joint alone loses stiffness.
struct AloneCourse {
  ShapeCourse course;
  double reach;
};

void set_slope_std(const std::vector<AloneCourse>& alone, ShapeCourse& course) {
  for (std::size_t i = 0; i < course.log_omega.size(); ++i) {
    const double omega = std::exp(course.log_omega[i]);
    const double change = course.log_omega.back() - course.log_omega[i];
    double squares = 0.0;
    double weights = 0.0;
    for (const AloneCourse& joint : alone) {
      const double weight = change > joint.reach ? joint.reach / change : 1.0;
      const double off = joint.course.slope_at(omega) - course.slope[i];
      squares += weight * off * off;
      weights += weight;
    }
    const double scatter = weights > 0.0 ? std::sqrt(squares / weights) : 0.0;
    course.slope_std.push_back(std::hypot(kModel * course.slope[i], scatter));
  }
}

/// Those in which one of several joints alone loses stiffness.
std::vector<Softenings> soften_each(const JointedStructure& structure,
                                    std::span<const std::span<const double>> points) {
  std::vector<Softenings> each;
  const std::size_t joints = structure.joints().size();
  for (std::size_t j = 0; joints > 1 && j < joints; ++j) {
    std::vector<bool> alone(joints, false);
    alone[j] = true;
    each.push_back(soften(structure, points, alone));
  }
  return each;
}

}  // namespace

double motion_at(std::span<const double> shape, std::span<const double> place) {
  return std::abs(std::inner_product(shape.begin(), shape.end(), place.begin(), 0.0));
}

std::vector<std::vector<ShapeCourse>> shape_courses(
    const JointedStructure& structure, std::span<const std::span<const double>> points) {
  const Softenings together =
      soften(structure, points, std::vector<bool>(structure.joints().size(), true));
  const std::vector<Softenings> each = soften_each(structure, points);
  std::vector<std::vector<ShapeCourse>> courses(together.size());
  for (std::size_t mode = 0; mode < together.size(); ++mode) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      ShapeCourse course = course_of(together[mode][p]);
      std::vector<AloneCourse> alone;
      for (const Softenings& joint : each) {
        ShapeCourse own = course_of(joint[mode][p]);
        if (!own.empty()) alone.push_back({std::move(own), joint[mode][p].reach()});
      }
      set_slope_std(alone, course);
      courses[mode].push_back(std::move(course));
    }
  }
  return courses;
}

}  // namespace microslip
