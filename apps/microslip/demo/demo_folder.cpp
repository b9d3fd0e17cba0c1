// SPDX-License-Identifier: MIT
#include "demo/demo_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "arguments/progress_bar.hpp"
#include "arguments/report_html.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/identify/identification_text.hpp"
#include "microslip/workflow/identify/levels_identification.hpp"
#include "microslip/workflow/results/experiment_folder.hpp"

namespace microslip::app {

DemoFolder::DemoFolder(std::string path, const Call& call) : path_(std::move(path)), call_(call) {
  make_folder(path_);
}

void DemoFolder::make_folder(const std::string& path) {
  folders_.make(path, "Choose another folder with --out.");
}

std::string DemoFolder::path_of(const std::string& name) const {
  return (std::filesystem::path(path_) / name).string();
}

void DemoFolder::add_identification(const std::string& folder, const Identification& found,
                                    const IdentificationOptions& options,
                                    const std::string& input_name, std::string_view input) {
  add(folder + "/joint.json", joint_text({.options = options}, found,
                                         {input_name, std::string(input)}, call_.command_line));
  add(folder + "/density.csv", density_csv(found, call_.command_line));
}

std::string DemoFolder::provenance(const std::string& folder,
                                   const std::vector<std::string>& inputs) const {
  std::vector<NamedInput> named;
  for (const std::string& input : inputs) {
    const auto file = std::ranges::find(files_, folder + "/" + input,
                                        [](const auto& entry) { return entry.first; });
    named.push_back({input, file->second});
  }
  return provenance_of(call_.command_line, named);
}

void DemoFolder::add_report(const DemoReport& report) {
  reports_.push_back(report);
  make_folder(path_of(report.folder));
  check_output(report_paths().back(), kReportKind);
}

std::vector<std::string> DemoFolder::report_paths() const {
  std::vector<std::string> paths;
  for (const DemoReport& report : reports_)
    paths.push_back(path_of(report.folder + "/report.html"));
  return paths;
}

void DemoFolder::write_report(const DemoReport& report) {
  ExperimentResults results = read_experiment(path_of(report.folder), kRecordsOverTime,
                                              progress_bar("recordings", call_.quiet));
  results.title = report.title;
  results.subtitle = report.subtitle;
  OutputFiles outputs;
  for (const DemoPicture& picture : report.pictures(results)) {
    const std::string name = report.folder + "/" + picture.name;
    const auto add = [&](const char* ending, PictureFormat format) {
      outputs.add(path_of(name + ending),
                  std::visit([&](const auto& figure) { return draw(figure, format, picture.size); },
                             picture.figure));
    };
    add(".svg", PictureFormat::kSvg);
    add(".png", PictureFormat::kPng);
    pictures_.push_back(name);
  }
  outputs.add(path_of(report.folder + "/report.html"), report_html(std::move(results), call_));
  outputs.commit();
}

std::vector<std::string> DemoFolder::commit() {
  OutputFiles outputs;
  const auto prepared = [&](const std::string& name) {
    std::string path = path_of(name);
    make_folder(std::filesystem::path(path).parent_path().string());
    return path;
  };
  for (const auto& [name, content] : files_) outputs.add(prepared(name), content);
  for (const auto& [name, recording] : recordings_) {
    write_recordings(outputs, prepared(name), std::span(&recording, 1), RecordingFormat::kCsv);
  }
  outputs.commit();
  for (const DemoReport& report : reports_) write_report(report);
  return pictures_;
}

}  // namespace microslip::app
