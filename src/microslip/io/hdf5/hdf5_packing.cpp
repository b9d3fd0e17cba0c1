// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_scales.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"

namespace microslip {
namespace {

constexpr std::array kPackingNames{"scale_factor", "add_offset", "valid_min", "valid_max",
                                   "valid_range"};
constexpr std::array kMissingNames{"_FillValue", "missing_value"};

/// Of the dataset itself. 0 is the usual one of HDF5 and what a sensor at rest gives.
std::optional<double> fill_value_of(hid_t dataset) {
  const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose);
  H5D_fill_value_t kind = H5D_FILL_VALUE_UNDEFINED;
  double value = 0.0;
  const bool defined = properties.valid() && H5Pfill_value_defined(properties.id(), &kind) >= 0 &&
                       kind == H5D_FILL_VALUE_USER_DEFINED &&
                       H5Pget_fill_value(properties.id(), H5T_NATIVE_DOUBLE, &value) >= 0;
  H5Eclear2(H5E_DEFAULT);
  return defined && value != 0.0 ? std::optional(value) : std::nullopt;
}

/// What the library of netCDF puts where nothing was written: NC_FILL_… of its netcdf.h; bytes have
/// none.
std::optional<double> fill_value_of_netcdf(hid_t type) {
  if (H5Tget_class(type) == H5T_FLOAT) return 9.9692099683868690e+36;
  if (H5Tget_class(type) != H5T_INTEGER) return std::nullopt;
  const bool is_unsigned = H5Tget_sign(type) == H5T_SGN_NONE;
  switch (H5Tget_size(type)) {
    case sizeof(std::int16_t):
      return is_unsigned ? 65535.0 : -32767.0;
    case sizeof(std::int32_t):
      return is_unsigned ? 4294967295.0 : -2147483647.0;
    case sizeof(std::int64_t):  // as doubles, which is how values are compared
      return is_unsigned ? 18446744073709551614.0 : -9223372036854775806.0;
    default:
      return std::nullopt;
  }
}

H5T_class_t class_of(const Hdf5Handle& type) {
  return type.valid() ? H5Tget_class(type.id()) : H5T_NO_CLASS;
}

bool is_float_attribute(hid_t dataset, const std::string& name) {
  const Hdf5Handle attribute(H5Aopen(dataset, name.c_str(), H5P_DEFAULT), H5Aclose);
  return attribute.valid() &&
         class_of(Hdf5Handle(H5Aget_type(attribute.id()), H5Tclose)) == H5T_FLOAT;
}

/// As a dataset of single precision stores it; infinite where it cannot.
double in_single_precision(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (std::abs(value) > kLargest) {
    return std::copysign(std::numeric_limits<double>::infinity(), value);
  }
  return static_cast<double>(static_cast<float>(value));
}

void read_range(hid_t dataset, const std::string& place, Hdf5Packing& packing) {
  const auto mark = [&](const char* name) -> std::optional<Hdf5Mark> {
    const std::optional<double> number = hdf5_number(dataset, name, place);
    return number ? std::optional(Hdf5Mark{*number, name}) : std::nullopt;
  };
  packing.least = mark("valid_min");
  packing.greatest = mark("valid_max");
  const std::vector<double> range = hdf5_numbers(dataset, "valid_range", place);
  if (range.size() == 2) {
    packing.least = {range[0], "the least of valid_range"};
    packing.greatest = {range[1], "the greatest of valid_range"};
  }
}

/// Why a number stands for no value; empty where it does.
std::string reason_of_missing(const Hdf5Packing& packing, double stored, double value) {
  for (const Hdf5Mark& mark : packing.missing) {
    if (stored == mark.number) return fmt::format("{} is the {}", stored, mark.name);
  }
  const double number = packing.range_of_values ? value : stored;
  if (packing.least && number < packing.least->number) {
    return fmt::format("{} is below {}, {}", number, packing.least->number, packing.least->name);
  }
  if (packing.greatest && number > packing.greatest->number) {
    return fmt::format("{} is above {}, {}", number, packing.greatest->number,
                       packing.greatest->name);
  }
  return {};
}

}  // namespace

Hdf5Packing hdf5_packing(hid_t dataset, const std::string& place, bool netcdf) {
  Hdf5Packing packing;
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const bool integers = class_of(type) == H5T_INTEGER;
  packing.applies = integers || netcdf || H5Aexists(dataset, "DIMENSION_LIST") > 0 ||
                    is_hdf5_scale(dataset, place);
  if (packing.applies) {
    const std::optional<double> factor = hdf5_number(dataset, "scale_factor", place);
    const std::optional<double> offset = hdf5_number(dataset, "add_offset", place);
    packing.scale_factor = factor.value_or(1.0);
    packing.add_offset = offset.value_or(0.0);
    read_range(dataset, place, packing);
    const std::optional<Hdf5Mark>& bound = packing.least ? packing.least : packing.greatest;
    const std::string name = bound && bound->name.starts_with("the ") ? "valid_range"
                             : bound                                  ? bound->name
                                                                      : "";
    packing.range_of_values =
        integers && (factor || offset) && bound && is_float_attribute(dataset, name);
  }
  if (const auto fill = fill_value_of(dataset)) {
    packing.missing.push_back({*fill, "fill value of the dataset"});
  } else if (const auto usual = fill_value_of_netcdf(type.id());
             usual && netcdf && H5Aexists(dataset, "_FillValue") <= 0) {
    packing.missing.push_back({*usual, "fill value of netCDF"});
  }
  for (const char* name : kMissingNames) {
    for (const double value : hdf5_numbers(dataset, name, place)) {
      packing.missing.push_back({value, name});
    }
  }
  if (is_single_precision(dataset)) {  // an attribute may give the same number with more digits
    for (Hdf5Mark& mark : packing.missing) mark.number = in_single_precision(mark.number);
    for (std::optional<Hdf5Mark>* bound : {&packing.least, &packing.greatest}) {
      if (*bound) (*bound)->number = in_single_precision((*bound)->number);
    }
  }
  return packing;
}

std::string unpack(const Hdf5Packing& packing, std::vector<double>& values) {
  const bool plain = packing.scale_factor == 1.0 && packing.add_offset == 0.0;
  std::string first;
  if (plain && packing.missing.empty() && !packing.least && !packing.greatest) return first;
  for (double& value : values) {
    const double unpacked = plain ? value : value * packing.scale_factor + packing.add_offset;
    std::string reason = reason_of_missing(packing, value, unpacked);
    value = reason.empty() ? unpacked : std::numeric_limits<double>::quiet_NaN();
    if (first.empty()) first = std::move(reason);
  }
  return first;
}

bool is_packing_attribute(const std::string& name) {
  return std::ranges::find(kPackingNames, name) != kPackingNames.end();
}

bool is_missing_attribute(const std::string& name) {
  return std::ranges::find(kMissingNames, name) != kMissingNames.end();
}

std::string packing_attributes(hid_t dataset) {
  std::string names;
  for (const char* name : kPackingNames) {
    if (H5Aexists(dataset, name) > 0) names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

}  // namespace microslip
