// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/result_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "microslip/base/units.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip {

std::vector<ChannelMisfit> comparisons_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  const std::vector<std::string> source = table.text("source");
  const std::vector<std::string> channel = table.text("channel");
  const std::vector<std::string> status = table.text("status");
  const auto numbers = [&](std::string_view name, const Dimension& dimension) {
    return table.numbers(name, dimension);
  };
  const std::vector<double> frequency = numbers("frequency", kFrequency);
  const std::vector<double> response = numbers("response_amplitude", kAcceleration);
  const std::vector<double> nrmse = numbers("NRMSE", kDimensionless);
  const std::vector<double> noise = numbers("noise_share", kDimensionless);
  const std::vector<double> ratio = numbers("amplitude_ratio", kDimensionless);
  const std::vector<double> phase = numbers("phase_error", kAngle);
  const std::vector<std::string> flags =
      table.has("flags") ? table.text("flags") : std::vector<std::string>(source.size());
  std::vector<ChannelMisfit> rows;
  for (std::size_t i = 0; i < source.size(); ++i) {
    rows.push_back({source[i], channel[i], status[i], frequency[i], response[i], nrmse[i], noise[i],
                    ratio[i], phase[i], flags[i]});
  }
  return rows;
}

std::vector<ForceControlLevel> force_control_of(const NamedInput& input) {
  const CsvTable table(input.text, input.path);
  const std::vector<std::string> level = table.text("level");
  const std::vector<double> response = table.numbers("response_amplitude", kAcceleration);
  std::vector<ForceControlLevel> rows;
  for (std::size_t i = 0; i < level.size(); ++i) {
    rows.push_back({fmt::format("{} ({:.3g} m/s²)", level[i], response[i]), response[i], {}, {}});
  }
  for (int n = 2; table.has(fmt::format("before_{}", n)); ++n) {
    const auto before = table.numbers(fmt::format("before_{}", n), kDimensionless);
    const auto after = table.numbers(fmt::format("after_{}", n), kDimensionless);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].before.push_back(before[i]);
      rows[i].after.push_back(after[i]);
    }
  }
  return rows;
}

std::optional<std::string> hash_of_input(const NamedInput& input, std::string_view name) {
  const CsvTable table(input.text, input.path);
  for (const InputHash& hash : hashes_in(table.comments())) {
    if (file_name(hash.file) == name) return hash.sha256;
  }
  return std::nullopt;
}

std::vector<std::string> hashes_in(const NamedInput& input) {
  std::vector<std::string> hashes;
  const CsvTable table(input.text, input.path);
  for (const InputHash& hash : hashes_in(table.comments())) hashes.push_back(hash.sha256);
  return hashes;
}

bool is_density_of(const DensityTable& table, const Joint& joint) {
  constexpr double kBelow = 1.0 - 1e-9;
  constexpr double kRounding = 1e-6;  // of the largest: digits that a table may leave out
  const double largest = std::ranges::max(table.density);
  const std::vector<double>& f = table.slip_force;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const bool step = (i > 0 && f[i - 1] == f[i]) || (i + 1 < f.size() && f[i + 1] == f[i]);
    if (step || f[i] == 0.0) continue;  // φ may be infinite at 0
    const double expected = joint.density().density(kBelow * f[i]);
    if (!(std::abs(table.density[i] - expected) <= kRounding * largest)) return false;
  }
  return true;
}

}  // namespace microslip
