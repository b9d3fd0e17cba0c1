// SPDX-License-Identifier: MIT
#include "microslip/report/document/report_document.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void check_size(const std::string& name, std::size_t size, std::size_t expected) {
  if (size != expected) {
    throw InputError(name + ".size()", fmt::format("{}", size),
                     fmt::format("must be {}", expected));
  }
}

void check_axis_texts(const std::string& name, const FigureAxis& axis) {
  for (const auto& [what, text] : {std::pair{".label", &axis.label}, {".unit", &axis.unit}}) {
    if (text->empty()) throw InputError(name + what, "''", "must not be empty");
  }
}

void check_content(const std::string& name, const std::vector<Layer>& layers) {
  if (layers.empty()) throw InputError(name + "layers.size()", "0", "must be 1 or more");
  check_layers(name, layers, true);
}

void check_part(const std::string& name, const ReportFigure& figure) {
  check_axis_texts(name + ".figure.x", figure.figure.x);
  check_axis_texts(name + ".figure.y", figure.figure.y);
  if (figure.choices.empty()) return check_content(name + ".figure.", figure.figure.layers);
  check_size(name + ".figure.layers", figure.figure.layers.size(), 0);
  if (figure.chosen >= figure.choices.size()) {
    throw InputError(name + ".chosen", fmt::format("{}", figure.chosen),
                     fmt::format("must be below the {} choices", figure.choices.size()));
  }
  for (std::size_t i = 0; i < figure.choices.size(); ++i) {
    check_content(fmt::format("{}.choices[{}].", name, i), figure.choices[i].layers);
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

const std::vector<Layer>& chosen_layers(const ReportFigure& figure) {
  return figure.choices.empty() ? figure.figure.layers : figure.choices.at(figure.chosen).layers;
}

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
