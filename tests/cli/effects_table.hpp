// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

/// @file
/// The table tests/data/effects.txt: each option, key and column, and the outputs that must change
/// with it. Its format is described at its top.

namespace microslip::cli_test {

/// A line of the table.
struct EffectRow {
  int line = 0;
  std::string subject;  ///< a subcommand or a file that is read
  std::string item;     ///< its option, key or column
  std::string base;     ///< arguments
  std::string change;   ///< arguments that are added, or the edit of a file
  std::vector<std::string> effects;
};

/// All lines; those that are too short fail the test that asks for them.
[[nodiscard]] std::vector<EffectRow> effect_rows();

/// The files of docs/file_formats.md that its blocks show, by name.
[[nodiscard]] std::map<std::string, std::string> documented_files();

/// The columns that docs/file_formats.md says are needed or used in a section, as in "##
/// levels.csv".
[[nodiscard]] std::vector<std::string> documented_columns(const std::string& section);

/// The keys in a file of TOML or JSON, each once.
[[nodiscard]] std::vector<std::string> keys_in(const std::string& text);

/// Without blanks at the ends.
[[nodiscard]] std::string trimmed(const std::string& text);

/// The parts between a separator, trimmed.
[[nodiscard]] std::vector<std::string> parts(const std::string& text, const std::string& separator);

/// The text with the edit of a row: "OLD -> NEW", each place; "COLUMN * FACTOR" or "COLUMN removed"
/// of a table. Throws std::runtime_error where the text has nothing to be edited.
[[nodiscard]] std::string edited(const std::string& text, const std::string& edit);

/// What is compared of an output. The whole: without comments, which hold the call, and without the
/// provenance of a joint. A part: the column of a table by its name without unit, a comment with
/// this beginning ("#peak"), or a pointer into JSON ("/identification/lambda"). Nothing where it is
/// not there.
[[nodiscard]] std::string content_of(const std::string& text, const std::string& part);

}  // namespace microslip::cli_test
