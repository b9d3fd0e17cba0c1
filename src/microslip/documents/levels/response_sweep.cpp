// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/response_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/levels/listed_units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"
#include "microslip/io/mat/mat_value.hpp"

namespace microslip {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// How often a motion is differentiated from a displacement, 0 to 2; nothing of other dimensions.
std::optional<int> rate_of(const Dimension& dimension) {
  constexpr std::array kMotions{kLength, kVelocity, kAcceleration};
  const auto* found = std::ranges::find(kMotions, dimension);
  if (found == kMotions.end()) return std::nullopt;
  return static_cast<int>(found - kMotions.begin());
}

std::optional<int> rate_per_force(const Dimension& dimension) {
  return rate_of(dimension * kForce);
}

/// (iω)^n that makes an acceleration of a motion of that rate.
Complex to_acceleration(double frequency, int rate) {
  const Complex differentiation(0.0, 2.0 * pi * frequency);
  Complex factor = 1.0;
  for (int i = rate; i < 2; ++i) factor *= differentiation;
  return factor;
}

/// A sweep in its own quantities.
struct ResponseSweep {
  std::string source;
  std::vector<double> frequency;  // Hz
  std::vector<Complex> transfer;  // SI
  int transfer_rate;
  std::vector<double> level;  // SI
  int level_rate;
};

/// A phase without the jumps of 2π that the noise of a phase near π makes.
void unwrap(std::vector<double>& phase) {
  for (std::size_t i = 1; i < phase.size(); ++i) {
    phase[i] = phase[i - 1] + std::remainder(phase[i] - phase[i - 1], 2.0 * pi);
  }
}

SteppedSine stepped_sine_of(const ResponseSweep& sweep) {
  SteppedSine result{sweep.source, sweep.frequency, {}, {}, {}};
  for (std::size_t i = 0; i < sweep.frequency.size(); ++i) {
    const double frequency = sweep.frequency[i];
    const Complex accelerance = sweep.transfer[i] * to_acceleration(frequency, sweep.transfer_rate);
    const double acceleration =
        std::abs(sweep.level[i] * to_acceleration(frequency, sweep.level_rate));
    result.acceleration.push_back(acceleration);
    result.force.push_back(acceleration / std::abs(accelerance));
    result.phase.push_back(std::arg(accelerance));
  }
  unwrap(result.phase);
  check_stepped_sine(result);
  return result;
}

std::vector<Complex> complex_values(std::vector<double> real,
                                    const std::vector<double>& imaginary) {
  std::vector<Complex> values(real.begin(), real.end());
  for (std::size_t i = 0; i < imaginary.size(); ++i) values[i].imag(imaginary[i]);
  return values;
}

std::vector<double> magnitudes(const std::vector<Complex>& values) {
  std::vector<double> result;
  for (const Complex& value : values) result.push_back(std::abs(value));
  return result;
}

// ---- Universal files. ----

/// The only channel that fits.
const Channel& only_channel(const Recording& recording, std::string_view what,
                            std::string_view remedy,
                            std::optional<int> (*rate)(const Dimension& dimension)) {
  const Channel* found = nullptr;
  std::size_t count = 0;
  for (const Channel& channel : recording.channels) {
    if (!channel.dimension || !rate(*channel.dimension)) continue;
    found = &channel;
    ++count;
  }
  if (count == 1) return *found;
  throw InputError(recording.source, fmt::format("{} channels with {}", count, what),
                   "must have one, of the point that is driven, over the frequencies of a sweep",
                   std::string(remedy));
}

/// The sweep of a frequency response and the level of the response.
SteppedSine sweep_of_pair(const Recording& recording, const Channel& transfer, const Channel& level,
                          const std::string& source) {
  ResponseSweep sweep{.source = source,
                      .frequency = {},
                      .transfer = complex_values(transfer.values, transfer.imaginary),
                      .transfer_rate = *rate_per_force(*transfer.dimension),
                      .level = magnitudes(complex_values(level.values, level.imaginary)),
                      .level_rate = *rate_of(*level.dimension)};
  for (std::size_t i = 0; i < recording.size(); ++i)
    sweep.frequency.push_back(recording.axis.at(i));
  return stepped_sine_of(sweep);
}

using Channels = std::vector<const Channel*>;

Channels channels_of(const Recording& recording,
                     std::optional<int> (*rate)(const Dimension& dimension)) {
  Channels found;
  for (const Channel& channel : recording.channels) {
    if (channel.dimension && rate(*channel.dimension)) found.push_back(&channel);
  }
  return found;
}

/// The attribute of that name; empty where there is none.
std::string attribute_of(const Channel& channel, std::string_view name) {
  const auto found = std::ranges::find_if(
      channel.attributes, [&](const auto& attribute) { return attribute.first == name; });
  return found == channel.attributes.end() ? std::string() : found->second;
}

/// Whether channels are of one point and direction of the response.
bool are_of_one_point(const Channels& channels) {
  return std::ranges::all_of(channels, [&](const Channel* channel) {
    return std::ranges::all_of(
        std::array{"response node", "response direction"}, [&](const char* name) {
          return attribute_of(*channel, name) == attribute_of(*channels.front(), name);
        });
  });
}

/// Levels in the order of the frequency responses that have the same text by this attribute; none
/// where that is not one each.
Channels paired(const Channels& transfers, const Channels& levels, std::string_view attribute) {
  Channels result;
  for (const Channel* transfer : transfers) {
    const std::string text = attribute_of(*transfer, attribute);
    const auto has_text = [&](const Channel* other) {
      return attribute_of(*other, attribute) == text;
    };
    if (text.empty() || std::ranges::count_if(transfers, has_text) != 1 ||
        std::ranges::count_if(levels, has_text) != 1) {
      return {};
    }
    result.push_back(*std::ranges::find_if(levels, has_text));
  }
  return result;
}

/// Of several levels over the same frequencies, which an identification or a number pairs.
std::vector<SteppedSine> sweeps_of(const Recording& recording) {
  const Channels transfers = channels_of(recording, rate_per_force);
  const Channels levels = channels_of(recording, rate_of);
  const bool are_pairs = transfers.size() > 1 && transfers.size() == levels.size() &&
                         are_of_one_point(transfers) && are_of_one_point(levels);
  for (const char* attribute : {"id line 1", "function number"}) {
    const Channels pairs = are_pairs ? paired(transfers, levels, attribute) : Channels();
    std::vector<SteppedSine> sweeps;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::string text = attribute_of(*transfers[i], attribute);
      sweeps.push_back(sweep_of_pair(recording, *transfers[i], *pairs[i],
                                     fmt::format("{}: {}", recording.source, printable(text))));
    }
    if (!sweeps.empty()) return sweeps;
  }
  const Channel& transfer = only_channel(
      recording, "a frequency response",
      "Keep the drive point alone: microslip convert FILE NEW --channel NAME. Several levels of it "
      "over the same frequencies need one identification each, in the first line of both of its "
      "functions.",
      rate_per_force);
  const Channel& level = only_channel(
      recording, "the level of the response",
      "Export the spectrum of the response, in m/s^2 or g, beside the frequency response.",
      rate_of);
  return {sweep_of_pair(recording, transfer, level, recording.source)};
}

// ---- MATLAB. ----

constexpr std::array<std::string_view, 2> kFrequencyFields{"FREQUENCY", "FREQ"};
constexpr std::array<std::string_view, 2> kTransferFields{"FRF", "H"};
constexpr std::array<std::string_view, 2> kLevelFields{"RESPONSE", "LEVEL"};
constexpr std::array<std::string_view, 1> kUnitFields{"UNITS"};

/// The field with one of these names; empty where there is none.
std::string field_of(const std::vector<std::string>& fields,
                     std::span<const std::string_view> names) {
  const auto found = std::ranges::find_if(fields, [&](const std::string& field) {
    return std::ranges::find(names, in_capitals(field)) != names.end();
  });
  return found == fields.end() ? std::string() : *found;
}

/// Three units of a text.
std::vector<std::string> split_units(const std::string& text, const std::string& place) {
  constexpr std::size_t kUnits = 3;
  std::vector<std::string> units = listed_units(text);
  if (units.size() == kUnits) return units;
  throw InputError(place, in_quotes(text),
                   "must be units of frequency, frequency response and response between commas",
                   "\"Hz, g/N, g\", for instance.");
}

/// A unit of a motion, and its rate.
std::pair<Unit, int> motion_unit(const std::string& text, const std::string& place) {
  for (const Dimension& dimension : {kAcceleration, kVelocity, kLength}) {
    try {
      return {parse_unit(text, dimension), *rate_of(dimension)};
    } catch (const InputError&) {  // the next
    }
  }
  throw InputError(place, in_quotes(text), "must be of an acceleration, velocity or displacement",
                   "m/s^2, g, mm/s or um, for instance.");
}

}  // namespace

bool is_over_frequency(std::string_view head) {
  constexpr std::size_t kLinesBefore = 7;  // of a dataset 58, above that of its abscissa
  std::string_view above;
  while (!head.empty()) {
    const std::string_view line = trimmed(take_dos_line(head));
    if (above == "-1" && (line == "58" || line.starts_with("58b "))) {
      for (std::size_t i = 0; i < kLinesBefore; ++i) (void)take_line(head);
      return trimmed(take_dos_line(head)).starts_with("18 ");
    }
    above = line;
  }
  return false;
}

std::vector<SteppedSine> response_sweeps(const Recordings& recordings, const std::string& name) {
  std::vector<SteppedSine> sweeps;
  for (const Recording& recording : recordings.recordings) {
    if (recording.axis.dimension != kFrequency) continue;
    std::ranges::move(sweeps_of(recording), std::back_inserter(sweeps));
  }
  if (!sweeps.empty()) return sweeps;
  throw InputError(name, "no recording over frequency", "must have a sweep at least");
}

bool has_response_fields(const std::vector<std::string>& fields) {
  return !field_of(fields, kFrequencyFields).empty() &&
         !field_of(fields, kTransferFields).empty() && !field_of(fields, kLevelFields).empty();
}

SteppedSine read_response_sweep(const MatVariable& file, const std::string& variable,
                                const std::vector<std::string>& fields) {
  const auto path = [&](const auto& names) {
    return fmt::format("{}.{}", variable, field_of(fields, names));
  };
  std::vector<std::string> units{"Hz", "m/s^2/N", "m/s^2"};
  const std::string place = fmt::format("{}: {}", file.path(), variable);
  if (!field_of(fields, kUnitFields).empty()) {
    units = split_units(file.text(path(kUnitFields)), place + ".units");
  }
  const std::size_t per = std::min(units[1].rfind('/'), units[1].size());
  const auto [motion, transfer_rate] = motion_unit(units[1].substr(0, per), place + ".units");
  const Unit force = parse_unit(per < units[1].size() ? units[1].substr(per + 1) : "", kForce);
  const auto [level_unit, level_rate] = motion_unit(units[2], place + ".units");
  const Unit frequency_unit = parse_unit(units[0], kFrequency);

  ResponseSweep sweep{.source = fmt::format("{}:{}", file.path(), variable),
                      .frequency = file.numbers(path(kFrequencyFields)),
                      .transfer = {},
                      .transfer_rate = transfer_rate,
                      .level = {},
                      .level_rate = level_rate};
  const MatArray transfer = file.array(path(kTransferFields));
  const MatArray level = file.array(path(kLevelFields));
  sweep.transfer = complex_values(transfer.real, transfer.imaginary);
  sweep.level = magnitudes(complex_values(level.real, level.imaginary));
  if (sweep.transfer.size() != sweep.frequency.size() ||
      sweep.level.size() != sweep.frequency.size()) {
    throw InputError(place,
                     fmt::format("{} frequencies, {} frequency responses and {} responses",
                                 sweep.frequency.size(), sweep.transfer.size(), sweep.level.size()),
                     "must have as many of each");
  }
  for (double& value : sweep.frequency) value = frequency_unit.to_si(value);
  for (Complex& value : sweep.transfer) value *= motion.to_si(1.0) / force.to_si(1.0);
  for (double& value : sweep.level) value = level_unit.to_si(value);
  return stepped_sine_of(sweep);
}

}  // namespace microslip
