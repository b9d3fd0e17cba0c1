// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// @file
/// The HDF5 library from C++: handles that close themselves, errors as exceptions. A place is
/// written `file:/group/dataset`.

namespace microslip {

/// While it lives, no other thread of microslip is inside the HDF5 library, which keeps global
/// state, and the library prints nothing.
class Hdf5Session {
 public:
  Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;
  ~Hdf5Session();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  H5E_auto2_t print_ = nullptr;
  void* print_to_ = nullptr;
};

/// Reason of the library for its last failure, in a few words.
[[nodiscard]] std::string hdf5_reason();

/// FormatError "place: expected …, found …" with the library's reason.
[[noreturn]] void fail_hdf5(std::string_view place, std::string_view expected);

/// Owns an identifier of the library.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close_by) : id_(id), close_(close_by) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { (void)close(); }

  [[nodiscard]] bool valid() const { return id_ >= 0; }
  [[nodiscard]] hid_t id() const { return id_; }
  /// False where the library could not finish what it had kept back.
  bool close() { return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Properties of access to a file without a lock. A file that is read is never written in place,
/// one that is written has a name of its own, and file systems without locks (Lustre, NFS) refuse.
[[nodiscard]] Hdf5Handle hdf5_access();

/// To be called in a reading process alone, see hdf5_reader.hpp.
/// @throws FormatError  where it is no HDF5 file, or a damaged one.
[[nodiscard]] Hdf5Handle open_hdf5(const std::string& path);

/// The names of the members of a group, those that end in numbers by number: x_2 before x_10.
[[nodiscard]] std::vector<std::string> hdf5_members(hid_t group, std::string_view place);

/// An object (dataset or group) with its place; invalid where the name leads nowhere.
[[nodiscard]] Hdf5Handle open_hdf5_object(hid_t group, const std::string& name);

}  // namespace microslip
