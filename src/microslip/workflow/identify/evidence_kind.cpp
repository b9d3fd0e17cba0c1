// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/evidence_kind.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

bool is_of_levels(const CsvColumn& column) {
  return column.name == "amplitude" || column.name == "dissipation";
}

/// By its name, or as a force by its unit.
bool is_of_record(const CsvColumn& column) {
  const auto quantity = quantity_of_name(column.name);
  if (quantity == kTime || quantity == kLength || quantity == kForce) return true;
  const auto unit = column.unit ? find_unit(*column.unit) : std::nullopt;
  return unit && unit->dimension == kForce;
}

}  // namespace

EvidenceKind evidence_kind(const std::string& path) {
  const std::string file = part_of_file(path).file;
  if (path == "-" || is_pipe_or_device(file)) return EvidenceKind::kLevels;
  if (recording_format(file) != RecordingFormat::kCsv) return EvidenceKind::kRecord;
  const std::string head = read_kind_head(file);
  if (std::ranges::any_of(csv_columns(head), is_of_levels)) return EvidenceKind::kLevels;
  return std::ranges::any_of(recording_columns(head), is_of_record) ? EvidenceKind::kRecord
                                                                    : EvidenceKind::kLevels;
}

}  // namespace microslip
