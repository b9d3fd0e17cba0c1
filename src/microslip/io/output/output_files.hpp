// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/io/output/temporaries.hpp"

namespace microslip {

class FileDescriptor;

/// Which file that is there already may be replaced, of those of the same kind.
enum class Replacing {
  kOwn,   ///< one that this program wrote, see own_file.hpp
  kSame,  ///< none but one of the very same bytes, as the same call on the same inputs leaves it
  kAny,   ///< whoever wrote it
};

/// Checks, before a long computation, what OutputFiles will demand of a path at its end.
/// @param path  "-" is standard output, to which anything may go.
/// @param kind  what will be written, see file_kind.hpp; empty where that is not known yet.
/// @param replacing  which file may be replaced; content of its own is compared only at the end.
/// @throws FileError  where the folder is missing or closed to writing, or the path names a folder,
///                    a device or a pipe, or an existing file of another kind, one that this
///                    program did not write or one closed to writing.
void check_output(const std::string& path, std::string_view kind = {},
                  Replacing replacing = Replacing::kOwn);

/// check_output() of a file where there are several.
struct PlannedOutput {
  std::string path;            ///< of the file; "-" is standard output
  std::string_view kind = {};  ///< as of check_output()
};

/// Checks all files that OutputFiles is to write, as above.
/// @throws FileError  as check_output(), and where two of them have one path or are standard
///                    output.
void check_outputs(std::span<const PlannedOutput> outputs);

/// Behind the name of a staged file: what goes into it at the end, as the rows of a TableStream.
inline constexpr std::string_view kRowsSuffix = ".rows";

/// Files that are written all or none. Each is written under a temporary name in its folder first;
/// commit() gives them their names. Without commit(), on an exception for instance, nothing is left
/// behind and existing files stay as they were. A file replaces only one of its kind (file_kind())
/// as Replacing has it, one of the same bytes or an empty one, and takes over its permissions; a
/// link stays a link. What a process that was
/// killed left of this kind in a folder is removed by the next one that writes there on the same
/// machine.
class OutputFiles {
 public:
  OutputFiles() = default;

  /// Adds a file with its content.
  /// @param path     "-" is standard output, written by commit().
  /// @param content  all of it.
  /// @throws FileError  as check_output(), where two files of the set have one path, and where the
  ///                    content cannot be written.
  void add(const std::string& path, std::string_view content);

  /// For what can only be written by name, by another library for instance: the name to write to
  /// before commit(). The file exists and is empty.
  /// @throws FileError  as add().
  [[nodiscard]] std::string stage(const std::string& path, Replacing replacing = Replacing::kOwn);

  /// Gives all files their names.
  /// Signals that end a process wait until all have theirs, or none.
  /// @throws FileError  where a file cannot be replaced, is of another kind or none that may be
  ///                    replaced; then all are as before (on a file system without hard links:
  ///                    those not replaced yet).
  void commit();

 private:
  struct File {
    std::string path;    ///< as given, for messages
    std::string target;  ///< behind links
    Temporary temporary;
    Replacing replacing;
    bool replaces = false;  ///< a file that was there at check_all()
  };

  std::pair<File*, FileDescriptor> create(const std::string& path, Replacing replacing);
  void check_all();
  void give_names();

  std::vector<File> files_;
  std::optional<std::string> standard_output_;
};

/// One file, whole or not at all. @throws FileError  as OutputFiles.
void write_file(const std::string& path, std::string_view content);

/// Removes a file that this program wrote and that holds no longer; one that cannot be removed
/// stays.
/// @param path  of it.
void remove_file(const std::string& path);

}  // namespace microslip
