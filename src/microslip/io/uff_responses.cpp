// SPDX-License-Identifier: MIT
#include "microslip/io/uff_responses.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/uff164.hpp"
#include "microslip/io/uff58.hpp"
#include "microslip/io/uff_channel.hpp"
#include "microslip/io/uff_envelope.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kResponseFunction = 4;
constexpr std::int64_t kFreedoms = static_cast<std::int64_t>(kNodalDirections);

DegreeOfFreedom freedom_of(const UffPoint& point, std::string_view what, const std::string& name) {
  const std::int64_t direction = std::abs(point.direction);
  if (point.node >= 1 && direction >= 1 && direction <= kFreedoms) {
    return {point.node, static_cast<NodalDirection>(direction - 1)};
  }
  throw InputError(fmt::format("{} of {}", what, name),
                   fmt::format("node {}, direction {}", point.node, point.direction),
                   "must have a node, 1 or more, and a direction, 1 to 6 or -1 to -6");
}

std::string freedom_text(const DegreeOfFreedom& freedom) {
  return fmt::format("node {} {}", freedom.node,
                     kNodalDirectionNames[static_cast<std::size_t>(freedom.direction)]);
}

bool is_turn(const DegreeOfFreedom& freedom) { return freedom.direction >= NodalDirection::kTurnX; }

/// How often the motion is differentiated; the radian may be written or not.
int derivatives_of(const FrequencyResponse& response, const std::optional<Dimension>& found) {
  if (!found) {
    throw InputError(response.name, "without unit",
                     "must have labels of its units, or dataset 164 must be before it",
                     "Export it with units, or give length_unit and force_unit.");
  }
  const Dimension motion = is_turn(response.response) ? kDimensionless : kLength;
  const Dimension force = is_turn(response.reference) ? kEnergy : kForce;
  Dimension rest = *found * force / motion;
  rest.angle = 0;
  for (const int derivatives : {0, 1, 2}) {
    if (rest == kTime.power(-derivatives)) return derivatives;
  }
  throw InputError(response.name, fmt::format("in {}", si_unit(*found)),
                   "must be a displacement, velocity or acceleration over a force");
}

void check_content(const FrequencyResponse& response) {
  const std::vector<double>& frequency = response.frequency;
  if (frequency.size() < 2) {
    throw InputError(response.name, fmt::format("{} lines above 0 Hz", frequency.size()),
                     "must have two at least");
  }
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    if (!std::isfinite(response.values[i].real()) || !std::isfinite(response.values[i].imag())) {
      throw InputError(fmt::format("{} at {:.6g} Hz", response.name, frequency[i]),
                       "not a number, or infinite", "must be finite");
    }
    if (i > 0 && !(frequency[i] > frequency[i - 1])) {
      throw InputError(response.name,
                       fmt::format("{:.6g} Hz behind {:.6g} Hz", frequency[i], frequency[i - 1]),
                       "must rise in frequency");
    }
  }
}

FrequencyResponse response_of(Uff58 data, const std::optional<Uff164>& units,
                              const std::string& dataset) {
  FrequencyResponse response{.name = dataset, .response = {}, .reference = {}};
  const Uff58Header& header = data.header;
  response.response = freedom_of(header.response, "response", dataset);
  response.reference = freedom_of(header.reference, "reference", dataset);
  response.name = fmt::format("{} ({} by a force at {})", dataset, freedom_text(response.response),
                              freedom_text(response.reference));
  if (!header.is_complex) {
    throw InputError(response.name, "real", "must be complex: a response has a phase");
  }
  const bool backwards = (header.response.direction < 0) != (header.reference.direction < 0);
  const UffChannel channel = uff_channel(std::move(data), units);
  if (channel.doubtful) {
    throw InputError(response.name, "in g beside a factor of 0.10197",
                     "may be in m/s^2 already, which the file does not tell",
                     "Export it in m/s^2.");
  }
  if (channel.axis.dimension != kFrequency) {
    throw InputError(response.name, fmt::format("over {}", dimension_name(channel.axis.dimension)),
                     "must be over frequency");
  }
  response.derivatives = derivatives_of(response, channel.dimension);
  for (std::size_t i = 0; i < channel.values.size(); ++i) {
    const double frequency = channel.axis.at(i);
    if (!(frequency > 0.0)) continue;
    const std::complex<double> value(channel.values[i], channel.imaginary[i]);
    response.frequency.push_back(frequency);
    response.values.push_back(backwards ? -value : value);
  }
  check_content(response);
  return response;
}

std::optional<Uff164> system_of(const std::optional<UnitSystem>& units) {
  if (!units) return std::nullopt;
  Uff164 system;
  system.length = 1.0 / units->length;
  system.force = 1.0 / units->force;
  return system;
}

}  // namespace

FrequencyResponses read_responses_uff(const std::string& path,
                                      const std::optional<UnitSystem>& otherwise) {
  UffInput input(path);
  UffEnvelope envelope(input);
  FrequencyResponses result;
  const std::optional<Uff164> usual = system_of(otherwise);
  std::optional<Uff164> units = usual;
  std::size_t functions = 0;
  while (const auto dataset = envelope.next()) {
    if (dataset->number == 58) {
      ++functions;
      const std::string name = envelope.dataset_name();
      Uff58 data = read_uff58(envelope, *dataset, false, result.warnings);
      if (data.header.function_type != kResponseFunction) continue;
      result.responses.push_back(response_of(std::move(data), units, name));
      continue;
    }
    const bool joined = dataset->number == 151 && functions > 0;
    if (joined) units = usual;  // files are joined by putting one behind the other
    if (dataset->number == 164) units = read_uff164(envelope);
    envelope.close();
  }
  if (!result.responses.empty()) return result;
  throw FormatError({.file = input.name()},
                    "a frequency response (dataset 58 or 58b of function type 4)",
                    fmt::format("{} functions of other types", functions));
}

}  // namespace microslip
