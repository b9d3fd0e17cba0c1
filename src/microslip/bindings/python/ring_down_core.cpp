// SPDX-License-Identifier: MIT
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/recordings.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/signal/decay/ring_down.hpp"
#include "microslip/signal/decay/ring_down_levels.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

RingDownOptions ring_down_options_of(const py::dict& given) {
  RingDownOptions all;
  all.frequency = given["frequency"].cast<std::optional<double>>();
  all.band = given["band"].cast<std::optional<std::pair<double, double>>>();
  all.from = given["from"].cast<std::optional<double>>();
  all.to = given["to"].cast<std::optional<double>>();
  all.least_periods = given["least_periods"].cast<double>();
  all.least_fall = given["least_fall"].cast<double>();
  all.largest_fall = given["largest_fall"].cast<double>();
  all.wanted_std = given["wanted_std"].cast<double>();
  all.largest_std = given["largest_std"].cast<double>();
  return all;
}

const char* name_of(DecayStart start) {
  switch (start) {
    case DecayStart::kGiven:
      return "given";
    case DecayStart::kRecord:
      return "record";
    case DecayStart::kBlow:
      return "blow";
    case DecayStart::kFall:
      return "fall";
  }
  return "";
}

py::list sensors_of(const RingDown& decay) {
  py::list all;
  for (const RingDownSensor& sensor : decay.sensors) {
    all.append(py::make_tuple(sensor.name, sensor.ratio, sensor.ratio_std, sensor.ratio_range));
  }
  return all;
}

py::dict dict_of(const RingDown& decay) {
  return py::dict(
      "time"_a = array_of(decay.time), "amplitude"_a = array_of(decay.amplitude),
      "amplitude_std"_a = array_of(decay.amplitude_std), "frequency"_a = array_of(decay.frequency),
      "frequency_std"_a = array_of(decay.frequency_std),
      "damping_ratio"_a = array_of(decay.damping_ratio),
      "damping_ratio_std"_a = array_of(decay.damping_ratio_std), "loss"_a = array_of(decay.loss),
      "loss_std"_a = array_of(decay.loss_std), "window"_a = array_of(decay.window),
      "flags"_a = decay.flags, "from"_a = decay.from, "to"_a = decay.to, "start"_a = decay.start,
      "start_by"_a = name_of(decay.start_by), "blow"_a = decay.blow, "band"_a = decay.band,
      "sensors"_a = sensors_of(decay), "noise_std"_a = decay.noise_std,
      "warnings"_a = list_of(decay.warnings), "summary"_a = python::dict_of(decay.summary));
}

/// Rebuilds the part of a decay that levels need; its warnings were issued already.
RingDown decay_of(const py::dict& given) {
  const auto column = [&](const char* name) { return copy_of(given[name].cast<RealArray>()); };
  RingDown decay;
  decay.time = column("time");
  decay.amplitude = column("amplitude");
  decay.amplitude_std = column("amplitude_std");
  decay.frequency = column("frequency");
  decay.frequency_std = column("frequency_std");
  decay.damping_ratio = column("damping_ratio");
  decay.damping_ratio_std = column("damping_ratio_std");
  decay.loss = column("loss");
  decay.loss_std = column("loss_std");
  decay.window = column("window");
  decay.flags = given["flags"].cast<std::vector<std::string>>();
  return decay;
}

py::dict dict_of(const RingDownLevels& levels) {
  return py::dict("amplitude"_a = array_of(levels.amplitude),
                  "amplitude_std"_a = array_of(levels.amplitude_std),
                  "dissipation"_a = array_of(levels.dissipation),
                  "dissipation_std"_a = array_of(levels.dissipation_std),
                  "secant_stiffness"_a = array_of(levels.secant_stiffness),
                  "secant_stiffness_std"_a = array_of(levels.secant_stiffness_std),
                  "time"_a = array_of(levels.time), "frequency"_a = array_of(levels.frequency),
                  "frequency_std"_a = array_of(levels.frequency_std),
                  "damping_ratio"_a = array_of(levels.damping_ratio),
                  "damping_ratio_std"_a = array_of(levels.damping_ratio_std),
                  "flags"_a = levels.flags, "warnings"_a = list_of(levels.warnings));
}

py::dict follow(const py::dict& recording, const std::vector<std::string>& channels,
                const py::dict& options) {
  const Recording of = recording_of(recording);
  const RingDownOptions how = ring_down_options_of(options);
  return dict_of(
      long_result([&](const Progress&) { return ring_down(of, channels, how); }, py::none()));
}

py::dict levels(const py::dict& decay, double modal_mass, double joint_ratio, double loss_factor,
                const std::optional<double>& stick_frequency,
                const std::optional<double>& joint_stiffness) {
  return dict_of(levels_of(decay_of(decay), {.modal_mass = modal_mass,
                                             .joint_ratio = joint_ratio,
                                             .loss_factor = loss_factor,
                                             .stick_frequency = stick_frequency,
                                             .joint_stiffness = joint_stiffness}));
}

py::dict damping_levels(const py::dict& decay, double joint_ratio) {
  return dict_of(damping_levels_of(decay_of(decay), joint_ratio));
}

}  // namespace

void add_ring_down(py::module_& core) {
  core.def("ring_down", follow);
  core.def("ring_down_levels", levels);
  core.def("ring_down_damping_levels", damping_levels);
}

}  // namespace microslip::python
