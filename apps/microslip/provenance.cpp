// SPDX-License-Identifier: MIT
#include "provenance.hpp"

#include <fmt/format.h>

#include "microslip/io/input_file.hpp"
#include "microslip/io/sha256.hpp"
#include "microslip/io/warning_comment.hpp"
#include "prediction.hpp"

namespace microslip::app {

std::string provenance_of(const Call& call, const std::vector<NamedInput>& inputs) {
  std::string text = heading_of(call);
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

}  // namespace microslip::app
