// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/io/hdf5/hdf5_handle.hpp"

/// @file
/// Writing of HDF5. Each `place` is that of the object, for messages. All throw WriteError where
/// the library does not do it, which in memory is for want of that.

namespace microslip {

/// Values of a chunk of a dataset at most.
inline constexpr hsize_t kHdf5Chunk = hsize_t{1} << 17U;

/// With the library's reason.
[[noreturn]] void fail_hdf5_writing(std::string_view place);

/// The handle, where it is valid.
[[nodiscard]] Hdf5Handle require_hdf5(Hdf5Handle handle, const std::string& place);

/// Buffered values are written upon closing.
void close_hdf5(Hdf5Handle& handle, const std::string& place);

/// Attributes. @throws InputError  for a text with a zero byte.
void write_hdf5_text(hid_t object, const std::string& name, const std::string& value,
                     const std::string& place);
void write_hdf5_number(hid_t object, const std::string& name, double value,
                       const std::string& place);

/// How a file and its datasets are laid out.
enum class Hdf5Layout {
  kChunks,  ///< of HDF5 1.10: chunks of values, and all that surrounds them, carry checksums
  kWhole,   ///< of HDF5 1.8, which older programs read: the values of a dataset carry no checksum
};

/// A dataset without values yet; attributes keep their order.
/// @param sizes  along each dimension, > 0.
[[nodiscard]] Hdf5Handle create_hdf5_dataset(hid_t group, const std::string& name, hid_t type,
                                             const std::vector<hsize_t>& sizes,
                                             const std::string& place,
                                             Hdf5Layout layout = Hdf5Layout::kChunks);

/// Creates a dataset of real numbers and writes its values, row by row.
[[nodiscard]] Hdf5Handle write_hdf5_real(hid_t group, const std::string& name,
                                         std::span<const double> values,
                                         const std::vector<hsize_t>& sizes,
                                         const std::string& place,
                                         Hdf5Layout layout = Hdf5Layout::kChunks);

/// The bytes of a file that the library makes in memory: of a file on a disk it would let errors
/// pass. The same contents make the same bytes.
class Hdf5Memory {
 public:
  /// @param fill   writes into the file, within a session. @param place  path of the file.
  Hdf5Memory(const std::function<void(hid_t file)>& fill, const std::string& place,
             Hdf5Layout layout = Hdf5Layout::kChunks);
  Hdf5Memory(const Hdf5Memory&) = delete;
  Hdf5Memory& operator=(const Hdf5Memory&) = delete;

  /// Without what was taken in advance.
  [[nodiscard]] std::string_view bytes() const;

 private:
  void use_by(hid_t access);
  static void* resized(std::size_t size, void* to);

  std::string bytes_;
};

}  // namespace microslip
