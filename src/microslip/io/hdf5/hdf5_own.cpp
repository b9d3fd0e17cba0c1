// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_foreign.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"
#include "microslip/io/recordings/hdf5_layout.hpp"
#include "microslip/io/recordings/sampling.hpp"
#include "microslip/io/recordings/value_checksum.hpp"

namespace microslip {
namespace {

/// `attribute_<i>:<name>` stands for a name that was not free.
std::string free_name(std::string name) {
  if (!name.starts_with("attribute_")) return name;
  const std::size_t colon = name.find(':');
  return colon == std::string::npos ? name : name.substr(colon + 1);
}

template <class Keys>
Attributes own_attributes(hid_t object, const Keys& keys, const std::string& place) {
  Attributes attributes = hdf5_attributes(object, place);
  std::erase_if(attributes, [&](const auto& a) { return is_one_of(a.first, keys); });
  for (auto& [name, value] : attributes) name = free_name(std::move(name));
  return attributes;
}

template <class Value>
Value require(std::optional<Value> value, const char* name, const std::string& place) {
  if (!value) {
    throw FormatError({.file = place}, fmt::format("the attribute '{}'", name), "none",
                      "The file is damaged, or another program changed it.");
  }
  return *std::move(value);
}

Dimension own_unit(const std::string& text, const std::string& place) {
  const std::optional<Unit> unit = find_unit(text);
  if (!unit || unit->factor() != 1.0) {
    throw FormatError({.file = place}, "an SI unit", in_quotes(text),
                      "The file is damaged, or another program changed it.");
  }
  return unit->dimension;
}

/// Reads one recording that microslip wrote.
class OwnReader {
 public:
  OwnReader(const std::string& path, Hdf5Progress& progress) : path_(path), progress_(progress) {}

  Recording read(hid_t file, const std::string& name) {
    const std::string place = fmt::format("{}:/{}", path_, printable(name));
    const Hdf5Handle group = open_hdf5_object(file, name);
    if (!group.valid() || H5Iget_type(group.id()) != H5I_GROUP) fail_hdf5(place, "a recording");
    Recording recording;
    recording.source = require(hdf5_text(group.id(), "source", place), "source", place);
    recording.attributes = own_attributes(group.id(), kRecordingKeys, place);
    recording.axis.dimension =
        own_unit(require(hdf5_text(group.id(), "axis_unit", place), "axis_unit", place), place);
    const std::vector<std::string> members = hdf5_members(group.id(), place);
    if (!is_one_of("axis", members)) {
      recording.axis.start = require(hdf5_number(group.id(), "start", place), "start", place);
      recording.axis.step = require(hdf5_number(group.id(), "step", place), "step", place);
    }
    for (const std::string& member : members) read_member(recording, group.id(), place, member);
    check_read(recording, place);
    return recording;
  }

 private:
  void read_member(Recording& recording, hid_t group, const std::string& place_of_group,
                   const std::string& name) {
    const std::string place = place_of_group + "/" + printable(name);
    const Hdf5Handle dataset = open_hdf5_object(group, name);
    const bool is_dataset = dataset.valid() && H5Iget_type(dataset.id()) == H5I_DATASET;
    const Hdf5Content content = is_dataset ? hdf5_content(dataset.id()) : Hdf5Content::kOther;
    if (content != Hdf5Content::kReal && content != Hdf5Content::kComplex) {
      fail_hdf5(place, "a dataset of numbers");
    }
    if (name == "axis") {
      read_hdf5_real(dataset.id(), recording.axis.values, place);
      return check_values(dataset.id(), recording.axis.values, {}, place);
    }
    Channel channel;
    channel.name = require(hdf5_text(dataset.id(), "channel_name", place), "channel_name", place);
    if (const auto unit = hdf5_text(dataset.id(), "unit_str", place)) {
      channel.dimension = own_unit(*unit, place);
    }
    channel.attributes = own_attributes(dataset.id(), kChannelKeys, place);
    if (content == Hdf5Content::kReal) {
      read_hdf5_real(dataset.id(), channel.values, place);
    } else {
      read_hdf5_complex(dataset.id(), channel.values, channel.imaginary, place);
    }
    check_values(dataset.id(), channel.values, channel.imaginary, place);
    progress_.add(channel.values.size() + channel.imaginary.size());
    recording.channels.push_back(std::move(channel));
  }

  /// Files whose values are in chunks with checksums have none beside them.
  static void check_values(hid_t dataset, std::span<const double> values,
                           std::span<const double> imaginary, const std::string& place) {
    const std::optional<std::string> expected = hdf5_text(dataset, kChecksumKey, place);
    if (!expected || *expected == checksum_of(values, imaginary)) return;
    throw FormatError({.file = place}, "values of the checksum beside them", "others",
                      "The file is damaged, or another program changed it.");
  }

  std::string path_;
  Hdf5Progress& progress_;
};

/// Its save -hdf5 marks the group of each variable.
bool is_of_octave(hid_t file, const std::string& path) {
  const std::vector<std::string> names = hdf5_members(file, path);
  if (names.empty()) return false;
  const Hdf5Handle first = open_hdf5_object(file, names.front());
  return first.valid() && is_octave_variable(first.id());
}

}  // namespace

Hdf5Recordings hdf5_recordings(const std::string& path, const RecordingReadOptions& options) {
  const Hdf5Handle file = open_hdf5(path);
  if (is_of_octave(file.id(), path)) {
    return {.variables = mat73_tree(path, {.progress = options.progress}), .of_octave = true};
  }
  Hdf5Progress progress(file.id(), options.progress);
  if (hdf5_text(file.id(), "schema", path) != kRecordingSchema) {
    return {.recordings = read_foreign_hdf5(file.id(), path, progress, options)};
  }
  Hdf5Recordings result;
  OwnReader reader(path, progress);
  for (const std::string& name : hdf5_members(file.id(), path)) {
    result.recordings.recordings.push_back(reader.read(file.id(), name));
  }
  return result;
}

}  // namespace microslip
