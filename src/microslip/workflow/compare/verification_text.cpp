// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/verification_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr std::size_t kSourceWidth = 14;
constexpr std::size_t kChannelWidth = 8;

std::string describe_model(const Verifier& verifier) {
  const VerificationOptions& options = verifier.options();
  const Joint& joint = verifier.joint();
  std::string text = line("modes", fmt::format("{} in the stick state, from {:.2f} Hz",
                                               verifier.reducer().state().modes(),
                                               natural_frequency(verifier.reducer().state(), 0.0)));
  std::string covered = fmt::format("k = {:.5g} N/m", joint.stiffness());
  if (options.covered_to) {
    covered += ", identified up to " + length_text(*options.covered_to / joint.stiffness());
  }
  text += line("joint", covered);
  if (options.linear_damping > 0.0) {
    text += line("linear damping", damping_text(options.linear_damping) + ", as identified");
  }
  text += line("force", options.sine ? "a pure sine" : "with its recorded harmonics");
  return text + line("input to the model", "frequency, and first harmonic of the drive point");
}

std::string header(const Verification& first) {
  std::string text = fmt::format("\n  {:<{}} {:>8} {:>8} {:>7} {:>7} {:>8} | NRMSE [%]\n", "",
                                 kSourceWidth, "", "", "", "", "");
  text += fmt::format("  {:<{}} {:>8} {:>8} {:>7} {:>7} {:>8} |", "source", kSourceWidth, "f [Hz]",
                      "a[m/s²]", "A [µm]", "Δf[mHz]", "ΔW [%]");
  for (const ChannelComparison& channel : first.channels) {
    text += fmt::format(" {:>{}}", shortened(channel.name, kChannelWidth), kChannelWidth);
  }
  return text + "\n";
}

std::string describe_record(const Verification& record) {
  const double energy = record.predicted.input_energy / record.recorded.input_energy.value - 1.0;
  const std::string offset = record.predicted.frequency_offset
                                 ? fmt::format("{:+.1f}", 1e3 * *record.predicted.frequency_offset)
                                 : "-";
  std::string text = fmt::format("  {:<{}} {:8.3f} {:8.3g} {:7.4g} {:>7} {:+8.2f} |",
                                 shortened(record.recorded.source, kSourceWidth), kSourceWidth,
                                 record.recorded.frequency, record.recorded.response_amplitude,
                                 1e6 * record.recorded.amplitude.value, offset, 100.0 * energy);
  for (const ChannelComparison& channel : record.channels) {
    text += fmt::format(" {:{}.3f}", 100.0 * channel.nrmse, kChannelWidth);
  }
  return text + (record.summary.converged() ? "\n" : " !\n");
}

/// Of each channel the record with the largest NRMSE, and how much of it is noise.
std::string describe_worst(const std::vector<Verification>& records) {
  std::string text = "Largest NRMSE of each channel, and that of its noise alone\n";
  for (std::size_t j = 0; j < records.front().channels.size(); ++j) {
    const auto worst = std::ranges::max_element(
        records, {}, [&](const Verification& record) { return record.channels[j].nrmse; });
    const ChannelComparison& channel = worst->channels[j];
    text += line(channel.name,
                 fmt::format("{:.3f} %, {:.3f} %  in {}", 100.0 * channel.nrmse,
                             100.0 * channel.noise_share, shortened(worst->recorded.source, 30)));
  }
  return text;
}

std::vector<Warning> kinds_of_warnings(const std::vector<Verification>& records,
                                       std::size_t source_width) {
  std::vector<FlaggedRecord> flagged;
  for (const Verification& record : records) {
    flagged.push_back({record.recorded.source, record.warnings});
    std::ranges::copy(record.recorded.flags, std::back_inserter(flagged.back().flags));
  }
  return kinds_of(flagged, "records", source_width);
}

std::string describe_troubles(const VerificationBatch& batch) {
  std::string text;
  for (const Verification& record : batch.records) {
    if (record.summary.converged()) continue;
    text += wrapped(fmt::format("  {} (!): ", shortened(record.recorded.source, 30)),
                    record.summary.brief(), 4);
  }
  for (const Warning& kind : kinds_of_warnings(batch.records, 30)) {
    text += wrapped("  ", fmt::format("{} [{}]", kind.text, kind.code), 4);
  }
  for (const RejectedRecord& record : batch.rejected) {
    text += fmt::format("  Left out: {}\n", record.reason);
  }
  return text.empty() ? text : "\nTo be checked\n" + text;
}

}  // namespace

std::string describe_verification(const Verifier& verifier, const VerificationBatch& batch) {
  std::string text = fmt::format("Verification by {}\n{}", counted(batch.records.size(), "record"),
                                 describe_model(verifier));
  text += header(batch.records.front());
  for (const Verification& record : batch.records) text += describe_record(record);
  text +=
      "\n  Δf  resonance of the model above that of the record, by the phase of the force"
      "\n  ΔW  energy input per cycle, predicted over recorded, minus 1"
      "\n  NRMSE  rms(recorded − predicted)/rms(recorded), without means\n\n";
  return text + describe_worst(batch.records) + describe_troubles(batch);
}

// Without wall times, which Summary::brief() has: the same call writes the same bytes.
std::vector<Warning> verification_warnings(const VerificationBatch& batch) {
  std::vector<Warning> warnings;
  for (const Verification& record : batch.records) {
    if (record.summary.converged()) continue;
    warnings.push_back(
        {"not_converged", fmt::format("{}: {}", record.recorded.source, record.summary.reason)});
  }
  std::ranges::move(kinds_of_warnings(batch.records, std::string::npos),
                    std::back_inserter(warnings));
  for (const RejectedRecord& record : batch.rejected) {
    warnings.push_back({"left_out", record.reason});
  }
  return warnings;
}

}  // namespace microslip
