// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/bindings/c/errors.hpp"
#include "microslip/bindings/c/handles.hpp"

namespace c = microslip::c;

namespace microslip::c {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr std::size_t kMostHarmonics = 1000;  // of a harmonic balance

std::string name_of(const char* name, std::string_view argument) {
  std::string text = &at(name, argument);
  if (text.empty()) throw InputError(argument, InputState{"empty"}, "must not be empty");
  return text;
}

DampingLaw law_of(microslip_damping damping) {
  switch (damping) {
    case MICROSLIP_VISCOUS:
      return DampingLaw::kViscous;
    case MICROSLIP_HYSTERETIC:
      return DampingLaw::kHysteretic;
  }
  throw_unknown(damping, "damping");
}

std::vector<double> shape_of(const microslip_model& model, std::size_t modes, const double* shape) {
  require_count(modes, model.modes.size(), "modes", "modes of the model");
  const auto all = values(modes, shape, "shape");
  return {all.begin(), all.end()};
}

microslip_joint_options joint_defaults() {
  microslip_joint_options all{};
  all.linear_damping = std::numeric_limits<double>::quiet_NaN();
  return all;
}

void add_joint(microslip_model& model, std::string name, const JointFile& file,
               std::vector<double> shape, const microslip_joint_options& options) {
  const std::optional<double> identified = identified_damping(file);
  const bool given = !std::isnan(options.linear_damping);
  const double damping = given ? not_negative(options.linear_damping, "options->linear_damping")
                               : identified.value_or(0.0);
  StructuralJoint joint{std::move(name), file.joint, std::move(shape)};
  joint.spring_in_modes = not_negative(options.spring_in_modes, "options->spring_in_modes");
  joint.series_compliance = not_negative(options.series_compliance, "options->series_compliance");
  joint.linear_damping = damping;
  JointSource source{joint.name, file.joint, covered_to(file), identified};
  source.linear_damping = damping;
  source.damping_said = given;
  model.joints.push_back(std::move(joint));
  model.sources.push_back(std::move(source));
}

Excitation excitation_of(std::string point, std::size_t harmonics, const double* real,
                         const double* imaginary) {
  Excitation excitation{std::move(point)};
  if (harmonics == 0 || harmonics > kMostHarmonics) {
    throw InputError("harmonics", fmt::format("{}", harmonics),
                     fmt::format("must be from 1 to {}", kMostHarmonics));
  }
  if (real == nullptr && harmonics > 1) require_pointer(real, "real");
  excitation.harmonics.assign(harmonics, 0.0);
  const auto re = real == nullptr ? std::span<const double>{} : values(harmonics, real, "real");
  const auto im =
      imaginary == nullptr ? std::span<const double>{} : values(harmonics, imaginary, "imaginary");
  for (std::size_t n = 0; n < harmonics; ++n) {
    excitation.harmonics[n] = {re.empty() ? 1.0 : re[n], im.empty() ? 0.0 : im[n]};
  }
  return excitation;
}

microslip_structure* new_structure(ModelFile model) {
  auto made = std::make_unique<microslip_structure>();
  made->stuck_frequencies = model.structure.stuck_frequencies();
  for (double& frequency : made->stuck_frequencies) frequency /= kTwoPi;
  made->model = std::make_shared<const ModelFile>(std::move(model));
  return made.release();
}

/// Default point of the response: where the structure is driven.
ModelFile model_file(const microslip_model& model) {
  if (model.excitations.empty()) {
    throw InputError("model", InputState{"without an excitation"}, "must have at least one",
                     "Add one by microslip_model_add_excitation().");
  }
  DrivenPoints driven;
  driven.excitations = model.excitations;
  driven.static_loads = model.static_loads;
  driven.response = model.excitations.front().point;
  return make_model(ModalModel(model.modes, model.points), model.law, model.joints, model.sources,
                    std::move(driven));
}

}  // namespace
}  // namespace microslip::c

microslip_status microslip_model_create(std::size_t modes, const double* frequency,
                                        const double* loss_factor, microslip_damping damping,
                                        microslip_model** model) {
  return c::done([&] {
    c::require_pointer(model, "model");
    if (modes == 0) throw microslip::InputError("modes", 0.0, "must be 1 or more");
    const auto f = c::values(modes, frequency, "frequency");
    const auto eta = c::values(modes, loss_factor, "loss_factor");
    auto made = std::make_unique<microslip_model>();
    made->law = c::law_of(damping);
    for (std::size_t i = 0; i < modes; ++i) {
      made->modes.push_back({c::kTwoPi * c::not_negative(f[i], fmt::format("frequency[{}]", i)),
                             c::not_negative(eta[i], fmt::format("loss_factor[{}]", i))});
    }
    *model = made.release();
  });
}

void microslip_model_destroy(microslip_model* model) { delete model; }

microslip_status microslip_model_add_point(microslip_model* model, const char* name,
                                           std::size_t modes, const double* shape) {
  return c::done([&] {
    c::require_pointer(model, "model");
    microslip::ModalPoint point{c::name_of(name, "name"), c::shape_of(*model, modes, shape)};
    model->points.push_back(std::move(point));
  });
}

microslip_status microslip_joint_options_defaults(microslip_joint_options* options,
                                                  std::size_t struct_size) {
  return c::done([&] { c::write_struct(c::joint_defaults(), options, struct_size, "options"); });
}

microslip_status microslip_model_add_joint(microslip_model* model, const char* name,
                                           const microslip_joint* joint, std::size_t modes,
                                           const double* shape,
                                           const microslip_joint_options* options) {
  return c::done([&] {
    c::require_pointer(model, "model");
    const microslip::JointFile& file = *c::at(joint, "joint").file;
    c::add_joint(*model, c::name_of(name, "name"), file, c::shape_of(*model, modes, shape),
                 c::read_struct(options, c::joint_defaults(), "options"));
  });
}

microslip_status microslip_model_add_excitation(microslip_model* model, const char* point,
                                                std::size_t harmonics, const double* real,
                                                const double* imaginary) {
  return c::done([&] {
    c::require_pointer(model, "model");
    model->excitations.push_back(
        c::excitation_of(c::name_of(point, "point"), harmonics, real, imaginary));
  });
}

microslip_status microslip_model_add_static_load(microslip_model* model, const char* point,
                                                 double force) {
  return c::done([&] {
    c::require_pointer(model, "model");
    model->static_loads.push_back({c::name_of(point, "point"), c::finite(force, "force")});
  });
}

microslip_status microslip_structure_create(const microslip_model* model,
                                            microslip_structure** structure) {
  return c::done([&] {
    c::require_pointer(structure, "structure");
    *structure = c::new_structure(c::model_file(c::at(model, "model")));
  });
}

microslip_status microslip_structure_read(const char* path, microslip_structure** structure) {
  return c::done([&] {
    c::require_pointer(structure, "structure");
    *structure = c::new_structure(microslip::read_model(&c::at(path, "path")));
  });
}

void microslip_structure_destroy(microslip_structure* structure) { delete structure; }

microslip_status microslip_structure_stuck_frequencies(const microslip_structure* structure,
                                                       const double** frequency,
                                                       std::size_t* count) {
  return c::done([&] {
    const auto& all = c::at(structure, "structure").stuck_frequencies;
    c::at(frequency, "frequency") = all.data();
    c::at(count, "count") = all.size();
  });
}

microslip_status microslip_structure_counts(const microslip_structure* structure,
                                            std::size_t* points, std::size_t* joints) {
  return c::done([&] {
    const auto& of = c::at(structure, "structure").model->structure;
    if (points != nullptr) *points = of.linear().points().size();
    if (joints != nullptr) *joints = of.joints().size();
  });
}

microslip_status microslip_structure_point(const microslip_structure* structure, std::size_t index,
                                           const char** name) {
  return c::done([&] {
    const auto points = c::at(structure, "structure").model->structure.linear().points();
    c::at(name, "name") = points[c::index_below(index, points.size(), "index")].name.c_str();
  });
}

microslip_status microslip_structure_joint(const microslip_structure* structure, std::size_t index,
                                           const char** name) {
  return c::done([&] {
    const auto joints = c::at(structure, "structure").model->structure.joints();
    c::at(name, "name") = joints[c::index_below(index, joints.size(), "index")].name.c_str();
  });
}
