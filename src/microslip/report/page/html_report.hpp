// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/report/document/report_document.hpp"
#include "microslip/report/page/html_report_options.hpp"

/// @file
/// A report as one HTML file that needs nothing else: no network, no other file, no program.

namespace microslip {

/// The file. Charts are drawn by plotly.js and uPlot, which are part of it with their licences. Its
/// content security policy lets the browser run these scripts alone, by their SHA-256, and load
/// nothing; all texts of the document are escaped. The same document gives the same bytes.
/// A figure for which the picture throws InputError has none, nor have those whose pictures would
/// make the file larger than 4 MB; for these the browser makes one once the page is read.
/// @throws InputError  as check_report(). @throws Error  as the picture does.
[[nodiscard]] std::string html_report(const ReportDocument& document,
                                      const HtmlReportOptions& options = {});

}  // namespace microslip
