// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat5_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/unicode.hpp"
#include "microslip/io/output/file_output.hpp"

namespace microslip {
namespace {

constexpr std::size_t kTag = 8;
constexpr std::size_t kFieldName = 32;  // bytes of the name of a field, with the 0 that ends it
constexpr std::size_t kLargest = std::numeric_limits<std::int32_t>::max();

constexpr std::size_t filled_up(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

constexpr std::size_t element_of(std::size_t bytes) { return kTag + filled_up(bytes); }

void check_size(const std::string& path, const Mat5Variable& variable) {
  const std::size_t bytes = variable.second.bytes(variable.first);
  if (bytes <= kLargest) return;
  throw InputError(path + ":" + variable.first,
                   fmt::format("{:.1f} GB", static_cast<double>(bytes) / 1e9),
                   "must be below 2 GiB in a MAT file of version 5",
                   "Write an HDF5 file (.h5), or parts of the recording.");
}

}  // namespace

Mat5Array Mat5Array::column(std::span<const double> real, std::span<const double> imaginary) {
  Mat5Array array;
  array.sizes_ = {real.size(), 1};
  array.real_ = real;
  array.imaginary_ = imaginary;
  return array;
}

Mat5Array Mat5Array::number(double value) {
  Mat5Array array;
  array.sizes_ = {1, 1};
  array.number_ = value;
  return array;
}

Mat5Array Mat5Array::text(std::string_view utf8, const std::string& place) {
  std::optional<std::u16string> units = utf16_of(utf8);
  if (!units) throw InputError(place, in_quotes(utf8), "must be UTF-8");
  Mat5Array array;
  array.class_ = mat5::kCharClass;
  array.sizes_ = {units->empty() ? std::size_t{0} : 1, units->size()};
  // Scilab keeps one letter of a text in UTF-16; of UTF-8 readers count letters or bytes, which are
  // the same in ASCII alone.
  if (units->size() == utf8.size()) {
    array.text_ = utf8;
  } else {
    array.text_type_ = mat5::kUint16;
    array.text_.assign(reinterpret_cast<const char*>(units->data()), 2 * units->size());
  }
  return array;
}

Mat5Array Mat5Array::cell(std::size_t rows, std::size_t columns, std::vector<Mat5Array> elements) {
  Mat5Array array;
  array.class_ = mat5::kCellClass;
  array.sizes_ = {rows, columns};
  array.children_ = std::move(elements);
  return array;
}

Mat5Array Mat5Array::row_of_structs(std::vector<Mat5Fields> elements) {
  Mat5Array array;
  array.class_ = mat5::kStructClass;
  array.sizes_ = {1, elements.size()};
  for (const auto& [name, value] : elements.front()) {
    if (name.size() >= kFieldName) {
      throw InputError("name of a field", in_quotes(name), "must have 31 bytes at most");
    }
    array.fields_.push_back(name);
  }
  for (Mat5Fields& fields : elements) {
    for (auto& field : fields) array.children_.push_back(std::move(field.second));
  }
  return array;
}

std::size_t Mat5Array::bytes(std::string_view name) const {
  std::size_t sum = element_of(8) + element_of(8) + element_of(name.size());  // flags, sizes, name
  switch (class_) {
    case mat5::kCharClass:
      return sum + element_of(text_.size());
    case mat5::kStructClass:
      sum += kTag + element_of(kFieldName * fields_.size());  // the length is in its tag
      [[fallthrough]];
    case mat5::kCellClass:
      for (const Mat5Array& child : children_) sum += element_of(child.bytes({}));
      return sum;
    default:
      sum += element_of(sizeof(double) * sizes_[0]);
      return imaginary_.empty() ? sum : sum + element_of(sizeof(double) * imaginary_.size());
  }
}

/// Gathers what is small, so that few calls of the system write it.
class Mat5Output {
 public:
  explicit Mat5Output(const std::string& path) : file_(path) {}

  void header() {
    std::string heading = "MATLAB 5.0 MAT-file, written by microslip";
    heading.resize(116, ' ');
    heading.append(8, '\0');  // no data of subsystems
    append(heading);
    number<std::uint16_t>(0x0100);           // version
    number<std::uint16_t>('M' << 8U | 'I');  // read as "IM" where the low byte is first
  }

  void array(std::string_view name, const Mat5Array& array) {
    tag(mat5::kMatrix, array.bytes(name));
    const bool complex = !array.imaginary_.empty();
    tag(mat5::kUint32, 8);
    number<std::uint32_t>(array.class_ | (complex ? mat5::kComplexFlag : 0U));
    number<std::uint32_t>(0);
    tag(mat5::kInt32, 8);
    for (const std::size_t size : array.sizes_) number(static_cast<std::int32_t>(size));
    element(mat5::kInt8, name);
    content(array);
  }

  void finish() {
    flush();
    file_.close();
  }

 private:
  void content(const Mat5Array& array) {
    if (array.class_ == mat5::kCharClass) {
      element(array.text_type_, array.text_);
    } else if (array.class_ == mat5::kDoubleClass) {
      element(mat5::kDoubleNumbers,
              bytes_of(array.number_ ? std::span<const double>(&*array.number_, 1) : array.real_));
      if (!array.imaginary_.empty()) element(mat5::kDoubleNumbers, bytes_of(array.imaginary_));
    } else {
      if (array.class_ == mat5::kStructClass) field_names(array.fields_);
      for (const Mat5Array& child : array.children_) this->array({}, child);
    }
  }

  void field_names(const std::vector<std::string_view>& fields) {
    // A small element, its 4 bytes in the tag: matio and Octave read the length in no other form.
    number<std::uint32_t>(mat5::kInt32 | 4U << 16U);
    number(static_cast<std::int32_t>(kFieldName));
    std::string names;
    for (const std::string_view field : fields) {
      names += field;
      names.append(kFieldName - field.size(), '\0');
    }
    element(mat5::kInt8, names);
  }

  template <class T>
  static std::string_view bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
  }

  void tag(mat5::Type type, std::size_t bytes) {
    number<std::uint32_t>(type);
    number(static_cast<std::uint32_t>(bytes));
  }

  void element(mat5::Type type, std::string_view bytes) {
    tag(type, bytes.size());
    append(bytes);
    fill_up(bytes.size());
  }

  void fill_up(std::size_t bytes) { gathered_.append(filled_up(bytes) - bytes, '\0'); }

  template <class T>
  void number(T value) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    gathered_.append(bytes.data(), bytes.size());
  }

  void append(std::string_view bytes) {
    constexpr std::size_t kSmall = std::size_t{1} << 16U;
    if (gathered_.size() + bytes.size() > kSmall) flush();
    if (bytes.size() > kSmall) {
      file_.write(bytes);
    } else {
      gathered_ += bytes;
    }
  }

  void flush() {
    file_.write(gathered_);
    gathered_.clear();
  }

  FileOutput file_;
  std::string gathered_;
};

void write_mat5(const std::string& path, std::span<const Mat5Variable> variables) {
  for (const Mat5Variable& variable : variables) check_size(path, variable);
  Mat5Output output(path);
  output.header();
  for (const Mat5Variable& variable : variables) output.array(variable.first, variable.second);
  output.finish();
}

}  // namespace microslip
