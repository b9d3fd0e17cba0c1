// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/loggers/byte_values.hpp"
#include "microslip/io/loggers/piece_reader.hpp"
#include "microslip/io/loggers/tdms_contents.hpp"
#include "microslip/io/loggers/tdms_metadata.hpp"
#include "microslip/io/recordings/sampling.hpp"

namespace microslip {
namespace {

constexpr std::size_t kLeadIn = 28;
constexpr std::uint64_t kNotClosed = std::numeric_limits<std::uint64_t>::max();

/// Of the table of contents in a lead-in.
constexpr std::uint32_t kHasMetadata = 1U << 1U;
constexpr std::uint32_t kNewObjects = 1U << 2U;
constexpr std::uint32_t kHasValues = 1U << 3U;
constexpr std::uint32_t kInterleaved = 1U << 5U;
constexpr std::uint32_t kBigEndian = 1U << 6U;

std::vector<double>& source_of(TdmsObject& object, std::uint32_t id) {
  const auto found = std::ranges::find(object.sources, id, &TdmsSource::scale_id);
  if (found != object.sources.end()) return found->values;
  return object.sources.emplace_back(TdmsSource{id, {}}).values;
}

/// Makes room for values that the file was seen to hold, as a vector that grows does.
void make_room(std::vector<double>& values, std::size_t count) {
  const std::size_t size = values.size() + count;
  if (size > values.capacity()) values.reserve(std::max(size, 2 * values.capacity()));
}

double* grown(std::vector<double>& values, std::size_t count) {
  make_room(values, count);
  values.resize(values.size() + count);
  return values.data() + (values.size() - count);
}

/// "/", "/'group'" or "/'group'/'channel'", in which '' is an apostrophe.
TdmsObject object_of_path(const std::string& path) {
  std::array<std::string, 2> names;
  std::size_t parts = 0;
  bool inside = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] == '\'') {
      const bool twice = inside && i + 1 < path.size() && path[i + 1] == '\'';
      if (!twice) {
        inside = !inside;
        if (inside) parts = std::min(parts + 1, names.size());
        continue;
      }
      ++i;
    } else if (!inside) {
      continue;
    }
    names.at(parts - 1) += path[i];
  }
  return {.kind = static_cast<TdmsObject::Kind>(parts),
          .group = std::move(names[0]),
          .channel = std::move(names[1])};
}

/// Whether values that were read depend on this property.
bool is_of_values(std::string_view name) {
  constexpr std::array<std::string_view, 5> kNames{"wf_start_offset", "wf_xunit_string",
                                                   "unit_string", "NI_UnitDescription",
                                                   "NI_Scaling_Status"};
  return std::ranges::find(kNames, name) != kNames.end() || name.starts_with("NI_Scale[") ||
         name == "NI_Number_Of_Scales";
}

std::string in_words(const TdmsValue& value) {
  if (const double* const number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  const std::string* const text = std::get_if<std::string>(&value);
  return text == nullptr ? "a time" : in_quotes(*text, 40);
}

/// A lead-in.
struct Segment {
  std::uint32_t contents = 0;
  bool swap = false;
  std::uint64_t next = 0;    ///< bytes to the next one
  std::uint64_t values = 0;  ///< bytes to the values
  bool cut = false;          ///< by the end of the file

  [[nodiscard]] bool has(std::uint32_t flag) const { return (contents & flag) != 0; }
};

class TdmsReader {
 public:
  TdmsReader(const std::string& path, bool allow_truncated, const Progress& progress)
      : file_(path, progress), allow_truncated_(allow_truncated) {}

  TdmsContents read() {
    while (file_.left() > 0 && !result_.truncated) read_segment();
    return std::move(result_);
  }

 private:
  /// An object of the segment that is read, with where its values lie.
  struct Active {
    std::size_t object;
    TdmsIndex index;
    bool is_left_out = false;
  };

  void read_segment() {
    if (file_.left() < kLeadIn) return end_early(kLeadIn);
    const Segment segment = read_lead_in();
    if (segment.cut && !allow_truncated_) return end_early(segment.next);
    result_.truncated = segment.cut;
    if (segment.has(kNewObjects)) {
      active_.clear();
      places_of_active_.clear();
    }
    if (segment.has(kHasMetadata)) {
      if (segment.values > file_.left()) return end_early(segment.values);
      const std::string place = fmt::format("{}, byte {}", file_.name(), file_.offset());
      const std::string_view bytes = file_.take(segment.values);
      for (TdmsEntry& entry : parse_tdms_metadata(bytes, segment.swap, place)) take(entry);
      leave_out();
    } else {
      file_.skip(std::min<std::size_t>(segment.values, file_.left()));
    }
    const std::size_t rest = std::min<std::size_t>(segment.next - segment.values, file_.left());
    const std::size_t before = file_.offset();
    if (segment.has(kHasValues)) read_values(segment, rest);
    file_.skip(rest - (file_.offset() - before));
  }

  void end_early(std::size_t expected) {
    if (!allow_truncated_ || result_.objects.empty()) {
      file_.fail(fmt::format("{} bytes of a segment", expected), "the end of the file",
                 "LabVIEW did not close it, or it was truncated: copy it again, or read what is "
                 "left with `allow_truncated`.");
    }
    result_.truncated = true;
    file_.skip(file_.left());
  }

  Segment read_lead_in() {
    std::string head(file_.take(4));
    if (head != "TDSm") file_.fail("the start of a segment, 'TDSm'", "other bytes");
    head += file_.take(kLeadIn - 4);
    Segment segment;
    constexpr bool kLittle = std::endian::native == std::endian::little;
    segment.contents = value_of_bytes<std::uint32_t>(head.data() + 4, !kLittle);
    segment.swap = segment.has(kBigEndian) == kLittle;
    segment.next = value_of_bytes<std::uint64_t>(head.data() + 12, segment.swap);
    segment.values = value_of_bytes<std::uint64_t>(head.data() + 20, segment.swap);
    segment.cut = segment.next == kNotClosed || segment.next > file_.left();
    if (segment.values > segment.next) {
      file_.fail("values within their segment", fmt::format("byte {}", segment.values));
    }
    return segment;
  }

  std::size_t object_of(const std::string& path) {
    const auto [found, is_new] = places_.try_emplace(path, result_.objects.size());
    if (is_new) {
      result_.objects.push_back(object_of_path(path));
    }
    return found->second;
  }

  void take(TdmsEntry& entry) {
    const std::size_t object = object_of(entry.path);
    for (auto& [name, value] : entry.properties.all) {
      take_property(result_.objects[object], name, std::move(value));
    }
    if (entry.has == TdmsEntry::Index::kNew) {
      known_.insert_or_assign(object, entry.index);
    } else if (entry.has == TdmsEntry::Index::kSame && !known_.contains(object)) {
      file_.fail("values described before", "an object without");
    }
    const auto there = places_of_active_.find(object);
    if (entry.has == TdmsEntry::Index::kNone) {
      if (there == places_of_active_.end()) return;
      active_[there->second].is_left_out = true;
      places_of_active_.erase(there);
    } else if (there != places_of_active_.end()) {
      active_[there->second].index = known_.at(object);
    } else {
      places_of_active_.emplace(object, active_.size());
      active_.push_back({object, known_.at(object)});
    }
  }

  static void take_property(TdmsObject& object, const std::string& name, TdmsValue value) {
    const auto known = object.properties.all.find(name);
    const bool changes =
        known != object.properties.all.end() && object.size() > 0 && known->second != value;
    const bool is_start = name == "wf_start_time";
    if (changes && name == "wf_increment") {
      if (!take_step(object, std::get_if<double>(&value))) return;
      object.properties.all.insert_or_assign(name, std::move(value));
      return;
    }
    if (changes && object.change.empty()) {
      if (is_start) object.change = gap_of(object, std::get_if<TdmsTime>(&value));
      if (is_of_values(name)) {
        object.change =
            fmt::format("{} ({}, then {})", name, in_words(known->second), in_words(value));
      }
    }
    if (changes && is_start) return;
    object.properties.all.insert_or_assign(name, std::move(value));
  }

  /// Keeps the former step for the values so far. Whether the next one counts: 0 states none, so
  /// that a former one goes on, and one behind it is that of all values.
  static bool take_step(TdmsObject& object, const double* next) {
    const double* const former = object.properties.number("wf_increment");
    if (!states_step(former)) return true;
    if (!states_step(next)) return false;
    object.former_steps.emplace_back(object.size(), *former);
    return true;
  }

  /// s, of all values, the last ones by `step`.
  static double length_of(const TdmsObject& object, double step) {
    double length = 0.0;
    std::size_t done = 0;
    for (const auto& [end, former] : object.former_steps) {
      length += former * static_cast<double>(end - done);
      done = end;
    }
    return length + step * static_cast<double>(object.size() - done);
  }

  /// In words, where values that begin at a time do not go on where those before them end; empty
  /// where they do, by half a step.
  static std::string gap_of(const TdmsObject& object, const TdmsTime* time) {
    const TdmsTime* const first = object.properties.time("wf_start_time");
    const double* const step = object.properties.number("wf_increment");
    if (first == nullptr || time == nullptr) return "wf_start_time";
    const double later = seconds_between(*first, *time);
    const double end = step == nullptr ? 0.0 : length_of(object, *step);
    if (step != nullptr && std::abs(later - end) <= 0.5 * *step) return {};
    return fmt::format("wf_start_time ({} s later, where {} s were recorded before)", later, end);
  }

  /// Takes off the objects that a segment says have no values any more.
  void leave_out() {
    if (active_.size() == places_of_active_.size()) return;
    std::erase_if(active_, &Active::is_left_out);
    for (std::size_t i = 0; i < active_.size(); ++i) places_of_active_[active_[i].object] = i;
  }

  void read_values(const Segment& segment, std::size_t bytes) {
    if (active_.empty()) return;
    const bool daqmx = active_.front().index.is_daqmx();
    for (const Active& active : active_) {
      if (active.index.is_daqmx() != daqmx) {
        file_.fail("channels of DAQmx, or none", "both in a segment");
      }
    }
    if (daqmx) {
      read_daqmx(segment, bytes);
    } else if (segment.has(kInterleaved)) {
      read_interleaved(segment, bytes);
    } else {
      read_contiguous(segment, bytes);
    }
  }

  /// How often what a segment states fits into its values.
  [[nodiscard]] std::size_t chunks_of(const Segment& segment, std::size_t bytes,
                                      std::size_t chunk) {
    if (chunk == 0) return 0;
    const std::size_t part = bytes % chunk;
    if (part != 0 && !segment.cut) {
      if (!allow_truncated_) {
        file_.fail(fmt::format("values of a multiple of {} bytes", chunk), fmt::format("{}", bytes),
                   "Its last chunk is not whole: save it again, or read the whole ones with "
                   "`allow_truncated`.");
      }
      result_.part_chunks += part;
    }
    return bytes / chunk;
  }

  /// The product, where it is not beyond what is left of the file.
  std::size_t bytes_of(std::uint64_t count, std::uint64_t size) const {
    if (size > 0 && count > std::numeric_limits<std::uint64_t>::max() / 4 / size) {
      file_.fail("values that the file can hold", fmt::format("{} of them", count));
    }
    return count * size;
  }

  std::size_t sum_of(std::size_t sum, std::size_t added) const {
    if (added > std::numeric_limits<std::size_t>::max() - sum) {
      file_.fail("values that the file can hold", "more");
    }
    return sum + added;
  }

  void read_contiguous(const Segment& segment, std::size_t bytes) {
    std::vector<std::pair<const Active*, std::size_t>> runs;
    std::size_t chunk = 0;
    for (const Active& active : active_) {
      const std::size_t run = active.index.type == kTdmsText
                                  ? active.index.bytes
                                  : bytes_of(active.index.count, tdms_size(active.index.type));
      chunk = sum_of(chunk, run);
      if (run > 0) runs.emplace_back(&active, run);
    }
    const std::size_t chunks = chunks_of(segment, bytes, chunk);
    for (const auto& [active, run] : runs) make_room_for(*active, chunks);
    for (std::size_t left = chunks; left > 0; --left) {
      for (const auto& [active, run] : runs) read_run(*active, run, segment.swap);
    }
  }

  /// For all chunks at once: room that grows by pieces is copied again and again.
  void make_room_for(const Active& active, std::size_t chunks) {
    const TdmsIndex& index = active.index;
    if (index.type == kTdmsText) return;
    std::vector<double>* const values = values_of(result_.objects[active.object], index.type);
    if (values != nullptr) make_room(*values, chunks * index.count);
  }

  void read_run(const Active& active, std::size_t bytes, bool swap) {
    TdmsObject& object = result_.objects[active.object];
    const TdmsIndex& index = active.index;
    if (index.type == kTdmsText) {
      object.other = "texts";
      return file_.skip(bytes);
    }
    const std::size_t size = tdms_size(index.type);
    std::vector<double>* const values = values_of(object, index.type);
    take_rows(file_, index.count, size, [&](const char* from, std::size_t count) {
      add(object, values, index.type, from, size, count, swap);
    });
  }

  /// Null where the values of the type are no numbers.
  std::vector<double>* values_of(TdmsObject& object, std::uint32_t type) {
    if (tdms_converter(type, false) != nullptr) return &source_of(object, 0);
    const bool is_extended = type == kTdmsExtended || type == kTdmsExtendedWithUnit;
    if (type != kTdmsTime)
      object.other = is_extended ? "numbers of extended precision" : "complex numbers";
    return nullptr;
  }

  void add(TdmsObject& object, std::vector<double>* values, std::uint32_t type, const char* from,
           std::size_t stride, std::size_t count, bool swap) {
    if (values != nullptr) {
      const bool is_large = type == kTdmsInt64 || type == kTdmsUint64;
      for (std::size_t i = 0; is_large && is_one_of(object.channel, kTimeNames) && i < count; ++i) {
        object.whole.bits.push_back(value_of_bytes<std::int64_t>(from + i * stride, swap));
        object.whole.is_signed = type == kTdmsInt64;
      }
      return tdms_converter(type, swap)(from, stride, count, grown(*values, count));
    }
    for (std::size_t i = 0; type == kTdmsTime && i < count; ++i) {
      object.times.push_back(tdms_time_of(from + i * stride, swap));
    }
  }

  void read_interleaved(const Segment& segment, std::size_t bytes) {
    std::size_t width = 0;
    for (const Active& active : active_) {
      const std::size_t size = tdms_size(active.index.type);
      if (size == 0) file_.fail("interleaved numbers", "texts");
      width += size;
    }
    const std::size_t rows = chunks_of(segment, bytes, width);
    take_rows(file_, rows, width, [&](const char* from, std::size_t count) {
      for (const Active& active : active_) {
        TdmsObject& object = result_.objects[active.object];
        add(object, values_of(object, active.index.type), active.index.type, from, width, count,
            segment.swap);
        from += tdms_size(active.index.type);
      }
    });
  }

  /// The rows of one block after those of the other, as many as the channels in it have values.
  void read_daqmx(const Segment& segment, std::size_t bytes) {
    const std::vector<std::uint32_t>& widths = active_.front().index.widths;
    std::vector<std::uint64_t> rows(widths.size());
    for (const Active& active : active_) {
      if (active.index.widths != widths) file_.fail("rows of the same widths", "others");
      for (const DaqmxScaler& scaler : active.index.scalers) {
        rows[scaler.buffer] = std::max(rows[scaler.buffer], active.index.count);
      }
    }
    std::size_t chunk = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      chunk = sum_of(chunk, bytes_of(rows[i], widths[i]));
    }
    for (std::size_t left = chunks_of(segment, bytes, chunk); left > 0; --left) {
      for (std::size_t i = 0; i < widths.size(); ++i) {
        if (widths[i] > 0) read_rows(i, rows[i], widths[i], segment.swap);
      }
    }
  }

  void read_rows(std::size_t buffer, std::size_t rows, std::size_t width, bool swap) {
    std::size_t done = 0;
    take_rows(file_, rows, width, [&](const char* from, std::size_t count) {
      for (const Active& active : active_) {
        const std::size_t of_channel =
            std::min<std::size_t>(count, active.index.count - std::min(active.index.count, done));
        for (const DaqmxScaler& scaler : active.index.scalers) {
          if (scaler.buffer == buffer) add_scaler(active, scaler, from, width, of_channel, swap);
        }
      }
      done += count;
    });
  }

  void add_scaler(const Active& active, const DaqmxScaler& scaler, const char* from,
                  std::size_t width, std::size_t count, bool swap) {
    TdmsObject& object = result_.objects[active.object];
    object.is_daqmx = true;
    const std::uint32_t type = tdms_type_of_daqmx(scaler.type);
    const ConvertBytes convert = tdms_converter(type, swap);
    const bool has_bits = type < 9;  // of integers
    if (convert == nullptr || (scaler.is_digital && !has_bits)) {
      object.other = fmt::format("values of the type {} of DAQmx", scaler.type);
      return;
    }
    const std::size_t first = scaler.is_digital ? scaler.offset / 8 : scaler.offset;
    double* const to = grown(source_of(object, scaler.id), count);
    convert(from + first, width, count, to);
    if (!scaler.is_digital) return;
    const std::uint32_t bit = scaler.offset % 8;
    std::transform(to, to + count, to, [bit](double value) {
      return static_cast<double>((static_cast<std::int64_t>(value) >> bit) & 1);
    });
  }

  PieceReader file_;
  bool allow_truncated_;
  TdmsContents result_;
  std::map<std::string, std::size_t> places_;  ///< of objects, by path
  std::map<std::size_t, TdmsIndex> known_;     ///< the last index of each object
  std::vector<Active> active_;
  std::map<std::size_t, std::size_t> places_of_active_;  ///< by object
};

}  // namespace

TdmsContents read_tdms(const std::string& path, bool allow_truncated, const Progress& progress) {
  return TdmsReader(path, allow_truncated, progress).read();
}

}  // namespace microslip
