// SPDX-License-Identifier: MIT
#include "microslip/documents/study/calibration_summary.hpp"

#include <utility>

#include "microslip/io/config/named_value_access.hpp"
#include "microslip/io/config/record_values.hpp"

namespace microslip {
namespace {

constexpr std::size_t kMostModes = 1000000;

void visit_joints(RecordValues& values, std::vector<JointSummary>& joints) {
  using Joint = JointSummary;
  values.rows("joint", joints);
  values.column("joint", joints, &Joint::name);
  values.column("stiffness_N_per_m", joints, &Joint::stiffness);
  values.column("stiffness_lower_N_per_m", joints, &Joint::stiffness_lower);
  values.column("stiffness_upper_N_per_m", joints, &Joint::stiffness_upper);
  values.column("slipping_share", joints, &Joint::slipping_share);
  values.column("degrees_of_freedom", joints, &Joint::degrees_of_freedom);
  if (values.has("loss_told", true)) values.column("loss_told", joints, &Joint::loss_significance);
  if (values.has("edges_evidence", true)) {
    values.column("edges_evidence", joints, &Joint::edges_evidence);
  }
  values.column("covered_from_N", joints, &Joint::covered_from);
  values.column("covered_to_N", joints, &Joint::covered_to);
}

/// Search for edges, and edge by edge those of all joints.
void visit_edges(RecordValues& values, CalibrationSummary& summary) {
  values.one("edges", summary.edges_sought, "sought", "none");
  values.rows("edge_joint", summary.edges);
  values.column("edge_joint", summary.edges, &EdgeSummary::joint);
  values.column("edge_N", summary.edges, &EdgeSummary::slip_force);
  values.column("edge_std_N", summary.edges, &EdgeSummary::deviation);
}

void visit_offsets(RecordValues& values, std::vector<ModeOffset>& offsets) {
  values.rows("offset_mode", offsets);
  values.places("offset_mode", offsets, &ModeOffset::mode, kMostModes, "modes");
  values.column("frequency_offset", offsets, &ModeOffset::offset);
}

void visit_pairs(RecordValues& values, std::vector<PairSummary>& pairs) {
  using Pair = PairSummary;
  values.rows("pair_first", pairs);
  values.column("pair_first", pairs, &Pair::first);
  values.column("pair_second", pairs, &Pair::second);
  values.column("pair_correlation", pairs, &Pair::correlation);
  values.column("pair_spread_alone", pairs, &Pair::spread_alone);
  values.column("pair_spread_together", pairs, &Pair::spread_together);
  values.column("pair_verdict", pairs, &Pair::known_only_together, "known_only_together",
                "told_apart");
}

void visit_calibration(RecordValues& values, CalibrationSummary& summary) {
  values.needed("status", summary.status);
  values.needed("levels", summary.levels);
  values.needed("levels_found", summary.levels_found);
  values.needed("band_confidence", summary.confidence);
  values.needed("scatter", summary.scatter);
  values.needed("scatter_of", summary.scatter_is_relative, "dissipation", "dissipation_std");
  values.needed("frequency_scatter", summary.frequency_scatter);
  values.needed("frequency_scatter_of", summary.frequency_scatter_is_relative, "frequency",
                "frequency_std");
  visit_joints(values, summary.joints);
  visit_edges(values, summary);
  visit_offsets(values, summary.offsets);
  visit_pairs(values, summary.pairs);
  values.list("known_in_sum", summary.known_in_sum);
  values.rows("warnings", summary.warnings);
  values.column("warnings", summary.warnings, &Warning::code);
  values.column("warning_texts", summary.warnings, &Warning::text);
}

}  // namespace

CalibrationFile calibration_file_of(CalibrationSummary found, Provenance provenance) {
  RecordValues values;
  visit_calibration(values, found);
  return {std::move(provenance), values.take()};
}

CalibrationSummary calibration_summary_of(const CalibrationFile& file, const std::string& path) {
  RecordValues values(file.calibration, path + ": calibration",
                      "Write it again by microslip calibrate.");
  CalibrationSummary summary;
  visit_calibration(values, summary);
  if (file.provenance) {
    summary.frequency_use = text_in(file.provenance->options, "frequency").value_or("");
  }
  return summary;
}

}  // namespace microslip
