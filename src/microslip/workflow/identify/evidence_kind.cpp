// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/evidence_kind.hpp"

#include <algorithm>
#include <optional>

#include "microslip/base/units.hpp"
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

EvidenceKind evidence_kind(const TestFile& file) {
  if (file.once) return EvidenceKind::kLevels;
  const auto found = find_recording_format_of(file.text);
  const RecordingFormat format = found ? *found : recording_format(file.part.file);  // throws why
  if (format != RecordingFormat::kCsv) return EvidenceKind::kRecord;
  if (std::ranges::any_of(csv_columns(file.text), is_of_levels)) return EvidenceKind::kLevels;
  return std::ranges::any_of(recording_columns(file.text), is_of_record) ? EvidenceKind::kRecord
                                                                         : EvidenceKind::kLevels;
}

}  // namespace microslip
