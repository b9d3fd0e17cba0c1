// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/found_by_records.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/config/named_value_access.hpp"

namespace microslip {
namespace {

constexpr std::string_view kAgain = "Identify the joint again from its measurements.";

/// Reads an identification key by key, and names the one at fault.
class RecordKeys {
 public:
  RecordKeys(const NamedValues& identification, const std::string& path)
      : identification_(identification), path_(path) {}

  /// A value with its band, where there are both.
  [[nodiscard]] std::optional<BandedValue> banded(const std::string& key) const {
    const std::optional<double> value = number_in(identification_, key);
    if (!value) return std::nullopt;
    const std::vector<double> band = numbers(("band_" + key), 2);
    return BandedValue{*value, band[0], band[1]};
  }

  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const {
    std::vector<double> values = numbers_in(identification_, key);
    check_count(key, values.size(), count);
    return values;
  }

  [[nodiscard]] std::vector<std::string> texts(const std::string& key, std::size_t count) const {
    std::vector<std::string> values = texts_in(identification_, key);
    check_count(key, values.size(), count);
    return values;
  }

  /// As texts(), but for files that do not say it.
  [[nodiscard]] std::vector<std::string> texts_or_none(const std::string& key,
                                                       std::size_t count) const {
    std::vector<std::string> values = texts_in(identification_, key);
    return values.empty() ? std::vector<std::string>(count) : texts(key, count);
  }

  /// Numbers of records, from 0.
  [[nodiscard]] std::vector<std::size_t> records(const std::string& key, std::size_t count,
                                                 std::size_t most) const {
    std::vector<std::size_t> all;
    for (const double value : numbers(key, count)) {
      const bool whole = value >= 1.0 && value <= static_cast<double>(most) &&
                         value == static_cast<double>(static_cast<std::size_t>(value));
      if (!whole) {
        throw InputError(
            name_of(key), value,
            fmt::format("must be a whole number from 1 to the {} of the records", most), kAgain);
      }
      all.push_back(static_cast<std::size_t>(value) - 1);
    }
    return all;
  }

 private:
  [[nodiscard]] std::string name_of(const std::string& key) const {
    return fmt::format("{}: identification.{}", path_, key);
  }

  void check_count(const std::string& key, std::size_t found, std::size_t expected) const {
    if (found == expected) return;
    throw InputError(name_of(key), fmt::format("{} values", found),
                     fmt::format("must be {}, to match the other data", expected), kAgain);
  }

  const NamedValues& identification_;
  const std::string& path_;
};

/// The departures that were looked for, in the order of the file.
std::vector<DepartureFound> departures_in(const RecordKeys& keys, std::size_t count) {
  const std::vector<std::string> departure = keys.texts("verdict_departure", count);
  const std::vector<std::string> verdict = keys.texts("verdict", count);
  const std::vector<double> share = keys.numbers("verdict_share", count);
  const std::vector<double> noise = keys.numbers("verdict_noise", count);
  std::vector<DepartureFound> found;
  for (std::size_t i = 0; i < count; ++i) {
    found.push_back({departure[i], share[i], noise[i], verdict[i] == "broken"});
  }
  return found;
}

void add_verdicts(const NamedValues& identification, const RecordKeys& keys,
                  std::vector<RecordFound>& records) {
  const std::size_t count = numbers_in(identification, "verdict_record").size();
  const std::vector<std::size_t> record = keys.records("verdict_record", count, records.size());
  const std::vector<DepartureFound> found = departures_in(keys, count);
  for (std::size_t i = 0; i < count; ++i) records[record[i]].verdicts.push_back(found[i]);
}

void add_offsets(const NamedValues& identification, const RecordKeys& keys,
                 std::vector<RecordFound>& records) {
  const std::vector<double> offset = numbers_in(identification, "offset_force_N");
  const std::vector<std::size_t> record =
      keys.records("offset_record", offset.size(), records.size());
  for (std::size_t i = 0; i < offset.size(); ++i) records[record[i]].offset.push_back(offset[i]);
}

}  // namespace

std::optional<FoundByRecords> found_by_records(const JointFile& file, const std::string& path) {
  const NamedValues& identification = file.identification;
  const std::size_t count = numbers_in(identification, "scatter_force_N").size();
  if (count == 0) return std::nullopt;
  const RecordKeys keys(identification, path);
  FoundByRecords found{.stiffness = keys.banded("stiffness_N_per_m"),
                       .elastic = keys.banded("elastic_stiffness_N_per_m"),
                       .viscous = keys.banded(std::string(kViscousKey)),
                       .draws = number_in(identification, "band_samples")};
  const std::vector<double> scatter = keys.numbers("scatter_force_N", count);
  const std::vector<double> correlation = keys.numbers("correlation", count);
  const std::vector<double> unexplained = keys.numbers("unexplained", count);
  const std::vector<std::string> start = keys.texts("start", count);
  const std::vector<std::string> start_from = keys.texts_or_none("start_from", count);
  const std::vector<std::string> source = keys.texts_or_none("record_source", count);
  for (std::size_t r = 0; r < count; ++r) {
    found.records.push_back({.source = source[r],
                             .start = start[r],
                             .start_from = start_from[r],
                             .scatter = scatter[r],
                             .correlation = correlation[r],
                             .unexplained = unexplained[r]});
  }
  add_offsets(identification, keys, found.records);
  add_verdicts(identification, keys, found.records);
  return found;
}

std::vector<DepartureFound> departures_of_levels(const JointFile& file, const std::string& path) {
  const NamedValues& identification = file.identification;
  if (!numbers_in(identification, "verdict_record").empty()) return {};
  return departures_in(RecordKeys(identification, path),
                       texts_in(identification, "verdict_departure").size());
}

}  // namespace microslip
