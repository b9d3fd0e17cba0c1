// SPDX-License-Identifier: MIT
#include "support/jointed_records.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/algebra/eigenvalues.hpp"

namespace microslip::testing {

Joint humped_joint(double stiffness, double middle, double at_zero) {
  const double peak = (1.8 / middle - at_zero) / 2.0;
  return Joint(
      stiffness,
      SlipDensity({PiecewiseLinearPart{{0.0, middle, 2.0 * middle}, {at_zero, peak, 0.0}}}));
}

JointedStructure random_chain(std::uint64_t seed, std::size_t joints, DampingLaw damping) {
  RandomStream random(seed, 3);
  const auto count = static_cast<Eigen::Index>(5 + seed % 3);
  const auto draw = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  Eigen::VectorXd mass(count);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(count, count);
  const auto add_spring = [&](const Eigen::VectorXd& across, double k) {
    stiffness += k * across * across.transpose();
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    mass[i] = draw(0.6, 1.5);
    Eigen::VectorXd across = Eigen::VectorXd::Unit(count, i);
    if (i > 0) across -= Eigen::VectorXd::Unit(count, i - 1);
    add_spring(across, draw(4e5, 1.2e6));
  }
  std::vector<Eigen::VectorXd> places;
  std::vector<double> k;
  for (std::size_t j = 0; j < joints; ++j) {
    const auto at = (static_cast<Eigen::Index>(2 * j) + 1) % count;
    Eigen::VectorXd across = Eigen::VectorXd::Unit(count, at);
    if (j % 2 == 0) across -= Eigen::VectorXd::Unit(count, (at + 2) % count);
    places.push_back(across);
    k.push_back(draw(3e5, 9e5));
    add_spring(across, k.back());
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      stiffness, Eigen::MatrixXd(mass.asDiagonal()));
  const Eigen::MatrixXd& modes = solver.eigenvectors();
  const auto shape_of = [&](const Eigen::VectorXd& place) {
    const Eigen::VectorXd shape = modes.transpose() * place;
    return std::vector<double>(shape.begin(), shape.end());
  };
  std::vector<Mode> linear;
  std::vector<ModalPoint> points;
  for (Eigen::Index i = 0; i < count; ++i) {
    linear.push_back({std::sqrt(solver.eigenvalues()[i]), draw(0.002, 0.006)});
    points.push_back({"p" + std::to_string(i + 1), shape_of(Eigen::VectorXd::Unit(count, i))});
  }
  std::vector<StructuralJoint> list;
  for (std::size_t j = 0; j < joints; ++j) {
    list.push_back({.name = "j" + std::to_string(j + 1),
                    .joint = humped_joint(k[j], draw(15.0, 60.0), draw(0.002, 0.006)),
                    .shape = shape_of(places[j]),
                    .spring_in_modes = k[j]});
  }
  return JointedStructure(ModalModel(std::move(linear), std::move(points)), std::move(list),
                          {{.point = "p1"}}, damping);
}

Recording record_of(const JointedStructure& structure, const SteadyVibration& vibration,
                    const std::vector<std::string>& points, std::uint64_t seed,
                    const JointedSampling& sampling) {
  RandomStream random(seed, 4);
  const double phase = 2.0 * std::numbers::pi * random.uniform();
  Recording recording;
  recording.source = "record " + std::to_string(seed);
  recording.axis.step = 1.0 / sampling.rate;
  const auto add = [&](const std::string& name, const Dimension& dimension, double noise,
                       const std::vector<std::complex<double>>& harmonics) {
    Channel& channel = recording.channels.emplace_back();
    channel.name = name;
    channel.dimension = dimension;
    for (std::size_t i = 0; i < sampling.points; ++i) {
      const double angle =
          phase + vibration.angular_frequency * static_cast<double>(i) * recording.axis.step;
      double value = noise * random.normal();
      for (std::size_t n = 1; n < harmonics.size(); ++n) {
        value += (harmonics[n] * std::polar(1.0, static_cast<double>(n) * angle)).real();
      }
      channel.values.push_back(value);
    }
  };
  add("force", kForce, sampling.force_noise, {0.0, vibration.force_amplitude});
  for (const std::string& point : points) {
    add(point, kAcceleration, sampling.acceleration_noise,
        vibration.acceleration(structure.linear(), point));
  }
  return recording;
}

}  // namespace microslip::testing
