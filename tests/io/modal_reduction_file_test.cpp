// SPDX-License-Identifier: MIT
#include "microslip/documents/levels/modal_reduction_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"

namespace microslip::modal_reduction_file_test {
namespace {

ModalLevel level(double scale) {
  ModalLevel level;
  level.source = "a.csv";
  level.mode = 2;
  level.displacement = {1e-5 * scale, 1e-9};
  level.frequency = {65.25, 1e-4};
  level.drive_frequency = 65.5;
  level.force_amplitude = 0.5 * scale;
  level.dissipation = {0.25 * scale, 1e-3};
  level.input_energy = 0.75 * scale;
  level.linear_dissipation = 0.5 * scale;
  level.force_distortion = 0.001;
  level.joints = {
      {.amplitude = {2e-6, 1e-9}, .dissipation = {0.125, 2e-3}, .secant_stiffness = {1e5, 10.0}},
      {.amplitude = {4e-6, 2e-9}, .dissipation = {0.125, 3e-3}, .secant_stiffness = {2e5, 20.0}}};
  return level;
}

std::string table_of(const std::vector<ModalLevel>& levels) {
  const std::vector<std::string> names{"left", "right"};
  return modal_reduction_table(levels, names).str();
}

std::string header_of_table(const std::vector<ModalLevel>& levels) {
  const std::string text = table_of(levels);
  return text.substr(0, text.find('\n'));
}

const std::string kFront =
    "mode [1],displacement [m],frequency [Hz],dissipation [J],dissipation_std [J],"
    "displacement_std [m],frequency_std [Hz],";
const std::string kLeft =
    "amplitude_left [m],amplitude_left_std [m],dissipation_left [J],dissipation_left_std [J],"
    "secant_stiffness_left [N/m],secant_stiffness_left_std [N/m],";
const std::string kBack =
    "source,drive_frequency [Hz],force_amplitude [N],input_energy [J],linear_dissipation [J],"
    "force_distortion [1],flags";

TEST(ModalReductionFile, HasTheDocumentedColumns) {
  ModalLevel flagged = level(1.0);
  flagged.flags = {{"few_cycles", "5 cycles"}, {"spike", "off"}};
  const std::string text = table_of({flagged});
  EXPECT_EQ(text, kFront + kLeft +
                      "amplitude_right [m],amplitude_right_std [m],dissipation_right [J],"
                      "dissipation_right_std [J],secant_stiffness_right [N/m],"
                      "secant_stiffness_right_std [N/m]," +
                      kBack +
                      "\n2,1e-05,65.25,0.25,0.001,1e-09,1e-04,2e-06,1e-09,0.125,0.002,1e+05,10,"
                      "4e-06,2e-09,0.125,0.003,2e+05,20,a.csv,65.5,0.5,0.75,0.5,0.001,"
                      "few_cycles spike\n");
  EXPECT_EQ(file_kind(text), kModalLevelsKind);
}

// What stands for a sensor that is missing must not be taken for a measurement.
TEST(ModalReductionFile, DoesNotCallAnAssumptionMeasured) {
  ModalLevel blind = level(2.0);
  blind.joints[1].unseen = 0.8;
  blind.joints[1].amplitude.std = 1e-6;
  EXPECT_EQ(header_of_table({level(1.0), blind}),
            kFront + kLeft +
                "assumed_amplitude_right [m],assumed_amplitude_right_std [m],unseen_right [1]," +
                kBack);
  blind.joints[1].amplitude.std = 1e-8;  // the force is not seen, the motion is
  EXPECT_EQ(
      header_of_table({level(1.0), blind}),
      kFront + kLeft + "amplitude_right [m],amplitude_right_std [m],unseen_right [1]," + kBack);
}

TEST(ModalReductionFile, WantsALevel) { EXPECT_THROW((void)table_of({}), InputError); }

}  // namespace
}  // namespace microslip::modal_reduction_file_test
