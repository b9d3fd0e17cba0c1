// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/modal_reduction_file.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>
#include "microslip/base/codes.hpp"

namespace microslip {
namespace {

/// Share of a joint's force that no sensor shows, above which its D is not given.
constexpr double kMostUnseen = 0.1;
/// Largest relative uncertainty of an amplitude that is given nevertheless.
constexpr double kKnownAmplitude = 0.05;

using LevelValue = std::function<double(const ModalLevel&)>;
using LevelMeasured = std::function<const Measured&(const ModalLevel&)>;

/// Columns of the same levels.
class ModalColumns {
 public:
  explicit ModalColumns(std::span<const ModalLevel> levels) : levels_(levels) {}

  void add(std::string_view name, const Dimension& dimension, const LevelValue& value) {
    std::vector<double> values;
    for (const ModalLevel& level : levels_) values.push_back(value(level));
    writer_.add_numbers(name, dimension, values);
  }

  /// With its standard deviation.
  void add_measured(const std::string& name, const Dimension& dimension,
                    const LevelMeasured& measured) {
    add(name, dimension, [&](const ModalLevel& level) { return measured(level).value; });
    add_std(name, dimension, measured);
  }

  void add_std(const std::string& name, const Dimension& dimension, const LevelMeasured& measured) {
    add(name + "_std", dimension, [&](const ModalLevel& level) { return measured(level).std; });
  }

  void add_joint(const std::string& name, std::size_t index);

  void add_text(std::string_view name, const std::function<std::string(const ModalLevel&)>& value) {
    std::vector<std::string> values;
    for (const ModalLevel& level : levels_) values.push_back(value(level));
    writer_.add_text(name, values);
  }

  [[nodiscard]] CsvWriter done() { return std::move(writer_); }

 private:
  std::span<const ModalLevel> levels_;
  CsvWriter writer_;
};

void ModalColumns::add_joint(const std::string& name, std::size_t index) {
  const auto all = [&](const auto& rule) {
    return std::ranges::all_of(levels_,
                               [&](const ModalLevel& level) { return rule(level.joints[index]); });
  };
  const auto is_seen = [](const JointLevel& joint) { return joint.unseen <= kMostUnseen; };
  const bool seen = all(is_seen);
  const bool amplitude_known = all([&](const JointLevel& joint) {
    return is_seen(joint) || joint.amplitude.std <= kKnownAmplitude * joint.amplitude.value;
  });
  add_measured(
      (amplitude_known ? "amplitude_" : "assumed_amplitude_") + name, kLength,
      [=](const ModalLevel& level) -> const Measured& { return level.joints[index].amplitude; });
  if (!seen) {
    add("unseen_" + name, kDimensionless,
        [=](const ModalLevel& level) { return level.joints[index].unseen; });
    return;
  }
  add_measured("dissipation_" + name, kEnergy, [=](const ModalLevel& level) -> const Measured& {
    return level.joints[index].dissipation;
  });
  add_measured("secant_stiffness_" + name, kStiffness,
               [=](const ModalLevel& level) -> const Measured& {
                 return level.joints[index].secant_stiffness;
               });
}

}  // namespace

CsvWriter modal_reduction_table(std::span<const ModalLevel> levels,
                                std::span<const std::string> joints) {
  ModalColumns columns(levels);
  const LevelMeasured displacement = std::mem_fn(&ModalLevel::displacement);
  const LevelMeasured frequency = std::mem_fn(&ModalLevel::frequency);
  columns.add("mode", kDimensionless,
              [](const ModalLevel& level) { return static_cast<double>(level.mode); });
  columns.add("displacement", kLength,
              [](const ModalLevel& level) { return level.displacement.value; });
  columns.add("frequency", kFrequency,
              [](const ModalLevel& level) { return level.frequency.value; });
  columns.add_measured("dissipation", kEnergy, std::mem_fn(&ModalLevel::dissipation));
  columns.add_std("displacement", kLength, displacement);
  columns.add_std("frequency", kFrequency, frequency);
  for (std::size_t j = 0; j < joints.size(); ++j) columns.add_joint(joints[j], j);
  columns.add_text("source", std::mem_fn(&ModalLevel::source));
  columns.add("drive_frequency", kFrequency, std::mem_fn(&ModalLevel::drive_frequency));
  columns.add("force_amplitude", kForce, std::mem_fn(&ModalLevel::force_amplitude));
  columns.add("input_energy", kEnergy, std::mem_fn(&ModalLevel::input_energy));
  columns.add("linear_dissipation", kEnergy, std::mem_fn(&ModalLevel::linear_dissipation));
  columns.add("force_distortion", kDimensionless, std::mem_fn(&ModalLevel::force_distortion));
  columns.add_text("flags", [](const ModalLevel& level) { return joined_codes(level.flags); });
  return columns.done();
}

}  // namespace microslip
