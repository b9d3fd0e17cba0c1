// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/hdf5_handle.hpp"
#include "microslip/io/hdf5_layout.hpp"
#include "microslip/io/mat_recording.hpp"
#include "microslip/io/mat_writer.hpp"
#include "microslip/io/text.hpp"
#include "microslip/io/unicode.hpp"
#include "microslip/io/write_error.hpp"
#include "microslip/io/written_recordings.hpp"

namespace microslip {
namespace {

/// A variable of version 5 counts its bytes in 31 bits; what is not values is small.
constexpr std::size_t kLargestVersion5 = (std::size_t{1} << 31U) - (std::size_t{64} << 20U);

struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};

Variable require(matvar_t* variable) {
  if (variable == nullptr) throw std::bad_alloc();
  return Variable(variable);
}

/// matio keeps the address of the pair of pointers to a complex array until it has written it.
using Parts = std::deque<mat_complex_split_t>;

/// A column; the values are not copied.
Variable numbers(std::span<const double> real, std::span<const double> imaginary, Parts& parts) {
  std::array<std::size_t, 2> sizes{real.size(), 1};
  void* data = const_cast<double*>(real.data());
  int options = MAT_F_DONT_COPY_DATA;
  if (!imaginary.empty()) {
    data = &parts.emplace_back(mat_complex_split_t{data, const_cast<double*>(imaginary.data())});
    options |= MAT_F_COMPLEX;
  }
  return require(
      Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), data, options));
}

Variable number(double value) {
  std::array<std::size_t, 2> sizes{1, 1};
  return require(Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes.data(), &value, 0));
}

Variable text(const std::string& value, const std::string& place) {
  std::optional<std::u16string> units = utf16_of(value);
  if (!units) throw InputError(place, in_quotes(value), "must be UTF-8");
  std::array<std::size_t, 2> sizes{units->empty() ? std::size_t{0} : 1, units->size()};
  return require(
      Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT16, 2, sizes.data(), units->data(), 0));
}

Variable attributes_cell(const Attributes& attributes, const std::string& place) {
  std::array<std::size_t, 2> sizes{attributes.size(), attributes.empty() ? std::size_t{0} : 2};
  Variable cell =
      require(Mat_VarCreate(nullptr, MAT_C_CELL, MAT_T_CELL, 2, sizes.data(), nullptr, 0));
  const int count = static_cast<int>(attributes.size());
  for (int i = 0; i < count; ++i) {
    const auto& [name, value] = attributes[static_cast<std::size_t>(i)];
    Mat_VarSetCell(cell.get(), i, text(name, place).release());
    Mat_VarSetCell(cell.get(), count + i, text(value, place).release());
  }
  return cell;
}

using Fields = std::vector<std::pair<const char*, Variable>>;

Variable make_struct(const char* name, std::vector<Fields> elements) {
  std::array<std::size_t, 2> sizes{1, elements.size()};
  std::vector<const char*> names;
  for (const auto& field : elements.front()) names.push_back(field.first);
  Variable result = require(Mat_VarCreateStruct(name, 2, sizes.data(), names.data(),
                                                static_cast<unsigned>(names.size())));
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (auto& [field, value] : elements[i]) {
      Mat_VarSetStructFieldByName(result.get(), field, i, value.release());
    }
  }
  return result;
}

Fields channel_fields(const Channel& channel, const std::string& place, Parts& parts) {
  Fields fields;
  const auto& dimension = channel.dimension;
  fields.emplace_back("name", text(channel.name, place));
  fields.emplace_back("unit", text(dimension ? si_unit(*dimension) : "", place));
  fields.emplace_back("quantity", text(dimension ? dimension_name(*dimension) : "", place));
  fields.emplace_back("values", numbers(channel.values, channel.imaginary, parts));
  fields.emplace_back("attributes", attributes_cell(channel.attributes, place));
  return fields;
}

Variable recording_struct(const Recording& recording, const std::string& name,
                          const std::string& path, Parts& parts) {
  const std::string place = path + ":" + name;
  const Axis& axis = recording.axis;
  Fields fields;
  fields.emplace_back("schema", text(std::string(kRecordingSchema), place));
  fields.emplace_back("source", text(recording.source, place));
  fields.emplace_back("axis_unit", text(si_unit(axis.dimension), place));
  if (axis.even()) {
    if (axis.dimension == kTime) fields.emplace_back("fs", number(recording.sampling_rate()));
    fields.emplace_back("start", number(axis.start));
    fields.emplace_back("step", number(axis.step));
  } else {
    fields.emplace_back("axis", numbers(axis.values, {}, parts));
  }
  fields.emplace_back("attributes", attributes_cell(recording.attributes, place));
  std::vector<Fields> channels;
  for (const Channel& channel : recording.channels) {
    channels.push_back(channel_fields(channel, place, parts));
  }
  fields.emplace_back("channels", make_struct(nullptr, std::move(channels)));
  std::vector<Fields> elements;
  elements.push_back(std::move(fields));
  return make_struct(name.c_str(), std::move(elements));
}

std::size_t size_of(const Recording& recording) {
  std::size_t values = recording.axis.values.size();
  for (const Channel& channel : recording.channels) {
    values += channel.values.size() + channel.imaginary.size();
  }
  return values * sizeof(double);
}

/// matio says that it failed, not why.
[[noreturn]] void fail_to_write_mat(const std::string& path, int error) {
  if (error != 0) fail_to_write(path, error);
  fail_as_not_written(path);
}

void write_whole_mat(const std::string& path, std::span<const Recording> recordings,
                     MatVersion version) {
  const Hdf5Session session;  // matio writes version 7.3 by HDF5
  // Without a text of ours the time would be in it, and no file as the one before.
  const bool is_5 = version == MatVersion::k5;
  const char* heading = is_5 ? "MATLAB 5.0 MAT-file, written by microslip"
                             : "MATLAB 7.3 MAT-file, written by microslip";
  errno = 0;
  std::unique_ptr<mat_t, CloseFile> file(
      Mat_CreateVer(path.c_str(), heading, is_5 ? MAT_FT_MAT5 : MAT_FT_MAT73));
  if (!file) fail_to_write_mat(path, errno);
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const std::string name = fmt::format("recording_{}", i + 1);
    Parts parts;
    const Variable variable = recording_struct(recordings[i], name, path, parts);
    errno = 0;
    if (Mat_VarWrite(file.get(), variable.get(), MAT_COMPRESSION_NONE) != 0) {
      fail_to_write_mat(path, errno);
    }
  }
  errno = 0;
  if (Mat_Close(file.release()) != 0) fail_to_write_mat(path, errno);
}

}  // namespace

void write_mat(const std::string& path, std::span<const Recording> recordings, MatVersion version) {
  for (const Recording& recording : recordings) check_recording(recording);
  write_whole_mat(path, recordings, version);
  // matio does not notice a full disk. What was written is what is promised.
  try {
    if (are_same(read_recordings_mat(path).recordings, recordings)) return;
  } catch (const Error&) {  // NOLINT(bugprone-empty-catch): it is as good as another content
  }
  fail_as_not_written(path);
}

void write_recordings_mat(const std::string& path, std::span<const Recording> recordings) {
  const bool fits = std::ranges::all_of(
      recordings, [](const Recording& r) { return size_of(r) <= kLargestVersion5; });
  write_mat(path, recordings, fits ? MatVersion::k5 : MatVersion::k73);
}

}  // namespace microslip
