// SPDX-License-Identifier: MIT
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/bindings/python/arguments.hpp"
#include "microslip/bindings/python/core.hpp"
#include "microslip/bindings/python/long_work.hpp"
#include "microslip/bindings/python/results.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/report/page/html_report.hpp"
#include "microslip/report/sections/experiment_report.hpp"
#include "microslip/workflow/results/experiment_folder.hpp"

namespace py = pybind11;

namespace microslip::python {
namespace {

/// A page, and its warnings.
struct Page {
  std::string html;
  std::vector<Warning> warnings;
};

/// Adds figures for print where gnuplot is installed.
Page page_of(ExperimentResults results, bool pictures) {
  if (!pictures) {
    return {html_report(experiment_report(results), {.picture = {}}), results.warnings};
  }
  try {
    return {html_report(experiment_report(results)), results.warnings};
  } catch (const Error& error) {
    results.warnings.push_back(
        {"pictures_missing",
         std::string("The pictures for paper are missing; the browser makes those that are "
                     "printed: ") +
             error.what()});
    return {html_report(experiment_report(results), {.picture = {}}), results.warnings};
  }
}

py::tuple report(const std::string& folder, const std::string& out,
                 const std::optional<std::string>& title, std::size_t records, bool pictures,
                 const std::string& command, const py::object& listener) {
  check_output(out, kReportKind);
  const Page page = long_result(
      [&](const Progress& progress) {
        ExperimentResults results = read_experiment(folder, records, progress);
        if (results.is_empty()) {
          throw InputError("folder", "'" + folder + "'",
                           "must contain levels.csv, joint.json, recordings level_*, "
                           "verification.csv, force_control.csv or what calibrate writes",
                           results.warnings.empty() ? "" : results.warnings.front().text);
        }
        if (title) results.title = *title;
        results.provenance.insert(results.provenance.begin(),
                                  {{"report made by", "microslip " + std::string(kVersion)},
                                   {"report command", command}});
        return page_of(std::move(results), pictures);
      },
      listener);
  write_file(out, page.html);
  return py::make_tuple(page.html.size(), list_of(page.warnings));
}

}  // namespace

void add_report(py::module_& core) { core.def("report", report); }

}  // namespace microslip::python
