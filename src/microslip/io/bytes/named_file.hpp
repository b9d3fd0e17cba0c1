// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// @file
/// Files that are not named in a call, but in another file.

namespace microslip {

/// Path of a file that another file names relative to its own folder.
/// @param naming  path of the file that names it.
/// @param name    as it stands there.
/// @throws FileError  as check_named_file().
[[nodiscard]] std::string file_beside(const std::string& naming, const std::string& name);

/// Checks that a file that another file names can be read like a file: a pipe or a device would be
/// waited for, without end and without a word. One that is missing, or a folder, is left to its
/// reader. @throws FileError  where it is neither these nor a regular file.
void check_named_file(const std::string& path);

}  // namespace microslip
