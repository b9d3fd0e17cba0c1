// SPDX-License-Identifier: MIT
#include "demo_recordings.hpp"

#include <string>

#include "demo_data.hpp"
#include "demo_recordings_data.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/csv.hpp"
#include "microslip/io/rig_file.hpp"

namespace microslip::app {
namespace {

Recording recording_of(const ShippedFile& file, const Rig& rig) {
  const CsvTable table(std::string(file.content), file.name);
  const std::vector<double> time = table.numbers("time", kTime);
  Recording recording;
  recording.source = file.name;
  recording.axis.start = time.front();
  recording.axis.step = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const auto add = [&](const std::string& name, const Dimension& dimension) {
    recording.channels.push_back({name, dimension, table.numbers(name, dimension), {}, {}});
  };
  add(rig.excitation.channel, kForce);
  for (const RigSensor& sensor : rig.accelerometers) add(sensor.channel, kAcceleration);
  if (rig.vibrometer) add(rig.vibrometer->channel, kLength);
  return recording;
}

}  // namespace

Rig demo_rig() { return parse_rig(kReferenceRig, "examples/reference_rig/rig.toml"); }

std::vector<Recording> demo_recordings(const Rig& rig) {
  std::vector<Recording> recordings;
  for (const ShippedFile& file : kReferenceRecordings) {
    recordings.push_back(recording_of(file, rig));
  }
  return recordings;
}

}  // namespace microslip::app
