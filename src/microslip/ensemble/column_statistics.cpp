// SPDX-License-Identifier: MIT
#include "microslip/ensemble/column_statistics.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr unsigned kAllBits = 64;
/// Columns whose order statistics are computed at once: some 100 kB each.
constexpr std::size_t kMostColumns = 2048;
constexpr std::size_t kTargets = 6;  // two of each of three quantiles

/// Whole numbers that have the order of doubles: −0 comes before 0.
std::uint64_t key_of(double value) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

double value_of(std::uint64_t key) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
  return std::bit_cast<double>((key & kSign) != 0 ? key & ~kSign : ~key);
}

/// Sums that do not depend on how many rows there are, beyond rounding of the compensated sum.
class Sum {
 public:
  void add(double value) {
    const double next = sum_ + value;
    rest_ += std::abs(sum_) >= std::abs(value) ? (sum_ - next) + value : (value - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0.0;
  double rest_ = 0.0;
};

/// One order statistic of a column: its rank among the values that share the digits found so far.
struct Selection {
  std::uint64_t key = 0;   ///< digits found, above those that are not
  std::uint64_t rank = 0;  ///< from 0
};

/// Where a quantile lies between order statistics.
struct Place {
  std::uint64_t low;
  std::uint64_t high;
  double share;
};

Place place_of(double probability, std::uint64_t count) {
  const double position = probability * static_cast<double>(count - 1);
  const auto low = static_cast<std::uint64_t>(position);
  return {low, std::min(low + 1, count - 1), position - static_cast<double>(low)};
}

using Selections = std::array<Selection, kTargets>;

/// Finds the next digit of the order statistics of some columns.
class DigitPass {
 public:
  DigitPass(std::size_t first, std::vector<Selections>& selections, unsigned shift, unsigned bits)
      : first_(first),
        selections_(selections),
        shift_(shift),
        bits_(bits),
        counts_(selections.size() * kTargets * kDigits) {}

  void take(std::span<const double> row) {
    for (std::size_t c = 0; c < selections_.size(); ++c) {
      const double value = row[first_ + c];
      if (std::isnan(value)) continue;
      const std::uint64_t key = key_of(value);
      const std::size_t digit = key >> shift_ & ((std::uint64_t{1} << bits_) - 1);
      for (std::size_t t = 0; t < kTargets; ++t) {
        if (same_above(key, selections_[c][t].key)) ++counts_[(c * kTargets + t) * kDigits + digit];
      }
    }
  }

  void choose() {
    for (std::size_t c = 0; c < selections_.size(); ++c) {
      for (std::size_t t = 0; t < kTargets; ++t) {
        Selection& selection = selections_[c][t];
        const std::uint64_t* counts = &counts_[(c * kTargets + t) * kDigits];
        std::uint64_t digit = 0;
        while (digit + 1 < kDigits && selection.rank >= counts[digit]) {
          selection.rank -= counts[digit++];
        }
        selection.key |= digit << shift_;
      }
    }
  }

 private:
  [[nodiscard]] bool same_above(std::uint64_t a, std::uint64_t b) const {
    const unsigned known = shift_ + bits_;
    return known >= kAllBits || a >> known == b >> known;
  }

  std::size_t first_;
  std::vector<Selections>& selections_;
  unsigned shift_;
  unsigned bits_;
  std::vector<std::uint64_t> counts_;
};

std::vector<ColumnStatistics> moments(const RowPass& pass, std::size_t columns) {
  std::vector<ColumnStatistics> statistics(columns,
                                           {.minimum = std::numeric_limits<double>::infinity(),
                                            .maximum = -std::numeric_limits<double>::infinity()});
  std::vector<Sum> sums(columns);
  pass([&](std::span<const double> row) {
    for (std::size_t c = 0; c < columns; ++c) {
      if (std::isnan(row[c])) continue;
      ++statistics[c].count;
      sums[c].add(row[c]);
      statistics[c].minimum = std::min(statistics[c].minimum, row[c]);
      statistics[c].maximum = std::max(statistics[c].maximum, row[c]);
    }
  });
  std::vector<Sum> squares(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    statistics[c].mean = sums[c].value() / static_cast<double>(statistics[c].count);
  }
  pass([&](std::span<const double> row) {
    for (std::size_t c = 0; c < columns; ++c) {
      if (!std::isnan(row[c])) squares[c].add(std::pow(row[c] - statistics[c].mean, 2));
    }
  });
  for (std::size_t c = 0; c < columns; ++c) {
    const auto freedom = static_cast<double>(std::max<std::uint64_t>(statistics[c].count, 2) - 1);
    statistics[c].std = std::sqrt(squares[c].value() / freedom);
  }
  return statistics;
}

void select(const RowPass& pass, std::size_t first, const std::array<double, 3>& probabilities,
            std::span<ColumnStatistics> statistics) {
  std::vector<Selections> selections(statistics.size());
  for (std::size_t c = 0; c < statistics.size(); ++c) {
    if (statistics[c].count == 0) continue;
    for (std::size_t q = 0; q < probabilities.size(); ++q) {
      const Place place = place_of(probabilities[q], statistics[c].count);
      selections[c][2 * q].rank = place.low;
      selections[c][2 * q + 1].rank = place.high;
    }
  }
  for (unsigned left = kAllBits; left > 0;) {
    const unsigned bits = std::min(kDigitBits, left);
    left -= bits;
    DigitPass digits(first, selections, left, bits);
    pass([&](std::span<const double> row) { digits.take(row); });
    digits.choose();
  }
  for (std::size_t c = 0; c < statistics.size(); ++c) {
    std::array<double, 3> quantiles{kNone, kNone, kNone};
    for (std::size_t q = 0; q < quantiles.size() && statistics[c].count > 0; ++q) {
      const Place place = place_of(probabilities[q], statistics[c].count);
      const double low = value_of(selections[c][2 * q].key);
      const double high = value_of(selections[c][2 * q + 1].key);
      quantiles[q] = low == high ? low : low + place.share * (high - low);
    }
    statistics[c].lower = quantiles[0];
    statistics[c].median = quantiles[1];
    statistics[c].upper = quantiles[2];
  }
}

}  // namespace

std::vector<ColumnStatistics> column_statistics(const RowPass& pass, std::size_t columns,
                                                double confidence) {
  std::vector<ColumnStatistics> statistics = moments(pass, columns);
  const std::array probabilities{0.5 * (1.0 - confidence), 0.5, 0.5 * (1.0 + confidence)};
  for (std::size_t first = 0; first < columns; first += kMostColumns) {
    const std::size_t count = std::min(kMostColumns, columns - first);
    select(pass, first, probabilities, std::span(statistics).subspan(first, count));
  }
  for (ColumnStatistics& column : statistics) {
    if (column.count > 0) continue;
    column.mean = column.std = column.minimum = column.maximum = kNone;
  }
  return statistics;
}

}  // namespace microslip
