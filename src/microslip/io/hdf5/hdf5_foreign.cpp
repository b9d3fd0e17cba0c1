// SPDX-License-Identifier: MIT
#include "microslip/io/hdf5/hdf5_foreign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "microslip/io/bytes/text.hpp"
#include "microslip/io/hdf5/hdf5_handle.hpp"
#include "microslip/io/hdf5/hdf5_values.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

constexpr int kDeepestGroup = 32;

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

struct Dataset {
  std::string name;
  std::string place;
  Hdf5Handle handle;
  std::vector<hsize_t> sizes;  ///< without those that are 1
};

class ForeignReader {
 public:
  ForeignReader(std::string path, Hdf5Progress& progress)
      : path_(std::move(path)), progress_(progress) {}

  Recordings read(hid_t file) {
    read_group(file, "", {}, 0);
    if (result_.recordings.empty()) fail_without_recording();
    warn_without_rate(without_axis_, result_.warnings);
    return std::move(result_);
  }

 private:
  void read_group(hid_t group, const std::string& inside, Sampling sampling, int depth) {
    const std::string place = fmt::format("{}:{}", path_, inside.empty() ? "/" : inside);
    if (depth > kDeepestGroup || !visit(group)) return;
    std::vector<Dataset> datasets;
    std::vector<std::pair<std::string, Hdf5Handle>> groups;
    sampling = sampling_of(group, sampling, place);
    for (const std::string& name : hdf5_members(group, place)) {
      Hdf5Handle object = open_hdf5_object(group, name);
      if (!object.valid()) fail_hdf5(place + "/" + printable(name), "a group or a dataset");
      if (H5Iget_type(object.id()) == H5I_GROUP) {
        groups.emplace_back(name, std::move(object));
      } else if (H5Iget_type(object.id()) == H5I_DATASET) {
        sort_in(datasets, sampling, name, fmt::format("{}:{}/{}", path_, inside, printable(name)),
                std::move(object));
      }
    }
    read_datasets(datasets, sampling, inside);
    for (const auto& [name, handle] : groups) {
      read_group(handle.id(), inside + "/" + printable(name), sampling, depth + 1);
    }
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
    if (content != Hdf5Content::kReal && content != Hdf5Content::kComplex) return;
    Dataset dataset{name, place, std::move(handle), {}};
    for (const hsize_t size : hdf5_sizes(dataset.handle.id())) {
      if (size != 1) dataset.sizes.push_back(size);
    }
    if (!dataset.sizes.empty()) {
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
    std::vector<Recording> recordings;
    const std::optional<PointsAxis> axis = read_axis(datasets, sampling);
    const std::string source = file_name(path_) + (inside.empty() ? std::string{} : ":" + inside);
    for (const Dataset& dataset : datasets)
      read_dataset(recordings, source, dataset, axis, sampling);
    for (Recording& recording : recordings) {
      check_read(recording, path_);
      result_.recordings.push_back(std::move(recording));
    }
  }

  /// The dataset of the points, removed from the others.
  std::optional<PointsAxis> read_axis(std::vector<Dataset>& datasets, const Sampling& sampling) {
    const auto take = [&](const auto& names, const Dimension& usual) -> std::optional<PointsAxis> {
      std::vector<double> points;
      const auto found = std::ranges::find_if(datasets, [&](const Dataset& d) {
        if (!is_one_of(d.name, names) || d.sizes.size() != 1) return false;
        if (hdf5_content(d.handle.id()) != Hdf5Content::kReal) return false;
        read_hdf5_real(d.handle.id(), points, d.place);
        return may_be_points(d.name, points);
      });
      if (found == datasets.end()) return std::nullopt;
      const Dataset dataset = std::move(*found);
      datasets.erase(found);
      const Dimension dimension = apply_axis_unit(
          points, text_of(dataset.handle.id(), kUnitNames, dataset.place), usual, dataset.place);
      return axis_of_points(std::move(points), dimension,
                            dimension == kTime ? sampling.step : std::nullopt);
    };
    auto axis = take(kTimeNames, kTime);
    return axis ? axis : take(kFrequencyNames, kFrequency);
  }

  void read_dataset(std::vector<Recording>& recordings, const std::string& source,
                    const Dataset& dataset, const std::optional<PointsAxis>& axis,
                    Sampling sampling) {
    if (dataset.sizes.size() > 2 || std::ranges::min(dataset.sizes) == 0) return;
    std::optional<Axis> own;
    if (axis && axis->points == std::ranges::max(dataset.sizes)) {
      own = axis->axis;
    } else if (sampling = sampling_of(dataset.handle.id(), sampling, dataset.place);
               sampling.step) {
      own = even_axis(sampling);
    }
    if (!own) {
      without_axis_.push_back(dataset.place);
      return;
    }
    for (Channel& channel : read_channels(dataset)) {
      add_channel(recordings, source, *own, std::move(channel), dataset.name);
    }
  }

  std::vector<Channel> read_channels(const Dataset& dataset) {
    const hid_t id = dataset.handle.id();
    Channel first;
    first.name = hdf5_text(id, "channel_name", dataset.place).value_or(dataset.name);
    first.attributes = attributes_of(dataset);
    const std::string unit = text_of(id, kUnitNames, dataset.place);
    std::vector<Channel> channels;
    if (dataset.sizes.size() == 2) {
      channels = read_matrix(dataset, first);
    } else if (hdf5_content(id) == Hdf5Content::kReal) {
      read_hdf5_real(id, first.values, dataset.place);
      channels.push_back(std::move(first));
    } else {
      read_hdf5_complex(id, first.values, first.imaginary, dataset.place);
      channels.push_back(std::move(first));
    }
    for (Channel& channel : channels) {
      apply_unit(channel, unit, dataset.place, result_.warnings);
      progress_.add(channel.values.size() + channel.imaginary.size());
    }
    return channels;
  }

  std::vector<Channel> read_matrix(const Dataset& dataset, const Channel& first) {
    const hid_t id = dataset.handle.id();
    if (hdf5_content(id) != Hdf5Content::kReal || hdf5_sizes(id).size() != 2) {
      throw FormatError({.file = dataset.place}, "real numbers in one or two dimensions",
                        "complex ones or more dimensions", "Store each channel as a dataset.");
    }
    std::vector<std::vector<double>> parts = dataset.sizes[0] < dataset.sizes[1]
                                                 ? read_hdf5_rows(id, dataset.place)
                                                 : read_hdf5_columns(id, dataset.place);
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Channel channel = first;
      channel.name = fmt::format("{}_{}", first.name, i + 1);
      channel.values = std::move(parts[i]);
      channels.push_back(std::move(channel));
    }
    return channels;
  }

  static Attributes attributes_of(const Dataset& dataset) {
    Attributes attributes = hdf5_attributes(dataset.handle.id(), dataset.place);
    std::erase_if(attributes, [](const auto& attribute) {
      const std::string& name = attribute.first;
      return name == "channel_name" || is_one_of(name, kRateNames) || is_one_of(name, kStepNames) ||
             is_one_of(name, kStartNames) || is_one_of(name, kUnitNames);
    });
    return attributes;
  }

  [[noreturn]] void fail_without_recording() const {
    if (without_axis_.empty()) {
      throw FormatError({.file = path_}, "a dataset of two numbers or more", "none");
    }
    throw FormatError({.file = without_axis_.front()}, "a sampling rate", "none",
                      "Add the attribute fs [Hz] to the dataset, to a group that contains it or to "
                      "the file, or a dataset 'time' [s] next to it.");
  }

  std::string path_;
  Hdf5Progress& progress_;
  Recordings result_;
  std::set<haddr_t> visited_;
  std::vector<std::string> without_axis_;
};

}  // namespace

Recordings read_foreign_hdf5(hid_t file, const std::string& path, Hdf5Progress& progress) {
  return ForeignReader(path, progress).read(file);
}

}  // namespace microslip
