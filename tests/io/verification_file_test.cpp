// SPDX-License-Identifier: MIT
#include "microslip/documents/response/verification_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "io/support.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/tables/csv.hpp"

namespace microslip::verification_file_test {
namespace {

using test::message_of;
using Complex = std::complex<double>;

constexpr double kPi = std::numbers::pi;

FourierSeries series(const std::vector<Complex>& harmonics) {
  FourierSeries result;
  result.omega = 100.0 * kPi;
  result.harmonic = harmonics;
  return result;
}

/// A force and an acceleration whose first harmonic is largest a quarter period before the zero of
/// time.
Verification record(const std::string& source) {
  Verification record;
  record.recorded.source = source;
  record.recorded.frequency = 50.0;
  record.recorded.response_amplitude = 3.0;
  record.recorded.amplitude.value = 2e-5;
  record.recorded.input_energy.value = 0.5;
  record.predicted.amplitude = 2.5e-5;
  record.predicted.input_energy = 0.25;
  record.predicted.frequency_offset = -0.125;
  record.summary.stop = Stop::kConverged;
  record.phase = 0.5 * kPi;
  record.history = {0.25, 0.5};
  ChannelComparison force;
  force.name = "force";
  force.dimension = kForce;
  force.recorded = series({2.0, {0.0, 0.5}});
  force.predicted = series({Complex{0.0, 1.0}, 0.0, 0.0});
  force.recorded_std = {0.125, 0.0625};
  force.nrmse = 0.75;
  force.noise_share = 0.25;
  force.recorded_history = {1.0, 2.0};
  force.predicted_history = {1.5, 2.5};
  ChannelComparison acceleration = force;
  acceleration.name = "acc1";
  acceleration.dimension = kAcceleration;
  acceleration.recorded = series({Complex{0.0, 3.0}, 1.0});
  acceleration.predicted = acceleration.recorded;
  record.channels = {force, acceleration};
  return record;
}

TEST(VerificationFile, ARowARecordAndChannel) {
  Verification marked = record("b.csv");
  marked.summary.stop = Stop::kNoProgress;
  marked.recorded.flags = {{"spike", ""}};
  marked.warnings = {{"beyond_identification", ""}};
  const std::vector<Verification> records{record("a.csv"), marked};
  const std::string text = verification_table(records).str();
  const std::string half_pi = "1.5707963267948966";
  EXPECT_EQ(text,
            "source,channel,status,frequency [Hz],response_amplitude [m/s^2],NRMSE [1],"
            "noise_share [1],amplitude_ratio [1],phase_error [rad],joint_amplitude [m],"
            "predicted_joint_amplitude [m],input_energy [J],predicted_input_energy [J],"
            "frequency_offset [Hz],flags\n"
            "a.csv,force,converged,50,3,0.75,0.25,0.5," +
                half_pi +
                ",2e-05,2.5e-05,0.5,0.25,-0.125,\"\"\n"
                "a.csv,acc1,converged,50,3,0.75,0.25,1,0,2e-05,2.5e-05,0.5,0.25,-0.125,\"\"\n"
                "b.csv,force,not converged,50,3,0.75,0.25,0.5," +
                half_pi +
                ",2e-05,2.5e-05,0.5,0.25,-0.125,spike beyond_identification\n"
                "b.csv,acc1,not converged,50,3,0.75,0.25,1,0,2e-05,2.5e-05,0.5,0.25,-0.125,"
                "spike beyond_identification\n");
  EXPECT_EQ(file_kind(text), kVerificationKind);
}

TEST(VerificationFile, AnOffsetThatOneRecordLacksIsNoColumn) {
  std::vector<Verification> records{record("a.csv"), record("b.csv")};
  records[1].predicted.frequency_offset = {};
  const std::string text = verification_table(records).str();
  EXPECT_EQ(text.find("frequency_offset"), std::string::npos);
  EXPECT_EQ(file_kind(text), kVerificationKind);
}

TEST(VerificationFile, HarmonicsHaveTheDrivePointAtPhaseZero) {
  const std::vector<Verification> records{record("a.csv")};
  const std::string text = harmonics_table(records).str();
  EXPECT_EQ(file_kind(text), kHarmonicsKind);
  const CsvTable table(text, "harmonics.csv");
  ASSERT_EQ(table.rows(), 2U);  // those that were recorded
  EXPECT_EQ(table.numbers("frequency", kFrequency), (std::vector<double>{50.0, 100.0}));
  EXPECT_EQ(table.numbers("force_recorded", kForce), (std::vector<double>{2.0, 0.5}));
  EXPECT_EQ(table.numbers("force_recorded_std", kForce), (std::vector<double>{0.125, 0.0625}));
  EXPECT_EQ(table.numbers("force_predicted", kForce), (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(table.numbers("acc1_predicted", kAcceleration), (std::vector<double>{3.0, 1.0}));
  const auto phase = [&](const char* name, std::size_t row) {
    return table.numbers(name, kAngle)[row];
  };
  // 0 less a quarter turn; a quarter turn less two of them; and the drive point itself.
  EXPECT_NEAR(phase("force_recorded_phase", 0), -0.5 * kPi, 1e-15);
  EXPECT_NEAR(phase("force_recorded_phase", 1), -0.5 * kPi, 1e-15);
  EXPECT_NEAR(phase("force_predicted_phase", 0), 0.0, 1e-15);
  EXPECT_NEAR(phase("acc1_recorded_phase", 0), 0.0, 1e-15);
}

TEST(VerificationFile, HistoriesStandBelowEachOther) {
  const std::vector<Verification> records{record("a.csv"), record("b.csv")};
  EXPECT_EQ(histories_table(records).str(),
            "source,time [s],force_recorded [N],force_predicted [N],acc1_recorded [m/s^2],"
            "acc1_predicted [m/s^2]\n"
            "a.csv,0.25,1,1.5,1,1.5\na.csv,0.5,2,2.5,2,2.5\n"
            "b.csv,0.25,1,1.5,1,1.5\nb.csv,0.5,2,2.5,2,2.5\n");
}

TEST(VerificationFile, RefusesNothingAndWhatIsNotFinite) {
  EXPECT_THROW((void)verification_table({}).str(), InputError);
  EXPECT_THROW((void)harmonics_table({}).str(), InputError);
  EXPECT_THROW((void)histories_table({}).str(), InputError);
  std::vector<Verification> records{record("a.csv")};
  records[0].channels[1].nrmse = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of<InputError>([&] { return verification_table(records); }).find("NRMSE"),
            std::string::npos);
}

}  // namespace
}  // namespace microslip::verification_file_test
