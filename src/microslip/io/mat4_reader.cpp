// SPDX-License-Identifier: MIT
#include "microslip/io/mat4_reader.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "microslip/io/mat_numbers.hpp"
#include "microslip/io/mat_text.hpp"
#include "microslip/io/mat_variables.hpp"
#include "microslip/io/text.hpp"

namespace microslip {
namespace {

/// The number that starts a variable reads MOPT in decimal digits: M the byte order (0 little, 1
/// big), O is 0, P the type of the numbers, T the kind of matrix.
constexpr std::uint32_t kLargestMopt = 1052;
constexpr std::uint32_t kLongestName = 4096;

struct Header {
  std::uint32_t precision = 0;
  std::uint32_t kind = 0;  // 0 numbers, 1 text, 2 sparse
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool complex = false;
  std::string name;
};

bool is_mopt(std::uint32_t number) {
  return number <= kLargestMopt && number / 100 % 10 == 0 && number / 10 % 10 <= 5 &&
         number % 10 <= 2;
}

std::size_t bytes_of_precision(std::uint32_t precision) {
  return precision == 0 ? 8 : precision <= 2 ? 4 : precision <= 4 ? 2 : 1;
}

class Mat4FileReader {
 public:
  Mat4FileReader(MatFileStream& file, const MatReadOptions& options)
      : file_(file), options_(options) {}

  MatTree read() {
    return read_variables(file_, options_, [this](MatValue& root) { read_variable(root); });
  }

 private:
  Header read_header() {
    if (file_.at_most() < 20) file_.fail_ended("a variable");
    const auto number = read_value<std::uint32_t>(file_, false);
    swap_ = number > kLargestMopt;
    const std::uint32_t mopt = swap_ ? byte_swapped(number) : number;
    constexpr bool kBigHost = std::endian::native == std::endian::big;
    if (!is_mopt(mopt) || (mopt / 1000 == 1) != (swap_ != kBigHost)) {
      file_.fail("the type of a variable", fmt::format("{}", mopt));
    }
    Header header;
    header.precision = mopt / 10 % 10;
    header.kind = mopt % 10;
    header.rows = read_value<std::uint32_t>(file_, swap_);
    header.columns = read_value<std::uint32_t>(file_, swap_);
    const auto complex = read_value<std::uint32_t>(file_, swap_);
    const auto length = read_value<std::uint32_t>(file_, swap_);
    if (complex > 1) file_.fail("0 or 1 for complex numbers", fmt::format("{}", complex));
    header.complex = complex == 1;
    if (length < 2 || length > kLongestName) {
      file_.fail("the length of a name", fmt::format("{}", length));
    }
    header.name.resize(length);
    if (length > file_.at_most()) file_.fail_ended("a name");
    file_.read(header.name.data(), length);
    if (header.name.find('\0') != length - 1) {
      file_.fail("a name that ends in a zero", in_quotes(header.name));
    }
    header.name.pop_back();
    if (!is_plain_name(header.name)) file_.fail("a name", in_quotes(header.name));
    return header;
  }

  void read_variable(MatValue& root) {
    Header header = read_header();
    const std::size_t bytes = bytes_of_precision(header.precision) * (header.complex ? 2 : 1);
    const std::size_t room = file_.at_most() / bytes;
    if (header.columns != 0 && header.rows > room / header.columns) {
      file_.fail_ended(
          fmt::format("{} × {} values of {}", header.rows, header.columns, in_quotes(header.name)));
    }
    MatValue value;
    value.sizes = {header.rows, header.columns};
    if (options_.only && *options_.only != header.name) {
      file_.skip(value.count() * bytes);
    } else {
      read_content(header, value);
    }
    root.fields.push_back(std::move(header.name));
    root.children.push_back(std::move(value));
    if (root.fields.size() > kMostMatValues) file_.fail("fewer variables", "more");
  }

  void read_content(const Header& header, MatValue& value) {
    std::vector<double> real = read_part(header, value.count());
    std::vector<double> imaginary;
    if (header.complex) imaginary = read_part(header, value.count());
    if (header.kind == 1) {
      value.kind = MatValue::Kind::kText;
      std::u16string units;
      for (const double unit : real) {
        if (!(unit >= 0 && unit < 65536)) file_.fail("a character", fmt::format("{}", unit));
        units += static_cast<char16_t>(unit);
      }
      value.texts = text_rows(units, header.rows);
    } else if (header.kind == 2) {
      value.kind = MatValue::Kind::kOther;
      value.other = "a sparse matrix";
    } else {
      value.kind = MatValue::Kind::kNumbers;
      value.real = std::move(real);
      value.imaginary = std::move(imaginary);
    }
  }

  std::vector<double> read_part(const Header& header, std::size_t count) {
    std::vector<double> values;
    switch (header.precision) {
      case 0:
        read_values<double>(file_, count, swap_, values);
        break;
      case 1:
        read_values<float>(file_, count, swap_, values);
        break;
      case 2:
        read_values<std::int32_t>(file_, count, swap_, values);
        break;
      case 3:
        read_values<std::int16_t>(file_, count, swap_, values);
        break;
      case 4:
        read_values<std::uint16_t>(file_, count, swap_, values);
        break;
      default:
        read_values<std::uint8_t>(file_, count, swap_, values);
    }
    return values;
  }

  MatFileStream& file_;
  const MatReadOptions& options_;
  bool swap_ = false;
};

}  // namespace

bool is_mat4(std::string_view head) {
  std::uint32_t number = 0;
  if (head.size() < 20) return false;
  std::memcpy(&number, head.data(), sizeof number);
  return is_mopt(number) || is_mopt(byte_swapped(number));
}

MatTree read_mat4(MatFileStream& file, const MatReadOptions& options) {
  return Mat4FileReader(file, options).read();
}

}  // namespace microslip
