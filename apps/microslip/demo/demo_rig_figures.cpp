// SPDX-License-Identifier: MIT
#include "demo/demo_rig_figures.hpp"

#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/figures/level_figures.hpp"
#include "microslip/report/figures/loops_figure.hpp"
#include "microslip/report/figures/rig_figures.hpp"
#include "microslip/report/figures/verification_figure.hpp"

namespace microslip::app {

std::vector<DemoPicture> rig_pictures(const ExperimentResults& results) {
  constexpr PictureSize kTwo{1100, 480};
  const FigureGrid verification = verification_figure(results);
  return {{"resonance", resonance_figure(results)},
          {"force_control", force_control_figure(results.force_control), kTwo},
          {"energies", FigureGrid{"", 2, {energies_figure(results), linear_share_figure(results)}},
           kTwo},
          {"dissipation", dissipation_figure(results)},
          {"density", density_figure(results)},
          {"loops", regenerated_loops_figure(results), kTwo},
          {"constant_response", constant_response_figure(results)},
          {"verification", verification, verification_size(verification)}};
}

}  // namespace microslip::app
