// SPDX-License-Identifier: MIT
#include "microslip/documents/study/ensemble_result_file.hpp"

#include <algorithm>

namespace microslip {

std::size_t EnsembleGroup::width() const {
  std::size_t sum = 0;
  for (const EnsembleOutput& output : outputs) sum += output.size();
  return sum;
}

std::uint64_t EnsembleResult::jobs() const {
  std::uint64_t sum = 0;
  for (const GroupResult& group : groups) sum += group.group.jobs;
  return sum;
}

std::uint64_t EnsembleResult::failed() const {
  std::uint64_t sum = 0;
  for (const GroupResult& group : groups) sum += group.failed.count;
  return sum;
}

bool EnsembleResult::keeps(const EnsembleOutput& output) const {
  return std::ranges::any_of(
      raw, [&](const std::string& name) { return name == "*" || name == output.name; });
}

}  // namespace microslip
