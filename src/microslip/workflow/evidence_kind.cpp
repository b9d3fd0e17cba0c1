// SPDX-License-Identifier: MIT
#include "microslip/workflow/evidence_kind.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "microslip/io/csv.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/signal/quantity_name.hpp"

namespace microslip {
namespace {

bool is_of_levels(const std::string& name) { return name == "amplitude" || name == "dissipation"; }

bool is_of_record(const std::string& name) {
  const auto quantity = quantity_of_name(name);
  return quantity == kTime || quantity == kLength || quantity == kForce;
}

}  // namespace

EvidenceKind evidence_kind(const std::string& path) {
  const std::string file = part_of_file(path).file;
  std::error_code unknown;
  const bool once =
      std::filesystem::exists(file, unknown) && !std::filesystem::is_regular_file(file, unknown);
  if (path == "-" || once) return EvidenceKind::kLevels;
  if (recording_format(file) != RecordingFormat::kCsv) return EvidenceKind::kRecord;
  const std::vector<std::string> names = csv_column_names(read_kind_head(file));
  if (std::ranges::any_of(names, is_of_levels)) return EvidenceKind::kLevels;
  return std::ranges::any_of(names, is_of_record) ? EvidenceKind::kRecord : EvidenceKind::kLevels;
}

}  // namespace microslip
