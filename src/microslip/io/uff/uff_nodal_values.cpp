// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_nodal_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

constexpr std::array<std::size_t, 1> kNodalWidth{13};

}  // namespace

std::vector<double> read_uff_numbers(UffEnvelope& envelope, std::size_t count,
                                     std::string_view what) {
  std::vector<double> numbers;
  while (numbers.size() < count) {
    const std::string_view line = envelope.line(what);
    append_uff_numbers(line, kNodalWidth, envelope.input().line_was_whole(),
                       envelope.input().place(), numbers);
  }
  const auto bad = std::find_if_not(numbers.begin(), numbers.end(),
                                    [](double value) { return std::isfinite(value); });
  if (bad != numbers.end()) {
    throw FormatError(envelope.input().place(), fmt::format("finite numbers as {}", what),
                      fmt::format("{}", *bad));
  }
  numbers.resize(count);
  return numbers;
}

std::size_t read_uff_count(UffFields& fields, std::int64_t largest, std::string_view what,
                           const TextPlace& place) {
  const std::int64_t count = fields.integer(10, what);
  if (count >= 0 && count <= largest) return static_cast<std::size_t>(count);
  throw FormatError(place, fmt::format("{} from 0 to {}", what, largest), fmt::format("{}", count));
}

void read_uff_nodes(UffEnvelope& envelope, bool is_complex, UffModeShape& shape) {
  const std::size_t count = shape.values_per_node * (is_complex ? 2 : 1);
  while (const auto line = envelope.value_line()) {
    if (trimmed(*line).empty()) continue;
    shape.nodes.push_back(UffFields(*line, envelope.input().place()).integer(10, "a node number"));
    const std::vector<double> numbers = read_uff_numbers(envelope, count, "values of a node");
    for (std::size_t i = 0; i < count; ++i) {
      (is_complex && i % 2 == 1 ? shape.imaginary : shape.values).push_back(numbers[i]);
    }
  }
}

void set_uff_eigenvalue(std::complex<double> eigenvalue, UffModeShape& shape) {
  shape.analysis = UffAnalysis::kComplexMode;
  const double size = std::hypot(eigenvalue.real(), eigenvalue.imag());
  shape.frequency = size / (2.0 * std::numbers::pi);
  shape.eigenvalue = eigenvalue;
  if (size > 0.0) shape.damping_ratio = -eigenvalue.real() / size;
}

}  // namespace microslip
