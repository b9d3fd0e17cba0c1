// SPDX-License-Identifier: MIT
#include "microslip/report/figures/named_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/report/figures/calibration_figures.hpp"
#include "microslip/report/figures/comparison_figure.hpp"
#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/figures/force_figures.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/report/figures/loops_figure.hpp"
#include "microslip/report/figures/prediction_figures.hpp"
#include "microslip/report/figures/rig_figures.hpp"
#include "microslip/report/figures/verification_figure.hpp"

namespace microslip {
namespace {

/// The figures without titles, which belong in the caption of a paper.
FigureGrid untitled(FigureGrid grid) {
  for (Figure& panel : grid.panels) panel.title.clear();
  return grid;
}

FigureGrid alone(Figure figure) { return untitled({"", 1, {std::move(figure)}}); }

/// A figure of the results of a test.
template <Figure (*Make)(const ExperimentResults&, const FigureOptions&)>
FigureGrid of_test(const ResultInput& input, const FigureOptions& options) {
  return alone(Make(input.test, options));
}

bool has_levels(const ResultInput& input) { return input.test.levels.has_value(); }
bool has_joint(const ResultInput& input) { return input.test.joint.has_value(); }

bool has_column(const ResultInput& input, std::vector<double> MeasuredLevels::*column) {
  return has_levels(input) && !((*input.test.levels).*column).empty();
}

bool has_secant(const ResultInput& input) {
  return has_levels(input) && !input.test.levels->levels.secant_stiffness.empty();
}

FigureGrid density(const ResultInput& input, const FigureOptions& options) {
  if (!input.density) return alone(density_figure(input.test, options));
  return alone(density_figure(*input.density, options));
}

template <FigureGrid (*Make)(const ExperimentResults&, const FigureOptions&)>
FigureGrid panels_of_test(const ResultInput& input, const FigureOptions& options) {
  return untitled(Make(input.test, options));
}

FigureGrid loops(const ResultInput& input, const FigureOptions& options) {
  if (!input.path) return alone(loops_figure(input.test, options));
  return alone(path_figure(input.path->displacement, input.path_force, input.path_band));
}

FigureGrid resonance(const ResultInput& input, const FigureOptions& options) {
  return alone(resonance_figure(input.test, options));
}

FigureGrid force_control(const ResultInput& input, const FigureOptions& options) {
  return untitled(force_control_figure(input.test.force_control, options));
}

FigureGrid verification(const ResultInput& input, const FigureOptions& options) {
  if (!input.test.predictions.empty()) return verification_figure(input.test, options);
  return {"", 3, deviation_figures(input.test, options)};
}

FigureGrid dissipation_of(const ResultInput& input, const FigureOptions& options) {
  if (!input.dissipation) return untitled(joint_figures(input.test, options));
  return joint_figures(*input.dissipation, options);
}

bool always(const ResultInput& /*input*/) { return true; }
bool never(const ResultInput& /*input*/) { return false; }

bool has_density(const ResultInput& input) { return has_joint(input) || input.density; }
bool has_loops(const ResultInput& input) { return has_joint(input) || input.path; }
bool has_steady_loops(const ResultInput& input) { return has_joint(input) && !input.path; }
bool has_stiffness(const ResultInput& input) { return has_joint(input) || has_secant(input); }

bool has_resonance(const ResultInput& input) {
  return has_column(input, &MeasuredLevels::frequency) ||
         has_column(input, &MeasuredLevels::resonance_frequency);
}

/// A ring-down gives the damping of a mode, which no joint has.
bool has_damping(const ResultInput& input) {
  return has_stiffness(input) || has_column(input, &MeasuredLevels::damping_ratio);
}

bool has_deviations(const ResultInput& input) {
  return input.test.predictions.empty() && !input.test.comparisons.empty();
}

bool has_verification(const ResultInput& input) {
  return has_deviations(input) || !input.test.predictions.empty();
}

bool has_dissipation(const ResultInput& input) { return has_joint(input) || input.dissipation; }
bool has_joint_curves(const ResultInput& input) { return has_joint(input) && !input.dissipation; }

bool has_record(const ResultInput& input) { return !input.test.force_paths.empty(); }
constexpr const char* kNeedsRecord = "joint.json and a recording that it was identified from";

/// Whether the results of a test or of a calibration have what a figure needs.
template <bool (*Has)(const ExperimentResults&)>
bool test_has(const ResultInput& input) {
  return Has(input.test);
}

bool has_densities(const ResultInput& input) { return !input.test.densities.empty(); }

constexpr const char* kNeedsDensities =
    "identifiability.csv, or joint.json of calibrate, or densities.csv, or several joints";

constexpr std::array<NamedFigure, 28> kFigures = {{
    {"energies", "input energy, linear loss and joint dissipation by amplitude", "levels.csv",
     has_levels, always, always, of_test<energies_figure>},
    {"density", "slip-force density with its band", "joint.json or density.csv", has_density, never,
     always, density},
    {"loops", "hysteresis loops of the joint at four amplitudes", "joint.json or a CSV of loop",
     has_loops, never, has_steady_loops, loops},
    {"resonance", "frequency over the response or the amplitude", "levels.csv with frequency [Hz]",
     has_resonance, always, never, resonance},
    {"stiffness", "secant stiffness over the amplitude",
     "joint.json or levels.csv with secant_stiffness [N/m]", has_stiffness, always, always,
     of_test<stiffness_figure>},
    {"damping", "loss factor of the joint, or damping ratio, by amplitude",
     "joint.json, or levels.csv with secant_stiffness [N/m] or damping_ratio [1], which reduce "
     "writes of its recordings",
     has_damping, always, has_stiffness, of_test<damping_figure>},
    {"force-control", "harmonics of the force before and after their control", "force_control.csv",
     [](const ResultInput& input) { return !input.test.force_control.empty(); }, never, never,
     force_control},
    {"constant-response", "frequency responses at constant response, predicted",
     "rig.toml, joint.json, levels.csv with response_amplitude [m/s^2]",
     [](const ResultInput& input) { return !input.test.responses.empty(); }, never, never,
     of_test<constant_response_figure>},
    {"verification", "recorded and predicted signals, or the error of each channel",
     "verification.csv or histories", has_verification, has_deviations, never, verification},
    {"comparison", "measured and predicted tests of a structure, with bands",
     "CSV of verify, of tests of a model",
     [](const ResultInput& input) { return !input.compared.empty(); }, never, never,
     [](const ResultInput& input, const FigureOptions& /*options*/) {
       return comparison_figure(input.compared);
     }},
    {"response", "frequency response, amplitude and phase", "CSV of frf",
     [](const ResultInput& input) { return input.response.has_value(); }, never, never,
     [](const ResultInput& input, const FigureOptions& /*options*/) {
       return response_figure(*input.response);
     }},
    {"backbone", "resonance frequency and damping ratio over the amplitude", "CSV of backbone",
     [](const ResultInput& input) { return input.backbone.has_value(); }, always, never,
     [](const ResultInput& input, const FigureOptions& options) {
       return backbone_figure(*input.backbone, options);
     }},
    {"spectrum", "shock response spectrum over the frequency", "CSV of spectrum",
     [](const ResultInput& input) { return input.spectrum.has_value(); }, never, never,
     [](const ResultInput& input, const FigureOptions& /*options*/) {
       return alone(spectrum_figure(*input.spectrum));
     }},
    {"history", "signals over time", "CSV of march or a recording",
     [](const ResultInput& input) { return !input.history.empty(); }, never, never,
     [](const ResultInput& input, const FigureOptions& /*options*/) {
       return histories_figure(input.history);
     }},
    {"ensemble", "curves of an ensemble: median and band of its jobs", "CSV of ensemble",
     [](const ResultInput& input) { return std::ranges::any_of(input.ensemble, is_curve); }, never,
     never,
     [](const ResultInput& input, const FigureOptions& /*options*/) {
       return ensemble_figure(input.ensemble);
     }},
    {"dissipation", "dissipation, secant stiffness and loss factor by amplitude",
     "joint.json or a CSV of dissipation", has_dissipation, always, has_joint_curves,
     dissipation_of},
    {"force", "force of a record over time, measured, found, difference", kNeedsRecord, has_record,
     never, never, panels_of_test<record_force_figure>, true},
    {"record-loops", "force of a record over its displacement, measured and found", kNeedsRecord,
     has_record, never, never, of_test<record_loops_figure>, true},
    {"residuals", "measured less found force over time and displacement", kNeedsRecord, has_record,
     never, never, panels_of_test<residuals_figure>, true},
    {"densities", "densities of several joints with their bands", kNeedsDensities, has_densities,
     never, never, of_test<densities_figure>},
    {"identifiability", "variance reduction of each density by modal levels",
     "identifiability.csv or joint.json of calibrate", test_has<has_variance_reduction>, never,
     never, panels_of_test<identifiability_figure>},
    {"modal-losses", "loss of all joints over the displacement, by mode",
     "calibration.csv or modal_levels.csv with dissipation [J]", test_has<has_modal_losses>, always,
     never, panels_of_test<modal_losses_figure>},
    {"modal-damping", "damping ratio over the displacement, by mode",
     "calibration.csv or modal_levels.csv with damping_ratio [1]", test_has<has_modal_damping>,
     always, never, of_test<modal_damping_figure>},
    {"modal-frequencies", "change of the frequency over the displacement, by mode",
     "calibration.csv or modal_levels.csv with frequency [Hz]", test_has<has_modal_frequencies>,
     always, never, of_test<modal_frequency_figure>},
    {"modal-residuals", "measured less found loss and frequency, by mode", "calibration.csv",
     test_has<has_modal_residuals>, always, never, panels_of_test<modal_residuals_figure>},
    {"joint-amplitudes", "displacement of each joint by that of the structure",
     "calibration.csv or modal_levels.csv with amplitude_NAME [m]", test_has<has_joint_amplitudes>,
     always, never, panels_of_test<joint_amplitudes_figure>},
    {"loss-shares", "share of each joint in the loss, by mode", "calibration.csv",
     test_has<has_loss_shares>, always, never, panels_of_test<loss_shares_figure>},
    {"draws", "draws of a density with their mean and band", "joint_samples.h5",
     [](const ResultInput& input) { return input.samples.has_value(); }, never, never,
     [](const ResultInput& input, const FigureOptions& options) {
       return alone(draws_figure(*input.samples, options));
     }},
}};

std::vector<const NamedFigure*> possible(const ResultInput& input) {
  std::vector<const NamedFigure*> figures;
  for (const NamedFigure& figure : kFigures) {
    if (figure.has(input)) figures.push_back(&figure);
  }
  return figures;
}

/// "It has energies, resonance."
std::string choice_text(const ResultInput& input) {
  std::vector<const char*> names;
  for (const NamedFigure* figure : possible(input)) names.push_back(figure->name);
  return names.empty() ? input.instead
                       : fmt::format("{} has {}.", input.name, fmt::join(names, ", "));
}

const NamedFigure& only_figure(const ResultInput& input) {
  const std::vector<const NamedFigure*> figures = possible(input);
  if (figures.size() == 1) return *figures.front();
  if (figures.empty()) {
    throw InputError("input", in_quotes(input.name), "has no data for any figure",
                     choice_text(input));
  }
  throw InputError("`figure`", InputState{"not given"}, "must name one of several figures",
                   choice_text(input));
}

/// Names the file and, where possible, the axis of a value that cannot be drawn, in place of
/// "panels[0].layers[1].x[3]", for instance.
InputError named(const InputError& error, const ResultInput& input, const FigureGrid* grid) {
  const std::string& name = error.name();
  if (name.starts_with("`")) return error;
  const std::string panels = "panels[";
  std::string part = name.starts_with("layers") ? "value" : name;
  if (grid && name.starts_with(panels)) {
    const Figure& panel = grid->panels.at(std::stoul(name.substr(panels.size())));
    part = name.find(".x") != std::string::npos ? axis_text(panel.x) : axis_text(panel.y);
  }
  return error.renamed(fmt::format("{}: {}", input.name, part));
}

}  // namespace

std::span<const NamedFigure> named_figures() { return kFigures; }

const NamedFigure& find_figure(const std::string& name, const ResultInput& input) {
  if (name.empty()) return only_figure(input);
  const auto found = std::ranges::find_if(
      kFigures, [&](const NamedFigure& figure) { return figure.name == name; });
  if (found != kFigures.end() && found->has(input)) return *found;
  const bool lacks_record = found != kFigures.end() && found->of_record && !input.no_record.empty();
  throw InputError("`figure`", "'" + name + "'",
                   found == kFigures.end() ? "there is no such figure"
                                           : fmt::format("it needs {}", found->needs),
                   lacks_record ? input.no_record : choice_text(input));
}

PaperPicture draw_named(const NamedFigure& figure, const ResultInput& input,
                        const FigureOptions& options, PictureFormat format,
                        const PaperPrint& print) {
  FigureGrid grid;
  try {
    grid = figure.make(input, options);
    return draw_for_paper(grid, format, print);
  } catch (const InputError& error) {
    throw named(error, input, grid.panels.empty() ? nullptr : &grid);
  }
}

}  // namespace microslip
