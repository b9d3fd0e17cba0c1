// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "microslip/io/uff/uff58.hpp"

namespace microslip {
namespace {

constexpr std::array<std::size_t, 1> kSingle{13};
constexpr std::array<std::size_t, 1> kDouble{20};
constexpr std::array<std::size_t, 2> kUnevenReal{13, 20};
constexpr std::array<std::size_t, 3> kUnevenComplex{13, 20, 20};

/// The fields of a line of values: 6E13.5, 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
std::span<const std::size_t> field_widths(const Uff58Header& header) {
  if (!header.is_double) return kSingle;
  if (header.even) return kDouble;
  if (header.is_complex) return kUnevenComplex;
  return kUnevenReal;
}

/// Deals the values out to x, real and imaginary parts in turn.
class Dealer {
 public:
  explicit Dealer(Uff58& data) {
    if (!data.header.even) targets_[count_++] = &data.x;
    targets_[count_++] = &data.values;
    if (data.header.is_complex) targets_[count_++] = &data.imaginary;
  }

  void reserve(std::size_t points) {
    for (std::size_t i = 0; i < count_; ++i) targets_[i]->reserve(points);
  }

  void deal(std::span<const double> values) {
    if (count_ == 1) {
      targets_[0]->insert(targets_[0]->end(), values.begin(), values.end());
      return;
    }
    for (const double value : values) {
      targets_[next_]->push_back(value);
      next_ = next_ + 1 == count_ ? 0 : next_ + 1;
    }
  }

 private:
  std::array<std::vector<double>*, 3> targets_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

}  // namespace

void read_uff58_text_values(UffEnvelope& envelope, Uff58& data, std::vector<Warning>& warnings) {
  UffInput& input = envelope.input();
  const std::span<const std::size_t> widths = field_widths(data.header);
  const std::size_t per_point = data.header.values_per_point();
  // A value takes two bytes at least, whatever the header announces.
  const std::size_t possible = input.remaining() / 2 + 1;
  const bool can_be_whole = data.header.points <= possible / per_point;
  std::size_t missing = can_be_whole ? data.header.points * per_point : possible;
  Dealer dealer(data);
  if (can_be_whole) dealer.reserve(data.header.points);

  std::vector<double> numbers;
  while (missing > 0) {
    const std::optional<std::string_view> line = envelope.value_line();
    if (!line) return;
    numbers.clear();
    append_uff_numbers(*line, widths, input.line_was_whole(), input.place(), numbers);
    const std::size_t used = std::min(missing, numbers.size());
    dealer.deal(std::span(numbers).first(used));
    missing -= used;
    const auto surplus = std::span(numbers).subspan(used);
    if (std::any_of(surplus.begin(), surplus.end(), [](double v) { return v != 0.0; })) {
      warnings.push_back(
          {"uff_extra_values", fmt::format("{}: {} values after the announced ones are not read",
                                           envelope.dataset_name(), surplus.size())});
    }
  }
}

}  // namespace microslip
