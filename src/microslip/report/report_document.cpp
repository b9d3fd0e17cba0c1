// SPDX-License-Identifier: MIT
#include "microslip/report/report_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_size(const std::string& name, std::size_t size, std::size_t expected) {
  if (size != expected) {
    throw InputError(name + ".size()", fmt::format("{}", size),
                     fmt::format("must be {}", expected));
  }
}

void check_finite(const std::string& name, const std::vector<double>& values) {
  const auto bad = std::ranges::find_if_not(values, [](double v) { return std::isfinite(v); });
  if (bad != values.end()) {
    throw InputError(fmt::format("{}[{}]", name, bad - values.begin()), *bad, "must be finite");
  }
}

void check_band(const std::string& name, const ReportTrace& trace) {
  check_size(name + ".lower", trace.lower.size(), trace.x.size());
  check_size(name + ".upper", trace.upper.size(), trace.x.size());
  check_finite(name + ".lower", trace.lower);
  check_finite(name + ".upper", trace.upper);
  for (std::size_t i = 0; i < trace.x.size(); ++i) {
    if (trace.upper[i] < trace.lower[i]) {
      throw InputError(fmt::format("{}.upper[{}]", name, i), trace.upper[i],
                       fmt::format("must be at least the {} of lower", trace.lower[i]));
    }
  }
}

void check_trace(const std::string& name, const ReportTrace& trace) {
  if (trace.stroke.colour < 0) {
    throw InputError(name + ".stroke.colour", trace.stroke.colour, "must be 0 or more");
  }
  if (trace.x.empty()) throw InputError(name + ".x.size()", "0", "must be 1 or more");
  check_finite(name + ".x", trace.x);
  if (trace.kind == TraceKind::kBand) return check_band(name, trace);
  if (trace.kind == TraceKind::kMarker) return check_size(name + ".x", trace.x.size(), 1);
  check_size(name + ".y", trace.y.size(), trace.x.size());
  if (!trace.y_std.empty()) check_size(name + ".y_std", trace.y_std.size(), trace.x.size());
  check_finite(name + ".y_std", trace.y_std);
  for (std::size_t i = 0; i < trace.y_std.size(); ++i) {
    if (trace.y_std[i] < 0.0) {
      throw InputError(fmt::format("{}.y_std[{}]", name, i), trace.y_std[i], "must be 0 or more");
    }
  }
}

void check_axis(const std::string& name, const ReportAxis& axis) {
  for (const auto& [what, text] : {std::pair{".label", &axis.label}, {".unit", &axis.unit}}) {
    if (text->empty()) throw InputError(name + what, "''", "must not be empty");
  }
}

void check_part(const std::string& name, const ReportFigure& figure) {
  check_axis(name + ".x", figure.x);
  check_axis(name + ".y", figure.y);
  if (figure.chosen >= figure.choices.size()) {
    throw InputError(name + ".chosen", fmt::format("{}", figure.chosen),
                     fmt::format("must be below the {} choices", figure.choices.size()));
  }
  for (std::size_t i = 0; i < figure.choices.size(); ++i) {
    const std::string choice = fmt::format("{}.choices[{}]", name, i);
    const std::vector<ReportTrace>& traces = figure.choices[i].traces;
    if (traces.empty()) throw InputError(choice + ".traces.size()", "0", "must be 1 or more");
    for (std::size_t j = 0; j < traces.size(); ++j) {
      check_trace(fmt::format("{}.traces[{}]", choice, j), traces[j]);
    }
  }
}

void check_part(const std::string& name, const ReportTable& table) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    check_size(fmt::format("{}.rows[{}]", name, i), table.rows[i].size(), table.columns.size());
  }
}

template <typename Other>
void check_part(const std::string& /*name*/, const Other& /*block*/) {}

}  // namespace

void check_report(const ReportDocument& document) {
  if (document.sections.empty()) throw InputError("sections.size()", "0", "must be 1 or more");
  for (std::size_t i = 0; i < document.sections.size(); ++i) {
    const std::vector<ReportBlock>& blocks = document.sections[i].blocks;
    for (std::size_t j = 0; j < blocks.size(); ++j) {
      const std::string name = fmt::format("sections[{}].blocks[{}]", i, j);
      std::visit([&](const auto& block) { check_part(name, block); }, blocks[j]);
    }
  }
}

}  // namespace microslip
