// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>

#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// Of the largest slip displacement: so far a spring is written, which no path reaches.
constexpr double kFarStrain = 1000.0;

}  // namespace

/// Its tables have no comments.
std::string mastodon_backbone(const ExportedJoint& joint) {
  std::string text = "strain,stress\n";
  const auto force = [&](double x) {
    double sum = joint.spring * x;
    for (const ExportedSlider& slider : joint.sliders) {
      sum += x < slider.slip_displacement ? slider.stiffness * x : slider.slip_force;
    }
    return sum;
  };
  const auto add = [&](double x) { text += fmt::format("{:.16e},{:.16e}\n", x, force(x)); };
  double last = 0.0;
  for (const ExportedSlider& slider : joint.sliders) {
    if (slider.slip_displacement > last) add(slider.slip_displacement);
    last = slider.slip_displacement;
  }
  if (joint.spring > 0.0) add(kFarStrain * (last > 0.0 ? last : 1.0));
  return text;
}

}  // namespace microslip
