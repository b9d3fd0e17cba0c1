// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_dates.hpp"

#include <cmath>

#include "microslip/io/bytes/byte_order.hpp"
#include "microslip/io/recordings/unitless_times.hpp"

namespace microslip {
namespace {

/// Whether doubles, which have 53 bits, hold times in seconds as finely as an axis must be even: to
/// 1e-6 of a step.
bool holds_steps(double first, double step) {
  constexpr double kExact = 9007199254740992.0;  // 2⁵³
  constexpr double kEvenTo = 1e-6;
  return std::abs(first) <= kExact && std::abs(first) <= kEvenTo * kExact * step;
}

}  // namespace

std::int64_t difference(std::int64_t later, std::int64_t earlier) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(later) -
                                   static_cast<std::uint64_t>(earlier));
}

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

WholeTimes whole_times(const WholeNumbers& whole, const std::string& unit,
                       const std::string& place) {
  const std::vector<std::int64_t>& numbers = whole.bits;
  WholeTimes times{.values = {}, .unit = unit};
  if (numbers.empty()) return times;
  const auto first = static_cast<double>(numbers.front());
  const double step =
      numbers.size() < 2 ? 0.0 : std::abs(static_cast<double>(difference(numbers[1], numbers[0])));
  const bool is_beyond = !whole.is_signed && numbers.front() < 0;
  const CountedUnit* const counted = unit.empty() && !is_beyond ? counted_unit(first) : nullptr;
  if (counted != nullptr) {
    times.unit = counted->unit;
    times.warning = since_1970(*counted, place);
  }
  const bool from_first = counted != nullptr || is_beyond || !holds_steps(first, step);
  const std::int64_t zero = from_first ? numbers.front() : 0;
  times.values.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    times.values.push_back(static_cast<double>(difference(number, zero)));
  }
  return times;
}

}  // namespace microslip
