// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/dynamics/harmonic/balance_equations.hpp"
#include "microslip/dynamics/harmonic/newton.hpp"
#include "microslip/dynamics/structure/hermite.hpp"

namespace microslip {

struct ContinuationOptions {
  NewtonOptions newton;
  double largest_change;  ///< of the response and of each joint's motion in a step, relative
  int least_points;
  int max_points;
  double accuracy = 0.0;                 ///< of the polygon through the points; 0: none added
  std::vector<double> frequencies = {};  ///< ω of points to be there as well, rad/s
};

/// Follows the curve on which one target is kept, by pseudo-arclength continuation: a step along
/// the tangent with the last curvature, then Newton's method on the plane across the tangent. The
/// length is measured in z over its scale at the present point, ω over the range where ω changes.
///
/// Where an atom starts or ceases to slip on a branch the derivatives jump and the curve has a
/// corner: such a point is found by that condition, and has a tangent for each side. So it is where
/// two extremes of a joint's motion become equal, which is checked where the curve does not
/// continue otherwise. Corners, peaks and folds become points, so that the curve is smooth between
/// two of them; then points are added between until the polygon through them is as close to the
/// curve as required. Internal to dynamics.
class Continuation {
 public:
  Continuation(BalanceEquations& equations, ContinuationOptions options, const Target& kept,
               Quantity along, double from, double to);

  /// Follows the curve from the solution z at `from` to `to`, or to where it ends. Fills all of the
  /// curve but the time; the reason names what was not found.
  /// @throws Cancelled  as requested by progress.
  void run(const Eigen::VectorXd& z, ResponseCurve& curve, const Progress& progress);

 private:
  /// A direction of the curve at a point.
  struct Ray {
    Eigen::VectorXd tangent;    ///< in relative z, of length 1
    Eigen::VectorXd curvature;  ///< its derivative by the length; empty where not known
    double along_slope = 0.0;   ///< d along/ds
    double gain_slope = 0.0;    ///< d ln(response/force)/ds
    double change_rate = 0.0;   ///< relative change per length
    /// Sign of det(derivatives; tangent), the same all along a curve; 0 where that is not so.
    int side = 0;
  };

  /// An onset next to the motion of a branch.
  struct Neighbour {
    Onset onset;
    double miss;      ///< relative
    double distance;  ///< up to it by the tangent onward; infinite where that leads away
  };

  /// A point of the curve. The two rays differ at a corner alone.
  struct Point {
    Eigen::VectorXd z;
    Eigen::VectorXd scale;
    std::complex<double> response;
    double along = 0.0;
    double height = 0.0;  ///< what is drawn over the frequency: the response, or the force
    Ray arrival;
    Ray onward;
    std::vector<std::size_t> slipping;  ///< behind it
    std::vector<Neighbour> neighbours;
    bool is_peak = false;
  };

  struct Row {
    Point point;
    SteadyVibration vibration;
    double strayed = 0.0;  ///< a harmonic from where the tangents had it expected, relative
  };

  /// Points beside two neighbours, on the same smooth piece of the curve; null where there is none.
  struct Around {
    const Point* before = nullptr;
    const Point* after = nullptr;
  };

  // Points and steps.
  [[nodiscard]] static bool is_corner(const Point& point);
  [[nodiscard]] static HermiteKnot knot(const Point& point, const Ray& ray, const Point& origin,
                                        const Eigen::VectorXd& normal);
  [[nodiscard]] Eigen::RowVectorXd along_row(const Eigen::VectorXd& scale) const;
  [[nodiscard]] Point place_at(const Eigen::VectorXd& z) const;
  [[nodiscard]] Ray directed(const Eigen::VectorXd& scale, const Eigen::RowVectorXd& towards) const;
  [[nodiscard]] Ray ray_at(const Eigen::VectorXd& scale, const Eigen::RowVectorXd& towards) const;
  [[nodiscard]] Point point_at(const Eigen::VectorXd& z, const Eigen::VectorXd* direction) const;
  static void add_curvature(const Point& before, double length, Point& point);
  [[nodiscard]] static Eigen::VectorXd predicted(const Point& from, double length);
  NewtonResult correct(const Point& from, double length, Eigen::VectorXd& z);
  [[nodiscard]] double change(const Point& from, const Eigen::VectorXd& z) const;
  [[nodiscard]] double wanted_length(const Point& point) const;
  [[nodiscard]] Eigen::VectorXd scale() const;
  bool find_next(const Point& point, double& length, Point& next);
  [[nodiscard]] bool smooth(const Point& point, double length, const Point& next) const;
  void put(double along, Eigen::VectorXd& z);
  void follow(Eigen::VectorXd z);
  bool step(Point& point, double& length);
  bool land(const Point& before, const Point& after, double limit);
  bool add(Point point);
  bool retraces();
  bool lies_on_earlier_piece(const Point& point);
  void stop(Stop why, const std::string& reason);
  [[nodiscard]] std::string place(const Point& point) const;
  void report_progress(double along);

  // Corners.
  void add_neighbours(Point& point) const;
  bool reach_corner(const Point& point, double& length, Point& next);
  bool corner_between(const Point& point, double& length, Point& next);
  bool reach_tie(const Point& point, double& length, Point& next);
  template <typename Condition>
  bool turn(const Point& point, const Condition& at, Eigen::VectorXd z, double& length,
            Point& next);
  template <typename Condition>
  bool leave(const Condition& at, double sign, double aside, Point& corner);

  // Peaks and folds.
  using Slope = std::function<double(const Ray&)>;
  std::map<double, Point> located(const Point& from, double length, const Point& to);
  [[nodiscard]] std::optional<double> vanishing(const Point& from, double length, double there,
                                                const Slope& slope, Point& found,
                                                std::string& reason);
  [[nodiscard]] bool in_range(const Point& point) const;

  // Points between those of the steps.
  struct Bridge;
  void draw_closely();
  void add_left_out();
  [[nodiscard]] std::vector<Row> walk(const Row& from, const Row& to);
  [[nodiscard]] std::array<double, 2> mark(const Point& point) const;
  [[nodiscard]] bool strays(const Row& from, const Row& to, const Row& row, double allowed) const;
  [[nodiscard]] bool is_coarse(const Row& from, const Row& to, const Around& around,
                               double allowed);
  void refine(const Row& from, const Row& to, const Around& around, double allowed, int depth,
              std::vector<Row>& rows);
  void refine_steps(const Row& from, const Row& to, double allowed, int depth,
                    std::vector<Row>& rows);
  void add_frequencies();
  [[nodiscard]] double strayed(const Bridge& bridge, const Eigen::VectorXd& z,
                               const Eigen::VectorXd& expected) const;
  [[nodiscard]] Around around(std::size_t i) const;
  [[nodiscard]] std::optional<Row> between(const Row& from, const Row& to, const Around& around,
                                           double share);
  [[nodiscard]] std::optional<Row> at_frequency(const Row& from, const Row& to, double frequency);
  [[nodiscard]] std::optional<Row> row_between(const Bridge& bridge, const Eigen::VectorXd& z,
                                               const NewtonResult& result);
  [[nodiscard]] std::vector<double> allowed_deviations() const;
  void hand_over(ResponseCurve& curve);

  BalanceEquations& equations_;
  BorderedFactors near_;  ///< of the last Newton step
  ContinuationOptions options_;
  Target kept_;
  Quantity along_;
  double from_;
  double to_;
  double longest_ = HUGE_VAL;  ///< step that may be taken
  bool quick_ = false;         ///< the last point took few iterations
  int retraced_ = 0;           ///< consecutive points on pieces followed before
  Progress progress_;
  double farthest_ = 0.0;  ///< share of the range that the curve has reached, 1
  std::vector<Row> rows_;
  Summary summary_;
  std::vector<Warning> warnings_;
};

}  // namespace microslip
