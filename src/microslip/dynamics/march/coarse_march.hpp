// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "microslip/dynamics/march/load_history.hpp"
#include "microslip/dynamics/march/march_loads.hpp"
#include "microslip/dynamics/march/march_options.hpp"
#include "microslip/dynamics/march/march_state.hpp"
#include "microslip/dynamics/march/march_weights.hpp"
#include "microslip/dynamics/structure/jointed_structure.hpp"

namespace microslip {

/// Steps of equal length over intervals. Internal to dynamics.
class EvenSteps {
 public:
  explicit EvenSteps(const JointedStructure& structure) : weights_(structure.linear().modes()) {}

  /// The least number of steps over an interval that are not longer, in pairs where that is asked
  /// for.
  [[nodiscard]] static std::size_t count(double length, double longest, bool in_pairs);

  /// Sets the following steps: the length of an interval and their number.
  void set(double length, std::size_t count);

  /// @return false where it failed.
  [[nodiscard]] bool take(MarchState& state) const { return state.step(weights_); }

 private:
  StepWeights weights_;
};

/// A march with twice the step, to estimate the error of another. Internal to dynamics.
class CoarseMarch {
 public:
  CoarseMarch(const JointedStructure& structure, const LoadHistory& loads,
              const MarchOptions& options);

  void start(const MarchLoads& acting, const InitialState& start);

  /// For the steps over an interval by their number.
  void set(const MarchLoads& acting, std::size_t interval, double length, std::size_t count);

  /// Takes a step, to be compared with two steps of the other.
  void take(const MarchState& fine);

  /// As MarchResult::error_estimate: none where it failed, or there was nothing to compare with.
  [[nodiscard]] std::optional<double> error() const;

 private:
  struct Difference {
    double difference = 0.0;  ///< largest so far, m
    double largest = 0.0;     ///< largest displacement about the rest so far, m
    double rest = 0.0;        ///< displacement under static loads, m
  };

  /// w of a point.
  [[nodiscard]] double moved(const MarchState& state, std::size_t point) const;
  void compare(const MarchState& fine);

  MarchState state_;
  EvenSteps steps_;
  bool second_order_;
  bool failed_ = false;
  bool compared_ = false;
  std::vector<std::span<const double>> shapes_;
  std::vector<Difference> differences_;
};

}  // namespace microslip
