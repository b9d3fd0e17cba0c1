// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/summary.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/study/ensemble_plan_file.hpp"
#include "microslip/io/config/named_values.hpp"
#include "microslip/io/output/output_files.hpp"

/// @file
/// The result of an ensemble as HDF5, schema microslip.ensemble_result/1. Attributes of the file:
/// schema, version, kind, seed, confidence, plan (its text), fingerprint (what the jobs follow
/// from, a line each), notes (warnings among them). Each group of jobs is a group of the file,
/// named as it, with the attributes jobs, failed and reasons (a line each), and for each output
///
///     OUTPUT         values × 8: count, mean, std, minimum, lower, median, upper, maximum;
///                    unit_str
///     OUTPUT axis    of a curve, one per value; its name and unit_str
///     OUTPUT values  jobs × values, NaN where a job has none, of the outputs that were asked for
///     failed jobs    the numbers of those that failed, the first kMostListed
///     grid N         values of axis N of a sweep, the last running fastest; number
///
/// The same plan and inputs make the same bytes, whoever did the jobs.

namespace microslip {

/// A quantity that each job of a group gives: a number, or a curve over an axis that all share.
struct EnsembleOutput {
  std::string name;               ///< "peak_frequency"
  Dimension dimension = {};       ///< of its values
  std::vector<double> axis = {};  ///< places of its values; empty: it is a number
  std::string axis_name = {};     ///< "frequency"; empty for a number
  Dimension axis_dimension = {};  ///< of the axis

  /// Values of a job.
  [[nodiscard]] std::size_t size() const { return axis.empty() ? 1 : axis.size(); }
};

/// Jobs that give the same.
struct EnsembleGroup {
  std::string name;                          ///< of the case or the design
  std::uint64_t jobs = 0;                    ///< how many there are
  std::vector<EnsembleOutput> outputs = {};  ///< in the order of the values of a job
  std::vector<SweepAxis> grid = {};          ///< whose points the jobs are; empty: of none

  /// Values of a job, of all outputs.
  [[nodiscard]] std::size_t width() const;
};

/// Statistics of the values of one quantity.
struct ColumnStatistics {
  std::uint64_t count = 0;  ///< values; without NaN, and without jobs that failed
  double mean = 0.0;        ///< NaN, as all that follow, where there is none
  double std = 0.0;         ///< √(Σ(x − mean)²/(n − 1)); 0 of one value
  double minimum = 0.0;     ///< of all
  double lower = 0.0;       ///< quantile (1 − P)/2, linear between neighbouring values
  double median = 0.0;      ///< quantile ½
  double upper = 0.0;       ///< quantile (1 + P)/2
  double maximum = 0.0;     ///< of all
};

/// Jobs that failed.
struct FailedJobs {
  /// Those that failed for one reason.
  struct Reason {
    std::string text;         ///< in words
    std::uint64_t count = 0;  ///< how many
    std::uint64_t first = 0;  ///< number of the first
  };

  std::uint64_t count = 0;           ///< how many
  std::vector<Reason> reasons = {};  ///< the first kMostReasons kinds, in the order of their jobs
  std::vector<std::uint64_t> jobs = {};  ///< the first kMostListed numbers

  static constexpr std::size_t kMostReasons = 100;   ///< kinds that are kept
  static constexpr std::size_t kMostListed = 10000;  ///< numbers that are kept
};

/// Result of a group.
struct GroupResult {
  EnsembleGroup group;                   ///< as planned
  std::vector<ColumnStatistics> values;  ///< one per value of a job
  FailedJobs failed = {};                ///< its jobs that failed
};

/// Result of a plan.
struct EnsembleResult {
  std::string kind;                      ///< of the plan
  std::uint64_t seed = 0;                ///< of the plan
  double confidence = 0.0;               ///< between lower and upper
  std::string plan;                      ///< its text
  std::vector<std::string> fingerprint;  ///< settings that determine the jobs
  std::vector<InputHash> inputs;         ///< files read, relative to the plan where beside it
  std::vector<std::string> notes;        ///< assumptions
  std::vector<Warning> warnings;         ///< of the result
  std::vector<std::string> raw;          ///< outputs whose values are kept; "*": all
  std::vector<GroupResult> groups;       ///< in the order of the plan

  /// Jobs of all groups.
  [[nodiscard]] std::uint64_t jobs() const;
  /// Jobs that failed, of all groups.
  [[nodiscard]] std::uint64_t failed() const;
  /// Whether the values of an output are kept.
  [[nodiscard]] bool keeps(const EnsembleOutput& output) const;
};

/// Gives all rows of a table to a function, always in the same order.
using RowPass = std::function<void(const std::function<void(std::span<const double> row)>& take)>;

/// Adds the file to a set. Values are written in pieces: memory does not grow with the jobs.
/// @param result   to be written.
/// @param rows_of  the values of each job of a group in their order, NaN where it failed.
/// @param path     of the file.
/// @param outputs  the set; the file gets its name when that is committed.
/// @throws WriteError   where the disk does not take it. @throws FileError  as OutputFiles; in a
///                      build without HDF5.
void add_ensemble_result(const EnsembleResult& result,
                         const std::function<RowPass(std::size_t group)>& rows_of,
                         const std::string& path, OutputFiles& outputs);

}  // namespace microslip
