// SPDX-License-Identifier: MIT
#include "microslip/report/figures/rig_figures.hpp"
#include "microslip/report/sections/sections.hpp"

namespace microslip {

ReportSection responses_section(const ExperimentResults& results) {
  ReportSection section{.title = "Responses", .blocks = {}};
  if (results.responses.empty() || !results.levels) {
    section.blocks.emplace_back(
        ReportMissing{"No frequency responses, which need rig.toml, joint.json and a levels.csv "
                      "with response amplitudes in this folder."});
  } else {
    section.blocks.emplace_back(
        ReportFigure{.figure = constant_response_figure(results), .wide = true});
  }
  return section;
}

}  // namespace microslip
