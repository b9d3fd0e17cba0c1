// SPDX-License-Identifier: MIT
#include "microslip/identify/methods/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <variant>

#include "microslip/base/error.hpp"
#include "microslip/base/interpolation.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/identify/evidence/stiffness_evidence.hpp"
#include "microslip/identify/inversion/inverted_joint.hpp"
#include "microslip/identify/inversion/possible_joints.hpp"
#include "microslip/identify/methods/diagnostics.hpp"
#include "microslip/identify/smoothing/differences.hpp"

namespace microslip {
namespace {

constexpr std::size_t kPlotPoints = 400;

void append(std::vector<Warning>& all, std::vector<Warning> more) {
  std::ranges::move(more, std::back_inserter(all));
}

/// The admissible joint of a density that may be negative.
Joint feasible_joint(double stiffness, const SignedDensity& found, std::vector<Warning>& warnings) {
  std::vector<double> density = found.density;
  const auto negative = std::ranges::count_if(density, [](double v) { return v < 0.0; });
  for (double& value : density) value = std::max(value, 0.0);
  if (negative > 0) {
    warnings.push_back({"density_clipped",
                        fmt::format("The density is negative at {} of {} points; the joint has 0 "
                                    "there. The method inversion needs no clipping.",
                                    negative, density.size())});
  }
  const double area = integral(found.slip_force, density);
  if (area > 1.0) {
    for (double& value : density) value /= area;
    warnings.push_back({"density_scaled",
                        fmt::format("The area of the density is {:.3f}, above 1; the joint has it "
                                    "scaled down to 1. k may be too low.",
                                    area)});
  }
  return Joint(stiffness, SlipDensity({PiecewiseLinearPart{found.slip_force, std::move(density)}}));
}

void read_density_of_joint(Identification& found) {
  const auto& part = std::get<PiecewiseLinearPart>(found.joint.density().parts().front());
  found.slip_force = part.slip_force;
  found.density = part.density;
}

Identification by_inversion(const LevelEvidence& evidence, double stiffness,
                            const IdentificationOptions& options) {
  InvertedDensity inverted{invert(evidence, stiffness, options.inversion)};
  const InversionResult& result = inverted.result;
  Identification found(options.method, joint_of(result, stiffness));
  found.slip_force = result.slip_force;
  found.density = result.density;
  found.linear_damping = result.linear_damping;
  found.summary = result.summary;
  append(found.warnings,
         diagnose(result, evidence, stiffness, options.inversion, SecantOf::kFinal));
  if (options.bands) {
    Stopwatch watch;
    inverted.samples = result.posterior.samples(options.bands->seed, options.bands->samples,
                                                options.bands->execution, options.bands->progress);
    inverted.bands = density_bands(result, inverted.samples, options.bands->confidence);
    found.summary.timings.push_back(watch.lap("band"));
    found.summary.wall_seconds += watch.seconds();
    found.lower = inverted.bands->lower;
    found.upper = inverted.bands->upper;
    append(found.warnings, diagnose(*inverted.bands));
  }
  found.free = std::move(inverted);
  return found;
}

Identification by_spline(const LevelEvidence& evidence, double stiffness,
                         const IdentificationOptions& options) {
  SplineDensityResult result = density_by_spline(evidence, stiffness, options.spline);
  std::vector<Warning> warnings = result.warnings;
  Identification found(options.method, feasible_joint(stiffness, result.density, warnings));
  read_density_of_joint(found);
  found.summary = result.fit.summary;
  found.warnings = std::move(warnings);
  found.free = std::move(result);
  return found;
}

Identification by_differences(const LevelEvidence& evidence, double stiffness,
                              const IdentificationOptions& options) {
  SignedDensity result = density_by_differences(evidence, stiffness);
  if (result.slip_force.size() < 2) {
    throw InputError(
        "number of different amplitudes", static_cast<double>(result.slip_force.size() + 2),
        "must be 4 or more for a density by second differences", "Measure more levels.");
  }
  std::vector<Warning> warnings;
  Identification found(options.method, feasible_joint(stiffness, result, warnings));
  read_density_of_joint(found);
  found.summary.method = "second differences";
  found.summary.stop = Stop::kClosedForm;
  found.summary.reason = "closed form";
  found.warnings = std::move(warnings);
  found.free = std::move(result);
  return found;
}

Identification by_method(const LevelEvidence& levels, double stiffness,
                         const IdentificationOptions& options) {
  switch (options.method) {
    case IdentificationMethod::kSpline:
      return by_spline(levels, stiffness, options);
    case IdentificationMethod::kDifferences:
      return by_differences(levels, stiffness, options);
    case IdentificationMethod::kInversion:
      break;
  }
  return by_inversion(levels, stiffness, options);
}

/// Replaces the joint by the parametric one; the result of the method stays beside it.
void replace_by_fit(const LevelEvidence& levels, double stiffness,
                    const IdentificationOptions& options, Identification& found) {
  ParametricResult fit = fit_parametric(levels, stiffness, *options.fit,
                                        {.linear_damping = options.inversion.linear_damping});
  if (found.summary.stop != Stop::kNotRun && !found.summary.converged()) {
    found.warnings.push_back(
        {"free_density_not_converged",
         fmt::format("The density beside the model, by the method {}, did not converge: {}.",
                     to_string(found.method), found.summary.reason)});
  }
  found.joint = fit.joint;
  found.summary = fit.summary;
  if (options.inversion.linear_damping) found.linear_damping = fit.linear_damping;
  append(found.warnings, fit.warnings);
  found.slip_force.clear();
  found.density.clear();
  found.lower.clear();
  found.upper.clear();
  // Not at 0, where a power law has no finite density.
  const double end = fit.joint.density().largest_slip_force();
  for (std::size_t i = 1; i <= kPlotPoints; ++i) {
    const double f = end * static_cast<double>(i) / static_cast<double>(kPlotPoints);
    found.slip_force.push_back(f);
    found.density.push_back(fit.joint.density().density(i == kPlotPoints ? f * (1 - 1e-12) : f));
  }
  found.parametric = std::move(fit);
}

/// Judges the stiffness of the final joint, whatever the inversion found for its own.
void judge_stiffness(const LevelEvidence& levels, Identification& found) {
  const InversionResult* inversion = found.parametric ? nullptr : found.inversion();
  SoftestJoint softest;
  if (inversion) {
    softest = [&](double from, double to) {
      return softest_joint(*inversion, found.joint.stiffness(), from, to);
    };
  }
  found.stiffness = stiffness_evidence(levels, found.joint, softest);
  for (Warning& warning : diagnose(found.stiffness, found.joint)) {
    // Smoothing may keep the joint of an inversion from k_eq: verdicts are of any joint.
    if (inversion && warning.code == "secant_misfit") continue;
    found.warnings.push_back(std::move(warning));
  }
}

/// Warnings of the levels by themselves and of their stiffness, with the name of the table, without
/// those that other evidence makes irrelevant.
std::vector<Warning> warnings_of_table(const JointEvidence& evidence, std::size_t table,
                                       const Joint& joint) {
  const LevelEvidence& levels = evidence.levels[table];
  std::vector<Warning> warnings = diagnose_beside_others(levels);
  append(warnings, diagnose(stiffness_evidence(levels, joint), joint));
  if (const auto order = judge_order(levels, joint)) append(warnings, diagnose({*order}));
  for (Warning& warning : warnings) {
    warning.text = fmt::format("{}: {}", evidence.name_of_levels(table), warning.text);
  }
  return warnings;
}

}  // namespace

std::string_view to_string(IdentificationMethod method) {
  switch (method) {
    case IdentificationMethod::kSpline:
      return "spline";
    case IdentificationMethod::kDifferences:
      return "differences";
    case IdentificationMethod::kInversion:
      break;
  }
  return "inversion";
}

std::optional<IdentificationMethod> find_identification_method(std::string_view name) {
  for (const IdentificationMethod method : kIdentificationMethods) {
    if (name == to_string(method)) return method;
  }
  return std::nullopt;
}

// The band is of the free density of the inversion: beside another joint it would be taken for its
// own.
void IdentificationOptions::check() const {
  inversion.check();
  if (!bands) return;
  bands->check();
  if (method != IdentificationMethod::kInversion) {
    throw InputError("bands", "asked for", "come with the method inversion only",
                     "Leave out the method, or the bands.");
  }
  if (fit) {
    throw InputError(
        "bands", "asked for",
        fmt::format("are those of a free density, not of the model {}", to_string(*fit)),
        "Leave out the model, whose parameters have standard errors, or the bands.");
  }
}

const InversionResult* Identification::inversion() const {
  const auto* inverted = std::get_if<InvertedDensity>(&free);
  return inverted ? &inverted->result : nullptr;
}

const DensityBands* Identification::bands() const {
  const auto* inverted = std::get_if<InvertedDensity>(&free);
  return inverted && inverted->bands ? &*inverted->bands : nullptr;
}

const SplineDensityResult* Identification::spline() const {
  return std::get_if<SplineDensityResult>(&free);
}

const SignedDensity* Identification::differences() const {
  return std::get_if<SignedDensity>(&free);
}

const RecordInversionResult* Identification::records() const {
  return std::get_if<RecordInversionResult>(&free);
}

Identification identify(const LevelEvidence& evidence, double stiffness,
                        const IdentificationOptions& options) {
  options.check();
  std::vector<Warning> warnings = diagnose(evidence);
  // A fit takes fewer levels than a free density.
  const bool fit_only = options.fit && evidence.size() < kFewestLevels;
  Identification found = fit_only ? Identification(options.method, Joint(stiffness, SlipDensity()))
                                  : by_method(evidence, stiffness, options);
  if (options.fit) replace_by_fit(evidence, stiffness, options, found);
  judge_stiffness(evidence, found);
  found.verdicts = judge_levels(evidence, found.joint, found.linear_damping, found.stiffness);
  append(found.warnings, diagnose(found.verdicts));
  append(warnings, std::move(found.warnings));
  found.warnings = std::move(warnings);
  found.covered_from = stiffness * evidence.levels().amplitude.front();
  found.covered_to = stiffness * evidence.levels().amplitude.back();
  return found;
}

Identification identify(std::span<const RecordEvidence> evidence, std::optional<double> stiffness,
                        const RecordInversionOptions& options) {
  return identify({.records = evidence}, stiffness, options);
}

Identification identify(const JointEvidence& evidence, std::optional<double> stiffness,
                        const RecordInversionOptions& options) {
  RecordInversionResult result = invert_together(evidence, stiffness, options);
  Identification found(IdentificationMethod::kInversion, result.joint());
  read_density_of_joint(found);
  DensityBand band = result.density_band();
  found.lower = std::move(band.lower);
  found.upper = std::move(band.upper);
  found.covered_from = result.stiffness.value * result.resolved_from;
  found.covered_to = result.stiffness.value * result.slip_displacement.back();
  found.summary = result.summary;
  append(found.warnings, diagnose(result, evidence));
  for (std::size_t t = 0; t < evidence.levels.size(); ++t) {
    append(found.warnings, warnings_of_table(evidence, t, found.joint));
  }
  found.free = std::move(result);
  return found;
}

}  // namespace microslip
