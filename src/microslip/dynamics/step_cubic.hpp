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
  double start, v0, v1, c, b;
};

}  // namespace microslip
