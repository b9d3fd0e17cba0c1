// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/figure_list.hpp"

namespace microslip::validation {

/// Parts of a Markdown file that are written by a program, by name:
///
///     <!-- validation: NAME -->
///     …
///     <!-- end validation -->
using Blocks = std::map<std::string, std::string>;

/// Measurements for the lines of a topic.
using Figures = std::vector<std::optional<double>>;

/// The blocks of a text, without their marks. @throws std::runtime_error  a mark has no partner, or
/// a name stands twice.
Blocks blocks_of(const std::string& text);

/// The text with the content of each of its blocks replaced. @throws std::runtime_error  there is
/// nothing for a block.
std::string with_blocks(const std::string& text, const Blocks& blocks);

/// A table of lines with the measurement of each, in the unit of the line; nothing where its data
/// are missing.
std::string table_of(const std::vector<FigureLine>& lines, const Figures& figures);

/// The tables of all topics by their names, and `summary`, a short one of the lines that have a
/// place in it.
Blocks tables_of(const std::vector<FigureTopic>& topics, const std::vector<Figures>& figures);

/// The measured values that table_of() shows. @throws std::runtime_error  not such a table.
Figures figures_in(const std::string& table);

/// Why a figure breaks the bounds of its line, or nothing.
std::optional<std::string> broken_bound(const FigureLine& line, double figure);

std::string read_text(const std::string& path);

}  // namespace microslip::validation
