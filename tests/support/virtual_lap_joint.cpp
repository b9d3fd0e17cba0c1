// SPDX-License-Identifier: MIT
#include "support/virtual_lap_joint.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace microslip::test {

double noisy(double value, double sigma, RandomStream& random) {
  return value * (1.0 + sigma * random.normal());
}

std::string noisy_sweep(const std::string& response, RandomStream& random) {
  const CsvTable table(response, "frf.csv");
  const std::vector<double> frequency = table.numbers("frequency", kFrequency);
  const std::vector<double> force = table.numbers("force", kForce);
  const std::vector<double> acceleration = table.numbers("acceleration", kAcceleration);
  const std::vector<double> lag = table.numbers("phase", kAngle);
  std::string text = "frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n";
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    text += fmt::format("{:.12g},{:.12g},{:.12g},{:.12g}\n", frequency[i],
                        noisy(force[i], 0.003, random), noisy(acceleration[i], 0.001, random),
                        std::numbers::pi - lag[i]);
  }
  return text;
}

std::string noisy_record(const std::string& history, double noise, RandomStream& random) {
  const CsvTable table(history, "march.csv");
  const std::vector<double> time = table.numbers("time", kTime);
  const std::vector<double> acceleration = table.numbers("acceleration", kAcceleration);
  std::string text = "time [s],acceleration [m/s^2]\n";
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {  // the last row is off the raster
    text += fmt::format("{:.12g},{:.9g}\n", time[i], acceleration[i] + noise * random.normal());
  }
  return text;
}

}  // namespace microslip::test
