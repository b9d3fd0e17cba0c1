// SPDX-License-Identifier: MIT
#include "microslip/ensemble/ensemble_journals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"

namespace microslip {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) lines.emplace_back(take_line(text));
  return lines;
}

/// "predict.draws = 100" without its value.
std::string key_of_line(const std::string& line) { return line.substr(0, line.find(" = ")); }

/// The first line that differs, in words.
std::string difference(const std::string& old_heading, const std::string& new_heading) {
  const std::vector<std::string> old_lines = lines_of(old_heading);
  const std::vector<std::string> new_lines = lines_of(new_heading);
  for (const std::string& now : new_lines) {
    if (std::ranges::find(old_lines, now) != old_lines.end()) continue;
    const auto before = std::ranges::find(old_lines, key_of_line(now), key_of_line);
    if (before == old_lines.end()) return fmt::format("{} is new", now);
    return fmt::format("{}, it was {}", now, before->substr(key_of_line(now).size() + 3));
  }
  for (const std::string& before : old_lines) {
    if (std::ranges::find(new_lines, before) == new_lines.end()) {
      return fmt::format("{} was removed", before);
    }
  }
  return "the order of its inputs";
}

}  // namespace

EnsembleJournals::EnsembleJournals(const std::string& out, const std::string& heading,
                                   const std::vector<EnsembleGroup>& groups,
                                   const BlockLayout& layout)
    : out_(out), groups_(groups), layout_(layout), places_(layout.size()) {
  for (const std::string& path : journals_beside(out)) {
    JournalReader journal(path);
    if (journal.heading() != heading) {
      throw InputError(fmt::format("{}: inputs", path),
                       in_quotes(difference(journal.heading(), heading), 300),
                       "must be those of this run",
                       "Undo the change to continue, or remove the journal to start again.");
    }
    for (const JournalBlock& block : journal.blocks()) {
      if (block.number >= places_.size()) continue;
      places_[block.number] = {static_cast<std::uint32_t>(journals_.size()), block};
    }
    journals_.push_back(std::move(journal));
  }
}

std::vector<JobResult> EnsembleJournals::results(std::uint64_t block) const {
  const Place& place = places_[block];
  if (!has(block)) {
    throw FileError(out_, "lost its journal during the run",
                    "Another run may have finished it: check whether the result is there.");
  }
  const JobRange range = layout_.jobs_of(block);
  const JournalReader& journal = journals_[place.journal];
  auto results =
      block_results(journal.content(place.block), range.count, groups_[range.group].width());
  if (results) return *std::move(results);
  throw FormatError({.file = journal.path()}, "the results of a block", "something else",
                    "Remove the journal to start again.");
}

std::vector<std::string> EnsembleJournals::paths() const {
  std::vector<std::string> paths;
  for (const JournalReader& journal : journals_) paths.push_back(journal.path());
  return paths;
}

RowPass EnsembleJournals::rows_of(std::size_t group) const {
  return [this, group](const std::function<void(std::span<const double> row)>& take) {
    const std::vector<double> none(groups_[group].width(),
                                   std::numeric_limits<double>::quiet_NaN());
    const auto [first, end] = layout_.blocks_of(group);
    for (std::uint64_t block = first; block < end; ++block) {
      for (const JobResult& result : results(block)) {
        take(result.failure.empty() ? result.values : none);
      }
    }
  };
}

}  // namespace microslip
