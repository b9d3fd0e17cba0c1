// SPDX-License-Identifier: MIT
#include "microslip/signal/shock/log_log_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

constexpr double kLargestValue = 1e30;

}  // namespace

void check_log_log_line(std::string_view what, std::string_view of,
                        std::span<const double> frequency, std::span<const double> value) {
  if (frequency.size() < 2 || value.size() != frequency.size()) {
    throw InputError(fmt::format("points of {}", what), static_cast<double>(frequency.size()),
                     fmt::format("must be at least 2, with a {} each", of));
  }
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const bool rises = i == 0 ? frequency[i] > 0.0 : frequency[i] > frequency[i - 1];
    if (!(std::isfinite(frequency[i]) && rises)) {
      throw InputError(fmt::format("frequency[{}] of {}", i, what), frequency[i],
                       "must be above 0 and above the previous one");
    }
    if (value[i] > 0.0 && value[i] <= kLargestValue) continue;
    throw InputError(fmt::format("{}[{}] of {}", of, i, what), value[i],
                     fmt::format("must be above 0, to {:g}", kLargestValue));
  }
}

double log_log_value(std::span<const double> frequency, std::span<const double> value, double f) {
  if (!(f >= frequency.front() && f <= frequency.back())) return 0.0;
  const auto next = std::ranges::upper_bound(frequency, f);
  const auto k = std::min(static_cast<std::size_t>(next - frequency.begin()), frequency.size() - 1);
  const double slope =
      std::log(value[k] / value[k - 1]) / std::log(frequency[k] / frequency[k - 1]);
  return value[k - 1] * std::pow(f / frequency[k - 1], slope);
}

}  // namespace microslip
