// SPDX-License-Identifier: MIT
#include "microslip/report/sections/verdict_block.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "microslip/workflow/text/departure_meanings.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr const char* kKind = "a Masing joint under constant normal load";

void add_once(std::vector<std::string>& all, const std::string& text) {
  if (std::ranges::find(all, text) == all.end()) all.push_back(text);
}

}  // namespace

std::vector<std::string> codes_of(const std::vector<Warning>& warnings) {
  std::vector<std::string> codes;
  for (const Warning& warning : warnings) add_once(codes, warning.code);
  return codes;
}

ReportVerdict verdict_on_joint(std::span<const DepartureFound> looked_for,
                               const std::string& status, const std::vector<Warning>& warnings) {
  ReportVerdict verdict{.text = {}, .codes = codes_of(warnings)};
  std::vector<std::string> broken;
  std::vector<std::string> all;
  for (const DepartureFound& one : looked_for) {
    add_once(all, one.departure);
    if (one.broken) add_once(broken, departure_meaning(one.departure));
  }
  if (status != kConvergedStatus && status != kStatusNotTold) {
    verdict.text = fmt::format("The solver did not converge ({}): do not rely on it. ", status);
    verdict.doubtful = true;
  }
  if (!broken.empty()) {
    verdict.doubtful = true;
    verdict.text += fmt::format("Not {} ({}). The nearest such joint is shown.", kKind,
                                fmt::join(broken, "; "));
  } else if (!all.empty()) {
    verdict.text += fmt::format("Nothing contradicts {}: {} looked for, none found.", kKind,
                                counted(all.size(), "departure"));
  } else {
    verdict.text += fmt::format("Not tested whether it is {}.", kKind);
  }
  return verdict;
}

}  // namespace microslip
