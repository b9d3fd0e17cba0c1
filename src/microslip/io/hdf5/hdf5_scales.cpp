// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_scales.hpp"

#include "microslip/io/hdf5/hdf5_values.hpp"

namespace microslip {
namespace {

constexpr const char* kList = "DIMENSION_LIST";

/// A list of references for each dimension, of which the library holds the memory.
class ReferenceLists {
 public:
  ReferenceLists(hid_t attribute, std::size_t count)
      : space_(H5Aget_space(attribute), H5Sclose),
        element_(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose),
        lists_(count) {
    if (H5Sget_simple_extent_npoints(space_.id()) != static_cast<hssize_t>(count)) return;
    valid_ = H5Aread(attribute, element_.id(), lists_.data()) >= 0;
  }
  ReferenceLists(const ReferenceLists&) = delete;
  ReferenceLists& operator=(const ReferenceLists&) = delete;
  ~ReferenceLists() {
    if (valid_) H5Dvlen_reclaim(element_.id(), space_.id(), H5P_DEFAULT, lists_.data());
  }

  [[nodiscard]] bool valid() const { return valid_; }

  [[nodiscard]] std::vector<Hdf5Handle> open(hid_t dataset, std::size_t dimension) const {
    std::vector<Hdf5Handle> scales;
    auto* const references = static_cast<hobj_ref_t*>(lists_[dimension].p);
    for (std::size_t i = 0; i < lists_[dimension].len; ++i) {
      Hdf5Handle scale(H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, &references[i]), H5Oclose);
      if (scale.valid() && H5Iget_type(scale.id()) == H5I_DATASET) {
        scales.push_back(std::move(scale));
      }
    }
    H5Eclear2(H5E_DEFAULT);
    return scales;
  }

 private:
  Hdf5Handle space_;
  Hdf5Handle element_;
  std::vector<hvl_t> lists_;
  bool valid_ = false;
};

}  // namespace

haddr_t hdf5_address(hid_t object) {
  H5O_info_t info;
  return H5Oget_info2(object, &info, H5O_INFO_BASIC) >= 0 ? info.addr : HADDR_UNDEF;
}

bool is_hdf5_scale(hid_t dataset, const std::string& place) {
  return hdf5_text(dataset, "CLASS", place) == "DIMENSION_SCALE";
}

bool is_bare_dimension(hid_t dataset, const std::string& place) {
  const std::string name = hdf5_text(dataset, "NAME", place).value_or("");
  return name.starts_with("This is a netCDF dimension but not a netCDF variable");
}

std::vector<std::vector<Hdf5Handle>> hdf5_scales(hid_t dataset, const std::string& place) {
  const std::size_t rank = hdf5_sizes(dataset).size();
  std::vector<std::vector<Hdf5Handle>> scales(rank);
  if (rank == 0 || H5Aexists(dataset, kList) <= 0) return scales;
  const Hdf5Handle attribute(H5Aopen(dataset, kList, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) fail_hdf5(place, "the scales of its dimensions");
  const ReferenceLists lists(attribute.id(), rank);
  if (!lists.valid()) fail_hdf5(place, "the scales of its dimensions");
  for (std::size_t i = 0; i < rank; ++i) scales[i] = lists.open(dataset, i);
  return scales;
}

}  // namespace microslip
