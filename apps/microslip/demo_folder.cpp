// SPDX-License-Identifier: MIT
#include "demo_folder.hpp"

#include <filesystem>
#include <span>
#include <utility>

#include "identification_report.hpp"
#include "microslip/base/version.hpp"
#include "microslip/io/density_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/io/sha256.hpp"

namespace microslip::app {
DemoFolder::DemoFolder(std::string path, const Call& call) : path_(std::move(path)), call_(call) {
  make_folder(path_);
}

void DemoFolder::make_folder(const std::string& path) {
  folders_.make(path, "Choose another folder with --out.");
}

void DemoFolder::add_identification(const std::string& folder, const Identification& found,
                                    const std::string& input_name, std::string_view input) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = call_.command_line;
  provenance.inputs.push_back({input_name, sha256(input)});
  provenance.seed = kDemoSeed;
  add(folder + "/joint.json", format_joint({found.joint, provenance, record_of(found)}));
  add(folder + "/density.csv", density_table(density_table_of(found)).str());
}

std::vector<std::string> DemoFolder::commit() {
  OutputFiles outputs;
  const auto path_of = [&](const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(path_) / name;
    make_folder(path.parent_path().string());
    return path.string();
  };
  for (const auto& [name, content] : files_) outputs.add(path_of(name), content);
  for (const auto& [name, recording] : recordings_) {
    write_recordings(outputs, path_of(name), std::span(&recording, 1), RecordingFormat::kCsv);
  }
  outputs.commit();
  return pictures_;
}

}  // namespace microslip::app
