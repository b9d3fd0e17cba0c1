// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/ensemble/team.hpp"

/// @file
/// An ensemble from its plan to its result. Finished blocks are kept in a journal beside the
/// result, `RESULT.journal` or of a share `RESULT.3-of-20.journal`, so that a stop costs only the
/// blocks in work; a run takes the blocks of all of them and does the rest.

namespace microslip {

/// A share of the blocks of an ensemble: number i of n has blocks i − 1, i − 1 + n, …
struct EnsembleShard {
  std::uint64_t number = 1;  ///< i, from 1
  std::uint64_t count = 1;   ///< n, ≥ i

  /// "3/20". @throws InputError  for anything else.
  [[nodiscard]] static EnsembleShard parse(const std::string& text);
};

/// Options of run_ensemble().
struct EnsembleRun {
  std::string plan;                         ///< path of the plan
  std::string out;                          ///< of the result, HDF5
  std::string table;                        ///< of the table, CSV
  std::optional<EnsembleShard> shard = {};  ///< only this share, and no result
  bool merge = false;                       ///< no jobs are run: all blocks must exist
  bool keep_journals = false;               ///< they stay where the result is written
  std::string command = {};                 ///< recorded in the table
  Progress progress = {};                   ///< of the jobs, those done before among them
  /// What must be known of the run while it lasts, and is no part of its result.
  std::function<void(const Warning&)> warned = {};
};

/// Result of run_ensemble().
struct FinishedEnsemble {
  EnsembleResult result;               ///< empty where shards are missing
  std::uint64_t jobs = 0;              ///< of the plan
  std::uint64_t done_before = 0;       ///< of these, found in journals
  std::uint64_t done_now = 0;          ///< by this run
  std::uint64_t failed = 0;            ///< of all that are done
  double wall_seconds = 0.0;           ///< of what was done now
  std::string journal = {};            ///< where a share stands; empty where the result does
  std::vector<Warning> warnings = {};  ///< what must be known of it
};

/// Reads the plan, does the jobs that are in no journal, and writes result and table: both or none.
/// @param run   the options; the same in all processes of the team.
/// @param team  the processes or threads.
/// @return none where this process does not coordinate.
/// @throws FileError, FormatError, InputError  as the readers; where a journal is of another plan,
///     other inputs or another version, naming what has changed; for a merge without all blocks,
///     naming what is missing.
/// @throws NothingFound  where more jobs fail than the plan allows: the journal keeps the finished
/// jobs.
/// @throws WriteError    where the disk is full: the journal keeps the finished jobs.
/// @throws Cancelled     as requested by progress.
[[nodiscard]] std::optional<FinishedEnsemble> run_ensemble(const EnsembleRun& run, Team& team);

/// The summary.
[[nodiscard]] std::string describe_ensemble(const EnsembleRun& run, const FinishedEnsemble& done);

}  // namespace microslip
