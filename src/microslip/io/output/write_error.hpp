// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {

/// Something could not be written whole: the disk is full or fails, a limit is reached, nobody
/// reads the pipe. Unlike with other errors of files, neither the call nor the input is at fault.
class WriteError : public FileError {
 public:
  /// As FileError.
  WriteError(std::string_view path, std::string_view reason, std::string_view remedy = {})
      : FileError(path, reason, remedy), reason_(reason), remedy_(remedy) {}

  /// The same error of another path: of that which the caller gave, where this one is temporary.
  [[nodiscard]] WriteError renamed(std::string_view path) const { return {path, reason_, remedy_}; }

 private:
  std::string reason_;
  std::string remedy_;
};

/// Whether another path would do, by what the system says, an `errno`: no such folder, no
/// permission, too long a name.
[[nodiscard]] bool is_fault_of_path(int error);

/// Throws what the system says, an `errno`: a FileError "path: cannot be written: …" where
/// is_fault_of_path(), else a WriteError.
[[noreturn]] void fail_to_write(std::string_view path, int error);

/// Brings an open file to the disk. Where that is not possible, in a pipe for instance, there is
/// nothing to bring. @throws WriteError  naming `path`, where something got lost.
void sync_file(int descriptor, std::string_view path);

/// Closes a copy of the descriptor, upon which some file systems (NFS) tell what got lost; itself
/// it stays open. @throws WriteError  naming `path`, where something did.
void close_copy(int descriptor, std::string_view path);

}  // namespace microslip
