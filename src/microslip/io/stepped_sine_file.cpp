// SPDX-License-Identifier: MIT
#include "microslip/io/stepped_sine_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/csv.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/input_stream.hpp"
#include "microslip/io/mat_value.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/io/text.hpp"

namespace microslip {
namespace {

constexpr std::array<Dimension, 4> kDimensions{kFrequency, kForce, kAcceleration, kAngle};

bool has_all(const std::vector<std::string>& names,
             std::initializer_list<std::string_view> wanted) {
  return std::ranges::all_of(
      wanted, [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); });
}

/// The name of the field with the acceleration; empty where the struct is no sweep.
std::string_view acceleration_field(const std::vector<std::string>& fields) {
  if (!has_all(fields, {"frequency", "force", "phase"})) return {};
  if (has_all(fields, {"acceleration"})) return "acceleration";
  return has_all(fields, {"amplitude"}) ? "amplitude" : "";
}

/// The units of frequency, force, acceleration and phase.
std::array<Unit, 4> units_of(const PartOfFile& part, const std::string& variable, bool stated) {
  if (!stated) return {};  // SI
  const std::string text = read_mat_text(part.file, variable + ".units");
  const auto fail = [&](std::string_view reason) {
    throw InputError(fmt::format("{}: {}.units", part.file, variable), in_quotes(text),
                     "must be units of frequency, force, acceleration and phase between commas",
                     reason);
  };
  std::array<Unit, 4> units;
  std::string_view rest = text;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    try {
      units[i] = parse_unit(trimmed(rest.substr(0, end)), kDimensions[i]);
    } catch (const InputError& error) {
      fail(error.what());
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (!trimmed(rest).empty()) fail("There are more than four.");
  return units;
}

SteppedSine read_element(const PartOfFile& part, const std::string& variable,
                         const std::vector<std::string>& fields) {
  const std::array<Unit, 4> units = units_of(part, variable, has_all(fields, {"units"}));
  const auto numbers = [&](std::string_view field, const Unit& unit) {
    std::vector<double> values = read_mat_numbers(part.file, fmt::format("{}.{}", variable, field));
    for (double& value : values) value = unit.to_si(value);
    return values;
  };
  return {.source = fmt::format("{}:{}", part.file, variable),
          .frequency = numbers("frequency", units[0]),
          .force = numbers("force", units[1]),
          .acceleration = numbers(acceleration_field(fields), units[2]),
          .phase = numbers("phase", units[3])};
}

std::vector<SteppedSine> read_mat_sweeps(const PartOfFile& part) {
  const std::vector<std::string> fields = mat_fields(part.file, part.variable);
  const std::size_t count = mat_count(part.file, part.variable);
  if (count == 0) {
    throw InputError(fmt::format("{}: {}", part.file, part.variable), "an empty array",
                     "must hold a sweep at least");
  }
  std::vector<SteppedSine> sweeps;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string element =
        count == 1 ? part.variable : fmt::format("{}({})", part.variable, i);
    sweeps.push_back(read_element(part, element, fields));
  }
  return sweeps;
}

SteppedSine read_csv_sweep(const std::string& path) {
  const CsvTable table(read_file(path), input_name(path));
  return {.source = input_name(path),
          .frequency = table.numbers("frequency", kFrequency),
          .force = table.numbers("force", kForce),
          .acceleration = table.numbers("acceleration", kAcceleration),
          .phase = table.numbers("phase", kAngle)};
}

/// The first bytes; none of a pipe, which is not even opened. Standard input is left where it was.
std::string head_of(const std::string& path) {
  std::error_code ignored;  // what is not there is no pipe
  if (std::filesystem::is_fifo(path, ignored)) return {};
  InputStream file(path);
  if (!file.rewind()) return {};
  std::string head(peek_kind_head(file));
  file.rewind();
  return head;
}

}  // namespace

bool is_stepped_sine(const std::string& path) {
  try {
    const PartOfFile part = part_of_file(path);
    if (!part.variable.empty()) {
      return !acceleration_field(mat_fields(part.file, part.variable)).empty();
    }
    const std::vector<std::string> columns = csv_column_names(head_of(path));
    return has_all(columns, {"frequency", "force", "acceleration", "phase"});
  } catch (const Error&) {
    return false;
  }
}

std::vector<SteppedSine> read_stepped_sines(const std::string& path) {
  const PartOfFile part = part_of_file(path);
  if (!part.variable.empty()) return read_mat_sweeps(part);
  return {read_csv_sweep(path)};
}

}  // namespace microslip
