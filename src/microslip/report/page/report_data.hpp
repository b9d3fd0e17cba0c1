// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/report/document/report_document.hpp"

/// @file
/// The figures of a report in the format that the scripts of its page read. Internal to report.

namespace microslip {

/// JSON that may stand in a script element: ASCII without <, > and &. An array of figures in the
/// order of the document; what is not finite is null, numbers have 7 digits.
/// A long even axis is {from, step, count}; x that an earlier trace of the choice has is {of:
/// number}.
[[nodiscard]] std::string report_data(const ReportDocument& document);

}  // namespace microslip
