// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/mat_text.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_foreign.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"

namespace microslip {
namespace {

constexpr std::array<std::string_view, 11> kNumberClasses{"double", "single", "int8",   "uint8",
                                                          "int16",  "uint16", "int32",  "uint32",
                                                          "int64",  "uint64", "logical"};

/// How a sparse matrix lies in a group.
struct SparseNames {
  const char* row;
  const char* start;
};
constexpr SparseNames kOfMatlab{"ir", "jc"};
constexpr SparseNames kOfSciPy{"indices", "indptr"};
constexpr SparseNames kOfOctave{"ridx", "cidx"};
constexpr const char* kSparseRows = "MATLAB_sparse";

/// The largest whole number up to which a double has all.
constexpr double kLargestIndex = 9007199254740992.0;

class Mat73Reader {
 public:
  Mat73Reader(std::string path, const MatReadOptions& options, hid_t file)
      : path_(std::move(path)), options_(options), file_(file), progress_(file, options.progress) {}

  MatTree read() {
    MatTree tree;
    tree.root.kind = MatValue::Kind::kStruct;
    tree.root.sizes = {1, 1};
    tree.root.in_order = false;
    if (!options_.only && is_of_scipy(file_)) {
      tree.root = read_group(file_, path_, 0);
      return tree;
    }
    for (const std::string& name : hdf5_members(file_, path_)) {
      if (name.starts_with('#')) continue;  // #refs#, #subsystem#
      MatValue value;
      if (!options_.only || *options_.only == name) {
        value = read_object(open_hdf5_object(file_, name), path_ + ":/" + printable(name), 0);
      }
      tree.root.fields.push_back(name);
      tree.root.children.push_back(std::move(value));
    }
    return tree;
  }

 private:
  void count_value(const std::string& place, int depth) {
    if (depth <= kDeepestMatValue && ++values_ <= kMostMatValues) return;
    throw FormatError(
        {.file = place},
        fmt::format("at most {} arrays, nested {} deep", kMostMatValues, kDeepestMatValue), "more",
        "The file is damaged; save or copy it again.");
  }

  MatValue read_object(const Hdf5Handle& object, const std::string& place, int depth) {
    count_value(place, depth);
    if (!object.valid()) fail_hdf5(place, "a variable");
    const H5I_type_t type = H5Iget_type(object.id());
    if (type != H5I_GROUP && type != H5I_DATASET) fail_hdf5(place, "a group or a dataset");
    const std::string name = hdf5_text(object.id(), "MATLAB_class", place).value_or("");
    if (type == H5I_GROUP && is_octave_variable(object.id())) {
      return read_octave(object.id(), place, depth);
    }
    if (type == H5I_GROUP) return read_group(object.id(), place, depth);
    MatValue value;
    value.sizes = sizes_of(object.id(), place);
    const bool empty = hdf5_number(object.id(), "MATLAB_empty", place).value_or(0.0) != 0.0;
    if (empty) value.sizes = {0, 0};
    if (name == "struct" || (name.empty() && empty)) {
      value.kind = MatValue::Kind::kStruct;
      if (value.count() > kMostMatValues) count_value(place, kDeepestMatValue + 1);
    } else if (name == "cell") {
      value.kind = MatValue::Kind::kCell;
      if (!empty) value.children = read_references(object.id(), value.count(), place, depth);
    } else if (name == "char") {
      value.kind = MatValue::Kind::kText;
      if (!empty) read_text(object.id(), value, place);
    } else if (std::ranges::find(kNumberClasses, name) != kNumberClasses.end()) {
      value.kind = MatValue::Kind::kNumbers;
      if (!empty) read_numbers(object.id(), value, place);
    } else if (const Hdf5Content content = hdf5_content(object.id());
               name.empty() &&
               (content == Hdf5Content::kReal || content == Hdf5Content::kComplex)) {
      value.kind = MatValue::Kind::kNumbers;
      read_numbers(object.id(), value, place);
    } else {
      value.kind = MatValue::Kind::kOther;
      value.other = name.empty() ? "a dataset without MATLAB_class" : other_class(name);
    }
    return value;
  }

  /// In MATLAB's order: HDF5 counts the dimensions in reverse.
  static std::vector<std::size_t> sizes_of(hid_t dataset, const std::string& place) {
    const std::vector<hsize_t> sizes = hdf5_sizes(dataset);
    (void)check_hdf5_storage(dataset, place);
    std::vector<std::size_t> result(sizes.rbegin(), sizes.rend());
    while (result.size() < 2) result.push_back(1);
    return result;
  }

  /// A variable of Octave: what it is, as a text, and its value, a dataset or a group.
  MatValue read_octave(hid_t group, const std::string& place, int depth) {
    const Hdf5Handle type_set = open_hdf5_object(group, "type");
    const Hdf5Handle value_object = open_hdf5_object(group, "value");
    if (!type_set.valid() || H5Iget_type(type_set.id()) != H5I_DATASET) fail_hdf5(place, "a type");
    if (!value_object.valid()) fail_hdf5(place, "a value");
    const std::string type = hdf5_text_of_dataset(type_set.id(), place);
    const hid_t id = value_object.id();
    if (H5Iget_type(id) == H5I_GROUP) return read_octave_group(id, type, place, depth);
    if (H5Iget_type(id) != H5I_DATASET) fail_hdf5(place, "a value");
    MatValue value;
    const Hdf5Content content = hdf5_content(id);
    if (type.ends_with("range")) return read_octave_range(id, place);
    value.sizes = sizes_of(id, place);
    const bool empty = H5Aexists(group, "OCTAVE_EMPTY_MATRIX") > 0;  // its sizes are the values
    if (empty) value.sizes = {0, 0};
    if (type == "cell") {  // an empty one: others are groups
      value.kind = MatValue::Kind::kCell;
      value.sizes = {0, 0};
    } else if (type == "string" || type == "sq_string") {
      value.kind = MatValue::Kind::kText;
      if (!empty) read_octave_text(id, value, place);
    } else if (content == Hdf5Content::kReal || content == Hdf5Content::kComplex) {
      value.kind = MatValue::Kind::kNumbers;
      if (!empty) read_numbers(id, value, place);
    } else {
      value.kind = MatValue::Kind::kOther;
      value.other = fmt::format("a value of the type {}", in_quotes(type));
    }
    return value;
  }

  MatValue read_octave_group(hid_t group, const std::string& type, const std::string& place,
                             int depth) {
    if (type.starts_with("sparse ")) {
      MatValue value = read_sparse(group, kOfOctave, place);
      value.sizes = {sparse_rows_of_octave(group, place), value.column_start.size() - 1};
      return checked(std::move(value), place);
    }
    if (type == "scalar struct") return read_struct(group, place, depth);
    if (type == "struct") return read_octave_structs(group, place, depth);
    MatValue value;
    value.sizes = {1, 1};
    if (type == "cell") {
      value.kind = MatValue::Kind::kCell;
      for (std::size_t i = 0; has_member(group, fmt::format("_{}", i).c_str()); ++i) {
        const std::string name = fmt::format("_{}", i);
        value.children.push_back(
            read_object(open_hdf5_object(group, name), place + "/" + name, depth + 1));
      }
      value.sizes = sizes_of_cell(group, value.children.size(), place);
      return value;
    }
    value.kind = MatValue::Kind::kOther;
    value.other = fmt::format("a value of the type {}", in_quotes(type));
    return value;
  }

  /// Its dimensions stand beside the elements.
  static std::vector<std::size_t> sizes_of_cell(hid_t group, std::size_t count,
                                                const std::string& place) {
    if (!has_member(group, "dims")) return {1, count};
    MatValue value;
    for (const std::int64_t size : read_indices(group, "dims", place)) {
      value.sizes.push_back(static_cast<std::size_t>(size));
    }
    if (value.sizes.size() < 2 || value.count() != count) {
      fail_hdf5(place, fmt::format("dimensions of {} elements", count));
    }
    return value.sizes;
  }

  /// Each field is a cell of its value in each element.
  MatValue read_octave_structs(hid_t group, const std::string& place, int depth) {
    MatValue columns = read_struct(group, place, depth);
    if (columns.fields.empty()) return columns;
    std::optional<MatValue> value = structs_of_columns(std::move(columns));
    if (!value) fail_hdf5(place, "fields that are cells of one size");
    return *std::move(value);
  }

  static std::size_t sparse_rows_of_octave(hid_t group, const std::string& place) {
    const std::vector<std::int64_t> rows = read_indices(group, "nr", place);
    if (rows.size() != 1) fail_hdf5(place, "a number of rows");
    return static_cast<std::size_t>(rows.front());
  }

  /// Base, limit and increment, of any type of numbers.
  static MatValue read_octave_range(hid_t dataset, const std::string& place) {
    struct Range {
      double base, limit, increment;
    };
    const Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Range)), H5Tclose);
    H5Tinsert(type.id(), "base", offsetof(Range, base), H5T_NATIVE_DOUBLE);
    H5Tinsert(type.id(), "limit", offsetof(Range, limit), H5T_NATIVE_DOUBLE);
    H5Tinsert(type.id(), "increment", offsetof(Range, increment), H5T_NATIVE_DOUBLE);
    Range range{};
    const bool one =
        H5Sget_simple_extent_npoints(Hdf5Handle(H5Dget_space(dataset), H5Sclose).id()) == 1;
    if (!one || H5Dread(dataset, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &range) < 0) {
      fail_hdf5(place, "base, limit and increment of a range");
    }
    constexpr std::size_t kMost = std::size_t{1} << 27U;
    auto value = octave_range(range.base, range.limit, range.increment, kMost);
    return value ? *std::move(value) : long_range(range.base, range.limit, range.increment);
  }

  /// Characters of a byte, signed as C has them.
  static void read_octave_text(hid_t dataset, MatValue& value, const std::string& place) {
    std::vector<double> numbers;
    if (hdf5_content(dataset) != Hdf5Content::kReal) fail_hdf5(place, "characters");
    read_hdf5_real(dataset, numbers, place);
    std::string bytes;
    for (const double number : numbers) {
      if (!(number >= -128 && number < 256)) fail_hdf5(place, "characters");
      bytes += static_cast<char>(static_cast<int>(number));
    }
    value.texts = text_rows_of_bytes(bytes, value.sizes.front());
  }

  MatValue read_group(hid_t group, const std::string& place, int depth) {
    if (const auto rows = hdf5_number(group, kSparseRows, place)) {
      MatValue value = read_sparse(group, kOfMatlab, place);
      value.sizes = {static_cast<std::size_t>(checked_index(*rows, place)),
                     value.column_start.size() - 1};
      return checked(std::move(value), place);
    }
    if (is_of_scipy(group)) {
      MatValue value = read_sparse(group, kOfSciPy, place);
      value.sizes = {sparse_rows(group, value, place), value.column_start.size() - 1};
      return checked(std::move(value), place);
    }
    return read_struct(group, place, depth);
  }

  static bool has_member(hid_t group, const char* name) {
    return H5Lexists(group, name, H5P_DEFAULT) > 0;
  }

  static bool is_of_scipy(hid_t group) {
    return has_member(group, "data") && has_member(group, kOfSciPy.row) &&
           has_member(group, kOfSciPy.start);
  }

  static MatValue checked(MatValue value, const std::string& place) {
    const std::string fault = checked_sparse(value);
    if (fault.empty()) return value;
    throw FormatError({.file = place}, "a sparse matrix", fault,
                      "The file is damaged; save or copy it again.");
  }

  static std::int64_t checked_index(double value, const std::string& place) {
    if (value >= 0.0 && value < kLargestIndex && value == std::floor(value)) {
      return static_cast<std::int64_t>(value);
    }
    throw FormatError({.file = place}, "indices of a sparse matrix", fmt::format("{}", value),
                      "The file is damaged; save or copy it again.");
  }

  static std::vector<std::int64_t> read_indices(hid_t group, const char* name,
                                                const std::string& place) {
    const Hdf5Handle object = open_hdf5_object(group, name);
    const std::string inside = fmt::format("{}/{}", place, name);
    const bool dataset = object.valid() && H5Iget_type(object.id()) == H5I_DATASET;
    if (!dataset || hdf5_content(object.id()) != Hdf5Content::kReal) {
      fail_hdf5(inside, "indices of a sparse matrix");
    }
    std::vector<double> numbers;
    read_hdf5_real(object.id(), numbers, inside);
    std::vector<std::int64_t> indices(numbers.size());
    std::ranges::transform(numbers, indices.begin(),
                           [&](double value) { return checked_index(value, inside); });
    return indices;
  }

  /// Without its sizes. MATLAB leaves out what is empty.
  MatValue read_sparse(hid_t group, const SparseNames& names, const std::string& place) {
    MatValue value;
    value.kind = MatValue::Kind::kSparse;
    value.column_start = read_indices(group, names.start, place);
    if (value.column_start.empty()) fail_hdf5(place, "starts of columns");
    if (!has_member(group, "data")) return value;
    value.row = read_indices(group, names.row, place);
    const Hdf5Handle data = open_hdf5_object(group, "data");
    if (!data.valid() || H5Iget_type(data.id()) != H5I_DATASET) fail_hdf5(place, "numbers");
    read_numbers(data.id(), value, place + "/data");
    return value;
  }

  /// Of SciPy's: by the dataset `shape`; square where there is none. What is
  /// compressed are its rows or its columns, so that either size may be that of the starts.
  static std::size_t sparse_rows(hid_t group, const MatValue& value, const std::string& place) {
    const std::size_t compressed = value.column_start.size() - 1;
    if (!has_member(group, "shape")) return compressed;
    const std::vector<std::int64_t> shape = read_indices(group, "shape", place);
    if (shape.size() == 2) {
      const auto first = static_cast<std::size_t>(shape[0]);
      const auto second = static_cast<std::size_t>(shape[1]);
      if (first == compressed) return second;
      if (second == compressed) return first;
    }
    throw FormatError({.file = place}, fmt::format("a shape with {}", compressed), "another one",
                      "The file is damaged, or of another form.");
  }

  void read_numbers(hid_t dataset, MatValue& value, const std::string& place) {
    const Hdf5Content content = hdf5_content(dataset);
    if (content == Hdf5Content::kReal) {
      read_hdf5_real(dataset, value.real, place);
      const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
      if (is_large_integer(type.id())) {
        value.whole = beyond_doubles(read_hdf5_integers(dataset, place));
      }
    } else if (content == Hdf5Content::kComplex) {
      read_hdf5_complex(dataset, value.real, value.imaginary, place);
    } else {
      fail_hdf5(place, "numbers");
    }
    progress_.add(value.real.size() + value.imaginary.size());
  }

  static void read_text(hid_t dataset, MatValue& value, const std::string& place) {
    std::vector<double> numbers;
    if (hdf5_content(dataset) != Hdf5Content::kReal) fail_hdf5(place, "characters");
    read_hdf5_real(dataset, numbers, place);
    std::u16string units;
    for (const double number : numbers) {
      if (!(number >= 0 && number < 65536)) fail_hdf5(place, "characters");
      units += static_cast<char16_t>(number);
    }
    value.texts = text_rows(units, value.sizes.front());
  }

  std::vector<MatValue> read_references(hid_t dataset, std::size_t count, const std::string& place,
                                        int depth) {
    if (hdf5_content(dataset) != Hdf5Content::kReferences) fail_hdf5(place, "references");
    if (count > kMostMatValues) count_value(place, kDeepestMatValue + 1);
    std::vector<hobj_ref_t> references(count);
    if (count > 0 &&
        H5Dread(dataset, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0) {
      fail_hdf5(place, "references");
    }
    std::vector<MatValue> values;
    for (std::size_t i = 0; i < count; ++i) {
      const Hdf5Handle object(H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, &references[i]),
                              H5Oclose);
      values.push_back(read_object(object, fmt::format("{}({})", place, i + 1), depth + 1));
    }
    return values;
  }

  static bool is_references(const Hdf5Handle& object, const std::string& place) {
    return object.valid() && H5Iget_type(object.id()) == H5I_DATASET &&
           hdf5_content(object.id()) == Hdf5Content::kReferences &&
           !hdf5_text(object.id(), "MATLAB_class", place);
  }

  /// MATLAB states the order of the fields; without that they come by name.
  static std::vector<std::string> fields_of(hid_t group, bool& in_order, const std::string& place) {
    std::vector<std::string> members = hdf5_members(group, place);
    std::vector<std::string> stated = hdf5_texts(group, "MATLAB_fields", place);
    in_order = std::ranges::is_permutation(stated, members);
    return in_order ? stated : members;
  }

  /// A struct of one element has its fields as members; of several, members that refer to one value
  /// per element.
  MatValue read_struct(hid_t group, const std::string& place, int depth) {
    MatValue value;
    value.kind = MatValue::Kind::kStruct;
    value.sizes = {1, 1};
    value.fields = fields_of(group, value.in_order, place);
    std::vector<std::vector<MatValue>> columns;
    std::size_t count = 1;
    for (const std::string& field : value.fields) {
      const std::string inside = place + "/" + printable(field);
      const Hdf5Handle object = open_hdf5_object(group, field);
      std::vector<MatValue> column;
      if (is_references(object, inside)) {
        value.sizes = sizes_of(object.id(), inside);
        column = read_references(object.id(), value.count(), inside, depth);
      } else {
        column.push_back(read_object(object, inside, depth + 1));
      }
      if (columns.empty()) count = column.size();
      if (column.size() != count) fail_hdf5(inside, fmt::format("{} elements", count));
      columns.push_back(std::move(column));
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (auto& column : columns) value.children.push_back(std::move(column[i]));
    }
    return value;
  }

  std::string path_;
  const MatReadOptions& options_;
  hid_t file_;
  Hdf5Progress progress_;
  std::size_t values_ = 0;
};

}  // namespace

MatTree mat73_tree(const std::string& path, const MatReadOptions& options) {
  const Hdf5Handle file = open_hdf5(path);
  return Mat73Reader(path, options, file.id()).read();
}

}  // namespace microslip
