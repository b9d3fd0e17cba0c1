// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace microslip {

/// Why a numerical method stopped.
enum class Stop {
  kNotRun,      ///< nothing was computed
  kConverged,   ///< its stopping rule holds
  kClosedForm,  ///< there was nothing to iterate; converged
  kLimit,       ///< iterations, evaluations or points are used up
  kNoProgress,  ///< no step leads further; what was found until then is there
  kDoubtful,    ///< its stopping rule holds, but a check of the result does not
  kIncomplete,  ///< some of several results were not found; those that are there converged
};

/// What a file says of a run that converged.
inline constexpr std::string_view kConvergedStatus = "converged";

/// What every numerical method says about its run. Pessimistic until filled in.
struct Summary {
  /// A part of the run.
  struct Timing {
    std::string what;      ///< "choice of the smoothing"
    double seconds = 0.0;  ///< wall time, s
  };

  Stop stop = Stop::kNotRun;           ///< why it stopped
  std::string method;                  ///< "regularised convex inversion"
  std::string reason = "was not run";  ///< why it stopped, in words
  double residual = 0.0;               ///< what the stopping rule measures, relative, 1
  int iterations = 0;                  ///< that it took
  double wall_seconds = 0.0;           ///< wall time, s
  std::vector<Timing> timings = {};    ///< what took it; need not add up to all of it

  /// Whether the stopping rule holds and no check of the result failed.
  [[nodiscard]] bool converged() const {
    return stop == Stop::kConverged || stop == Stop::kClosedForm;
  }
  /// Whether there is a result to use, with the reason in mind: parts of it may be missing, or it
  /// may be the best of an unfinished search.
  [[nodiscard]] bool usable() const { return stop != Stop::kNotRun && stop != Stop::kDoubtful; }

  /// "not run", "converged", "not converged": what files say.
  [[nodiscard]] std::string_view status() const;

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
