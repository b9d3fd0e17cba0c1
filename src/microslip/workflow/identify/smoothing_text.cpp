// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/smoothing_text.hpp"

#include <fmt/format.h>

#include <string_view>

#include "microslip/base/error.hpp"
#include "microslip/base/units.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip {
namespace {

struct Choice {
  std::string_view name;  ///< "gcv", "lambda" or "p"
  double value = 0.0;
};

Choice parse(std::string_view text) {
  if (text == "gcv") return {"gcv"};
  for (const std::string_view name : {std::string_view("lambda"), std::string_view("p")}) {
    if (text.starts_with(name) && text.substr(name.size()).starts_with('=')) {
      return {name, parse_quantity(fmt::format("`smoothing {}`", name),
                                   text.substr(name.size() + 1), kDimensionless)};
    }
  }
  throw InputError("`smoothing`", in_quotes(text), "must be gcv, lambda=X or p=X");
}

void check(const Choice& choice) {
  if (choice.name == "lambda" && !(choice.value > 0.0)) {
    throw InputError("`smoothing lambda`", choice.value, "must be above 0");
  }
  if (choice.name == "p" && !(choice.value >= 0.0 && choice.value <= 1.0)) {
    throw InputError("`smoothing p`", choice.value,
                     "must be from 0 (a straight line) to 1 (no smoothing)");
  }
}

double unit_in_metres(const Choice& choice, const std::optional<std::string>& unit) {
  if (!unit) {
    throw InputError(fmt::format("`smoothing {}`", choice.name), choice.value,
                     "is undefined without the unit of the amplitude for which it was chosen",
                     "Add `smoothing_unit`, for instance `smoothing_unit um`.");
  }
  return parse_option_unit("`smoothing_unit`", *unit, kLength).factor();
}

void set_for_spline(const Choice& choice, const std::optional<std::string>& unit,
                    IdentificationOptions& options) {
  if (choice.name == "gcv") {
    if (!unit) return;
    throw InputError("`smoothing_unit`", "'" + *unit + "'", "applies to p=X or lambda=X",
                     "Leave it out with gcv.");
  }
  const double metres = unit_in_metres(choice, unit);
  if (choice.name == "p") {
    options.spline.smoothing = MatlabP{choice.value, metres};
  } else {
    options.spline.smoothing = FixedLambda{choice.value * metres * metres * metres};
  }
}

void set_for_inversion(const Choice& choice, const std::optional<std::string>& unit,
                       IdentificationOptions& options) {
  if (choice.name == "p") {
    if (!unit) static_cast<void>(unit_in_metres(choice, unit));
    throw InputError("`smoothing p`", choice.value, "applies to `method spline`",
                     "Choose that method, or `smoothing gcv` or lambda=X.");
  }
  if (unit) {
    throw InputError("`smoothing_unit`", *unit, "applies to `method spline`",
                     "The inversion is scaled and needs none: leave it out.");
  }
  if (choice.name == "lambda") options.inversion.lambda = choice.value;
}

}  // namespace

void set_smoothing(const std::string& smoothing, const std::optional<std::string>& unit,
                   IdentificationOptions& options) {
  const Choice choice = parse(smoothing);
  check(choice);
  switch (options.method) {
    case IdentificationMethod::kInversion:
      set_for_inversion(choice, unit, options);
      break;
    case IdentificationMethod::kSpline:
      set_for_spline(choice, unit, options);
      break;
    case IdentificationMethod::kDifferences:
      if (choice.name != "gcv" || unit) {
        throw InputError("`smoothing`", in_quotes(smoothing),
                         "has no meaning for the method differences", "Leave it out.");
      }
  }
}

}  // namespace microslip
