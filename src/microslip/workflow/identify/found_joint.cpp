// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/found_joint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/identify/posterior/spread_prior.hpp"

namespace microslip {
namespace {

void set_warnings(const std::vector<Warning>& warnings, IdentifiedJoint& joint) {
  for (const Warning& warning : warnings) {
    joint.warnings.push_back(warning.code);
    joint.warning_texts.push_back(warning.text);
  }
}

BandedValue banded(const Estimate& estimate) {
  return {estimate.value, estimate.lower, estimate.upper};
}

BandedValue banded(const Spread& spread) { return {spread.median, spread.lower, spread.upper}; }

/// @param verdict  on records or on levels.
template <typename Verdict>
DepartureFound departure_found(const Verdict& verdict) {
  return {std::string(to_string(verdict.departure)), verdict.share, verdict.noise, verdict.broken};
}

void set_path(const std::vector<PathPoint>& points, IdentifiedJoint& joint) {
  SmoothingPath& path = joint.path.emplace();
  for (const PathPoint& point : points) {
    if (!std::isfinite(point.gcv)) continue;
    path.lambda.push_back(point.lambda);
    path.degrees_of_freedom.push_back(point.edf);
    path.residual.push_back(point.residual);
    path.gcv.push_back(point.gcv);
  }
}

void set_inversion(const InversionResult& result, IdentifiedJoint& joint) {
  joint.lambda = result.path[result.chosen].lambda;
  joint.degrees_of_freedom = result.edf;
  joint.edges = result.edges;
  if (result.smoothing_trend != 0.0) joint.smoothing_trend = result.smoothing_trend;
  joint.scatter_of_all = result.scatter;
  joint.scatter_is_relative = result.scatter_is_relative;
  joint.scatter = result.dissipation_scatter;
  joint.secant_scatter = result.secant_scatter;
  if (result.inner_not_converged > 0) {
    joint.inner_not_converged = static_cast<double>(result.inner_not_converged);
  }
  set_path(result.path, joint);
}

void set_parameters(const ParametricResult& fit, IdentifiedJoint& joint) {
  joint.model = to_string(fit.model);
  for (const FittedParameter& parameter : fit.parameters) {
    ParameterFound& found = joint.parameters.emplace_back();
    found = {parameter.name, parameter.value, {}};
    if (std::isfinite(parameter.standard_error)) found.error = parameter.standard_error;
  }
  // Parameters that the levels do not determine have none.
  if (std::ranges::all_of(fit.covariance, [](double c) { return std::isfinite(c); })) {
    joint.covariance = fit.covariance;
  }
  joint.misfit = fit.misfit;
}

/// Of the joint that the file holds, whatever found it.
void set_stiffness(const StiffnessEvidence& evidence, IdentifiedJoint& joint) {
  if (evidence.secant) joint.secant = {evidence.secant->offset, evidence.secant->offset_std};
  if (!evidence.frequency) return;
  const FrequencyEvidence& frequency = *evidence.frequency;
  joint.frequencies = {
      .rise = std::max(0.0, frequency.rise.change),
      .fall_unexplained = std::max(0.0, frequency.fall.explained - frequency.fall.change),
      .softening_share = frequency.share,
      .uncertainty = frequency.uncertainty,
      .equivalent_joint_error = frequency.equivalent_joint_error};
}

TableFound table_found(const LevelFit& fit) {
  TableFound found{.scatter = fit.scatter.dissipation,
                   .scatter_is_relative = fit.scatter_is_relative};
  const auto add = [&](const std::optional<LevelVerdict>& one, const char* quantity) {
    if (one) found.verdicts.push_back({quantity, one->share, one->noise, one->broken});
  };
  add(fit.dissipation_verdict, "dissipation");
  add(fit.secant_verdict, "secant_stiffness");
  return found;
}

RecordFound record_found(const RecordFit& fit) {
  RecordFound found{.start = std::string(to_string(fit.start)),
                    .scatter = fit.scatter,
                    .correlation = fit.correlation,
                    .unexplained = fit.unexplained,
                    .offset = fit.offset};
  for (const RecordVerdict& one : fit.verdicts) found.verdicts.push_back(departure_found(one));
  return found;
}

/// Of the draws from the posterior of records.
void set_records(const RecordInversionResult& result, IdentifiedJoint& joint) {
  FoundByRecords& found = joint.by_records.emplace();
  if (!result.stiffness_known) found.stiffness = banded(result.stiffness);
  found.elastic = banded(result.elastic_stiffness);
  if (result.viscous) found.viscous = banded(*result.viscous);
  found.reference_exponent = result.reference_exponent;
  for (const RecordFit& fit : result.records) found.records.push_back(record_found(fit));
  for (const LevelFit& fit : result.levels) found.tables.push_back(table_found(fit));
  joint.band_confidence = result.confidence;
  joint.band_samples = static_cast<double>(result.draws.size());
}

void set_level_bands(const Identification& found, IdentifiedJoint& joint) {
  const DensityBands& bands = *found.bands();
  joint.band_confidence = bands.confidence;
  joint.band_samples = static_cast<double>(bands.samples);
  LevelBandsFound& of_levels = joint.level_bands.emplace();
  of_levels.effective_samples = bands.effective_samples;
  of_levels.area = bands.area;
  if (found.linear_damping) of_levels.damping = bands.linear_damping;
  if (found.inversion()->atom_slip_force) of_levels.atom = bands.atom_weight;
}

std::string_view origin_of_stiffness(AssemblyStiffness from) {
  switch (from) {
    case AssemblyStiffness::kGiven:
      return "given";
    case AssemblyStiffness::kSought:
      return "secant_stiffness";
    case AssemblyStiffness::kCommon:
      break;
  }
  return "common";
}

JointSummary joint_summary(const CalibratedJoint& joint) {
  const double k = joint.joint.stiffness();
  return {.name = joint.name,
          .stiffness = joint.stiffness.value,
          .stiffness_lower = joint.stiffness.lower,
          .stiffness_upper = joint.stiffness.upper,
          .slipping_share = 1.0 - joint.joint.density().elastic_remainder(),
          .degrees_of_freedom = joint.edf,
          .loss_significance = joint.loss_significance,
          .edges_evidence = joint.edges_evidence,
          .covered_from = k * joint.least_amplitude,
          .covered_to = k * joint.largest_amplitude};
}

IdentifiedJoint joint_of_assemblies(const AssembliesResult& found, Joint joint) {
  IdentifiedJoint all{.joint = std::move(joint),
                      .method = std::string(kAssembliesMethod),
                      .status = std::string(found.summary.status()),
                      .of_assemblies = FoundOfAssemblies{},
                      .band_confidence = found.confidence,
                      .band_samples = static_cast<double>(found.draws.size())};
  all.of_assemblies->stiffness_from = origin_of_stiffness(found.stiffness_from);
  set_warnings(found.warnings, all);
  return all;
}

void set_band_up_to(double covered_to, const std::vector<double>& slip_force,
                    const BandedDensity& density, IdentifiedJoint& joint) {
  for (std::size_t i = 0; i < slip_force.size() && slip_force[i] <= covered_to; ++i) {
    joint.band_slip_force.push_back(slip_force[i]);
    joint.band_lower.push_back(density.lower[i]);
    joint.band_upper.push_back(density.upper[i]);
  }
}

}  // namespace

IdentifiedJoint found_joint(const Identification& found) {
  IdentifiedJoint joint{.joint = found.joint,
                        .method = std::string(to_string(found.method)),
                        .status = std::string(found.summary.status()),
                        .covered_from = found.covered_from,
                        .covered_to = found.covered_to,
                        .linear_damping = found.linear_damping};
  if (found.inversion()) set_inversion(*found.inversion(), joint);
  if (found.spline()) {
    joint.lambda = found.spline()->fit.lambda;
    joint.degrees_of_freedom = found.spline()->fit.edf;
  }
  if (found.parametric) set_parameters(*found.parametric, joint);
  set_stiffness(found.stiffness, joint);
  for (const LevelDepartureVerdict& one : found.verdicts) {
    joint.verdicts.push_back(departure_found(one));
  }
  if (found.records()) set_records(*found.records(), joint);
  if (found.bands()) set_level_bands(found, joint);
  if (found.records() || found.bands()) {
    joint.band_slip_force = found.slip_force;
    joint.band_lower = found.lower;
    joint.band_upper = found.upper;
  }
  set_warnings(found.warnings, joint);
  return joint;
}

IdentifiedJoint found_joint(const AssembliesResult& found) {
  IdentifiedJoint joint = joint_of_assemblies(found, found.joint());
  FoundOfAssemblies& mean = *joint.of_assemblies;
  for (const AssemblyFit& fit : found.assemblies) mean.names.push_back(fit.name);
  if (found.stiffness_spread) mean.stiffness_spread = banded(*found.stiffness_spread);
  mean.slip_force_spread = banded(found.slip_force_spread);
  mean.shape_spread = banded(found.shape_spread);
  mean.spread_prior_from = SpreadPrior::kNone;
  mean.spread_prior_to = SpreadPrior::kUsual;
  mean.effective_draws = found.effective_draws;
  joint.scatter = found.scatter;
  joint.scatter_is_relative = found.scatter_is_relative;
  joint.covered_from = found.covered_from;
  joint.covered_to = found.covered_to;
  set_band_up_to(found.covered_to, found.slip_force, found.common, joint);
  return joint;
}

IdentifiedJoint found_joint(const AssembliesResult& found, std::size_t assembly) {
  const AssemblyFit& fit = found.assemblies.at(assembly);
  IdentifiedJoint joint = joint_of_assemblies(found, found.joint(assembly));
  joint.of_assemblies->name = fit.name;
  joint.of_assemblies->stiffness = banded(fit.stiffness);
  joint.of_assemblies->slip_force_scale = banded(fit.slip_force_scale);
  joint.of_assemblies->shape = banded(fit.shape);
  joint.covered_from = fit.covered_from;
  joint.covered_to = fit.covered_to;
  set_band_up_to(fit.covered_to, found.slip_force, fit.density, joint);
  return joint;
}

IdentifiedJoint found_joint(const CalibrationResult& found, const CalibratedJoint& joint) {
  const double k = joint.joint.stiffness();
  IdentifiedJoint all{
      .joint = joint.joint,
      .method = std::string(kCalibrationMethod),
      .status = std::string(found.summary.status()),
      .covered_from = k * joint.least_amplitude,
      .covered_to = k * joint.largest_amplitude,
      .by_calibration = FoundByCalibration{.levels = static_cast<double>(found.levels.size()),
                                           .stiffness = banded(joint.stiffness),
                                           .elastic = banded(joint.elastic_stiffness),
                                           .variance_reduction = joint.variance_reduction,
                                           .reference_exponent = joint.exponent,
                                           .edges_evidence = joint.edges_evidence},
      .degrees_of_freedom = joint.edf,
      .band_confidence = found.confidence,
      .band_samples = static_cast<double>(joint.draws.size()),
      .band_lower = joint.band.lower,
      .band_upper = joint.band.upper};
  for (const double x : joint.slip_displacement) all.band_slip_force.push_back(k * x);
  for (const DensityEdge& edge : joint.edges) {
    all.edges.push_back(edge.slip_force);
    all.by_calibration->edges_std.push_back(edge.deviation);
  }
  set_warnings(found.warnings, all);
  return all;
}

CalibrationSummary found_calibration(const CalibrationResult& found) {
  CalibrationSummary summary{.status = std::string(found.summary.status()),
                             .levels = static_cast<double>(found.levels.size()),
                             .levels_found = static_cast<double>(
                                 std::ranges::count_if(found.levels, &CalibratedLevel::found)),
                             .confidence = found.confidence,
                             .scatter = found.loss_scatter,
                             .scatter_is_relative = !found.loss_std_given,
                             .frequency_scatter = found.frequency_scatter,
                             .frequency_scatter_is_relative = !found.frequency_std_given,
                             .edges_sought = found.edges_sought,
                             .warnings = found.warnings};
  for (const CalibratedJoint& joint : found.joints) {
    summary.joints.push_back(joint_summary(joint));
    for (const DensityEdge& edge : joint.edges) {
      summary.edges.push_back({joint.name, edge.slip_force, edge.deviation});
    }
  }
  for (std::size_t m = 0; m < found.frequency_offset.size(); ++m) {
    // A mode without frequencies has none.
    if (!std::isnan(found.frequency_offset[m])) {
      summary.offsets.push_back({m, found.frequency_offset[m]});
    }
  }
  for (const JointPair& pair : found.pairs) {
    summary.pairs.push_back({found.joints[pair.first].name, found.joints[pair.second].name,
                             pair.correlation, pair.spread_alone, pair.spread_together,
                             pair.known_only_together});
  }
  for (const std::size_t joint : found.known_in_sum) {
    summary.known_in_sum.push_back(found.joints[joint].name);
  }
  return summary;
}

}  // namespace microslip
