// SPDX-License-Identifier: MIT
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "microslip/base/gather.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/march.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/bindings/python/vibration.hpp"
#include "microslip/workflow/predict/backbone_draws.hpp"
#include "microslip/workflow/predict/march_draws.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/predict/response_draws.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

const std::map<std::string, Correlation> kCorrelations{{"auto", Correlation::kAuto},
                                                       {"together", Correlation::kTogether},
                                                       {"independent", Correlation::kIndependent}};

DrawOptions draw_options_of(const py::dict& given) {
  return {.count = given["samples"].cast<std::size_t>(),
          .confidence = given["confidence"].cast<double>(),
          .seed = given["seed"].cast<std::uint64_t>(),
          .correlation = kCorrelations.at(given["correlation"].cast<std::string>())};
}

StructureSpread spread_of(const py::dict& given) {
  const auto std_of = [&](const char* name) { return copy_of(given[name].cast<py::object>()); };
  return {.frequency = std_of("frequency_std"),
          .loss_factor = std_of("loss_factor_std"),
          .normal_load = std_of("normal_load_std"),
          .force_gain = std_of("force_gain_std"),
          .response_gain = given["response_gain_std"].cast<double>()};
}

/// Joins draws and spread of a structure.
struct Draws {
  DrawOptions options;
  StructureDraws structures;
};

/// Whether the structure itself gives the linear damping of each joint; then draws do not change
/// it.
std::vector<bool> damping_given(const ModelFile& model) {
  std::vector<bool> given;
  for (const StructuralJoint& joint : model.structure.joints()) {
    const std::size_t j = given.size();
    const bool known = j < model.identified_damping.size();
    const double found = known ? model.identified_damping[j].value_or(0.0) : 0.0;
    given.push_back(joint.linear_damping != found);
  }
  return given;
}

/// The given draws and spread; those of the model.toml where neither was given.
Draws draws_of_structure(const ModelFile& model, const py::dict& given) {
  const DrawOptions options = draw_options_of(given);
  const StructureSpread spread = given["has_spread"].cast<bool>() ? spread_of(given) : model.spread;
  if (given["joints"].is_none()) {
    ModelFile of = model;
    of.spread = spread;
    return {options, draws_of(of, "structure", options)};
  }
  auto joints = given["joints"].cast<std::vector<std::optional<JointSamples>>>();
  return {options, draws_of(model.structure, spread, std::move(joints), damping_given(model),
                            options, "structure")};
}

py::tuple tuple_of(const Band& band) {
  return py::make_tuple(array_of(band.lower), array_of(band.upper));
}

py::list list_of_failures(const DrawsTaken& taken) {
  py::list all;
  for (const DrawsTaken::Failure& failure : taken.failures) {
    all.append(py::make_tuple(failure.reason, failure.count));
  }
  return all;
}

// ---- Curves. ----

py::list list_of_peaks(const ResponseSpread& spread) {
  py::list all;
  for (const PeakSpread& peak : spread.peaks) {
    all.append(py::make_tuple(peak.frequency, peak.frequency_lower, peak.frequency_upper,
                              peak.height, peak.height_lower, peak.height_upper, peak.draws));
  }
  return all;
}

py::object dict_of(const ResponseSpread& spread) {
  return py::dict("height"_a = tuple_of(spread.band), "peaks"_a = list_of_peaks(spread),
                  "failures"_a = list_of_failures(spread.taken),
                  "too_many_failed"_a = spread.taken.too_many_failed(),
                  "warnings"_a = list_of(spread.warnings));
}

py::object dict_of(const BackboneSpread& spread) {
  return py::dict("force"_a = tuple_of(spread.force), "frequency"_a = tuple_of(spread.frequency),
                  "damping_ratio"_a = tuple_of(spread.damping_ratio),
                  "failures"_a = list_of_failures(spread.taken),
                  "too_many_failed"_a = spread.taken.too_many_failed(),
                  "warnings"_a = list_of(spread.warnings));
}

/// The curve that `follow` finds, and the band that `spread_of` finds over it where it ends well.
template <class Follow, class SpreadOf>
py::dict drawn_curve(const Follow& follow, const SpreadOf& spread_of, const py::object& listener) {
  using Spread = std::invoke_result_t<SpreadOf, const ResponseCurve&, const Progress&>;
  const auto drawn = long_result(
      [&](const Progress& progress) {
        std::pair<ResponseCurve, std::optional<Spread>> all{follow(progress), {}};
        if (all.first.summary.converged()) all.second = spread_of(all.first, progress);
        return all;
      },
      listener);
  py::dict all = curve_dict(drawn.first);
  all["spread"] = drawn.second ? dict_of(*drawn.second) : py::object(py::none());
  return all;
}

py::dict draw_frequency(const JudgedBalance& of, const std::string& kept, double value, double from,
                        double to, const py::dict& given, const py::object& listener) {
  const ResponseRange range{
      {kept == "force" ? Quantity::kForceAmplitude : Quantity::kResponse, value}, from, to};
  const Draws draws = draws_of_structure(*of.model, given);
  return drawn_curve(
      [&](const Progress& progress) { return of.follow_frequency(range.kept, from, to, progress); },
      [&](const ResponseCurve& curve, const Progress& progress) {
        return response_spread(of.balance, curve, range, draws.structures, draws.options,
                               Execution::threads(), progress);
      },
      listener);
}

py::dict draw_backbone(const JudgedBalance& of, const RealArray& responses, std::size_t mode,
                       const py::dict& given, const py::object& listener) {
  const std::vector<double> at = copy_of(responses);
  const Draws draws = draws_of_structure(*of.model, given);
  return drawn_curve(
      [&](const Progress& progress) { return of.follow_backbone(at, mode, true, progress); },
      [&](const ResponseCurve& curve, const Progress& progress) {
        return backbone_spread(of.balance, curve, at, mode, draws.structures, draws.options,
                               Execution::threads(), progress);
      },
      listener);
}

// ---- In time. ----

py::tuple tuple_of(const StatisticSpread& of) {
  return py::make_tuple(of.value, of.lower, of.upper);
}

/// Every signals.size()-th of numbers stored by rows.
RealArray column(const std::vector<double>& rows, std::size_t signal, std::size_t signals) {
  std::vector<double> numbers;
  for (std::size_t i = signal; i < rows.size(); i += signals) numbers.push_back(rows[i]);
  return array_of(std::move(numbers));
}

py::list signals_of(const DrawnMarch& drawn) {
  const std::size_t count = drawn.signals.size();
  py::list all;
  for (std::size_t s = 0; s < count; ++s) {
    const MarchedSignal& signal = drawn.signals[s];
    all.append(py::make_tuple(signal.name, si_unit(signal.dimension), column(drawn.rows, s, count),
                              column(drawn.band.lower, s, count),
                              column(drawn.band.upper, s, count), tuple_of(signal.peak),
                              tuple_of(signal.rms)));
  }
  return all;
}

py::dict draw_march(const std::shared_ptr<ModelFile>& structure, const std::string& point,
                    const RealArray& time, const py::list& forces, const py::list& normal_loads,
                    const py::dict& options, const py::dict& given, const py::object& listener) {
  const LoadHistory loads = load_history_of(time, forces, normal_loads);
  MarchOptions of = march_options_of(options);
  of.points = {point};
  const Draws draws = draws_of_structure(*structure, given);
  ModelFile model = *structure;
  model.response = point;
  if (given["has_spread"].cast<bool>()) model.spread = spread_of(given);
  const DrawnMarch drawn = long_result(
      [&](const Progress& progress) {
        return drawn_march(model, loads, of, draws.structures, draws.options, Execution::threads(),
                           progress, progress);
      },
      listener);
  py::dict all = march_dict(drawn.march);
  all["time"] = array_of(gather(loads.time, drawn.times));
  all["signals"] = signals_of(drawn);
  all["failures"] = list_of_failures(drawn.taken);
  return all;
}

}  // namespace

void add_draws(py::module_& core) {
  core.def("draw_frequency", draw_frequency);
  core.def("draw_backbone", draw_backbone);
  core.def("draw_march", draw_march);
}

}  // namespace microslip::python
