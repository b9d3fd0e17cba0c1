// SPDX-License-Identifier: MIT
//
// The generated parts of docs/validation.md and README.md, for scripts/update_validation:
//
//     validation_report runs LIST           lines `PROGRAM FILTER`: which tests and benchmarks to
//                                           run; the filters of microslip_bench and ctest are
//                                           expressions
//     validation_report update ROOT FOLDER  writes what FOLDER holds: *.json as they write it, *.md
//
// LIST is tests/validation/figures.toml. Writes nothing and fails where a figure was not measured,
// breaks its bound, or a test failed.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "validation/figure_list.hpp"
#include "validation/measurements.hpp"
#include "validation/page.hpp"

namespace microslip::validation {
namespace {

namespace fs = std::filesystem;

/// A regular expression that finds the name and no longer one, or all that begin with the text
/// before a *.
std::string expression(const std::string& name) {
  return name.ends_with('*') ? "^" + name.substr(0, name.size() - 1) : "^" + name + "$";
}

void print_runs(const std::string& list) {
  std::map<std::string, std::set<std::string>> runs;
  const auto add = [&](const std::string& by) {
    const std::size_t dot = by.find('.');
    const std::string folder = by.substr(0, dot);
    const std::string name = by.substr(dot + 1);
    if (folder == "bench") {
      runs["microslip_bench"].insert(expression(name));
    } else if (folder == "ctest") {
      runs["ctest"].insert(expression(name));
    } else if (folder != "browser") {
      runs["test_" + folder].insert(name);
    }
  };
  for (const FigureTopic& topic : read_figure_list(list)) {
    for (const FigureLine& line : topic.lines) {
      add(line.by);
      if (!line.over.empty()) add(line.over);
    }
  }
  for (const auto& [program, names] : runs) {
    const char* separator = program.starts_with("test_") ? ":" : "|";
    fmt::print("{} {}\n", program, fmt::join(names, separator));
  }
}

/// The value of the first line `key… = or : value` of a file of the system.
std::string system_value(const std::string& path, const std::string& key) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t from = line.find_first_not_of(" \t=:\"", key.size());
    return line.substr(from, line.find_last_not_of(" \"") + 1 - from);
  }
  return "unknown";
}

std::string machine(double load) {
  return fmt::format(
      "Measured on {} processors of an {}, {}, GCC {}, preset `release`.\n"
      "Before the benchmarks began {:.1f} processes ran in the mean of a minute.\n",
      std::thread::hardware_concurrency(), system_value("/proc/cpuinfo", "model name"),
      system_value("/etc/os-release", "PRETTY_NAME"), __VERSION__, load);
}

/// Tables by the names of their topics, `summary` for the README, and the faults.
struct Report {
  Blocks blocks;
  std::vector<std::string> faults;
};

/// The figure of a line; its faults are added to the list.
std::optional<double> checked_figure(const FigureLine& line, const Measurements& measured,
                                     std::vector<std::string>& faults) {
  try {
    const std::optional<double> figure = measured.figure(line);
    if (const auto broken = figure ? broken_bound(line, *figure) : std::nullopt) {
      faults.push_back(*broken);
    }
    return figure;
  } catch (const std::exception& error) {
    faults.push_back(fmt::format("{}: {}", line.what, error.what()));
    return std::nullopt;
  }
}

Report report_of(const std::vector<FigureTopic>& topics, const Measurements& measured) {
  Report report;
  for (const std::string& name : measured.failed()) report.faults.push_back(name + " failed");
  std::vector<Figures> figures;
  for (const FigureTopic& topic : topics) {
    figures.emplace_back();
    for (const FigureLine& line : topic.lines) {
      figures.back().push_back(checked_figure(line, measured, report.faults));
    }
  }
  report.blocks = tables_of(topics, figures);
  report.blocks["machine"] = machine(measured.load());
  return report;
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  if (!(file << text).flush()) throw std::runtime_error("cannot write " + path.string());
}

int update(const fs::path& root, const fs::path& folder) {
  Measurements measured;
  Blocks more;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") measured.add_file(entry.path());
    if (entry.path().extension() == ".md") more.merge(blocks_of(read_text(entry.path())));
  }
  Report report = report_of(read_figure_list(root / "tests/validation/figures.toml"), measured);
  report.blocks.merge(more);
  const std::string page = with_blocks(read_text(root / "docs/validation.md"), report.blocks);
  const std::string readme = with_blocks(read_text(root / "README.md"), report.blocks);
  if (!report.faults.empty()) {
    fmt::print(stderr, "validation_report: nothing is written:\n{}\n",
               fmt::join(report.faults, "\n"));
    return 1;
  }
  write_text(root / "docs/validation.md", page);
  write_text(root / "README.md", readme);
  return 0;
}

}  // namespace
}  // namespace microslip::validation

int main(int argc, char** argv) {
  using namespace microslip::validation;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 2 && arguments[0] == "runs") {
      print_runs(arguments[1]);
      return 0;
    }
    if (arguments.size() == 3 && arguments[0] == "update")
      return update(arguments[1], arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "validation_report: %s\n", error.what());
    return 1;
  }
  std::fputs("validation_report runs LIST\nvalidation_report update ROOT FOLDER\n", stderr);
  return 2;
}
