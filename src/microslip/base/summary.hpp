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
  kNoProgress,  ///< no step leads further; the result so far is there
  kDoubtful,    ///< its stopping rule holds, but a check of the result does not
  kIncomplete,  ///< some of several results were not found; those that are there converged
};

/// Status that files give for a converged run.
inline constexpr std::string_view kConvergedStatus = "converged";

/// Report of every numerical method on its run. Pessimistic until filled in.
struct Summary {
  /// A part of the run.
  struct Timing {
    std::string what;      ///< "choice of the smoothing"
    double seconds = 0.0;  ///< wall time, s
  };

  Stop stop = Stop::kNotRun;           ///< why it stopped
  std::string method;                  ///< "regularised convex inversion"
  std::string reason = "was not run";  ///< why it stopped, in words
  double residual = 0.0;               ///< quantity of the stopping rule, relative, 1
  int iterations = 0;                  ///< that it took
  double wall_seconds = 0.0;           ///< wall time, s
  std::vector<Timing> timings = {};    ///< of its parts; need not add up to all of it

  /// Whether the stopping rule holds and no check of the result failed.
  [[nodiscard]] bool converged() const {
    return stop == Stop::kConverged || stop == Stop::kClosedForm;
  }
  /// Whether there is a result to use, with the reason in mind: parts of it may be missing, or it
  /// may be the best of an unfinished search.
  [[nodiscard]] bool usable() const { return stop != Stop::kNotRun && stop != Stop::kDoubtful; }

  /// The status as files give it: "not run", "converged", "not converged".
  [[nodiscard]] std::string_view status() const;

  /// One line: method, status, iterations, residual, time.
  [[nodiscard]] std::string brief() const;
  /// One line per item.
  [[nodiscard]] std::string full() const;
};

/// A finding about the data or the result that the user must know. Never an error.
struct Warning {
  std::string code;  ///< stable, for scripts: "density_negative"
  std::string text;  ///< one sentence with the figures, and what to do about it
};

}  // namespace microslip
