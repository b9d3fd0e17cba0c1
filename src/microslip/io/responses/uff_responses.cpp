// SPDX-License-Identifier: MIT
#include "microslip/io/responses/uff_responses.hpp"

#include <fmt/format.h>

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/responses/nodal_function.hpp"
#include "microslip/io/uff/uff164.hpp"
#include "microslip/io/uff/uff58.hpp"
#include "microslip/io/uff/uff_channel.hpp"
#include "microslip/io/uff/uff_envelope.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kResponseFunction = 4;

FrequencyResponse response_of(Uff58 data, const std::optional<Uff164>& units,
                              const std::string& dataset) {
  const UffPoint response = data.header.response;
  const UffPoint reference = data.header.reference;
  UffChannel channel = uff_channel(std::move(data), units);
  const NodalFunction function{
      .name = dataset,
      .response = response,
      .reference = reference,
      .axis = channel.axis,
      .dimension = channel.dimension,
      .values = channel.values,
      .imaginary = channel.imaginary,
      .unit_rule = "must have unit labels, or dataset 164 must precede it",
      .unit_remedy = "Export it with units, or give length_unit and force_unit."};
  if (channel.doubtful) {
    throw InputError(function.full_name(), "in g beside a factor of 0.10197",
                     "may be in m/s^2 already, the file is ambiguous", "Export it in m/s^2.");
  }
  return frequency_response(function);
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
