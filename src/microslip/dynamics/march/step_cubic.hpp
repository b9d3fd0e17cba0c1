// SPDX-License-Identifier: MIT
#pragma once

namespace microslip {

/// A signal over a step of a march by its values and slopes at both ends, over the share x of the
/// step. Internal to dynamics.
struct StepCubic {
  /// @param y0, y1    values. @param dy0, dy1  slopes in time. @param length  of the step, s.
  StepCubic(double y0, double dy0, double y1, double dy1, double length)
      : start(y0),
        v0(length * dy0),
        v1(length * dy1),
        c(v0 + v1 - 2.0 * (y1 - y0)),
        b(y1 - y0 - v0 - c) {}
  [[nodiscard]] double value(double x) const { return start + x * (v0 + x * (b + x * c)); }
  [[nodiscard]] double slope(double x) const { return v0 + x * (2.0 * b + 3.0 * x * c); }
  [[nodiscard]] double bend(double x) const { return 2.0 * b + 6.0 * x * c; }
  /// ∫ over the share from 0.
  [[nodiscard]] double integral(double x) const {
    return x * (start + x * (v0 / 2.0 + x * (b / 3.0 + x * c / 4.0)));
  }
  double start, v0, v1, c, b;
};

/// A signal over a step that also has the second derivative at the beginning: the cubic plus a
/// multiple of x²(1 − x)², which leaves the values and slopes at the ends.
class StepQuartic {
 public:
  /// @param bend  at the beginning, over the share squared.
  StepQuartic(const StepCubic& cubic, double bend)
      : start(cubic.start),
        v0(cubic.v0),
        v1(cubic.v1),
        b(0.5 * bend),
        d(b - cubic.b),
        c(cubic.c - 2.0 * d) {}
  [[nodiscard]] double value(double x) const {
    return start + x * (v0 + x * (b + x * (c + x * d)));
  }
  [[nodiscard]] double slope(double x) const {
    return v0 + x * (2.0 * b + x * (3.0 * c + 4.0 * x * d));
  }
  [[nodiscard]] double bend(double x) const { return 2.0 * b + x * (6.0 * c + 12.0 * x * d); }
  /// Slope of the bend.
  [[nodiscard]] double bend_slope(double x) const { return 6.0 * c + 24.0 * x * d; }
  double start, v0, v1, b, d, c;
};

}  // namespace microslip
