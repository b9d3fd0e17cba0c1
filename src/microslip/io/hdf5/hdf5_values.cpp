// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_dates.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/reading_worker.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLargestText = std::size_t{64} << 20U;
constexpr std::size_t kRowsBuffer = std::size_t{1} << 17U;  // doubles
/// Deflate makes no more of one byte (RFC 1951).
constexpr hsize_t kLargestHdf5Inflation = 1040;

Hdf5Handle type_of(hid_t dataset) { return {H5Dget_type(dataset), H5Tclose}; }

/// The member of a compound as the only one of a type in memory: values come one after the other.
Hdf5Handle part_type(hid_t type, unsigned index) {
  char* name = H5Tget_member_name(type, index);
  Hdf5Handle part(H5Tcreate(H5T_COMPOUND, sizeof(double)), H5Tclose);
  if (name != nullptr) H5Tinsert(part.id(), name, 0, H5T_NATIVE_DOUBLE);
  H5free_memory(name);
  return part;
}

bool is_complex(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND || H5Tget_nmembers(type) != 2) return false;
  for (const auto& [first, second] : {std::pair{"r", "i"}, std::pair{"real", "imag"}}) {
    if (H5Tget_member_index(type, first) == 0 && H5Tget_member_index(type, second) == 1) {
      return is_hdf5_number(Hdf5Handle(H5Tget_member_type(type, 0), H5Tclose).id()) &&
             is_hdf5_number(Hdf5Handle(H5Tget_member_type(type, 1), H5Tclose).id());
    }
  }
  return false;
}

template <class Number>
void read_all(hid_t dataset, hid_t type, std::vector<Number>& values, const std::string& place) {
  values.resize(check_hdf5_storage(dataset, place));
  if (values.empty()) return;
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail_hdf5(place, fmt::format("{} values", values.size()));
  }
}

hsize_t product(const std::vector<hsize_t>& sizes, const std::string& place) {
  hsize_t count = 1;
  for (const hsize_t size : sizes) {
    if (size != 0 && count > (hsize_t{1} << 48U) / size) {
      throw FormatError({.file = place}, "sizes of a dataset", "more values than a file can hold");
    }
    count *= size;
  }
  return count;
}

/// Chunks that are not there would be read as zeros.
hsize_t missing_chunks(hid_t dataset, hid_t properties, const std::vector<hsize_t>& sizes) {
  std::vector<hsize_t> chunk(sizes.size());
  hsize_t there = 0;
  if (H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) < 0) return 1;
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  if (H5Dget_num_chunks(dataset, space.id(), &there) < 0) return 1;
  hsize_t expected = 1;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (chunk[i] == 0) return 1;
    expected *= (sizes[i] + chunk[i] - 1) / chunk[i];
  }
  return expected > there ? expected - there : 0;
}

/// A filter that the library here does not have is no damage.
void require_filters(hid_t properties, const std::string& place) {
  const int count = H5Pget_nfilters(properties);
  for (int i = 0; i < count; ++i) {
    std::array<char, 64> name{};
    unsigned flags = 0;
    std::size_t parameters = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &parameters, nullptr,
                       name.size() - 1, name.data(), nullptr);
    if (filter < 0 || H5Zfilter_avail(filter) > 0) continue;
    H5Eclear2(H5E_DEFAULT);
    throw FormatError({.file = place}, "values that are compressed by gzip, szip or not at all",
                      fmt::format("the filter {} {}", filter, in_quotes(name.data())),
                      "Where its plugin is installed: h5repack -f GZIP=4 IN OUT.");
  }
}

std::optional<std::string> read_text(hid_t attribute, hid_t type) {
  const std::size_t size = H5Tget_size(type);
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (H5Aread(attribute, type, &text) < 0) return std::nullopt;
    std::string copy = text == nullptr ? "" : text;
    H5free_memory(text);
    return copy;
  }
  if (size > kLargestText) return std::nullopt;
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0) return std::nullopt;
  if (H5Tget_strpad(type) == H5T_STR_SPACEPAD) text.resize(text.find_last_not_of(' ') + 1);
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

struct AttributeValue {
  std::optional<std::string> text;
  std::optional<double> number;
};

/// An attribute, its type, and how many values it has; negative where the library does not tell.
struct OpenAttribute {
  Hdf5Handle attribute;
  Hdf5Handle type;
  hssize_t count = -1;

  [[nodiscard]] hid_t id() const { return attribute.id(); }
};

OpenAttribute open_attribute(hid_t object, const char* name, const std::string& place) {
  OpenAttribute open;
  open.attribute = Hdf5Handle(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!open.attribute.valid()) fail_hdf5(place, fmt::format("an attribute {}", in_quotes(name)));
  open.type = Hdf5Handle(H5Aget_type(open.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(open.id()), H5Sclose);
  if (space.valid()) open.count = H5Sget_simple_extent_npoints(space.id());
  return open;
}

AttributeValue read_attribute(hid_t object, const char* name, const std::string& place) {
  const OpenAttribute open = open_attribute(object, name, place);
  if (open.count < 0 || !open.type.valid()) fail_hdf5(place, "the type of an attribute");
  AttributeValue value;
  if (open.count != 1) return value;
  if (H5Tget_class(open.type.id()) == H5T_STRING) {
    value.text = read_text(open.id(), open.type.id());
    if (!value.text) fail_hdf5(place, fmt::format("the text {}", in_quotes(name)));
  } else if (is_hdf5_number(open.type.id())) {
    double number = 0.0;
    if (H5Aread(open.id(), H5T_NATIVE_DOUBLE, &number) < 0) {
      fail_hdf5(place, fmt::format("the number {}", in_quotes(name)));
    }
    value.number = number;
  }
  return value;
}

bool has_attribute(hid_t object, const char* name, const std::string& place) {
  const htri_t found = H5Aexists(object, name);
  if (found < 0) fail_hdf5(place, "attributes");
  return found > 0;
}

herr_t add_name(hid_t, const char* name, const H5A_info_t*, void* to) {
  static_cast<std::vector<std::string>*>(to)->emplace_back(name);
  return 0;
}

}  // namespace

bool is_hdf5_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_FLOAT || kind == H5T_INTEGER;
}

std::vector<hsize_t> hdf5_sizes(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = space.valid() ? H5Sget_simple_extent_ndims(space.id()) : 0;
  std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
  return sizes;
}

Hdf5Content hdf5_content(hid_t dataset) {
  const Hdf5Handle type = type_of(dataset);
  if (!type.valid()) return Hdf5Content::kOther;
  if (is_hdf5_number(type.id())) return Hdf5Content::kReal;
  if (is_complex(type.id())) return Hdf5Content::kComplex;
  if (H5Tequal(type.id(), H5T_STD_REF_OBJ) > 0) return Hdf5Content::kReferences;
  if (hdf5_time(type.id())) return Hdf5Content::kTimes;
  return H5Tget_class(type.id()) == H5T_COMPOUND ? Hdf5Content::kTable : Hdf5Content::kOther;
}

bool is_single_precision(hid_t dataset) {
  const Hdf5Handle type = type_of(dataset);
  return type.valid() && H5Tget_class(type.id()) == H5T_FLOAT && H5Tget_size(type.id()) == 4;
}

std::size_t check_hdf5_storage(hid_t dataset, const std::string& place) {
  const std::vector<hsize_t> sizes = hdf5_sizes(dataset);
  const hsize_t count = product(sizes, place);
  const Hdf5Handle type = type_of(dataset);
  const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose);
  if (!type.valid() || !properties.valid()) fail_hdf5(place, "a dataset");
  if (count == 0) return 0;
  const H5D_layout_t layout = H5Pget_layout(properties.id());
  if (H5Pget_external_count(properties.id()) != 0 || layout == H5D_VIRTUAL) {
    throw FormatError({.file = place}, "values in the file itself", "a link to other files",
                      "Copy them into one file, with h5repack for instance.");
  }
  require_filters(properties.id(), place);
  const hsize_t bytes = count * H5Tget_size(type.id());
  const hsize_t stored = H5Dget_storage_size(dataset);
  const bool filtered = H5Pget_nfilters(properties.id()) > 0;
  const bool chunked = layout == H5D_CHUNKED;
  const hsize_t most = filtered ? stored * kLargestHdf5Inflation : stored;
  if (bytes > most || (chunked && missing_chunks(dataset, properties.id(), sizes) > 0)) {
    throw FormatError({.file = place}, fmt::format("{} values", count), "fewer in the file",
                      "It was not closed when it was written, or it is damaged.");
  }
  expect_to_read(std::max<hsize_t>(bytes, count * sizeof(double)));
  return count;
}

void read_hdf5_real(hid_t dataset, std::vector<double>& values, const std::string& place) {
  read_all(dataset, H5T_NATIVE_DOUBLE, values, place);
}

WholeNumbers read_hdf5_integers(hid_t dataset, const std::string& place) {
  const hid_t in_memory = large_integer_in_memory(type_of(dataset).id());
  WholeNumbers whole{.bits = {}, .is_signed = in_memory == H5T_NATIVE_INT64};
  read_all(dataset, in_memory, whole.bits, place);
  return whole;
}

std::vector<double> read_hdf5_times(hid_t dataset, const std::string& place) {
  const std::optional<Hdf5Time> type = hdf5_time(type_of(dataset).id());
  if (!type) fail_hdf5(place, "times");
  std::vector<std::int64_t> times;
  if (type->is_pair) {
    read_all(dataset, type->type, times, place);
  } else {
    std::vector<std::int32_t> seconds;
    read_all(dataset, type->type, seconds, place);
    times.assign(seconds.begin(), seconds.end());
  }
  for (std::int64_t& time : times) time = time_in_nanoseconds(time, *type);
  return seconds_from_first(times);
}

void read_hdf5_complex(hid_t dataset, std::vector<double>& real, std::vector<double>& imaginary,
                       const std::string& place) {
  const Hdf5Handle type = type_of(dataset);
  read_all(dataset, part_type(type.id(), 0).id(), real, place);
  read_all(dataset, part_type(type.id(), 1).id(), imaginary, place);
}

namespace {

/// Values [first, first + count) of rows, each of them whole.
void read_block(hid_t dataset, hsize_t first, hsize_t rows, hsize_t columns, double* to,
                const std::string& place) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const hsize_t start[2] = {first, 0};
  const hsize_t count[2] = {rows, columns};
  const Hdf5Handle memory(H5Screate_simple(2, count, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
      H5Dread(dataset, H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, to) < 0) {
    fail_hdf5(place, fmt::format("row {}", first + 1));
  }
}

}  // namespace

std::vector<std::vector<double>> read_hdf5_rows(hid_t dataset, const std::string& place) {
  check_hdf5_storage(dataset, place);
  const std::vector<hsize_t> sizes = hdf5_sizes(dataset);
  std::vector<std::vector<double>> rows(sizes[0]);
  for (hsize_t row = 0; row < sizes[0]; ++row) {
    rows[row].resize(sizes[1]);
    read_block(dataset, row, 1, sizes[1], rows[row].data(), place);
  }
  return rows;
}

std::vector<std::vector<double>> read_hdf5_columns(hid_t dataset, const std::string& place) {
  check_hdf5_storage(dataset, place);
  const std::vector<hsize_t> sizes = hdf5_sizes(dataset);
  std::vector<std::vector<double>> columns(sizes[1], std::vector<double>(sizes[0]));
  const hsize_t step = std::max<hsize_t>(kRowsBuffer / sizes[1], 1);
  std::vector<double> buffer(step * sizes[1]);
  for (hsize_t row = 0; row < sizes[0]; row += step) {
    const hsize_t count = std::min(step, sizes[0] - row);
    read_block(dataset, row, count, sizes[1], buffer.data(), place);
    for (hsize_t i = 0; i < count; ++i) {
      for (hsize_t j = 0; j < sizes[1]; ++j) columns[j][row + i] = buffer[i * sizes[1] + j];
    }
  }
  return columns;
}

bool is_octave_variable(hid_t group) { return H5Aexists(group, "OCTAVE_NEW_FORMAT") > 0; }

std::string hdf5_text_of_dataset(hid_t dataset, const std::string& place) {
  constexpr std::size_t kLongest = 4096;
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const bool is_text = H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0;
  const std::size_t size = is_text ? H5Tget_size(type.id()) : 0;
  if (size == 0 || size > kLongest || H5Sget_simple_extent_npoints(space.id()) != 1) {
    fail_hdf5(place, "a text");
  }
  std::string text(size, '\0');
  if (H5Dread(dataset, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) {
    fail_hdf5(place, "a text");
  }
  return text.c_str();
}

std::optional<std::string> hdf5_text(hid_t object, const char* name, const std::string& place) {
  if (!has_attribute(object, name, place)) return std::nullopt;
  return read_attribute(object, name, place).text;
}

std::optional<double> hdf5_number(hid_t object, const char* name, const std::string& place) {
  if (!has_attribute(object, name, place)) return std::nullopt;
  return read_attribute(object, name, place).number;
}

namespace {

/// Texts of fixed length, `size` bytes each.
std::vector<std::string> fixed_texts(hid_t attribute, hid_t type, std::size_t count,
                                     const std::string& place) {
  const std::size_t size = H5Tget_size(type);
  std::string bytes(count * size, '\0');
  if (H5Aread(attribute, type, bytes.data()) < 0) fail_hdf5(place, "texts");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = bytes.substr(i * size, size);
    text.resize(std::min(text.find('\0'), text.size()));
    text.resize(text.find_last_not_of(' ') + 1);  // where it is padded so
    texts.push_back(std::move(text));
  }
  return texts;
}

/// Texts in memory of the library: `Item` points to one, `text` copies it.
template <class Item, class Copy>
std::vector<std::string> variable_texts(hid_t attribute, hid_t type, std::size_t count,
                                        const std::string& place, const Copy& text) {
  std::vector<Item> items(count);
  if (H5Aread(attribute, type, items.data()) < 0) fail_hdf5(place, "texts");
  std::vector<std::string> texts;
  for (const Item& item : items) texts.push_back(text(item));
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  H5Dvlen_reclaim(type, space.id(), H5P_DEFAULT, items.data());
  return texts;
}

bool is_list_of_characters(hid_t type) {
  if (H5Tget_class(type) != H5T_VLEN) return false;
  const Hdf5Handle item(H5Tget_super(type), H5Tclose);
  return H5Tget_class(item.id()) == H5T_STRING && H5Tis_variable_str(item.id()) == 0 &&
         H5Tget_size(item.id()) == 1;
}

}  // namespace

std::vector<std::string> hdf5_texts(hid_t object, const char* name, const std::string& place) {
  constexpr hssize_t kMost = 65536;
  if (!has_attribute(object, name, place)) return {};
  const OpenAttribute open = open_attribute(object, name, place);
  const hid_t type = open.type.id();
  if (!open.type.valid() || open.count < 1 || open.count > kMost) return {};
  const auto count = static_cast<std::size_t>(open.count);
  if (is_list_of_characters(type)) {
    return variable_texts<hvl_t>(open.id(), type, count, place, [](const hvl_t& item) {
      return std::string(static_cast<const char*>(item.p), item.len);
    });
  }
  if (H5Tget_class(type) != H5T_STRING) return {};
  if (H5Tis_variable_str(type) == 0) return fixed_texts(open.id(), type, count, place);
  return variable_texts<char*>(open.id(), type, count, place, [](const char* item) {
    return std::string(item == nullptr ? "" : item);
  });
}

std::vector<double> hdf5_numbers(hid_t object, const char* name, const std::string& place) {
  constexpr hssize_t kMost = 4096;
  if (!has_attribute(object, name, place)) return {};
  const OpenAttribute open = open_attribute(object, name, place);
  if (!open.type.valid() || !is_hdf5_number(open.type.id()) || open.count < 1 ||
      open.count > kMost) {
    return {};
  }
  std::vector<double> numbers(static_cast<std::size_t>(open.count));
  if (H5Aread(open.id(), H5T_NATIVE_DOUBLE, numbers.data()) < 0) {
    fail_hdf5(place, fmt::format("the numbers {}", in_quotes(name)));
  }
  return numbers;
}

Attributes hdf5_attributes(hid_t object, const std::string& place) {
  std::vector<std::string> names;
  hsize_t at = 0;
  if (H5Aiterate2(object, H5_INDEX_CRT_ORDER, H5_ITER_INC, &at, add_name, &names) < 0) {
    H5Eclear2(H5E_DEFAULT);
    names.clear();
    at = 0;
    if (H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &at, add_name, &names) < 0) {
      fail_hdf5(place, "attributes");
    }
  }
  Attributes attributes;
  for (const std::string& name : names) {
    AttributeValue value = read_attribute(object, name.c_str(), place);
    if (value.text) attributes.emplace_back(name, *std::move(value.text));
    if (value.number) {
      append_number(attributes.emplace_back(name, std::string{}).second, *value.number);
    }
  }
  return attributes;
}

}  // namespace microslip
