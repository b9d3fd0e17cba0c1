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

void check_shape(const ModalPoint& point, std::size_t modes) {
  if (point.shape.size() != modes) {
    throw InputError(fmt::format("shape of point '{}'", point.name),
                     fmt::format("{} values", point.shape.size()),
                     fmt::format("must have one value a mode, {} in all", modes));
  }
  for (std::size_t i = 0; i < modes; ++i) {
    if (std::isfinite(point.shape[i])) continue;
    throw InputError(fmt::format("shape[{}] of point '{}'", i, point.name), point.shape[i],
                     "must be finite");
  }
}

/// What is there, for messages.
std::string names_of(std::span<const ModalPoint> points) {
  std::string text;
  for (const ModalPoint& point : points) {
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", point.name);
  }
  return text.empty() ? "none" : text;
}

}  // namespace

ModalModel::ModalModel(std::vector<Mode> modes, std::vector<ModalPoint> points)
    : modes_(std::move(modes)), points_(std::move(points)) {
  if (modes_.empty()) throw InputError("number of modes", 0.0, "must be at least 1");
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    require_non_negative(fmt::format("angular_frequency[{}]", i), modes_[i].angular_frequency);
    require_non_negative(fmt::format("loss_factor[{}]", i), modes_[i].loss_factor);
  }
  for (auto point = points_.begin(); point != points_.end(); ++point) {
    const auto same = std::find_if(points_.begin(), point,
                                   [&](const ModalPoint& p) { return p.name == point->name; });
    if (point->name.empty() || same != point) {
      throw InputError("name of a point", fmt::format("'{}'", point->name),
                       "must not be empty, and no two the same");
    }
    check_shape(*point, modes_.size());
  }
}

std::span<const double> ModalModel::shape(std::string_view point) const {
  const auto found = std::ranges::find(points_, point, &ModalPoint::name);
  if (found != points_.end()) return found->shape;
  throw InputError("point", fmt::format("'{}'", point), "is not one of the structure",
                   fmt::format("Points there are: {}.", names_of(points_)));
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
