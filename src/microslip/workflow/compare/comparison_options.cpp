// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/comparison_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/text.hpp"

namespace microslip {
namespace {

bool is_of_loops(const ReadTest& test) {
  return std::holds_alternative<std::vector<NamedForceRecord>>(test.content);
}

bool is_of_modes(const ReadTest& test) { return std::holds_alternative<ModalLevels>(test.content); }

std::string_view words_of(const ReadTest& test) {
  if (is_of_loops(test)) return "records of force and displacement";
  if (!is_of_modes(test)) return "stepped-sine tables";
  return test.is_recording ? "recordings of ring-downs" : "tables of modal levels";
}

/// "stepped-sine tables and tables of modal levels".
std::string words_of(std::span<const ReadTest> read) {
  std::vector<std::string_view> kinds;
  for (const ReadTest& test : read) {
    if (std::ranges::count(kinds, words_of(test)) == 0) kinds.push_back(words_of(test));
  }
  return fmt::format("{}", fmt::join(kinds, " and "));
}

/// An option that was given.
class GivenOption {
 public:
  /// @param name  in back quotes. @param value  as given; empty for a flag.
  GivenOption(std::string_view name, std::string_view value) : name_(name), value_(value) {}

  [[noreturn]] void refuse(std::string_view rule, std::string_view remedy) const {
    if (value_.empty()) throw InputError(name_, InputState{"given"}, rule, remedy);
    throw InputError(name_, in_quotes(value_), rule, remedy);
  }

  /// Refuses it unless a test uses it. @param users  what such tests are.
  template <typename Uses>
  void require(std::span<const ReadTest> read, const Uses& uses, std::string_view users) const {
    if (std::ranges::any_of(read, uses)) return;
    refuse(
        fmt::format("has no effect: it applies to {}, and the tests are {}", users, words_of(read)),
        "Leave it out.");
  }

 private:
  std::string_view name_;
  std::string value_;
};

void check_reading(const TestReading& reading, std::span<const ReadTest> read) {
  constexpr std::string_view kRecordings = "recordings over time";
  const auto is_recording = [](const ReadTest& test) { return test.is_recording; };
  const AssumedUnits& units = reading.reading.assumed_units;
  if (units.si || !units.named.empty()) {
    const std::string first = units.named.empty() ? "SI" : units.named.front().first;
    GivenOption("`assume_units`", first).require(read, is_recording, kRecordings);
  }
  if (reading.reading.allow_truncated) {
    GivenOption("`allow_truncated`", "").require(read, is_recording, kRecordings);
  }
  if (reading.reading.rate) {
    GivenOption("`rate`", fmt::format("{:.12g} Hz", *reading.reading.rate))
        .require(read, is_recording, kRecordings);
  }
  if (!reading.channels.force.empty()) {
    GivenOption("`force`", reading.channels.force)
        .require(read, is_of_loops, "records of force and displacement");
  }
  if (!reading.channels.displacement.empty()) {
    GivenOption("`displacement`", reading.channels.displacement)
        .require(read, is_of_loops, "records of force and displacement");
  }
}

void check_ring_down_options(const TestReading& reading, std::span<const ReadTest> read) {
  if (!reading.sensors.empty()) {
    const auto uses = [](const ReadTest& test) { return is_of_modes(test) && test.is_recording; };
    GivenOption("`sensor`", reading.sensors.front())
        .require(read, uses, "recordings of ring-downs");
  }
  for (const std::size_t mode : reading.modes) {
    const GivenOption option("`mode`", std::to_string(mode));
    option.require(read, is_of_modes, "ring-downs");
    const auto has_it = [&](const ReadTest& test) {
      return is_of_modes(test) &&
             std::ranges::count(std::get<ModalLevels>(test.content).mode, mode - 1) > 0;
    };
    if (!std::ranges::any_of(read, has_it)) {
      option.refuse("has no effect: no test has this mode", "Leave it out, or name its test.");
    }
  }
}

void check_prediction_options(const TestsVerification& options, std::span<const ReadTest> read) {
  constexpr std::string_view kStructure = "tests of a structure: sweeps and ring-downs";
  const auto is_of_structure = [](const ReadTest& test) { return !is_of_loops(test); };
  if (options.harmonics) {
    GivenOption("`harmonics`", std::to_string(*options.harmonics))
        .require(read, is_of_structure, kStructure);
  }
  if (options.draws && options.draws->correlation != Correlation::kAuto) {
    GivenOption("`correlation`",
                options.draws->correlation == Correlation::kTogether ? "together" : "independent")
        .require(read, is_of_structure, kStructure);
  }
  if (!options.joint.empty()) {
    GivenOption("`joint`", options.joint)
        .require(read, is_of_loops, "records of force and displacement");
  }
}

}  // namespace

void check_predictor_options(const TestsVerification& options, bool alone) {
  constexpr std::string_view kLeave = "Leave it out.";
  if (alone && !options.joint.empty()) {
    GivenOption("`joint`", options.joint)
        .refuse("must not be given with a joint.json, which is a single joint", kLeave);
  }
  if (alone) return;
  constexpr std::string_view kSaid =
      "must not be given with a model.toml, which specifies its uncertainty";
  if (!options.uncertain.samples.empty()) {
    GivenOption("`samples`", options.uncertain.samples)
        .refuse(kSaid, "Name the draws by the key samples of its [[joint]].");
  }
  if (options.uncertain.normal_load > 0.0) {
    GivenOption("`normal_load_std`", fmt::format("{:g}", options.uncertain.normal_load))
        .refuse(kSaid, "Give the key normal_load_std of its [[joint]].");
  }
}

void check_test_options(const TestsVerification& options, std::span<const ReadTest> read) {
  check_reading(options.reading, read);
  check_ring_down_options(options.reading, read);
  check_prediction_options(options, read);
}

}  // namespace microslip
