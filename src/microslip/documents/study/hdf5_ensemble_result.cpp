// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/version.hpp"
#include "microslip/documents/study/ensemble_result_file.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_writing.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/provenance.hpp"

namespace microslip {
namespace {

constexpr std::size_t kColumns = 8;
constexpr const char* kColumnNames = "count, mean, std, minimum, lower, median, upper, maximum";

std::string lines_of(const std::vector<std::string>& lines) {
  return fmt::format("{}", fmt::join(lines, "\n"));
}

void write_dataset(hid_t group, const std::string& name, const std::vector<double>& values,
                   const std::vector<hsize_t>& sizes, const Dimension& dimension,
                   const std::string& place,
                   const std::vector<std::pair<const char*, std::string>>& attributes) {
  Hdf5Handle dataset = write_hdf5_real(group, name, values, sizes, place);
  write_hdf5_text(dataset.id(), "unit_str", si_unit(dimension), place);
  for (const auto& [key, text] : attributes) write_hdf5_text(dataset.id(), key, text, place);
  close_hdf5(dataset, place);
}

std::vector<double> columns_of(const GroupResult& group, std::size_t first, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = first; i < first + count; ++i) {
    const ColumnStatistics& s = group.values[i];
    const std::array<double, kColumns> row{static_cast<double>(s.count),
                                           s.mean,
                                           s.std,
                                           s.minimum,
                                           s.lower,
                                           s.median,
                                           s.upper,
                                           s.maximum};
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

/// Rows of some columns of all jobs, written piece by piece.
class ValuesWriter {
 public:
  ValuesWriter(hid_t group, const EnsembleOutput& output, std::uint64_t jobs, std::string place)
      : width_(output.size()), jobs_(jobs), place_(std::move(place)) {
    dataset_ = create_hdf5_dataset(group, output.name + " values", H5T_IEEE_F64LE, {jobs_, width_},
                                   place_);
    write_hdf5_text(dataset_.id(), "unit_str", si_unit(output.dimension), place_);
    rows_at_once_ = std::max<hsize_t>(1, kHdf5Chunk / width_);
  }

  void take(std::span<const double> values) {
    values_.insert(values_.end(), values.begin(), values.end());
    if (values_.size() >= rows_at_once_ * width_) flush();
  }

  void close() {
    flush();
    close_hdf5(dataset_, place_);
  }

 private:
  void flush() {
    if (values_.empty()) return;
    const std::array<hsize_t, 2> start{written_, 0};
    const std::array<hsize_t, 2> count{values_.size() / width_, width_};
    const Hdf5Handle file_space(H5Dget_space(dataset_.id()), H5Sclose);
    const Hdf5Handle memory_space(H5Screate_simple(2, count.data(), nullptr), H5Sclose);
    H5Sselect_hyperslab(file_space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                        nullptr);
    if (H5Dwrite(dataset_.id(), H5T_NATIVE_DOUBLE, memory_space.id(), file_space.id(), H5P_DEFAULT,
                 values_.data()) < 0) {
      fail_hdf5_writing(place_);
    }
    written_ += count[0];
    values_.clear();
  }

  hsize_t width_;
  hsize_t jobs_;
  hsize_t written_ = 0;
  hsize_t rows_at_once_ = 1;
  std::string place_;
  Hdf5Handle dataset_;
  std::vector<double> values_;
};

/// Assumptions and warnings, a line each.
std::string notes_of(const EnsembleResult& result) {
  const std::string notes = lines_of(result.notes);
  const std::string warnings = warning_lines(result.warnings);
  return notes.empty() || warnings.empty() ? notes + warnings : notes + '\n' + warnings;
}

class ResultWriter {
 public:
  ResultWriter(const EnsembleResult& result,
               const std::function<RowPass(std::size_t group)>& rows_of, const std::string& path)
      : result_(result), rows_of_(rows_of), path_(path) {}

  void write(hid_t file) const {
    write_hdf5_text(file, "schema", std::string(kEnsembleKind), path_);
    write_hdf5_text(file, "version", std::string(kVersion), path_);
    write_hdf5_text(file, "kind", result_.kind, path_);
    write_hdf5_text(file, "seed", fmt::format("{}", result_.seed), path_);
    write_hdf5_number(file, "confidence", result_.confidence, path_);
    write_hdf5_text(file, "fingerprint", lines_of(result_.fingerprint), path_);
    write_hdf5_text(file, "notes", notes_of(result_), path_);
    write_hdf5_text(file, "plan", result_.plan, path_);
    for (std::size_t g = 0; g < result_.groups.size(); ++g) write_group(file, g);
  }

 private:
  void write_group(hid_t file, std::size_t number) const {
    const GroupResult& result = result_.groups[number];
    const std::string place = fmt::format("{}:/{}", path_, result.group.name);
    const Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.id(), false);
    H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    Hdf5Handle group = require_hdf5(
        {H5Gcreate2(file, result.group.name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
         H5Gclose},
        place);
    write_hdf5_number(group.id(), "jobs", static_cast<double>(result.group.jobs), place);
    write_failures(group.id(), result.failed, place);
    for (std::size_t a = 0; a < result.group.grid.size(); ++a) {
      const SweepAxis& axis = result.group.grid[a];
      write_dataset(group.id(), fmt::format("grid {}", a + 1), axis.values, {axis.values.size()},
                    kDimensionless, place, {{"number", axis.number}});
    }
    std::size_t first = 0;
    for (const EnsembleOutput& output : result.group.outputs) {
      write_output(group.id(), result, output, first, place);
      first += output.size();
    }
    write_values(group.id(), number, place);
    close_hdf5(group, place);
  }

  static void write_failures(hid_t group, const FailedJobs& failed, const std::string& place) {
    write_hdf5_number(group, "failed", static_cast<double>(failed.count), place);
    if (failed.count == 0) return;
    std::vector<std::string> reasons;
    for (const FailedJobs::Reason& reason : failed.reasons) {
      reasons.push_back(
          fmt::format("{} jobs, first number {}: {}", reason.count, reason.first, reason.text));
    }
    std::string text = lines_of(reasons);
    std::ranges::replace(text, '\0', ' ');
    write_hdf5_text(group, "reasons", text, place);
    const std::vector<double> numbers(failed.jobs.begin(), failed.jobs.end());
    write_dataset(group, "failed jobs", numbers, {numbers.size()}, kDimensionless, place, {});
  }

  static void write_output(hid_t group, const GroupResult& result, const EnsembleOutput& output,
                           std::size_t first, const std::string& place) {
    write_dataset(group, output.name, columns_of(result, first, output.size()),
                  {output.size(), kColumns}, output.dimension, place, {{"columns", kColumnNames}});
    if (output.axis.empty()) return;
    write_dataset(group, output.name + " axis", output.axis, {output.axis.size()},
                  output.axis_dimension, place, {{"name", output.axis_name}});
  }

  /// All outputs that are kept in one pass over the jobs.
  void write_values(hid_t group, std::size_t number, const std::string& place) const {
    const EnsembleGroup& planned = result_.groups[number].group;
    std::vector<std::pair<std::size_t, ValuesWriter>> writers;  // first column of each
    std::vector<std::size_t> sizes;
    std::size_t first = 0;
    for (const EnsembleOutput& output : planned.outputs) {
      if (result_.keeps(output)) {
        writers.emplace_back(first, ValuesWriter(group, output, planned.jobs, place));
        sizes.push_back(output.size());
      }
      first += output.size();
    }
    if (writers.empty()) return;
    rows_of_(number)([&](std::span<const double> row) {
      for (std::size_t w = 0; w < writers.size(); ++w) {
        writers[w].second.take(row.subspan(writers[w].first, sizes[w]));
      }
    });
    for (auto& [column, writer] : writers) writer.close();
  }

  const EnsembleResult& result_;
  const std::function<RowPass(std::size_t group)>& rows_of_;
  const std::string& path_;
};

Hdf5Handle created(const std::string& path, const std::string& name) {
  const Hdf5Handle access = hdf5_access();
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  return require_hdf5(
      {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose}, name);
}

/// Reads all datasets back: their check sums, and that the disk has them all. The library lets some
/// errors of a full disk pass.
void verify(const std::string& path, const std::string& name) {
  const Hdf5Handle access = hdf5_access();
  const Hdf5Handle file =
      require_hdf5({H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose}, name);
  const auto read = [](hid_t group, const char* member, const H5O_info_t* info, void*) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const Hdf5Handle dataset(H5Dopen2(group, member, H5P_DEFAULT), H5Dclose);
    const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
    std::array<hsize_t, 2> sizes{1, 1};
    if (H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr) < 0) return -1;
    const hsize_t rows = std::max<hsize_t>(1, kHdf5Chunk / sizes[1]);
    std::vector<double> values(rows * sizes[1]);
    for (hsize_t from = 0; from < sizes[0]; from += rows) {
      const std::array<hsize_t, 2> start{from, 0};
      const std::array<hsize_t, 2> count{std::min(rows, sizes[0] - from), sizes[1]};
      const Hdf5Handle memory(H5Screate_simple(2, count.data(), nullptr), H5Sclose);
      H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
      const hsize_t total = count[0] * count[1];
      const Hdf5Handle flat(H5Screate_simple(1, &total, nullptr), H5Sclose);
      if (H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, flat.id(), space.id(), H5P_DEFAULT,
                  values.data()) < 0) {
        return -1;
      }
    }
    return 0;
  };
  if (H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_INC, read, nullptr, H5O_INFO_BASIC) < 0) {
    fail_hdf5_writing(name);
  }
}

}  // namespace

void add_ensemble_result(const EnsembleResult& result,
                         const std::function<RowPass(std::size_t group)>& rows_of,
                         const std::string& path, OutputFiles& outputs) {
  const std::string staged = outputs.stage(path);
  const Hdf5Session session;
  Hdf5Handle file = created(staged, path);
  ResultWriter(result, rows_of, path).write(file.id());
  close_hdf5(file, path);
  verify(staged, path);
}

}  // namespace microslip
