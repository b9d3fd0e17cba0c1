// SPDX-License-Identifier: MIT
// Whatever is passed: an error that names the argument, and nothing written.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "c/handle.hpp"

namespace microslip::test::bad_input {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max();

/// One of each handle, and arrays of three values.
struct Handles {
  CJoint joint;
  CMemory memory;
  CLevels levels;
  CIdentification found;
  CModel model;
  CStructure structure;
  CCurve curve;
  CMarched marched;
  std::vector<double> rising{1.0, 2.0, 3.0};
  std::vector<double> with_nan{1.0, kNan, 3.0};
  std::vector<double> negative{1.0, 2.0, -3.0};
  std::vector<double> falling{3.0, 2.0, 1.0};
  double out[3] = {};
  const double* values = nullptr;
  const double* const one_load[1] = {rising.data()};
  const double* const null_load[1] = {nullptr};
  const char* const null_place[1] = {nullptr};
  std::size_t count = 0;

  Handles() {
    const auto read = [](const char* file) { return example(file); };
    EXPECT_OK(microslip_joint_read(read("one_mass/joint.json").c_str(), joint.out()));
    EXPECT_OK(microslip_memory_create(joint, memory.out()));
    EXPECT_OK(microslip_levels_read(read("brake_reuss_beam/levels.csv").c_str(), levels.out()));
    auto options = defaults(microslip_identify_options_defaults);
    options.stiffness = 1e7;
    EXPECT_OK(microslip_identify(levels, &options, found.out()));
    EXPECT_OK(microslip_model_create(1, rising.data(), out, MICROSLIP_VISCOUS, model.out()));
    EXPECT_OK(microslip_structure_read(read("one_mass/model.toml").c_str(), structure.out()));
    auto quick = defaults(microslip_frf_options_defaults);
    quick.harmonics = 1;
    EXPECT_OK(microslip_frf(structure, nullptr, MICROSLIP_KEEP_FORCE, 0.1, 0.14, 0.15, &quick,
                            curve.out()));
    EXPECT_OK(
        microslip_march(structure, 3, rising.data(), 1, nullptr, one_load, nullptr, marched.out()));
  }
};

struct Bad {
  const char* what;  ///< for a person
  const char* name;  ///< that the message begins with
  std::function<microslip_status(Handles&)> call;
};

microslip_part uniform() {
  auto part = defaults(microslip_part_defaults);
  part.to = 1.0;
  part.weight = 0.5;
  return part;
}

microslip_status joint_of(Handles& h, const std::function<void(microslip_part&)>& change,
                          double stiffness = 1e5) {
  (void)h;
  std::vector<microslip_part> parts{uniform(), uniform()};
  change(parts[1]);
  CJoint joint;
  return microslip_joint_create(stiffness, parts.data(), 2, joint.out());
}

/// Both parts say that they have this size.
microslip_status joint_of_size(std::size_t size) {
  std::vector<microslip_part> parts(200, uniform());  // beyond what is said
  for (microslip_part& part : parts) part.struct_size = size;
  CJoint joint;
  return microslip_joint_create(1e5, parts.data(), 2, joint.out());
}

microslip_status identify_with(Handles& h,
                               const std::function<void(microslip_identify_options&)>& change) {
  auto options = defaults(microslip_identify_options_defaults);
  options.stiffness = 1e7;
  change(options);
  CIdentification found;
  return microslip_identify(h.levels, &options, found.out());
}

microslip_status frf_with(Handles& h, const std::function<void(microslip_frf_options&)>& change) {
  auto options = defaults(microslip_frf_options_defaults);
  change(options);
  CCurve curve;
  return microslip_frf(h.structure, "mass", MICROSLIP_KEEP_FORCE, 0.1, 0.14, 0.15, &options,
                       curve.out());
}

microslip_status frf_at(Handles& h, double frequency) {
  return frf_with(h, [&](auto& options) {
    options.at_count = 1;
    options.at = &frequency;
  });
}

microslip_status march_with(Handles& h,
                            const std::function<void(microslip_march_options&)>& change) {
  auto options = defaults(microslip_march_options_defaults);
  change(options);
  CMarched marched;
  return microslip_march(h.structure, 3, h.rising.data(), 1, nullptr, h.one_load, &options,
                         marched.out());
}

microslip_status joint_added(Handles& h,
                             const std::function<void(microslip_joint_options&)>& change) {
  auto options = defaults(microslip_joint_options_defaults);
  change(options);
  return microslip_model_add_joint(h.model, "j", h.joint, 1, h.rising.data(), &options);
}

std::vector<Bad> joint_table() {
  using H = Handles;
  return {
      {"no joint to write to", "joint",
       [](H&) { return microslip_joint_create(1.0, nullptr, 0, nullptr); }},
      {"parts without any", "parts",
       [](H&) {
         CJoint joint;
         return microslip_joint_create(1.0, nullptr, 2, joint.out());
       }},
      {"stiffness of 0", "stiffness",
       [](H& h) {
         return joint_of(
             h, [](auto&) {}, 0.0);
       }},
      {"stiffness below 0", "stiffness",
       [](H& h) {
         return joint_of(
             h, [](auto&) {}, -1.0);
       }},
      {"stiffness NaN", "stiffness",
       [](H& h) {
         return joint_of(
             h, [](auto&) {}, kNan);
       }},
      {"stiffness infinite", "stiffness",
       [](H& h) {
         return joint_of(
             h, [](auto&) {}, kInfinity);
       }},
      {"unknown kind", "parts[1].kind",
       [](H& h) {
         return joint_of(h, [](auto& part) { part.kind = static_cast<microslip_part_kind>(99); });
       }},
      {"size of an older age", "parts[1]->struct_size",
       [](H& h) { return joint_of(h, [](auto& part) { part.struct_size = 8; }); }},
      {"a larger size than the first", "parts[1]->struct_size",
       [](H& h) { return joint_of(h, [](auto& part) { part.struct_size += 8; }); }},
      {"a size that no alignment has", "parts[0]->struct_size",
       [](H&) { return joint_of_size(sizeof(microslip_part) + 1); }},
      {"a size beyond 4 KiB", "parts[0]->struct_size", [](H&) { return joint_of_size(4096 + 8); }},
      {"weight below 0", "parts[1].weight",
       [](H& h) { return joint_of(h, [](auto& part) { part.weight = -0.1; }); }},
      {"weight NaN", "parts[1].weight",
       [](H& h) { return joint_of(h, [](auto& part) { part.weight = kNan; }); }},
      {"to below from", "parts[1].to",
       [](H& h) { return joint_of(h, [](auto& part) { part.from = 2.0; }); }},
      {"atoms without an array", "parts[1].slip_force",
       [](H& h) {
         return joint_of(h, [](auto& part) {
           part.kind = MICROSLIP_PART_ATOMS;
           part.count = 3;
         });
       }},
      {"atoms beyond any memory", "count of parts[1].slip_force",
       [](H& h) {
         return joint_of(h, [&](auto& part) {
           part.kind = MICROSLIP_PART_ATOMS;
           part.count = kHuge;
           part.slip_force = part.value = h.rising.data();
         });
       }},
      {"knots out of order", "parts[1].slip_force",
       [](H& h) {
         return joint_of(h, [&](auto& part) {
           part.kind = MICROSLIP_PART_PIECEWISE_LINEAR;
           part.count = 3;
           part.slip_force = part.value = h.falling.data();
         });
       }},
      {"a value NaN", "parts[1].value[1]",
       [](H& h) {
         return joint_of(h, [&](auto& part) {
           part.kind = MICROSLIP_PART_ATOMS;
           part.count = 3;
           part.slip_force = h.rising.data();
           part.value = h.with_nan.data();
         });
       }},
      {"too much weight", "total weight",
       [](H& h) { return joint_of(h, [](auto& part) { part.weight = 0.6; }); }},
      {"four parameters beside others", "parts[1]",
       [](H& h) {
         return joint_of(h, [](auto& part) { part.kind = MICROSLIP_PART_FOUR_PARAMETER; });
       }},
      {"no path to read", "path",
       [](H&) {
         CJoint joint;
         return microslip_joint_read(nullptr, joint.out());
       }},
      {"no text to parse", "text",
       [](H&) {
         CJoint joint;
         return microslip_joint_parse(nullptr, joint.out());
       }},
      {"no path to write", "path", [](H& h) { return microslip_joint_write(h.joint, nullptr); }},
      {"no joint to write", "joint", [](H&) { return microslip_joint_write(nullptr, "x.json"); }},
      {"no text to point", "text", [](H& h) { return microslip_joint_text(h.joint, nullptr); }},
      {"a part too many", "index",
       [](H& h) {
         auto part = defaults(microslip_part_defaults);
         return microslip_joint_part(h.joint, 1, &part);
       }},
      {"no part", "part", [](H& h) { return microslip_joint_part(h.joint, 0, nullptr); }},
      {"a part without a size", "part->struct_size",
       [](H& h) {
         microslip_part part{};
         return microslip_joint_part(h.joint, 0, &part);
       }},
      {"force of no joint", "joint",
       [](H& h) { return microslip_virgin_force(nullptr, 3, h.rising.data(), h.out); }},
      {"force of no path", "displacement",
       [](H& h) { return microslip_virgin_force(h.joint, 3, nullptr, h.out); }},
      {"force into nothing", "force",
       [](H& h) { return microslip_virgin_force(h.joint, 3, h.rising.data(), nullptr); }},
      {"force of NaN", "displacement[1]",
       [](H& h) { return microslip_virgin_force(h.joint, 3, h.with_nan.data(), h.out); }},
      {"force of too many", "count of displacement",
       [](H& h) { return microslip_virgin_force(h.joint, kHuge, h.rising.data(), h.out); }},
      {"tangent of NaN", "displacement[1]",
       [](H& h) { return microslip_tangent_stiffness(h.joint, 3, h.with_nan.data(), h.out); }},
      {"amplitude below 0", "amplitude[2]",
       [](H& h) { return microslip_dissipation(h.joint, 3, h.negative.data(), h.out); }},
      {"secant below 0", "amplitude[2]",
       [](H& h) { return microslip_secant_stiffness(h.joint, 3, h.negative.data(), h.out); }},
      {"density below 0", "slip_force[2]",
       [](H& h) { return microslip_density(h.joint, 3, h.negative.data(), h.out); }},
      {"memory of no joint", "joint",
       [](H&) {
         CMemory memory;
         return microslip_memory_create(nullptr, memory.out());
       }},
      {"memory into nothing", "memory",
       [](H& h) { return microslip_memory_create(h.joint, nullptr); }},
      {"copy of nothing", "memory",
       [](H&) {
         CMemory copy;
         return microslip_memory_copy(nullptr, copy.out());
       }},
      {"copy into nothing", "copy", [](H& h) { return microslip_memory_copy(h.memory, nullptr); }},
      {"assigned nothing", "from", [](H& h) { return microslip_memory_assign(h.memory, nullptr); }},
      {"trial to NaN", "displacement",
       [](H& h) { return microslip_memory_trial(h.memory, kNan, h.out, h.out); }},
      {"trial into nothing", "force",
       [](H& h) { return microslip_memory_trial(h.memory, 1.0, nullptr, h.out); }},
      {"advanced to infinity", "displacement",
       [](H& h) { return microslip_memory_advance(h.memory, kInfinity, h.out); }},
      {"marched over NaN", "displacement[1]",
       [](H& h) { return microslip_memory_march(h.memory, 3, h.with_nan.data(), h.out); }},
      {"dissipation to NaN", "displacement",
       [](H& h) { return microslip_memory_dissipation(h.memory, kNan, h.out); }},
      {"stored into nothing", "energy",
       [](H& h) { return microslip_memory_stored_energy(h.memory, nullptr); }},
      {"state of nothing", "memory",
       [](H& h) { return microslip_memory_state(nullptr, h.out, h.out); }},
      {"reset of nothing", "memory", [](H&) { return microslip_memory_reset(nullptr); }},
  };
}

std::vector<Bad> identify_table() {
  using H = Handles;
  const auto levels_of = [](std::size_t count, const double* a, const double* d) {
    CLevels levels;
    return microslip_levels_create(count, a, d, levels.out());
  };
  return {
      {"no levels", "number of levels",
       [=](H& h) { return levels_of(0, h.rising.data(), h.rising.data()); }},
      {"levels beyond any memory", "count of amplitude",
       [=](H& h) { return levels_of(kHuge, h.rising.data(), h.rising.data()); }},
      {"no amplitude", "amplitude", [=](H& h) { return levels_of(3, nullptr, h.rising.data()); }},
      {"no dissipation", "dissipation",
       [=](H& h) { return levels_of(3, h.rising.data(), nullptr); }},
      {"an amplitude NaN", "amplitude[1]",
       [=](H& h) { return levels_of(3, h.with_nan.data(), h.rising.data()); }},
      {"an amplitude below 0", "amplitude of level 3",
       [=](H& h) { return levels_of(3, h.negative.data(), h.rising.data()); }},
      {"a dissipation below 0", "dissipation of level 3",
       [=](H& h) { return levels_of(3, h.rising.data(), h.negative.data()); }},
      {"unknown column", "column",
       [](H& h) {
         std::size_t n = 0;
         EXPECT_OK(microslip_levels_count(h.levels, &n));
         const std::vector<double> ones(n, 1.0);
         return microslip_levels_set(h.levels, static_cast<microslip_level_column>(77), n,
                                     ones.data());
       }},
      {"a column of another length", "count",
       [](H& h) {
         return microslip_levels_set(h.levels, MICROSLIP_LEVEL_AMPLITUDE_STD, 1, h.rising.data());
       }},
      {"no path of levels", "path",
       [](H&) {
         CLevels levels;
         return microslip_levels_read(nullptr, levels.out());
       }},
      {"no options", "options",
       [](H& h) {
         CIdentification found;
         return microslip_identify(h.levels, nullptr, found.out());
       }},
      {"options that were not filled", "options->struct_size",
       [](H& h) {
         microslip_identify_options options{};
         CIdentification found;
         return microslip_identify(h.levels, &options, found.out());
       }},
      {"defaults of a small struct", "options->struct_size",
       [](H&) {
         microslip_identify_options options{};
         return microslip_identify_options_defaults(&options, 4);
       }},
      {"no stiffness", "options->stiffness",
       [](H& h) { return identify_with(h, [](auto& options) { options.stiffness = 0.0; }); }},
      {"stiffness NaN", "options->stiffness",
       [](H& h) { return identify_with(h, [](auto& options) { options.stiffness = kNan; }); }},
      {"unknown method", "options->method",
       [](H& h) { return identify_with(h, [](auto& options) { options.method = "guess"; }); }},
      {"unknown fit", "options->fit",
       [](H& h) { return identify_with(h, [](auto& options) { options.fit = "any"; }); }},
      {"unknown smoothing", "`smoothing`",
       [](H& h) { return identify_with(h, [](auto& options) { options.smoothing = "much"; }); }},
      {"few draws", "options->bands",
       [](H& h) { return identify_with(h, [](auto& options) { options.bands = 3; }); }},
      {"more draws than use", "options->bands",
       [](H& h) { return identify_with(h, [](auto& options) { options.bands = 1'000'001; }); }},
      {"draws beyond any memory", "options->bands",
       [](H& h) { return identify_with(h, [](auto& options) { options.bands = kHuge; }); }},
      {"draws beyond any vector", "options->bands",
       [](H& h) {
         return identify_with(h, [](auto& options) { options.bands = std::size_t{1} << 60U; });
       }},
      {"confidence of 1", "options->confidence",
       [](H& h) {
         return identify_with(h, [](auto& options) {
           options.bands = 20;
           options.confidence = 1.0;
         });
       }},
      {"threads below 0", "options->threads",
       [](H& h) {
         return identify_with(h, [](auto& options) {
           options.bands = 20;
           options.threads = -1;
         });
       }},
      {"a gain NaN", "options->dissipation_gain_std",
       [](H& h) {
         return identify_with(h, [](auto& options) { options.dissipation_gain_std = kNan; });
       }},
      {"an error of a loss that the file does not have", "options->loss_factor_std",
       [](H& h) { return identify_with(h, [](auto& options) { options.loss_factor_std = 0.1; }); }},
      {"an error of a loss that nobody set", "options->loss_factor_std",
       [=](H& h) {
         CLevels levels;
         EXPECT_OK(microslip_levels_create(3, h.rising.data(), h.rising.data(), levels.out()));
         auto options = defaults(microslip_identify_options_defaults);
         options.stiffness = 1e7;
         options.loss_factor_std = 0.1;
         CIdentification found;
         return microslip_identify(levels, &options, found.out());
       }},
      {"a command that is no UTF-8", "options->command",
       [](H& h) { return identify_with(h, [](auto& options) { options.command = "caf\xE9"; }); }},
      {"a command of two lines", "options->command",
       [](H& h) { return identify_with(h, [](auto& options) { options.command = "a\nb"; }); }},
      {"unknown values", "what",
       [](H& h) {
         return microslip_identification_values(
             h.found, static_cast<microslip_identified_values>(50), &h.values, &h.count);
       }},
      {"values into nothing", "values",
       [](H& h) {
         return microslip_identification_values(h.found, MICROSLIP_IDENTIFIED_DENSITY, nullptr,
                                                &h.count);
       }},
      {"a joint into nothing", "joint",
       [](H& h) { return microslip_identification_joint(h.found, nullptr); }},
      {"number of nothing", "identification",
       [](H& h) {
         return microslip_identification_number(nullptr, MICROSLIP_IDENTIFIED_COVERED_TO, h.out);
       }},
      {"a warning too many", "index",
       [](H& h) { return microslip_identification_warning(h.found, 1000, nullptr, nullptr); }},
      {"an outcome without a size", "outcome->struct_size",
       [](H& h) {
         microslip_outcome outcome{};
         return microslip_identification_outcome(h.found, &outcome);
       }},
  };
}

std::vector<Bad> structure_table() {
  using H = Handles;
  const auto model_of = [](std::size_t modes, const double* f, const double* eta, int damping = 0) {
    CModel model;
    return microslip_model_create(modes, f, eta, static_cast<microslip_damping>(damping),
                                  model.out());
  };
  return {
      {"no modes", "modes", [=](H& h) { return model_of(0, h.rising.data(), h.rising.data()); }},
      {"modes beyond any memory", "count of frequency",
       [=](H& h) { return model_of(kHuge, h.rising.data(), h.rising.data()); }},
      {"no frequencies", "frequency", [=](H& h) { return model_of(3, nullptr, h.rising.data()); }},
      {"a frequency below 0", "frequency[2]",
       [=](H& h) { return model_of(3, h.negative.data(), h.rising.data()); }},
      {"a loss factor below 0", "loss_factor[2]",
       [=](H& h) { return model_of(3, h.rising.data(), h.negative.data()); }},
      {"unknown damping", "damping",
       [=](H& h) { return model_of(3, h.rising.data(), h.rising.data(), 9); }},
      {"a point without a name", "name",
       [](H& h) { return microslip_model_add_point(h.model, nullptr, 1, h.rising.data()); }},
      {"a point with an empty name", "name",
       [](H& h) { return microslip_model_add_point(h.model, "", 1, h.rising.data()); }},
      {"a point of other modes", "modes",
       [](H& h) { return microslip_model_add_point(h.model, "p", 3, h.rising.data()); }},
      {"a point without a shape", "shape",
       [](H& h) { return microslip_model_add_point(h.model, "p", 1, nullptr); }},
      {"a joint that is none", "joint",
       [](H& h) {
         return microslip_model_add_joint(h.model, "j", nullptr, 1, h.rising.data(), nullptr);
       }},
      {"a spring below 0", "options->spring_in_modes",
       [](H& h) { return joint_added(h, [](auto& options) { options.spring_in_modes = -1.0; }); }},
      {"a compliance NaN", "options->series_compliance",
       [](H& h) {
         return joint_added(h, [](auto& options) { options.series_compliance = kNan; });
       }},
      {"a damping below 0", "options->linear_damping",
       [](H& h) { return joint_added(h, [](auto& options) { options.linear_damping = -1.0; }); }},
      {"an excitation nowhere", "point",
       [](H& h) { return microslip_model_add_excitation(h.model, nullptr, 1, nullptr, nullptr); }},
      {"no harmonics", "harmonics",
       [](H& h) { return microslip_model_add_excitation(h.model, "p", 0, nullptr, nullptr); }},
      {"harmonics without values", "real",
       [](H& h) { return microslip_model_add_excitation(h.model, "p", 2, nullptr, nullptr); }},
      {"harmonics beyond any memory", "harmonics",
       [](H& h) {
         return microslip_model_add_excitation(h.model, "p", kHuge, h.rising.data(), nullptr);
       }},
      {"more harmonics than a balance takes", "harmonics",
       [](H& h) {
         const std::vector<double> ones(1001, 1.0);
         return microslip_model_add_excitation(h.model, "p", ones.size(), ones.data(), nullptr);
       }},
      {"a harmonic NaN", "imaginary[1]",
       [](H& h) {
         return microslip_model_add_excitation(h.model, "p", 3, h.rising.data(), h.with_nan.data());
       }},
      {"a load NaN", "force",
       [](H& h) { return microslip_model_add_static_load(h.model, "p", kNan); }},
      {"a model without excitation", "model",
       [](H& h) {
         CStructure structure;
         return microslip_structure_create(h.model, structure.out());
       }},
      {"a name too many", "index",
       [](H& h) {
         const char* name = nullptr;
         return microslip_structure_point(h.structure, 7, &name);
       }},
  };
}

std::vector<Bad> prediction_table() {
  using H = Handles;
  const auto frf = [](H& h, const char* point, int kept, double value, double from, double to) {
    CCurve curve;
    return microslip_frf(h.structure, point, static_cast<microslip_kept>(kept), value, from, to,
                         nullptr, curve.out());
  };
  const auto march = [](H& h, std::size_t count, const double* time, std::size_t loads,
                        const char* const* places, const double* const* force) {
    CMarched marched;
    return microslip_march(h.structure, count, time, loads, places, force, nullptr, marched.out());
  };
  return {
      {"frf of nothing", "structure",
       [](H&) {
         CCurve curve;
         return microslip_frf(nullptr, nullptr, MICROSLIP_KEEP_FORCE, 1.0, 1.0, 2.0, nullptr,
                              curve.out());
       }},
      {"frf into nothing", "curve",
       [](H& h) {
         return microslip_frf(h.structure, nullptr, MICROSLIP_KEEP_FORCE, 1.0, 1.0, 2.0, nullptr,
                              nullptr);
       }},
      {"unknown point", "point", [=](H& h) { return frf(h, "nowhere", 0, 1.0, 1.0, 2.0); }},
      {"unknown kept", "kept", [=](H& h) { return frf(h, "mass", 12, 1.0, 1.0, 2.0); }},
      {"force of 0", "value", [=](H& h) { return frf(h, "mass", 0, 0.0, 1.0, 2.0); }},
      {"force NaN", "value", [=](H& h) { return frf(h, "mass", 0, kNan, 1.0, 2.0); }},
      {"from 0 Hz", "from", [=](H& h) { return frf(h, "mass", 0, 1.0, 0.0, 2.0); }},
      {"to infinity", "to", [=](H& h) { return frf(h, "mass", 0, 1.0, 1.0, kInfinity); }},
      {"no range", "to", [=](H& h) { return frf(h, "mass", 0, 1.0, 1.0, 1.0); }},
      {"no harmonics", "harmonics",
       [](H& h) { return frf_with(h, [](auto& options) { options.harmonics = 0; }); }},
      {"few samples", "samples",
       [](H& h) { return frf_with(h, [](auto& options) { options.samples = 3; }); }},
      {"tolerance NaN", "tolerance",
       [](H& h) { return frf_with(h, [](auto& options) { options.tolerance = kNan; }); }},
      {"unknown response", "options->response",
       [](H& h) {
         return frf_with(
             h, [](auto& options) { options.response = static_cast<microslip_response>(9); });
       }},
      {"frequencies without values", "options->at",
       [](H& h) { return frf_with(h, [](auto& options) { options.at_count = 2; }); }},
      {"a frequency above the range", "options->at[0]", [](H& h) { return frf_at(h, 900.0); }},
      {"a frequency below the range", "options->at[0]", [](H& h) { return frf_at(h, 0.139); }},
      {"options of a later age", "options",
       [](H& h) {
         struct {
           microslip_frf_options options;
           double later;
         } later{defaults(microslip_frf_options_defaults), 1.0};
         later.options.struct_size = sizeof later;
         CCurve curve;
         return microslip_frf(h.structure, nullptr, MICROSLIP_KEEP_FORCE, 1.0, 1.0, 2.0,
                              &later.options, curve.out());
       }},
      {"backbone without responses", "count",
       [](H& h) {
         CCurve curve;
         return microslip_backbone(h.structure, "mass", 0, 0, h.rising.data(), nullptr,
                                   curve.out());
       }},
      {"backbone out of order", "response[1]",
       [](H& h) {
         CCurve curve;
         return microslip_backbone(h.structure, "mass", 0, 3, h.falling.data(), nullptr,
                                   curve.out());
       }},
      {"backbone of a mode too many", "mode",
       [](H& h) {
         CCurve curve;
         return microslip_backbone(h.structure, "mass", 5, 3, h.rising.data(), nullptr,
                                   curve.out());
       }},
      {"unknown column of a curve", "what",
       [](H& h) {
         return microslip_curve_values(h.curve, static_cast<microslip_curve_values_of>(-1),
                                       &h.values, &h.count);
       }},
      {"a joint too many of a curve", "joint",
       [](H& h) {
         return microslip_curve_joint(h.curve, 1, MICROSLIP_CURVE_JOINT_AMPLITUDE, &h.values,
                                      &h.count);
       }},
      {"a harmonic too many", "harmonic",
       [](H& h) {
         EXPECT_OK(microslip_curve_values(h.curve, MICROSLIP_CURVE_FORCE, &h.values, &h.count));
         std::vector<double> w(h.count);
         return microslip_curve_harmonic(h.curve, "mass", 2, h.count, w.data(), w.data());
       }},
      {"harmonics of another length", "count",
       [](H& h) { return microslip_curve_harmonic(h.curve, "mass", 1, 1, h.out, h.out); }},
      {"one time", "number of times",
       [=](H& h) { return march(h, 1, h.rising.data(), 1, nullptr, h.one_load); }},
      {"no time", "time", [=](H& h) { return march(h, 3, nullptr, 1, nullptr, h.one_load); }},
      {"times that fall", "time[1]",
       [=](H& h) { return march(h, 3, h.falling.data(), 1, nullptr, h.one_load); }},
      {"times beyond any memory", "count of time",
       [=](H& h) { return march(h, kHuge, h.rising.data(), 1, nullptr, h.one_load); }},
      {"no loads", "loads",
       [=](H& h) { return march(h, 3, h.rising.data(), 1, nullptr, nullptr); }},
      {"a load that is none", "loads[0]",
       [=](H& h) { return march(h, 3, h.rising.data(), 1, nullptr, h.null_load); }},
      {"a place that is none", "places[0]",
       [=](H& h) { return march(h, 3, h.rising.data(), 1, h.null_place, h.one_load); }},
      {"two loads without places", "places",
       [=](H& h) { return march(h, 3, h.rising.data(), 2, nullptr, h.one_load); }},
      {"more loads than places", "load_count",
       [=](H& h) { return march(h, 3, h.rising.data(), 2, h.null_place, h.one_load); }},
      {"loads beyond any memory", "load_count",
       [=](H& h) { return march(h, 3, h.rising.data(), kHuge, h.null_place, h.one_load); }},
      {"a step below 0", "step",
       [](H& h) { return march_with(h, [](auto& options) { options.step = -1.0; }); }},
      {"every 0th time", "every",
       [](H& h) { return march_with(h, [](auto& options) { options.every = 0; }); }},
      {"a start of other modes", "options->start_modes",
       [](H& h) { return march_with(h, [](auto& options) { options.start_modes = 4; }); }},
      {"a start of no modes", "options->start_modes",
       [](H& h) {
         return march_with(h, [&](auto& options) { options.start_velocity = h.rising.data(); });
       }},
      {"a start at a place of no modes", "options->start_modes",
       [](H& h) {
         return march_with(h, [&](auto& options) { options.start_displacement = h.rising.data(); });
       }},
      {"unknown motion", "what",
       [](H& h) {
         return microslip_marched_point(h.marched, 0, static_cast<microslip_response>(8), &h.values,
                                        &h.count);
       }},
      {"a point too many", "point",
       [](H& h) {
         return microslip_marched_point(h.marched, 1, MICROSLIP_VELOCITY, &h.values, &h.count);
       }},
      {"unknown number", "what",
       [](H& h) {
         return microslip_marched_value(h.marched, static_cast<microslip_marched_number>(40),
                                        h.out);
       }},
      {"times of nothing", "marched",
       [](H& h) { return microslip_marched_time(nullptr, &h.values, &h.count); }},
  };
}

void expect_named(const std::vector<Bad>& table) {
  Handles handles;
  for (const Bad& bad : table) {
    EXPECT_EQ(bad.call(handles), MICROSLIP_INPUT) << bad.what;
    const std::string message = microslip_last_error();
    EXPECT_TRUE(message.starts_with(bad.name))
        << bad.what << ": '" << message << "' does not begin with '" << bad.name << "'";
  }
}

TEST(CBadInput, OfJointsNamesTheArgument) { expect_named(joint_table()); }
TEST(CBadInput, OfIdentificationNamesTheArgument) { expect_named(identify_table()); }
TEST(CBadInput, OfStructuresNamesTheArgument) { expect_named(structure_table()); }
TEST(CBadInput, OfPredictionsNamesTheArgument) { expect_named(prediction_table()); }

TEST(CBadInput, OfFilesHasStatusesOfItsOwn) {
  CJoint joint;
  EXPECT_EQ(microslip_joint_read("/nowhere/joint.json", joint.out()), MICROSLIP_FILE);
  EXPECT_EQ(microslip_joint_parse("{", joint.out()), MICROSLIP_FORMAT);
  EXPECT_EQ(microslip_joint_parse(R"({"schema": "microslip.joint/1", "stiffness_N_per_m": -1,
                                      "density": []})",
                                  joint.out()),
            MICROSLIP_INPUT);
  EXPECT_EQ(joint, nullptr);
  CJoint good;
  ASSERT_OK(microslip_joint_create(1.0, nullptr, 0, good.out()));
  EXPECT_EQ(microslip_joint_write(good, "/nowhere/joint.json"), MICROSLIP_FILE);
}

// A listener of C++ is the one place from where any exception comes.
TEST(CBadInput, IsNoMemoryWhereAVectorCannotBeSoLong) {
  Handles handles;
  const auto status = frf_with(handles, [](auto& options) {
    options.progress = [](std::size_t, std::size_t, void*) -> int {
      throw std::length_error("too long");
    };
  });
  EXPECT_EQ(status, MICROSLIP_MEMORY);
  EXPECT_STREQ(microslip_last_error(), "no memory left");
}

TEST(CBadInput, LeavesAMemoryWhereItWas) {
  CJoint joint;
  CMemory memory;
  ASSERT_OK(microslip_joint_create(1e5, nullptr, 0, joint.out()));
  ASSERT_OK(microslip_memory_create(joint, memory.out()));
  ASSERT_OK(microslip_memory_advance(memory, 1e-5, nullptr));
  const double path[] = {2e-5, kNan};
  double force[2] = {};
  EXPECT_EQ(microslip_memory_march(memory, 2, path, force), MICROSLIP_INPUT);
  double x = 0.0;
  ASSERT_OK(microslip_memory_state(memory, &x, nullptr));
  EXPECT_EQ(x, 1e-5);
}

TEST(CBadInput, IsReportedToEachThreadByItself) {
  CJoint joint;
  EXPECT_EQ(microslip_joint_create(-1.0, nullptr, 0, joint.out()), MICROSLIP_INPUT);
  const std::string here = microslip_last_error();
  std::string there = "not asked";
  std::thread([&] { there = microslip_last_error(); }).join();
  EXPECT_EQ(there, "");
  EXPECT_EQ(microslip_last_error(), here);
}

TEST(CBadInput, DestroysNothingWithoutHarm) {
  microslip_joint_destroy(nullptr);
  microslip_memory_destroy(nullptr);
  microslip_levels_destroy(nullptr);
  microslip_identification_destroy(nullptr);
  microslip_model_destroy(nullptr);
  microslip_structure_destroy(nullptr);
  microslip_curve_destroy(nullptr);
  microslip_marched_destroy(nullptr);
}

}  // namespace
}  // namespace microslip::test::bad_input
