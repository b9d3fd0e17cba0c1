// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_handle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

std::recursive_mutex& library_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

/// The innermost failure comes first and says most.
herr_t take_first(unsigned, const H5E_error2_t* error, void* to) {
  *static_cast<std::string*>(to) = error->desc == nullptr ? "" : error->desc;
  return 1;
}

herr_t add_name(hid_t, const char* name, const H5L_info_t* link, void* to) {
  // External links could lead to any file of the machine.
  if (link->type == H5L_TYPE_HARD || link->type == H5L_TYPE_SOFT) {
    static_cast<std::vector<std::string>*>(to)->emplace_back(name);
  }
  return 0;
}

/// The name without the digits at its end, and their number.
std::pair<std::string_view, unsigned long long> split_number(std::string_view name) {
  const std::size_t digits = name.size() - 1 - name.find_last_not_of("0123456789");
  unsigned long long number = 0;
  const std::string_view tail = name.substr(name.size() - digits);
  std::from_chars(tail.data(), tail.data() + tail.size(), number);
  return {name.substr(0, name.size() - digits), number};
}

}  // namespace

Hdf5Session::Hdf5Session() : lock_(library_mutex()) {
  // A damaged file, or a full disk, can leave the library with something that it cannot close; at
  // the end of the process it would say so on standard error. All our files are closed by then.
  static const bool no_words_at_exit = H5dont_atexit() >= 0;
  (void)no_words_at_exit;
  H5Eget_auto2(H5E_DEFAULT, &print_, &print_to_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() { H5Eset_auto2(H5E_DEFAULT, print_, print_to_); }

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &reason);
  H5Eclear2(H5E_DEFAULT);
  return reason.empty() ? "other bytes" : fmt::format("'{}'", reason);
}

void fail_hdf5(std::string_view place, std::string_view expected) {
  throw FormatError({.file = std::string(place)}, expected, hdf5_reason(),
                    "The file is damaged; save or copy it again.");
}

Hdf5Handle hdf5_access() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
#if H5_VERSION_GE(1, 12, 1) || (H5_VERSION_GE(1, 10, 7) && !H5_VERSION_GE(1, 12, 0))
  H5Pset_file_locking(access.id(), false, true);
#endif
  return access;
}

Hdf5Handle open_hdf5(const std::string& path) {
  const Hdf5Handle access = hdf5_access();
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose);
  if (!file.valid()) {
    throw FormatError({.file = path}, "a whole HDF5 file", hdf5_reason(),
                      "It is another file, truncated or damaged; save or copy it again.");
  }
  return file;
}

std::vector<std::string> hdf5_members(hid_t group, std::string_view place) {
  std::vector<std::string> names;
  if (H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add_name, &names) < 0) {
    fail_hdf5(place, "a list of members");
  }
  std::ranges::sort(names, {}, split_number);
  return names;
}

Hdf5Handle open_hdf5_object(hid_t group, const std::string& name) {
  Hdf5Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (!object.valid()) H5Eclear2(H5E_DEFAULT);
  return object;
}

}  // namespace microslip
