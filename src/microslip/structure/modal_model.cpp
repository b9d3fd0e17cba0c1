// SPDX-License-Identifier: MIT
#include "microslip/structure/modal_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "microslip/base/error.hpp"

namespace microslip {
namespace {

void require_non_negative(const std::string& name, double value) {
  if (!(std::isfinite(value) && value >= 0.0)) {
    throw InputError(name, value, "must be 0 or more, and finite");
  }
}

/// @param what   "shape". @param whose  "point 'tip'". @param one_a  "mode".
void check_values(std::string_view what, const std::string& whose,
                  const std::vector<double>& values, std::size_t count, std::string_view one_a) {
  if (values.size() != count) {
    throw InputError(fmt::format("{} of {}", what, whose), fmt::format("{} values", values.size()),
                     fmt::format("must have one value per {}, {} in all", one_a, count));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(values[i])) continue;
    throw InputError(fmt::format("{}[{}] of {}", what, i, whose), values[i], "must be finite");
  }
}

/// The available names, for messages.
template <class Named>
std::string names_of(std::span<const Named> named) {
  std::string text;
  for (const Named& one : named) {
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", one.name);
  }
  return text.empty() ? "none" : text;
}

/// Checks that a name is not empty and differs from those before it.
template <class Named>
void check_name(std::span<const Named> named, std::size_t at, std::string_view what) {
  const std::string& name = named[at].name;
  const auto before = named.first(at);
  if (!name.empty() && std::ranges::find(before, name, &Named::name) == before.end()) return;
  throw InputError(fmt::format("name of a {}", what), fmt::format("'{}'", name),
                   "must not be empty, and no two the same");
}

}  // namespace

ModalModel::ModalModel(std::vector<Mode> modes, std::vector<ModalPoint> points,
                       std::vector<ModalBase> bases, std::size_t static_modes)
    : modes_(std::move(modes)),
      points_(std::move(points)),
      bases_(std::move(bases)),
      static_modes_(static_modes) {
  if (modes_.empty()) throw InputError("number of modes", 0.0, "must be at least 1");
  if (static_modes_ >= modes_.size()) {
    throw InputError("number of static modes", static_cast<double>(static_modes_),
                     fmt::format("must be below that of all, {}", modes_.size()));
  }
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    require_non_negative(fmt::format("angular_frequency[{}]", i), modes_[i].angular_frequency);
    require_non_negative(fmt::format("loss_factor[{}]", i), modes_[i].loss_factor);
  }
  for (std::size_t p = 0; p < points_.size(); ++p) {
    check_name(this->points(), p, "point");
    check_values("shape", fmt::format("point '{}'", points_[p].name), points_[p].shape,
                 modes_.size(), "mode");
  }
  for (std::size_t b = 0; b < bases_.size(); ++b) {
    const ModalBase& base = bases_[b];
    check_name(this->bases(), b, "base");
    if (std::ranges::find(points_, base.name, &ModalPoint::name) != points_.end()) {
      throw InputError("name of a base", fmt::format("'{}'", base.name),
                       "must not be that of a point");
    }
    const std::string whose = fmt::format("base '{}'", base.name);
    check_values("participation", whose, base.participation, modes_.size(), "mode");
    check_values("point_motion", whose, base.point_motion, points_.size(), "point");
    std::vector<double>& load = base_loads_.emplace_back();
    for (const double value : base.participation) load.push_back(-value);
  }
}

ModalModel ModalModel::with_modes(std::vector<Mode> modes) const {
  return {std::move(modes), points_, bases_, static_modes_};
}

bool ModalModel::is_base(std::string_view place) const {
  return std::ranges::find(bases_, place, &ModalBase::name) != bases_.end();
}

double ModalModel::carried(std::string_view point, std::string_view place) const {
  const std::size_t at = index_of(point);
  const auto base = std::ranges::find(bases_, place, &ModalBase::name);
  return base == bases_.end() ? 0.0 : base->point_motion[at];
}

std::span<const double> ModalModel::shape(std::string_view point) const {
  return points_[index_of(point)].shape;
}

std::size_t ModalModel::index_of(std::string_view point) const {
  const auto found = std::ranges::find(points_, point, &ModalPoint::name);
  if (found != points_.end()) return static_cast<std::size_t>(found - points_.begin());
  throw InputError("point", fmt::format("'{}'", point), "is not one of the structure",
                   fmt::format("Available points: {}.", names_of(points())));
}

std::span<const double> ModalModel::load(std::string_view place) const {
  const auto base = std::ranges::find(bases_, place, &ModalBase::name);
  if (base != bases_.end()) return base_loads_[static_cast<std::size_t>(base - bases_.begin())];
  if (bases_.empty() || std::ranges::find(points_, place, &ModalPoint::name) != points_.end()) {
    return shape(place);
  }
  throw InputError(
      "place of a load", fmt::format("'{}'", place), "is not one of the structure",
      fmt::format("Available points: {}; bases: {}.", names_of(points()), names_of(bases())));
}

std::complex<double> ModalModel::receptance(std::string_view to, std::string_view from,
                                            double angular_frequency, DampingLaw law) const {
  require_non_negative("angular_frequency", angular_frequency);
  const std::span<const double> displaced = shape(to);
  const std::span<const double> driven = shape(from);
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const double product = displaced[i] * driven[i];
    if (product == 0.0) continue;  // a mode that takes no part is none at its resonance either
    const std::complex<double> stiffness = modal_stiffness(modes_[i], angular_frequency, law);
    if (stiffness == 0.0) return std::numeric_limits<double>::infinity();
    sum += product / stiffness;
  }
  return sum;
}

std::complex<double> modal_stiffness(const Mode& mode, double angular_frequency, DampingLaw law) {
  const double natural = mode.angular_frequency;
  const double damped = law == DampingLaw::kViscous ? angular_frequency : natural;
  return {(natural - angular_frequency) * (natural + angular_frequency),
          mode.loss_factor * natural * damped};
}

}  // namespace microslip
