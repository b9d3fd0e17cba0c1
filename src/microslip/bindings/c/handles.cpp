// SPDX-License-Identifier: MIT
#include "microslip/bindings/c/handles.hpp"

#include <utility>

#include "microslip/bindings/c/errors.hpp"

namespace microslip::c {

Ending::Ending(const Summary& given, std::vector<Warning> issued, std::string text)
    : summary(given), warnings(std::move(issued)), lines(std::move(text)) {}

void write_outcome(const Ending& ending, microslip_outcome* outcome) {
  require_pointer(outcome, "outcome");
  microslip_outcome all{};
  all.converged = ending.summary.converged() ? 1 : 0;
  all.usable = ending.summary.usable() ? 1 : 0;
  all.iterations = ending.summary.iterations;
  all.residual = ending.summary.residual;
  all.method = ending.summary.method.c_str();
  all.reason = ending.summary.reason.c_str();
  all.summary = ending.lines.c_str();
  all.warning_count = ending.warnings.size();
  write_struct(all, outcome, outcome->struct_size, "outcome");
}

void write_warning(const Ending& ending, std::size_t index, const char** code, const char** text) {
  const Warning& warning = ending.warnings[index_below(index, ending.warnings.size(), "index")];
  if (code != nullptr) *code = warning.code.c_str();
  if (text != nullptr) *text = warning.text.c_str();
}

void hand_out(const std::vector<double>& from, const double** values, std::size_t* count) {
  at(values, "values") = from.data();
  if (count != nullptr) *count = from.size();
}

microslip_status status_of(const Summary& summary) {
  return summary.converged() ? MICROSLIP_OK : not_converged(summary.reason);
}

}  // namespace microslip::c
