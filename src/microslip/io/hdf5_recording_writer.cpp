// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <set>

#include "microslip/base/error.hpp"
#include "microslip/io/file_output.hpp"
#include "microslip/io/hdf5_handle.hpp"
#include "microslip/io/hdf5_layout.hpp"
#include "microslip/io/hdf5_recording.hpp"
#include "microslip/io/text.hpp"
#include "microslip/io/write_error.hpp"

namespace microslip {
namespace {

constexpr hsize_t kChunk = hsize_t{1} << 17U;  // values
/// The library looks for a file of the name before it makes one in memory.
constexpr const char* kNowhere = "/dev/null/in memory";

/// What can go wrong in memory.
[[noreturn]] void fail_to_make(std::string_view place) {
  throw WriteError(place, fmt::format("cannot be written: {}", hdf5_reason()));
}

Hdf5Handle require_written(Hdf5Handle handle, const std::string& place) {
  if (!handle.valid()) fail_to_make(place);
  return handle;
}

/// What has been kept back is written upon closing.
void close_written(Hdf5Handle& handle, const std::string& place) {
  if (!handle.close()) fail_to_make(place);
}

void write_attribute(hid_t object, const std::string& name, hid_t type, const void* value,
                     const std::string& place) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                       H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute.id(), type, value) < 0 || !attribute.close()) {
    fail_to_make(fmt::format("{}: attribute {}", place, in_quotes(name)));
  }
}

void write_text_attribute(hid_t object, const std::string& name, const std::string& value,
                          const std::string& place) {
  if (value.find('\0') != std::string::npos) {
    throw InputError(fmt::format("{}: {}", place, name), in_quotes(value),
                     "must hold no zero byte");
  }
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<std::size_t>(value.size(), 1));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  write_attribute(object, name, type.id(), value.c_str(), place);
}

void write_number_attribute(hid_t object, const std::string& name, double value,
                            const std::string& place) {
  write_attribute(object, name, H5T_NATIVE_DOUBLE, &value, place);
}

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
    write_text_attribute(object, stored, value, place);
    taken.insert(stored);
  }
}

/// In chunks with checksums; attributes keep their order.
Hdf5Handle dataset_properties(hsize_t count) {
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const hsize_t chunk = std::min(count, kChunk);
  H5Pset_chunk(properties.id(), 1, &chunk);
  H5Pset_fletcher32(properties.id());
  H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER);
  H5Pset_obj_track_times(properties.id(), false);  // the same recording makes the same file
  H5Pset_attr_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return properties;
}

Hdf5Handle create_dataset(hid_t group, const char* name, hid_t type, hsize_t count,
                          const std::string& place) {
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  return require_written({H5Dcreate2(group, name, type, space.id(), H5P_DEFAULT,
                                     dataset_properties(count).id(), H5P_DEFAULT),
                          H5Dclose},
                         place);
}

Hdf5Handle write_real(hid_t group, const char* name, std::span<const double> values,
                      const std::string& place) {
  Hdf5Handle dataset = create_dataset(group, name, H5T_IEEE_F64LE, values.size(), place);
  if (H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail_to_make(place);
  }
  return dataset;
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
  Hdf5Handle dataset = create_dataset(group, name, complex_type(H5T_IEEE_F64LE).id(), count, place);
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
      fail_to_make(place);
    }
  }
  return dataset;
}

void write_axis(hid_t group, const Axis& axis, const std::string& place) {
  write_text_attribute(group, "axis_unit", si_unit(axis.dimension), place);
  if (!axis.even()) {
    Hdf5Handle dataset = write_real(group, "axis", axis.values, place + "/axis");
    write_text_attribute(dataset.id(), "unit_str", si_unit(axis.dimension), place + "/axis");
    return close_written(dataset, place + "/axis");
  }
  write_number_attribute(group, "start", axis.start, place);
  write_number_attribute(group, "step", axis.step, place);
  if (axis.dimension == kTime) write_number_attribute(group, "fs", 1.0 / axis.step, place);
}

void write_channel(hid_t group, std::size_t number, const Channel& channel, const Axis& axis,
                   const std::string& place_of_group) {
  const std::string name = fmt::format("channel_{}", number);
  const std::string place = place_of_group + "/" + name;
  Hdf5Handle dataset = channel.imaginary.empty()
                           ? write_real(group, name.c_str(), channel.values, place)
                           : write_complex(group, name.c_str(), channel, place);
  write_text_attribute(dataset.id(), "channel_name", channel.name, place);
  if (channel.dimension) {
    write_text_attribute(dataset.id(), "unit_str", si_unit(*channel.dimension), place);
    write_text_attribute(dataset.id(), "quantity", dimension_name(*channel.dimension), place);
  }
  if (axis.even() && axis.dimension == kTime) {
    write_number_attribute(dataset.id(), "fs", 1.0 / axis.step, place);
  }
  write_attributes(dataset.id(), channel.attributes, kChannelKeys, place);
  close_written(dataset, place);
}

void write_recording(hid_t file, std::size_t number, const Recording& recording,
                     const std::string& path) {
  const std::string name = fmt::format("recording_{}", number);
  const std::string place = fmt::format("{}:/{}", path, name);
  const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_attr_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(properties.id(), false);
  Hdf5Handle group = require_written(
      {H5Gcreate2(file, name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose}, place);
  write_text_attribute(group.id(), "source", recording.source, place);
  write_axis(group.id(), recording.axis, place);
  write_attributes(group.id(), recording.attributes, kRecordingKeys, place);
  for (std::size_t i = 0; i < recording.channels.size(); ++i) {
    write_channel(group.id(), i + 1, recording.channels[i], recording.axis, place);
  }
  close_written(group, place);
}

/// The bytes of a file that the library makes in memory: of a file on a disk it would let errors
/// pass. They are whole when the library has closed it.
class MemoryFile {
 public:
  MemoryFile() = default;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Has the file of the access properties made here.
  void use_by(hid_t access) {
    H5Pset_fapl_core(access, kStep, false);
    H5FD_file_image_callbacks_t calls{};
    calls.image_malloc = [](std::size_t size, H5FD_file_image_op_t, void* to) {
      return resized(size, to);
    };
    calls.image_realloc = [](void*, std::size_t size, H5FD_file_image_op_t, void* to) {
      return resized(size, to);
    };
    calls.image_free = [](void*, H5FD_file_image_op_t, void*) { return herr_t{0}; };
    calls.udata_copy = [](void* to) { return to; };
    calls.udata_free = [](void*) { return herr_t{0}; };
    calls.udata = this;
    H5Pset_file_image_callbacks(access, &calls);
  }

  /// Without what was taken in advance: the superblock (version 2 or 3) has the end of the file.
  [[nodiscard]] std::string_view bytes() const {
    constexpr std::size_t kPlaceOfEnd = 28;
    std::size_t end = 0;
    for (std::size_t i = 8; i-- > 0;) {
      end = end << 8U | static_cast<unsigned char>(bytes_.at(kPlaceOfEnd + i));
    }
    return std::string_view(bytes_).substr(0, end);
  }

 private:
  static constexpr std::size_t kStep = std::size_t{1} << 20U;

  /// The library takes no exceptions.
  static void* resized(std::size_t size, void* to) {
    std::string& bytes = static_cast<MemoryFile*>(to)->bytes_;
    try {
      if (size > bytes.capacity()) bytes.reserve(std::max(size, 2 * bytes.capacity()));
      bytes.resize(size);
    } catch (const std::exception&) {
      return nullptr;
    }
    return bytes.data();
  }

  std::string bytes_;
};

void write_whole(MemoryFile& memory, const std::string& path,
                 std::span<const Recording> recordings) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // From 1.10 on all that surrounds the values carries checksums.
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  memory.use_by(access.id());
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  Hdf5Handle file = require_written(
      {H5Fcreate(kNowhere, H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose}, path);
  write_text_attribute(file.id(), "schema", std::string(kRecordingSchema), path);
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    write_recording(file.id(), i + 1, recordings[i], path);
  }
  close_written(file, path);
}

}  // namespace

void write_recordings_hdf5(const std::string& path, std::span<const Recording> recordings) {
  for (const Recording& recording : recordings) check_recording(recording);
  MemoryFile memory;
  {
    const Hdf5Session session;
    write_whole(memory, path, recordings);
  }
  FileOutput output(path);
  output.write(memory.bytes());
  output.close();
}

}  // namespace microslip
