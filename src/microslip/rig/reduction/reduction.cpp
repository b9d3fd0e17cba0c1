// SPDX-License-Identifier: MIT
#include "microslip/rig/reduction/reduction.hpp"

#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/rig/reduction/record_analysis.hpp"
#include "microslip/rig/reduction/record_level.hpp"

namespace microslip {
namespace {

void check_options(const ReductionOptions& options) {
  const auto require = [](std::string_view name, double value) {
    if (!(value > 0.0)) throw InputError(name, value, "must be above 0");
  };
  require("most_distortion", options.most_distortion);
  require("most_misfit", options.most_misfit);
  require("most_mismatch", options.most_mismatch);
  require("most_phase", options.most_phase);
}

}  // namespace

Reducer::Reducer(Rig rig, ReductionOptions options)
    : rig_(std::move(rig)), options_(options), state_(stick_state(rig_, options_.modes)) {
  check_options(options_);
}

ReducedLevel Reducer::reduce(const Recording& recording) const {
  return reduced_level(
      analyse_record(recording, rig_, state_, options_.fit, options_.use_vibrometer), rig_, state_,
      options_);
}

}  // namespace microslip
