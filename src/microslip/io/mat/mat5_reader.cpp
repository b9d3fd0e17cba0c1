// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat5_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "microslip/io/bytes/mat_text.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat5_format.hpp"
#include "microslip/io/mat/mat_numbers.hpp"
#include "microslip/io/mat/mat_variables.hpp"

namespace microslip {
namespace {

std::size_t bytes_of_type(std::uint32_t type) {
  switch (type) {
    case mat5::kInt8:
    case mat5::kUint8:
    case mat5::kUtf8:
      return 1;
    case mat5::kInt16:
    case mat5::kUint16:
    case mat5::kUtf16:
      return 2;
    case mat5::kInt32:
    case mat5::kUint32:
    case mat5::kUtf32:
    case mat5::kSingleNumbers:
      return 4;
    case mat5::kDoubleNumbers:
    case mat5::kInt64:
    case mat5::kUint64:
      return 8;
    default:
      return 0;
  }
}

struct Tag {
  std::uint32_t type = 0;
  std::size_t size = 0;
  std::size_t end = 0;  ///< offset at which the element ends, with what fills it up to 8 bytes
};

/// How the end that a variable claims is taken. One that is open may come earlier when all elements
/// are complete: libmatio counts two bytes for each letter of a text and writes one. One that is
/// cut lies behind the end of the file by no more than a tag, which libsndfile counts twice.
enum class VariableEnd { kFixed, kOpen, kCut };

/// One variable with all that lies in it.
class VariableReader {
 public:
  VariableReader(MatStream& stream, bool swap, std::size_t& values, VariableEnd end)
      : stream_(stream), swap_(swap), values_(values), end_(end) {}

  /// @param end  where the variable ends.
  /// @param only, name  its name is returned; its content is left where it is if `only` is another.
  MatValue read(std::size_t end, std::optional<std::string_view> only, std::string& name) {
    only_ = only;
    return read_matrix(end, 0, &name);
  }

  [[nodiscard]] Tag read_tag(std::size_t end) {
    need(8, end);
    const auto first = read_value<std::uint32_t>(stream_, swap_);
    Tag tag;
    if (first >> 16U != 0) {  // small: the data are in the tag
      tag.type = first & 0xFFFFU;
      tag.size = first >> 16U;
      tag.end = stream_.offset() + 4;
      if (tag.size > 4) stream_.fail("at most 4 bytes in a small element", number(tag.size));
      return tag;
    }
    tag.type = first;
    tag.size = read_value<std::uint32_t>(stream_, swap_);
    need(tag.size, end);
    tag.end = std::min(stream_.offset() + (tag.size + 7) / 8 * 8, end);
    return tag;
  }

 private:
  static std::string number(std::size_t value) { return fmt::format("{}", value); }

  void need(std::size_t size, std::size_t end) const {
    if (stream_.offset() <= end && size <= end - stream_.offset()) return;
    if (end_ == VariableEnd::kCut) stream_.fail_ended(fmt::format("{} bytes of an element", size));
    stream_.fail(fmt::format("{} bytes of an element", size),
                 "the end of the one that it is part of");
  }

  [[noreturn]] void fail_too_many() const {
    stream_.fail(fmt::format("at most {} arrays, nested {} deep", kMostMatValues, kDeepestMatValue),
                 "more");
  }

  void go_to(std::size_t offset) { stream_.skip(offset - stream_.offset()); }

  Tag read_tag_of(std::uint32_t type, std::string_view what, std::size_t end) {
    const Tag tag = read_tag(end);
    if (tag.type != type) stream_.fail(what, fmt::format("an element of type {}", tag.type));
    return tag;
  }

  std::string read_bytes(const Tag& tag) {
    std::string bytes(tag.size, '\0');
    stream_.read(bytes.data(), bytes.size());
    go_to(tag.end);
    return bytes;
  }

  /// Converts to To as it reads; the element may hold any type of numbers.
  template <class To>
  void read_numbers(const Tag& tag, std::vector<To>& to) {
    const std::size_t size = bytes_of_type(tag.type);
    if (size == 0 || tag.size % size != 0) {
      stream_.fail("an element of numbers", fmt::format("type {} of {} bytes", tag.type, tag.size));
    }
    const std::size_t count = tag.size / size;
    switch (tag.type) {
      case mat5::kInt8:
        return read_values<std::int8_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kUint8:
      case mat5::kUtf8:
        return read_values<std::uint8_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kInt16:
        return read_values<std::int16_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kUint16:
      case mat5::kUtf16:
        return read_values<std::uint16_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kInt32:
        return read_values<std::int32_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kUint32:
      case mat5::kUtf32:
        return read_values<std::uint32_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kSingleNumbers:
        return read_values<float>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kInt64:
        return read_values<std::int64_t>(stream_, count, swap_, to), go_to(tag.end);
      case mat5::kUint64:
        return read_values<std::uint64_t>(stream_, count, swap_, to), go_to(tag.end);
      default:
        return read_values<double>(stream_, count, swap_, to), go_to(tag.end);
    }
  }

  MatValue read_matrix(std::size_t end, int depth, std::string* name) {
    if (depth > kDeepestMatValue || ++values_ > kMostMatValues) fail_too_many();
    MatValue value;
    const std::uint32_t flags = read_flags(end);
    const std::uint32_t type = flags & 0xFFU;
    // A sparse matrix has far fewer numbers than its sizes say.
    const std::size_t most = std::size_t{1} << (type == mat5::kSparseClass ? 62U : 40U);
    if (type != mat5::kOpaqueClass) value.sizes = read_sizes(end, most);
    const Tag name_tag = read_tag_of(mat5::kInt8, "a name", end);
    const std::string own_name = read_bytes(name_tag);
    if (!is_plain_name(own_name)) stream_.fail("a name", in_quotes(own_name));
    if (name != nullptr) *name = own_name;
    if (name != nullptr && only_ && own_name != *only_) return value;
    read_content(value, type, (flags & mat5::kComplexFlag) != 0, end, depth);
    if (stream_.offset() != end && !(depth == 0 && end_ != VariableEnd::kFixed)) {
      stream_.fail("the end of the variable", fmt::format("{} more bytes", end - stream_.offset()));
    }
    return value;
  }

  std::uint32_t read_flags(std::size_t end) {
    const Tag tag = read_tag_of(mat5::kUint32, "the flags of an array", end);
    if (tag.size != 8) stream_.fail("flags of 8 bytes", number(tag.size));
    const auto flags = read_value<std::uint32_t>(stream_, swap_);
    stream_.skip(4);
    return flags;
  }

  std::vector<std::size_t> read_sizes(std::size_t end, std::size_t most) {
    const Tag tag = read_tag_of(mat5::kInt32, "the sizes of an array", end);
    if (tag.size < 8 || tag.size > 128) stream_.fail("2 to 32 sizes", number(tag.size / 4));
    std::vector<std::int32_t> sizes;
    read_numbers(tag, sizes);
    std::size_t count = 1;
    for (const std::int32_t size : sizes) {
      if (size < 0) stream_.fail("sizes of an array", fmt::format("{}", size));
      const bool fits = size == 0 || count <= most / static_cast<unsigned>(size);
      if (!fits) stream_.fail("sizes of an array", "more values than a file can hold");
      count *= static_cast<std::size_t>(size);
    }
    return {sizes.begin(), sizes.end()};
  }

  void read_content(MatValue& value, std::uint32_t type, bool complex, std::size_t end, int depth) {
    if (type >= mat5::kDoubleClass && type <= mat5::kUint64Class) {
      value.kind = MatValue::Kind::kNumbers;
      read_part(value, value.real, type, end);
      if (complex) read_part(value, value.imaginary, type, end);
    } else if (type == mat5::kSparseClass) {
      value.kind = MatValue::Kind::kSparse;
      read_sparse(value, complex, end);
    } else if (type == mat5::kCharClass) {
      value.kind = MatValue::Kind::kText;
      read_text(value, end);
    } else if (type == mat5::kCellClass) {
      value.kind = MatValue::Kind::kCell;
      read_children(value, value.count(), end, depth);
    } else if (type == mat5::kStructClass) {
      value.kind = MatValue::Kind::kStruct;
      read_field_names(value, end);
      // Without fields it has no children either, whatever it says of its size.
      if (value.count() > kMostMatValues / std::max<std::size_t>(1, value.fields.size())) {
        fail_too_many();
      }
      read_children(value, value.count() * value.fields.size(), end, depth);
    } else {
      value.kind = MatValue::Kind::kOther;
      value.other = type == mat5::kObjectClass     ? "an object of a class"
                    : type == mat5::kFunctionClass ? "a function handle"
                    : type == mat5::kOpaqueClass   ? read_class(end)
                                                   : "";
      if (value.other.empty()) stream_.fail("an array of a known class", fmt::format("{}", type));
      go_to(end);
    }
  }

  /// Of an object: which system of classes it is of, then the name of its class.
  std::string read_class(std::size_t end) {
    std::string name;
    for (int i = 0; i < 2; ++i) {
      const Tag tag = read_tag(end);
      if (tag.type != mat5::kInt8) return "an object of a class";
      name = read_bytes(tag);
    }
    return other_class(name);
  }

  void read_part(MatValue& value, std::vector<double>& part, std::uint32_t type, std::size_t end) {
    const Tag tag = read_tag(end);
    const std::size_t size = bytes_of_type(tag.type);
    if (size == 0 || tag.type >= mat5::kUtf8 || tag.size != size * value.count()) {
      stream_.fail(fmt::format("{} numbers", value.count()),
                   fmt::format("{} bytes of type {}", tag.size, tag.type));
    }
    // Integers may be stored in fewer bytes than their class has, never as fractions.
    if (type > mat5::kSingleClass &&
        (tag.type == mat5::kSingleNumbers || tag.type == mat5::kDoubleNumbers)) {
      stream_.fail("integers", "fractions");
    }
    if (&part == &value.real && (tag.type == mat5::kInt64 || tag.type == mat5::kUint64)) {
      return read_large(tag, value);
    }
    read_numbers(tag, part);
  }

  void read_large(const Tag& tag, MatValue& value) {
    WholeNumbers whole{.bits = {}, .is_signed = tag.type == mat5::kInt64};
    const std::size_t count = tag.size / sizeof(std::int64_t);
    if (whole.is_signed) {
      read_values<std::int64_t>(stream_, count, swap_, whole.bits);
      value.real.assign(whole.bits.begin(), whole.bits.end());
    } else {
      std::vector<std::uint64_t> numbers;
      read_values<std::uint64_t>(stream_, count, swap_, numbers);
      value.real.assign(numbers.begin(), numbers.end());
      whole.bits.assign(numbers.begin(), numbers.end());
    }
    value.whole = beyond_doubles(std::move(whole));
    go_to(tag.end);
  }

  /// Rows, starts of columns, numbers. There may be more rows and numbers than the columns have.
  void read_sparse(MatValue& value, bool complex, std::size_t end) {
    read_indices(value.row, end);
    read_indices(value.column_start, end);
    read_numbers(read_tag(end), value.real);
    if (complex) read_numbers(read_tag(end), value.imaginary);
    if (complex && value.imaginary.size() != value.real.size()) {
      stream_.fail(fmt::format("{} imaginary parts", value.real.size()),
                   number(value.imaginary.size()));
    }
    const std::string fault = checked_sparse(value);
    if (!fault.empty()) stream_.fail("a sparse matrix", fault);
  }

  void read_indices(std::vector<std::int64_t>& indices, std::size_t end) {
    const Tag tag = read_tag(end);
    if (tag.type == mat5::kSingleNumbers || tag.type == mat5::kDoubleNumbers) {
      stream_.fail("indices of a sparse matrix", "fractions");
    }
    read_numbers(tag, indices);
  }

  void read_text(MatValue& value, std::size_t end) {
    if (stream_.offset() == end) return;  // some writers leave out what is empty
    const Tag tag = read_tag(end);
    const std::size_t rows = value.sizes.front();
    std::u16string units;
    if (tag.type == mat5::kUtf8 || tag.type == mat5::kInt8 || tag.type == mat5::kUint8) {
      units = units_of_bytes(read_bytes(tag));
    } else if (tag.type == mat5::kUint16 || tag.type == mat5::kUtf16) {
      std::vector<std::uint16_t> numbers;
      read_numbers(tag, numbers);
      units.assign(numbers.begin(), numbers.end());
    } else {
      stream_.fail("text", fmt::format("an element of type {}", tag.type));
    }
    // For UTF-8 some count bytes, some characters.
    const bool fits = rows == 1 ? tag.type == mat5::kUtf8 || units.size() <= value.count()
                                : units.size() == value.count();
    if (!fits) {
      stream_.fail(fmt::format("{} characters", value.count()), number(units.size()));
    }
    value.texts = text_rows(units, rows);
  }

  void read_field_names(MatValue& value, std::size_t end) {
    const Tag length_tag = read_tag_of(mat5::kInt32, "the length of the names of fields", end);
    if (length_tag.size != 4) stream_.fail("one length", number(length_tag.size / 4));
    const auto length = read_value<std::int32_t>(stream_, swap_);
    go_to(length_tag.end);
    const std::string names = read_bytes(read_tag_of(mat5::kInt8, "the names of fields", end));
    if (names.empty()) return;
    const auto step = static_cast<std::size_t>(length);
    if (length <= 0 || names.size() % step != 0) {
      stream_.fail("names of fields", fmt::format("{} bytes for each", length));
    }
    std::set<std::string> taken;
    for (std::size_t at = 0; at < names.size(); at += step) {
      value.fields.emplace_back(names.substr(at, step).c_str());
      if (!taken.insert(value.fields.back()).second) {
        stream_.fail("each field of a struct once",
                     fmt::format("{} twice", in_quotes(value.fields.back())));
      }
      if (!is_plain_name(value.fields.back())) {
        stream_.fail("the name of a field", in_quotes(value.fields.back()));
      }
    }
  }

  void read_children(MatValue& value, std::size_t count, std::size_t end, int depth) {
    if (count > (end - stream_.offset()) / 8) {  // each has a tag of 8 bytes
      stream_.fail(fmt::format("{} elements", count), "room for fewer");
    }
    if (count > kMostMatValues) fail_too_many();
    value.children.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Tag tag = read_tag_of(mat5::kMatrix, "an array", end);
      value.children.push_back(
          tag.size == 0 ? empty() : read_matrix(stream_.offset() + tag.size, depth + 1, nullptr));
      go_to(tag.end);
    }
  }

  MatValue empty() {
    ++values_;
    MatValue value;
    value.kind = MatValue::Kind::kNumbers;
    value.sizes = {0, 0};
    return value;
  }

  MatStream& stream_;
  bool swap_;
  std::size_t& values_;
  VariableEnd end_;
  std::optional<std::string_view> only_;
};

bool read_header(MatFileStream& file) {
  std::array<char, mat5::kHeaderSize> header{};
  file.read(header.data(), header.size());
  const std::string_view mark(header.data() + 126, 2);
  if (mark != "IM" && mark != "MI") {
    file.fail("the mark of the byte order, 'IM' or 'MI'", in_quotes(mark));
  }
  return (mark == "MI") == (std::endian::native == std::endian::little);
}

class Mat5FileReader {
 public:
  Mat5FileReader(MatFileStream& file, const MatReadOptions& options)
      : file_(file), options_(options), swap_(read_header(file)) {}

  MatTree read() {
    return read_mat_variables(file_, options_, [this](MatValue& root) { read_variable(root); });
  }

 private:
  void read_variable(MatValue& root) {
    if (file_.at_most() < 8) file_.fail_ended("a variable");
    const auto type = read_value<std::uint32_t>(file_, swap_);
    const auto size = read_value<std::uint32_t>(file_, swap_);
    if (type != mat5::kMatrix && type != mat5::kCompressed) {
      file_.fail("a variable", fmt::format("an element of type {}", type));
    }
    constexpr std::size_t kTagSize = 8;
    const bool cut = size > file_.at_most();
    if (cut && (type != mat5::kMatrix || size - file_.at_most() > kTagSize))
      file_.fail_ended(fmt::format("{} bytes of a variable", size));
    std::string name;
    MatValue value = type == mat5::kMatrix ? read_plain(size, name) : read_compressed(size, name);
    if (name.empty()) return;  // internal data of MATLAB on objects
    names_.add(name, file_);
    root.fields.push_back(std::move(name));
    root.children.push_back(std::move(value));
  }

  MatValue read_plain(std::size_t size, std::string& name) {
    const bool cut = size > file_.at_most();
    const std::size_t end = file_.offset() + std::min(size, file_.at_most());
    VariableReader reader(file_, swap_, values_, cut ? VariableEnd::kCut : VariableEnd::kFixed);
    MatValue value = reader.read(end, options_.only, name);
    file_.skip(end - file_.offset());
    return value;
  }

  MatValue read_compressed(std::size_t size, std::string& name) {
    MatInflateStream stream(file_, size);
    const auto type = read_value<std::uint32_t>(stream, swap_);
    const auto inflated = read_value<std::uint32_t>(stream, swap_);
    if (type != mat5::kMatrix)
      stream.fail("a variable", fmt::format("an element of type {}", type));
    if (inflated > stream.at_most()) {
      stream.fail(fmt::format("{} bytes of a variable", inflated), "room for fewer");
    }
    VariableReader reader(stream, swap_, values_, VariableEnd::kOpen);
    const std::size_t end = stream.offset() + inflated;
    MatValue value = reader.read(end, options_.only, name);
    stream.finish(value.kind == MatValue::Kind::kNotRead ? end - stream.offset() : 0);
    return value;
  }

  MatFileStream& file_;
  const MatReadOptions& options_;
  bool swap_;
  std::size_t values_ = 0;
  MatNames names_;
};

}  // namespace

MatTree read_mat5(MatFileStream& file, const MatReadOptions& options) {
  return Mat5FileReader(file, options).read();
}

}  // namespace microslip
