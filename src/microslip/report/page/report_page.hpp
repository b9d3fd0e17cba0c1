// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "microslip/report/document/report_document.hpp"
#include "microslip/report/page/html_report_options.hpp"

/// @file
/// The sections of a report as HTML, complete without any script. Internal to report.

namespace microslip {

/// Links to the sections.
[[nodiscard]] std::string page_navigation(const ReportDocument& document);

/// All sections with their texts, tables, and the pictures for which `most_bytes` leave room.
[[nodiscard]] std::string page_sections(const ReportDocument& document,
                                        const HtmlReportOptions& options, std::size_t most_bytes);

}  // namespace microslip
