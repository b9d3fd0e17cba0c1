// SPDX-License-Identifier: MIT
#include "microslip/identify/evidence/joint_evidence.hpp"

#include <fmt/format.h>

namespace microslip {
namespace {

std::string name_or_number(const std::vector<std::string>& names, std::string_view noun,
                           std::size_t index) {
  return index < names.size() ? names[index] : fmt::format("{} {}", noun, index + 1);
}

}  // namespace

std::string JointEvidence::name_of_record(std::size_t record) const {
  return name_or_number(record_names, "record", record);
}

std::string JointEvidence::name_of_levels(std::size_t table) const {
  return name_or_number(level_names, "levels", table);
}

}  // namespace microslip
