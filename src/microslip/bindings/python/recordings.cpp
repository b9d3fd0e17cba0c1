// SPDX-License-Identifier: MIT
#include "microslip/bindings/python/recordings.hpp"

#include <complex>
#include <optional>
#include <string>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/bindings/python/arguments.hpp"

namespace py = pybind11;

namespace microslip::python {

Unit known_unit(const std::string& text) {
  if (const std::optional<Unit> unit = find_unit(text)) return *unit;
  throw InputError("unit", "'" + text + "'", "must be a known unit",
                   "For instance N, m/s^2, g, um, or 1 for a number.");
}

namespace {

using namespace py::literals;

Axis axis_of(const py::tuple& axis) {
  return {.dimension = known_unit(axis[0].cast<std::string>()).dimension,
          .start = axis[1].cast<double>(),
          .step = axis[2].cast<double>(),
          .values = copy_of(axis[3].cast<py::object>())};
}

Channel channel_of(const py::tuple& given) {
  const auto unit = given[1].cast<std::optional<std::string>>();
  Channel channel{.name = given[0].cast<std::string>(),
                  .dimension = unit ? std::optional(known_unit(*unit).dimension) : std::nullopt,
                  .values = {},
                  .imaginary = {},
                  .attributes = given[3].cast<Attributes>()};
  set_values(given[2].cast<py::object>(), channel.values, channel.imaginary);
  return channel;
}

}  // namespace

void set_values(const py::object& values, std::vector<double>& real,
                std::vector<double>& imaginary) {
  if (!py::isinstance<ComplexArray>(values)) {
    real = copy_of(values.cast<RealArray>());
    return;
  }
  const auto array = values.cast<ComplexArray>();
  for (const std::complex<double> value : python::values(array)) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
}

py::object values_of(std::vector<double> real, const std::vector<double>& imaginary) {
  if (imaginary.empty()) return array_of(std::move(real));
  std::vector<std::complex<double>> all;
  all.reserve(real.size());
  for (std::size_t i = 0; i < real.size(); ++i) all.emplace_back(real[i], imaginary[i]);
  return array_of(std::move(all));
}

Recording recording_of(const py::dict& recording) {
  Recording all{.source = recording["source"].cast<std::string>(),
                .axis = axis_of(recording["axis"].cast<py::tuple>()),
                .channels = {},
                .attributes = recording["attributes"].cast<Attributes>()};
  for (const py::handle channel : recording["channels"]) {
    all.channels.push_back(channel_of(channel.cast<py::tuple>()));
  }
  return all;
}

std::vector<Recording> recordings_of(const py::list& recordings) {
  std::vector<Recording> all;
  for (const py::handle recording : recordings) {
    all.push_back(recording_of(recording.cast<py::dict>()));
  }
  return all;
}

py::dict dict_of(Recording recording) {
  py::list channels;
  for (Channel& channel : recording.channels) {
    const auto unit = channel.dimension ? std::optional(si_unit(*channel.dimension)) : std::nullopt;
    channels.append(py::make_tuple(channel.name, unit,
                                   values_of(std::move(channel.values), channel.imaginary),
                                   channel.attributes));
  }
  Axis& axis = recording.axis;
  py::object values = py::none();
  if (!axis.even()) values = array_of(std::move(axis.values));
  return py::dict("source"_a = recording.source,
                  "axis"_a = py::make_tuple(si_unit(axis.dimension), axis.start, axis.step, values),
                  "channels"_a = channels, "attributes"_a = recording.attributes);
}

py::list list_of(std::vector<Recording> recordings) {
  py::list all;
  for (Recording& recording : recordings) all.append(dict_of(std::move(recording)));
  return all;
}

}  // namespace microslip::python
