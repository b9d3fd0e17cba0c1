// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "microslip/bindings/c/errors.hpp"
#include "microslip/bindings/c/handles.hpp"
#include "microslip/workflow/predict/model_text.hpp"

namespace c = microslip::c;

namespace microslip::c {
namespace {

constexpr double kRadians = 2.0 * std::numbers::pi;  // per cycle

/// Calls copy(member of C, member of C++) for each option that both have alike.
template <typename Copy>
void for_each_same(const Copy& copy) {
  using Given = microslip_frf_options;
  using Own = HarmonicBalanceOptions;
  copy(&Given::harmonics, &Own::harmonics);
  copy(&Given::samples, &Own::samples);
  copy(&Given::tolerance, &Own::tolerance);
  copy(&Given::max_iterations, &Own::max_iterations);
  copy(&Given::largest_change, &Own::largest_change);
  copy(&Given::least_points, &Own::least_points);
  copy(&Given::max_points, &Own::max_points);
  copy(&Given::accuracy, &Own::accuracy);
}

microslip_frf_options frf_defaults() {
  const HarmonicBalanceOptions of;
  microslip_frf_options all{};
  for_each_same([&](auto given, auto own) { all.*given = of.*own; });
  all.judge = 1;
  return all;
}

HarmonicBalanceOptions balance_options(const microslip_frf_options& options) {
  HarmonicBalanceOptions all;
  for_each_same([&](auto given, auto own) { all.*own = options.*given; });
  if (options.modal_forcing != 0) all.forcing = Forcing::kModal;
  for (const double frequency : values(options.at_count, options.at, "options->at")) {
    all.frequencies.push_back(kRadians * frequency);
  }
  return all;
}

ResponseKind kind_of(microslip_response response, std::string_view name) {
  switch (response) {
    case MICROSLIP_DISPLACEMENT:
      return ResponseKind::kDisplacement;
    case MICROSLIP_VELOCITY:
      return ResponseKind::kVelocity;
    case MICROSLIP_ACCELERATION:
      return ResponseKind::kAcceleration;
  }
  throw_unknown(response, name);
}

Quantity quantity_of(microslip_kept kept) {
  switch (kept) {
    case MICROSLIP_KEEP_FORCE:
      return Quantity::kForceAmplitude;
    case MICROSLIP_KEEP_RESPONSE:
      return Quantity::kResponse;
  }
  throw_unknown(kept, "kept");
}

/// @throws InputError  naming the first frequency that no curve over the range can have.
void check_frequencies(const microslip_frf_options& options, double from, double to) {
  const auto [low, high] = std::minmax(from, to);
  const auto at = values(options.at_count, options.at, "options->at");
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] >= low && at[i] <= high) continue;
    throw InputError(fmt::format("options->at[{}]", i), at[i],
                     fmt::format("must lie within the range, {:g} to {:g} Hz", low, high),
                     "Widen the range, or leave this frequency out.");
  }
}

HarmonicBalance balance_of(const ModelFile& model, const char* point,
                           const microslip_frf_options& options) {
  const ResponsePoint response{point == nullptr ? model.response : std::string(point),
                               kind_of(options.response, "options->response")};
  return HarmonicBalance(model.structure, response, balance_options(options));
}

void fill_row(const SteadyVibration& at, const ModelFile& model, const std::string& point,
              microslip_curve& curve) {
  const std::complex<double> w = at.displacement(model.structure.linear(), point)[1];
  double dissipation = 0.0;
  for (std::size_t j = 0; j < at.joints.size(); ++j) {
    dissipation += at.joints[j].dissipation;
    curve.joints[MICROSLIP_CURVE_JOINT_AMPLITUDE][j].push_back(at.joints[j].amplitude);
    curve.joints[MICROSLIP_CURVE_JOINT_DISSIPATION][j].push_back(at.joints[j].dissipation);
  }
  const auto put = [&](microslip_curve_values_of what, double value) {
    curve.columns[static_cast<std::size_t>(what)].push_back(value);
  };
  put(MICROSLIP_CURVE_FREQUENCY, at.frequency());
  put(MICROSLIP_CURVE_FORCE, at.force_amplitude);
  put(MICROSLIP_CURVE_DISPLACEMENT, std::abs(w));
  put(MICROSLIP_CURVE_REAL, w.real());
  put(MICROSLIP_CURVE_IMAGINARY, w.imag());
  put(MICROSLIP_CURVE_PHASE, at.phase_lag);
  put(MICROSLIP_CURVE_DAMPING_RATIO, at.damping_ratio());
  put(MICROSLIP_CURVE_DISSIPATION, dissipation);
  put(MICROSLIP_CURVE_LINEAR_DISSIPATION, at.linear_dissipation);
  put(MICROSLIP_CURVE_IMBALANCE, at.energy_imbalance);
}

microslip_curve* new_curve(const microslip_structure& structure, const HarmonicBalance& balance,
                           ResponseCurve found, std::string lines) {
  Ending ending(found.summary, found.warnings, found.summary.full() + lines);
  auto made = std::make_unique<microslip_curve>(
      microslip_curve{structure.model, std::move(found), std::move(ending)});
  for (auto& of_joints : made->joints) of_joints.resize(structure.model->structure.joints().size());
  for (const SteadyVibration& at : made->curve.points) {
    fill_row(at, *structure.model, balance.response().point, *made);
  }
  return made.release();
}

microslip_curve* over_frequency(const microslip_structure& structure, const char* point,
                                const Target& kept, double from, double to,
                                const microslip_frf_options& options) {
  check_frequencies(options, from, to);
  const HarmonicBalance balance = balance_of(*structure.model, point, options);
  ResponseCurve curve =
      balance.follow(kept, Quantity::kAngularFrequency, kRadians * from, kRadians * to, 0,
                     progress_of(options.progress, options.user));
  std::string lines;
  if (options.judge != 0) {
    lines = judge_response(balance, *structure.model, kept.quantity, curve);
  } else {
    add_response_warnings(balance, *structure.model, curve);
  }
  return new_curve(structure, balance, std::move(curve), std::move(lines));
}

microslip_curve* over_response(const microslip_structure& structure, const char* point,
                               std::size_t mode, std::span<const double> response,
                               const microslip_frf_options& options) {
  const HarmonicBalance balance = balance_of(*structure.model, point, options);
  ResponseCurve curve =
      balance.resonances(response, mode, progress_of(options.progress, options.user));
  std::string lines;
  if (options.judge != 0) {
    lines = judge_backbone(balance, *structure.model, curve);
  } else {
    add_model_warnings(*structure.model, curve);
  }
  return new_curve(structure, balance, std::move(curve), std::move(lines));
}

}  // namespace
}  // namespace microslip::c

microslip_status microslip_frf_options_defaults(microslip_frf_options* options,
                                                std::size_t struct_size) {
  return c::done([&] { c::write_struct(c::frf_defaults(), options, struct_size, "options"); });
}

microslip_status microslip_frf(const microslip_structure* structure, const char* point,
                               microslip_kept kept, double value, double from, double to,
                               const microslip_frf_options* options, microslip_curve** curve) {
  return c::guarded([&] {
    c::require_pointer(structure, "structure");
    c::require_pointer(curve, "curve");
    const microslip::Target target{c::quantity_of(kept), c::positive(value, "value")};
    c::positive(from, "from");
    c::positive(to, "to");
    if (from == to) throw microslip::InputError("to", to, "must differ from `from`");
    *curve = c::over_frequency(*structure, point, target, from, to,
                               c::read_struct(options, c::frf_defaults(), "options"));
    return c::status_of((*curve)->ending.summary);
  });
}

microslip_status microslip_backbone(const microslip_structure* structure, const char* point,
                                    std::size_t mode, std::size_t count, const double* response,
                                    const microslip_frf_options* options, microslip_curve** curve) {
  return c::guarded([&] {
    c::require_pointer(structure, "structure");
    c::require_pointer(curve, "curve");
    const auto all = c::values(count, response, "response");
    if (count == 0) throw microslip::InputError("count", 0.0, "must be 1 or more");
    *curve = c::over_response(*structure, point, mode, all,
                              c::read_struct(options, c::frf_defaults(), "options"));
    return c::status_of((*curve)->ending.summary);
  });
}

void microslip_curve_destroy(microslip_curve* curve) { delete curve; }

microslip_status microslip_curve_values(const microslip_curve* curve,
                                        microslip_curve_values_of what, const double** values,
                                        std::size_t* count) {
  return c::done([&] {
    const auto& columns = c::at(curve, "curve").columns;
    const auto column = static_cast<std::size_t>(what);
    if (column >= columns.size()) c::throw_unknown(what, "what");
    c::hand_out(columns[column], values, count);
  });
}

microslip_status microslip_curve_joint(const microslip_curve* curve, std::size_t joint,
                                       microslip_curve_joint_of what, const double** values,
                                       std::size_t* count) {
  return c::done([&] {
    const auto& columns = c::at(curve, "curve").joints;
    const auto column = static_cast<std::size_t>(what);
    if (column >= columns.size()) c::throw_unknown(what, "what");
    const auto& joints = columns[column];
    c::hand_out(joints[c::index_below(joint, joints.size(), "joint")], values, count);
  });
}

microslip_status microslip_curve_harmonic(const microslip_curve* curve, const char* point,
                                          std::size_t harmonic, std::size_t count, double* real,
                                          double* imaginary) {
  return c::done([&] {
    const auto& points = c::at(curve, "curve").curve.points;
    const auto& linear = curve->model->structure.linear();
    const std::string place = &c::at(point, "point");
    c::require_count(count, points.size(), "count", "vibrations");
    const auto re = c::room(count, real, "real");
    const auto im = c::room(count, imaginary, "imaginary");
    for (std::size_t i = 0; i < count; ++i) {
      const auto w = points[i].displacement(linear, place);
      const auto& w_n = w[c::index_below(harmonic, w.size(), "harmonic")];
      re[i] = w_n.real();
      im[i] = w_n.imag();
    }
  });
}

microslip_status microslip_curve_peaks(const microslip_curve* curve, const std::size_t** index,
                                       std::size_t* count) {
  return c::done([&] {
    const auto& peaks = c::at(curve, "curve").curve.peak_points;
    c::at(index, "index") = peaks.data();
    if (count != nullptr) *count = peaks.size();
  });
}

microslip_status microslip_curve_outcome(const microslip_curve* curve, microslip_outcome* outcome) {
  return c::done([&] { c::write_outcome(c::at(curve, "curve").ending, outcome); });
}

microslip_status microslip_curve_warning(const microslip_curve* curve, std::size_t index,
                                         const char** code, const char** text) {
  return c::done([&] { c::write_warning(c::at(curve, "curve").ending, index, code, text); });
}
