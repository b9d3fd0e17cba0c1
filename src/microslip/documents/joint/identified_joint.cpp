// SPDX-License-Identifier: MIT
#include "microslip/documents/joint/identified_joint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "microslip/base/error.hpp"
#include "microslip/io/config/named_value_access.hpp"
#include "microslip/io/config/record_values.hpp"

namespace microslip {
namespace {

constexpr const char* kIdentifyAgain = "Identify the joint again from its measurements.";

/// An item of one of several parts, in a list of those of all.
template <typename Item>
struct OfPart {
  Item item = {};
  std::size_t part = 0;  ///< from 0
};

// ---- Parts. ----

void visit_banded(RecordValues& values, const std::string& key, BandedValue& banded) {
  values.one(key, banded.value);
  values.pair("band_" + key, banded.lower, banded.upper);
}

void visit_banded_if_there(RecordValues& values, const std::string& key,
                           std::optional<BandedValue>& banded) {
  if (values.has(key, banded)) visit_banded(values, key, *banded);
}

void visit_band_edges(RecordValues& values, IdentifiedJoint& joint) {
  values.list("band_slip_force_N", joint.band_slip_force);
  const std::size_t count = joint.band_slip_force.size();
  values.list("band_lower_per_N", joint.band_lower, count);
  values.list("band_upper_per_N", joint.band_upper, count);
}

void visit_warnings(RecordValues& values, IdentifiedJoint& joint) {
  values.list("warnings", joint.warnings);
  values.list("warning_texts", joint.warning_texts);
}

/// It follows from the density, and is not read.
void visit_remainder(RecordValues& values, const IdentifiedJoint& joint) {
  double remainder = joint.joint.density().elastic_remainder();
  if (!values.reads()) values.one("elastic_remainder", remainder);
}

void visit_path(RecordValues& values, IdentifiedJoint& joint) {
  if (!values.has("path_lambda", joint.path)) return;
  values.list("path_lambda", joint.path->lambda);
  const std::size_t count = joint.path->lambda.size();
  values.list("path_degrees_of_freedom", joint.path->degrees_of_freedom, count);
  values.list("path_residual", joint.path->residual, count);
  values.list("path_gcv", joint.path->gcv, count);
}

void visit_smoothing(RecordValues& values, IdentifiedJoint& joint) {
  values.one(joint.method == "spline" ? "lambda_m3" : "lambda", joint.lambda);
  values.one("degrees_of_freedom", joint.degrees_of_freedom);
  if (values.has("edges_N", !joint.edges.empty())) values.list("edges_N", joint.edges);
  values.one("smoothing_trend", joint.smoothing_trend);
  values.one("scatter", joint.scatter_of_all);
  if (joint.scatter_of_all) {
    values.one("scatter_of", joint.scatter_is_relative, "dissipation", "dissipation_std");
  }
  values.one("scatter_dissipation", joint.scatter);
  values.one("scatter_secant", joint.secant_scatter);
  values.one("inner_not_converged", joint.inner_not_converged);
  visit_path(values, joint);
}

void visit_parameters(RecordValues& values, IdentifiedJoint& joint) {
  for (const std::string& name : values.names("fitted_")) joint.parameters.push_back({name});
  for (ParameterFound& parameter : joint.parameters) {
    values.one("fitted_" + parameter.name, parameter.value);
    values.one("std_" + parameter.name, parameter.error);
  }
  if (values.has("covariance", !joint.covariance.empty())) {
    values.list("covariance", joint.covariance);
  }
  values.one("misfit", joint.misfit);
}

void visit_stiffness(RecordValues& values, IdentifiedJoint& joint) {
  if (values.has("secant_offset_N_per_m", joint.secant)) {
    values.one("secant_offset_N_per_m", joint.secant->offset);
    values.one("secant_offset_std_N_per_m", joint.secant->offset_std);
  }
  if (!values.has("frequency_rise", joint.frequencies)) return;
  values.one("frequency_rise", joint.frequencies->rise);
  values.one("frequency_fall_unexplained", joint.frequencies->fall_unexplained);
  values.one("softening_share", joint.frequencies->softening_share);
  values.one("resonance_uncertainty_Hz", joint.frequencies->uncertainty);
  values.one("equivalent_joint_error_Hz", joint.frequencies->equivalent_joint_error);
}

void visit_level_verdicts(RecordValues& values, IdentifiedJoint& joint) {
  if (!values.has("verdict_departure", !joint.verdicts.empty())) return;
  values.rows("verdict_departure", joint.verdicts);
  values.column("verdict_departure", joint.verdicts, &DepartureFound::departure);
  values.column("verdict", joint.verdicts, &DepartureFound::broken, "broken", "held");
  values.column("verdict_share", joint.verdicts, &DepartureFound::share);
  values.column("verdict_noise", joint.verdicts, &DepartureFound::noise);
}

/// Items of all parts, one below the other. @param counted  key of a list of theirs.
template <typename Part, typename Item, typename Visit>
void visit_items(RecordValues& values, const char* counted, std::vector<Part>& parts,
                 std::vector<Item> Part::*items, const Visit& visit) {
  std::vector<OfPart<Item>> rows;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const Item& item : parts[i].*items) rows.push_back({item, i});
  }
  values.rows(counted, rows);
  visit(rows);
  if (!values.reads()) return;
  for (const OfPart<Item>& row : rows) (parts[row.part].*items).push_back(row.item);
}

constexpr auto kDeparture = [](auto& row) -> auto& { return row.item.departure; };
constexpr auto kBroken = [](auto& row) -> auto& { return row.item.broken; };
constexpr auto kShare = [](auto& row) -> auto& { return row.item.share; };
constexpr auto kNoise = [](auto& row) -> auto& { return row.item.noise; };
using VerdictOfPart = OfPart<DepartureFound>;

/// Keys of a drift: of its coefficients, and of the numbers of their records.
struct DriftKeys {
  const char* coefficients;
  const char* records;
};

void visit_drift(RecordValues& values, std::vector<RecordFound>& records, const DriftKeys& keys,
                 std::vector<double> RecordFound::*drift) {
  const bool any = std::ranges::any_of(
      records, [&](const RecordFound& record) { return !(record.*drift).empty(); });
  if (!values.has(keys.coefficients, any)) return;
  visit_items(values, keys.coefficients, records, drift, [&](auto& rows) {
    values.column(keys.coefficients, rows, &OfPart<double>::item);
    values.places(keys.records, rows, &OfPart<double>::part, records.size(), "records");
  });
}

void visit_each_record(RecordValues& values, std::vector<RecordFound>& records) {
  values.rows("scatter_force_N", records);
  values.column("scatter_force_N", records, &RecordFound::scatter);
  values.column("correlation", records, &RecordFound::correlation);
  values.column("unexplained", records, &RecordFound::unexplained);
  visit_items(values, "offset_force_N", records, &RecordFound::offset, [&](auto& rows) {
    values.column("offset_force_N", rows, &OfPart<double>::item);
    values.places("offset_record", rows, &OfPart<double>::part, records.size(), "records");
  });
  visit_drift(values, records, {"displacement_drift_m", "displacement_drift_record"},
              &RecordFound::displacement_drift);
  visit_drift(values, records, {"force_drift_N", "force_drift_record"}, &RecordFound::force_drift);
  values.column("start", records, &RecordFound::start);
  visit_items(values, "verdict_record", records, &RecordFound::verdicts, [&](auto& rows) {
    values.column("verdict_departure", rows, kDeparture);
    values.column("verdict", rows, kBroken, "broken", "held");
    values.places("verdict_record", rows, &VerdictOfPart::part, records.size(), "records");
    values.column("verdict_share", rows, kShare);
    values.column("verdict_noise", rows, kNoise);
  });
}

void visit_tables(RecordValues& values, std::vector<TableFound>& tables) {
  if (!values.has("levels_scatter", !tables.empty())) return;
  values.rows("levels_scatter", tables);
  values.column("levels_scatter", tables, &TableFound::scatter);
  values.column("levels_scatter_of", tables, &TableFound::scatter_is_relative, "dissipation",
                "dissipation_std");
  visit_items(values, "levels_verdict_table", tables, &TableFound::verdicts, [&](auto& rows) {
    values.places("levels_verdict_table", rows, &VerdictOfPart::part, tables.size(), "tables");
    values.column("levels_verdict_quantity", rows, kDeparture);
    values.column("levels_verdict", rows, kBroken, "broken", "held");
    values.column("levels_verdict_share", rows, kShare);
    values.column("levels_verdict_noise", rows, kNoise);
  });
}

void visit_records(RecordValues& values, FoundByRecords& found) {
  visit_banded_if_there(values, "stiffness_N_per_m", found.stiffness);
  visit_banded_if_there(values, "elastic_stiffness_N_per_m", found.elastic);
  visit_banded_if_there(values, std::string(kViscousKey), found.viscous);
  values.one("reference_exponent", found.reference_exponent);
  visit_each_record(values, found.records);
  visit_tables(values, found.tables);
}

/// What the files of the records add to an identification.
void visit_sources(RecordValues& values, std::vector<RecordFound>& records) {
  const auto column = [&](const std::string& key, const auto& member) {
    if (values.has(key, true)) values.column(key, records, member);
  };
  column("start_from", &RecordFound::start_from);
  column("record_source", &RecordFound::source);
  column("record_input", &RecordFound::input);
}

void visit_level_bands(RecordValues& values, IdentifiedJoint& joint) {
  if (!values.has("band_samples_effective", joint.level_bands)) return;
  auto& bands = *joint.level_bands;
  values.one("band_samples_effective", bands.effective_samples);
  const auto pair_if_there = [&](const std::string& key, auto& band) {
    if (values.has(key, band)) values.pair(key, band->first, band->second);
  };
  values.pair("band_area", bands.area.first, bands.area.second);
  pair_if_there("band_linear_damping_J_per_m2", bands.damping);
  pair_if_there("band_atom_weight", bands.atom);
}

// ---- Whole identifications. ----

/// Of levels, of records, or of both.
void visit_identification(RecordValues& values, IdentifiedJoint& joint) {
  values.one("method", joint.method);
  values.one("model", joint.model);
  values.one("status", joint.status);
  values.one("covered_from_N", joint.covered_from);
  values.one(std::string(kCoveredToKey), joint.covered_to);
  visit_remainder(values, joint);
  values.one(std::string(kLinearDampingKey), joint.linear_damping);
  visit_smoothing(values, joint);
  visit_parameters(values, joint);
  visit_stiffness(values, joint);
  if (values.has("scatter_force_N", joint.by_records)) {
    visit_records(values, *joint.by_records);
  } else {
    visit_level_verdicts(values, joint);
  }
  if (values.reads() || !joint.band_slip_force.empty()) {
    values.one("band_confidence", joint.band_confidence);
    values.one("band_samples", joint.band_samples);
    visit_level_bands(values, joint);
    visit_band_edges(values, joint);
  }
  visit_warnings(values, joint);
  if (joint.by_records) visit_sources(values, joint.by_records->records);
}

void visit_assemblies(RecordValues& values, FoundOfAssemblies& found) {
  values.one("assembly", found.name);
  if (values.has("assembly", !found.names.empty())) values.list("assembly", found.names);
  values.one("stiffness_from", found.stiffness_from);
  visit_banded_if_there(values, "stiffness_spread", found.stiffness_spread);
  visit_banded_if_there(values, "slip_force_spread", found.slip_force_spread);
  visit_banded_if_there(values, "shape_spread", found.shape_spread);
  values.one("spread_prior_from", found.spread_prior_from);
  values.one("spread_prior_to", found.spread_prior_to);
  values.one("effective_draws", found.effective_draws);
  visit_banded_if_there(values, "stiffness_N_per_m", found.stiffness);
  visit_banded_if_there(values, "slip_force_scale", found.slip_force_scale);
  visit_banded_if_there(values, "shape", found.shape);
}

/// The mean of several assemblies, or one of them.
void visit_of_assemblies(RecordValues& values, IdentifiedJoint& joint) {
  values.one("status", joint.status);
  values.one("method", joint.method);
  visit_assemblies(values, *joint.of_assemblies);
  values.one("scatter", joint.scatter);
  if (joint.scatter) {
    values.one("scatter_of", joint.scatter_is_relative, "dissipation", "dissipation_std");
  }
  values.one("covered_from_N", joint.covered_from);
  values.one(std::string(kCoveredToKey), joint.covered_to);
  values.one("band_samples", joint.band_samples);
  values.one("band_confidence", joint.band_confidence);
  visit_band_edges(values, joint);
  visit_warnings(values, joint);
}

/// One of the joints of a structure.
void visit_calibrated(RecordValues& values, IdentifiedJoint& joint) {
  auto& found = *joint.by_calibration;
  values.one("method", joint.method);
  values.one("status", joint.status);
  values.one("levels", found.levels);
  values.one("covered_from_N", joint.covered_from);
  values.one(std::string(kCoveredToKey), joint.covered_to);
  visit_remainder(values, joint);
  values.needed("stiffness_N_per_m", found.stiffness.value);
  values.pair("band_stiffness_N_per_m", found.stiffness.lower, found.stiffness.upper);
  visit_banded(values, "elastic_stiffness_N_per_m", found.elastic);
  values.one("band_confidence", joint.band_confidence);
  visit_band_edges(values, joint);
  values.one("band_samples", joint.band_samples);
  values.list("told", found.variance_reduction, joint.band_slip_force.size());
  values.one("reference_exponent", found.reference_exponent);
  values.one("degrees_of_freedom", joint.degrees_of_freedom);
  if (values.has("edges_N", !joint.edges.empty())) {
    values.list("edges_N", joint.edges);
    values.list("edges_std_N", found.edges_std, joint.edges.size());
    values.one("edges_evidence", found.edges_evidence);
  }
  visit_warnings(values, joint);
}

void visit_any(RecordValues& values, IdentifiedJoint& joint) {
  if (joint.of_assemblies) {
    visit_of_assemblies(values, joint);
  } else if (joint.by_calibration) {
    visit_calibrated(values, joint);
  } else {
    visit_identification(values, joint);
  }
}

void check_band(const IdentifiedJoint& joint, const std::string& object) {
  for (std::size_t i = 0; i < joint.band_upper.size(); ++i) {
    if (joint.band_lower[i] <= joint.band_upper[i]) continue;
    throw InputError(
        fmt::format("{}.band_upper_per_N[{}]", object, i),
        fmt::format("{} 1/N", joint.band_upper[i]),
        fmt::format("must be at least band_lower_per_N there, {}", joint.band_lower[i]),
        kIdentifyAgain);
  }
}

/// How λ was chosen, as far as the file tells.
std::string smoothing_of(const JointFile& file) {
  const std::optional<std::string> asked =
      file.provenance ? text_in(file.provenance->options, "smoothing") : std::nullopt;
  if (!asked) return {};
  return *asked == "gcv" ? "generalised cross-validation" : "as specified";
}

}  // namespace

JointFile joint_file_of(IdentifiedJoint found, Provenance provenance) {
  RecordValues values;
  visit_any(values, found);
  return {std::move(found.joint), std::move(provenance), values.take()};
}

IdentifiedJoint identified_joint_of(const JointFile& file, const std::string& path) {
  const std::string object = path + ": identification";
  RecordValues values(file.identification, object, kIdentifyAgain);
  IdentifiedJoint joint{.joint = file.joint,
                        .status = std::string(kStatusNotTold),
                        .smoothing = smoothing_of(file),
                        .band_confidence = 0.95};
  values.one("method", joint.method);
  if (joint.method == kAssembliesMethod) joint.of_assemblies.emplace();
  if (joint.method == kCalibrationMethod) joint.by_calibration.emplace();
  visit_any(values, joint);
  if (joint.by_records && joint.by_records->records.empty()) joint.by_records.reset();
  if (!joint.scatter) joint.scatter = joint.scatter_of_all;  // of files that tell that alone
  check_band(joint, object);
  return joint;
}

}  // namespace microslip
