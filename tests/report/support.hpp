// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "microslip/report/drawing/figure.hpp"
#include "support/messages.hpp"

namespace microslip::test {

/// The message of the InputError that the call throws; says so where it throws none.
template <class Call>
std::string input_fault(const Call& call) {
  return message_or("no error", call);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Everything a figure can have: a band, a dashed line, points with bars, a marker.
inline Figure density_figure() {
  return {.title = "Distribution density φ(f*)",
          .subtitle = "90 levels",
          .x = {.label = "slip force f*", .unit = "N"},
          .y = {.label = "density φ", .unit = "1/N"},
          .layers = {BandLayer{.x = {0.0, 10.0, 20.0},
                               .lower = {0.05, 0.02, 0.0},
                               .upper = {0.15, 0.06, 0.02},
                               .legend = "95 % band"},
                     LineLayer{.x = {0.0, 10.0, 20.0},
                               .y = {0.1, 0.04, 0.01},
                               .legend = "truth",
                               .stroke = {.colour = kBlack, .style = LineStyle::kDashed}},
                     PointLayer{.x = {5.0, 15.0},
                                .y = {0.06, 0.02},
                                .y_error = {0.01, 0.005},
                                .legend = "measured",
                                .colour = kVermillion},
                     MarkerLayer{.x = 18.0, .label = "largest force"}}};
}

}  // namespace microslip::test
