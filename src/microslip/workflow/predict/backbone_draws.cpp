// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/backbone_draws.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace microslip {

DrawnBackbone drawn_backbone(const HarmonicBalance& balance, const ResponseCurve& reference,
                             const std::vector<double>& responses, std::size_t mode,
                             StructureDraw drawn) {
  std::vector<double> there;
  for (const double response : responses) there.push_back(response / drawn.response_gain);
  const ResponseCurve curve =
      HarmonicBalance(std::move(drawn.structure), balance.response(), balance.options())
          .resonances(there, mode);
  if (!curve.summary.converged()) return {.failure = curve.summary.reason};
  if (curve.points.size() != reference.points.size()) {
    return {.failure = fmt::format("its backbone has other turning points: {} rows, not {}",
                                   curve.points.size(), reference.points.size())};
  }
  DrawnBackbone backbone;
  for (const SteadyVibration& point : curve.points) {
    backbone.force.push_back(point.force_amplitude);
    backbone.frequency.push_back(point.frequency());
    backbone.damping_ratio.push_back(point.damping_ratio());
  }
  return backbone;
}

BackboneSpread backbone_spread(const HarmonicBalance& balance, const ResponseCurve& reference,
                               const std::vector<double>& responses, std::size_t mode,
                               const StructureDraws& draws, const DrawOptions& options,
                               const Execution& execution, const Progress& progress) {
  options.check();
  using Rows = std::vector<std::vector<double>>;  // [draw][point]
  Rows force(options.count);
  Rows frequency(options.count);
  Rows damping_ratio(options.count);
  const auto take = [&](std::size_t i) {
    DrawnBackbone drawn = drawn_backbone(balance, reference, responses, mode, draws.draw(i));
    force[i] = std::move(drawn.force);
    frequency[i] = std::move(drawn.frequency);
    damping_ratio[i] = std::move(drawn.damping_ratio);
    return drawn.failure;
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
