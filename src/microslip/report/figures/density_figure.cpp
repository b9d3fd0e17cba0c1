// SPDX-License-Identifier: MIT
#include "microslip/report/figures/density_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "microslip/base/percent.hpp"
#include "microslip/report/document/figure_parts.hpp"
#include "microslip/report/document/scales.hpp"
#include "microslip/report/document/shown_unit.hpp"

namespace microslip {
namespace {

constexpr const char* kOfLevels =
    "Below kA of the lowest level the levels determine two moments of φ only, above that of the "
    "highest nothing. [AR14 Fig. 9]";
constexpr const char* kOfRecords =
    "Below the first line slip is below the noise of the displacement, and φ is continued "
    "smoothly; beyond the second, k times the largest half range, nothing slipped.";

/// The values at the slip forces that the levels cover.
std::vector<double> covered(const DensityCurve& curve, const std::vector<double>& slip_force,
                            const std::vector<double>& values) {
  std::vector<double> kept;
  for (std::size_t j = 0; j < values.size(); ++j) {
    if (slip_force[j] >= 0.9 * curve.covered_from.value_or(0.0)) kept.push_back(values[j]);
  }
  return kept;
}

/// The name of a joint whose φ is drawn, with its atoms, which φ does not show.
std::string density_name(const std::string& name, const Joint& joint) {
  double share = 0.0;
  for (const double weight : joint.density().atoms().weight) share += weight;
  if (share == 0.0) return name;
  return fmt::format("{} without its atoms, {} of k", name, percent_text(share));
}

/// The highest that a line or band of the figure reaches.
double highest_of(const Figure& figure) {
  double highest = 0.0;
  for (const Layer& layer : figure.layers) {
    const std::vector<double>* values = nullptr;
    if (const auto* line = std::get_if<LineLayer>(&layer)) values = &line->y;
    if (const auto* band = std::get_if<BandLayer>(&layer)) values = &band->upper;
    if (values != nullptr && !values->empty()) {
      highest = std::max(highest, std::ranges::max(*values));
    }
  }
  return highest;
}

void add_marker(Figure& figure, const std::optional<double>& at, const char* label) {
  if (at) figure.layers.emplace_back(MarkerLayer{.x = *at, .label = label});
}

void add_band(Figure& figure, const DensityCurve& curve) {
  if (curve.lower.empty()) return;
  const std::vector<double>& f =
      curve.band_slip_force.empty() ? curve.slip_force : curve.band_slip_force;
  figure.layers.emplace_back(BandLayer{
      covered(curve, f, f), covered(curve, f, curve.lower), covered(curve, f, curve.upper),
      fmt::format("{:.0f} % band", 100.0 * curve.confidence), kBlue});
  figure.caption += " The band is pointwise: neither of its edges is the density of a joint.";
}

void add_range(Figure& figure, const DensityCurve& curve) {
  add_marker(figure, curve.covered_from,
             curve.of_records ? "determined from" : "kA of lowest level");
  add_marker(figure, curve.covered_to,
             curve.of_records ? "k × largest half range" : "kA of highest level");
  for (std::size_t i = 0; i < curve.atom_slip_force.size() && i < kMostAtomsShown; ++i) {
    add_marker(figure, curve.atom_slip_force[i], "atom");
  }
  if (curve.atom_slip_force.empty()) return;
  figure.caption +=
      " An atom, a slip force at which a part of the stiffness slips at once, is a line without "
      "height here.";
}

/// @param others  beside the curve, up to its end.
Figure figure_of(const DensityCurve& curve, std::span<const ShownJoint> others,
                 const FigureOptions& options) {
  Figure figure{.title = "Slip-force density",
                .caption = curve.of_records ? kOfRecords : kOfLevels};
  const double end = curve.covered_to.value_or(curve.slip_force.back());
  add_band(figure, curve);
  figure.layers.emplace_back(LineLayer{covered(curve, curve.slip_force, curve.slip_force),
                                       covered(curve, curve.slip_force, curve.density), curve.name,
                                       kFound});
  for (const ShownJoint& drawn : others) {
    DensityPoints points = density_points(drawn.joint, 0.0, end);
    figure.layers.emplace_back(LineLayer{std::move(points.slip_force), std::move(points.density),
                                         density_name(drawn.name, drawn.joint), drawn.stroke});
  }
  figure.x.range = AxisRange{0.0, 1.05 * end};
  if (const double highest = highest_of(figure); highest > 0.0) {
    figure.y.range = AxisRange{0.0, 1.05 * highest};
  }
  std::ranges::copy(options.beside, std::back_inserter(figure.layers));
  add_range(figure, curve);
  show_x(figure, "slip force f*", "N");
  show_y(figure, "density φ", "1/N");
  figure.x.log_switch = figure.y.log_switch = true;
  return figure;
}

/// Sliders of single slip forces alone, which have no density.
bool is_of_atoms(const SlipDensity& density) {
  const auto is_flat = [](const SlipDensity::LinearSegment& segment) {
    return segment.p == 0.0 && segment.q == 0.0;
  };
  return !density.atoms().weight.empty() && density.power_laws().empty() &&
         std::ranges::all_of(density.segments(), is_flat);
}

/// Φ0(f*), which has steps where a density has atoms.
Figure slipped_shares(const std::vector<ShownJoint>& joints) {
  double end = 0.0;
  for (const ShownJoint& drawn : joints) {
    end = std::max(end, 1.1 * drawn.joint.density().largest_slip_force());
  }
  Figure figure{.title = "Slip forces",
                .caption =
                    "Share of the stiffness that slips up to a slip force. The joint has single "
                    "slip forces, and thus no density."};
  for (const ShownJoint& drawn : joints) {
    Curve curve = slipped_share(drawn.joint, end);
    figure.layers.emplace_back(
        LineLayer{std::move(curve.x), std::move(curve.y), drawn.name, drawn.stroke});
  }
  figure.x.range = AxisRange{0.0, end};
  show_x(figure, "slip force f*", "N");
  show_y(figure, "share of k that slips up to f*", "1");
  return figure;
}

DensityCurve density_curve_of(const IdentifiedJoint& found) {
  const double from = 0.9 * found.covered_from.value_or(0.0);
  const double to =
      found.covered_to.value_or(macroslip_amplitude(found.joint) * found.joint.stiffness());
  DensityPoints points = density_points(found.joint, from, to);
  return {.slip_force = std::move(points.slip_force),
          .density = std::move(points.density),
          .lower = found.band_lower,
          .upper = found.band_upper,
          .confidence = found.band_confidence,
          .band_slip_force = found.band_slip_force,
          .covered_from = found.covered_from,
          .covered_to = found.covered_to,
          .atom_slip_force = found.joint.density().atoms().slip_force,
          .name = density_name(joint_name(found), found.joint),
          .of_records = found.by_records.has_value()};
}

}  // namespace

Figure density_figure(const ExperimentResults& results, const FigureOptions& options) {
  const IdentifiedJoint& found = joint_of(results);
  if (is_of_atoms(found.joint.density())) return slipped_shares(drawn_joints(results, options));
  return figure_of(density_curve_of(found), drawn_others(results, options), options);
}

Figure density_figure(const DensityCurve& curve, const FigureOptions& options) {
  return figure_of(curve, drawn_others({}, options), options);
}

}  // namespace microslip
