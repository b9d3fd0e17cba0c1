// SPDX-License-Identifier: MIT
#include "microslip/io/uff/uff_envelope.hpp"

#include <fmt/format.h>

#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

bool is_blank(std::string_view line) {
  return line.find_first_not_of(' ') == std::string_view::npos;
}

/// Text between datasets, which the format allows. Numbers are not: a dataset that ended too early
/// leaves them.
bool is_remark(std::string_view line) {
  if (line.size() > 200 || printable(line) != line) return false;
  while (!line.empty()) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find(' '));
    if (word.find_first_not_of("0123456789+-.eEdD") != std::string_view::npos) return true;
    line.remove_prefix(word.size());
  }
  return false;
}

}  // namespace

bool is_uff_marker(std::string_view line) {
  constexpr std::string_view kMarker = "    -1";
  return line.starts_with(kMarker) && is_blank(line.substr(kMarker.size()));
}

std::optional<UffDataset> UffEnvelope::next() {
  std::optional<std::string_view> line = input_.line();
  while (line && (is_blank(*line) || (ordinal_ > 0 && is_remark(*line)))) line = input_.line();
  if (!line) return std::nullopt;
  if (!is_uff_marker(*line)) {
    const std::string_view expected =
        ordinal_ == 0 ? "a universal file, which begins with the line '    -1'"
                      : "the line '    -1' that opens a dataset, or the end of the file";
    throw FormatError(input_.place(1), expected, in_quotes(*line));
  }
  closed_ = false;
  UffDataset dataset{.ordinal = ++ordinal_, .id_line = {}};
  dataset.id_line = std::string(this->line("the number of the dataset"));
  UffFields fields(dataset.id_line, input_.place());
  dataset.number = static_cast<int>(fields.integer(6, "the number of the dataset"));
  dataset.binary = fields.text(1) == "b";
  return dataset;
}

std::string_view UffEnvelope::line(std::string_view what) {
  const std::optional<std::string_view> line = value_line();
  if (line) return *line;
  throw UffTruncated(input_.place(), fmt::format("{} of {}", what, dataset_name()),
                     closed_ ? "the line '    -1' that closes it" : "the end of the file");
}

UffFields UffEnvelope::fields(std::string_view what) {
  const std::string_view text = line(what);
  return {text, input_.place()};
}

std::optional<std::string_view> UffEnvelope::value_line() {
  if (closed_) return std::nullopt;
  const std::optional<std::string_view> line = input_.line();
  closed_ = line && is_uff_marker(*line);
  return closed_ ? std::nullopt : line;
}

UffEnvelope::Rest UffEnvelope::close() {
  Rest rest;
  while (const auto line = value_line()) {
    if (!is_blank(*line)) ++rest.lines;
  }
  rest.closed = closed_;
  closed_ = true;
  return rest;
}

std::string UffEnvelope::dataset_name() const { return fmt::format("dataset {}", ordinal_); }

}  // namespace microslip
