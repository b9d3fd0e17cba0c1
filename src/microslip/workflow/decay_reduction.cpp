// SPDX-License-Identifier: MIT
#include "microslip/workflow/decay_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/io/text.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/provenance.hpp"
#include "microslip/workflow/summary_text.hpp"

namespace microslip {
namespace {

/// One decay: channels of one recording, one at least.
struct DecaySignal {
  const Recording* recording;
  std::vector<std::string> channels;
};

bool is_motion(const Recording& recording, const Channel& channel) {
  return recording.axis.dimension == kTime && channel.imaginary.empty() && channel.dimension &&
         (*channel.dimension == kLength || *channel.dimension == kVelocity ||
          *channel.dimension == kAcceleration);
}

/// The channel of that name, or the only motion there is.
DecaySignal choose_signal(const std::vector<Recording>& recordings, const std::string& name,
                          const std::string& file) {
  std::vector<DecaySignal> fits;
  std::string names;
  for (const Recording& recording : recordings) {
    for (const Channel& channel : recording.channels) {
      if (name.empty() ? is_motion(recording, channel) : channel.name == name) {
        fits.push_back({&recording, {channel.name}});
      }
      names += (names.empty() ? "'" : ", '") + channel.name + "'";
    }
  }
  if (fits.size() == 1) return fits.front();
  const std::string what =
      fmt::format("{}: {}", file, name.empty() ? "motion" : "channel " + in_quotes(name));
  const std::string state = fits.empty() ? "missing" : fmt::format("there {} times", fits.size());
  throw InputError(what, InputState{state},
                   name.empty() ? "must have one channel of displacement, velocity or acceleration "
                                  "over time"
                                : "must be there once",
                   fmt::format("The channels are {}; choose by `channel`, and give units that the "
                               "file lacks by `assume_units`.",
                               names.empty() ? "none" : names));
}

/// The channels of those names, all of one recording.
DecaySignal choose_signals(const std::vector<Recording>& recordings,
                           const std::vector<std::string>& names, const std::string& file) {
  if (names.empty()) return choose_signal(recordings, "", file);
  DecaySignal signal = choose_signal(recordings, names.front(), file);
  for (const std::string& name : std::span(names).subspan(1)) {
    const DecaySignal other = choose_signal(recordings, name, file);
    if (other.recording != signal.recording) {
      throw InputError(fmt::format("{}: channel {}", file, in_quotes(name)), "of another recording",
                       fmt::format("must be recorded with {}: one blow", in_quotes(names.front())));
    }
    signal.channels.push_back(name);
  }
  return signal;
}

/// What holds for the whole decay: what single levels say of themselves is among their own flags.
std::string codes_of(const std::vector<Warning>& warnings) {
  std::string codes;
  for (const Warning& warning : warnings) {
    constexpr std::string_view kOfLevels[] = {"beats", "neighbour_leaks", "sensors_differ",
                                              "shape_moves", "steady_tone"};
    if (std::ranges::find(kOfLevels, warning.code) != std::end(kOfLevels)) continue;
    if ((" " + codes + " ").find(" " + warning.code + " ") != std::string::npos) continue;
    codes += (codes.empty() ? "" : " ") + warning.code;
  }
  return codes;
}

std::vector<std::string> flags_of(const ReducedDecay& reduced) {
  const std::string all = codes_of(reduced.warnings);
  std::vector<std::string> flags = reduced.levels.flags;
  for (std::string& own : flags) own += (own.empty() || all.empty() ? "" : " ") + all;
  return flags;
}

std::string start_text(const RingDown& decay) {
  std::string text = fmt::format("{:.5g} s, ", decay.start);
  switch (decay.start_by) {
    case DecayStart::kGiven:
      return text + "given";
    case DecayStart::kRecord:
      return text + "the beginning of the record: no blow is in it";
    case DecayStart::kBlow:
      return text + fmt::format("1.5 periods behind the blow at {:.5g} s", *decay.blow);
    case DecayStart::kFall:
      break;
  }
  return text + "where the mode begins to fall";
}

std::string band_text(const RingDown& decay, bool given) {
  return fmt::format("{:.6g}:{:.6g} Hz, {}", decay.band.first, decay.band.second,
                     given ? "given" : "by the neighbouring modes and the damping");
}

std::string sensors_text(const RingDown& decay) {
  std::string text;
  for (const RingDownSensor& sensor : decay.sensors) {
    text += (text.empty() ? "" : ", ") + sensor.name;
    if (&sensor == &decay.sensors.front()) continue;
    text += fmt::format(" ({:.4g} of its amplitude, {:.2g} % apart over the decay)", sensor.ratio,
                        100.0 * sensor.ratio_range);
  }
  return text;
}

/// What is said of the decay above the levels.
std::string comment_of(const ReducedDecay& reduced, std::string_view command) {
  std::string text = heading_of(command);
  text += "\nsensors: " + sensors_text(reduced.decay);
  text += "\nfree decay from: " + start_text(reduced.decay);
  text += "\nband: " + band_text(reduced.decay, reduced.band_given);
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
  text += line("recording", fmt::format("{}, {}", reduced.source, sensors_text(decay)));
  text += line("method", decay.summary.method);
  text += line("free decay from", start_text(decay));
  text += line("band", band_text(decay, reduced.band_given));
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
  text +=
      line("noise", fmt::format("{:.2g} of the first amplitude, a sample", decay.summary.residual));
  return text + describe_warnings(reduced.warnings);
}

}  // namespace microslip
