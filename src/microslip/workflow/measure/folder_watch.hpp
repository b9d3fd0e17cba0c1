// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace microslip {

/// Changes of the files of a folder since the last check.
struct FolderChange {
  std::vector<std::string> whole = {};    ///< paths of all that are whole, sorted
  std::vector<std::string> changed = {};  ///< of these, those that are new or other ones
  bool gone = false;                      ///< one that was whole is not there any more
  bool waiting = false;                   ///< some are not still yet
  /// Whether something is to be done.
  [[nodiscard]] bool any() const { return gone || !changed.empty(); }
};

/// Looks again and again which files of a folder are whole: those whose size and time of change
/// have stood still for a while. Who copies or writes a file changes one of them until it is done.
class FolderWatch {
 public:
  using Clock = std::chrono::steady_clock;  ///< of looks

  /// Whether a file is looked at. @param name  in the folder, or in recordings/ of it.
  using Wanted = std::function<bool(const std::string& name)>;

  /// @param folder  with files in it or in recordings/.
  /// @param still   for how long a file must not have changed.
  /// @param wanted  which are looked at. Hidden files and temporary ones never are.
  FolderWatch(std::string folder, std::chrono::milliseconds still, Wanted wanted);

  /// Files present. @param now  not before the last check. @throws FileError  where the folder
  /// cannot be read.
  FolderChange look(Clock::time_point now = Clock::now());

  /// Whether a name is one of a file that is still in the making, or hidden: `.x`, `x~`, `x.tmp`,
  /// `x.part`, `x.partial`, `x.crdownload`, `x.swp`, `~$x`, `#x#`.
  [[nodiscard]] static bool is_temporary(const std::string& name);

 private:
  struct Seen {
    std::uintmax_t size = 0;
    std::int64_t changed = 0;  // of its clock
    Clock::time_point since = {};
    bool whole = false;
    bool there = true;
  };

  void note(const std::string& path, Clock::time_point now, FolderChange& change);

  std::string folder_;
  std::chrono::milliseconds still_;
  Wanted wanted_;
  std::map<std::string, Seen> files_;
};

}  // namespace microslip
