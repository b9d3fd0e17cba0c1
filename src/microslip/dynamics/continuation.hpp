// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/dynamics/balance_equations.hpp"
#include "microslip/dynamics/newton.hpp"

namespace microslip {

struct ContinuationOptions {
  NewtonOptions newton;
  double largest_change;  ///< of the response and of each joint's motion in a step, relative
  int least_points;
  int max_points;
};

/// Follows the curve on which one target is kept, by pseudo-arclength continuation: a step along the
/// tangent, bent as it was last, then Newton's method on the plane across the tangent. The length is
/// measured in z over its scale at the present point, ω over the range where that is what changes.
/// Internal to dynamics.
class Continuation {
 public:
  Continuation(BalanceEquations& equations, const ContinuationOptions& options, const Target& kept,
               Quantity along, double from, double to);

  /// From the solution z at `from` to `to`, or to where it ends. Fills all of the curve but the time;
  /// a peak that was not located is named in the reason.
  /// @throws Cancelled  where progress says so.
  void run(const Eigen::VectorXd& z, ResponseCurve& curve, const Progress& progress);

 private:
  /// A point of the curve and its tangent in relative z, of length 1.
  struct Point {
    Eigen::VectorXd z;
    Eigen::VectorXd scale;
    Eigen::VectorXd tangent;
    Eigen::VectorXd curvature;  ///< its derivative by the length; empty where not known
    std::complex<double> response;
    double along = 0.0;
    double along_slope = 0.0;  ///< d along/ds
    double orientation = 0.0;  ///< sign of det(derivatives, tangent)
    double gain_slope = 0.0;   ///< d ln(response/force)/ds
    double change_rate = 0.0;  ///< relative change per length
  };

  [[nodiscard]] Eigen::MatrixXd matrix(const Eigen::VectorXd& scale,
                                       const Eigen::RowVectorXd& last) const;
  [[nodiscard]] Point point_at(const Eigen::VectorXd& z, const Eigen::VectorXd* direction) const;
  static void add_curvature(const Point& before, double length, Point& point);
  NewtonResult correct(const Point& from, double length, Eigen::VectorXd& z);
  [[nodiscard]] double change(const Point& from, const Eigen::VectorXd& z) const;
  [[nodiscard]] double wanted_length(const Point& point) const;
  [[nodiscard]] Eigen::VectorXd scale() const;
  bool find_next(const Point& point, double& length, Point& next, ResponseCurve& curve);
  [[nodiscard]] bool smooth(const Point& point, double length, const Point& next) const;
  bool round_corner(const Point& point, double longest, double& length, Point& next,
                    ResponseCurve& curve);
  void follow(const Eigen::VectorXd& z, ResponseCurve& curve, const Progress& progress);
  bool step(Point& point, double& length, ResponseCurve& curve);
  void locate_peak(const Point& from, double length, double slope_there, ResponseCurve& curve);
  void keep_peak(const Point& peak, ResponseCurve& curve);
  void miss_peak(const Point& near, const std::string& reason);
  bool land(const Point& before, const Point& after, double limit, ResponseCurve& curve);
  bool add(const Eigen::VectorXd& z, ResponseCurve& curve);
  static void stop(ResponseCurve& curve, Status status, const std::string& reason);
  [[nodiscard]] std::string place(const Point& point) const;
  void tell(const Progress& progress, double along);

  BalanceEquations& equations_;
  ContinuationOptions options_;
  Target kept_;
  Quantity along_;
  double from_;
  double to_;
  bool quick_ = false;     ///< the last point took few iterations
  double farthest_ = 0.0;  ///< share of the range that the curve has reached, 1
  std::string missed_;     ///< the peaks that were not located, and why
};

}  // namespace microslip
