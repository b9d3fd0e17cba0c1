// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/hdf5_foreign.hpp"
#include "microslip/io/hdf5_handle.hpp"
#include "microslip/io/hdf5_values.hpp"
#include "microslip/io/mat_text.hpp"
#include "microslip/io/text.hpp"

namespace microslip {
namespace {

constexpr std::array<std::string_view, 11> kNumberClasses{"double", "single", "int8",   "uint8",
                                                          "int16",  "uint16", "int32",  "uint32",
                                                          "int64",  "uint64", "logical"};

class Mat73Reader {
 public:
  Mat73Reader(std::string path, const MatReadOptions& options, hid_t file)
      : path_(std::move(path)), options_(options), file_(file), progress_(file, options.progress) {}

  MatTree read() {
    MatTree tree;
    tree.root.kind = MatValue::Kind::kStruct;
    tree.root.sizes = {1, 1};
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
        "The file is damaged; save or copy it anew.");
  }

  MatValue read_object(const Hdf5Handle& object, const std::string& place, int depth) {
    count_value(place, depth);
    if (!object.valid()) fail_hdf5(place, "a variable");
    const H5I_type_t type = H5Iget_type(object.id());
    if (type != H5I_GROUP && type != H5I_DATASET) fail_hdf5(place, "a group or a dataset");
    const std::string name = hdf5_text(object.id(), "MATLAB_class", place).value_or("");
    if (type == H5I_GROUP) return read_struct(object.id(), place, depth);
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
    } else {
      value.kind = MatValue::Kind::kOther;
      value.other = name.empty() ? "a dataset without MATLAB_class" : "of class " + in_quotes(name);
    }
    return value;
  }

  /// In MATLAB's order: HDF5 counts the dimensions the other way round.
  static std::vector<std::size_t> sizes_of(hid_t dataset, const std::string& place) {
    const std::vector<hsize_t> sizes = hdf5_sizes(dataset);
    (void)check_hdf5_storage(dataset, place);
    std::vector<std::size_t> result(sizes.rbegin(), sizes.rend());
    while (result.size() < 2) result.push_back(1);
    return result;
  }

  void read_numbers(hid_t dataset, MatValue& value, const std::string& place) {
    const Hdf5Content content = hdf5_content(dataset);
    if (content == Hdf5Content::kReal) {
      read_hdf5_real(dataset, value.real, place);
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

  /// A struct of one element has its fields as members; of several, members that refer to one value
  /// per element.
  MatValue read_struct(hid_t group, const std::string& place, int depth) {
    MatValue value;
    value.kind = MatValue::Kind::kStruct;
    value.sizes = {1, 1};
    value.fields = hdf5_members(group, place);
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
