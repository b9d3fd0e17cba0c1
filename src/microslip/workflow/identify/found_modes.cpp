// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/found_modes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

JointedStructure corrected(const JointedStructure& structure, const FoundModes& modes) {
  try {
    return with_modal_offsets(structure, modes.offset, modes.springs);
  } catch (const InputError&) {
    throw InputError("frequencies of the model", "\"corrected\"",
                     "must leave the structure stable without its joints, whose stiffness these "
                     "modes have almost alone",
                     "Take them as given: their offsets are then frequency_std.");
  }
}

}  // namespace

void set_found_modes(const FoundModes& modes, ModelFrequencies asked, ModelFile& model) {
  if (!modes.any()) return;
  const bool correct = asked == ModelFrequencies::kCorrected;
  std::vector<double>& spread = model.spread.frequency;
  spread.resize(modes.offset.size(), 0.0);
  for (std::size_t i = 0; i < spread.size(); ++i) {
    const double left = correct ? 0.0 : modes.offset[i];
    spread[i] = std::max(spread[i], std::hypot(left, modes.deviation[i]));
  }
  if (correct) model.structure = corrected(model.structure, modes);
}

std::string describe_found_modes(const CalibrationResult& found, ModelFrequencies asked) {
  if (!found.modes.any()) return {};
  std::vector<std::string> offsets;
  for (std::size_t m = 0; m < found.frequency_offset.size(); ++m) {
    if (std::isnan(found.frequency_offset[m])) continue;
    offsets.push_back(fmt::format("mode {} {:+.2g} %", m + 1, 100.0 * found.frequency_offset[m]));
  }
  const bool correct = asked == ModelFrequencies::kCorrected;
  double most = 0.0;
  for (const double each : correct ? found.modes.deviation : found.modes.offset) {
    most = std::max(most, std::abs(each));
  }
  return line("offsets",
              fmt::format("measured frequencies are off the model: {}", fmt::join(offsets, ", "))) +
         line("", correct ? fmt::format("corrected in model.toml; up to {} are left, its "
                                        "frequency_std",
                                        percent_text(most))
                          : fmt::format("up to {} as frequency_std in model.toml; "
                                        "`--model-frequencies corrected` corrects it",
                                        percent_text(most)));
}

}  // namespace microslip
