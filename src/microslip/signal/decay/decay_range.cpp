// SPDX-License-Identifier: MIT
#include "microslip/signal/decay/decay_range.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "microslip/signal/decay/tapered_transform.hpp"

namespace microslip {
namespace {

/// Number of times the signal stays at a value for three samples.
int stays_at(std::span<const double> signal, double value) {
  constexpr std::size_t kShortest = 3;
  int stays = 0;
  std::size_t run = 0;
  for (const double y : signal) {
    run = y == value ? run + 1 : 0;
    if (run == kShortest) ++stays;
  }
  return stays;
}

}  // namespace

std::optional<double> find_blow(std::span<const double> signal, double rate) {
  constexpr double kRise = 0.1;       // of the largest value
  constexpr double kQuiet = 0.02;     // of the largest value
  constexpr std::size_t kFewest = 8;  // samples before it
  double largest = 0.0;
  for (const double y : signal) largest = std::max(largest, std::abs(y));
  if (!(largest > 0.0)) return std::nullopt;
  const auto rises = [&](double y) { return std::abs(y) >= kRise * largest; };
  const auto blow = std::ranges::find_if(signal, rises);
  const auto before = static_cast<std::size_t>(blow - signal.begin());
  if (before < kFewest) return std::nullopt;
  double squares = 0.0;
  for (const double y : signal.first(before)) squares += y * y;
  if (squares > static_cast<double>(before) * kQuiet * kQuiet * largest * largest) {
    return std::nullopt;
  }
  return static_cast<double>(before) / rate;
}

double start_of_decay(std::span<const double> signal, double rate, double frequency, double length,
                      double margin) {
  constexpr double kHeld = 0.95;
  constexpr double kHop = 0.25;  // of the length
  const double duration = static_cast<double>(signal.size()) / rate;
  std::vector<double> amplitude;
  for (double centre = length / 2.0; centre + length / 2.0 < duration; centre += kHop * length) {
    const TaperedWindow window(signal, rate, centre, length);
    amplitude.push_back(std::abs(window.transform(2.0 * std::numbers::pi * frequency)));
  }
  if (amplitude.empty()) return 0.0;
  const auto largest = std::ranges::max_element(amplitude);
  if (*largest <= (1.0 + margin) * amplitude.front()) return 0.0;
  const double most = *largest;
  auto last = largest;
  for (auto it = largest; it != amplitude.end(); ++it) {
    if (*it >= kHeld * most) last = it;
  }
  return (0.5 + kHop * static_cast<double>(last - amplitude.begin())) * length;
}

bool looks_clipped(std::span<const double> signal) {
  constexpr int kOften = 3;
  if (signal.empty()) return false;
  const auto [least, most] = std::ranges::minmax_element(signal);
  if (*least == *most) return false;
  return stays_at(signal, *least) >= kOften || stays_at(signal, *most) >= kOften;
}

}  // namespace microslip
