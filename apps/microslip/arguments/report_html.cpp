// SPDX-License-Identifier: MIT
#include "arguments/report_html.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/version.hpp"
#include "microslip/report/page/html_report.hpp"
#include "microslip/report/sections/experiment_report.hpp"

namespace microslip::app {

namespace {

/// The reader knows options as they are typed.
void name_options(ExperimentResults& results) {
  for (Warning& warning : results.warnings) warning.text = with_option_names(warning.text);
  if (results.calibration) {
    for (Warning& warning : results.calibration->warnings) {
      warning.text = with_option_names(warning.text);
    }
  }
  if (!results.joint) return;
  for (std::string& text : results.joint->warning_texts) text = with_option_names(text);
}

ReportDocument document_of(const ExperimentResults& results, const ReportAbout& about) {
  ReportDocument document = experiment_report(results);
  document.particulars = about.particulars;
  document.logo = about.logo;
  document.logo_type = about.logo_type;
  return document;
}

}  // namespace

std::string report_html(ExperimentResults results, const Call& call, bool pictures,
                        const ReportAbout& about) {
  name_options(results);
  results.provenance.insert(results.provenance.begin(),
                            {{"report made by", fmt::format("microslip {}", kVersion)},
                             {"report command", call.command_line}});
  if (pictures) {
    try {
      return html_report(document_of(results, about));
    } catch (const Error& error) {
      const std::string text = fmt::format(
          "The pictures for print are missing; the browser draws them when printing: {}",
          error.what());
      results.warnings.push_back({"pictures_missing", text});
      std::string html =
          html_report(document_of(results, about), {.picture = {}});  // may fail as before
      if (!call.quiet) print_text(stderr, fmt::format("microslip: warning: {}\n", text));
      return html;
    }
  }
  return html_report(document_of(results, about), {.picture = {}});
}

}  // namespace microslip::app
