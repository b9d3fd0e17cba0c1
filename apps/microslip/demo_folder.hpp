// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.hpp"
#include "microslip/identify/identification.hpp"
#include "microslip/io/output_folders.hpp"
#include "microslip/report/gnuplot.hpp"
#include "microslip/signal/recording.hpp"

namespace microslip::app {

/// The seed of everything that the demonstration draws.
inline constexpr std::uint64_t kDemoSeed = 1;

/// Everything that goes into the folder of the demonstration, written at once at the end.
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

  /// What a table says of its origin: call and hashes of files that were added to the folder.
  [[nodiscard]] std::string provenance(const std::string& folder,
                                       const std::vector<std::string>& inputs) const;

  /// A report of a folder of the demonstration, written last.
  void add_report(const std::string& folder, const std::string& title, const std::string& subtitle);

  template <typename Picture>
  void draw_both(const std::string& name, const Picture& picture, PictureSize size = {}) {
    add(name + ".svg", draw(picture, PictureFormat::kSvg, size));
    add(name + ".png", draw(picture, PictureFormat::kPng, size));
    pictures_.push_back(name);
  }

  [[nodiscard]] const Call& call() const { return call_; }

  /// Writes all files, then the reports of them. @return the names of the pictures, without ending.
  std::vector<std::string> commit();

  /// Of the reports, in the order of add_report().
  [[nodiscard]] std::vector<std::string> report_paths() const;

 private:
  struct Report {
    std::string folder;  ///< name
    std::string title;
    std::string subtitle;
  };

  void make_folder(const std::string& path);
  [[nodiscard]] std::string path_of(const std::string& name) const;
  void write_report(const Report& report) const;

  std::string path_;
  const Call& call_;
  OutputFolders folders_;
  std::vector<std::pair<std::string, std::string>> files_;  // name and content
  std::vector<std::pair<std::string, Recording>> recordings_;
  std::vector<std::string> pictures_;
  std::vector<Report> reports_;
};

}  // namespace microslip::app
