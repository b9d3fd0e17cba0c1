// SPDX-License-Identifier: MIT
#include "microslip/dynamics/march/march.hpp"

#include <fmt/format.h>

#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "microslip/bindings/c/errors.hpp"
#include "microslip/bindings/c/handles.hpp"
#include "microslip/workflow/predict/model_text.hpp"

namespace c = microslip::c;

namespace microslip::c {
namespace {

microslip_march_options march_defaults() {
  const MarchOptions of;
  microslip_march_options all{};
  all.step = of.step;
  all.every = of.every;
  all.tolerance = of.tolerance;
  all.max_iterations = of.max_iterations;
  all.largest_imbalance = of.largest_imbalance;
  all.estimate_error = of.estimate_error ? 1 : 0;
  all.largest_error = of.largest_error;
  return all;
}

std::vector<double> start_of(std::size_t modes, const double* from, std::string_view name) {
  if (from == nullptr) return {};
  const auto all = values(modes, from, name);
  return {all.begin(), all.end()};
}

MarchOptions march_options(const microslip_march_options& options,
                           const JointedStructure& structure) {
  MarchOptions all;
  all.step = options.step;
  all.every = options.every;
  all.tolerance = options.tolerance;
  all.max_iterations = options.max_iterations;
  all.largest_imbalance = options.largest_imbalance;
  all.estimate_error = options.estimate_error != 0;
  all.largest_error = options.largest_error;
  if (options.start_modes != 0 || options.start_displacement != nullptr ||
      options.start_velocity != nullptr) {
    require_count(options.start_modes, structure.linear().size(), "options->start_modes",
                  "modes of the structure");
    all.start.displacement =
        start_of(options.start_modes, options.start_displacement, "options->start_displacement");
    all.start.velocity =
        start_of(options.start_modes, options.start_velocity, "options->start_velocity");
  }
  for (const ModalPoint& point : structure.linear().points()) all.points.push_back(point.name);
  return all;
}

/// Checked before any load: the arrays have `load_count` entries.
void check_loads(const JointedStructure& structure, std::size_t load_count,
                 const char* const* places, const double* const* loads) {
  if (load_count > 0) require_pointer(loads, "loads");
  if (load_count > 1) require_pointer(places, "places");
  const std::size_t most = structure.linear().points().size() + structure.linear().bases().size();
  if (load_count <= most) return;
  throw InputError("load_count", fmt::format("{}", load_count),
                   fmt::format("must be at most the number of points and bases, {}", most));
}

std::string place_of(const JointedStructure& structure, const char* const* places,
                     std::size_t index) {
  if (places == nullptr) return structure.excitations().front().point;
  return &at(places[index], fmt::format("places[{}]", index));
}

LoadHistory history_of(const JointedStructure& structure, std::span<const double> time,
                       std::size_t load_count, const char* const* places,
                       const double* const* loads) {
  LoadHistory history{{time.begin(), time.end()}, {}};
  check_loads(structure, load_count, places, loads);
  for (std::size_t i = 0; i < load_count; ++i) {
    std::string place = place_of(structure, places, i);
    const auto load = values(time.size(), loads[i], fmt::format("loads[{}]", i));
    history.forces.push_back({std::move(place), {load.begin(), load.end()}});
  }
  return history;
}

microslip_marched* marched(const ModelFile& model, const LoadHistory& history,
                           const microslip_march_options& options) {
  MarchResult result = judged_march(model, history, march_options(options, model.structure),
                                    progress_of(options.progress, options.user));
  Ending ending(result.summary, result.warnings, result.summary.full());
  return new microslip_marched{std::move(result), std::move(ending)};
}

const std::vector<double>& motion_of(const PointMotion& point, microslip_response what) {
  switch (what) {
    case MICROSLIP_DISPLACEMENT:
      return point.displacement;
    case MICROSLIP_VELOCITY:
      return point.velocity;
    case MICROSLIP_ACCELERATION:
      return point.acceleration;
  }
  throw_unknown(what, "what");
}

const std::vector<double>& motion_of(const JointMotion& joint, microslip_marched_joint_of what) {
  switch (what) {
    case MICROSLIP_MARCHED_JOINT_DISPLACEMENT:
      return joint.displacement;
    case MICROSLIP_MARCHED_JOINT_FORCE:
      return joint.force;
  }
  throw_unknown(what, "what");
}

double number_of(const MarchResult& result, microslip_marched_number what) {
  switch (what) {
    case MICROSLIP_MARCHED_REACHED:
      return result.reached;
    case MICROSLIP_MARCHED_INITIAL:
      return result.energy.initial;
    case MICROSLIP_MARCHED_INPUT:
      return result.energy.input;
    case MICROSLIP_MARCHED_KINETIC:
      return result.energy.kinetic;
    case MICROSLIP_MARCHED_ELASTIC:
      return result.energy.elastic;
    case MICROSLIP_MARCHED_LINEAR:
      return result.energy.linear_dissipation;
    case MICROSLIP_MARCHED_JOINT_STORED:
      return result.energy.joint_stored();
    case MICROSLIP_MARCHED_JOINT_DISSIPATION:
      return result.energy.joint_dissipation();
    case MICROSLIP_MARCHED_JOINT_LINEAR:
      return result.energy.joint_linear_dissipation();
    case MICROSLIP_MARCHED_IMBALANCE:
      return result.energy.imbalance();
    case MICROSLIP_MARCHED_ERROR:
      return result.error_estimate.value_or(std::numeric_limits<double>::quiet_NaN());
  }
  throw_unknown(what, "what");
}

}  // namespace
}  // namespace microslip::c

microslip_status microslip_march_options_defaults(microslip_march_options* options,
                                                  std::size_t struct_size) {
  return c::done([&] { c::write_struct(c::march_defaults(), options, struct_size, "options"); });
}

microslip_status microslip_march(const microslip_structure* structure, std::size_t count,
                                 const double* time, std::size_t load_count,
                                 const char* const* places, const double* const* loads,
                                 const microslip_march_options* options,
                                 microslip_marched** marched) {
  return c::guarded([&] {
    c::require_pointer(structure, "structure");
    c::require_pointer(marched, "marched");
    const microslip::ModelFile& model = *structure->model;
    const microslip::LoadHistory history =
        c::history_of(model.structure, c::values(count, time, "time"), load_count, places, loads);
    *marched = c::marched(model, history, c::read_struct(options, c::march_defaults(), "options"));
    return c::status_of((*marched)->ending.summary);
  });
}

void microslip_marched_destroy(microslip_marched* marched) { delete marched; }

microslip_status microslip_marched_time(const microslip_marched* marched, const double** time,
                                        std::size_t* count) {
  return c::done([&] {
    const auto& all = c::at(marched, "marched").result.time;
    c::at(time, "time") = all.data();
    if (count != nullptr) *count = all.size();
  });
}

microslip_status microslip_marched_point(const microslip_marched* marched, std::size_t point,
                                         microslip_response what, const double** values,
                                         std::size_t* count) {
  return c::done([&] {
    const auto& points = c::at(marched, "marched").result.points;
    c::hand_out(c::motion_of(points[c::index_below(point, points.size(), "point")], what), values,
                count);
  });
}

microslip_status microslip_marched_joint(const microslip_marched* marched, std::size_t joint,
                                         microslip_marched_joint_of what, const double** values,
                                         std::size_t* count) {
  return c::done([&] {
    const auto& joints = c::at(marched, "marched").result.joints;
    c::hand_out(c::motion_of(joints[c::index_below(joint, joints.size(), "joint")], what), values,
                count);
  });
}

microslip_status microslip_marched_value(const microslip_marched* marched,
                                         microslip_marched_number what, double* value) {
  return c::done(
      [&] { c::at(value, "value") = c::number_of(c::at(marched, "marched").result, what); });
}

microslip_status microslip_marched_outcome(const microslip_marched* marched,
                                           microslip_outcome* outcome) {
  return c::done([&] { c::write_outcome(c::at(marched, "marched").ending, outcome); });
}

microslip_status microslip_marched_warning(const microslip_marched* marched, std::size_t index,
                                           const char** code, const char** text) {
  return c::done([&] { c::write_warning(c::at(marched, "marched").ending, index, code, text); });
}
