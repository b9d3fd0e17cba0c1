// SPDX-License-Identifier: MIT
// Fig. 6: the resonance of the rig over the level of its response.
#include <vector>

#include "figures.hpp"
#include "microslip/base/units.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::ReducedLevel;

template <typename T>
std::vector<double> column(const Experiment& experiment, T ReducedLevel::*member) {
  std::vector<double> values;
  for (const ReducedLevel& level : experiment.levels) values.push_back(level.*member);
  return values;
}

}  // namespace

Reproduction figure_06(const Experiment& experiment) {
  const std::vector<double> response = column(experiment, &ReducedLevel::response_amplitude);
  const std::vector<double> resonance = column(experiment, &ReducedLevel::resonance_frequency);
  const std::vector<double> drive = column(experiment, &ReducedLevel::frequency);

  microslip::Figure figure = microslip::resonance_figure(
      {.levels = microslip::measured_levels(experiment.levels)}, {.response_unit = "g"});
  figure.title = "Resonance over level";
  figure.subtitle = "first bending mode of the beam on its frictional support";
  Reproduction made{.name = "fig_06", .title = "Resonance over level", .picture = figure};
  microslip::CsvWriter table;
  table.add_numbers("response_amplitude", microslip::kAcceleration, response);
  table.add_numbers("resonance_frequency", microslip::kFrequency, resonance);
  table.add_numbers("drive_frequency", microslip::kFrequency, drive);
  made.tables.emplace_back("", table);
  // The paper's frequencies are set, and so known, within 0.1 Hz.
  made.findings.push_back(
      {"resonance at the lowest level, 30 mg [Hz]", "55.8", resonance.front(), 55.7, 55.9});
  made.findings.push_back(
      {"resonance at the highest level, 4 g [Hz]", "54.6", resonance.back(), 54.5, 54.7});
  return made;
}

}  // namespace ahmadian_rajaei
