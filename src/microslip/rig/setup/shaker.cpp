// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/shaker.hpp"

#include <cstddef>
#include <numbers>

namespace microslip {
namespace {

using Complex = std::complex<double>;

Complex coil_impedance(const RigShaker& shaker, double angular_frequency) {
  return {shaker.resistance, angular_frequency * shaker.inductance};
}

/// ∮ Re(a) Re(b) dt over n of the periods of harmonic n, per 1/ω.
double product(Complex a, Complex b) { return std::numbers::pi * (std::conj(a) * b).real(); }

}  // namespace

ShakerTransfer shaker_transfer(const RigShaker& shaker, double angular_frequency) {
  const double omega = angular_frequency;
  const Complex coil = coil_impedance(shaker, omega);
  const Complex armature{shaker.suspension_stiffness - omega * omega * shaker.moving_mass,
                         omega * shaker.suspension_damping};
  const Complex back = Complex{0.0, omega} * shaker.force_factor * shaker.force_factor / coil;
  const Complex stiffness = armature + back;
  const Complex series = 1.0 + stiffness / shaker.stinger_stiffness;
  return {.voltage = shaker.force_factor / (coil * series), .displacement = stiffness / series};
}

ShakerEnergy shaker_energy(const RigShaker& shaker, double angular_frequency,
                           std::span<const Complex> voltage, std::span<const Complex> force,
                           std::span<const Complex> displacement) {
  ShakerEnergy energy;
  for (std::size_t n = 1; n < voltage.size(); ++n) {
    const Complex derivative{0.0, static_cast<double>(n) * angular_frequency};
    const Complex armature = derivative * (displacement[n] + force[n] / shaker.stinger_stiffness);
    const Complex current =
        (voltage[n] - shaker.force_factor * armature) / coil_impedance(shaker, derivative.imag());
    energy.electrical += product(voltage[n], current) / angular_frequency;
    energy.coil += shaker.resistance * product(current, current) / angular_frequency;
    energy.suspension +=
        shaker.suspension_damping * product(armature, armature) / angular_frequency;
    energy.mechanical += product(force[n], derivative * displacement[n]) / angular_frequency;
  }
  return energy;
}

}  // namespace microslip
