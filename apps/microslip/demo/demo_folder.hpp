// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "arguments/command.hpp"
#include "microslip/identify/methods/identification.hpp"
#include "microslip/io/output/output_folders.hpp"
#include "microslip/report/drawing/gnuplot.hpp"
#include "microslip/signal/recording/recording.hpp"
#include "microslip/workflow/results/experiment_results.hpp"

namespace microslip::app {

/// The seed of everything that the demonstration draws.
inline constexpr std::uint64_t kDemoSeed = 1;

/// A picture of what a folder of the demonstration holds.
struct DemoPicture {
  std::string name;  ///< in the folder, without ending
  std::variant<Figure, FigureGrid> figure;
  PictureSize size = {};
};

/// A report of a folder, and the pictures beside it.
struct DemoReport {
  std::string folder;  ///< name
  std::string title;
  std::string subtitle;
  std::vector<DemoPicture> (*pictures)(const ExperimentResults&);
};

/// Everything that goes into the folder of the demonstration, written at once at the end; what is
/// drawn of it follows.
class DemoFolder {
 public:
  /// Makes the folder where it is missing. @throws FileError  where that fails.
  DemoFolder(std::string path, const Call& call);

  /// @param name  in the folder; a folder in it is made.
  void add(const std::string& name, std::string content) {
    files_.emplace_back(name, std::move(content));
  }

  void add(const std::string& name, Recording recording) {
    recordings_.emplace_back(name, std::move(recording));
  }

  /// joint.json and density.csv.
  void add_identification(const std::string& folder, const Identification& found,
                          const IdentificationOptions& options, const std::string& input_name,
                          std::string_view input);

  /// Provenance of a table: call and hashes of files that were added to the folder.
  [[nodiscard]] std::string provenance(const std::string& folder,
                                       const std::vector<std::string>& inputs) const;

  /// Drawn last, from the files in its folder.
  void add_report(const DemoReport& report);

  [[nodiscard]] const Call& call() const { return call_; }

  /// Writes all files, then the pictures and reports of them. @return the names of the pictures,
  /// without ending.
  std::vector<std::string> commit();

  /// Of the reports, in the order of add_report().
  [[nodiscard]] std::vector<std::string> report_paths() const;

 private:
  void make_folder(const std::string& path);
  [[nodiscard]] std::string path_of(const std::string& name) const;
  void write_report(const DemoReport& report);

  std::string path_;
  const Call& call_;
  OutputFolders folders_;
  std::vector<std::pair<std::string, std::string>> files_;  // name and content
  std::vector<std::pair<std::string, Recording>> recordings_;
  std::vector<std::string> pictures_;
  std::vector<DemoReport> reports_;
};

}  // namespace microslip::app
