// SPDX-License-Identifier: MIT
#include "microslip/ensemble/grid_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace microslip {
namespace {

constexpr std::uint64_t kMostPoints = 1'000'000;

/// A number for the bits of a row: FNV-1a over its values. That of a job that failed is 0.
std::uint64_t mark_of(std::span<const double> row) {
  constexpr std::uint64_t kBasis = 0xCBF29CE484222325U;
  constexpr std::uint64_t kPrime = 0x100000001B3U;
  if (std::ranges::all_of(row, [](double value) { return std::isnan(value); })) return 0;
  std::uint64_t mark = kBasis;
  for (const double value : row) mark = (mark ^ std::bit_cast<std::uint64_t>(value)) * kPrime;
  return std::max<std::uint64_t>(mark, 1);
}

/// Whether a value changes anywhere along one axis of a grid whose last axis runs fastest.
class AxisEffect {
 public:
  AxisEffect(const std::vector<SweepAxis>& axes, std::size_t axis, std::uint64_t points)
      : count_(axes[axis].values.size()) {
    for (std::size_t a = axis + 1; a < axes.size(); ++a) stride_ *= axes[a].values.size();
    marks_.resize(points / count_);
  }

  /// Jobs in the order of their numbers.
  void take(std::uint64_t job, std::uint64_t mark) {
    std::uint64_t& first = marks_[job / (stride_ * count_) * stride_ + job % stride_];
    if (mark == 0) return;
    if (first == 0) {
      first = mark;
      return;
    }
    ++compared_;
    changes_ = changes_ || first != mark;
  }

  [[nodiscard]] bool is_missing() const { return compared_ > 0 && !changes_; }

 private:
  std::uint64_t count_;
  std::uint64_t stride_ = 1;
  std::vector<std::uint64_t>
      marks_;  // of the first place that has one, by the places of the others
  std::uint64_t compared_ = 0;
  bool changes_ = false;
};

}  // namespace

std::vector<Warning> grid_warnings(const EnsembleResult& result,
                                   const std::function<RowPass(std::size_t group)>& rows_of) {
  std::vector<Warning> warnings;
  for (std::size_t g = 0; g < result.groups.size(); ++g) {
    const EnsembleGroup& group = result.groups[g].group;
    if (group.grid.empty() || group.jobs > kMostPoints) continue;
    std::vector<std::pair<std::size_t, AxisEffect>> effects;
    for (std::size_t a = 0; a < group.grid.size(); ++a) {
      if (group.grid[a].values.size() > 1)
        effects.emplace_back(a, AxisEffect(group.grid, a, group.jobs));
    }
    std::uint64_t job = 0;
    rows_of(g)([&](std::span<const double> row) {
      const std::uint64_t mark = mark_of(row);
      for (auto& [axis, effect] : effects) effect.take(job, mark);
      ++job;
    });
    for (const auto& [axis, effect] : effects) {
      if (!effect.is_missing()) continue;
      warnings.push_back({"axis_without_effect",
                          fmt::format("'{}' changes nothing in '{}': no prediction there depends "
                                      "on it.",
                                      group.grid[axis].number, group.name)});
    }
  }
  return warnings;
}

}  // namespace microslip
