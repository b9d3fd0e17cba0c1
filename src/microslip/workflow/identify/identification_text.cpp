// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/identification_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/percent.hpp"
#include "microslip/documents/joint/density_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/text/departure_meanings.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

std::string method_name(const Identification& found) {
  if (found.parametric) {
    return fmt::format("fit of the model {}", to_string(found.parametric->model));
  }
  return found.summary.method;
}

/// Of D, and of k_eq where it has standard deviations.
std::string describe_scatter(const InversionResult& result) {
  const double d = result.dissipation_scatter;
  const std::string of_d = result.scatter_is_relative
                               ? percent_text(d) + " of D about the fit (estimated)"
                               : fmt::format("{:.2f} times the given standard deviations", d);
  if (!result.secant_scatter) return line("scatter", of_d);
  const double k = *result.secant_scatter;
  return line("scatter of D", of_d) +
         line("scatter of k_eq", fmt::format("{:.2f} times those given{}", k,
                                             k < 0.7 ? ", which contain more than scatter" : ""));
}

/// Where the joint's own secant stiffnesses lie against the measured ones.
std::string describe_offset(const Identification& found) {
  if (!found.stiffness.secant) return {};
  const SecantEvidence& secant = *found.stiffness.secant;
  const double k = found.joint.stiffness();
  return line(
      "k_eq of the joint",
      fmt::format("{} of k {} the measured, ± {}", percent_text(std::abs(secant.offset) / k),
                  secant.offset > 0.0 ? "below" : "above", percent_text(secant.offset_std / k)));
}

/// Departures found in a record: alternatives are behind the one that they may stand for.
std::vector<std::string> failed_in(const RecordFit& record) {
  std::vector<std::string> texts;
  for (const RecordVerdict& verdict : record.verdicts) {
    if (!verdict.broken) continue;
    std::string text = departure_with_code(to_string(verdict.departure));
    if (verdict.alternative && !texts.empty()) {
      texts.back() += " or " + text;
    } else {
      texts.push_back(std::move(text));
    }
  }
  return texts;
}

/// Failed assumptions, before anything on the density.
std::string describe_broken(const Identification& found) {
  std::vector<std::string> failed;
  const auto add = [&](const std::string& text) {
    if (std::ranges::find(failed, text) == failed.end()) failed.push_back(text);
  };
  for (const LevelDepartureVerdict& verdict : found.verdicts) {
    if (verdict.broken) add(departure_with_code(to_string(verdict.departure)));
  }
  if (found.records()) {
    for (const RecordFit& record : found.records()->records) {
      for (const std::string& text : failed_in(record)) add(text);
    }
  }
  if (failed.empty()) return {};
  const std::string text = fmt::format("NOT A MASING JOINT: {}", fmt::join(failed, "; "));
  constexpr std::size_t kIndent = 23;  // of the second column of line()
  return wrapped(fmt::format("  {:<20} ", "verdict"), text, kIndent) +
         line("", "what follows is the closest Masing joint; see the warnings");
}

/// What a test of levels compares.
std::string_view test_name(LevelDeparture departure) {
  switch (departure) {
    case LevelDeparture::kSecant:
      return "k_eq against D";
    case LevelDeparture::kFrequency:
      return "frequency against D";
    default:
      return "rising against falling levels";
  }
}

/// Tests of the assumptions for levels, each with its number and the most that noise gives.
std::string describe_verdicts(const Identification& found) {
  std::string text;
  for (const LevelDepartureVerdict& verdict : found.verdicts) {
    text += line(text.empty() ? "tested" : "",
                 fmt::format("{}: {} of {}, noise {} at most, {}", test_name(verdict.departure),
                             percent_text(verdict.share), verdict.quantity,
                             percent_text(verdict.noise), verdict.broken ? "failed" : "passed"));
  }
  return text;
}

/// How far the measured frequencies are from what the joint can make of a resonance.
std::string describe_frequencies(const Identification& found) {
  if (!found.stiffness.frequency) return {};
  const FrequencyEvidence& frequency = *found.stiffness.frequency;
  return line("frequencies",
              fmt::format("fit within {:.2g} Hz at sensitivity {:.2f} to the joint's softening",
                          frequency.uncertainty, frequency.share)) +
         line("", fmt::format("({:.2g} Hz at sensitivity 1: the joint as the only stiffness)",
                              frequency.equivalent_joint_error));
}

std::string describe_smoothing(double lambda, std::string_view unit, double edf) {
  return line("smoothing",
              fmt::format("lambda {:.3g}{}, {:.1f} degrees of freedom", lambda, unit, edf));
}

/// λ and p mean nothing without the weights.
std::string describe_spline(const SplineDensityResult& result) {
  return describe_smoothing(result.fit.lambda, " m^3", result.fit.edf) +
         line("weights", result.weighted ? "1/dissipation_std^2 over their mean"
                                         : "1 of each level, without dissipation_std");
}

std::string describe_inversion(const Identification& found) {
  const InversionResult& result = *found.inversion();
  const PathPoint& point = result.path[result.chosen];
  std::string text = describe_scatter(result);
  text += describe_smoothing(point.lambda, "", point.edf);
  text += describe_offset(found);
  if (!result.edges.empty()) {
    text +=
        line("edges", fmt::format("the density jumps at {:.4g} N", fmt::join(result.edges, ", ")));
  }
  if (result.atom_slip_force) {
    text += line("macro-slip at", fmt::format("{:.4g} N, by an atom of weight {:.3f}",
                                              *result.atom_slip_force, result.atom_weight));
  }
  if (found.bands()) {
    text += line("area Φ0", fmt::format("{:.3f}, {:.0f} % band {:.3f} to {:.3f}", result.area,
                                        100.0 * found.bands()->confidence,
                                        found.bands()->area.first, found.bands()->area.second));
  }
  return text;
}

std::string band_text(const Estimate& estimate, double confidence) {
  return fmt::format("{:.0f} % band {:.5g} to {:.5g}", 100.0 * confidence, estimate.lower,
                     estimate.upper);
}

/// Elastic remainder, where the stiffness was identified from records.
std::string describe_records(const RecordInversionResult& result) {
  std::string text = line("elastic remainder",
                          fmt::format("{:.5g} N/m, {}", result.elastic_stiffness.value,
                                      band_text(result.elastic_stiffness, result.confidence)));
  if (result.viscous) {
    text += line("viscous part", fmt::format("{:.5g} N s/m, {}", result.viscous->value,
                                             band_text(*result.viscous, result.confidence)));
  }
  return text + line("draws", fmt::format("{}", result.draws.size()));
}

std::string describe_stiffness(const Identification& found) {
  std::string text = fmt::format("{:.6g} N/m", found.joint.stiffness());
  if (found.records() && !found.records()->stiffness_known) {
    text += ", " + band_text(found.records()->stiffness, found.records()->confidence);
  }
  return line("stiffness k", text);
}

std::string_view name_of_count(const Identification& found) {
  if (!found.records()) return "levels";
  if (found.records()->levels.empty()) return "records";
  return found.records()->records.empty() ? "tables of levels" : "records and tables";
}

std::string describe_parameters(const ParametricResult& fit) {
  std::string text;
  for (const FittedParameter& parameter : fit.parameters) {
    const std::string unit = parameter.unit == "1" ? "" : " " + parameter.unit;
    text += line(
        parameter.name,
        parameter.at_bound
            ? fmt::format("{:.4g}{} (at the end of its range)", parameter.value, unit)
            : fmt::format("{:.4g} ± {:.2g}{}", parameter.value, parameter.standard_error, unit));
  }
  text += line("misfit", percent_text(fit.misfit) + " of D, rms");
  return text;
}

/// The density at a few slip forces, as a table.
std::string describe_density(const Identification& found) {
  constexpr int kRows = 7;
  std::string text = found.lower.empty() ? "  slip force [N]   density [1/N]\n"
                                         : "  slip force [N]   density [1/N]   band [1/N]\n";
  const double from = std::max(found.covered_from, found.slip_force.front());
  const double to = std::min(found.covered_to, found.slip_force.back());
  for (int i = 0; i < kRows; ++i) {
    const double f = from + (to - from) * i / (kRows - 1);
    const auto near = std::ranges::min_element(found.slip_force, {},
                                               [&](double force) { return std::abs(force - f); });
    const auto j = static_cast<std::size_t>(near - found.slip_force.begin());
    text += fmt::format("  {:14.4g}   {:13.4g}", found.slip_force[j], found.density[j]);
    if (!found.lower.empty()) {
      text += fmt::format("   {:.4g} to {:.4g}", found.lower[j], found.upper[j]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string describe_identification(const Identification& found, std::size_t level_count) {
  return describe_identification(found, level_count, found.warnings);
}

std::string describe_identification(const Identification& found, std::size_t level_count,
                                    std::span<const Warning> warnings) {
  const Joint& joint = found.joint;
  const SlipDensity& density = joint.density();
  std::string text = "Identified joint\n" + describe_broken(found);
  text += line("method", method_name(found));
  text += line(name_of_count(found), fmt::format("{}", level_count));
  text += describe_stiffness(found);
  text += line("slip forces covered",
               fmt::format("{:.4g} to {:.4g} N", found.covered_from, found.covered_to));
  if (found.records()) {
    text += describe_records(*found.records());
  } else if (found.inversion() && !found.parametric) {
    text += describe_inversion(found);
  } else {
    if (found.parametric) text += describe_parameters(*found.parametric);
    if (found.spline() && !found.parametric) text += describe_spline(*found.spline());
    text += describe_offset(found);
  }
  text += describe_frequencies(found);
  text += describe_verdicts(found);
  text += line("slipping fraction",
               fmt::format("{:.1f} % of k (elastic remainder {:.1f} %)",
                           100.0 * density.total().zeroth, 100.0 * density.elastic_remainder()));
  text += line("total slip force", fmt::format("{:.4g} N", joint.macroslip_force()));
  if (found.linear_damping && !found.parametric) {
    text += line("linear damping",
                 fmt::format("{:.4g} J/m^2 (adds to D with A^2)", *found.linear_damping));
  }
  text += line("solver", fmt::format("{}: {}", found.summary.status(), found.summary.reason));
  text += describe_density(found);
  for (const Warning& warning : warnings) text += wrapped("  warning: ", warning.text, 11);
  return text;
}

std::string density_csv(const Identification& found, std::string_view command) {
  DensityTable density{found.slip_force, found.density, found.lower, found.upper};
  for (double& value : density.density) value = std::max(value, 0.0);
  CsvWriter table = density_table(density);
  table.add_comment(heading_of(command));
  const AtomsPart& atoms = found.joint.density().atoms();
  for (std::size_t i = 0; i < atoms.weight.size(); ++i) {
    table.add_comment(fmt::format("not in the density: an atom of weight {:.6g} at {:.6g} N",
                                  atoms.weight[i], atoms.slip_force[i]));
  }
  if (!density.lower.empty()) {
    table.add_comment(
        "lower and upper are pointwise: neither edge as a whole is the density of a joint");
  }
  if (!found.summary.converged()) {
    table.add_comment(fmt::format("NOT CONVERGED: {}", found.summary.reason));
  }
  add_warnings(found.warnings, table);
  return table.str();
}

}  // namespace microslip
