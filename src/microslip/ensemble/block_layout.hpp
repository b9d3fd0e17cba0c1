// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "microslip/ensemble/ensemble_jobs.hpp"

/// @file
/// Jobs in blocks, the units of distribution, writing and reading.

namespace microslip {

/// Jobs of one group, one behind the other.
struct JobRange {
  std::size_t group = 0;    ///< of the ensemble
  std::uint64_t first = 0;  ///< job of the group
  std::uint64_t count = 0;  ///< jobs
};

/// The blocks of an ensemble, numbered from 0 through all groups; no block has jobs of two.
class BlockLayout {
 public:
  /// @param groups  of the ensemble. @param block  jobs of one, ≥ 1.
  BlockLayout(const std::vector<EnsembleGroup>& groups, std::uint64_t block);

  /// Jobs of a block.
  [[nodiscard]] JobRange jobs_of(std::uint64_t block) const;
  /// Numbers of the blocks of a group, from first to one before the second.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> blocks_of(std::size_t group) const;
  /// How many there are.
  [[nodiscard]] std::uint64_t size() const { return begin_.back(); }

 private:
  std::vector<std::uint64_t> jobs_;
  std::vector<std::uint64_t> begin_;  ///< first block of each group; size()
  std::uint64_t block_;
};

/// Jobs of a block where a plan does not give them: a thousandth of all, so that a stop costs
/// little and all cores have work to the end; 256 at most.
[[nodiscard]] std::uint64_t usual_block(const std::vector<EnsembleGroup>& groups);

/// Results of a block as bytes: of each job a byte 0 and its values, 8 bytes each, least first; or
/// a byte 1, the size of the reason, 8 bytes, and the reason.
[[nodiscard]] std::string block_bytes(const std::vector<JobResult>& results);

/// Reads the results of block_bytes().
/// @param bytes  of the block. @param jobs  in it. @param width  values of a job.
/// @return none where they are not of such a block.
[[nodiscard]] std::optional<std::vector<JobResult>> block_results(const std::string& bytes,
                                                                  std::uint64_t jobs,
                                                                  std::size_t width);

}  // namespace microslip
