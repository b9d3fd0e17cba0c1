// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_recording.hpp"
#include "microslip/io/hdf5/hdf5_writing.hpp"
#include "microslip/io/output/file_output.hpp"
#include "microslip/io/recordings/hdf5_layout.hpp"
#include "microslip/io/recordings/value_checksum.hpp"

namespace microslip {
namespace {

constexpr hsize_t kChunk = kHdf5Chunk;
/// Programs with HDF5 1.8 read it, and jsfive.
constexpr Hdf5Layout kLayout = Hdf5Layout::kWhole;

/// The attributes of a recording or a channel under names that are free, in their order.
template <class Keys>
void write_attributes(hid_t object, const Attributes& attributes, const Keys& keys,
                      const std::string& place) {
  std::set<std::string> taken(keys.begin(), keys.end());
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const auto& [name, value] = attributes[i];
    if (name.find('\0') != std::string::npos) {
      throw InputError(place + ": name of an attribute", name.c_str(), "must hold no zero byte");
    }
    const bool is_free = !name.empty() && !name.starts_with("attribute_") && !taken.contains(name);
    const std::string stored = is_free ? name : fmt::format("attribute_{}:{}", i + 1, name);
    write_hdf5_text(object, stored, value, place);
    taken.insert(stored);
  }
}

Hdf5Handle complex_type(hid_t part) {
  Hdf5Handle type(H5Tcreate(H5T_COMPOUND, 2 * sizeof(double)), H5Tclose);
  H5Tinsert(type.id(), "r", 0, part);
  H5Tinsert(type.id(), "i", sizeof(double), part);
  return type;
}

/// A chunk at a time: the two parts lie apart in memory and side by side in the file.
Hdf5Handle write_complex(hid_t group, const char* name, const Channel& channel,
                         const std::string& place) {
  const hsize_t count = channel.values.size();
  Hdf5Handle dataset =
      create_hdf5_dataset(group, name, complex_type(H5T_IEEE_F64LE).id(), {count}, place, kLayout);
  const Hdf5Handle memory_type = complex_type(H5T_NATIVE_DOUBLE);
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::vector<double> buffer;
  for (hsize_t start = 0; start < count; start += kChunk) {
    const hsize_t size = std::min(kChunk, count - start);
    buffer.resize(2 * size);
    for (hsize_t i = 0; i < size; ++i) {
      buffer[2 * i] = channel.values[start + i];
      buffer[2 * i + 1] = channel.imaginary[start + i];
    }
    const Hdf5Handle memory(H5Screate_simple(1, &size, nullptr), H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &start, nullptr, &size, nullptr);
    if (H5Dwrite(dataset.id(), memory_type.id(), memory.id(), space.id(), H5P_DEFAULT,
                 buffer.data()) < 0) {
      fail_hdf5_writing(place);
    }
  }
  return dataset;
}

void write_axis(hid_t group, const Axis& axis, const std::string& place) {
  write_hdf5_text(group, "axis_unit", si_unit(axis.dimension), place);
  if (!axis.even()) {
    Hdf5Handle dataset =
        write_hdf5_real(group, "axis", axis.values, {axis.values.size()}, place + "/axis", kLayout);
    write_hdf5_text(dataset.id(), kChecksumKey, checksum_of(axis.values), place + "/axis");
    write_hdf5_text(dataset.id(), "unit_str", si_unit(axis.dimension), place + "/axis");
    return close_hdf5(dataset, place + "/axis");
  }
  write_hdf5_number(group, "start", axis.start, place);
  write_hdf5_number(group, "step", axis.step, place);
  if (axis.dimension == kTime) write_hdf5_number(group, "fs", 1.0 / axis.step, place);
}

void write_channel(hid_t group, std::size_t number, const Channel& channel, const Axis& axis,
                   const std::string& place_of_group) {
  const std::string name = fmt::format("channel_{}", number);
  const std::string place = place_of_group + "/" + name;
  Hdf5Handle dataset =
      channel.imaginary.empty()
          ? write_hdf5_real(group, name, channel.values, {channel.values.size()}, place, kLayout)
          : write_complex(group, name.c_str(), channel, place);
  write_hdf5_text(dataset.id(), "channel_name", channel.name, place);
  if (channel.dimension) {
    write_hdf5_text(dataset.id(), "unit_str", si_unit(*channel.dimension), place);
    write_hdf5_text(dataset.id(), "quantity", dimension_name(*channel.dimension), place);
  }
  if (axis.even() && axis.dimension == kTime) {
    write_hdf5_number(dataset.id(), "fs", 1.0 / axis.step, place);
  }
  write_hdf5_text(dataset.id(), kChecksumKey, checksum_of(channel.values, channel.imaginary),
                  place);
  write_attributes(dataset.id(), channel.attributes, kChannelKeys, place);
  close_hdf5(dataset, place);
}

void write_recording(hid_t file, std::size_t number, const Recording& recording,
                     const std::string& path) {
  const std::string name = fmt::format("recording_{}", number);
  const std::string place = fmt::format("{}:/{}", path, name);
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_attr_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(properties.id(), false);
  Hdf5Handle group = require_hdf5(
      {H5Gcreate2(file, name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose}, place);
  write_hdf5_text(group.id(), "source", recording.source, place);
  write_axis(group.id(), recording.axis, place);
  write_attributes(group.id(), recording.attributes, kRecordingKeys, place);
  for (std::size_t i = 0; i < recording.channels.size(); ++i) {
    write_channel(group.id(), i + 1, recording.channels[i], recording.axis, place);
  }
  close_hdf5(group, place);
}

void write_whole(hid_t file, const std::string& path, std::span<const Recording> recordings) {
  write_hdf5_text(file, "schema", std::string(kRecordingSchema), path);
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    write_recording(file, i + 1, recordings[i], path);
  }
}

}  // namespace

void write_recordings_hdf5(const std::string& path, std::span<const Recording> recordings) {
  for (const Recording& recording : recordings) check_recording(recording);
  const Hdf5Memory memory([&](hid_t file) { write_whole(file, path, recordings); }, path, kLayout);
  FileOutput output(path);
  output.write(memory.bytes());
  output.close();
}

}  // namespace microslip
