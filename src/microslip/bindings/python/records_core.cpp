// SPDX-License-Identifier: MIT
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/identification.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/recordings.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/identify/evidence/joint_evidence.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/workflow/identify/records_identification.hpp"
#include "microslip/workflow/reduce/force_records.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

using namespace py::literals;

/// One record, or one table of levels, from the package, with its name.
using GivenRecord = std::tuple<std::string, RealArray, RealArray, double>;
using GivenLevels = std::tuple<std::string, py::dict>;

std::string_view bytes_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

std::vector<NamedForceRecord> records_of(const std::vector<GivenRecord>& given) {
  std::vector<NamedForceRecord> all;
  for (const auto& [name, displacement, force, time_step] : given) {
    all.push_back({.source = name,
                   .record = {.displacement = copy_of(displacement),
                              .force = copy_of(force),
                              .time_step = time_step},
                   .input = static_cast<double>(all.size() + 1)});
  }
  return all;
}

/// The given arrays, as the files of the program.
struct GivenEvidence {
  std::vector<NamedForceRecord> records;
  std::vector<std::pair<std::string, Levels>> levels;
};

RecordsIdentification record_options_of(const py::dict& given) {
  RecordsIdentification all;
  all.stiffness = given["stiffness"].cast<std::optional<double>>();
  if (const auto start = given["start"].cast<std::string>(); start != "auto") {
    all.start = start == "virgin" ? PathStart::kVirgin : PathStart::kUnknown;
  }
  all.options.viscous = given["viscous"].cast<bool>();
  all.fit_drift = given["drift"].cast<bool>();
  all.options.draws = given["samples"].cast<std::size_t>();
  all.options.seed = given["seed"].cast<std::uint64_t>();
  all.channels = {.force = "force", .displacement = "displacement"};
  return all;
}

SourcedEvidence evidence_of(const GivenEvidence& given, const RecordsIdentification& options) {
  SourcedEvidence all;
  for (const NamedForceRecord& one : given.records) {
    all.add(one, options);
    std::string content(bytes_of(one.record.displacement));
    content += bytes_of(one.record.force);
    all.from.inputs.push_back({one.source, sha256(content)});
  }
  for (const auto& [name, table] : given.levels) {
    all.add(name, table);
    std::string content(bytes_of(table.amplitude));
    content += bytes_of(table.dissipation);
    all.from.inputs.push_back({name, sha256(content)});
  }
  return all;
}

py::object viscous_of(const RecordInversionResult& found) {
  return found.viscous ? py::object(estimate_tuple(*found.viscous)) : py::object(py::none());
}

py::list fits_of(const IdentifiedRecords& done) {
  py::list all;
  for (std::size_t i = 0; i < done.from.records.size(); ++i) {
    const RecordFit& fit = done.found.records()->records[i];
    const SensorDrift drift = done.from.drift[i] ? done.from.drift[i]->drift : SensorDrift{};
    py::list verdicts;
    for (const RecordVerdict& verdict : fit.verdicts) {
      verdicts.append(py::make_tuple(std::string(to_string(verdict.departure)), verdict.share,
                                     verdict.noise, verdict.broken));
    }
    all.append(
        py::dict("source"_a = done.from.records[i], "start"_a = std::string(to_string(fit.start)),
                 "start_shown"_a = done.from.start[i].shown, "offset"_a = array_of(fit.offset),
                 "displacement_drift"_a = array_of(drift.displacement),
                 "force_drift"_a = array_of(drift.force), "residual"_a = array_of(fit.residual),
                 "scatter"_a = fit.scatter, "correlation"_a = fit.correlation,
                 "unexplained"_a = fit.unexplained, "verdicts"_a = verdicts));
  }
  return all;
}

py::dict identify_records(const std::vector<GivenRecord>& records,
                          const std::vector<GivenLevels>& levels, const py::dict& given,
                          const std::string& command, const py::object& listener) {
  RecordsIdentification options = record_options_of(given);
  GivenEvidence evidence{records_of(records), {}};
  for (const auto& [name, columns] : levels) {
    evidence.levels.emplace_back(name, levels_of_columns(columns));
  }
  const IdentifiedRecords done = long_result(
      [&](const Progress& progress) {
        options.options.progress = progress;
        return identify_evidence(evidence_of(evidence, options), options);
      },
      listener);
  py::dict all = identification_dict(done.found, identified_joint(options, done, command));
  const RecordInversionResult& found = *done.found.records();
  all["stiffness"] = estimate_tuple(found.stiffness);
  all["elastic_stiffness"] = estimate_tuple(found.elastic_stiffness);
  all["viscous"] = viscous_of(found);
  all["resolved_from"] = found.resolved_from;
  all["records"] = fits_of(done);
  return all;
}

py::tuple record_of(const py::dict& recording, const std::string& force,
                    const std::string& displacement) {
  ForceRecord record = force_record(recording_of(recording), {force, displacement});
  return py::make_tuple(array_of(std::move(record.displacement)), array_of(std::move(record.force)),
                        record.time_step);
}

}  // namespace

void add_records(py::module_& core) {
  core.def("force_record", record_of);
  core.def("identify_records", identify_records);
}

}  // namespace microslip::python
