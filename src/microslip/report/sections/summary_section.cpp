// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "microslip/base/percent.hpp"
#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/sections/left_out.hpp"
#include "microslip/report/sections/prediction_reach.hpp"
#include "microslip/report/sections/sections.hpp"
#include "microslip/report/sections/verdict_block.hpp"
#include "microslip/workflow/results/verdict.hpp"
#include "microslip/workflow/text/departure_meanings.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr const char* kIdentify =
    "microslip identify levels.csv --stiffness K --bands 1000 --out joint.json --density-csv "
    "density.csv";

/// Origin of the joint, as far as its file states it.
std::string origin(const ExperimentResults& results) {
  const IdentifiedJoint& found = *results.joint;
  const double k = found.joint.stiffness() / kKilonewtonPerMetre;
  if (found.method.empty()) {
    return fmt::format("A joint of stuck stiffness {:.4g} kN/m. Its file does not state the method",
                       k);
  }
  std::string text = fmt::format("A joint of stuck stiffness {:.4g} kN/m was identified by {}", k,
                                 found.found_by());
  if (!results.levels) return text;
  return text + (found.from_these_levels
                     ? fmt::format(" from {}", counted(used_count(*results.levels), "level"))
                     : ", according to its file not from the levels below");
}

/// The method and the result in a sentence or two.
std::string lead(const ExperimentResults& results) {
  const IdentifiedJoint& found = *results.joint;
  const SlipDensity& density = found.joint.density();
  const PartialMoments slips =
      found.covered_to ? density.moments(*found.covered_to) : density.total();
  std::string text =
      fmt::format("{}. {} of its stiffness slips", origin(results), percent_text(slips.zeroth));
  if (!found.covered_to) return text + ".";
  constexpr double kNothing = 5e-4;  // 0.0 %
  if (1.0 - slips.zeroth < kNothing) {
    return text + fmt::format(" at slip forces up to {:.3g} N.", *found.covered_to);
  }
  return text + fmt::format(
                    " at slip forces up to {:.3g} N. The levels end there and do not show slip "
                    "under larger forces.",
                    *found.covered_to);
}

ReportFacts key_facts(const ExperimentResults& results) {
  ReportFacts facts{.prominent = true, .beside = true};
  const auto add = [&](const char* name, std::string value) {
    facts.facts.emplace_back(name, std::move(value));
  };
  const IdentifiedJoint& found = *results.joint;
  const SlipDensity& density = found.joint.density();
  add("stuck stiffness k",
      fmt::format("{:.4g} kN/m", found.joint.stiffness() / kKilonewtonPerMetre));
  if (found.covered_from && found.covered_to) {
    add("slip forces covered",
        fmt::format("{:.3g} to {:.3g} N", *found.covered_from, *found.covered_to));
  }
  add("slipping fraction of k", percent_text(density.total().zeroth));
  add("elastic remainder", percent_text(density.elastic_remainder()));
  for (std::size_t i = 0; i < density.atoms().weight.size() && i < kMostAtomsShown; ++i) {
    add("slips at once", fmt::format("{} at {:.4g} N", percent_text(density.atoms().weight[i]),
                                     density.atoms().slip_force[i]));
  }
  add("total slip force", fmt::format("{:.4g} N", found.joint.macroslip_force()));
  return facts;
}

/// Scatter of the levels that the joint was identified from.
std::string scatter_of(const IdentifiedJoint& found) {
  std::string text =
      found.scatter_is_relative
          ? percent_text(*found.scatter) + " of D about the fit"
          : fmt::format("D {:.2f} times the given standard deviations", *found.scatter);
  if (found.secant_scatter) text += fmt::format(", k_eq {:.2f} of its own", *found.secant_scatter);
  return text;
}

std::string smoothing_of(const IdentifiedJoint& found) {
  std::string text =
      fmt::format("λ = {:.3g}{}", *found.lambda, found.found_by() == "spline" ? " m³" : "");
  if (found.degrees_of_freedom) {
    text += fmt::format(", {:.1f} degrees of freedom", *found.degrees_of_freedom);
  }
  return text + (found.smoothing.empty() ? "" : fmt::format(" ({})", found.smoothing));
}

/// Forces have a unit; other parameters have none, or one that the model gives.
std::string parameter_text(const ParameterFound& parameter) {
  std::string text = fmt::format("{:.4g}", parameter.value);
  if (parameter.error.value_or(0.0) > 0.0) text += fmt::format(" ± {:.2g}", *parameter.error);
  if (parameter.name.ends_with("force") || parameter.name == "to") text += " N";
  return text + (parameter.error == 0.0 ? " (at the end of its range)" : "");
}

ReportFacts certainty(const ExperimentResults& results) {
  ReportFacts facts{.title = "Uncertainty", .facts = {}};
  const auto add = [&](const char* name, std::string value) {
    facts.facts.emplace_back(name, std::move(value));
  };
  const IdentifiedJoint& found = *results.joint;
  add("method", found.found_by().empty() ? "not given in the file" : found.found_by());
  if (results.levels && found.from_these_levels) {
    add("levels", fmt::format("{}", used_count(*results.levels)));
  }
  add("solver", found.status);
  for (const DepartureFound& one : found.verdicts) {
    add("tested for", fmt::format("{}: {}, by noise {}: {}", departure_meaning(one.departure),
                                  percent_text(one.share), percent_text(one.noise),
                                  one.broken ? "found" : "not found"));
  }
  if (const auto width = typical_half_width(found)) {
    add("density known to",
        fmt::format("± {} by scatter alone (median half-width of the {:.0f} % band)",
                    percent_text(*width), 100.0 * found.band_confidence));
  } else {
    add("density known to", "not available: no band was computed (identify --bands 1000)");
  }
  // Of a parametric model they are those of the free density that it was compared with.
  if (found.parameters.empty()) {
    if (found.scatter) add("scatter of its levels", scatter_of(found));
    if (found.lambda) add("smoothing", smoothing_of(found));
  }
  if (results.levels) add("misfit to the levels shown", misfit_text(results));
  for (const ParameterFound& one : found.parameters) {
    if (one.name.ends_with("linear_damping")) continue;  // it has a line of its own
    add(one.name.c_str(), parameter_text(one));
  }
  if (found.linear_damping) {
    add("linear damping fitted",
        fmt::format("{:.4g} J/m² (adds to D with A²)", *found.linear_damping));
  }
  if (const auto error = error_against_truth(results)) {
    add("error against the truth",
        fmt::format("{} of the density, relative L2 over 5 to 95 % of the range",
                    percent_text(*error)));
  }
  return facts;
}

std::string not_examined(const ExperimentResults& results, const ReportWarnings& warnings) {
  return fmt::format(
      "{}Not examined: whether the stuck stiffness k, the linear damping of the structure and the "
      "gains of the sensors are right{}.",
      warnings.warnings.empty() ? "No warning and no flag. " : "", unknown_repeatability(results));
}

}  // namespace

ReportSection summary_section(const ExperimentResults& results,
                              const std::optional<MethodComparison>& methods) {
  ReportSection section{.title = "Summary", .blocks = {}};
  const auto add = [&section](auto block) { section.blocks.emplace_back(std::move(block)); };
  const ReportWarnings warnings{.warnings = warnings_of(results, methods), .beside = true};
  if (!results.joint) {
    add(ReportMissing{"No joint.json in this folder: no joint was identified yet.", kIdentify});
    add(warnings);
    return section;
  }
  const IdentifiedJoint& joint = *results.joint;
  ReportVerdict verdict = verdict_on_joint(joint.verdicts, joint.status, warnings.warnings);
  put_contradictions(results, verdict);
  add(std::move(verdict));
  if (joint.joint.density().largest_slip_force() > 0.0) {
    add(ReportFigure{.figure = density_figure(results)});
  }
  add(key_facts(results));
  add(reach_of_levels(results));
  add(warnings);
  add(ReportText{lead(results)});
  add(ReportText{not_examined(results, warnings)});
  add(certainty(results));
  return section;
}

}  // namespace microslip
