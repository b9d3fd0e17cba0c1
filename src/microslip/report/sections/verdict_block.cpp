// SPDX-License-Identifier: MIT
#include "microslip/report/sections/verdict_block.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr const char* kKind = "a Masing joint under constant normal load";

void add_once(std::vector<std::string>& all, const std::string& text) {
  if (std::ranges::find(all, text) == all.end()) all.push_back(text);
}

}  // namespace

std::string departure_text(const std::string& code) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kTexts = {{
      {"rate_dependent", "rate: force follows velocity"},
      {"asymmetric", "asymmetry: sides differ"},
      {"dead_zone", "dead zone: play, pinching or bearing"},
      {"drifts", "drift: force grows or falls"},
      {"offset_drifts", "offset: zero moves"},
      {"displacement_drifts", "displacement: zero moves"},
      {"not_masing", "not Masing: branches differ"},
      {"records_contradict", "not the other records' joint"},
      {"order_matters", "order: rising and falling levels differ"},
      {"secant_against_dissipation", "k_eq: does not soften as D implies"},
      {"frequency_against_dissipation", "frequency: does not fall as D implies"},
  }};
  const auto* known =
      std::ranges::find(kTexts, code, &std::pair<std::string_view, std::string_view>::first);
  return std::string(known == kTexts.end() ? std::string_view(code) : known->second);
}

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
    if (one.broken) add_once(broken, departure_text(one.departure));
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
