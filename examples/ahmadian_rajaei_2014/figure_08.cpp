// SPDX-License-Identifier: MIT
// Fig. 8: what the exciter puts in, what the linear damping takes, and the rest, which the joint
// dissipates. [AR14 (15) to (18)]
#include <algorithm>
#include <cmath>

#include "curves.hpp"
#include "figures.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/workflow/reduce/recordings_reduction.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::ReducedLevel;

struct Energies {
  std::vector<double> amplitude;  // m
  std::vector<double> input;      // J
  std::vector<double> linear;     // J
  std::vector<double> joint;      // J
  std::vector<double> truth;      // of the joint, J
  std::vector<double> share;      // of the linear loss, 1
};

Energies energies_of(const Experiment& experiment) {
  Energies energies;
  for (const ReducedLevel& level : experiment.levels) {
    energies.amplitude.push_back(level.amplitude.value);
    energies.input.push_back(level.input_energy.value);
    energies.linear.push_back(level.linear_dissipation);
    energies.joint.push_back(level.dissipation.value);
    energies.truth.push_back(microslip::dissipation(experiment.truth, level.amplitude.value));
    energies.share.push_back(level.linear_dissipation / level.input_energy.value);
  }
  return energies;
}

/// Of D against the truth, over the levels in the upper half.
double largest_error(const Energies& energies) {
  double largest = 0.0;
  for (std::size_t i = energies.joint.size() / 2; i < energies.joint.size(); ++i) {
    largest = std::max(largest, std::abs(energies.joint[i] / energies.truth[i] - 1.0));
  }
  return largest;
}

microslip::FigureGrid picture_of(const Experiment& experiment) {
  const microslip::ExperimentResults results{
      .levels = microslip::measured_levels(experiment.levels), .truth = experiment.truth};
  microslip::FigureOptions options;
  options.beside = {microslip::LineLayer{
      {0.0, experiment.levels.back().amplitude.value},
      {0.15, 0.15},
      "15 %, the paper's at high level",
      {.colour = microslip::kGrey, .style = microslip::LineStyle::kDashed, .width = 1.4}}};
  return {"Energies of a cycle",
          2,
          {microslip::energies_figure(results), microslip::linear_share_figure(results, options)}};
}

}  // namespace

Reproduction figure_08(const Experiment& experiment) {
  const Energies energies = energies_of(experiment);
  Reproduction made{.name = "fig_08",
                    .title = "Input energy, linear loss and dissipation of the joint",
                    .picture = picture_of(experiment)};
  made.size = {.width = 1100, .height = 480};
  microslip::CsvWriter table;
  table.add_numbers("amplitude", microslip::kLength, energies.amplitude);
  table.add_numbers("input_energy", microslip::kEnergy, energies.input);
  table.add_numbers("linear_dissipation", microslip::kEnergy, energies.linear);
  table.add_numbers("dissipation", microslip::kEnergy, energies.joint);
  table.add_numbers("true_dissipation", microslip::kEnergy, energies.truth);
  made.tables.emplace_back("", table);
  // Our rig is not the paper's: it is asked to be alike, not the same.
  made.findings.push_back({"share of the linear loss at the highest level [1]",
                           "0.15 still at high level", energies.share.back(), 0.12, 0.16});
  // The noise of the sensors; record and reduction have the same modes.
  made.findings.push_back(
      {"dissipation of the joint against the true one, largest relative "
       "difference in the upper half of the levels [1]",
       "not in the paper", largest_error(energies), 0.0, 1e-3});
  return made;
}

}  // namespace ahmadian_rajaei
