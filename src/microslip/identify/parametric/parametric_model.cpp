// SPDX-License-Identifier: MIT
#include "microslip/identify/parametric/parametric_model.hpp"

namespace microslip {

std::string_view to_string(ParametricModel model) {
  switch (model) {
    case ParametricModel::kPowerLaw:
      return "power_law";
    case ParametricModel::kUniform:
      return "uniform";
    case ParametricModel::kFourParameter:
      break;
  }
  return "four_parameter";
}

std::optional<ParametricModel> find_parametric_model(std::string_view name) {
  for (const ParametricModel model : kParametricModels) {
    if (name == to_string(model)) return model;
  }
  return std::nullopt;
}

}  // namespace microslip
