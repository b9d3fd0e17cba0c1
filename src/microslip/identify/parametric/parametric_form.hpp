// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/identify/parametric/parametric_model.hpp"
#include "microslip/joint/joint.hpp"
#include "microslip/observe/levels.hpp"

/// @file
/// The densities of parametric.hpp as the search sees them. Internal: not installed.

namespace microslip {

/// The admissible range of one unknown q, and its one-to-one map from the real line:
/// q = lower + scale·e^u where upper is infinite, else q = lower + (upper − lower)/(1 + e^−u).
struct Coordinate {
  double lower;
  double upper;
  double scale;         ///< of q − lower; for an infinite upper
  bool lower_admitted;  ///< the bound itself belongs to the range
  bool upper_admitted;

  [[nodiscard]] double value(double u) const;
  [[nodiscard]] double inverse(double q) const;  ///< q strictly inside
};

/// One parametric density over coordinates q that suit the search; parameter i of the report is at
/// a bound where coordinate i is.
class ParametricForm {
 public:
  struct Name {
    std::string name;
    std::string unit;
  };

  virtual ~ParametricForm() = default;

  [[nodiscard]] virtual std::vector<Name> names() const = 0;
  [[nodiscard]] virtual std::vector<Coordinate> coordinates() const = 0;
  [[nodiscard]] virtual Joint joint(std::span<const double> q) const = 0;
  /// The parameters of the report, from q.
  [[nodiscard]] virtual std::vector<double> parameters(std::span<const double> q) const = 0;
  /// A coarse grid of q inside of the ranges.
  [[nodiscard]] virtual std::vector<std::vector<double>> grid() const = 0;
  /// Starts beyond the kinks near q: places where the sum of squares has a minimum of its own.
  [[nodiscard]] virtual std::vector<std::vector<double>> neighbours(
      std::span<const double> q) const = 0;
  /// Warnings where the levels do not determine this q.
  [[nodiscard]] virtual std::vector<Warning> limits(std::span<const double> q) const = 0;
};

/// @param levels  checked.
[[nodiscard]] std::unique_ptr<ParametricForm> make_parametric_form(ParametricModel model,
                                                                   const Levels& levels,
                                                                   double stiffness);

}  // namespace microslip
