// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <microslip.h>
#include "microslip/base/error.hpp"
#include "microslip/base/progress.hpp"

/// @file
/// The boundary of the C interface: checks what crosses it, and stops exceptions.

namespace microslip::c {

/// Status of the exception that is being handled; keeps its text for the thread.
[[nodiscard]] microslip_status status_of_exception() noexcept;

/// Keeps the text for the thread. @return MICROSLIP_NOT_CONVERGED.
[[nodiscard]] microslip_status not_converged(std::string_view reason);

/// Runs the body of a function of the interface.
template <typename Body>
microslip_status guarded(const Body& body) noexcept {
  try {
    return body();
  } catch (...) {
    return status_of_exception();
  }
}

/// Runs a body that returns no status.
template <typename Body>
microslip_status done(const Body& body) noexcept {
  return guarded([&] {
    body();
    return MICROSLIP_OK;
  });
}

/// @throws InputError  where the pointer is NULL.
void require_pointer(const void* pointer, std::string_view name);

/// Returns the object of the pointer. @throws InputError  where it is NULL.
template <typename T>
T& at(T* pointer, std::string_view name) {
  require_pointer(pointer, name);
  return *pointer;
}

/// @throws InputError  unless it is finite.
double finite(double value, std::string_view name);

/// @throws InputError  unless it is finite, and 0 or more.
double not_negative(double value, std::string_view name);

/// @throws InputError  unless it is finite and above 0.
double positive(double value, std::string_view name);

/// An array of the caller. @throws InputError  for more values than fit in any memory; where the
/// pointer is NULL and there are values; naming the first value that is not finite.
std::span<const double> values(std::size_t count, const double* pointer, std::string_view name);

/// An array for results. @throws InputError  as for input(), whatever its values.
std::span<double> room(std::size_t count, double* pointer, std::string_view name);

/// @throws InputError  unless `index` is below `count`.
std::size_t index_below(std::size_t index, std::size_t count, std::string_view name);

/// @throws InputError  unless `count` is `wanted`.
void require_count(std::size_t count, std::size_t wanted, std::string_view name,
                   std::string_view of);

/// The error of an enumeration that has an unknown value.
[[noreturn]] void throw_unknown(int value, std::string_view name);

/// @throws InputError  unless a struct of the caller has this size at least, 4 KiB at most, and one
/// of which an array can be made.
void check_struct_size(std::size_t size, std::size_t least, std::size_t alignment,
                       std::string_view name);

/// @throws InputError  where a later version knows a member beyond `known` that is not 0.
void check_unknown_members(const void* given, std::size_t size, std::size_t known,
                           std::string_view name);

/// Options of the caller, who may know fewer members or more than this library. The first version
/// of a struct is its smallest: where members are added, `least` becomes the size without them.
template <typename T>
T read_struct(const T* given, const T& defaults, std::string_view name,
              std::size_t least = sizeof(T)) {
  if (given == nullptr) return defaults;
  const std::size_t size = given->struct_size;
  check_struct_size(size, least, alignof(T), name);
  check_unknown_members(given, size, sizeof(T), name);
  T all = defaults;
  std::memcpy(&all, given, std::min(size, sizeof(T)));
  return all;
}

/// Fills a struct of the caller, who may know fewer members or more, which are set to 0.
template <typename T>
void write_struct(const T& from, T* to, std::size_t size, std::string_view name,
                  std::size_t least = sizeof(T)) {
  require_pointer(to, name);
  check_struct_size(size, least, alignof(T), name);
  std::memset(static_cast<void*>(to), 0, size);
  std::memcpy(static_cast<void*>(to), &from, std::min(size, sizeof(T)));
  to->struct_size = size;
}

/// The progress callback of the caller; an empty function where there is none.
[[nodiscard]] Progress progress_of(microslip_progress progress, void* user);

}  // namespace microslip::c
