// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_writing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/output/write_error.hpp"

namespace microslip {
namespace {

/// The library looks for a file of the name before it makes one in memory.
constexpr const char* kNowhere = "/dev/null/in memory";
/// By which the memory of a file grows, bytes.
constexpr std::size_t kStepOfMemory = std::size_t{1} << 20U;

void write_attribute(hid_t object, const std::string& name, hid_t type, const void* value,
                     const std::string& place) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                       H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute.id(), type, value) < 0 || !attribute.close()) {
    fail_hdf5_writing(fmt::format("{}: attribute {}", place, in_quotes(name)));
  }
}

/// Whole rows of the last dimensions in a chunk, and no more than is there.
std::vector<hsize_t> chunk_of(const std::vector<hsize_t>& sizes) {
  std::vector<hsize_t> chunk = sizes;
  hsize_t row = 1;
  for (std::size_t i = sizes.size(); i-- > 0;) {
    chunk[i] = std::clamp<hsize_t>(kHdf5Chunk / row, 1, sizes[i]);
    row *= chunk[i];
  }
  return chunk;
}

Hdf5Handle dataset_properties(const std::vector<hsize_t>& sizes, Hdf5Layout layout) {
  Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (layout == Hdf5Layout::kChunks) {
    const std::vector<hsize_t> chunk = chunk_of(sizes);
    H5Pset_chunk(properties.id(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_fletcher32(properties.id());
  }
  H5Pset_fill_time(properties.id(), H5D_FILL_TIME_NEVER);
  H5Pset_obj_track_times(properties.id(), false);  // the same contents make the same file
  H5Pset_attr_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return properties;
}

}  // namespace

void fail_hdf5_writing(std::string_view place) {
  throw WriteError(place, fmt::format("cannot be written: {}", hdf5_reason()));
}

Hdf5Handle require_hdf5(Hdf5Handle handle, const std::string& place) {
  if (!handle.valid()) fail_hdf5_writing(place);
  return handle;
}

void close_hdf5(Hdf5Handle& handle, const std::string& place) {
  if (!handle.close()) fail_hdf5_writing(place);
}

void write_hdf5_text(hid_t object, const std::string& name, const std::string& value,
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

void write_hdf5_number(hid_t object, const std::string& name, double value,
                       const std::string& place) {
  write_attribute(object, name, H5T_NATIVE_DOUBLE, &value, place);
}

Hdf5Handle create_hdf5_dataset(hid_t group, const std::string& name, hid_t type,
                               const std::vector<hsize_t>& sizes, const std::string& place,
                               Hdf5Layout layout) {
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
                         H5Sclose);
  return require_hdf5({H5Dcreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT,
                                  dataset_properties(sizes, layout).id(), H5P_DEFAULT),
                       H5Dclose},
                      place);
}

Hdf5Handle write_hdf5_real(hid_t group, const std::string& name, std::span<const double> values,
                           const std::vector<hsize_t>& sizes, const std::string& place,
                           Hdf5Layout layout) {
  Hdf5Handle dataset = create_hdf5_dataset(group, name, H5T_IEEE_F64LE, sizes, place, layout);
  if (H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail_hdf5_writing(place);
  }
  return dataset;
}

Hdf5Memory::Hdf5Memory(const std::function<void(hid_t file)>& fill, const std::string& place,
                       Hdf5Layout layout) {
  const Hdf5Session session;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // From 1.10 on the index of chunks carries a checksum; all else does from 1.8 on.
  const bool whole = layout == Hdf5Layout::kWhole;
  H5Pset_libver_bounds(access.id(), whole ? H5F_LIBVER_V18 : H5F_LIBVER_V110,
                       whole ? H5F_LIBVER_V18 : H5F_LIBVER_LATEST);
  use_by(access.id());
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  Hdf5Handle file = require_hdf5(
      {H5Fcreate(kNowhere, H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose}, place);
  fill(file.id());
  close_hdf5(file, place);
}

/// Has the file of the access properties made here.
void Hdf5Memory::use_by(hid_t access) {
  H5Pset_fapl_core(access, kStepOfMemory, false);
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

// The superblock (version 2 or 3) has the end of the file.
std::string_view Hdf5Memory::bytes() const {
  constexpr std::size_t kPlaceOfEnd = 28;
  std::size_t end = 0;
  for (std::size_t i = 8; i-- > 0;) {
    end = end << 8U | static_cast<unsigned char>(bytes_.at(kPlaceOfEnd + i));
  }
  return std::string_view(bytes_).substr(0, end);
}

/// The library takes no exceptions.
void* Hdf5Memory::resized(std::size_t size, void* to) {
  std::string& bytes = static_cast<Hdf5Memory*>(to)->bytes_;
  try {
    if (size > bytes.capacity()) bytes.reserve(std::max(size, 2 * bytes.capacity()));
    bytes.resize(size);
  } catch (const std::exception&) {
    return nullptr;
  }
  return bytes.data();
}

}  // namespace microslip
