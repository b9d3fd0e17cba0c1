// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/documents/study/journal_file.hpp"
#include "microslip/ensemble/block_layout.hpp"

namespace microslip {

/// All journals of a result: its finished blocks.
class EnsembleJournals {
 public:
  /// Opens the journals beside the result.
  /// @param out      path of the result. @param heading  of the plan and its inputs.
  /// @throws InputError  where one belongs to other inputs, naming the change.
  /// @throws FileError, FormatError  as JournalReader.
  EnsembleJournals(const std::string& out, const std::string& heading,
                   const std::vector<EnsembleGroup>& groups, const BlockLayout& layout);

  /// Whether a block is done.
  [[nodiscard]] bool has(std::uint64_t block) const { return places_[block].journal != kNowhere; }
  /// Results of a block that is done. @throws FileError  where it is not: another run removed it.
  [[nodiscard]] std::vector<JobResult> results(std::uint64_t block) const;
  /// The paths of those that are there.
  [[nodiscard]] std::vector<std::string> paths() const;

  /// Rows of all jobs of a group, which are done: NaN where they failed. This object must outlive
  /// it.
  [[nodiscard]] RowPass rows_of(std::size_t group) const;

 private:
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;
  struct Place {
    std::uint32_t journal = kNowhere;
    JournalBlock block = {};
  };

  std::string out_;
  const std::vector<EnsembleGroup>& groups_;
  const BlockLayout& layout_;
  std::vector<JournalReader> journals_;
  std::vector<Place> places_;  ///< one per block
};

}  // namespace microslip
