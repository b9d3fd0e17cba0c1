// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <memory>

namespace microslip::app {

/// Columns of the terminal that standard output is, from 40; 80 where it is none.
[[nodiscard]] std::size_t help_width();

/// Help whose descriptions are broken between words: beside the options, or, in few columns, below
/// them.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_help_formatter(std::size_t width);

}  // namespace microslip::app
