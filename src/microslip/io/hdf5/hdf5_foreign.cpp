// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_foreign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_dates.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_packing.hpp"
#include "microslip/io/hdf5/hdf5_scales.hpp"
#include "microslip/io/hdf5/hdf5_table.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"
#include "microslip/io/recordings/axis_rank.hpp"
#include "microslip/io/recordings/sampling.hpp"
#include "microslip/signal/recording/missing_values.hpp"
#include "microslip/signal/recording/quantity_name.hpp"

namespace microslip {
namespace {

constexpr int kDeepestGroup = 32;
/// Attributes with the names of the channels of a matrix.
constexpr std::array kChannelsNames{"channels", "channel_names", "names", "labels"};

template <class Names>
std::optional<double> number_of(hid_t object, const Names& names, const std::string& place) {
  for (const char* name : names) {
    if (const auto number = hdf5_number(object, name, place)) return number;
  }
  return std::nullopt;
}

template <class Names>
std::string text_of(hid_t object, const Names& names, const std::string& place) {
  for (const char* name : names) {
    if (auto text = hdf5_text(object, name, place)) return *std::move(text);
  }
  return {};
}

/// Axis from the attributes of an object, else the one known before.
Sampling sampling_of(hid_t object, Sampling known, const std::string& place) {
  if (const auto step = number_of(object, kStepNames, place)) {
    known.step = step;
  } else if (const auto rate = number_of(object, kRateNames, place)) {
    known.step = step_of_rate(*rate, place);
  }
  if (const auto start = number_of(object, kStartNames, place)) known.start = *start;
  return known;
}

/// A dimension of more than one value.
struct DatasetSide {
  hsize_t size = 0;
  std::vector<Hdf5Handle> scales = {};  ///< datasets that the file names for it
};

struct Dataset {
  std::string name;
  std::string place;
  Hdf5Handle handle;
  std::vector<DatasetSide> sides = {};  ///< at most two are read

  /// The longest side, the first of equal ones.
  [[nodiscard]] std::size_t longest() const {
    return static_cast<std::size_t>(std::ranges::max_element(sides, {}, &DatasetSide::size) -
                                    sides.begin());
  }
};

/// The axis of a dataset lies along one of its sides.
struct AxisAlong {
  Axis axis;
  std::size_t side = 0;
};

/// The points of an axis, or why they cannot be used.
struct PointsOrFault {
  PointsAxis points;
  std::string fault = {};  ///< for WithoutAxis::found; empty where there is none
};

/// The axis that the datasets of a group share by its name.
struct AxisBeside {
  PointsOrFault read;
  std::string name;
  std::vector<haddr_t> scales;  ///< of its one dimension; itself where it is a scale
};

/// A scale of time or frequency.
struct ScaleAxis {
  PointsOrFault read;
  AxisRank rank = AxisRank::kDoubtful;
};

/// A group whose datasets have been read, but for scales that may turn out to be axes of others.
struct GroupRead {
  std::string source;
  std::vector<Recording> recordings = {};
  std::vector<Dataset> scales = {};
  std::optional<AxisBeside> axis = {};
  Sampling sampling = {};
};

/// The path of an object within its file; empty where it has none.
std::string path_of(hid_t object) {
  std::array<char, 256> path{};
  H5Iget_name(object, path.data(), path.size() - 1);
  return path.data();
}

std::vector<haddr_t> addresses_of(const std::vector<Hdf5Handle>& scales) {
  std::vector<haddr_t> addresses;
  for (const Hdf5Handle& scale : scales) addresses.push_back(hdf5_address(scale.id()));
  return addresses;
}

/// Values over another dimension than the axis are not over it, however many they are. Where the
/// file names no dimensions, the number of values decides.
bool may_share(const DatasetSide& side, const AxisBeside& axis) {
  if (side.size != axis.read.points.points) return false;
  if (side.scales.empty() || axis.scales.empty()) return true;
  return std::ranges::any_of(addresses_of(side.scales), [&](haddr_t address) {
    return std::ranges::find(axis.scales, address) != axis.scales.end();
  });
}

/// Whether the name of a dimension speaks of time: that of the samples is not that of the channels.
bool speaks_of_time(const DatasetSide& side) {
  return std::ranges::any_of(side.scales, [](const Hdf5Handle& scale) {
    const std::string name = in_capitals(file_name(path_of(scale.id())));
    return name.find("TIME") != std::string::npos || name.find("SAMPLE") != std::string::npos;
  });
}

class ForeignReader {
 public:
  ForeignReader(std::string path, Hdf5Progress& progress, const RecordingReadOptions& options)
      : path_(std::move(path)),
        progress_(progress),
        options_(options),
        place_untimed_(options.rate.has_value()) {}

  Recordings read(hid_t file) {
    netcdf_ = is_netcdf(file);
    read_all(file);
    if (result_.recordings.empty() && options_.allow_untimed && may_be_untimed(without_axis_)) {
      visited_.clear();
      without_axis_.clear();
      served_.clear();
      result_.warnings.clear();
      place_untimed_ = true;
      read_all(file);
    }
    if (result_.recordings.empty()) fail_without_recording();
    check_foreign(result_, path_);
    warn_without_rate(without_axis_, result_.warnings);
    return std::move(result_);
  }

 private:
  /// By what the library of netCDF-4 writes, or the attribute of its conventions.
  static bool is_netcdf(hid_t file) {
    const auto has = [&](const char* name) { return H5Aexists(file, name) > 0; };
    return has("_NCProperties") || has("_nc3_strict") || has("Conventions");
  }

  void read_all(hid_t file) {
    groups_.clear();
    read_group(file, "", {}, 0);
    for (GroupRead& group : groups_) {
      read_scales(group);
      std::ranges::move(group.recordings, std::back_inserter(result_.recordings));
    }
  }

  void read_group(hid_t group, const std::string& inside, Sampling sampling, int depth) {
    const std::string place = fmt::format("{}:{}", path_, inside.empty() ? "/" : inside);
    if (depth > kDeepestGroup || !visit(group) || is_index(group, place)) return;
    pandas_ = pandas_ || H5Aexists(group, "pandas_type") > 0;
    std::vector<Dataset> datasets;
    std::vector<Dataset> tables;
    std::vector<std::pair<std::string, Hdf5Handle>> groups;
    sampling = sampling_of(group, sampling, place);
    for (const std::string& name : hdf5_members(group, place)) {
      Hdf5Handle object = open_hdf5_object(group, name);
      if (!object.valid()) fail_hdf5(place + "/" + printable(name), "a group or a dataset");
      if (H5Iget_type(object.id()) == H5I_GROUP) {
        groups.emplace_back(name, std::move(object));
      } else if (H5Iget_type(object.id()) == H5I_DATASET) {
        const std::string its_place = fmt::format("{}:{}/{}", path_, inside, printable(name));
        if (hdf5_content(object.id()) == Hdf5Content::kTable) {
          tables.push_back({name, its_place, std::move(object)});
        } else {
          sort_in(datasets, sampling, name, its_place, std::move(object));
        }
      }
    }
    read_datasets(datasets, sampling, inside);
    const std::optional<AxisBeside> beside = groups_.back().axis;
    for (const Dataset& table : tables) read_table(table, sampling, beside, inside);
    for (const auto& [name, handle] : groups) {
      read_group(handle.id(), inside + "/" + printable(name), sampling, depth + 1);
    }
  }

  /// What PyTables keeps to find rows of a table: no data.
  static bool is_index(hid_t group, const std::string& place) {
    return hdf5_text(group, "CLASS", place) == "TINDEX";
  }

  /// False where a link has led here before.
  bool visit(hid_t group) {
    H5O_info_t info;
    return H5Oget_info2(group, &info, H5O_INFO_BASIC) >= 0 && visited_.insert(info.addr).second;
  }

  /// Datasets of one number are as good as attributes of the group.
  void sort_in(std::vector<Dataset>& datasets, Sampling& sampling, const std::string& name,
               const std::string& place, Hdf5Handle handle) {
    const Hdf5Content content = hdf5_content(handle.id());
    if (content != Hdf5Content::kReal && content != Hdf5Content::kComplex &&
        content != Hdf5Content::kTimes) {
      return;
    }
    if (is_bare_dimension(handle.id(), place)) return;
    Dataset dataset{name, place, std::move(handle)};
    const std::vector<hsize_t> sizes = hdf5_sizes(dataset.handle.id());
    std::vector<std::vector<Hdf5Handle>> scales = hdf5_scales(dataset.handle.id(), place);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (sizes[i] != 1) dataset.sides.push_back({sizes[i], std::move(scales[i])});
    }
    if (dataset.sides.size() == 1 && is_hdf5_scale(dataset.handle.id(), place)) {
      H5Iinc_ref(dataset.handle.id());  // it is over itself
      dataset.sides[0].scales.emplace_back(dataset.handle.id(), H5Oclose);
    }
    if (!dataset.sides.empty()) {
      datasets.push_back(std::move(dataset));
      return;
    }
    if (content != Hdf5Content::kReal) return;
    std::vector<double> value;
    read_hdf5_real(dataset.handle.id(), value, place);
    if (value.empty()) return;
    if (is_one_of(name, kRateNames)) sampling.step = step_of_rate(value.front(), place);
    if (is_one_of(name, kStepNames)) sampling.step = value.front();
    if (is_one_of(name, kStartNames)) sampling.start = value.front();
  }

  void read_datasets(std::vector<Dataset>& datasets, const Sampling& sampling,
                     const std::string& inside) {
    GroupRead group{file_name(path_) + (inside.empty() ? std::string{} : ":" + inside)};
    group.axis = read_axis(datasets, sampling);
    group.sampling = sampling;
    if (group.axis) served_.insert(group.axis->scales.begin(), group.axis->scales.end());
    for (Dataset& dataset : datasets) {
      if (is_hdf5_scale(dataset.handle.id(), dataset.place)) {
        group.scales.push_back(std::move(dataset));
      } else {
        (void)read_dataset(group, dataset);
      }
    }
    groups_.push_back(std::move(group));
  }

  /// The fields of a table are channels, over that of its times where it has one.
  void read_table(const Dataset& dataset, const Sampling& sampling,
                  const std::optional<AxisBeside>& beside, const std::string& inside) {
    const std::string& place = dataset.place;
    const std::vector<hsize_t> sizes = hdf5_sizes(dataset.handle.id());
    if (sizes.size() != 1 || sizes[0] < 2) {
      tables_.emplace_back(
          place, sizes.size() == 1
                     ? std::string(sizes[0] == 0 ? "an empty table" : "a table of one row")
                     : fmt::format("a table of {} dimensions", sizes.size()));
      return;
    }
    Hdf5Table table = read_hdf5_table(dataset.handle.id(), place);
    std::ranges::copy(table.warnings, std::back_inserter(result_.warnings));
    if (table.fields.empty()) {
      tables_.emplace_back(place, "a table of which no field has real numbers");
      return;
    }
    const std::optional<Axis> axis = axis_of_table(table, dataset, sampling, beside);
    if (axis && table.fields.empty()) tables_.emplace_back(place, "a table of times alone");
    if (!axis || table.fields.empty()) return;
    GroupRead group{fmt::format("{}:{}/{}", file_name(path_), inside, printable(dataset.name))};
    for (Hdf5Field& field : table.fields) {
      Channel channel;
      channel.name = std::move(field.name);
      channel.values = std::move(field.values);
      apply_unit(channel, field.unit, place, result_.warnings);
      progress_.add(channel.values.size());
      add_channel(group.recordings, group.source, *axis, std::move(channel), dataset.name);
    }
    for (Recording& recording : group.recordings) recording.left_out = table.left_out;
    groups_.push_back(std::move(group));
  }

  /// The field of times or frequencies is taken out of the table; where it has none a dataset of
  /// times beside it will do.
  std::optional<Axis> axis_of_table(Hdf5Table& table, const Dataset& dataset, const Sampling& known,
                                    const std::optional<AxisBeside>& beside) {
    const Sampling sampling = sampling_of(dataset.handle.id(), known, dataset.place);
    std::optional<PointsOrFault> read;
    if (const auto [found, usual] =
            points_of_table(table, dataset.place, sampling.step.has_value());
        found != table.fields.end()) {
      Hdf5Field field = std::move(*found);
      table.fields.erase(found);
      read = read_points(std::move(field.values), field.unit, usual, field.name, dataset.place,
                         sampling);
    }
    if (!read && beside && beside->read.points.points == hdf5_sizes(dataset.handle.id())[0]) {
      read = beside->read;
    }
    if (read && read->fault.empty()) return read->points.axis;
    if (!read) {
      if (const auto axis = axis_without_points(sampling)) return axis;
    }
    without_axis_.push_back({dataset.place, read ? read->fault : std::string()});
    return std::nullopt;
  }

  using FieldOfTable = std::vector<Hdf5Field>::iterator;

  /// The field of the points and what they usually are: a time by its name, else one that rises in
  /// a unit of time, else a frequency by its name; the end where there is none. A span of time
  /// will do where there is no rate.
  std::pair<FieldOfTable, Dimension> points_of_table(Hdf5Table& table, const std::string& place,
                                                     bool has_rate) {
    const auto named = [&](const auto& names, const Dimension& usual) {
      auto found = table.fields.end();
      for (const char* name : names) {
        if (found != table.fields.end()) break;
        found = std::ranges::find_if(table.fields, [&](const Hdf5Field& field) {
          return field.name == name && may_be_unit_of_points(field.unit, usual) &&
                 may_be_frequencies(field.name, field.values, has_rate && usual == kFrequency);
        });
      }
      return found;
    };
    if (const auto found = named(kTimeNames, kTime); found != table.fields.end()) {
      return {found, kTime};
    }
    const FieldOfTable rising = std::ranges::min_element(table.fields, {}, rank_as_times);
    if (rank_as_times(*rising) > AxisRank::kLongTime) {
      FieldOfTable frequency = named(kFrequencyNames, kFrequency);
      const bool is_span = rank_as_times(*rising) == AxisRank::kSpan && !has_rate;
      if (is_span && frequency == table.fields.end()) frequency = the_frequency(table);
      if (is_span && frequency == table.fields.end()) return {rising, kTime};
      return {frequency, kFrequency};
    }
    const FieldOfTable frequency = the_frequency(table);
    if (is_named_as_time(rising->name) || frequency == table.fields.end()) return {rising, kTime};
    result_.warnings.push_back(
        {"axis_chosen",
         fmt::format("{}: {} is taken for the axis, though {} rises in a unit of time. Name the "
                     "latter 'time' where it is the axis",
                     place, in_quotes(frequency->name), in_quotes(rising->name))});
    return {frequency, kFrequency};
  }

  /// The field that is called frequency and is the only one in Hz that rises; the end: none.
  static FieldOfTable the_frequency(Hdf5Table& table) {
    const auto rises_in_hertz = [](const Hdf5Field& field) {
      const std::optional<Unit> unit = find_unit_of_points(field.unit);
      return unit && unit->dimension == kFrequency && rises(field);
    };
    if (std::ranges::count_if(table.fields, rises_in_hertz) != 1) return table.fields.end();
    const auto found = std::ranges::find_if(table.fields, rises_in_hertz);
    return quantity_of_name(found->name) == kFrequency || is_one_of(found->name, kFrequencyNames)
               ? found
               : table.fields.end();
  }

  static bool rises(const Hdf5Field& field) {
    return std::ranges::adjacent_find(field.values, std::not_fn(std::less<>())) ==
           field.values.end();
  }

  /// Doubtful where a field is no time by its unit, or does not rise.
  static AxisRank rank_as_times(const Hdf5Field& field) {
    const std::optional<Unit> unit = stated_unit_of_time(field.unit);
    if (!unit || !rises(field)) return AxisRank::kDoubtful;
    return rank_as_axis(field.name, *unit).value_or(AxisRank::kDoubtful);
  }

  /// Scales that are the axis of no dataset are channels: a force may be over a displacement.
  void read_scales(GroupRead& group) {
    for (const Dataset& scale : group.scales) {
      if (served_.contains(hdf5_address(scale.handle.id()))) continue;
      std::string reason = "nothing is given over it";
      const bool is_axis = axis_of_scale(scale.handle, group.sampling, scale.place) != nullptr;
      if (is_axis) {
        result_.warnings.push_back(
            {"scale_unused", fmt::format("{}: left out, {}", scale.place, reason)});
      } else if (read_dataset(group, scale)) {
        continue;
      } else {
        reason = "it is not over the axis of the others";
      }
      for (Recording& recording : group.recordings) {
        recording.left_out.push_back({scale.name, reason});
      }
    }
  }

  [[nodiscard]] std::vector<double> read_values(hid_t dataset, const std::string& place) const {
    std::vector<double> values;
    read_hdf5_real(dataset, values, place);
    (void)unpack(hdf5_packing(dataset, place, netcdf_), values);
    return values;
  }

  /// Times that a dataset gives; whole numbers may find its unit.
  [[nodiscard]] std::vector<double> read_times(hid_t dataset, const std::string& place,
                                               std::string& unit) {
    if (hdf5_content(dataset) == Hdf5Content::kTimes) {
      unit = "s";
      return read_hdf5_times(dataset, place);
    }
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    const bool is_packed =
        H5Aexists(dataset, "scale_factor") > 0 || H5Aexists(dataset, "add_offset") > 0;
    if (!is_large_integer(type.id()) || is_packed) return read_values(dataset, place);
    WholeTimes times = whole_times(read_hdf5_integers(dataset, place), unit, place);
    if (times.warning) result_.warnings.push_back(*std::move(times.warning));
    unit = std::move(times.unit);
    return std::move(times.values);
  }

  /// Points that a dataset gives. Those of an unknown unit are no fault of what is over others.
  PointsOrFault read_points(std::vector<double> points, const std::string& unit,
                            const Dimension& usual, const std::string& name,
                            const std::string& place, const Sampling& sampling) {
    const std::size_t count = points.size();
    try {
      PointsOrFault read{axis_of_points({.points = std::move(points),
                                         .unit = unit,
                                         .usual = usual,
                                         .place = place,
                                         .rate = options_.rate},
                                        sampling.step, result_.warnings)};
      result_.rate_used = result_.rate_used || read.points.rate_used;
      for (const auto& warning : {contradicting_rate(read.points, sampling.step, name, path_),
                                  unused_rate(read.points.axis, sampling.step, name, place)}) {
        if (warning) result_.warnings.push_back(*warning);
      }
      return read;
    } catch (const InputError& error) {
      if (trimmed(unit).empty() || find_unit_of_points(unit)) throw;
      if (!axis_fault_) axis_fault_ = error;
      return {{.axis = {}, .points = count}, points_of_unknown_unit(name, unit)};
    }
  }

  static bool may_give_points(const Dataset& dataset, const Dimension& usual) {
    const Hdf5Content content = hdf5_content(dataset.handle.id());
    return content == Hdf5Content::kReal || (content == Hdf5Content::kTimes && usual == kTime);
  }

  /// The dataset of the points, removed from the others.
  std::optional<AxisBeside> read_axis(std::vector<Dataset>& datasets, const Sampling& sampling) {
    const auto take = [&](const char* name, const Dimension& usual) -> std::optional<AxisBeside> {
      std::vector<double> points;
      std::string unit;
      const auto found = std::ranges::find_if(datasets, [&](const Dataset& d) {
        if (d.name != name || d.sides.size() != 1) return false;
        if (!may_give_points(d, usual)) return false;
        unit = text_of(d.handle.id(), kUnitNames, d.place);
        if (!may_be_unit_of_points(unit, usual)) return false;
        points = usual == kTime ? read_times(d.handle.id(), d.place, unit)
                                : read_values(d.handle.id(), d.place);
        return may_be_frequencies(d.name, points, sampling.step && usual == kFrequency);
      });
      if (found == datasets.end()) return std::nullopt;
      const Dataset dataset = std::move(*found);
      datasets.erase(found);
      const hid_t id = dataset.handle.id();
      AxisBeside axis{{}, dataset.name, addresses_of(dataset.sides[0].scales)};
      if (is_hdf5_scale(id, dataset.place)) axis.scales.push_back(hdf5_address(id));
      axis.read =
          read_points(std::move(points), unit, usual, dataset.name, dataset.place, sampling);
      return axis;
    };
    for (const char* name : kTimeNames) {
      if (auto axis = take(name, kTime)) return axis;
    }
    for (const char* name : kFrequencyNames) {
      if (auto axis = take(name, kFrequency)) return axis;
    }
    return std::nullopt;
  }

  /// Points that a scale gives, null unless it is one of time or frequency; each is read once.
  const ScaleAxis* axis_of_scale(const Hdf5Handle& scale, const Sampling& sampling,
                                 const std::string& place) {
    const auto [found, is_new] = scales_.try_emplace(hdf5_address(scale.id()));
    if (is_new) found->second = read_scale(scale, sampling, place);
    return found->second ? &*found->second : nullptr;
  }

  std::optional<ScaleAxis> read_scale(const Hdf5Handle& scale, const Sampling& sampling,
                                      const std::string& place) {
    const hid_t id = scale.id();
    const std::string path = path_of(id);
    const std::string inside = fmt::format("{}:{}", path_, printable(path));
    const bool numbers = hdf5_content(id) == Hdf5Content::kReal && hdf5_sizes(id).size() == 1;
    if (!numbers || is_bare_dimension(id, place)) return std::nullopt;
    std::string unit = text_of(id, kUnitNames, inside);
    const std::string name = file_name(path);
    const std::optional<Dimension> dimension = dimension_of_scale(name, unit);
    if (!dimension) return std::nullopt;
    const Unit known = find_unit_of_points(unit).value_or(Unit{.dimension = *dimension});
    std::vector<double> points =
        *dimension == kTime ? read_times(id, inside, unit) : read_values(id, inside);
    return ScaleAxis{read_points(std::move(points), unit, *dimension, name, inside, sampling),
                     rank_as_axis(name, known).value_or(AxisRank::kFrequencyUnit)};
  }

  static std::optional<Dimension> dimension_of_scale(const std::string& name,
                                                     const std::string& unit) {
    const auto is_axis = [](const Dimension& d) {
      return d == kTime || d == kFrequency || d == kAngularFrequency;
    };
    const std::optional<Unit> known = find_unit_of_points(unit);
    if (!unit.empty() && known) {
      return is_axis(known->dimension) ? std::optional(known->dimension) : std::nullopt;
    }
    if (is_one_of(name, kTimeNames)) return kTime;
    if (is_one_of(name, kFrequencyNames)) return kFrequency;
    const std::optional<Dimension> named = quantity_of_name(name);
    return named && is_axis(*named) ? named : std::nullopt;
  }

  /// The best of the axes that the file names for the sides of a dataset.
  std::optional<AxisAlong> axis_of_scales(const Dataset& dataset, const GroupRead& group,
                                          std::string& fault) {
    std::optional<AxisAlong> best;
    AxisRank rank = AxisRank::kDoubtful;
    for (std::size_t side = 0; side < dataset.sides.size(); ++side) {
      for (const Hdf5Handle& handle : dataset.sides[side].scales) {
        const ScaleAxis* scale = axis_of_scale(handle, group.sampling, dataset.place);
        if (scale == nullptr) continue;
        served_.insert(hdf5_address(handle.id()));
        if (scale->read.points.points != dataset.sides[side].size) continue;
        if (!scale->read.fault.empty()) {
          fault = scale->read.fault;
        } else if (!best || scale->rank < rank) {
          best = AxisAlong{scale->read.points.axis, side};
          rank = scale->rank;
        }
      }
    }
    const bool time_beside = group.axis && group.axis->read.fault.empty() && best &&
                             may_share(dataset.sides[best->side], *group.axis);
    return rank == AxisRank::kDoubtful && time_beside ? std::nullopt : best;
  }

  /// @param fault  why an axis that there is cannot be used.
  std::optional<AxisAlong> find_axis(const Dataset& dataset, const GroupRead& group,
                                     std::string& fault) {
    if (auto along = axis_of_scales(dataset, group, fault)) return along;
    const std::optional<AxisBeside>& axis = group.axis;
    const std::size_t longest = dataset.longest();
    std::vector<std::size_t> sides{longest};
    for (std::size_t side = 0; side < dataset.sides.size(); ++side) sides.push_back(side);
    for (const std::size_t side : sides) {
      if (!axis || !may_share(dataset.sides[side], *axis)) continue;
      fault = axis->read.fault;
      if (fault.empty()) return AxisAlong{axis->read.points.axis, side};
    }
    const Sampling sampling = sampling_of(dataset.handle.id(), group.sampling, dataset.place);
    const bool contradicted = !fault.empty() || axis;
    if (contradicted && !sampling.step) return std::nullopt;
    std::optional<Axis> even = axis_without_points(sampling);
    if (!even) return std::nullopt;
    const auto named = std::ranges::find_if(dataset.sides, speaks_of_time);
    return AxisAlong{*std::move(even),
                     named == dataset.sides.end()
                         ? longest
                         : static_cast<std::size_t>(named - dataset.sides.begin())};
  }

  /// By a rate that the file states, else of points that nothing places.
  std::optional<Axis> axis_without_points(const Sampling& sampling) {
    if (sampling.step) return even_axis(sampling);
    if (!place_untimed_) return std::nullopt;
    note_untimed(options_, path_, result_);
    return even_axis({.step = untimed_step(options_), .start = sampling.start});
  }

  /// False where it is left out.
  bool read_dataset(GroupRead& group, const Dataset& dataset) {
    const bool empty =
        std::ranges::find(dataset.sides, 0U, &DatasetSide::size) != dataset.sides.end();
    if (dataset.sides.size() > 2 || empty) return false;
    std::string fault;
    const std::optional<AxisAlong> along = find_axis(dataset, group, fault);
    if (!along) {
      if (fault.empty() && group.axis) fault = found_beside(dataset, *group.axis);
      without_axis_.push_back({dataset.place, fault});
      return false;
    }
    const Sampling own = sampling_of(dataset.handle.id(), {}, dataset.place);
    const std::string over = group.axis ? group.axis->name : "a scale";
    if (auto warning = unused_rate(along->axis, own.step, over, dataset.place)) {
      result_.warnings.push_back(*std::move(warning));
    }
    for (Channel& channel : read_channels(dataset, along->side)) {
      add_channel(group.recordings, group.source, along->axis, std::move(channel), dataset.name);
    }
    return true;
  }

  static std::string found_beside(const Dataset& dataset, const AxisBeside& axis) {
    const hsize_t values = dataset.sides[dataset.longest()].size;
    const std::size_t points = axis.read.points.points;
    if (values != points) {
      return fmt::format("{} of {} values for its {}", in_quotes(axis.name), points, values);
    }
    return fmt::format("{}, which is that of another dimension", in_quotes(axis.name));
  }

  std::vector<Channel> read_channels(const Dataset& dataset, std::size_t along) {
    const hid_t id = dataset.handle.id();
    Channel first;
    first.name = hdf5_text(id, "channel_name", dataset.place).value_or(dataset.name);
    const Hdf5Packing packing = hdf5_packing(id, dataset.place, netcdf_);
    first.attributes = attributes_of(dataset, packing);
    if (!packing.applies) warn_of_packing(dataset);
    const bool are_times = hdf5_content(id) == Hdf5Content::kTimes;
    const std::string unit = are_times ? "s" : text_of(id, kUnitNames, dataset.place);
    std::vector<Channel> channels;
    if (dataset.sides.size() == 2) {
      channels = read_matrix(dataset, first, along);
    } else if (hdf5_content(id) == Hdf5Content::kReal) {
      read_hdf5_real(id, first.values, dataset.place);
      channels.push_back(std::move(first));
    } else if (are_times) {
      first.values = read_hdf5_times(id, dataset.place);
      channels.push_back(std::move(first));
    } else {
      read_hdf5_complex(id, first.values, first.imaginary, dataset.place);
      channels.push_back(std::move(first));
    }
    const bool is_matrix = dataset.sides.size() == 2;
    const std::vector<std::string> units =
        is_matrix ? listed_texts(dataset, kUnitNames, channels.size(), "units")
                  : std::vector<std::string>();
    for (Channel& channel : channels) {
      std::string missing = unpack(packing, channel.values);
      if (missing.empty()) missing = unpack(packing, channel.imaginary);
      if (!missing.empty()) channel.attributes.emplace_back(kMissingAttribute, missing);
      const std::size_t i = static_cast<std::size_t>(&channel - channels.data());
      apply_unit(channel, units.empty() ? unit : units[i], dataset.place, result_.warnings);
      progress_.add(channel.values.size() + channel.imaginary.size());
    }
    return channels;
  }

  /// @param along  the side of the points; each index of the other one is a channel.
  std::vector<Channel> read_matrix(const Dataset& dataset, const Channel& first,
                                   std::size_t along) {
    const hid_t id = dataset.handle.id();
    if (hdf5_content(id) != Hdf5Content::kReal || hdf5_sizes(id).size() != 2) {
      throw FormatError({.file = dataset.place}, "real numbers in one or two dimensions",
                        "complex ones or more dimensions", "Store each channel as a dataset.");
    }
    std::vector<std::vector<double>> parts =
        along == 1 ? read_hdf5_rows(id, dataset.place) : read_hdf5_columns(id, dataset.place);
    std::vector<Channel> channels;
    const std::vector<Label> labels = read_labels(dataset, 1 - along);
    const std::vector<std::string> names =
        listed_texts(dataset, kChannelsNames, parts.size(), "names");
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Channel channel = first;
      channel.name =
          names.empty() || names[i].empty() ? fmt::format("{}_{}", first.name, i + 1) : names[i];
      for (const Label& label : labels) {
        channel.attributes.emplace_back(
            label.name,
            fmt::format("{}{}{}", label.values[i], label.unit.empty() ? "" : " ", label.unit));
      }
      channel.values = std::move(parts[i]);
      channels.push_back(std::move(channel));
    }
    return channels;
  }

  /// What an attribute of a matrix lists, one text for each of its channels; none where there is
  /// no such list. One of another length is left, with a warning.
  /// @param what  it lists, in words.
  template <class Names>
  std::vector<std::string> listed_texts(const Dataset& dataset, const Names& attributes,
                                        std::size_t channels, std::string_view what) {
    for (const char* attribute : attributes) {
      std::vector<std::string> texts = hdf5_texts(dataset.handle.id(), attribute, dataset.place);
      if (texts.size() < 2) continue;  // one is for all channels
      if (texts.size() == channels) return texts;
      result_.warnings.push_back(
          {"list_not_applied",
           fmt::format("{}: {} lists {} {} for {} channels and is not applied", dataset.place,
                       in_quotes(attribute), texts.size(), what, channels)});
    }
    return {};
  }

  /// Numbers by which a scale tells the channels of a matrix apart: positions, for instance.
  struct Label {
    std::string name;
    std::string unit;
    std::vector<double> values;
  };

  std::vector<Label> read_labels(const Dataset& dataset, std::size_t side) {
    std::vector<Label> labels;
    for (const Hdf5Handle& scale : dataset.sides[side].scales) {
      const hid_t id = scale.id();
      served_.insert(hdf5_address(id));
      const bool numbers = hdf5_content(id) == Hdf5Content::kReal && hdf5_sizes(id).size() == 1;
      if (!numbers || is_bare_dimension(id, dataset.place)) continue;
      Label label{printable(file_name(path_of(id))), text_of(id, kUnitNames, dataset.place),
                  read_values(id, dataset.place)};
      if (label.values.size() == dataset.sides[side].size) labels.push_back(std::move(label));
    }
    return labels;
  }

  void warn_of_packing(const Dataset& dataset) {
    const std::string names = packing_attributes(dataset.handle.id());
    if (names.empty()) return;
    result_.warnings.push_back(
        {"packing_not_applied",
         fmt::format("{}: {} kept as attributes and not applied: the values are no integers and "
                     "the file is not netCDF",
                     dataset.place, names)});
  }

  /// What has been applied to the values is no longer an attribute of that name.
  static Attributes attributes_of(const Dataset& dataset, const Hdf5Packing& packing) {
    Attributes attributes = hdf5_attributes(dataset.handle.id(), dataset.place);
    const bool scale = is_hdf5_scale(dataset.handle.id(), dataset.place);
    std::erase_if(attributes, [&](const auto& attribute) {
      const std::string& name = attribute.first;
      return name == "channel_name" || is_one_of(name, kRateNames) || is_one_of(name, kStepNames) ||
             is_one_of(name, kStartNames) || is_one_of(name, kUnitNames) ||
             is_missing_attribute(name) || name.starts_with("_Netcdf4") ||
             (scale && (name == "CLASS" || name == "NAME"));
    });
    for (auto& [name, value] : attributes) {
      if (packing.applies && is_packing_attribute(name)) name.insert(0, "applied_");
    }
    return attributes;
  }

  [[noreturn]] void fail_without_recording() const {
    if (axis_fault_) throw InputError(*axis_fault_);
    if (!without_axis_.empty()) {
      throw no_sampling_rate(
          without_axis_.front(),
          pandas_ ? "pandas wrote it: there, write it with the times as a column, format='table' "
                    "and data_columns=True."
                  : "Add the attribute fs [Hz] to the dataset, to a group that contains it or to "
                    "the file, or a dataset 'time' [s] next to it.");
    }
    if (!tables_.empty()) {
      const auto& [place, found] = tables_.front();
      throw FormatError({.file = place}, "a dataset or a table of numbers", found,
                        "Store each column as a dataset of its own; pandas: to_csv.");
    }
    const auto with_axis = std::ranges::find_if(
        groups_, [](const GroupRead& group) { return group.axis.has_value(); });
    throw FormatError({.file = path_}, "a dataset of two numbers or more",
                      with_axis == groups_.end()
                          ? "none"
                          : fmt::format("{} alone", in_quotes(with_axis->axis->name)));
  }

  std::string path_;
  Hdf5Progress& progress_;
  const RecordingReadOptions& options_;
  bool place_untimed_;  ///< whether datasets that nothing places take untimed_step()
  Recordings result_;
  std::set<haddr_t> visited_;
  std::map<haddr_t, std::optional<ScaleAxis>> scales_;  ///< by address
  std::set<haddr_t> served_;  ///< scales that are axes or tell channels apart
  std::vector<GroupRead> groups_;
  bool netcdf_ = false;
  bool pandas_ = false;
  std::optional<InputError> axis_fault_;  ///< the first unit of points that is not known
  std::vector<WithoutAxis> without_axis_;
  /// Places of datasets with named fields that are no recording, and what they are.
  std::vector<std::pair<std::string, std::string>> tables_;
};

}  // namespace

Recordings read_foreign_hdf5(hid_t file, const std::string& path, Hdf5Progress& progress,
                             const RecordingReadOptions& options) {
  return ForeignReader(path, progress, options).read(file);
}

}  // namespace microslip
