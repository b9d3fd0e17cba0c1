// SPDX-License-Identifier: MIT
#include "microslip/structure/entry_rounding.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace microslip {
namespace {

constexpr std::size_t kMostLookedAt = 20'000;
/// A uniform mesh of short numbers has a dozen different entries, exact ones.
constexpr std::size_t kLeastEntries = 50;
constexpr int kFewestDigits = 6;  // of fewer, a number may well be exact
constexpr int kMostDigits = 15;   // that a double keeps
constexpr double kSingleRounding = 0x1p-24;

/// Different sizes of some entries, evenly spread, without 0.
std::vector<double> sample_of(const std::vector<double>& values) {
  const std::size_t step = values.size() / kMostLookedAt + 1;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < values.size(); i += step) {
    if (values[i] != 0.0 && std::isfinite(values[i])) sizes.push_back(std::abs(values[i]));
  }
  std::ranges::sort(sizes);
  const auto rest = std::ranges::unique(sizes);
  sizes.erase(rest.begin(), rest.end());
  return sizes;
}

/// How many decimal digits a number has, kMostDigits + 1 where it has more than a double keeps.
int digits_of(double size) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), size,
                                 std::chars_format::scientific, kMostDigits - 1);
  double back = 0.0;
  std::from_chars(text.data(), end.ptr, back);
  // A sum or a unit of a power of ten leaves some ε.
  if (std::abs(back - size) > 2.0 * std::numeric_limits<double>::epsilon() * size) {
    return kMostDigits + 1;
  }
  std::string_view mantissa(text.data(), end.ptr);
  mantissa = mantissa.substr(0, mantissa.find('e'));
  const std::size_t last = mantissa.find_last_not_of("0.");
  return last == 0 ? 1 : static_cast<int>(last);  // the point is between
}

bool is_single(double size) {
  return size <= std::numeric_limits<float>::max() &&
         static_cast<double>(static_cast<float>(size)) == size;
}

/// The rounding of entries of the given sizes where so many parts of four have all of the digits.
double rounding_of(const std::vector<double>& sizes, std::size_t quarters) {
  if (sizes.empty()) return 0.0;
  std::vector<int> digits;
  for (const double size : sizes) digits.push_back(digits_of(size));
  const int most = *std::ranges::max_element(digits);
  const auto with_all = static_cast<std::size_t>(std::ranges::count(digits, most));
  if (most > kMostDigits) return std::ranges::all_of(sizes, is_single) ? kSingleRounding : 0.0;
  if (most < kFewestDigits || 4 * with_all < quarters * digits.size()) return 0.0;
  return 5.0 * std::pow(10.0, -most);
}

}  // namespace

double entry_rounding(const SymmetricEntries& entries) {
  const std::vector<double> sizes = sample_of(entries.value);
  return sizes.size() < kLeastEntries ? 0.0 : rounding_of(sizes, 2);
}

double possible_entry_rounding(const SymmetricEntries& entries) {
  const std::vector<double> sizes = sample_of(entries.value);
  return rounding_of(sizes, sizes.size() < kLeastEntries ? 3 : 2);
}

}  // namespace microslip
