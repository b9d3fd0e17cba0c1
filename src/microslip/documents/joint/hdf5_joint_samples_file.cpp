// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <new>
#include <span>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/config/json_input.hpp"
#include "microslip/io/config/named_values_json.hpp"
#include "microslip/io/hdf5/hdf5_joint_samples.hpp"
#include "microslip/io/hdf5/hdf5_reader.hpp"
#include "microslip/io/hdf5/hdf5_writing.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip {
namespace {

/// The columns of kSamplesColumns in their order.
std::vector<std::span<const double>> columns_of(const JointSamples& samples) {
  std::span<const double> atom;
  if (samples.atom_slip_displacement) atom = {&*samples.atom_slip_displacement, 1};
  return {samples.slip_displacement, samples.stiffness_density, samples.stiffness, atom,
          samples.atom_weight,       samples.linear_damping,    samples.viscous};
}

void write_samples(hid_t file, const JointSamples& samples, const std::string& path) {
  write_hdf5_text(file, "schema", std::string(kSamplesKind), path);
  write_hdf5_text(file, kSamplesMethod, samples.method, path);
  write_hdf5_text(file, kSamplesSeed, fmt::format("{}", samples.seed), path);
  if (samples.provenance) {
    std::string text;
    append_named_values(text, provenance_values(*samples.provenance), "");
    write_hdf5_text(file, kSamplesProvenance, text, path);
  }
  const std::vector<std::span<const double>> columns = columns_of(samples);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) continue;
    const SamplesColumn& column = kSamplesColumns[i];
    const std::string place = fmt::format("{}:/{}", path, column.name);
    std::vector<hsize_t> sizes{columns[i].size()};
    if (column.dimensions == 2) sizes = {samples.size(), samples.slip_displacement.size()};
    Hdf5Handle dataset = write_hdf5_real(file, std::string(column.name), columns[i], sizes, place);
    write_hdf5_text(dataset.id(), "unit_str", std::string(column.unit), place);
    close_hdf5(dataset, place);
  }
}

std::uint64_t seed_of(const std::string& text, const std::string& path) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc() && end == text.data() + text.size() && !text.empty()) return seed;
  throw FormatError({.file = path}, "a whole number as the attribute 'seed'", in_quotes(text));
}

JointSamples samples_of(RawSamples raw, const std::string& path) {
  JointSamples samples;
  samples.method = std::move(raw.method);
  samples.seed = seed_of(raw.seed, path);
  if (!raw.provenance.empty()) {
    const Json json = parse_json(raw.provenance, path);
    (void)JsonObject(json, path, kSamplesProvenance);  // throws where it is no object
    samples.provenance = read_provenance(json);
  }
  std::vector<std::vector<double>>& columns = raw.columns;
  if (columns.size() != kSamplesColumns.size() || raw.sizes.size() != 2) {
    throw FormatError({.file = path}, "the datasets of draws", "others");
  }
  if (raw.sizes[0] != columns[2].size() || raw.sizes[1] != columns[0].size()) {
    throw FormatError({.file = path + ":/stiffness_density"},
                      fmt::format("{} × {} values, draws × slip displacements", columns[2].size(),
                                  columns[0].size()),
                      fmt::format("{} × {}", raw.sizes[0], raw.sizes[1]));
  }
  if (columns[3].size() > 1) {
    throw FormatError({.file = path + ":/atom_slip_displacement"}, "1 value",
                      fmt::format("{}", columns[3].size()));
  }
  samples.slip_displacement = std::move(columns[0]);
  samples.stiffness_density = std::move(columns[1]);
  samples.stiffness = std::move(columns[2]);
  if (!columns[3].empty()) samples.atom_slip_displacement = columns[3].front();
  samples.atom_weight = std::move(columns[4]);
  samples.linear_damping = std::move(columns[5]);
  samples.viscous = std::move(columns[6]);
  return samples;
}

}  // namespace

std::string joint_samples_bytes(const JointSamples& samples, const std::string& path) {
  samples.check();
  const Hdf5Memory memory([&](hid_t file) { write_samples(file, samples, path); }, path);
  return std::string(memory.bytes());
}

JointSamples read_joint_samples(const std::string& path) {
  if (path == "-") throw FileError("standard input", "cannot hold an HDF5 file", "Name a file.");
  (void)read_file_head(path, 1);  // says what hinders the reading better than the library does
  try {
    JointSamples samples = samples_of(read_hdf5_joint_samples(path), path);
    samples.check();
    return samples;
  } catch (const InputError& error) {
    throw error.renamed(fmt::format("{}: {}", path, error.name()));
  } catch (const std::bad_alloc&) {
    throw FileError(path, "does not fit into memory");
  }
}

}  // namespace microslip
