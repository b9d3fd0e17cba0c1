// SPDX-License-Identifier: MIT
#include "demo/demo_beam.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "arguments/progress_bar.hpp"
#include "demo_data.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/report/figures/density_figure.hpp"
#include "microslip/report/figures/level_figures.hpp"

namespace microslip::app {
namespace {

// Modal stiffness of the Brake-Reuss beam at its drive point; how it was found stands in
// examples/brake_reuss_beam/README.md.
constexpr double kBeamStiffness = 5.08e5;  // N/m

// One of the first thousand draws of seed 1 weighs as much as most others: the band of these is
// that of 20 000 draws.
constexpr std::uint64_t kBeamSeed = 2;

}  // namespace

Identification demonstrate_beam(DemoFolder& folder) {
  const std::string kFolder = "brake_reuss_beam";
  const LevelsFile file =
      parse_levels(std::string(kBrakeReussLevels), "examples/brake_reuss_beam/levels.csv");
  IdentificationOptions options;
  options.inversion.linear_damping = true;
  options.bands =
      BandOptions{.seed = kBeamSeed, .progress = progress_bar("bands", folder.call().quiet)};
  Identification found = identify(file.levels, kBeamStiffness, options);
  folder.add(kFolder + "/levels.csv", std::string(kBrakeReussLevels));
  folder.add_identification(kFolder, found, options, file.file, kBrakeReussLevels);
  folder.add_report(
      {kFolder, "Brake–Reuß beam",
       "Eight measured levels of a bolted joint, as an equivalent joint between drive point and "
       "ground with linear damping in parallel",
       [](const ExperimentResults& results) -> std::vector<DemoPicture> {
         return {{"dissipation", dissipation_figure(results)},
                 {"density", density_figure(results)}};
       }});
  return found;
}

}  // namespace microslip::app
