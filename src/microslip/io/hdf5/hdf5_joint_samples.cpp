// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_joint_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_foreign.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

std::string required_text(hid_t file, const char* name, const std::string& path) {
  if (std::optional<std::string> text = hdf5_text(file, name, path)) return *std::move(text);
  throw FormatError({.file = path}, fmt::format("the attribute '{}', a text", name), "none",
                    "The file is damaged, or another program changed it.");
}

std::vector<double> read_column(hid_t file, const SamplesColumn& column, const std::string& place,
                                std::vector<std::size_t>& sizes) {
  const Hdf5Handle dataset = open_hdf5_object(file, std::string(column.name));
  const bool is_dataset = dataset.valid() && H5Iget_type(dataset.id()) == H5I_DATASET;
  if (!is_dataset || hdf5_content(dataset.id()) != Hdf5Content::kReal) {
    fail_hdf5(place, "a dataset of numbers");
  }
  const std::vector<hsize_t> found = hdf5_sizes(dataset.id());
  if (found.size() != column.dimensions) {
    throw FormatError(
        {.file = place},
        fmt::format("{} dimension{}", column.dimensions, column.dimensions == 1 ? "" : "s"),
        fmt::format("{}", found.size()));
  }
  const std::optional<std::string> unit = hdf5_text(dataset.id(), "unit_str", place);
  if (unit != column.unit) {
    throw FormatError({.file = place}, fmt::format("the unit {}", column.unit),
                      unit ? in_quotes(*unit) : "none");
  }
  if (column.dimensions == 2) sizes.assign(found.begin(), found.end());
  std::vector<double> values;
  read_hdf5_real(dataset.id(), values, place);
  return values;
}

}  // namespace

RawSamples hdf5_joint_samples(const std::string& path, const Progress& on_progress) {
  const Hdf5Handle file = open_hdf5(path);
  Hdf5Progress progress(file.id(), on_progress);
  const std::optional<std::string> schema = hdf5_text(file.id(), "schema", path);
  if (schema != kSamplesKind) {
    throw FormatError({.file = path}, fmt::format("the schema {}", kSamplesKind),
                      schema ? in_quotes(*schema) : "none", "`identify` writes such a file.");
  }
  RawSamples samples;
  samples.method = required_text(file.id(), kSamplesMethod, path);
  samples.seed = required_text(file.id(), kSamplesSeed, path);
  samples.provenance = hdf5_text(file.id(), kSamplesProvenance, path).value_or("");
  const std::vector<std::string> members = hdf5_members(file.id(), path);
  for (const SamplesColumn& column : kSamplesColumns) {
    samples.columns.emplace_back();
    const std::string place = fmt::format("{}:/{}", path, column.name);
    if (std::ranges::find(members, column.name) == members.end()) {
      if (column.required) throw FormatError({.file = place}, "a dataset", "none");
      continue;
    }
    samples.columns.back() = read_column(file.id(), column, place, samples.sizes);
    progress.add(samples.columns.back().size());
  }
  for (const std::string& member : members) {
    if (std::ranges::find(kSamplesColumns, member, &SamplesColumn::name) == kSamplesColumns.end()) {
      throw FormatError({.file = path}, "datasets of draws alone", in_quotes(printable(member)));
    }
  }
  return samples;
}

}  // namespace microslip
