// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/verified_results.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/documents/response/verification_file.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/results/result_tables.hpp"

namespace microslip {
namespace {

/// A few cycles, the prediction finer than the samples.
SignalPair history_of(const Verification& record, const ChannelComparison& channel) {
  constexpr std::size_t kSteps = 400;
  SignalPair signal{
      channel.name, si_unit(channel.dimension), record.history, channel.recorded_history, {}, {}};
  const double from = record.history.front();
  const double step = (record.history.back() - from) / static_cast<double>(kSteps);
  for (std::size_t i = 0; i <= kSteps; ++i) {
    signal.other_time.push_back(from + static_cast<double>(i) * step);
    signal.other.push_back(channel.predicted.value(signal.other_time.back()));
  }
  return signal;
}

HarmonicsPair harmonics_of(const ChannelComparison& channel) {
  HarmonicsPair harmonics{channel.name, si_unit(channel.dimension), {}, {}, channel.recorded_std};
  for (std::size_t n = 1; n <= channel.recorded.order(); ++n) {
    harmonics.recorded.push_back(std::abs(channel.recorded.c(n)));
    harmonics.other.push_back(std::abs(channel.predicted.c(n)));
  }
  return harmonics;
}

/// The accelerometer at the exciter before the others, which it is the measure of.
std::vector<const ChannelComparison*> channels_of(const Verification& record) {
  std::vector<const ChannelComparison*> channels;
  for (const ChannelComparison& channel : record.channels) channels.push_back(&channel);
  if (record.drive_point && *record.drive_point > 1) {
    std::rotate(channels.begin() + 1,
                channels.begin() + static_cast<std::ptrdiff_t>(*record.drive_point),
                channels.begin() + static_cast<std::ptrdiff_t>(*record.drive_point) + 1);
  }
  return channels;
}

}  // namespace

void add_verified(std::span<const Verification> records, ExperimentResults& results) {
  if (records.empty()) return;
  results.comparisons =
      comparisons_of({std::string(kVerificationKind), verification_table(records).str()});
  for (const Verification& record : records) {
    LevelRecord level{record.recorded.source, {}, {}};
    for (const ChannelComparison* channel : channels_of(record)) {
      level.signals.push_back(history_of(record, *channel));
      level.harmonics.push_back(harmonics_of(*channel));
    }
    results.predictions.push_back(std::move(level));
  }
}

}  // namespace microslip
