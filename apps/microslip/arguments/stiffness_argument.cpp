// SPDX-License-Identifier: MIT
#include "arguments/stiffness_argument.hpp"

#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/workflow/reduce/level_table.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {

double parse_stiffness(const std::optional<std::string>& text) {
  constexpr std::string_view kRemedy =
      "Give the stiffness of the stuck joint, for instance from a low-level test.";
  if (!text) {
    throw InputError("--stiffness", InputState{"missing"},
                     "must be given with levels: slip forces are k times A", kRemedy);
  }
  const double k = parse_quantity("--stiffness", *text, kStiffness);
  if (k > 0.0 && !(k >= kSmallestStiffness && k <= kLargestStiffness)) {
    throw InputError("--stiffness", k, "must be from 1e-6 to 1e15 N/m", "Check its unit.");
  }
  if (!(k > 0.0)) {
    throw InputError("--stiffness", k, "must be above 0 N/m", kRemedy);
  }
  return k;
}

}  // namespace microslip::app
