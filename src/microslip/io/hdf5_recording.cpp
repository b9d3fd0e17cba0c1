// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/hdf5_foreign.hpp"
#include "microslip/io/hdf5_handle.hpp"
#include "microslip/io/hdf5_layout.hpp"
#include "microslip/io/hdf5_values.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/sampling.hpp"
#include "microslip/io/text.hpp"
#include "microslip/io/trial_process.hpp"

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
    if (name == "axis") return read_hdf5_real(dataset.id(), recording.axis.values, place);
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
    progress_.add(channel.values.size() + channel.imaginary.size());
    recording.channels.push_back(std::move(channel));
  }

  std::string path_;
  Hdf5Progress& progress_;
};

/// As write_recordings_hdf5() leaves it: a superblock of version 2 or later, which like all that it
/// leads to has a checksum, and the schema among the attributes of the root, which come next. Told
/// from the bytes, as opening a damaged file is what can crash.
bool has_own_layout(const std::string& path) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1A\n";
  constexpr std::size_t kHeadSize = 4096;
  const std::string head = read_file_head(path, kHeadSize);
  return head.starts_with(kSignature) && head.size() > kSignature.size() &&
         head[kSignature.size()] >= 2 && head.find(kRecordingSchema) != std::string::npos;
}

Recordings read_file_of_recordings(const std::string& path, const RecordingReadOptions& options) {
  const Hdf5Handle file = open_hdf5(path);
  Hdf5Progress progress(file.id(), options.progress);
  if (hdf5_text(file.id(), "schema", path) != kRecordingSchema) {
    return read_foreign_hdf5(file.id(), path, progress);
  }
  Recordings result;
  OwnReader reader(path, progress);
  for (const std::string& name : hdf5_members(file.id(), path)) {
    result.recordings.push_back(reader.read(file.id(), name));
  }
  return result;
}

}  // namespace

Recordings read_recordings_hdf5(const std::string& path, const RecordingReadOptions& options) {
  try {
    if (path == "-") return read_file_of_recordings(path, options);  // which refuses it
    const Hdf5Session session;
    if (!has_own_layout(path)) {
      RecordingReadOptions silent = options;
      silent.progress = {};
      try_in_child(session, path, options.progress,
                   [&] { (void)read_file_of_recordings(path, silent); });
    }
    return read_file_of_recordings(path, options);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "does not fit into memory");
  }
}

}  // namespace microslip
