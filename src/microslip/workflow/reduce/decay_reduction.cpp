// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/decay_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "microslip/base/codes.hpp"
#include "microslip/base/error.hpp"
#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/reduce/decay_signal.hpp"
#include "microslip/workflow/reduce/decay_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

std::vector<std::string> flags_of(const ReducedDecay& reduced) {
  const std::string all = codes_of_decay(reduced.warnings);
  std::vector<std::string> flags = reduced.levels.flags;
  for (std::string& own : flags) add_code(own, all);
  return flags;
}

/// Comment on the decay above the levels.
std::string comment_of(const ReducedDecay& reduced, std::string_view command) {
  std::string text = heading_of(command);
  text += "\nsensors: " + decay_sensors_text(reduced.decay);
  text += "\nfree decay from: " + decay_start_text(reduced.decay);
  text += "\nband: " + decay_band_text(reduced.decay, reduced.band_given);
  text += "\nended: " + reduced.decay.summary.reason;
  return with_warnings(std::move(text), reduced.warnings);
}

CsvWriter dissipation_table(const RingDownLevels& found) {
  return levels_table({.amplitude = found.amplitude,
                       .dissipation = found.dissipation,
                       .amplitude_std = found.amplitude_std,
                       .dissipation_std = found.dissipation_std,
                       .secant_stiffness = found.secant_stiffness,
                       .secant_stiffness_std = found.secant_stiffness_std});
}

}  // namespace

ReducedDecay reduce_decay(const DecayReduction& options) {
  const Recordings file = read_recordings(options.recording, options.reading);
  const DecaySignal signal = choose_signals(file.recordings, options.channels, options.recording);
  RingDown decay = ring_down(*signal.recording, signal.channels, options.analysis);
  RingDownLevels levels = options.levels ? levels_of(decay, *options.levels)
                                         : damping_levels_of(decay, options.joint_ratio);
  std::vector<Warning> warnings = file.warnings;
  for (const auto* more : {&decay.warnings, &levels.warnings}) {
    warnings.insert(warnings.end(), more->begin(), more->end());
  }
  return {signal.recording->source, std::move(decay), std::move(levels), std::move(warnings),
          options.analysis.band.has_value()};
}

std::string levels_text(const ReducedDecay& reduced, std::string_view command) {
  const RingDownLevels& found = reduced.levels;
  const std::size_t n = found.amplitude.size();
  const bool damping_alone = found.dissipation.empty();
  CsvWriter table = damping_alone ? CsvWriter() : dissipation_table(found);
  if (damping_alone) {
    table.add_numbers("amplitude", kLength, found.amplitude);
    table.add_numbers("amplitude_std", kLength, found.amplitude_std);
  }
  table.add_numbers("frequency", kFrequency, found.frequency);
  table.add_numbers("frequency_std", kFrequency, found.frequency_std);
  table.add_numbers("damping_ratio", kDimensionless, found.damping_ratio);
  table.add_numbers("damping_ratio_std", kDimensionless, found.damping_ratio_std);
  // A column `time` would make the table a history, which no table of levels may replace.
  table.add_numbers("decay_time", kTime, found.time);
  table.add_text("source", std::vector<std::string>(n, reduced.source));
  table.add_text("flags", flags_of(reduced));
  table.add_comment(comment_of(reduced, command));
  return table.str();
}

std::string describe_decay(const ReducedDecay& reduced) {
  const RingDown& decay = reduced.decay;
  const RingDownLevels& levels = reduced.levels;
  const auto span = [](const std::vector<double>& values) {
    return fmt::format("{:.4g} to {:.4g}", values.front(), values.back());
  };
  std::string text = "Ring-down\n";
  text += line("recording", fmt::format("{}, {}", reduced.source, decay_sensors_text(decay)));
  text += line("method", decay.summary.method);
  text += line("free decay from", decay_start_text(decay));
  text += line("band", decay_band_text(decay, reduced.band_given));
  text += line("decay used",
               fmt::format("{:.4g} to {:.4g} s, {}", decay.from, decay.to, decay.summary.reason));
  text += line("levels", fmt::format("{}, by falling amplitude", levels.amplitude.size()));
  const bool damping_alone = levels.dissipation.empty();
  text += line(damping_alone ? "amplitude" : "joint amplitude", span(levels.amplitude) + " m");
  text += line("dissipation",
               damping_alone ? "none: without `modal_mass`" : span(levels.dissipation) + " J");
  text += line("frequency",
               fmt::format("{:.6g} to {:.6g} Hz ({:+.2g} %)", levels.frequency.front(),
                           levels.frequency.back(),
                           100.0 * (levels.frequency.back() / levels.frequency.front() - 1.0)));
  text += line("damping ratio", span(levels.damping_ratio));
  text += line("noise",
               fmt::format("{:.2g} of the first amplitude, per sample", decay.summary.residual));
  return text + describe_warnings(reduced.warnings);
}

}  // namespace microslip
