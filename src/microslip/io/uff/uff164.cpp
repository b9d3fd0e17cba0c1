// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff164.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {

Uff164 read_uff164(UffEnvelope& envelope) {
  static constexpr std::array<std::size_t, 1> kWidth{25};
  Uff164 units;
  UffFields fields = envelope.fields("the code of the units");
  units.code = fields.integer(10, "the code of the units");
  units.description = fields.text(20);
  std::vector<double> factors;
  const std::string_view line = envelope.line("the factors of the units");
  const TextPlace place = envelope.input().place();
  append_uff_numbers(line, kWidth, envelope.input().line_was_whole(), place, factors);
  if (factors.size() < 2) {
    throw FormatError(place, "the factors of length and force in dataset 164",
                      fmt::format("{} numbers", factors.size()));
  }
  for (const double factor : std::span(factors).first(2)) {
    if (factor > 0.0 && std::isfinite(factor) && std::isfinite(1.0 / factor)) continue;
    throw FormatError(place, "a factor of units above 0 and finite", fmt::format("{}", factor));
  }
  units.length = factors[0];
  units.force = factors[1];
  return units;
}

std::string format_uff164_si() {
  std::string text = uff_padded("    -1", 80) + '\n' + uff_padded("   164", 80) + '\n';
  text += uff_padded(fmt::format("{:10d}{:<20}{:10d}", 1, "SI: m, N", 2), 80) + '\n';
  constexpr std::string_view kOne = "  1.00000000000000000D+00";
  constexpr std::string_view kZero = "  0.00000000000000000D+00";
  text += uff_padded(fmt::format("{}{}{}", kOne, kOne, kOne), 80) + '\n';
  text += uff_padded(kZero, 80) + '\n' + uff_padded("    -1", 80) + '\n';
  return text;
}

}  // namespace microslip
