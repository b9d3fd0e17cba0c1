// SPDX-License-Identifier: MIT
#include "reproduction.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "microslip/base/error.hpp"
#include "microslip/io/output/output_files.hpp"

namespace ahmadian_rajaei {
namespace {

using microslip::CsvWriter;
using microslip::OutputFiles;
using microslip::PictureFormat;

std::string drawn(const Reproduction& figure, PictureFormat format) {
  return std::visit(
      [&](const auto& picture) { return microslip::draw(picture, format, figure.size); },
      figure.picture);
}

/// "fig_02" is figure 2.
std::string number_of(const Reproduction& figure) {
  const std::string number = figure.name.substr(figure.name.find('_') + 1);
  return number.front() == '0' ? number.substr(1) : number;
}

}  // namespace

std::string summary_text(std::span<const Reproduction> figures) {
  std::string text = "| figure | quantity | the paper | here | agrees |\n|---|---|---|---|---|\n";
  for (const Reproduction& figure : figures) {
    for (const Finding& finding : figure.findings) {
      text += fmt::format("| {} | {} | {} | {:.4g} | {} |\n", number_of(figure), finding.quantity,
                          finding.reported, finding.value + 0.0, finding.agrees() ? "yes" : "no");
    }
  }
  return text;
}

CsvWriter summary_table(std::span<const Reproduction> figures) {
  std::vector<std::string> number;
  std::vector<std::string> quantity;
  std::vector<std::string> reported;
  std::vector<std::string> agrees;
  std::vector<double> value;
  std::vector<double> from;
  std::vector<double> to;
  for (const Reproduction& figure : figures) {
    for (const Finding& finding : figure.findings) {
      number.push_back(number_of(figure));
      quantity.push_back(finding.quantity);
      reported.push_back(finding.reported);
      agrees.emplace_back(finding.agrees() ? "yes" : "no");
      value.push_back(finding.value);
      from.push_back(finding.from);
      to.push_back(finding.to);
    }
  }
  CsvWriter table;
  table.add_comment("value agrees with what is reported where from <= value <= to");
  table.add_text("figure", number);
  table.add_text("quantity", quantity);
  // Each quantity states its own unit.
  table.add_numbers("value", microslip::kDimensionless, value);
  table.add_numbers("from", microslip::kDimensionless, from);
  table.add_numbers("to", microslip::kDimensionless, to);
  table.add_text("agrees", agrees);
  table.add_text("reported", reported);
  return table;
}

void write_all(const std::string& folder, std::span<const Reproduction> figures) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw microslip::FileError(folder, error.message(), "Choose another folder with --out.");
  }
  OutputFiles files;
  for (const Reproduction& figure : figures) {
    const std::string path = folder + "/" + figure.name;
    for (auto [ending, table] : figure.tables) {
      table.add_comment(fmt::format("[AR14 Fig. {}]: {}", number_of(figure), figure.title));
      files.add(path + ending + ".csv", table.str());
    }
    files.add(path + ".svg", drawn(figure, PictureFormat::kSvg));
    files.add(path + ".png", drawn(figure, PictureFormat::kPng));
  }
  files.add(folder + "/summary.md", summary_text(figures));
  files.add(folder + "/summary.csv", summary_table(figures).str());
  files.commit();
}

}  // namespace ahmadian_rajaei
