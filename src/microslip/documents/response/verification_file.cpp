// SPDX-License-Identifier: MIT
#include "microslip/documents/response/verification_file.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>
#include "microslip/base/codes.hpp"

namespace microslip {
namespace {

/// A value for each pair of a record and something in it, record by record.
template <typename Count, typename Value>
auto column(std::span<const Verification> records, Count count, Value value) {
  std::vector<decltype(value(records.front(), std::size_t{0}))> values;
  for (const Verification& record : records) {
    for (std::size_t i = 0; i < count(record); ++i) values.push_back(value(record, i));
  }
  return values;
}

std::string flags_of(const Verification& record) {
  std::string flags = joined_codes(record.recorded.flags);
  for (const Warning& warning : record.warnings) add_code(flags, warning.code);
  return flags;
}

std::size_t channel_count(const Verification& record) { return record.channels.size(); }

/// Of the first harmonic.
std::complex<double> predicted_over_recorded(const ChannelComparison& channel) {
  return channel.predicted.c(1) / channel.recorded.c(1);
}

/// Harmonic n with the zero of time of harmonics_table().
std::complex<double> shifted_harmonic(const Verification& record, const FourierSeries& series,
                                      std::size_t n) {
  return series.c(n) * std::polar(1.0, -static_cast<double>(n) * record.phase);
}

void add_record_columns(CsvWriter& writer, std::span<const Verification> records) {
  const auto add = [&](std::string_view name, const Dimension& dimension, auto value) {
    writer.add_numbers(name, dimension,
                       column(records, channel_count, [&](const Verification& record, std::size_t) {
                         return value(record);
                       }));
  };
  add("joint_amplitude", kLength, [](const auto& r) { return r.recorded.amplitude.value; });
  add("predicted_joint_amplitude", kLength, [](const auto& r) { return r.predicted.amplitude; });
  add("input_energy", kEnergy, [](const auto& r) { return r.recorded.input_energy.value; });
  add("predicted_input_energy", kEnergy, [](const auto& r) { return r.predicted.input_energy; });
  if (std::ranges::all_of(records,
                          [](const auto& r) { return r.predicted.frequency_offset.has_value(); })) {
    add("frequency_offset", kFrequency,
        [](const auto& r) { return *r.predicted.frequency_offset; });
  }
  writer.add_text("flags",
                  column(records, channel_count,
                         [](const Verification& record, std::size_t) { return flags_of(record); }));
}

}  // namespace

CsvWriter verification_table(std::span<const Verification> records) {
  CsvWriter writer;
  const auto add_text = [&](std::string_view name, auto value) {
    writer.add_text(name, column(records, channel_count, value));
  };
  const auto add = [&](std::string_view name, const Dimension& dimension, auto value) {
    writer.add_numbers(name, dimension, column(records, channel_count, value));
  };
  add_text("source", [](const auto& r, std::size_t) { return r.recorded.source; });
  add_text("channel", [](const auto& r, std::size_t j) { return r.channels[j].name; });
  add_text("status", [](const auto& r, std::size_t) { return std::string(r.summary.status()); });
  add("frequency", kFrequency, [](const auto& r, std::size_t) { return r.recorded.frequency; });
  add("response_amplitude", kAcceleration,
      [](const auto& r, std::size_t) { return r.recorded.response_amplitude; });
  add("NRMSE", kDimensionless, [](const auto& r, std::size_t j) { return r.channels[j].nrmse; });
  add("noise_share", kDimensionless,
      [](const auto& r, std::size_t j) { return r.channels[j].noise_share; });
  add("amplitude_ratio", kDimensionless, [](const auto& r, std::size_t j) {
    return std::abs(predicted_over_recorded(r.channels[j]));
  });
  add("phase_error", kAngle, [](const auto& r, std::size_t j) {
    return std::arg(predicted_over_recorded(r.channels[j]));
  });
  add_record_columns(writer, records);
  return writer;
}

CsvWriter harmonics_table(std::span<const Verification> records) {
  CsvWriter writer;
  const auto order = [](const Verification& record) {
    return record.channels.front().recorded.order();
  };
  const auto add = [&](const std::string& name, const Dimension& dimension, auto value) {
    writer.add_numbers(name, dimension,
                       column(records, order, [&](const Verification& record, std::size_t i) {
                         return value(record, i + 1);
                       }));
  };
  writer.add_text("source", column(records, order,
                                   [](const auto& r, std::size_t) { return r.recorded.source; }));
  add("harmonic", kDimensionless,
      [](const auto&, std::size_t n) { return static_cast<double>(n); });
  add("frequency", kFrequency,
      [](const auto& r, std::size_t n) { return static_cast<double>(n) * r.recorded.frequency; });
  const std::size_t channels = records.empty() ? 0 : records.front().channels.size();
  for (std::size_t j = 0; j < channels; ++j) {
    const std::string name = records.front().channels[j].name;
    const Dimension& dimension = records.front().channels[j].dimension;
    const auto add_series = [&](const std::string& which, auto series) {
      add(name + which, dimension,
          [&](const auto& r, std::size_t n) { return std::abs(series(r.channels[j]).c(n)); });
      add(name + which + "_phase", kAngle, [&](const auto& r, std::size_t n) {
        return std::arg(shifted_harmonic(r, series(r.channels[j]), n));
      });
    };
    add_series(
        "_recorded", [](const auto& channel) -> const auto& { return channel.recorded; });
    add(name + "_recorded_std", dimension,
        [&](const auto& r, std::size_t n) { return r.channels[j].recorded_std[n - 1]; });
    add_series(
        "_predicted", [](const auto& channel) -> const auto& { return channel.predicted; });
  }
  return writer;
}

CsvWriter histories_table(std::span<const Verification> records) {
  CsvWriter writer;
  const auto samples = [](const Verification& record) { return record.history.size(); };
  writer.add_text("source", column(records, samples,
                                   [](const auto& r, std::size_t) { return r.recorded.source; }));
  writer.add_numbers("time", kTime, column(records, samples, [](const auto& r, std::size_t i) {
                       return r.history[i];
                     }));
  const std::size_t channels = records.empty() ? 0 : records.front().channels.size();
  for (std::size_t j = 0; j < channels; ++j) {
    const ChannelComparison& first = records.front().channels[j];
    writer.add_numbers(first.name + "_recorded", first.dimension,
                       column(records, samples, [&](const auto& r, std::size_t i) {
                         return r.channels[j].recorded_history[i];
                       }));
    writer.add_numbers(first.name + "_predicted", first.dimension,
                       column(records, samples, [&](const auto& r, std::size_t i) {
                         return r.channels[j].predicted_history[i];
                       }));
  }
  return writer;
}

}  // namespace microslip
