// SPDX-License-Identifier: MIT
#include "microslip/workflow/backbone_draws.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace microslip {

BackboneSpread backbone_spread(const HarmonicBalance& balance, const ResponseCurve& reference,
                               const std::vector<double>& responses, std::size_t mode,
                               const StructureDraws& draws, const DrawOptions& options,
                               const Execution& execution, const Progress& progress) {
  options.check();
  using Rows = std::vector<std::vector<double>>;  // [draw][point]
  Rows force(options.count);
  Rows frequency(options.count);
  Rows damping_ratio(options.count);
  const auto take = [&](std::size_t i) -> std::string {
    StructureDraw drawn = draws.draw(i);
    std::vector<double> there;
    for (const double response : responses) there.push_back(response / drawn.response_gain);
    const ResponseCurve curve =
        HarmonicBalance(std::move(drawn.structure), balance.response(), balance.options())
            .resonances(there, mode);
    if (!curve.summary.converged()) return curve.summary.reason;
    if (curve.points.size() != reference.points.size()) {
      return fmt::format("its backbone turns back otherwise: {} rows, not {}", curve.points.size(),
                         reference.points.size());
    }
    for (const SteadyVibration& point : curve.points) {
      force[i].push_back(point.force_amplitude);
      frequency[i].push_back(point.frequency());
      damping_ratio[i].push_back(point.damping_ratio());
    }
    return "";
  };
  BackboneSpread spread;
  spread.taken = take_draws(options, take, execution, progress);
  spread.force = band_of(force, options.confidence);
  spread.frequency = band_of(frequency, options.confidence);
  spread.damping_ratio = band_of(damping_ratio, options.confidence);
  spread.warnings = draw_warnings(spread.taken);
  return spread;
}

}  // namespace microslip
