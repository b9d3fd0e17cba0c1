// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/recordings.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/io/open/recording_file.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/uff/uff_functions.hpp"
#include "microslip/workflow/reduce/recording_conversion.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

/// Warnings of the reader are kept with the recordings, as in `microslip convert`.
py::tuple tuple_of(Recordings found) {
  add_warning_attributes(found.warnings, found.recordings);
  py::list warnings = list_of(found.warnings);
  return py::make_tuple(list_of(std::move(found.recordings)), warnings);
}

py::tuple read(const std::string& path, const std::vector<std::string>& assumed,
               bool allow_truncated, std::optional<double> rate, const py::object& listener) {
  RecordingReadOptions options{.allow_truncated = allow_truncated,
                               .rate = rate,
                               .assumed_units = parse_assumed_units(assumed)};
  return tuple_of(long_result(
      [&](const Progress& progress) {
        options.progress = progress;
        return read_recordings(path, options);
      },
      listener));
}

void write(const std::string& path, const py::list& recordings,
           const std::optional<std::string>& format, bool replace) {
  const std::vector<Recording> all = recordings_of(recordings);
  const RecordingFormat as =
      format ? find_recording_format(*format).value() : recording_format_of_name(path);
  do_long_work(
      [&](const Progress&) {
        OutputFiles files;
        write_recordings(files, path, all, as, replace ? Replacing::kAny : Replacing::kSame);
        files.commit();
      },
      py::none());
}

py::tuple unit(const std::string& text) {
  const Unit of = known_unit(text);
  return py::make_tuple(of.numerator, of.denominator, si_unit(of.dimension));
}

// ---- Datasets 58, by the names of pyuff. ----

UffPoint point_of(const py::dict& of, const std::string& name) {
  const auto field = [&](const char* end) { return of[(name + end).c_str()]; };
  return {.entity = field("_ent_name").cast<std::string>(),
          .node = field("_node").cast<std::int64_t>(),
          .direction = field("_dir").cast<std::int64_t>()};
}

void add_point(const UffPoint& point, const std::string& name, py::dict& to) {
  const auto set = [&](const char* end, const py::object& value) {
    to[(name + end).c_str()] = value;
  };
  set("_ent_name", py::str(point.entity));
  set("_node", py::int_(point.node));
  set("_dir", py::int_(point.direction));
}

UffQuantity quantity_of(const py::dict& of, const std::string& name) {
  const auto field = [&](const char* end) { return of[(name + end).c_str()]; };
  return {.type = field("_spec_data_type").cast<std::int64_t>(),
          .exponents = {field("_len_unit_exp").cast<std::int64_t>(),
                        field("_force_unit_exp").cast<std::int64_t>(),
                        field("_temp_unit_exp").cast<std::int64_t>()},
          .label = field("_axis_lab").cast<std::string>(),
          .unit = field("_axis_units_lab").cast<std::string>()};
}

void add_quantity(const UffQuantity& quantity, const std::string& name, py::dict& to) {
  const auto set = [&](const char* end, const py::object& value) {
    to[(name + end).c_str()] = value;
  };
  set("_spec_data_type", py::int_(quantity.type));
  set("_len_unit_exp", py::int_(quantity.exponents[0]));
  set("_force_unit_exp", py::int_(quantity.exponents[1]));
  set("_temp_unit_exp", py::int_(quantity.exponents[2]));
  set("_axis_lab", py::str(quantity.label));
  set("_axis_units_lab", py::str(quantity.unit));
}

/// The fields that the package has checked, and numbers that it has taken out.
Uff58 function_of(const py::dict& of) {
  Uff58 all;
  Uff58Header& header = all.header;
  for (std::size_t i = 0; i < header.id_lines.size(); ++i) {
    header.id_lines[i] = of[("id" + std::to_string(i + 1)).c_str()].cast<std::string>();
  }
  header.function_type = of["func_type"].cast<std::int64_t>();
  header.function_id = of["func_id"].cast<std::int64_t>();
  header.version = of["ver_num"].cast<std::int64_t>();
  header.load_case = of["load_case_id"].cast<std::int64_t>();
  header.response = point_of(of, "rsp");
  header.reference = point_of(of, "ref");
  header.even = of["abscissa_spacing"].cast<int>() == 1;
  header.start = of["abscissa_min"].cast<double>();
  header.step = of["abscissa_inc"].cast<double>();
  header.z = of["z_axis_value"].cast<double>();
  header.abscissa = quantity_of(of, "abscissa");
  header.ordinate = quantity_of(of, "ordinate");
  header.denominator = quantity_of(of, "orddenom");
  header.z_axis = quantity_of(of, "z_axis");
  set_values(of["data"].cast<py::object>(), all.values, all.imaginary);
  all.x = copy_of(of["x"].cast<py::object>());
  header.is_complex = !all.imaginary.empty();
  header.points = all.values.size();
  return all;
}

py::dict dict_of(Uff58 of) {
  const Uff58Header& header = of.header;
  py::dict all("type"_a = 58, "binary"_a = 1);
  for (std::size_t i = 0; i < header.id_lines.size(); ++i) {
    all[("id" + std::to_string(i + 1)).c_str()] = header.id_lines[i];
  }
  all["func_type"] = header.function_type;
  all["func_id"] = header.function_id;
  all["ver_num"] = header.version;
  all["load_case_id"] = header.load_case;
  add_point(header.response, "rsp", all);
  add_point(header.reference, "ref", all);
  all["ord_data_type"] = header.is_complex ? 6 : 4;
  all["num_pts"] = header.points;
  all["abscissa_spacing"] = header.even ? 1 : 0;
  all["abscissa_min"] = header.start;
  all["abscissa_inc"] = header.step;
  all["z_axis_value"] = header.z;
  add_quantity(header.abscissa, "abscissa", all);
  add_quantity(header.ordinate, "ordinate", all);
  add_quantity(header.denominator, "orddenom", all);
  add_quantity(header.z_axis, "z_axis", all);
  all["data"] = values_of(std::move(of.values), of.imaginary);
  all["x"] = of.x.empty() ? py::object(py::none()) : array_of(std::move(of.x));
  return all;
}

py::tuple of_functions(const py::list& functions, const std::string& source) {
  std::vector<Uff58> all;
  for (const py::handle function : functions) all.push_back(function_of(function.cast<py::dict>()));
  return tuple_of(recordings_of_functions(std::move(all), source));
}

py::list functions(const py::dict& recording) {
  py::list all;
  for (Uff58& function : functions_of_recording(recording_of(recording))) {
    all.append(dict_of(std::move(function)));
  }
  return all;
}

}  // namespace

void add_recordings(py::module_& core) {
  core.def("read_recordings", read);
  core.def("write_recordings", write);
  core.def("check_recording",
           [](const py::dict& recording) { check_recording(recording_of(recording)); });
  core.def("unit", unit);
  core.def("recordings_of_functions", of_functions);
  core.def("functions_of_recording", functions);
}

}  // namespace microslip::python
