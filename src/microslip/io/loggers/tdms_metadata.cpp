// SPDX-License-Identifier: MIT
#include "microslip/io/loggers/tdms_metadata.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/character_set.hpp"
#include "microslip/io/loggers/piece_reader.hpp"

namespace microslip {
namespace {

constexpr std::uint32_t kNoValues = 0xFFFFFFFF;
constexpr std::uint32_t kSameAsBefore = 0;
constexpr std::uint32_t kFormatChanging = 0x1269;
constexpr std::uint32_t kDigitalLine = 0x126A;
constexpr std::uint32_t kVoid = 0;  ///< a property without value
constexpr std::string_view kSaveOtherwise =
    "Let LabVIEW or DIAdem save it as numbers of double precision.";

/// Takes the bytes of metadata one after the other.
class MetadataCursor {
 public:
  MetadataCursor(std::string_view bytes, bool swap, const std::string& place)
      : bytes_(bytes), swap_(swap), place_(place) {}

  template <class T>
  T value() {
    return value_of_bytes<T>(take(sizeof(T)).data(), swap_);
  }

  std::string text() { return to_utf8(take(value<std::uint32_t>())); }

  [[nodiscard]] bool swap() const { return swap_; }

  std::string_view take(std::size_t size) {
    if (size > bytes_.size() - at_) {
      fail(fmt::format("{} bytes", size), fmt::format("{}", bytes_.size() - at_));
    }
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  [[noreturn]] void fail(std::string_view expected, std::string_view found,
                         std::string_view remedy = PieceReader::kDamaged) const {
    throw FormatError({.file = fmt::format("{} + {}", place_, at_)}, expected, found, remedy);
  }

 private:
  std::string_view bytes_;
  bool swap_;
  const std::string& place_;
  std::size_t at_ = 0;
};

TdmsTime parse_time(MetadataCursor& from) {
  return tdms_time_of(from.take(tdms_size(kTdmsTime)).data(), from.swap());
}

TdmsValue parse_value(MetadataCursor& from) {
  const auto type = from.value<std::uint32_t>();
  if (const ConvertBytes convert = tdms_converter(type, from.swap())) {
    double number = 0.0;
    convert(from.take(tdms_size(type)).data(), tdms_size(type), 1, &number);
    return number;
  }
  switch (type) {
    case kVoid:
      return std::string{};
    case kTdmsText:
      return from.text();
    case kTdmsTime:
      return parse_time(from);
    default:
      (void)from.take(tdms_size(type));
      if (tdms_size(type) == 0) {
        from.fail("a property of a known type", fmt::format("{}", type), kSaveOtherwise);
      }
      return std::string{};
  }
}

DaqmxScaler parse_scaler(MetadataCursor& from, bool is_digital) {
  DaqmxScaler scaler{.is_digital = is_digital};
  scaler.type = from.value<std::uint32_t>();
  scaler.buffer = from.value<std::uint32_t>();
  scaler.offset = from.value<std::uint32_t>();
  (void)from.take(is_digital ? 1 : 4);  // the format of the samples, of which there is one
  scaler.id = from.value<std::uint32_t>();
  return scaler;
}

void parse_daqmx(MetadataCursor& from, TdmsIndex& index, bool is_digital) {
  for (auto count = from.value<std::uint32_t>(); count > 0; --count) {
    index.scalers.push_back(parse_scaler(from, is_digital));
  }
  for (auto count = from.value<std::uint32_t>(); count > 0; --count) {
    index.widths.push_back(from.value<std::uint32_t>());
  }
  if (index.scalers.empty() || index.widths.empty()) from.fail("scalers of DAQmx", "none");
  for (const DaqmxScaler& scaler : index.scalers) {
    const std::size_t first = scaler.is_digital ? scaler.offset / 8 : scaler.offset;
    const std::size_t size = tdms_size(tdms_type_of_daqmx(scaler.type));
    const bool fits =
        scaler.buffer < index.widths.size() && first + size <= index.widths[scaler.buffer];
    if (!fits) from.fail("values within their row", fmt::format("byte {}", first));
  }
}

TdmsIndex parse_index(MetadataCursor& from, std::uint32_t header) {
  TdmsIndex index;
  index.type = from.value<std::uint32_t>();
  const auto dimensions = from.value<std::uint32_t>();
  if (dimensions != 1) from.fail("values of one dimension", fmt::format("{}", dimensions));
  index.count = from.value<std::uint64_t>();
  if (header == kFormatChanging || header == kDigitalLine) {
    parse_daqmx(from, index, header == kDigitalLine);
  } else if (index.type == kTdmsText) {
    index.bytes = from.value<std::uint64_t>();
  } else if (tdms_size(index.type) == 0) {
    from.fail("values of a known type", fmt::format("type {}", index.type), kSaveOtherwise);
  }
  return index;
}

TdmsEntry parse_entry(MetadataCursor& from) {
  TdmsEntry entry{.path = from.text()};
  const auto header = from.value<std::uint32_t>();
  if (header == kSameAsBefore) {
    entry.has = TdmsEntry::Index::kSame;
  } else if (header != kNoValues) {
    entry.has = TdmsEntry::Index::kNew;
    entry.index = parse_index(from, header);
  }
  for (auto count = from.value<std::uint32_t>(); count > 0; --count) {
    std::string name = from.text();
    entry.properties.all.insert_or_assign(std::move(name), parse_value(from));
  }
  return entry;
}

template <class Value>
const Value* find_property(const TdmsProperties& properties, std::string_view name) {
  const auto found = properties.all.find(name);
  return found == properties.all.end() ? nullptr : std::get_if<Value>(&found->second);
}

}  // namespace

std::uint32_t tdms_type_of_daqmx(std::uint32_t type) {
  constexpr std::array<std::uint32_t, 10> kTypes{5, 1, 6, 2, 7, 3, 8, 4, 9, 10};
  return type < kTypes.size() ? kTypes[type] : 0;
}

ConvertBytes tdms_converter(std::uint32_t type, bool swap) {
  switch (type) {
    case 1:
      return converter<std::int8_t>(swap);
    case 2:
      return converter<std::int16_t>(swap);
    case 3:
      return converter<std::int32_t>(swap);
    case 4:
      return converter<std::int64_t>(swap);
    case 5:
    case 0x21:  // true or false
      return converter<std::uint8_t>(swap);
    case 6:
      return converter<std::uint16_t>(swap);
    case 7:
      return converter<std::uint32_t>(swap);
    case 8:
      return converter<std::uint64_t>(swap);
    case 9:
    case 0x19:
      return converter<float>(swap);
    case 10:
    case 0x1A:
      return converter<double>(swap);
    default:
      return nullptr;
  }
}

std::size_t tdms_size(std::uint32_t type) {
  switch (type) {
    case 1:
    case 5:
    case 0x21:
      return 1;
    case 2:
    case 6:
      return 2;
    case 3:
    case 7:
    case 9:
    case 0x19:
      return 4;
    case 4:
    case 8:
    case 10:
    case 0x1A:
    case 0x08000C:  // complex, two of single precision
      return 8;
    case kTdmsExtended:
    case kTdmsExtendedWithUnit:
    case kTdmsTime:
    case 0x10000D:  // complex, two of double precision
      return 16;
    default:
      return 0;
  }
}

TdmsTime tdms_time_of(const char* from, bool swap) {
  // The least significant bytes come first, but where the most significant do.
  const bool big = swap == (std::endian::native == std::endian::little);
  return {.seconds = value_of_bytes<std::int64_t>(from + (big ? 0 : 8), swap),
          .fraction = value_of_bytes<std::uint64_t>(from + (big ? 8 : 0), swap)};
}

double seconds_between(const TdmsTime& from, const TdmsTime& to) {
  // Seconds since 1904 are below 2^53: as doubles they are exact.
  const double whole = static_cast<double>(to.seconds) - static_cast<double>(from.seconds);
  const double part = static_cast<double>(to.fraction) - static_cast<double>(from.fraction);
  return whole + std::ldexp(part, -64);
}

bool states_step(const double* increment) {
  return increment != nullptr && *increment > 0.0 && std::isfinite(*increment);
}

const double* TdmsProperties::number(std::string_view name) const {
  return find_property<double>(*this, name);
}

const std::string* TdmsProperties::text(std::string_view name) const {
  return find_property<std::string>(*this, name);
}

const TdmsTime* TdmsProperties::time(std::string_view name) const {
  return find_property<TdmsTime>(*this, name);
}

std::vector<TdmsEntry> parse_tdms_metadata(std::string_view bytes, bool swap,
                                           const std::string& place) {
  MetadataCursor from(bytes, swap, place);
  std::vector<TdmsEntry> entries;
  for (auto count = from.value<std::uint32_t>(); count > 0; --count) {
    entries.push_back(parse_entry(from));
  }
  return entries;
}

}  // namespace microslip
