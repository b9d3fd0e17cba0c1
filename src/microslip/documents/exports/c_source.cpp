// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>

#include "microslip/documents/exports/comment_lines.hpp"
#include "microslip/documents/exports/target_texts.hpp"

namespace microslip {
namespace {

/// A table of C of one number of each slider, filled to whole groups of lanes by zeros.
std::string table_of(const ExportedJoint& joint, double ExportedSlider::*number,
                     std::size_t padded) {
  std::string text;
  for (std::size_t i = 0; i < padded; ++i) {
    const double value = i < joint.sliders.size() ? joint.sliders[i].*number : 0.0;
    text +=
        fmt::format("{}{:.17g}{}", i % 4 == 0 ? "\n    " : " ", value, i + 1 < padded ? "," : "");
  }
  return text;
}

constexpr const char* kCode = R"(
#include <stddef.h>

#define {0}_SIZE {1}

/* Positions of the sliders, {2}. All zero: the joint as it was put together. */
typedef struct {{
  double position[{0}_SIZE];
}} {0}_state;

static const double {0}_stiffness[{0}_SIZE] = {{{3}}};
static const double {0}_slip[{0}_SIZE] = {{{4}}};
static const double {0}_spring = {5:.17g};

/* The force, {6}, at a displacement, {2}, reached in a straight line from that of `from`. Nothing
   is kept but in `to`, which may be `from` itself: a trial step leaves `from` as it is. `tangent`
   may be NULL; it is the slope of the force where the joint goes on. Compile it without
   contraction of products and sums (-ffp-contract=off) for the last digits. */
double {0}_force(const {0}_state *from, double displacement, {0}_state *to, double *tangent) {{
  double lanes[{7}] = {{0.0}};
  double slope = {0}_spring;
  size_t i;
  for (i = 0; i < {0}_SIZE; ++i) {{
    const double lowest = displacement - {0}_slip[i];
    const double highest = displacement + {0}_slip[i];
    double z = from->position[i];
    const int slips = z < lowest || z > highest;
    z = z < lowest ? lowest : z;
    z = z > highest ? highest : z;
    to->position[i] = z;
    lanes[i % {7}] += {0}_stiffness[i] * (displacement - z);
    if (!slips) slope += {0}_stiffness[i];
  }}
  if (tangent) *tangent = slope;
  return (((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
          ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]))) +
         {0}_spring * displacement;
}}
)";

}  // namespace

std::string c_code(const ExportedJoint& joint) {
  const std::size_t padded = padded_sliders(joint);
  return fmt::format(fmt::runtime(kCode), joint.name, padded, joint.units.length,
                     table_of(joint, &ExportedSlider::stiffness, padded),
                     table_of(joint, &ExportedSlider::slip_displacement, padded), joint.spring,
                     joint.units.force, kExportedLanes);
}

std::string c_source(const ExportedJoint& joint) {
  return comment_lines(joint, "/* ", "c", " */") + c_code(joint);
}

}  // namespace microslip
