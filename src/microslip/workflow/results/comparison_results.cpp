// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/comparison_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "microslip/base/percent.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// The largest rms difference of each quantity: "displacement 2.1 %, phase lag 0.013 rad".
std::string largest_differences(const std::vector<ComparedTest>& tests) {
  std::map<std::pair<std::string, bool>, double>
      largest;  // by quantity, and whether it is an angle
  for (const ComparedTest& test : tests) {
    for (const ComparedCurve& curve : test.curves) {
      if (curve.compared() == 0) continue;
      double& kept = largest[{curve.quantity, curve.dimension == kAngle}];
      kept = std::max(kept, curve.deviation());
    }
  }
  std::string text;
  for (const auto& [key, value] : largest) {
    std::string name = key.first;
    std::ranges::replace(name, '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name,
                        key.second ? fmt::format("{:.2g} rad", value) : percent_text(value));
  }
  return text;
}

/// "few_inside, no_mode_in_sweep" of those that speak against it, each once.
std::string codes_against(const ComparisonFound& found) {
  std::vector<std::string> codes;
  for (const Warning& warning : found.warnings) {
    if (speaks_against(found, warning) && std::ranges::count(codes, warning.code) == 0) {
      codes.push_back(warning.code);
    }
  }
  return fmt::format("{}", fmt::join(codes, ", "));
}

}  // namespace

InsideCount count_inside(const std::vector<ComparedTest>& tests) {
  InsideCount count;
  for (const ComparedTest& test : tests) {
    for (const ComparedCurve& curve : test.curves) {
      count.compared += curve.compared();
      if (curve.has_band()) count.banded += curve.compared();
      count.inside += curve.inside();
    }
  }
  return count;
}

bool speaks_against(const ComparisonFound& found, const Warning& warning) {
  constexpr std::array<std::string_view, 5> kNot = {
      "draws_few", "no_resonance", "several_resonances", "truncated", "viscous_not_drawn"};
  if (std::ranges::count(kNot, warning.code) > 0) return false;
  if (warning.code.starts_with("joint_")) return true;
  return std::ranges::any_of(found.tests, [&](const ComparedTest& test) {
    return warning.text.starts_with(test.source + ": ");
  });
}

std::string comparison_verdict(const ComparisonFound& found) {
  if (!found.of_this_model) return "not available: the comparison is of another joint or model";
  const InsideCount count = count_inside(found.tests);
  const std::string tests = counted(found.tests.size(), "test");
  if (count.compared == 0) return fmt::format("not available: no prediction for {}", tests);
  std::string text;
  if (count.banded > 0) {
    text =
        fmt::format("{} of {} values of {} inside their bands", count.inside, count.banded, tests);
    if (found.confidence) {
      text +=
          fmt::format(", {:.0f} expected", *found.confidence * static_cast<double>(count.banded));
    }
  } else {
    text = fmt::format("{}, without bands to assess them (verify --draws)", tests);
  }
  text += fmt::format("; largest rms differences: {}", largest_differences(found.tests));
  const std::string against = codes_against(found);
  return against.empty() ? text : fmt::format("{}. Against it: {}", text, against);
}

}  // namespace microslip
