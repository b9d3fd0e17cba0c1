// SPDX-License-Identifier: MIT
#include "microslip/io/output/provenance.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "microslip/base/version.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/io/cells/comment_entry.hpp"
#include "microslip/io/cells/warning_comment.hpp"

namespace microslip {
namespace {

constexpr std::string_view kHashKey = "sha256";
constexpr std::string_view kFormerMark = ": sha256 ";

/// An input as earlier versions named it: "FILE: sha256 …".
std::optional<InputHash> former_hash(const std::string& comment) {
  const std::size_t mark = comment.rfind(kFormerMark);
  if (mark == std::string::npos) return std::nullopt;
  return InputHash{comment.substr(0, mark), comment.substr(mark + kFormerMark.size())};
}

}  // namespace

std::string hash_comment(std::string_view file, std::string_view sha256) {
  return comment_entry(kHashKey, file, sha256);
}

std::vector<InputHash> hashes_in(std::span<const std::string> comments) {
  std::vector<InputHash> inputs;
  for (const std::string& comment : comments) {
    if (auto entry = parse_comment_entry(comment)) {
      if (entry->key == kHashKey) inputs.push_back({entry->subject, entry->value});
    } else if (auto former = former_hash(comment)) {
      inputs.push_back(*std::move(former));
    }
  }
  return inputs;
}

std::string heading_of(std::string_view command) {
  return fmt::format("microslip {}: {}", kVersion, command);
}

std::string provenance_of(std::string_view command, const std::vector<NamedInput>& inputs) {
  std::string text = heading_of(command);
  for (const NamedInput& input : inputs) {
    text += '\n' + hash_comment(input_name(input.path), sha256(input.text));
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
