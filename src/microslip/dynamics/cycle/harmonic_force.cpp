// SPDX-License-Identifier: MIT
#include "microslip/dynamics/cycle/harmonic_force.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/dynamics/cycle/steady_cycle.hpp"

namespace microslip {
namespace {

void check_size(std::string_view what, std::size_t size, std::size_t least, std::size_t most) {
  if (size >= least && size <= most) return;
  throw InputError(what, static_cast<double>(size),
                   fmt::format("must be from {} to {}", least, most),
                   what == "samples" ? "Take more samples or fewer harmonics." : "");
}

std::size_t checked_harmonics(std::size_t harmonics, std::size_t samples) {
  check_size("harmonics", harmonics, 1, 1000);
  check_size("samples", samples, 2 * harmonics + 2, 1'000'000);
  return harmonics;
}

void check_length(std::string_view what, std::size_t length, std::size_t expected) {
  if (length == expected) return;
  throw InputError(fmt::format("length of {}", what), static_cast<double>(length),
                   fmt::format("must be {}", expected));
}

}  // namespace

HarmonicForce::HarmonicForce(std::size_t harmonics, std::size_t samples)
    : cycle_(std::make_unique<SteadyCycle>(checked_harmonics(harmonics, samples), samples)) {}
HarmonicForce::~HarmonicForce() = default;
HarmonicForce::HarmonicForce(HarmonicForce&&) noexcept = default;
HarmonicForce& HarmonicForce::operator=(HarmonicForce&&) noexcept = default;

HarmonicForce::Cycle HarmonicForce::evaluate(const Joint& joint,
                                             std::span<const double> displacement,
                                             std::span<double> force, std::span<double> jacobian) {
  const auto n = static_cast<std::size_t>(cycle_->coefficients());
  check_length("displacement", displacement.size(), n);
  check_length("force", force.size(), n);
  check_length("jacobian", jacobian.size(), n * n);
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(displacement[i])) continue;
    throw InputError(fmt::format("displacement[{}]", i), displacement[i], "must be finite");
  }
  return cycle_->evaluate(joint, displacement, force, jacobian);
}

std::size_t HarmonicForce::reaches() const { return cycle_->reaches(); }

double HarmonicForce::reach(std::size_t rank) const {
  if (rank < cycle_->reaches()) return cycle_->reach(rank);
  throw InputError("rank", static_cast<double>(rank),
                   fmt::format("must be below the number of reaches, {}", cycle_->reaches()));
}

void HarmonicForce::reach_gradient(std::size_t rank, std::span<double> gradient) const {
  (void)reach(rank);  // throws where there is none
  check_length("gradient", gradient.size(), static_cast<std::size_t>(cycle_->coefficients()));
  cycle_->reach_gradient(rank, gradient);
}

std::size_t HarmonicForce::turns() const { return cycle_->turns(); }

HarmonicForce::Turn HarmonicForce::turn(std::size_t i) const {
  if (i < cycle_->turns()) return cycle_->turn(i);
  throw InputError("turn", static_cast<double>(i),
                   fmt::format("must be below the number of turns, {}", cycle_->turns()));
}

void HarmonicForce::turn_gradient(std::size_t i, std::span<double> gradient) const {
  (void)turn(i);  // throws where there is none
  check_length("gradient", gradient.size(), static_cast<std::size_t>(cycle_->coefficients()));
  cycle_->turn_gradient(i, gradient);
}

}  // namespace microslip
