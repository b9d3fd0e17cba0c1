// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "microslip/observe/level_evidence.hpp"
#include "microslip/observe/record_evidence.hpp"

namespace microslip {

/// All measurements of one joint. It must outlive the objects that refer to it.
struct JointEvidence {
  std::span<const RecordEvidence> records = {};  ///< forces on paths
  std::span<const LevelEvidence> levels = {};    ///< tables of levels, each with its own scatter

  std::vector<std::string> record_names = {};  ///< for messages, one per record; else numbers
  std::vector<std::string> level_names = {};   ///< the same, one per table

  /// "record 2", or its name.
  [[nodiscard]] std::string name_of_record(std::size_t record) const;
  /// "levels 2", or the name of the table.
  [[nodiscard]] std::string name_of_levels(std::size_t table) const;
};

}  // namespace microslip
