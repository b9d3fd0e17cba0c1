// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/modes/tested_modes.hpp"

namespace microslip {
namespace {

constexpr std::int64_t kDisplacement = 8;
constexpr std::int64_t kUnknownType = 0;
constexpr std::int64_t kGeneralType = 1;
/// Largest difference of η and 2ζ of a mode that are one damping given twice.
constexpr double kSameDamping = 1e-3;

/// A mode shape, and how messages call it.
struct NamedShape {
  const UffModeShape* shape;
  std::string name;
  double mass = 0.0;  // by the key, kg; 0 without it
};

bool is_mode(const UffModeShape& shape) {
  if (shape.analysis == UffAnalysis::kNormalMode) return true;
  // Of a pair of conjugate modes one is enough.
  return shape.analysis == UffAnalysis::kComplexMode && shape.eigenvalue->imag() >= 0.0;
}

std::vector<NamedShape> shapes_wanted(const TestedStructure& test,
                                      const TestedModesOptions& options) {
  std::vector<NamedShape> wanted;
  for (const UffModeShape& shape : test.shapes) {
    if (!is_mode(shape)) continue;
    wanted.push_back(
        {&shape, fmt::format("{}: {}", test.file, mode_name(wanted.size(), shape.frequency))});
  }
  if (wanted.empty()) {
    throw InputError(test.file, fmt::format("{} results at nodes", test.shapes.size()),
                     "must have normal or complex modes (analysis type 2, 3 or 7) among them");
  }
  if (!test.modal_mass.empty() && test.modal_mass.size() != wanted.size()) {
    throw InputError("modal_mass_kg", fmt::format("{} values", test.modal_mass.size()),
                     fmt::format("must be {}, one per mode of {}", wanted.size(), test.file));
  }
  for (std::size_t i = 0; i < test.modal_mass.size(); ++i) wanted[i].mass = test.modal_mass[i];
  std::ranges::stable_sort(wanted, {},
                           [](const NamedShape& named) { return named.shape->frequency; });
  if (!options.count) return wanted;
  if (*options.count > wanted.size()) {
    throw InputError("modes.count", static_cast<double>(*options.count),
                     fmt::format("must be up to {}, the modes of {}", wanted.size(), test.file));
  }
  wanted.resize(*options.count);
  return wanted;
}

void check_values(const NamedShape& named) {
  const UffModeShape& shape = *named.shape;
  if (shape.values_per_node != 3 && shape.values_per_node != 6) {
    throw InputError(named.name, fmt::format("{} values per node", shape.values_per_node),
                     "must have 3 or 6: x, y, z, and rotations");
  }
  const std::int64_t type = shape.specific_type;
  if (type != kDisplacement && type != kUnknownType && type != kGeneralType) {
    throw InputError(named.name, fmt::format("data type {}", type),
                     "must be of displacements, 8: the scale of a velocity or acceleration is "
                     "not given");
  }
  if (shape.nodes.empty()) throw InputError(named.name, "no node", "must have at least one");
}

std::vector<DegreeOfFreedom> freedoms_of(const UffModeShape& shape) {
  std::vector<DegreeOfFreedom> freedoms;
  for (const std::int64_t node : shape.nodes) {
    for (std::size_t k = 0; k < shape.values_per_node; ++k) {
      freedoms.push_back({node, static_cast<NodalDirection>(k)});
    }
  }
  return freedoms;
}

/// The units of a shape, by the file or the keys.
UnitSystem units_of(const NamedShape& named, const std::optional<UnitSystem>& otherwise) {
  if (named.shape->length_unit) return {*named.shape->length_unit, *named.shape->force_unit};
  if (otherwise) return *otherwise;
  throw InputError(named.name, "without units",
                   "must have dataset 164 before it: modal masses and lengths need not be SI",
                   "Give length_unit and force_unit in [test].");
}

Eigen::VectorXcd values_of(const UffModeShape& shape) {
  const auto count = static_cast<Eigen::Index>(shape.values.size());
  Eigen::VectorXcd values = Eigen::Map<const Eigen::VectorXd>(shape.values.data(), count);
  if (!shape.imaginary.empty()) {
    values.imag() = Eigen::Map<const Eigen::VectorXd>(shape.imaginary.data(), count);
  }
  return values;
}

[[noreturn]] void fail_unscaled(const NamedShape& named, std::string_view what,
                                const std::string& found) {
  throw InputError(fmt::format("{} of {}", what, named.name), found,
                   "must be above 0: without it the scale of the shape is not known",
                   "Give modal_mass_kg, or frfs with the drive point in place of shapes.");
}

/// ψ over the root of the modal mass in units of the file, √(2iω_d/a) of a complex mode.
Eigen::VectorXcd scaled(const NamedShape& named) {
  const UffModeShape& shape = *named.shape;
  const Eigen::VectorXcd values = values_of(shape);
  if (named.mass > 0.0) return values / std::sqrt(named.mass);
  if (shape.analysis == UffAnalysis::kNormalMode) {
    if (!shape.modal_mass) fail_unscaled(named, "modal mass", "not in the file");
    if (!(*shape.modal_mass > 0.0)) {
      fail_unscaled(named, "modal mass", fmt::format("{:g}", *shape.modal_mass));
    }
    return values / std::sqrt(*shape.modal_mass);
  }
  if (!shape.modal_a) fail_unscaled(named, "modal A", "not in the file");
  if (!(std::abs(*shape.modal_a) > 0.0)) fail_unscaled(named, "modal A", "0");
  const std::complex<double> mass =
      *shape.modal_a / std::complex<double>(0.0, 2.0 * shape.eigenvalue->imag());
  return values / std::sqrt(mass);
}

/// Factor to √(modal mass in kg) where shapes have lengths in this unit.
void to_si(const UnitSystem& units, bool mass_in_kg, std::span<const DegreeOfFreedom> freedoms,
           Eigen::VectorXcd& shape) {
  const double mass = mass_in_kg ? 1.0 : units.force / units.length;
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    const bool turns = freedoms[i].direction >= NodalDirection::kTurnX;
    shape(static_cast<Eigen::Index>(i)) /= std::sqrt(mass) * (turns ? units.length : 1.0);
  }
}

/// The real shape nearest to a complex one, with its collinearity and phase.
Eigen::VectorXd real_shape(const NamedShape& named, Eigen::VectorXcd shape, TestedModes& tested) {
  if (named.shape->imaginary.empty()) {
    tested.lines.push_back("real");
    if (named.shape->analysis == UffAnalysis::kNormalMode) return shape.real();
  }
  const double turn = 0.5 * std::arg(shape.cwiseProduct(shape).sum());
  const double collinearity = phase_collinearity(shape);
  const double phase = named.mass > 0.0 || !named.shape->modal_a ? 0.0 : 2.0 * turn;
  if (!named.shape->imaginary.empty()) {
    tested.lines.push_back(fmt::format("modal phase collinearity {:.4f}", collinearity));
  }
  warn_of_complexity(named.name, collinearity, phase, tested.warnings);
  return (shape * std::polar(1.0, -turn)).real();
}

[[noreturn]] void fail_undamped(const NamedShape& named) {
  throw InputError("damping of " + named.name, "not in the file, or 0",
                   "must be known: without it resonances are unbounded",
                   "Give damping_ratio or loss_factor in [modes], [0.0] for none.");
}

struct Damping {
  double loss;
  DampingLaw law;
};

Damping damping_of(const NamedShape& named) {
  const UffModeShape& shape = *named.shape;
  const double viscous = 2.0 * shape.damping_ratio.value_or(0.0);
  const double hysteretic = shape.loss_factor.value_or(0.0);
  if (viscous < 0.0 || hysteretic < 0.0) {
    throw InputError("damping of " + named.name, std::min(viscous / 2.0, hysteretic),
                     "must not be negative");
  }
  if (viscous > 0.0 && hysteretic > 0.0 &&
      std::abs(viscous - hysteretic) > kSameDamping * viscous) {
    throw InputError("damping of " + named.name,
                     fmt::format("ratio {:g} and loss factor {:g}", viscous / 2.0, hysteretic),
                     "must be one of them, or the same",
                     "Give damping_ratio or loss_factor in [modes].");
  }
  if (viscous > 0.0) return {viscous, DampingLaw::kViscous};
  if (hysteretic > 0.0) return {hysteretic, DampingLaw::kHysteretic};
  fail_undamped(named);
}

void add_mode(const NamedShape& named, const TestedModesOptions& options, bool first,
              TestedModes& tested) {
  Mode mode{.angular_frequency = 2.0 * std::numbers::pi * named.shape->frequency};
  if (!(named.shape->frequency >= 0.0)) {
    throw InputError(named.name, named.shape->frequency, "must be 0 Hz or above");
  }
  if (!options.damping_given && mode.angular_frequency > 0.0) {
    const Damping damping = damping_of(named);
    if (!first && damping.law != tested.law) {
      throw InputError("damping of " + named.name, "viscous with hysteretic of other modes",
                       "must be of one kind", "Give damping_ratio or loss_factor in [modes].");
    }
    mode.loss_factor = damping.loss;
    tested.law = damping.law;
  }
  tested.modes.push_back(mode);
}

/// "dataset 55".
std::string datasets_of(const std::vector<NamedShape>& wanted) {
  const int first = wanted.front().shape->dataset;
  const bool same = std::ranges::all_of(
      wanted, [&](const NamedShape& named) { return named.shape->dataset == first; });
  return same ? fmt::format("dataset {}", first) : "datasets 55 and 2414";
}

/// Refuses a mode that is in the file twice, as in datasets 55 and 2414: it would count twice.
void check_different(const std::vector<NamedShape>& wanted, const TestedModes& tested) {
  constexpr double kSame = 1e-6;
  for (std::size_t j = 1; j < wanted.size(); ++j) {
    const auto later = tested.shapes.col(static_cast<Eigen::Index>(j));
    for (std::size_t i = 0; i < j; ++i) {
      const auto one = tested.shapes.col(static_cast<Eigen::Index>(i));
      const double frequency = wanted[j].shape->frequency;
      if (frequency - wanted[i].shape->frequency > kSame * frequency) continue;
      if (std::abs(one.dot(later)) < (1.0 - kSame) * one.norm() * later.norm()) continue;
      throw InputError(wanted[j].name, fmt::format("of the shape of {}", wanted[i].name),
                       "must be a different mode: it would count twice",
                       "Keep one of them in the file.");
    }
  }
}

}  // namespace

TestedModes modes_of_shapes(const TestedStructure& test, const TestedModesOptions& options) {
  const std::vector<NamedShape> wanted = shapes_wanted(test, options);
  TestedModes tested{.freedoms = {}, .modes = {}, .shapes = {}, .origin = {}, .lines = {}};
  for (const NamedShape& named : wanted) {
    check_values(named);
    if (tested.freedoms.empty()) tested.freedoms = freedoms_of(*named.shape);
    if (freedoms_of(*named.shape) != tested.freedoms) {
      throw InputError(named.name, fmt::format("{} nodes", named.shape->nodes.size()),
                       "must have the nodes and directions of " + wanted.front().name);
    }
  }
  tested.shapes.resize(static_cast<Eigen::Index>(tested.freedoms.size()),
                       static_cast<Eigen::Index>(wanted.size()));
  bool first = true;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const NamedShape& named = wanted[i];
    Eigen::VectorXcd shape = scaled(named);
    add_mode(named, options, first, tested);
    first = first && tested.modes.back().angular_frequency == 0.0;
    to_si(units_of(named, test.units), named.mass > 0.0, tested.freedoms, shape);
    tested.shapes.col(static_cast<Eigen::Index>(i)) = real_shape(named, std::move(shape), tested);
  }
  check_different(wanted, tested);
  tested.origin.push_back(fmt::format(
      "modes of a test: {} shapes ({}) of {}, scaled by {}", wanted.size(), datasets_of(wanted),
      test.file, test.modal_mass.empty() ? "the modal mass of the file" : "modal_mass_kg"));
  tested.summary.stop = Stop::kClosedForm;
  tested.summary.method = "mode shapes of a test";
  tested.summary.reason = "as in the file";
  return tested;
}

}  // namespace microslip
