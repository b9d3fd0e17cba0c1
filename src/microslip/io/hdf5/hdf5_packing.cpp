// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_packing.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"

namespace microslip {
namespace {

constexpr std::array<std::string_view, 7> kPackingNames{"scale_factor",  "add_offset", "_FillValue",
                                                        "missing_value", "valid_min",  "valid_max",
                                                        "valid_range"};

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

}  // namespace

Hdf5Packing hdf5_packing(hid_t dataset, const std::string& place) {
  Hdf5Packing packing;
  packing.scale_factor = hdf5_number(dataset, "scale_factor", place).value_or(1.0);
  packing.add_offset = hdf5_number(dataset, "add_offset", place).value_or(0.0);
  packing.least = hdf5_number(dataset, "valid_min", place);
  packing.greatest = hdf5_number(dataset, "valid_max", place);
  const std::vector<double> range = hdf5_numbers(dataset, "valid_range", place);
  if (range.size() == 2) {
    packing.least = range[0];
    packing.greatest = range[1];
  }
  if (const auto fill = fill_value_of(dataset)) packing.missing.push_back(*fill);
  for (const char* name : {"_FillValue", "missing_value"}) {
    const std::vector<double> values = hdf5_numbers(dataset, name, place);
    packing.missing.insert(packing.missing.end(), values.begin(), values.end());
  }
  if (is_single_precision(dataset)) {  // an attribute may give the same number with more digits
    for (double& value : packing.missing) value = static_cast<float>(value);
  }
  return packing;
}

void unpack(const Hdf5Packing& packing, std::vector<double>& values) {
  const auto is_missing = [&](double stored) {
    return std::ranges::find(packing.missing, stored) != packing.missing.end() ||
           (packing.least && stored < *packing.least) ||
           (packing.greatest && stored > *packing.greatest);
  };
  const bool plain = packing.scale_factor == 1.0 && packing.add_offset == 0.0;
  if (plain && packing.missing.empty() && !packing.least && !packing.greatest) return;
  for (double& value : values) {
    if (is_missing(value)) {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (!plain) {
      value = value * packing.scale_factor + packing.add_offset;
    }
  }
}

bool is_packing_attribute(const std::string& name) {
  return std::ranges::find(kPackingNames, name) != kPackingNames.end();
}

}  // namespace microslip
