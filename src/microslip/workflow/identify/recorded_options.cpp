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

NamedValues record_of_options(const IdentificationOptions& options, const OptionTexts& texts) {
  NamedValues record;
  record.emplace_back("method", std::string(to_string(options.method)));
  record.emplace_back("smoothing", texts.smoothing);
  if (texts.smoothing_unit) record.emplace_back("smoothing_unit", *texts.smoothing_unit);
  record.emplace_back("linear_damping", options.inversion.linear_damping ? "fit" : "none");
  record.emplace_back("atom", options.inversion.atom ? "sought" : "none");
  record.emplace_back("edges", options.inversion.edges ? "sought" : "none");
  record.emplace_back("bands", options.bands ? static_cast<double>(options.bands->samples) : 0.0);
  if (!texts.samples_out.empty()) record.emplace_back("samples_out", texts.samples_out);
  record.emplace_back("dissipation_gain_std", texts.common_errors.dissipation_gain_std);
  record.emplace_back("amplitude_gain_std", texts.common_errors.amplitude_gain_std);
  record.emplace_back("loss_factor_std", texts.common_errors.loss_factor_std);
  record.emplace_back("fit", options.fit ? std::string(to_string(*options.fit)) : "none");
  record.emplace_back("inner_reversals", texts.inner_reversals);
  return record;
}

}  // namespace microslip
