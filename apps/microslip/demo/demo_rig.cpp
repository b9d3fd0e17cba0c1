// SPDX-License-Identifier: MIT
#include "demo/demo_rig.hpp"

#include <cstddef>
#include <string>

#include "arguments/progress_bar.hpp"
#include "demo/demo_rig_figures.hpp"
#include "demo_data.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/response/verification_file.hpp"
#include "microslip/documents/response/virtual_measurement_file.hpp"
#include "microslip/documents/structure/rig_file.hpp"
#include "microslip/documents/structure/rig_writer.hpp"

namespace microslip::app {
namespace {

const std::string kFolder = "reference_rig";

void add_tables(DemoFolder& folder, const RigDemonstration& done) {
  const VirtualRecords& records = done.recordings;
  folder.add(kFolder + "/rig.toml", format_rig(without_truth(done.rig)));
  folder.add(kFolder + "/truth_joint.json", std::string(kReferenceJoint));
  folder.add(kFolder + "/truth.csv",
             truth_table(done.test.levels, done.truth, records.names).str());
  folder.add(kFolder + "/force_control.csv",
             force_control_table(done.test.levels, VirtualMeasurementOptions{}.controlled_harmonics)
                 .str());
  const std::string origin = folder.provenance(kFolder, {"rig.toml", "joint.json"});
  const auto add_predicted = [&](const char* name, CsvWriter table) {
    table.add_comment(origin);
    folder.add(kFolder + name, table.str());
  };
  add_predicted("/verification.csv", verification_table(done.verification.records));
  add_predicted("/verification_harmonics.csv", harmonics_table(done.verification.records));
  add_predicted("/verification_histories.csv", histories_table(done.verification.records));
  for (std::size_t i = 0; i < records.names.size(); ++i) {
    folder.add(kFolder + "/" + records.names[i], records.recordings[i]);
  }
  for (const auto& [name, recording] : records.before_control) {
    folder.add(kFolder + "/" + name, recording);
  }
}

}  // namespace

RigDemonstration demonstrate_rig(DemoFolder& folder) {
  const bool quiet = folder.call().quiet;
  RigDemonstration done =
      demonstrate(parse_rig(kReferenceRig, "examples/reference_rig/rig.toml"),
                  parse_joint(kReferenceJoint, "examples/reference_rig/joint.json").joint,
                  kDemoSeed, [&](const char* what) { return progress_bar(what, quiet); });
  folder.add(kFolder + "/levels.csv", done.levels_text);
  folder.add_identification(kFolder, done.found, done.options, done.levels.file, done.levels_text);
  add_tables(folder, done);
  folder.add_report({kFolder, "Reference rig",
                     "A virtual frictional-support test with shaker, force control and noise; the "
                     "joint is known, and the reduction never reads it",
                     rig_pictures});
  return done;
}

}  // namespace microslip::app
