// SPDX-License-Identifier: MIT
#include <algorithm>
#include <complex>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/bindings/python/structure.hpp"
#include "microslip/bindings/python/vibration.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance.hpp"
#include "microslip/workflow/predict/model_text.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

const std::map<std::string, ResponseKind> kKinds{{"displacement", ResponseKind::kDisplacement},
                                                 {"velocity", ResponseKind::kVelocity},
                                                 {"acceleration", ResponseKind::kAcceleration}};
const std::map<std::string, Quantity> kQuantities{
    {"angular_frequency", Quantity::kAngularFrequency},
    {"force", Quantity::kForceAmplitude},
    {"response", Quantity::kResponse},
    {"phase_lag", Quantity::kPhaseLag}};

constexpr double kTurn = 2.0 * std::numbers::pi;

HarmonicBalanceOptions balance_options_of(const py::dict& given) {
  return {.harmonics = given["harmonics"].cast<std::size_t>(),
          .samples = given["samples"].cast<std::size_t>(),
          .tolerance = given["tolerance"].cast<double>(),
          .max_iterations = given["max_iterations"].cast<int>(),
          .largest_change = given["largest_change"].cast<double>(),
          .least_points = given["least_points"].cast<int>(),
          .max_points = given["max_points"].cast<int>(),
          .accuracy = given["accuracy"].cast<double>(),
          .frequencies = copy_of(given["angular_frequencies"].cast<py::object>()),
          .forcing = given["modal_forcing"].cast<bool>() ? Forcing::kModal : Forcing::kExcitation};
}

py::dict dict_of(const HarmonicBalanceOptions& of) {
  return py::dict("harmonics"_a = of.harmonics, "samples"_a = of.samples,
                  "tolerance"_a = of.tolerance, "max_iterations"_a = of.max_iterations,
                  "largest_change"_a = of.largest_change, "least_points"_a = of.least_points,
                  "max_points"_a = of.max_points, "accuracy"_a = of.accuracy,
                  "angular_frequencies"_a = array_of(of.frequencies),
                  "modal_forcing"_a = of.forcing == Forcing::kModal);
}

std::shared_ptr<JudgedBalance> balance_of(const std::shared_ptr<ModelFile>& model,
                                          const std::string& point, const std::string& kind,
                                          const py::dict& options) {
  return std::make_shared<JudgedBalance>(
      model,
      HarmonicBalance(model->structure, {point, kKinds.at(kind)}, balance_options_of(options)));
}

/// One number of each vibration.
template <class Member>
RealArray column(const std::vector<SteadyVibration>& points, const Member& member) {
  std::vector<double> numbers;
  numbers.reserve(points.size());
  for (const SteadyVibration& point : points) {
    numbers.push_back(static_cast<double>(std::invoke(member, point)));
  }
  return array_of(std::move(numbers));
}

/// Rows of complex numbers, one per vibration, each of `length`.
template <class Row>
ComplexArray complex_rows(const std::vector<SteadyVibration>& points, py::ssize_t length,
                          const Row& row) {
  ComplexArray all({static_cast<py::ssize_t>(points.size()), length});
  std::complex<double>* to = all.mutable_data();
  for (const SteadyVibration& point : points) to = std::ranges::copy(row(point), to).out;
  return all;
}

py::dict joint_columns(const std::vector<SteadyVibration>& points, std::size_t j) {
  const JointCycle& first = points.front().joints[j];
  const auto of = [j](auto member) {
    return
        [j, member](const SteadyVibration& point) { return std::invoke(member, point.joints[j]); };
  };
  const auto rows = [&](auto member) {
    return complex_rows(
        points, static_cast<py::ssize_t>(first.displacement.size()),
        [&](const SteadyVibration& point) -> const std::vector<std::complex<double>>& {
          return point.joints[j].*member;
        });
  };
  return py::dict("name"_a = first.name, "amplitude"_a = column(points, of(&JointCycle::amplitude)),
                  "dissipation"_a = column(points, of(&JointCycle::dissipation)),
                  "linear_dissipation"_a = column(points, of(&JointCycle::linear_dissipation)),
                  "reversals"_a = column(points, of(&JointCycle::reversals)),
                  "displacement"_a = rows(&JointCycle::displacement),
                  "force"_a = rows(&JointCycle::force));
}

/// q of each vibration, as an array of vibration, mode and harmonic.
ComplexArray modal_array(const std::vector<SteadyVibration>& points) {
  const auto modes = static_cast<py::ssize_t>(points.empty() ? 0 : points.front().modal.size());
  const auto harmonics =
      static_cast<py::ssize_t>(modes == 0 ? 0 : points.front().modal.front().size());
  ComplexArray all({static_cast<py::ssize_t>(points.size()), modes, harmonics});
  std::complex<double>* to = all.mutable_data();
  for (const SteadyVibration& point : points) {
    for (const auto& mode : point.modal) to = std::ranges::copy(mode, to).out;
  }
  return all;
}

py::dict columns_of(const std::vector<SteadyVibration>& points) {
  py::list joints;
  for (std::size_t j = 0; !points.empty() && j < points.front().joints.size(); ++j) {
    joints.append(joint_columns(points, j));
  }
  return py::dict("frequency"_a = column(points, &SteadyVibration::frequency),
                  "force"_a = column(points, &SteadyVibration::force_amplitude),
                  "response"_a = column(points, &SteadyVibration::response),
                  "phase_lag"_a = column(points, &SteadyVibration::phase_lag),
                  "damping_ratio"_a = column(points, &SteadyVibration::damping_ratio),
                  "input_energy"_a = column(points, &SteadyVibration::input_energy),
                  "linear_dissipation"_a = column(points, &SteadyVibration::linear_dissipation),
                  "energy_imbalance"_a = column(points, &SteadyVibration::energy_imbalance),
                  "modal"_a = modal_array(points), "joints"_a = joints);
}

py::list list_of(const std::vector<std::size_t>& numbers) {
  py::list all;
  for (const std::size_t number : numbers) all.append(number);
  return all;
}

py::dict dict_of(const ResponseCurve& curve) {
  return py::dict("points"_a = columns_of(curve.points), "peaks"_a = columns_of(curve.peaks),
                  "peak_points"_a = list_of(curve.peak_points),
                  "turning_points"_a = list_of(curve.turning_points),
                  "warnings"_a = python::list_of(curve.warnings),
                  "summary"_a = python::dict_of(curve.summary));
}

py::dict follow_frequency(const JudgedBalance& of, const std::string& kept, double value,
                          double from, double to, const py::object& listener) {
  const Target target{kQuantities.at(kept), value};
  return dict_of(long_result(
      [&](const Progress& progress) { return of.follow_frequency(target, from, to, progress); },
      listener));
}

py::dict follow_backbone(const JudgedBalance& of, const RealArray& responses, std::size_t mode,
                         bool through_folds, const py::object& listener) {
  return dict_of(long_result(
      [&](const Progress& progress) {
        return of.follow_backbone(values(responses), mode, through_folds, progress);
      },
      listener));
}

/// A vibration as a curve of one point, so that the same checks apply.
ResponseCurve judged_point(const JudgedBalance& of, const VibrationResult& result,
                           const Target& kept) {
  ResponseCurve curve;
  curve.points = {result.vibration};
  curve.summary = result.summary;
  if (!result.summary.converged()) return curve;
  (void)add_truncation(of.balance, *of.model, kept.quantity, curve);
  add_model_warnings(*of.model, curve);
  return curve;
}

py::dict solve(const JudgedBalance& of, const std::pair<std::string, double>& first,
               const std::pair<std::string, double>& second, std::size_t mode) {
  const auto target = [](const std::pair<std::string, double>& given) {
    return Target{kQuantities.at(given.first), given.second};
  };
  const Target one = target(first);
  const Target other = target(second);
  VibrationResult result;
  ResponseCurve judged = long_result(
      [&](const Progress&) {
        result = of.balance.solve(one, other, mode);
        return judged_point(of, result, one.quantity == Quantity::kAngularFrequency ? other : one);
      },
      py::none());
  return py::dict("points"_a = columns_of(judged.points),
                  "warnings"_a = python::list_of(judged.warnings),
                  "summary"_a = python::dict_of(result.summary));
}

}  // namespace

ResponseCurve JudgedBalance::follow_frequency(const Target& kept, double from, double to,
                                              const Progress& progress) const {
  for (const double frequency : balance.options().frequencies) {
    if (std::min(from, to) <= frequency && frequency <= std::max(from, to)) continue;
    throw InputError("frequencies", frequency / kTurn, "must be within the range of the curve");
  }
  ResponseCurve curve = balance.follow(kept, Quantity::kAngularFrequency, from, to, 0, progress);
  judge_response(balance, *model, kept.quantity, curve);
  return curve;
}

ResponseCurve JudgedBalance::follow_backbone(std::span<const double> responses, std::size_t mode,
                                             bool through_folds, const Progress& progress) const {
  if (!balance.options().frequencies.empty()) {
    throw InputError("frequencies", balance.options().frequencies.front() / kTurn,
                     "belongs to curves over the frequency, and this is a backbone",
                     "Leave it out.");
  }
  ResponseCurve curve = through_folds ? balance.resonances(responses, mode, progress)
                                      : balance.backbone(responses, mode, progress);
  judge_backbone(balance, *model, curve);
  return curve;
}

py::dict curve_dict(const ResponseCurve& curve) { return dict_of(curve); }

void add_vibration(py::module_& core) {
  py::class_<JudgedBalance, std::shared_ptr<JudgedBalance>>(core, "HarmonicBalance")
      .def(py::init(&balance_of))
      .def_property_readonly("point",
                             [](const JudgedBalance& of) { return of.balance.response().point; })
      .def("options", [](const JudgedBalance& of) { return dict_of(of.balance.options()); })
      .def("follow_frequency", follow_frequency)
      .def("follow_backbone", follow_backbone)
      .def("solve", solve);
}

}  // namespace microslip::python
