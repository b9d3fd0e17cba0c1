// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/stepped_sine_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/documents/levels/listed_units.hpp"
#include "microslip/documents/levels/response_sweep.hpp"
#include "microslip/io/bytes/input_stream.hpp"
#include "microslip/io/bytes/signature.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/mat/mat_value.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/recordings/recording_csv.hpp"
#include "microslip/io/tables/column_rules.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

constexpr std::array<Dimension, 4> kDimensions{kFrequency, kForce, kAcceleration, kAngle};

bool has_all(const std::vector<std::string>& names,
             std::initializer_list<std::string_view> wanted) {
  return std::ranges::all_of(
      wanted, [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); });
}

/// The name of the field with the acceleration; empty where there is none.
std::string_view acceleration_field(const std::vector<std::string>& fields) {
  if (has_all(fields, {"acceleration"})) return "acceleration";
  return has_all(fields, {"amplitude"}) ? "amplitude" : "";
}

/// Whether names are those of a sweep, or of one that lacks a part: steps of frequency and force
/// with a motion or a phase, and not over time unless there is a phase.
bool are_of_sweep(const std::vector<std::string>& names) {
  const auto has_any = [&](std::initializer_list<std::string_view> wanted) {
    return std::ranges::any_of(wanted,
                               [&](std::string_view name) { return has_all(names, {name}); });
  };
  return has_all(names, {"frequency", "force"}) && (!has_any({"time"}) || has_any({"phase"})) &&
         has_any({"acceleration", "amplitude", "velocity", "displacement", "phase"});
}

/// What a column of a sweep is called in files of microslip, by a name in any spelling: `Freq`,
/// `Force 1`, `Phase angle`.
std::string known_name(const std::string& name) {
  constexpr std::array<std::pair<Dimension, std::string_view>, 6> kNames{
      {{kFrequency, "frequency"},
       {kForce, "force"},
       {kAcceleration, "acceleration"},
       {kVelocity, "velocity"},
       {kLength, "displacement"},
       {kTime, "time"}}};
  if (in_capitals(name).find("PHASE") != std::string::npos) return "phase";
  const std::optional<Dimension> quantity = quantity_of_name(name);
  for (const auto& [dimension, known] : kNames) {
    if (quantity == dimension) return std::string(known);
  }
  return name;
}

struct ColumnOfSweep {
  std::string name;
  std::optional<Dimension> dimension;  ///< by its unit
};

/// known_name() of each. In a table without times the units tell what names in other languages do
/// not, of parts that no name tells.
std::vector<std::string> known_names(const std::vector<ColumnOfSweep>& columns) {
  constexpr std::array<std::pair<Dimension, std::string_view>, 4> kParts{
      {{kFrequency, "frequency"},
       {kForce, "force"},
       {kAcceleration, "acceleration"},
       {kAngle, "phase"}}};
  std::vector<std::string> names;
  for (const ColumnOfSweep& column : columns) names.push_back(known_name(column.name));
  const auto has = [&](std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  if (has("time") ||
      std::ranges::find(columns, kTime, &ColumnOfSweep::dimension) != columns.end()) {
    return names;
  }
  std::vector<std::string> by_unit = names;
  for (const auto& [dimension, part] : kParts) {
    if (has(part) || (part == "acceleration" && has("amplitude"))) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool is_free = names[i] == columns[i].name;
      if (is_free && columns[i].dimension == dimension) by_unit[i] = part;
    }
  }
  return by_unit;
}

/// The names in the table of a sweep as a logger writes it: in any spelling, below other lines,
/// with units on a line of their own, between blanks.
std::vector<std::string> known_names(std::string_view head) {
  std::vector<ColumnOfSweep> columns;
  for (const CsvColumn& column : recording_columns(head)) {
    const std::optional<Unit> unit = column.unit ? find_unit(*column.unit) : std::nullopt;
    ColumnOfSweep& added = columns.emplace_back(ColumnOfSweep{column.name, {}});
    if (unit) added.dimension = unit->dimension;
  }
  return known_names(columns);
}

/// Whether a table is in the form of microslip itself: names as above, in the first line that is no
/// comment, with their units.
bool is_own_table(std::string_view head) {
  std::vector<std::string> names;
  bool has_units = false;
  for (const CsvColumn& column : csv_columns(head)) {
    names.push_back(column.name);
    has_units = has_units || column.unit;
  }
  return has_units && are_of_sweep(names);
}

/// Conversion of a displacement or velocity to acceleration.
std::string motion_remedy(const std::vector<std::string>& names) {
  for (const auto& [name, factor] :
       {std::pair{"displacement", "(2 pi frequency)^2"}, std::pair{"velocity", "2 pi frequency"}}) {
    if (has_all(names, {name})) {
      return fmt::format("It has the {}: multiply it by {} to get the acceleration.", name, factor);
    }
  }
  return {};
}

/// @param place  of the names. @param source  of them: "columns".
/// @throws FormatError  where a part of the sweep is missing.
void require_parts(const std::vector<std::string>& names, const TextPlace& place,
                   std::string_view source) {
  const bool moves = !acceleration_field(names).empty();
  const bool lags = has_all(names, {"phase"});
  if (moves && lags) return;
  const std::string missing = moves  ? "phase [rad]"
                              : lags ? "acceleration [m/s^2]"
                                     : "acceleration [m/s^2] and phase [rad]";
  std::string remedy = moves ? std::string() : motion_remedy(names);
  if (!lags) {
    remedy += fmt::format(
        "{}The phase is that of the acceleration relative to the force; at resonance it is a "
        "quarter turn.",
        remedy.empty() ? "" : " ");
  }
  throw FormatError(place, fmt::format("{} of a stepped sine with {}", source, missing),
                    in_quotes(fmt::format("{}", fmt::join(names, ", ")), 120), remedy);
}

/// The units of frequency, force, acceleration and phase.
std::array<Unit, 4> units_of(const MatVariable& file, const std::string& variable, bool stated) {
  if (!stated) return {};  // SI
  const std::string text = file.text(variable + ".units");
  const auto fail = [&](std::string_view reason) {
    throw InputError(fmt::format("{}: {}.units", file.path(), variable), in_quotes(text),
                     "must be units of frequency, force, acceleration and phase between commas",
                     reason);
  };
  std::array<Unit, 4> units;
  std::vector<std::string> listed = listed_units(text);
  if (listed.size() > units.size()) fail("There are more than four.");
  listed.resize(units.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    try {
      units[i] = parse_unit(listed[i], kDimensions[i]);
    } catch (const InputError& error) {
      fail(error.what());
    }
  }
  return units;
}

SteppedSine read_element(const MatVariable& file, const std::string& variable,
                         const std::vector<std::string>& fields) {
  if (has_response_fields(fields)) return read_response_sweep(file, variable, fields);
  const std::array<Unit, 4> units = units_of(file, variable, has_all(fields, {"units"}));
  const auto numbers = [&](std::string_view field, const Unit& unit) {
    std::vector<double> values = file.numbers(fmt::format("{}.{}", variable, field));
    for (double& value : values) value = unit.to_si(value);
    return values;
  };
  return {.source = fmt::format("{}:{}", file.path(), variable),
          .frequency = numbers("frequency", units[0]),
          .force = numbers("force", units[1]),
          .acceleration = numbers(acceleration_field(fields), units[2]),
          .phase = numbers("phase", units[3])};
}

/// By the reader of tables that recordings use.
SteppedSine parse_logged_sine(std::string text, const std::string& name) {
  InputStream file(std::move(text), name);
  Recordings read = read_recordings_csv(file, {.no_axis = true});
  Recording& recording = read.recordings.front();
  std::vector<ColumnOfSweep> columns;
  for (const Channel& channel : recording.channels) {
    columns.push_back({channel.name, channel.dimension});
  }
  const std::vector<std::string> names = known_names(columns);
  for (std::size_t i = 0; i < names.size(); ++i) recording.channels[i].name = names[i];
  for (LeftOutChannel& channel : recording.left_out) channel.name = known_name(channel.name);
  require_parts(names, {.file = name}, "columns");
  const std::array<std::string_view, 4> parts{"frequency", "force", acceleration_field(names),
                                              "phase"};
  for (const std::string_view part : parts) {
    if (std::ranges::count(names, part) == 1) continue;
    throw FormatError({.file = name}, fmt::format("one column of the {} of a stepped sine", part),
                      fmt::format("{}", std::ranges::count(names, part)),
                      "Keep the columns of one sweep at the point that is driven.");
  }
  const auto values = [&](std::size_t part) {
    const std::span<const double> of_channel = recording.signal(parts[part], kDimensions[part]);
    return std::vector<double>(of_channel.begin(), of_channel.end());
  };
  SteppedSine sweep{.source = name,
                    .frequency = values(0),
                    .force = values(1),
                    .acceleration = values(2),
                    .phase = values(3)};
  check_stepped_sine(sweep);
  return sweep;
}

/// Whether it is a universal file over frequencies.
bool is_response_sweep(std::string_view head) {
  return signature(head) == recording_kind(RecordingFormat::kUff) && is_over_frequency(head);
}

}  // namespace

bool is_stepped_sine_table(std::string_view head) {
  if (is_response_sweep(head)) return true;
  try {
    const KnownKind* const known = known_kind_of(head);
    if (known != nullptr && !known->is_recording) return false;
    if (is_own_table(head)) return true;
    const std::vector<std::string> names = known_names(head);  // of spectra, too: a phase tells
    return are_of_sweep(names) && has_all(names, {"phase"});
  } catch (const Error&) {  // no table
    return false;
  }
}

SteppedSine parse_stepped_sine(std::string text, const std::string& name) {
  if (!is_own_table(text)) return parse_logged_sine(std::move(text), name);
  const CsvTable table(std::move(text), name);
  std::vector<std::string> names;
  for (const CsvColumn& column : table.columns()) names.push_back(column.name);
  require_parts(names, {.file = name}, "columns");
  const auto positive = [&](std::string_view column, const Dimension& dimension) {
    std::vector<double> values = table.numbers(column, dimension);
    require_positive(table, column, values);
    return values;
  };
  return {.source = name,
          .frequency = positive("frequency", kFrequency),
          .force = positive("force", kForce),
          .acceleration = positive("acceleration", kAcceleration),
          .phase = table.numbers("phase", kAngle)};
}

bool is_stepped_sine(const MatVariable& file, std::string_view variable) {
  const std::vector<std::string> fields = file.fields(variable);
  return are_of_sweep(fields) || has_response_fields(fields);
}

std::vector<SteppedSine> read_mat_sweeps(const MatVariable& file, const std::string& variable) {
  const std::vector<std::string> fields = file.fields(variable);
  if (!has_response_fields(fields)) {
    require_parts(fields, {.file = fmt::format("{}: {}", file.path(), variable)}, "fields");
  }
  const std::size_t count = file.count(variable);
  if (count == 0) {
    throw InputError(fmt::format("{}: {}", file.path(), variable), "an empty array",
                     "must contain at least one sweep");
  }
  std::vector<SteppedSine> sweeps;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string element = count == 1 ? variable : fmt::format("{}({})", variable, i);
    sweeps.push_back(read_element(file, element, fields));
  }
  return sweeps;
}

}  // namespace microslip
