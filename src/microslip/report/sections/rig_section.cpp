// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>

#include "microslip/report/sections/sections.hpp"

namespace microslip {
namespace {

constexpr double kMillimetre = 1e-3;  // m
constexpr double kGigapascal = 1e9;   // Pa
constexpr double kGram = 1e-3;        // kg

using Facts = std::vector<std::pair<std::string, std::string>>;

std::string at(double position) { return fmt::format("{:.4g} mm", position / kMillimetre); }

void add_beam(const Rig& rig, const RigBeam& beam, Facts& facts) {
  facts.emplace_back("beam", fmt::format("{:.5g} × {:.4g} × {:.4g} mm", beam.length / kMillimetre,
                                         beam.width / kMillimetre, beam.thickness / kMillimetre));
  facts.emplace_back("material", fmt::format("E = {:.4g} GPa, ρ = {:.5g} kg/m³",
                                             beam.youngs_modulus / kGigapascal, beam.mass_density));
  for (const RigMass& mass : rig.masses) {
    facts.emplace_back("mass", fmt::format("{:.4g} g at {}", mass.mass / kGram, at(mass.position)));
  }
  facts.emplace_back("radius of the rod", at(rig.contact.rod_radius));
}

void add_contact(const RigContact& contact, Facts& facts) {
  if (contact.stiffness) {
    facts.emplace_back("stuck stiffness",
                       fmt::format("{:.5g} kN/m", *contact.stiffness / kKilonewtonPerMetre));
  }
  if (contact.stick_frequency) {
    facts.emplace_back("stuck frequency", fmt::format("{:.5g} Hz", *contact.stick_frequency));
  }
}

void add_sensor(const char* name, const RigSensor& sensor, bool on_beam, Facts& facts) {
  facts.emplace_back(name, on_beam ? fmt::format("{} at {}", sensor.channel, at(sensor.position))
                                   : sensor.channel);
}

}  // namespace

ReportSection rig_section(const ExperimentResults& results) {
  ReportSection section{.title = "Rig", .blocks = {}};
  if (!results.rig) return section;
  const Rig& rig = *results.rig;
  Facts facts;
  if (const RigBeam* beam = rig.beam()) add_beam(rig, *beam, facts);
  if (const RigModes* modes = rig.modes()) {
    facts.emplace_back("modes", fmt::format("{:.5g} Hz", fmt::join(modes->frequency, ", ")));
  }
  add_contact(rig.contact, facts);
  facts.emplace_back("loss factors", fmt::format("{:.4g}", fmt::join(rig.loss_factor, ", ")));
  const bool on_beam = rig.beam() != nullptr;
  add_sensor("force", rig.excitation, on_beam, facts);
  for (const RigSensor& sensor : rig.accelerometers) {
    add_sensor("accelerometer", sensor, on_beam, facts);
  }
  if (rig.vibrometer) {
    const bool joint = rig.vibrometer->measures == RigVibrometer::Measures::kJoint;
    facts.emplace_back("vibrometer",
                       fmt::format("{}, {}", rig.vibrometer->channel,
                                   joint ? "motion of the joint" : "axial motion of the beam"));
  }
  section.blocks.emplace_back(ReportFacts{.title = "As rig.toml describes it", .facts = facts});
  return section;
}

}  // namespace microslip
