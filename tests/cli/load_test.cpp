// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "microslip/io/tables/csv.hpp"
#include "support/replaced.hpp"

/// @file Shaken and loaded structures as a user has them: `load`, `frf --acceleration`, `march`,
/// `spectrum`.

namespace microslip::cli_test::load_test {
namespace {

using std::numbers::pi;

/// One mass of 4 kg at 12 Hz on a table, without a joint.
const std::string kMassOnTable =
    "schema = \"microslip.model/1\"\n"
    "[structure]\nfrequency_Hz = [12.0]\ndamping_ratio = [0.03]\n"
    "[[structure.point]]\nname = \"mass\"\nshape = [0.5]\n"
    "[[structure.base]]\nname = \"table\"\nparticipation = [2.0]\npoint_motion = [1.0]\n"
    "[excitation]\nbase = \"table\"\n"
    "[response]\npoint = \"mass\"\n";

CsvTable table_of(const Sandbox& box, const std::string& file) {
  return CsvTable(box.get(file), file);
}

// |(1 + 2iζr)/(1 − r² + 2iζr)|, r = ω/ω₀. [Chopra 3.5] Rows hold 15 digits of the frequency.
TEST(frf, OfAShakenMassHasItsTransmissibility) {
  const Sandbox box{{"model.toml", kMassOnTable}};
  expect_done(box, {"frf", "model.toml", "--acceleration", "0.5g", "--frequency", "2:60", "--out",
                    "frf.csv"});
  const CsvTable table = table_of(box, "frf.csv");
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  const std::vector<double> found = table.numbers("transmissibility", kDimensionless);
  const std::vector<double> absolute = table.numbers("absolute_acceleration", kAcceleration);
  const std::vector<double> relative = table.numbers("displacement", kLength);
  const std::vector<double> velocity = table.numbers("velocity", kVelocity);
  ASSERT_GT(frequency.size(), 50U);
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double r = frequency[i] / 12.0;
    const std::complex<double> below(1.0 - r * r, 2.0 * 0.03 * r);
    EXPECT_NEAR(found[i], std::abs(std::complex<double>(1.0, 2.0 * 0.03 * r) / below),
                1e-10 * found[i]);
    EXPECT_NEAR(absolute[i], found[i] * 0.5 * 9.80665, 1e-10 * absolute[i]);
    const double square = std::pow(2.0 * pi * 12.0, 2);
    EXPECT_NEAR(relative[i], 0.5 * 9.80665 / square / std::abs(below), 1e-10 * relative[i]);
    EXPECT_NEAR(velocity[i], 2.0 * pi * frequency[i] * relative[i], 1e-12 * velocity[i]);
  }
  EXPECT_EQ(table.numbers("base_acceleration", kAcceleration).front(), 0.5 * 9.80665);
}

// The unit says what is kept: at the natural frequency ω₀²|w| is the acceleration asked for.
TEST(frf, KeepsAnAccelerationByItsUnit) {
  const Sandbox box{{"model.toml", kMassOnTable}};
  expect_done(box, {"frf", "model.toml", "--response", "3m/s^2", "--frequency", "10:15", "--out",
                    "frf.csv"});
  const CsvTable table = table_of(box, "frf.csv");
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  const std::vector<double> acceleration = table.numbers("acceleration", kAcceleration);
  const std::vector<double> displacement = table.numbers("displacement", kLength);
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    EXPECT_NEAR(acceleration[i], 3.0, 1e-9);
    EXPECT_NEAR(displacement[i] * std::pow(2.0 * pi * frequency[i], 2), 3.0, 1e-9);
  }
}

// A mass of 4 kg under 8 N hangs by F/k; the march begins and stays there.
TEST(march, BeginsAtRestUnderStaticLoads) {
  const Sandbox box{
      {"model.toml", kMassOnTable + "[[static_load]]\npoint = \"mass\"\nforce_N = 8.0\n"},
      {"none.csv", "time [s],acceleration of table [m/s^2]\n0,0\n1,0\n2,0\n"}};
  expect_done(box, {"march", "model.toml", "--force-file", "none.csv", "--out", "march.csv"});
  const double hangs = 8.0 / (4.0 * std::pow(2.0 * pi * 12.0, 2));
  for (const double w : table_of(box, "march.csv").numbers("displacement", kLength)) {
    EXPECT_NEAR(w, hangs, 1e-12 * hangs);
  }
}

// Two forces a quarter of a period apart: what `load` writes is what the model says of them.
TEST(load, OfASineHasTheHarmonicsAndPhasesOfTheModel) {
  const std::string model = test::replaced(
      kMassOnTable, "[excitation]\nbase = \"table\"\n",
      "[[structure.point]]\nname = \"other\"\nshape = [0.2]\n"
      "[[excitation]]\npoint = \"mass\"\n"
      "[[excitation]]\npoint = \"other\"\nharmonics = [0.5]\nphase_rad = [1.5707963267948966]\n");
  const Sandbox box{
      {"model.toml", test::replaced(model, "point_motion = [1.0]", "point_motion = [1.0, 1.0]")}};
  const Outcome run =
      expect_done(box, {"load", "sine", "model.toml", "--peak", "10", "--frequency", "12",
                        "--cycles", "6", "--duration", "1", "--out", "l.csv"});
  EXPECT_NE(run.out.find("peak 10 N"), std::string::npos) << run.out;
  const CsvTable table = table_of(box, "l.csv");
  const std::vector<double> time = table.numbers("time", kTime);
  const std::vector<double> mass = table.numbers("force at mass", kForce);
  const std::vector<double> other = table.numbers("force at other", kForce);
  for (std::size_t i = 0; i < time.size(); ++i) {
    const bool acts = time[i] < 0.5;
    const double turn = 2.0 * pi * 12.0 * time[i];
    EXPECT_NEAR(mass[i], acts ? 10.0 * std::cos(turn) : 0.0, 1e-9);
    EXPECT_NEAR(other[i], acts ? -5.0 * std::sin(turn) : 0.0, 1e-9);
  }
  expect_done(box, {"march", "model.toml", "--force-file", "l.csv", "--out", "march.csv"});
}

// From noise to the spectrum of what comes of it; the second time it is the same noise.
TEST(load, OfNoiseLeadsToASpectrum) {
  const Sandbox box{{"model.toml", kMassOnTable},
                    {"asd.csv", "frequency [Hz],density [g^2/Hz]\n5,0.001\n60,0.001\n"}};
  const Arguments noise{"load",       "noise", "model.toml", "--density", "asd.csv",
                        "--duration", "4s",    "--seed",     "5",         "--out"};
  const auto to = [&](const std::string& file) {
    Arguments call = noise;
    call.push_back(file);
    return call;
  };
  expect_done(box, to("n.csv"));
  expect_done(box, to("again.csv"));
  const std::vector<double> one =
      table_of(box, "n.csv").numbers("acceleration of table", kAcceleration);
  EXPECT_EQ(one, table_of(box, "again.csv").numbers("acceleration of table", kAcceleration));
  expect_done(box, {"march", "model.toml", "--force-file", "n.csv", "--out", "march.csv"});
  // The spectrum of the table itself at the mass is the largest of the march.
  expect_done(box, {"spectrum", "n.csv", "--column", "acceleration of table", "--frequency",
                    "12:24:2", "--damping-ratio", "0.03", "--out", "srs.csv"});
  double largest = 0.0;
  for (const double w : table_of(box, "march.csv").numbers("displacement", kLength)) {
    largest = std::max(largest, std::abs(w));
  }
  const CsvTable spectrum = table_of(box, "srs.csv");
  EXPECT_NEAR(spectrum.numbers("relative_displacement", kLength)[0], largest, 2e-3 * largest);
}

/// 9 dB an octave, then flat, as of a functional shock.
const std::string kRequired = "frequency [Hz],maximax [g]\n10,4\n60,40\n400,40\n";

// What `spectrum` finds in the file lies within 1 dB of what was asked for, which is written out
// here; peaks are right to 1e-5. At the end of the march the table is at rest where it was.
TEST(load, OfAShockHasTheRequiredSpectrum) {
  const Sandbox box{{"model.toml", kMassOnTable}, {"required.csv", kRequired}};
  const Outcome run = expect_done(box, {"load", "shock", "model.toml", "--spectrum", "required.csv",
                                        "--duration", "0.5s", "--at", "20ms", "--out", "s.csv"});
  EXPECT_NE(run.out.find("worst deviation"), std::string::npos) << run.out;
  EXPECT_NE(box.get("s.csv").find("# sum of 65 wavelets: converged"), std::string::npos);
  EXPECT_NE(box.get("s.csv").find("# worst deviation: "), std::string::npos);
  expect_done(box, {"spectrum", "s.csv", "--column", "acceleration of table", "--frequency",
                    "10:400:65:log", "--out", "srs.csv"});
  const CsvTable spectrum = table_of(box, "srs.csv");
  const std::vector<double> frequency = spectrum.numbers("frequency", kFrequency);
  const std::vector<double> maximax = spectrum.numbers("maximax", kAcceleration);
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double f = frequency[i];
    const double level = f < 60.0 ? 4.0 * std::pow(f / 10.0, 1.0 / std::log10(6.0)) : 40.0;
    EXPECT_LT(std::abs(20.0 * std::log10(maximax[i] / (level * 9.80665))), 1.0 + 1e-3) << f;
  }
  expect_done(box, {"march", "model.toml", "--force-file", "s.csv", "--out", "march.csv"});
  const CsvTable march = table_of(box, "march.csv");
  const std::vector<double> relative = march.numbers("displacement", kLength);
  const std::vector<double> absolute = march.numbers("absolute_displacement", kLength);
  const std::vector<double> time = march.numbers("time", kTime);
  EXPECT_EQ(march.numbers("acceleration of table", kAcceleration)[160], 0.0);  // at 20 ms
  EXPECT_NE(march.numbers("acceleration of table", kAcceleration)[165], 0.0);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] < 0.18) continue;  // the shock is over, the table has gone back
    EXPECT_NEAR(absolute[i], relative[i], 1e-9);
  }
}

// It is written, marked in the file, warned of with --quiet, and the status says it.
TEST(load, MarksAShockThatMissesItsSpectrum) {
  const Sandbox box{
      {"model.toml", kMassOnTable},
      {"jump.csv", "frequency [Hz],maximax [m/s^2]\n20,10\n50,10\n51,100\n200,100\n"}};
  const Outcome run = box.run({"load", "shock", "model.toml", "--spectrum", "jump.csv",
                               "--duration", "0.2s", "--out", "s.csv", "--quiet"});
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_NE(run.err.find("not converged: the spectrum lies"), std::string::npos) << run.err;
  EXPECT_NE(box.get("s.csv").find("wavelets: NOT CONVERGED: the spectrum lies"), std::string::npos);
}

TEST(load, RefusesSpectraThatMeanNothing) {
  const auto refused = [](const std::string& table, const Arguments& more, const std::string& part,
                          const std::string& model = kMassOnTable) {
    const Sandbox box{{"model.toml", model}, {"r.csv", table}};
    Arguments call{"load",       "shock", "model.toml", "--spectrum", "r.csv",
                   "--duration", "0.5s",  "--out",      "s.csv"};
    call.insert(call.end(), more.begin(), more.end());
    const Outcome run = box.run(call);
    EXPECT_EQ(run.status, 2) << run.out << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  };
  refused("frequency [Hz],maximax [g]\n10,4\n", {}, "points of a required spectrum");
  refused("frequency [Hz],maximax [g]\n10,4\n10,4\n", {}, "r.csv: frequency[1]");
  refused("frequency [Hz],maximax [g]\n10,4\n20,-1\n", {}, "r.csv: maximax[1]");
  refused("frequency [Hz],maximax\n10,4\n20,1\n", {}, "unit");
  refused("frequency [Hz],maximax [N]\n10,4\n20,1\n", {}, "r.csv");
  refused("frequency [Hz],level [g]\n10,4\n20,1\n", {}, "'maximax [m/s^2]'");
  refused(kRequired, {"--sampling-rate", "3kHz"}, "must be 4000 Hz or more");
  refused(kRequired, {"--pulse", "0.1s"}, "must be 0.15 s or more");
  refused(kRequired, {"--tolerance", "50%"}, "must be in dB");
  refused(kRequired, {"--at", "0.4s"}, "start of the shock");
  refused(kRequired, {"--pulse", "0.6s"}, "must be 0.6 s or more, the length of the shock");
  refused(kRequired, {"--per-octave", "4"}, "must be from 6 to 48");
  refused(kRequired, {"--tolerance", "0"}, "must be from 0.1 to 12");
  refused(kRequired, {"--damping-ratio", "1"}, "damping ratio");
  refused(kRequired, {"--peak", "1"}, "it does not apply to a shock");
  refused(kRequired, {}, "must be a base for a shock",
          test::replaced(kMassOnTable, "[excitation]\nbase = \"table\"",
                         "[excitation]\npoint = \"mass\""));
}

TEST(load, RefusesWhatMeansNothing) {
  const Sandbox box{{"model.toml", kMassOnTable},
                    {"asd.csv", "frequency [Hz],density [N^2/Hz]\n5,1\n60,1\n"}};
  const auto refused = [&](const Arguments& call, const std::string& part) {
    const Outcome run = box.run(call);
    EXPECT_EQ(run.status, 2) << run.out;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
  };
  refused({"load", "half-sine", "model.toml", "--peak", "1", "--duration", "1", "--out", "l.csv"},
          "--pulse");
  refused({"load", "sine", "model.toml", "--peak", "1N", "--frequency", "5", "--duration", "1",
           "--out", "l.csv"},
          "m/s^2");
  refused(
      {"load", "noise", "model.toml", "--density", "asd.csv", "--duration", "1", "--out", "l.csv"},
      "asd.csv");
  refused({"load", "sine", "model.toml", "--peak", "1", "--frequency", "5", "--duration", "1",
           "--pulse", "1", "--out", "l.csv"},
          "it does not apply to a sine");
  refused({"load", "half-sine", "model.toml", "--peak", "1", "--pulse", "11ms", "--at", "5",
           "--duration", "1", "--out", "l.csv"},
          "start of the half-sine");
  refused({"load", "sine", "model.toml", "--peak", "1", "--frequency", "16", "--duration", "1",
           "--sampling-rate", "16", "--out", "l.csv"},
          "must be 128 Hz or more");
  refused({"spectrum", "asd.csv", "--column", "density", "--frequency", "1:2:3", "--out", "s.csv"},
          "'time [s]'");
  refused({"frf", "model.toml", "--force", "1", "--frequency", "5:20", "--out", "f.csv"},
          "driven by its base 'table'");
  refused({"march", "model.toml", "--release", "1", "--duration", "1", "--sampling-rate", "100",
           "--out", "m.csv"},
          "MODE:DISPLACEMENT");
  refused({"march", "model.toml", "--out", "m.csv"}, "--force-file");
}

}  // namespace
}  // namespace microslip::cli_test::load_test
