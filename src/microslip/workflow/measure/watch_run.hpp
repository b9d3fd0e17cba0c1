// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/progress.hpp"
#include "microslip/workflow/identify/level_plan.hpp"
#include "microslip/workflow/measure/folder_watch.hpp"

/// @file
/// A test that is running: what its folder holds so far, evaluated again whenever a record comes.

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// Subject of a line.
enum class WatchedNews {
  kRecord,  ///< a record that is new
  kFault,   ///< what could not be done, and why; a file that is left out until it changes
  kJoint,   ///< what is known of it
  kNext,    ///< the level to measure next
};

#pragma GCC diagnostic pop

/// Folder to watch, and options.
struct WatchedTestOptions {
  std::string folder = {};                   ///< with the records
  std::optional<double> stiffness = {};      ///< k, N/m; without it that of rig.toml, or of records
  PlanTarget target = PlanTarget::kDensity;  ///< of the next level; kDensity or kArea
  /// Between which the next level may lie, m; without it the lowest and highest that are there.
  std::optional<std::pair<double, double>> amplitude = {};
  std::string command = {};  ///< that the files are made by
  /// Gets each line as soon as it is known.
  std::function<void(WatchedNews, const std::string&)> tell = [](WatchedNews, const std::string&) {
  };
  Progress progress = {};  ///< reports all that takes long; may cancel
};

/// The files of a folder that watch_test() reads and writes.
///
/// With a rig.toml in it all records are of that rig: they are reduced to levels.csv. Without,
/// tables of levels and recordings of force and displacement are recognised by their content. Then
/// joint.json and density.csv are written, with 1000 draws, and next_levels.csv where one table of
/// levels is all there is; one of an earlier joint is removed.
class WatchedTest {
 public:
  /// @throws InputError  where the folder holds a file of a name that is written and that is not of
  ///                     an earlier watch: nothing of others is replaced.
  explicit WatchedTest(WatchedTestOptions options);

  /// Whether a file of the folder is read. @param name  of it.
  [[nodiscard]] bool reads(const std::string& name) const;

  /// The report that belongs to the folder, which the caller writes.
  [[nodiscard]] std::string report_path() const;

  /// Whether a file of the last evaluation, found as it should be, could not be written.
  [[nodiscard]] bool lacks_a_file() const { return unwritten_; }

  /// Evaluates complete files. Faulty ones are reported once and left out until they change.
  /// @return whether a joint was written.
  /// @throws InputError  where k is not known. @throws Cancelled  as the progress says.
  bool evaluate(const FolderChange& files);

 private:
  struct Kept {
    std::vector<std::string> records;  // recordings of force and displacement
    std::vector<std::string> levels;   // tables
  };

  [[nodiscard]] std::string path(const std::string& name) const;
  void check_own() const;
  void of_rig(const std::vector<std::string>& files, const FolderChange& change);
  void of_evidence(const std::vector<std::string>& files, const FolderChange& change);
  Kept sort_out(const std::vector<std::string>& files, const FolderChange& change);
  void identify_table(const std::string& levels, double stiffness);
  void identify_together(const Kept& kept);
  void write_joint(const std::string& joint, const std::string& density);
  void write(const std::vector<std::pair<std::string_view, std::string>>& files);  // name, text
  void forget_plan() const;
  void plan_next(const std::string& levels, double stiffness, std::size_t count);
  bool done(const std::function<void()>& call) const;  // or tells the fault
  void leave_out_repeated(std::vector<std::string>& files);
  void tell_left_out(const std::string& file, const std::string& fault);

  WatchedTestOptions options_;
  std::map<std::string, std::string> faulty_;  // by path, until it changes
  bool joint_written_ = false;                 // by the last evaluation
  bool planned_ = false;                       // as above, next_levels.csv
  bool unwritten_ = false;                     // as above, any file
};

}  // namespace microslip
