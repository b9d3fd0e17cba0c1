// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff151.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "microslip/base/version.hpp"
#include "microslip/io/uff/uff_fields.hpp"

namespace microslip {
namespace {

/// The first four records. The fourth goes on with version numbers, which are not used.
struct HeaderRecord {
  std::string_view name;
  std::size_t width;
};
constexpr std::array<HeaderRecord, 4> kHeaderRecords{
    {{"model name", 80}, {"model description", 80}, {"creating program", 80}, {"created", 20}}};

std::string text_of(const Attributes& attributes, std::string_view name) {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const auto& a) { return a.first == name; });
  return found == attributes.end() ? "NONE" : found->second;
}

}  // namespace

Attributes read_uff151(UffEnvelope& envelope) {
  Attributes attributes;
  for (const HeaderRecord& record : kHeaderRecords) {
    const auto line = envelope.value_line();
    if (!line) break;
    std::string text = UffFields(*line, envelope.input().place()).text(record.width);
    if (!text.empty()) attributes.emplace_back(record.name, std::move(text));
  }
  return attributes;
}

std::string format_uff151(const Attributes& attributes) {
  const auto line = [](std::string_view text) { return uff_padded(text, 80) + '\n'; };
  std::string text = line("    -1") + line("   151");
  for (std::size_t i = 0; i < 3; ++i) text += line(text_of(attributes, kHeaderRecords[i].name));
  text += line(uff_padded(text_of(attributes, kHeaderRecords[3].name), kHeaderRecords[3].width) +
               fmt::format("{:10d}{:10d}{:10d}", 0, 0, 0));
  text += line("NONE") + line(fmt::format("microslip {}", kVersion)) + line("NONE");
  return text + line("    -1");
}

}  // namespace microslip
