// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace microslip {

/// A file of an archive.
struct ArchiveFile {
  std::string name;     ///< with `/` between folders, relative
  std::string content;  ///< bytes
};

/// A ZIP archive of files as they are, not compressed. All have the time 1980-01-01 00:00, the
/// earliest of the format, so that the same files give the same bytes.
/// [PKWARE, .ZIP File Format Specification 6.3.10, 4.3]
/// @param files  at most 65535, of less than 4 GiB together.
/// @throws InputError  for more.
[[nodiscard]] std::string zip_archive(std::span<const ArchiveFile> files);

}  // namespace microslip
