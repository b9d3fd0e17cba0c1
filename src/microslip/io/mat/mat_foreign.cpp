// SPDX-License-Identifier: MIT
#include "microslip/io/mat/mat_foreign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/mat/mat_path.hpp"
#include "microslip/io/mat/mat_rows.hpp"
#include "microslip/io/mat/mat_units.hpp"
#include "microslip/io/recordings/sampling.hpp"
#include "microslip/io/recordings/whole_times.hpp"

namespace microslip {
namespace {

using Kind = MatValue::Kind;

constexpr std::array kNamesNames{"names", "channel_names", "labels"};
constexpr std::array kValuesNames{"values", "data"};
constexpr std::array kNameNames{"name", "channel_name", "label"};

/// How dSPACE and others in capitals call what describes a channel.
constexpr std::array kCapitalNames{"Name", "Data", "Unit"};

/// An array of a struct that could be a channel, several, or the axis.
struct Array {
  std::string name;
  MatValue* value;
  std::string unit;
  std::vector<std::string> units = {};  ///< of its channels, where they differ
};

template <class Names>
MatValue* first_field(MatValue& value, std::size_t element, const Names& names) {
  for (const char* name : names) {
    if (MatValue* found = field_of(value, element, name)) return found;
  }
  return nullptr;
}

bool is_numbers(const MatValue& value) {
  return value.kind == Kind::kNumbers && value.sizes.size() == 2 && value.count() > 1;
}

/// Axis from the numbers of a struct, else the one known before.
Sampling sampling_of(MatValue& value, std::size_t element, Sampling known,
                     const std::string& place) {
  const auto number = [&](const auto& names) -> const double* {
    const MatValue* found = first_field(value, element, names);
    return found != nullptr && found->real.size() == 1 ? found->real.data() : nullptr;
  };
  if (const double* step = number(kStepNames)) {
    known.step = *step;
  } else if (const double* rate = number(kRateNames)) {
    known.step = step_of_rate(*rate, place);
  }
  if (const double* start = number(kStartNames)) known.start = *start;
  return known;
}

/// The columns of a matrix, or its rows, as arrays of their own.
std::vector<MatValue> parts_of(MatValue& value, bool by_row) {
  std::vector<MatValue> parts;
  if (value.is_vector()) {
    parts.push_back(std::move(value));
    return parts;
  }
  const std::size_t rows = value.sizes[0];
  const std::size_t columns = value.sizes[1];
  const auto take = [&](const std::vector<double>& from, std::size_t part) {
    std::vector<double> to(from.empty() ? 0 : (by_row ? columns : rows));
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i] = by_row ? from[i * rows + part] : from[part * rows + i];
    }
    return to;
  };
  for (std::size_t part = 0; part < (by_row ? rows : columns); ++part) {
    MatValue& added = parts.emplace_back();
    added.kind = Kind::kNumbers;
    added.real = take(value.real, part);
    added.imaginary = take(value.imaginary, part);
  }
  return parts;
}

/// A struct as its arrays see it.
struct Scope {
  std::string inside;  ///< its path in the file
  std::string place;   ///< with the file's name, for messages
  Sampling sampling;
  std::optional<PointsAxis> axis;
  std::string axis_name;           ///< of the array of its points
  std::vector<std::string> names;  ///< of channels
};

MatValue* values_of(MatValue& value, std::size_t element) {
  if (MatValue* values = first_field(value, element, kValuesNames)) return values;
  const bool is_named = field_of(value, element, kCapitalNames[0]) != nullptr;
  return is_named ? field_of(value, element, kCapitalNames[1]) : nullptr;
}

/// The text of the first of these fields, else of one in capitals.
template <class Names>
std::string text_of(MatValue& value, std::size_t element, const Names& names,
                    const char* in_capitals) {
  std::string text = mat_text(first_field(value, element, names));
  return text.empty() ? mat_text(field_of(value, element, in_capitals)) : text;
}

/// Structs with values, but not over points of their own.
bool is_channels(MatValue& value) {
  if (value.kind != Kind::kStruct || value.count() == 0) return false;
  for (std::size_t i = 0; i < value.count(); ++i) {
    const MatValue* values = values_of(value, i);
    if (values == nullptr || !is_numbers(*values)) return false;
    if (first_field(value, i, kTimeNames) != nullptr) return false;
  }
  return true;
}

/// Vectors and matrices of a struct, and structs in it that describe a channel.
std::vector<Array> arrays_of(MatValue& value, std::size_t element) {
  std::vector<Array> arrays;
  for (std::size_t index = 0; index < value.fields.size(); ++index) {
    const std::string& name = value.fields[index];
    MatValue* field = field_at(value, element, index);
    if (field == nullptr) continue;
    if (is_numbers(*field)) arrays.push_back({name, field, {}});
    if (!is_channels(*field)) continue;
    for (std::size_t i = 0; i < field->count(); ++i) {
      const std::string own = text_of(*field, i, kNameNames, kCapitalNames[0]);
      const std::string number = field->count() == 1 ? "" : fmt::format("_{}", i + 1);
      arrays.push_back({own.empty() ? name + number : own, values_of(*field, i),
                        text_of(*field, i, kUnitNames, kCapitalNames[2])});
    }
  }
  return arrays;
}

bool may_be_axis(const Array& array, std::string_view name, const Dimension& usual, bool has_rate) {
  return array.name == name && array.value->is_vector() && array.value->imaginary.empty() &&
         may_be_unit_of_points(array.unit, usual) &&
         may_be_frequencies(array.name, array.value->real, has_rate && usual == kFrequency);
}

/// The array of the points, of what they usually are; the number of arrays where there is none.
std::pair<std::size_t, Dimension> find_points(const std::vector<Array>& arrays, bool has_rate) {
  std::size_t index = arrays.size();
  const auto find = [&](std::string_view name, const Dimension& usual) {
    const auto found = std::ranges::find_if(
        arrays, [&](const Array& a) { return may_be_axis(a, name, usual, has_rate); });
    index = static_cast<std::size_t>(found - arrays.begin());
    return index < arrays.size();
  };
  if (std::ranges::any_of(kTimeNames, [&](const char* name) { return find(name, kTime); })) {
    return {index, kTime};
  }
  (void)std::ranges::any_of(kFrequencyNames,
                            [&](const char* name) { return find(name, kFrequency); });
  return {index, kFrequency};
}

std::size_t channels_of(const MatValue& value) {
  return value.is_vector() ? 1 : std::min(value.sizes[0], value.sizes[1]);
}

/// A function as Simcenter Testlab writes it, a struct of `x_values` (`start_value`, `increment`)
/// and `y_values` (`values`), each with the label of its unit in `quantity`.
struct TestlabFunction {
  MatValue* values;
  std::string unit;
  Axis axis;
};

std::string label_of_quantity(MatValue& values) {
  MatValue* const quantity = field_of(values, 0, "quantity");
  if (quantity == nullptr || quantity->kind != Kind::kStruct) return {};
  return mat_text(field_of(*quantity, 0, "label"));
}

/// A single number in a field of `x_values`. Elsewhere `increment` may be that of anything.
std::optional<double> number_of_axis(MatValue& x, std::string_view name) {
  const MatValue* const found = field_of(x, 0, name);
  if (found == nullptr || found->real.size() != 1) return std::nullopt;
  return found->real.front();
}

/// Nothing where it is no such function, or one over neither time nor frequency.
std::optional<TestlabFunction> testlab_function(MatValue& value, std::size_t element) {
  MatValue* const x = field_of(value, element, "x_values");
  MatValue* const y = field_of(value, element, "y_values");
  if (x == nullptr || y == nullptr || x->kind != Kind::kStruct || !is_channels(*y)) return {};
  const std::optional<Unit> unit = find_unit_of_points(label_of_quantity(*x));
  const std::optional<double> step = number_of_axis(*x, "increment");
  if (!unit || !step || y->count() != 1) return {};
  if (unit->dimension != kTime && unit->dimension != kFrequency) return {};
  return TestlabFunction{values_of(*y, 0),
                         label_of_quantity(*y),
                         {.dimension = unit->dimension,
                          .start = unit->to_si(number_of_axis(*x, "start_value").value_or(0.0)),
                          .step = unit->to_si(*step),
                          .values = {}}};
}

/// Takes the points off the arrays, for the scope.
/// @param rate  that the user states, Hz.
void take_axis(std::vector<Array>& arrays, Scope& scope, std::optional<double> rate,
               std::vector<Warning>& warnings) {
  const auto [index, usual] = find_points(arrays, scope.sampling.step.has_value());
  if (index == arrays.size()) return;
  const Array& array = arrays[index];
  scope.axis_name = array.name;
  PointsInFile points{array.value->real, array.unit, usual,
                      fmt::format("{}: {}", scope.place, array.name)};
  if (!array.value->whole.bits.empty() && usual == kTime) {
    WholeTimes times = whole_times(array.value->whole, points.unit, points.place);
    if (times.warning) warnings.push_back(*std::move(times.warning));
    points.points = std::move(times.values);
    points.unit = std::move(times.unit);
  }
  points.rate = rate;
  scope.axis = axis_of_points(std::move(points), scope.sampling.step, warnings);
  for (auto& warning :
       {contradicting_rate(*scope.axis, scope.sampling.step, array.name, scope.place),
        unused_rate(scope.axis->axis, scope.sampling.step, array.name, scope.place)}) {
    if (warning) warnings.push_back(*warning);
  }
  arrays.erase(arrays.begin() + static_cast<std::ptrdiff_t>(index));
}

class Collector {
 public:
  /// @param place_untimed  whether arrays that nothing places take untimed_step().
  Collector(const std::string& path, const RecordingReadOptions& options, bool place_untimed)
      : path_(path), options_(options), place_untimed_(place_untimed) {}

  /// A struct with all that lies in it. @param only  the one array to take; empty: all.
  void read_struct(MatValue& value, std::size_t element, const Sampling& known,
                   const std::string& inside, std::string_view only = {}) {
    Scope scope;
    scope.inside = inside;
    scope.place = inside.empty() ? path_ : path_ + ":" + inside;
    if (is_own_recording(value, element)) {
      Recording own = own_recording(value, element, scope.place);
      check_read(own, path_);
      result_.recordings.push_back(std::move(own));
      return;
    }
    if (const auto function = testlab_function(value, element)) {
      add_function(*function, scope);
      return;
    }
    scope.sampling = sampling_of(value, element, known, scope.place);
    scope.names = mat_texts(first_field(value, element, kNamesNames));
    std::vector<Array> arrays = arrays_of(value, element);
    give_units(value, element, arrays, scope);
    take_axis(arrays, scope, options_.rate, result_.warnings);
    result_.rate_used = result_.rate_used || (scope.axis && scope.axis->rate_used);
    if (!only.empty()) std::erase_if(arrays, [&](const Array& a) { return a.name != only; });
    read_arrays(arrays, scope);
    if (only.empty()) read_fields(value, element, scope);
  }

  void read_elements(MatValue& value, const Sampling& known, const std::string& inside) {
    if (is_table_of_rows(value)) {
      tables_.push_back({&value, known, inside});
      return;
    }
    for (std::size_t i = 0; i < value.count(); ++i) {
      read_struct(value, i, known,
                  value.count() == 1 ? inside : fmt::format("{}({})", inside, i + 1));
    }
  }

  /// Where there are no other values: an array of structs beside them lists events, for instance.
  void read_tables() {
    const bool found = !result_.recordings.empty() || !functions_.empty();
    if (found || !without_axis_.empty()) return;
    for (const TableOfRows& rows : tables_) {
      try {
        read_table(rows);
      } catch (const FormatError& error) {
        if (!fault_of_table_) fault_of_table_ = error;
      }
    }
  }

  /// Whether all that there is has no axis.
  [[nodiscard]] bool is_untimed() const {
    return result_.recordings.empty() && functions_.empty() && may_be_untimed(without_axis_);
  }

  Recordings finish() {
    std::ranges::move(functions_, std::back_inserter(result_.recordings));
    if (result_.recordings.empty()) fail_without_recording();
    check_foreign(result_, path_);
    warn_without_rate(without_axis_, result_.warnings);
    return std::move(result_);
  }

 private:
  struct TableOfRows {
    const MatValue* value;
    Sampling known;
    std::string inside;
  };

  void read_table(const TableOfRows& rows) {
    const std::string place = path_ + ":" + rows.inside;
    ColumnsOfRows columns = columns_of_rows(*rows.value, place);
    for (const std::string& name : columns.left_out) {
      result_.warnings.push_back(
          {"channel_left_out", fmt::format("{}: {}: left out, its values are no real numbers",
                                           place, in_quotes(name))});
    }
    read_struct(columns.table, 0, rows.known, rows.inside);
  }

  /// Functions of one axis are a recording, called by their variables.
  void add_function(const TestlabFunction& function, const Scope& scope) {
    const bool longer = function.values->sizes[1] > function.values->sizes[0];
    const std::string name =
        scope.inside.empty() ? "y_values" : scope.inside.substr(scope.inside.rfind('.') + 1);
    std::vector<MatValue> parts = parts_of(*function.values, longer);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Channel channel;
      channel.name = parts.size() == 1 ? name : fmt::format("{}_{}", name, i + 1);
      channel.values = std::move(parts[i].real);
      channel.imaginary = std::move(parts[i].imaginary);
      apply_unit(channel, function.unit, scope.place, result_.warnings);
      add_channel(functions_, file_name(path_), function.axis, std::move(channel), scope.inside);
    }
  }

  void give_units(MatValue& value, std::size_t element, std::vector<Array>& arrays,
                  const Scope& scope) {
    const std::size_t axis = find_points(arrays, scope.sampling.step.has_value()).first;
    std::vector<UnitOfArray> units;
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      const std::size_t channels = i == axis ? 0 : channels_of(*arrays[i].value);
      units.push_back({arrays[i].name, channels, arrays[i].unit});
    }
    assign_units(value, element, first_field(value, element, kUnitNames), units, scope.place,
                 result_.warnings);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      arrays[i].unit = std::move(units[i].unit);
      arrays[i].units = std::move(units[i].of_channels);
    }
  }

  void read_arrays(const std::vector<Array>& arrays, const Scope& scope) {
    std::vector<Recording> recordings;
    for (const Array& array : arrays) {
      const std::optional<AxisAlong> along = find_axis(array, scope);
      if (along) {
        add_array(recordings, array, *along, scope);
      } else {
        add_without_axis(array, scope);
      }
    }
    std::ranges::move(recordings, std::back_inserter(result_.recordings));
  }

  /// The axis, and whether it lies along the rows.
  struct AxisAlong {
    Axis axis;
    bool rows = false;
  };

  std::optional<AxisAlong> find_axis(const Array& array, const Scope& scope) {
    const std::vector<std::size_t>& sizes = array.value->sizes;
    const bool longer = sizes[1] > sizes[0];
    if (scope.axis) {
      for (const bool rows : {longer, !longer}) {
        if (sizes[rows ? 1 : 0] == scope.axis->points) return AxisAlong{scope.axis->axis, rows};
      }
    }
    if (scope.sampling.step) return AxisAlong{even_axis(scope.sampling), longer};
    if (scope.axis || !place_untimed_) return std::nullopt;
    note_untimed(options_, path_, result_);
    return AxisAlong{even_axis({.step = untimed_step(options_), .start = scope.sampling.start}),
                     longer};
  }

  void add_without_axis(const Array& array, const Scope& scope) {
    WithoutAxis without{fmt::format("{}: {}", scope.place, in_quotes(array.name))};
    if (scope.axis) {
      without.found = fmt::format("{} of {} values for its {}", in_quotes(scope.axis_name),
                                  scope.axis->points, std::ranges::max(array.value->sizes));
    }
    without_axis_.push_back(std::move(without));
  }

  void add_array(std::vector<Recording>& recordings, const Array& array, const AxisAlong& along,
                 const Scope& scope) {
    const std::string source =
        file_name(path_) + (scope.inside.empty() ? std::string{} : ":" + scope.inside);
    std::vector<MatValue> parts = parts_of(*array.value, along.rows);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Channel channel;
      channel.name = array.name;
      if (parts.size() > 1) {
        channel.name = scope.names.size() == parts.size() && !scope.names[i].empty()
                           ? scope.names[i]
                           : fmt::format("{}_{}", array.name, i + 1);
      }
      channel.values = std::move(parts[i].real);
      channel.imaginary = std::move(parts[i].imaginary);
      const bool listed = array.unit.empty() && i < array.units.size();
      const std::string& unit = listed ? array.units[i] : array.unit;
      apply_unit(channel, unit, scope.place, result_.warnings);
      add_channel(recordings, source, along.axis, std::move(channel), array.name);
    }
  }

  /// The structs in a struct, and those in its cells.
  void read_fields(MatValue& value, std::size_t element, const Scope& scope) {
    for (std::size_t index = 0; index < value.fields.size(); ++index) {
      const std::string& name = value.fields[index];
      MatValue* field = field_at(value, element, index);
      if (field == nullptr) continue;
      const std::string inside = scope.inside.empty() ? name : scope.inside + "." + name;
      if (field->kind == Kind::kOther) {
        others_.emplace_back(fmt::format("{}:{}", path_, inside), describe(*field));
      }
      if (field->kind == Kind::kStruct && !is_channels(*field)) {
        read_elements(*field, scope.sampling, inside);
      }
      if (field->kind != Kind::kCell) continue;
      for (std::size_t i = 0; i < field->children.size(); ++i) {
        MatValue& child = field->children[i];
        if (child.kind != Kind::kStruct) continue;
        read_elements(child, scope.sampling, fmt::format("{}{{{}}}", inside, i + 1));
      }
    }
  }

  [[noreturn]] void fail_without_recording() const {
    if (!without_axis_.empty()) {
      throw no_sampling_rate(without_axis_.front(),
                             "Add a variable fs [Hz], or a vector time [s], to the struct or to "
                             "the top of the file.");
    }
    if (!others_.empty() && !others_.front().second.starts_with("an object of")) {
      throw FormatError({.file = others_.front().first}, "vectors of numbers",
                        others_.front().second,
                        "In the program that wrote it, save its values as a vector of numbers.");
    }
    if (!others_.empty()) {
      throw FormatError({.file = others_.front().first}, "vectors of numbers",
                        others_.front().second,
                        "Only MATLAB reads it. There, save its variables as vectors: "
                        "s = struct('time', seconds(T.Time), 'x', T.x); save('name.mat', "
                        "'-struct', 's'); or writetimetable(T, 'name.csv'), writetable.");
    }
    if (fault_of_table_) throw FormatError(*fault_of_table_);
    throw FormatError({.file = path_}, "a vector of two numbers or more", "none");
  }

  std::string path_;
  const RecordingReadOptions& options_;
  bool place_untimed_;
  Recordings result_;
  std::vector<Recording> functions_;  ///< of TestlabFunction
  std::vector<WithoutAxis> without_axis_;
  std::vector<TableOfRows> tables_;
  std::optional<FormatError> fault_of_table_;                ///< of the first that is no recording
  std::vector<std::pair<std::string, std::string>> others_;  ///< places and what lies there
};

}  // namespace

namespace {

/// What is asked for, over points as far as they are known.
void collect_values(Collector& collector, MatValue& root, std::string_view variable,
                    const std::string& path) {
  if (variable.empty()) return collector.read_struct(root, 0, {}, {});
  const Sampling known = sampling_of(root, 0, {}, path);
  const MatPlace place = follow(root, variable, path);
  if (place.value->kind == Kind::kStruct && place.element) {
    collector.read_struct(*place.value, *place.element, known, std::string(variable));
  } else if (place.value->kind == Kind::kStruct) {
    collector.read_elements(*place.value, known, std::string(variable));
  } else if (is_numbers(*place.value) && !variable.ends_with('}')) {
    const std::size_t dot = variable.rfind('.');
    const bool top = dot == std::string_view::npos;
    const std::string_view parent = variable.substr(0, top ? 0 : dot);
    const MatPlace scope = follow(root, parent, path);
    collector.read_struct(*scope.value, scope.element.value_or(0), known, std::string(parent),
                          variable.substr(top ? 0 : dot + 1));
  } else {
    throw InputError(fmt::format("{}: {}", path, in_quotes(variable, 200)), describe(*place.value),
                     "must be a struct or a vector");
  }
}

void collect(Collector& collector, MatValue& root, std::string_view variable,
             const std::string& path) {
  collect_values(collector, root, variable, path);
  collector.read_tables();
}

}  // namespace

Recordings recordings_of(MatValue& root, std::string_view variable, const std::string& path,
                         const RecordingReadOptions& options) {
  Collector collector(path, options, options.rate.has_value());
  collect(collector, root, variable, path);
  if (!options.allow_untimed || !collector.is_untimed()) return collector.finish();
  Collector untimed(path, options, true);
  collect(untimed, root, variable, path);
  return untimed.finish();
}

}  // namespace microslip
