// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// How a numerical method ended.
enum class Status {
  kNotRun,        ///< nothing was computed
  kConverged,     ///< the stopping rule of the method holds
  kNotConverged,  ///< it does not; the result is the best that was found
};

/// "not run", "converged", "not converged".
[[nodiscard]] std::string_view to_string(Status status);

/// What every numerical method says about its run. Pessimistic until filled in.
struct Summary {
  Status status = Status::kNotRun;     ///< how it ended
  std::string method;                  ///< "regularised convex inversion"
  std::string reason = "was not run";  ///< why it stopped, in words
  double residual = 0.0;               ///< what the stopping rule measures, relative, 1
  int iterations = 0;                  ///< that it took
  double wall_seconds = 0.0;           ///< wall time, s

  /// Whether the stopping rule holds.
  [[nodiscard]] bool converged() const { return status == Status::kConverged; }

  /// One line: method, status, iterations, residual, time.
  [[nodiscard]] std::string brief() const;
  /// A line a fact.
  [[nodiscard]] std::string full() const;
};

/// Something in the data or the result that its user must know of. Never an error.
struct Warning {
  std::string code;  ///< stable, for scripts: "density_negative"
  std::string text;  ///< one sentence with the figures, and what to do about it
};

}  // namespace microslip
