// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// @file
/// Scripts and styles of the page of a report, compiled into the library from report/web and
/// third_party. Internal to report.

namespace microslip {

/// The content of an element, and its SHA-256 in hexadecimal digits.
struct WebAsset {
  std::string_view text;
  std::string_view sha256;
};

extern const WebAsset kPlotlyScript;
extern const WebAsset kUplotScript;
extern const WebAsset kReportScript;
extern const WebAsset kUplotStyle;
extern const WebAsset kReportStyle;
extern const WebAsset kPlotlyLicence;
extern const WebAsset kUplotLicence;

/// "plotly.js 4.1.1, uPlot 1.6.32"
extern const std::string_view kWebLibraries;

}  // namespace microslip
