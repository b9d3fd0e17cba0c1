// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/rig.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/work_size.hpp"

namespace microslip {
namespace {

void require_positive(std::string_view field, double value, std::string_view remedy = {}) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw InputError(field, value, "must be above 0 and finite", remedy);
}

void require_non_negative(std::string_view field, double value) {
  if (value >= 0.0 && std::isfinite(value)) return;
  throw InputError(field, value, "must be 0 or more and finite");
}

/// No beam is of anything softer, or lighter: a wrong unit.
void require_solid(std::string_view field, double value, double least, std::string_view remedy) {
  if (value >= least) return;
  throw InputError(field, value, fmt::format("must be {:g} or more, as of all solids", least),
                   remedy);
}

void check_beam(const RigBeam& beam) {
  require_positive("beam.length", beam.length);
  require_positive("beam.width", beam.width);
  require_positive("beam.thickness", beam.thickness);
  require_positive("beam.youngs_modulus", beam.youngs_modulus);
  require_positive("beam.mass_density", beam.mass_density);
  require_solid("beam.youngs_modulus", beam.youngs_modulus, 1e6, "Steel has 2.1e11: no GPa.");
  require_solid("beam.mass_density", beam.mass_density, 25.0, "Steel has 7850: no g/cm^3.");
  if (beam.thickness > 0.2 * beam.length) {
    throw InputError("beam.thickness", beam.thickness,
                     fmt::format("must be below a fifth of beam.length = {} m", beam.length),
                     "The beam is slender: shear and rotary inertia are left out. Check the units, "
                     "or give modes in place of the beam.");
  }
}

void check_shape(std::string_view field, const std::vector<double>& shape, std::size_t modes) {
  if (shape.size() != modes) {
    throw InputError(field, fmt::format("{} values", shape.size()),
                     fmt::format("must have {}, one per mode of modes.frequency", modes));
  }
  for (const double value : shape) {
    if (!std::isfinite(value)) throw InputError(field, value, "must be finite");
  }
}

void check_modes(const RigModes& modes) {
  if (modes.frequency.empty()) {
    throw InputError("modes.frequency", "[]", "must have at least one value");
  }
  double before = 0.0;
  for (const double frequency : modes.frequency) {
    require_positive("modes.frequency", frequency);
    if (frequency < before) {
      throw InputError("modes.frequency", frequency,
                       fmt::format("must not be below the previous value, {}", before),
                       "Sort the modes, and their shapes with them.");
    }
    before = frequency;
  }
  check_shape("modes.excitation", modes.excitation, modes.frequency.size());
  check_shape("modes.joint", modes.joint, modes.frequency.size());
}

void check_contact(const Rig& rig) {
  const RigContact& contact = rig.contact;
  if (contact.stiffness) require_positive("contact.stiffness", *contact.stiffness);
  if (contact.stick_frequency) {
    require_positive("contact.stick_frequency", *contact.stick_frequency);
  }
  if (!rig.beam()) return;
  require_positive("contact.rod_radius", contact.rod_radius);
  if (contact.stiffness.has_value() != contact.stick_frequency.has_value()) return;
  throw InputError("contact", contact.stiffness ? "stiffness and stick_frequency" : "neither",
                   "must have one of stiffness and stick_frequency",
                   "The stiffness of the stuck joint follows from the first natural frequency at "
                   "low level.");
}

void check_loss_factors(const std::vector<double>& loss_factors) {
  if (loss_factors.empty()) {
    throw InputError("loss_factor", "[]", "must have at least one value",
                     "[0] if there is no linear damping.");
  }
  for (const double loss_factor : loss_factors) {
    if (loss_factor >= 0.0 && loss_factor < 1.0) continue;
    throw InputError("loss_factor", loss_factor, "must be 0 or more and below 1",
                     "A loss factor is twice the damping ratio.");
  }
}

void check_masses(const Rig& rig) {
  for (std::size_t i = 0; i < rig.masses.size(); ++i) {
    const RigMass& mass = rig.masses[i];
    if (!rig.beam()) {
      throw InputError("masses", fmt::format("{} given", rig.masses.size()),
                       "must not be given with modes", "The modes contain all masses.");
    }
    require_non_negative(fmt::format("masses[{}].mass", i), mass.mass);
    if (mass.position >= 0.0 && mass.position <= rig.beam()->length) continue;
    throw InputError(fmt::format("masses[{}].position", i), mass.position,
                     fmt::format("must be from 0 to beam.length = {} m", rig.beam()->length));
  }
}

/// A sensor at a node of all modes would see nothing.
void check_position(const RigBeam& beam, std::string_view field, double position) {
  if (position > 0.0 && position < beam.length) return;
  throw InputError(field, position,
                   fmt::format("must be above 0 and below beam.length = {} m", beam.length),
                   "The beam does not move at its ends.");
}

void check_sensors(const Rig& rig) {
  if (rig.accelerometers.empty()) {
    throw InputError("accelerometers", "none", "must be given at least once",
                     "Add one with its position and channel.");
  }
  if (rig.beam()) check_position(*rig.beam(), "excitation.position", rig.excitation.position);
  for (std::size_t i = 0; i < rig.accelerometers.size(); ++i) {
    const RigSensor& sensor = rig.accelerometers[i];
    if (rig.beam()) {
      check_position(*rig.beam(), fmt::format("accelerometers[{}].position", i), sensor.position);
    } else {
      check_shape(fmt::format("accelerometers[{}].shape", i), sensor.shape,
                  rig.modes()->frequency.size());
    }
  }
  if (!rig.beam() && rig.vibrometer &&
      rig.vibrometer->measures == RigVibrometer::Measures::kAxial) {
    throw InputError("vibrometer.measures", "axial", "must be \"joint\" with modes",
                     "Only a beam has the kinematics that lead from one to the other.");
  }
}

void check_channels(const Rig& rig) {
  std::map<std::string_view, std::string> fields;
  const auto add = [&](const std::string& channel, std::string field) {
    if (channel.empty()) {
      throw InputError(field, "''", "must be the name of a channel");
    }
    const auto [other, fresh] = fields.emplace(channel, field);
    if (!fresh) {
      throw InputError(field, channel, fmt::format("must differ from {}", other->second));
    }
  };
  add(rig.excitation.channel, "excitation.channel");
  for (std::size_t i = 0; i < rig.accelerometers.size(); ++i) {
    add(rig.accelerometers[i].channel, fmt::format("accelerometers[{}].channel", i));
  }
  if (rig.vibrometer) add(rig.vibrometer->channel, "vibrometer.channel");
}

void check_count(std::string_view field, std::size_t value, std::size_t from, std::size_t to) {
  if (value >= from && value <= to) return;
  throw InputError(field, static_cast<double>(value),
                   fmt::format("must be from {} to {}", from, to));
}

/// Time, force and what the sensors read.
std::size_t columns_of(const Rig& rig) {
  return 2 + rig.accelerometers.size() + (rig.vibrometer ? 1 : 0);
}

void check_test(const RigTest& test, std::size_t columns) {
  require_positive("test.response_from", test.response_from);
  require_positive("test.response_to", test.response_to);
  if (test.response_to < test.response_from) {
    throw InputError(
        "test.response_to", test.response_to,
        fmt::format("must not be below the first response, {} m/s^2", test.response_from));
  }
  check_count("test.count", test.count, 1, 100000);
  require_positive("test.sampling_rate", test.sampling_rate);
  require_positive("test.duration", test.duration);
  const auto most = static_cast<double>(most_kept(static_cast<double>(sizeof(double) * columns)));
  if (!(test.duration * test.sampling_rate <= most)) {
    throw InputError("test.duration", test.duration,
                     fmt::format("must be at most {:.6g}: {} samples of {} columns, 1 GiB, at "
                                 "test.sampling_rate = {:.6g} Hz",
                                 most / test.sampling_rate, most, columns, test.sampling_rate),
                     "Record less, or sample more slowly.");
  }
  require_non_negative("test.frequency_resolution", test.frequency_resolution);
  check_count("test.modes", test.modes, 1, 100);
  check_count("test.harmonics", test.harmonics, 1, 100);
}

void check_shaker(const RigShaker& shaker) {
  require_positive("shaker.resistance", shaker.resistance);
  require_non_negative("shaker.inductance", shaker.inductance);
  require_positive("shaker.force_factor", shaker.force_factor);
  require_positive("shaker.moving_mass", shaker.moving_mass);
  require_non_negative("shaker.suspension_stiffness", shaker.suspension_stiffness);
  require_non_negative("shaker.suspension_damping", shaker.suspension_damping);
  require_positive("shaker.stinger_stiffness", shaker.stinger_stiffness);
}

}  // namespace

void check_rig(const Rig& rig) {
  if (rig.beam()) check_beam(*rig.beam());
  if (rig.modes()) check_modes(*rig.modes());
  check_contact(rig);
  check_loss_factors(rig.loss_factor);
  check_masses(rig);
  check_sensors(rig);
  check_channels(rig);
  if (rig.test) check_test(*rig.test, columns_of(rig));
  if (rig.noise) {
    require_non_negative("noise.force", rig.noise->force);
    require_non_negative("noise.acceleration", rig.noise->acceleration);
    require_non_negative("noise.vibrometer", rig.noise->vibrometer);
  }
  if (rig.shaker) check_shaker(*rig.shaker);
}

}  // namespace microslip
