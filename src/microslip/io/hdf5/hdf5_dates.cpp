// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_dates.hpp"

#include "microslip/io/bytes/byte_order.hpp"

namespace microslip {

bool is_large_integer(hid_t type) {
  return H5Tget_class(type) == H5T_INTEGER && H5Tget_size(type) == sizeof(std::int64_t);
}

hid_t large_integer_in_memory(hid_t type) {
  return H5Tget_sign(type) == H5T_SGN_NONE ? H5T_NATIVE_UINT64 : H5T_NATIVE_INT64;
}

std::optional<Hdf5Time> hdf5_time(hid_t type) {
  if (H5Tget_class(type) != H5T_TIME) return std::nullopt;
  for (const Hdf5Time& time :
       {Hdf5Time{H5T_UNIX_D32LE, false, false}, Hdf5Time{H5T_UNIX_D64LE, true, false},
        Hdf5Time{H5T_UNIX_D32BE, false, true}, Hdf5Time{H5T_UNIX_D64BE, true, true}}) {
    if (H5Tequal(type, time.type) > 0) return time;
  }
  return std::nullopt;
}

std::int64_t time_in_nanoseconds(std::int64_t bits, const Hdf5Time& time) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  constexpr std::int64_t kMicrosecond = 1'000;
  if (time.is_pair && time.is_big) bits = byte_swapped(bits);
  auto lower = static_cast<std::int32_t>(bits);
  if (!time.is_pair && time.is_big) lower = byte_swapped(lower);
  return time.is_pair ? kSecond * (bits >> 32) + kMicrosecond * lower : kSecond * lower;
}

std::vector<double> seconds_from_first(std::span<const std::int64_t> nanoseconds) {
  constexpr double kNanosecond = 1e-9;
  std::vector<double> seconds;
  seconds.reserve(nanoseconds.size());
  for (const std::int64_t date : nanoseconds) {
    seconds.push_back(kNanosecond * static_cast<double>(difference(date, nanoseconds.front())));
  }
  return seconds;
}

}  // namespace microslip
