// SPDX-License-Identifier: MIT
#include "microslip/rig/setup/rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "microslip/base/error.hpp"

namespace microslip::rig_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Rig beam_rig() {
  Rig rig;
  rig.structure = RigBeam{.length = 0.5,
                          .width = 0.04,
                          .thickness = 0.005,
                          .youngs_modulus = 2e11,
                          .mass_density = 8000.0};
  rig.contact.rod_radius = 0.03;
  rig.contact.stiffness = 1e5;
  rig.loss_factor = {0.003, 0.002};
  rig.masses = {{.position = 0.4, .mass = 0.03}, {.position = 0.2, .mass = 0.01}};
  rig.excitation = {.position = 0.4, .shape = {}, .channel = "force"};
  rig.accelerometers = {{.position = 0.4, .shape = {}, .channel = "acc1"},
                        {.position = 0.2, .shape = {}, .channel = "acc2"}};
  rig.vibrometer = RigVibrometer{.channel = "ldv", .measures = RigVibrometer::Measures::kAxial};
  rig.test.emplace();
  rig.test->response_from = 1.0;
  rig.test->response_to = 10.0;
  rig.test->sampling_rate = 8192.0;
  rig.test->duration = 1.0;
  rig.noise.emplace();
  return rig;
}

Rig modes_rig() {
  Rig rig;
  rig.structure = RigModes{.frequency = {50.0, 350.0}, .excitation = {1.0, -1.0}, .joint = {2, 3}};
  rig.loss_factor = {0.0};
  rig.excitation.channel = "force";
  rig.accelerometers = {{.position = 0.0, .shape = {1.0, 0.5}, .channel = "acc"}};
  return rig;
}

RigBeam& beam_of(Rig& rig) { return std::get<RigBeam>(rig.structure); }
RigModes& modes_of(Rig& rig) { return std::get<RigModes>(rig.structure); }

using Change = std::function<void(Rig&)>;

/// The name in the error of the rig after a change; empty where there is no error.
std::string fault(Rig rig, const Change& change) {
  change(rig);
  try {
    check_rig(rig);
  } catch (const InputError& error) {
    return error.name();
  }
  return {};
}

std::string message(Rig rig, const Change& change) {
  change(rig);
  try {
    check_rig(rig);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The change of one number, which must be above 0, or 0 or more.
void expect_bounded(const std::string& name, const std::function<double&(Rig&)>& member,
                    bool zero_too) {
  for (const double bad : {-1.0, -1e-300, kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(fault(beam_rig(), [&](Rig& rig) { member(rig) = bad; }), name) << bad;
  }
  EXPECT_EQ(fault(beam_rig(), [&](Rig& rig) { member(rig) = 0.0; }), zero_too ? "" : name);
}

TEST(Rig, TheseAreSound) {
  EXPECT_NO_THROW(check_rig(beam_rig()));
  EXPECT_NO_THROW(check_rig(modes_rig()));
}

TEST(Rig, NumbersAreBounded) {
  const auto positive = [](const std::string& name, const std::function<double&(Rig&)>& member) {
    expect_bounded(name, member, false);
  };
  const auto non_negative = [](const std::string& name,
                               const std::function<double&(Rig&)>& member) {
    expect_bounded(name, member, true);
  };
  using R = Rig&;
  positive("beam.length", [](R rig) -> double& { return beam_of(rig).length; });
  positive("beam.width", [](R rig) -> double& { return beam_of(rig).width; });
  positive("beam.thickness", [](R rig) -> double& { return beam_of(rig).thickness; });
  positive("beam.youngs_modulus", [](R rig) -> double& { return beam_of(rig).youngs_modulus; });
  positive("beam.mass_density", [](R rig) -> double& { return beam_of(rig).mass_density; });
  positive("contact.rod_radius", [](R rig) -> double& { return rig.contact.rod_radius; });
  positive("contact.stiffness", [](R rig) -> double& { return *rig.contact.stiffness; });
  positive("contact.stick_frequency", [](R rig) -> double& {
    rig.contact.stiffness.reset();
    return rig.contact.stick_frequency.emplace();
  });
  non_negative("loss_factor", [](R rig) -> double& { return rig.loss_factor[1]; });
  non_negative("masses[1].mass", [](R rig) -> double& { return rig.masses[1].mass; });
  non_negative("masses[1].position", [](R rig) -> double& { return rig.masses[1].position; });
  positive("excitation.position", [](R rig) -> double& { return rig.excitation.position; });
  positive("accelerometers[1].position",
           [](R rig) -> double& { return rig.accelerometers[1].position; });
  positive("test.response_from", [](R rig) -> double& { return rig.test->response_from; });
  positive("test.response_to", [](R rig) -> double& { return rig.test->response_to; });
  positive("test.sampling_rate", [](R rig) -> double& { return rig.test->sampling_rate; });
  positive("test.duration", [](R rig) -> double& { return rig.test->duration; });
  non_negative("test.frequency_resolution",
               [](R rig) -> double& { return rig.test->frequency_resolution; });
  non_negative("noise.force", [](R rig) -> double& { return rig.noise->force; });
  non_negative("noise.acceleration", [](R rig) -> double& { return rig.noise->acceleration; });
  non_negative("noise.vibrometer", [](R rig) -> double& { return rig.noise->vibrometer; });
}

TEST(Rig, CountsAreBounded) {
  const auto fault_of = [](const Change& change) { return fault(beam_rig(), change); };
  EXPECT_EQ(fault_of([](Rig& rig) { rig.test->count = 0; }), "test.count");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.test->count = 1; }), "");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.test->modes = 0; }), "test.modes");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.test->modes = 1000; }), "test.modes");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.test->harmonics = 0; }), "test.harmonics");
}

TEST(Rig, PlacesLieOnTheBeam) {
  const auto fault_of = [](const Change& change) { return fault(beam_rig(), change); };
  EXPECT_EQ(fault_of([](Rig& rig) { rig.masses[0].position = 0.5; }), "") << "at the support";
  EXPECT_EQ(fault_of([](Rig& rig) { rig.masses[0].position = 0.51; }), "masses[0].position");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.excitation.position = 0.5; }), "excitation.position");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.accelerometers[0].position = 0.5; }),
            "accelerometers[0].position");
}

TEST(Rig, ABeamIsSlender) {
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { beam_of(rig).thickness = 0.1; }), "");
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { beam_of(rig).thickness = 5.0; }), "beam.thickness")
      << "given in mm";
}

TEST(Rig, ABeamHasTheStiffnessOrTheStickFrequency) {
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.contact.stiffness.reset(); }), "contact");
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.contact.stick_frequency = 55.0; }), "contact");
  EXPECT_EQ(fault(modes_rig(), [](Rig& rig) { rig.contact.stiffness = 1e5; }), "");
}

TEST(Rig, ShapesHaveAValueAMode) {
  const auto fault_of = [](const Change& change) { return fault(modes_rig(), change); };
  EXPECT_EQ(fault_of([](Rig& rig) { modes_of(rig).excitation.pop_back(); }), "modes.excitation");
  EXPECT_EQ(fault_of([](Rig& rig) { modes_of(rig).joint.push_back(1.0); }), "modes.joint");
  EXPECT_EQ(fault_of([](Rig& rig) { modes_of(rig).joint[0] = kNan; }), "modes.joint");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.accelerometers[0].shape.clear(); }),
            "accelerometers[0].shape");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.accelerometers[0].shape[1] = kInfinity; }),
            "accelerometers[0].shape");
}

TEST(Rig, FrequenciesRise) {
  const auto fault_of = [](const std::vector<double>& frequency) {
    return fault(modes_rig(), [&](Rig& rig) { modes_of(rig).frequency = frequency; });
  };
  for (const std::vector<double>& bad :
       {std::vector<double>{}, {0.0, 1.0}, {2.0, 1.0}, {1.0, kNan}, {1.0, kInfinity}}) {
    EXPECT_EQ(fault_of(bad), "modes.frequency");
  }
  EXPECT_EQ(fault_of({50.0, 50.0}), "") << "two modes of one frequency";
}

TEST(Rig, OnlyABeamHasMassesAndAnAxialMotion) {
  EXPECT_EQ(fault(modes_rig(), [](Rig& rig) { rig.masses.push_back({0.1, 0.1}); }), "masses");
  const auto fault_of = [](RigVibrometer::Measures measures) {
    return fault(modes_rig(), [&](Rig& rig) { rig.vibrometer = RigVibrometer{"ldv", measures}; });
  };
  EXPECT_EQ(fault_of(RigVibrometer::Measures::kAxial), "vibrometer.measures");
  EXPECT_EQ(fault_of(RigVibrometer::Measures::kJoint), "");
}

TEST(Rig, LossFactorsAreBelowOne) {
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.loss_factor.clear(); }), "loss_factor");
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.loss_factor[0] = 1.0; }), "loss_factor");
}

TEST(Rig, ChannelsDiffer) {
  const auto fault_of = [](const Change& change) { return fault(beam_rig(), change); };
  EXPECT_EQ(fault_of([](Rig& rig) { rig.excitation.channel.clear(); }), "excitation.channel");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.accelerometers[1].channel = "force"; }),
            "accelerometers[1].channel");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.vibrometer->channel = "acc2"; }), "vibrometer.channel");
  EXPECT_EQ(fault_of([](Rig& rig) { rig.accelerometers.clear(); }), "accelerometers");
}

TEST(Rig, TheResponseGrows) {
  EXPECT_EQ(message(beam_rig(), [](Rig& rig) { rig.test->response_to = 0.5; }),
            "test.response_to = 0.5; must not be below the first response, 1 m/s^2");
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.test->response_to = 1.0; }), "");
}

TEST(Rig, MessagesNameValueRuleAndRemedy) {
  EXPECT_EQ(message(beam_rig(), [](Rig& rig) { beam_of(rig).length = -1.0; }),
            "beam.length = -1; must be above 0 and finite");
  EXPECT_EQ(message(modes_rig(), [](Rig& rig) { rig.accelerometers[0].shape.pop_back(); }),
            "accelerometers[0].shape = 1 values; must have 2, one per mode of modes.frequency");
}

TEST(Rig, LaterModesTakeTheLastLossFactor) {
  const Rig rig = beam_rig();
  EXPECT_EQ(rig.loss_factor_of(0), 0.003);
  EXPECT_EQ(rig.loss_factor_of(1), 0.002);
  EXPECT_EQ(rig.loss_factor_of(40), 0.002);
}

TEST(Rig, ABeamHasAreaAndBendingStiffness) {
  const RigBeam beam{.length = 1.0, .width = 2.0, .thickness = 3.0, .youngs_modulus = 4.0};
  EXPECT_EQ(beam.area(), 6.0);
  EXPECT_EQ(beam.bending_stiffness(), 18.0) << "4 · 2 · 3³ / 12";
}

// Time, force, two accelerometers and the vibrometer: 2^30 bytes are 26843545 rows of 5 doubles.
TEST(Rig, ARecordFitsIntoMemory) {
  EXPECT_EQ(
      message(beam_rig(), [](Rig& rig) { rig.test->duration = 13000.0; }),
      "test.duration = 13000; must be at most 3276.8: 26843545 samples of 5 columns, 1 GiB, at "
      "test.sampling_rate = 8192 Hz. Record less, or sample more slowly.");
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.test->duration = 1e300; }), "test.duration");
  EXPECT_EQ(fault(beam_rig(), [](Rig& rig) { rig.test->duration = 3276.0; }), "");
}

}  // namespace
}  // namespace microslip::rig_test
