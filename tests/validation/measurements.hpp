// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/figure_list.hpp"

namespace microslip::validation {

/// Results of tests and benchmarks.
class Measurements {
 public:
  /// Takes `test_FOLDER.json`, written by GoogleTest; `bench.json`, written by Google Benchmark, of
  /// repeated benchmarks the median; `ctest.json`, whether each test of CTest that was run has
  /// passed; or another `NAME.json`: its numbers, by their paths `a/b`, are figures of NAME.
  /// @throws std::runtime_error  not such a file.
  void add_file(const std::string& path);

  /// The figure of a line in its unit; the number of tests that passed where it has none. Nothing
  /// where its data are missing, so that its tests were skipped. @throws std::runtime_error  not
  /// measured, or a test failed.
  [[nodiscard]] std::optional<double> figure(const FigureLine& line) const;

  /// Names of the tests and benchmarks that failed.
  [[nodiscard]] const std::vector<std::string>& failed() const { return failed_; }

  /// Load of the machine when the benchmarks began, processes that run.
  [[nodiscard]] double load() const { return load_; }

 private:
  struct Test {
    bool passed = false;
    std::map<std::string, double> figures;
  };

  void add_tests(const std::string& folder, const std::string& text);
  void add_benchmarks(const std::string& text);
  void add_ctest(const std::string& text);
  void add_numbers(const std::string& name, const std::string& text);
  /// That of one test, or of all that begin with the text before a *.
  [[nodiscard]] std::optional<double> sum(const FigureLine& line, const std::string& by) const;

  std::map<std::string, Test> tests_;  ///< by `folder.Suite.Test`, `bench.name` and `ctest.name`
  std::vector<std::string> failed_;
  double load_ = 0.0;
};

}  // namespace microslip::validation
