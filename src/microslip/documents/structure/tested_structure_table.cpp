// SPDX-License-Identifier: MIT
#include "microslip/documents/structure/tested_structure_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/model_tables.hpp"
#include "microslip/documents/structure/structure_places.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/responses/recorded_responses.hpp"

namespace microslip {
namespace {

constexpr double kLargestModalMass = 1e12;  // kg

constexpr std::string_view kShapesKey = "shapes";
constexpr std::string_view kResponsesKey = "frfs";
constexpr std::string_view kDriveKey = "drive";
constexpr std::string_view kBandKey = "band_Hz";
constexpr std::string_view kStartKey = "start_frequency_Hz";
constexpr std::string_view kDampingKey = "damping";
constexpr std::string_view kResponseKey = "response";
constexpr std::string_view kChannelKey = "channel";
constexpr std::string_view kForceKey = "force";
constexpr std::string_view kUnitKey = "unit";
constexpr std::string_view kModalMassKey = "modal_mass_kg";
constexpr std::string_view kLengthUnitKey = "length_unit";
constexpr std::string_view kForceUnitKey = "force_unit";

/// Node and direction of a table, as a universal file has them.
UffPoint read_point(const TomlTable& table) {
  const MeshPlace place = read_place(table, NodeSets());
  const MeshDirection direction = read_direction(table, true);
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(direction.axis[k]) != 1.0) continue;
    const auto number = static_cast<std::int64_t>(direction.turns ? k + 4 : k + 1);
    return {.node = place.nodes.front(), .direction = direction.axis[k] < 0.0 ? -number : number};
  }
  throw InputError(table.name("direction"), "no axis",
                   "must be x, y, z, rx, ry or rz: a direction of the file");
}

DegreeOfFreedom read_drive(const TomlTable& test) {
  const TomlTable drive = test.table(kDriveKey);
  drive.allow_only({kNodeKey, "direction"});
  const UffPoint point = read_point(drive);
  return {point.node, static_cast<NodalDirection>(std::abs(point.direction) - 1)};
}

/// A [[test.response]]. @param drive  where the force is, unless the table says another place.
ResponseChannel read_channel(const TomlTable& table, const DegreeOfFreedom& drive) {
  table.allow_only({kChannelKey, kNodeKey, "direction", kForceKey, kUnitKey});
  ResponseChannel channel{.name = table.text(kChannelKey), .response = read_point(table)};
  channel.reference = {.node = drive.node,
                       .direction = static_cast<std::int64_t>(drive.direction) + 1};
  if (table.has(kForceKey)) {
    const TomlTable force = table.table(kForceKey);
    force.allow_only({kNodeKey, "direction"});
    channel.reference = read_point(force);
  }
  if (!table.has(kUnitKey)) return channel;
  channel.unit = find_unit(table.text(kUnitKey));
  if (!channel.unit) {
    throw InputError(table.name(kUnitKey), in_quotes(table.text(kUnitKey)),
                     "must be the unit of a motion over a force, for instance m/s^2/N");
  }
  return channel;
}

std::array<double, 2> read_band(const TomlTable& test) {
  const std::vector<double> band = read_positive(test, kBandKey, kHighestFrequency);
  if (band.size() == 2 && band[0] < band[1]) return {band[0], band[1]};
  throw InputError(test.name(kBandKey),
                   fmt::format("{} value{}", band.size(), band.size() == 1 ? "" : "s"),
                   "must be two, from and to, rising");
}

DampingLaw read_law(const TomlTable& test) {
  const std::string law = test.text(kDampingKey);
  if (law == "viscous") return DampingLaw::kViscous;
  if (law == "hysteretic") return DampingLaw::kHysteretic;
  throw InputError(test.name(kDampingKey), in_quotes(law), "must be viscous or hysteretic");
}

/// Numbers of a key, each above 0; at least one.
std::vector<double> read_above_zero(const TomlTable& test, std::string_view key, double most) {
  std::vector<double> values = read_positive(test, key, most);
  if (values.empty()) throw wrong_count(test, key, 0, "must have at least one");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0.0)) throw InputError(test.name(key, i), values[i], "must be above 0");
  }
  return values;
}

/// Of the keys for the other kind of file. @param wanted  what the key is for. @param here  what
/// this test has in its place.
void refuse_idle(const TomlTable& test, std::string_view key, std::string_view wanted,
                 std::string_view here) {
  if (!test.has(key)) return;
  throw InputError(test.name(key), InputState{"given"},
                   fmt::format("has no effect with {}: it applies to {}", here, wanted),
                   "Leave it out.");
}

void read_shapes(const TomlTable& test, std::string_view file, TestedStructure& read) {
  for (const std::string_view key : {kDriveKey, kBandKey, kStartKey, kDampingKey, kResponseKey}) {
    refuse_idle(test, key, "frequency responses, frfs", "mode shapes");
  }
  if (test.has(kModalMassKey)) {
    read.modal_mass = read_above_zero(test, kModalMassKey, kLargestModalMass);
  }
  read.file = test.text(kShapesKey);
  const std::string path = path_beside(test, kShapesKey, "a universal file", file);
  UffModeShapes shapes = read_named(test, kShapesKey, path, read_mode_shapes_uff);
  read.shapes = std::move(shapes.shapes);
  read.warnings = std::move(shapes.warnings);
  if (!read.shapes.empty()) return;
  throw FormatError({.file = path}, "mode shapes (dataset 55 or 2414)",
                    read.warnings.empty() ? "none" : read.warnings.front().text);
}

bool is_universal(const std::string& path) {
  const RecordingFormat format = recording_format(part_of_file(path).file);
  return format == RecordingFormat::kUff || format == RecordingFormat::kUffBinary;
}

/// Whatever format the file has.
FrequencyResponses responses_of(const TomlTable& test, const std::string& path,
                                TestedStructure& read) {
  if (is_universal(path)) {
    refuse_idle(test, kResponseKey, "CSV, MATLAB and HDF5, whose channels have no nodes",
                "a universal file, which has its nodes");
    return read_responses_uff(path, read.units);
  }
  for (const std::string_view key : {kLengthUnitKey, kForceUnitKey}) {
    refuse_idle(test, key, "universal files", "a file whose channels have their units");
  }
  read.kept_as = "channels";
  std::vector<ResponseChannel> channels;
  if (test.has(kResponseKey)) {
    for (const TomlTable& table : test.tables(kResponseKey)) {
      channels.push_back(read_channel(table, *read.drive));
    }
  }
  return read_recorded_responses(path, channels);
}

void read_frequency_responses(const TomlTable& test, std::string_view file, TestedStructure& read) {
  refuse_idle(test, kModalMassKey, "mode shapes, shapes", "frequency responses");
  read.drive = read_drive(test);
  if (test.has(kBandKey)) read.band = read_band(test);
  if (test.has(kStartKey)) {
    read.start_frequency = read_above_zero(test, kStartKey, kHighestFrequency);
  }
  if (test.has(kDampingKey)) read.law = read_law(test);
  read.file = test.text(kResponsesKey);
  const std::string path = path_beside(test, kResponsesKey, "a file of responses", file);
  FrequencyResponses responses = read_named(test, kResponsesKey, path, [&](const std::string& its) {
    return responses_of(test, its, read);
  });
  read.responses = std::move(responses.responses);
  read.warnings = std::move(responses.warnings);
}

}  // namespace

double read_unit_factor(const TomlTable& table, std::string_view key, const Dimension& dimension) {
  if (!table.has(key)) return 1.0;
  try {
    return parse_unit(table.text(key), dimension).factor();
  } catch (const InputError& error) {
    throw error.renamed(table.name(key));
  }
}

TestedStructure read_tested_structure(const TomlTable& test, std::string_view file) {
  test.allow_only({kShapesKey, kResponsesKey, kDriveKey, kBandKey, kStartKey, kDampingKey,
                   kResponseKey, kModalMassKey, kLengthUnitKey, kForceUnitKey});
  if (test.has(kShapesKey) == test.has(kResponsesKey)) {
    throw FormatError(test.place(kResponsesKey), "in test one of the keys shapes and frfs",
                      test.has(kShapesKey) ? "both" : "neither");
  }
  TestedStructure read;
  if (test.has(kLengthUnitKey) || test.has(kForceUnitKey)) {
    read.units = UnitSystem{.length = read_unit_factor(test, kLengthUnitKey, kLength),
                            .force = read_unit_factor(test, kForceUnitKey, kForce)};
  }
  if (test.has(kShapesKey)) {
    read_shapes(test, file, read);
  } else {
    read_frequency_responses(test, file, read);
  }
  return read;
}

}  // namespace microslip
