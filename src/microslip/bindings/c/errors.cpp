// SPDX-License-Identifier: MIT
#include "microslip/bindings/c/errors.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>

#include "microslip/base/version.hpp"

namespace microslip::c {
namespace {

// Beyond the address space of any machine.
constexpr std::size_t kMostValues = std::size_t{1} << 44;
constexpr std::size_t kLargestStruct = 4096;  // ten times the largest: more was not initialised

/// Holds a constant text where there is no memory for another.
struct LastError {
  std::string text;
  const char* constant = "";
};

LastError& last_error() {
  thread_local LastError error;
  return error;
}

void keep(std::string_view text) noexcept {
  try {
    last_error().text = text;
    last_error().constant = nullptr;
  } catch (...) {
    last_error().constant = "no memory left";
  }
}

microslip_status failed(microslip_status status, std::string_view text) noexcept {
  keep(text);
  return status;
}

microslip_status no_memory() noexcept {
  last_error().constant = "no memory left";
  return MICROSLIP_MEMORY;
}

}  // namespace

microslip_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const InputError& error) {
    return failed(MICROSLIP_INPUT, error.what());
  } catch (const FormatError& error) {
    return failed(MICROSLIP_FORMAT, error.what());
  } catch (const FileError& error) {
    return failed(MICROSLIP_FILE, error.what());
  } catch (const Cancelled& error) {
    return failed(MICROSLIP_CANCELLED, error.what());
  } catch (const std::bad_alloc&) {
    return no_memory();
  } catch (const std::length_error&) {
    return no_memory();
  } catch (const std::exception& error) {
    return failed(MICROSLIP_INTERNAL, error.what());
  } catch (...) {
    return failed(MICROSLIP_INTERNAL, "an error without a text");
  }
}

microslip_status not_converged(std::string_view reason) {
  return failed(MICROSLIP_NOT_CONVERGED, fmt::format("not converged: {}", reason));
}

void require_pointer(const void* pointer, std::string_view name) {
  if (pointer == nullptr) throw InputError(name, InputState{"NULL"}, "must point to something");
}

double finite(double value, std::string_view name) {
  if (!std::isfinite(value)) throw InputError(name, value, "must be finite");
  return value;
}

double not_negative(double value, std::string_view name) {
  if (!(std::isfinite(value) && value >= 0.0)) {
    throw InputError(name, value, "must be 0 or more, and finite");
  }
  return value;
}

double positive(double value, std::string_view name) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw InputError(name, value, "must be positive and finite");
  }
  return value;
}

std::span<double> room(std::size_t count, double* pointer, std::string_view name) {
  if (count > kMostValues) {
    throw InputError(fmt::format("count of {}", name), fmt::format("{}", count),
                     "must be a number of values that fit in memory");
  }
  if (count > 0) require_pointer(pointer, name);
  return {pointer, count};
}

std::span<const double> values(std::size_t count, const double* pointer, std::string_view name) {
  // Looked at, not written.
  const std::span<const double> all = room(count, const_cast<double*>(pointer), name);
  const auto bad = std::find_if(all.begin(), all.end(), [](double x) { return !std::isfinite(x); });
  if (bad != all.end()) {
    throw InputError(fmt::format("{}[{}]", name, bad - all.begin()), *bad, "must be finite");
  }
  return all;
}

std::size_t index_below(std::size_t index, std::size_t count, std::string_view name) {
  if (index >= count) {
    throw InputError(name, fmt::format("{}", index),
                     fmt::format("must be below their number, {}", count));
  }
  return index;
}

void require_count(std::size_t count, std::size_t wanted, std::string_view name,
                   std::string_view of) {
  if (count != wanted) {
    throw InputError(name, fmt::format("{}", count),
                     fmt::format("must be the number of {}, {}", of, wanted));
  }
}

void throw_unknown(int value, std::string_view name) {
  throw InputError(name, static_cast<double>(value), "must be one of its enumeration");
}

void check_struct_size(std::size_t size, std::size_t least, std::size_t alignment,
                       std::string_view name) {
  if (size >= least && size <= kLargestStruct && size % alignment == 0) return;
  throw InputError(fmt::format("{}->struct_size", name), fmt::format("{}", size),
                   "must be the size of the struct",
                   "Set it to sizeof; fill options by their function of defaults.");
}

void check_unknown_members(const void* given, std::size_t size, std::size_t known,
                           std::string_view name) {
  const auto* bytes = static_cast<const unsigned char*>(given);
  for (std::size_t i = known; i < size; ++i) {
    if (bytes[i] == 0) continue;
    throw InputError(name, fmt::format("a struct of {} bytes", size),
                     "must not use members that this version of the library does not have",
                     fmt::format("It is version {}.", kVersion));
  }
}

Progress progress_of(microslip_progress progress, void* user) {
  if (progress == nullptr) return {};
  return [=](std::size_t done, std::size_t total) { return progress(done, total, user) != 0; };
}

}  // namespace microslip::c

const char* microslip_last_error(void) {
  const auto& error = microslip::c::last_error();
  return error.constant != nullptr ? error.constant : error.text.c_str();
}

const char* microslip_version(void) { return microslip::kVersion.data(); }
