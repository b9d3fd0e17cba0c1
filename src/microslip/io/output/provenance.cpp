// SPDX-License-Identifier: MIT
#include "microslip/io/output/provenance.hpp"

#include <fmt/format.h>

#include "microslip/base/version.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/cells/warning_comment.hpp"

namespace microslip {

std::string heading_of(std::string_view command) {
  return fmt::format("microslip {}: {}", kVersion, command);
}

std::string provenance_of(std::string_view command, const std::vector<NamedInput>& inputs) {
  std::string text = heading_of(command);
  for (const NamedInput& input : inputs) {
    text += fmt::format("\n{}: sha256 {}", input_name(input.path), sha256(input.text));
  }
  return text;
}

std::string warning_lines(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) {
    text += (text.empty() ? "" : "\n") + warning_comment(warning);
  }
  return text;
}

std::string with_warnings(std::string comment, const std::vector<Warning>& warnings) {
  const std::string lines = warning_lines(warnings);
  if (!lines.empty()) comment += (comment.empty() ? "" : "\n") + lines;
  return comment;
}

void add_warnings(const std::vector<Warning>& warnings, CsvWriter& table) {
  if (!warnings.empty()) table.add_comment(warning_lines(warnings));
}

}  // namespace microslip
