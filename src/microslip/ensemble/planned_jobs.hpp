// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/io/config/named_values.hpp"

/// @file
/// The jobs of an ensemble, whatever they compute and wherever they run.

namespace microslip {

/// Result of a job.
struct JobResult {
  /// Values of all outputs of the group in their order; NaN: the job has none. Empty where it
  /// failed.
  std::vector<double> values = {};
  std::string failure = {};  ///< why it failed; empty where it did not
};

/// All jobs of a plan, and what is to be known of them. Immutable; several threads may run jobs at
/// once.
class EnsembleJobs {
 public:
  EnsembleJobs() = default;
  EnsembleJobs(const EnsembleJobs&) = delete;
  EnsembleJobs& operator=(const EnsembleJobs&) = delete;
  virtual ~EnsembleJobs() = default;

  /// Job `index` of a group: a function of the plan, the inputs and the two numbers alone.
  [[nodiscard]] virtual JobResult run(std::size_t group, std::uint64_t index) const = 0;

  /// The groups, with different names.
  [[nodiscard]] const std::vector<EnsembleGroup>& groups() const { return groups_; }
  /// The files that they follow from, with their contents' SHA-256.
  [[nodiscard]] const std::vector<InputHash>& inputs() const { return inputs_; }
  /// Assumptions as text, one per line.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// Warnings of the inputs and of the methods.
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

 protected:
  // Filled by the constructor of each kind.
  std::vector<EnsembleGroup> groups_;  ///< of groups()
  std::vector<InputHash> inputs_;      ///< of inputs()
  std::vector<std::string> notes_;     ///< of notes()
  std::vector<Warning> warnings_;      ///< of warnings()
};

}  // namespace microslip
