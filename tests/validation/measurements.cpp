// SPDX-License-Identifier: MIT
#include "validation/measurements.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "validation/page.hpp"

namespace microslip::validation {
namespace {

using nlohmann::json;

double seconds_in(const std::string& unit) {
  static const std::map<std::string, double> kUnits{
      {"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1.0}};
  return kUnits.at(unit);
}

}  // namespace

void Measurements::add_file(const std::string& path) {
  const std::string name = std::filesystem::path(path).stem().string();
  const std::string text = read_text(path);
  try {
    if (name.starts_with("test_")) {
      add_tests(name.substr(5), text);
    } else if (name == "bench") {
      add_benchmarks(text);
    } else if (name == "ctest") {
      add_ctest(text);
    } else {
      add_numbers(name, text);
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
  }
}

// Properties stand among the members of a test in the file; those that are numbers are figures.
void Measurements::add_tests(const std::string& folder, const std::string& text) {
  const json file = json::parse(text);
  for (const json& suite : file.at("testsuites")) {
    for (const json& one : suite.at("testsuite")) {
      const std::string name = fmt::format("{}.{}.{}", folder, suite.at("name").get<std::string>(),
                                           one.at("name").get<std::string>());
      Test test;
      test.passed = one.at("result") == "COMPLETED" && !one.contains("failures");
      if (one.contains("failures")) failed_.push_back(name);
      for (const auto& [key, value] : one.items()) {
        if (!key.ends_with(']') || !value.is_string()) continue;
        test.figures[key] = std::stod(value.get<std::string>());
      }
      tests_[name] = std::move(test);
    }
  }
}

// Google Benchmark keeps to processor time unless a benchmark asks for that of the clock, and then
// says so in its name. So does `time [s]` here.
void Measurements::add_benchmarks(const std::string& text) {
  const json file = json::parse(text);
  const json& load = file.at("context").at("load_avg");
  if (!load.empty()) load_ = load[0].get<double>();
  for (const json& run : file.at("benchmarks")) {
    const std::string name = "bench." + run.at("run_name").get<std::string>();
    if (run.value("error_occurred", false)) failed_.push_back(name);
    if (run.value("aggregate_name", "median") != "median") continue;
    Test test{.passed = true, .figures = {}};
    for (const auto& [key, value] : run.items()) {
      if (value.is_number_float()) test.figures[key] = value.get<double>();
    }
    const char* time = name.ends_with("/real_time") ? "real_time" : "cpu_time";
    test.figures["time [s]"] =
        run.at(time).get<double>() * seconds_in(run.at("time_unit").get<std::string>());
    tests_[name] = std::move(test);
  }
}

void Measurements::add_ctest(const std::string& text) {
  const json file = json::parse(text);
  for (const auto& [key, value] : file.items()) {
    const std::string name = "ctest." + key;
    tests_[name] = {.passed = value.get<bool>(), .figures = {}};
    if (!tests_[name].passed) failed_.push_back(name);
  }
}

void Measurements::add_numbers(const std::string& name, const std::string& text) {
  Test test{.passed = true, .figures = {}};
  const json file = json::parse(text).flatten();
  for (const auto& [key, value] : file.items()) {
    if (value.is_number()) test.figures[key.substr(1)] = value.get<double>();
  }
  tests_[name] = std::move(test);
}

std::optional<double> Measurements::sum(const FigureLine& line, const std::string& by) const {
  const bool several = by.ends_with('*');
  const std::string start = several ? by.substr(0, by.size() - 1) : by;
  bool run = false;
  std::optional<double> result;
  for (auto test = tests_.lower_bound(start); test != tests_.end(); ++test) {
    const auto& [name, found] = *test;
    if (several ? !name.starts_with(start) : name != start) break;
    run = true;
    const auto figure = found.figures.find(line.figure);
    if (!found.passed || (!line.counts_tests() && figure == found.figures.end())) continue;
    result = result.value_or(0.0) + (line.counts_tests() ? 1.0 : figure->second);
  }
  if (!result && !line.external) {
    const char* why =
        run ? "failed, was skipped or does not record" : "was not run, so there is no";
    throw std::runtime_error(fmt::format("{} {} '{}'", by, why, line.figure));
  }
  return result;
}

std::optional<double> Measurements::figure(const FigureLine& line) const {
  const std::optional<double> value = sum(line, line.by);
  if (!value || line.counts_tests()) return value;
  return line.scale * *value / (line.over.empty() ? 1.0 : *sum(line, line.over));
}

}  // namespace microslip::validation
