// SPDX-License-Identifier: MIT
#include "microslip/workflow/reduce/decay_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include "microslip/base/codes.hpp"

namespace microslip {

std::string codes_of_decay(const std::vector<Warning>& warnings) {
  std::string codes;
  for (const Warning& warning : warnings) {
    constexpr std::string_view kOfLevels[] = {"beats",          "clipped",     "neighbour_leaks",
                                              "sensors_differ", "shape_moves", "steady_tone"};
    if (std::ranges::find(kOfLevels, warning.code) != std::end(kOfLevels)) continue;
    add_code(codes, warning.code);
  }
  return codes;
}

std::string decay_start_text(const RingDown& decay) {
  std::string text = fmt::format("{:.5g} s, ", decay.start);
  switch (decay.start_by) {
    case DecayStart::kGiven:
      return text + "given";
    case DecayStart::kRecord:
      return text + "the beginning of the record: it contains no impact";
    case DecayStart::kBlow:
      return text + fmt::format("1.5 periods after the impact at {:.5g} s", *decay.blow);
    case DecayStart::kFall:
      break;
  }
  return text + "where the mode begins to decay";
}

std::string decay_band_text(const RingDown& decay, bool given) {
  return fmt::format("{:.6g}:{:.6g} Hz, {}", decay.band.first, decay.band.second,
                     given ? "given" : "by the neighbouring modes and the damping");
}

std::string decay_sensors_text(const RingDown& decay) {
  std::string text;
  for (const RingDownSensor& sensor : decay.sensors) {
    text += (text.empty() ? "" : ", ") + sensor.name;
    if (&sensor == &decay.sensors.front()) continue;
    text += fmt::format(" ({:.4g} of its amplitude, {:.2g} % apart over the decay)", sensor.ratio,
                        100.0 * sensor.ratio_range);
  }
  return text;
}

}  // namespace microslip
