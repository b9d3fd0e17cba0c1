// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/recorded_options.hpp"

#include <optional>
#include <string>
#include <string_view>

#include "microslip/io/config/named_value_access.hpp"
#include "microslip/workflow/identify/smoothing_text.hpp"

namespace microslip {

IdentificationOptions recorded_options(const NamedValues& record) {
  IdentificationOptions options;
  const std::string method = text_in(record, "method").value_or("");
  options.method = find_identification_method(method).value_or(options.method);
  options.fit = find_parametric_model(text_in(record, "fit").value_or(""));
  options.inversion.linear_damping = text_in(record, "linear_damping") == "fit";
  options.inversion.atom = text_in(record, "atom") == "sought";
  options.inversion.edges = text_in(record, "edges") == "sought";
  if (const auto smoothing = text_in(record, "smoothing")) {
    set_smoothing(*smoothing, text_in(record, "smoothing_unit"), options);
  }
  return options;
}

}  // namespace microslip
