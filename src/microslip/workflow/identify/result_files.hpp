// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// @file
/// The files of a folder of results.

namespace microslip {

/// A file to be written.
struct ResultFile {
  std::string path;          ///< in the folder
  std::string_view kind;     ///< of file_kind.hpp
  std::string content = {};  ///< all of it
};

/// Checks the name of a folder of results. @throws InputError  where it is empty or "-".
void require_result_folder(const std::string& out);

/// Checks that no file of the results would take the place of an input.
/// @param out     the folder of the results, for the message.
/// @param files   of the results.
/// @param inputs  paths.
/// @throws InputError  naming the input.
void check_inputs_kept(const std::string& out, const std::vector<ResultFile>& files,
                       const std::vector<std::string>& inputs);

}  // namespace microslip
