// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/mat/mat5_writer.hpp"
#include "microslip/io/mat/mat_recording.hpp"
#include "microslip/io/recordings/hdf5_layout.hpp"

namespace microslip {
namespace {

Mat5Array attributes_cell(const Attributes& attributes, const std::string& place) {
  std::vector<Mat5Array> texts;  // column by column: all names, then all values
  for (const auto& attribute : attributes) {
    texts.push_back(Mat5Array::text(attribute.first, place));
  }
  for (const auto& attribute : attributes) {
    texts.push_back(Mat5Array::text(attribute.second, place));
  }
  const std::size_t rows = attributes.size();
  return Mat5Array::cell(rows, rows == 0 ? 0 : 2, std::move(texts));
}

Mat5Fields channel_fields(const Channel& channel, const std::string& place) {
  const auto& dimension = channel.dimension;
  Mat5Fields fields;
  fields.emplace_back("name", Mat5Array::text(channel.name, place));
  fields.emplace_back("unit", Mat5Array::text(dimension ? si_unit(*dimension) : "", place));
  fields.emplace_back("quantity",
                      Mat5Array::text(dimension ? dimension_name(*dimension) : "", place));
  fields.emplace_back("values", Mat5Array::column(channel.values, channel.imaginary));
  fields.emplace_back("attributes", attributes_cell(channel.attributes, place));
  return fields;
}

Mat5Array recording_struct(const Recording& recording, const std::string& place) {
  const Axis& axis = recording.axis;
  Mat5Fields fields;
  fields.emplace_back("schema", Mat5Array::text(kRecordingSchema, place));
  fields.emplace_back("source", Mat5Array::text(recording.source, place));
  fields.emplace_back("axis_unit", Mat5Array::text(si_unit(axis.dimension), place));
  if (axis.even()) {
    if (axis.dimension == kTime) {
      fields.emplace_back("fs", Mat5Array::number(recording.sampling_rate()));
    }
    fields.emplace_back("start", Mat5Array::number(axis.start));
    fields.emplace_back("step", Mat5Array::number(axis.step));
  } else {
    fields.emplace_back("axis", Mat5Array::column(axis.values, {}));
  }
  fields.emplace_back("attributes", attributes_cell(recording.attributes, place));
  std::vector<Mat5Fields> channels;
  for (const Channel& channel : recording.channels) {
    channels.push_back(channel_fields(channel, place));
  }
  fields.emplace_back("channels", Mat5Array::row_of_structs(std::move(channels)));
  std::vector<Mat5Fields> one;
  one.push_back(std::move(fields));
  return Mat5Array::row_of_structs(std::move(one));
}

}  // namespace

void write_recordings_mat(const std::string& path, std::span<const Recording> recordings) {
  for (const Recording& recording : recordings) check_recording(recording);
  std::vector<Mat5Variable> variables;
  for (const Recording& recording : recordings) {
    std::string name = fmt::format("recording_{}", variables.size() + 1);
    Mat5Array array = recording_struct(recording, path + ":" + name);
    variables.emplace_back(std::move(name), std::move(array));
  }
  write_mat5(path, variables);
}

}  // namespace microslip
