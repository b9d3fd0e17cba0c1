// SPDX-License-Identifier: MIT
#include "microslip/identify/records/departure_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Forms = std::vector<DepartureColumns>;

/// Widths of a pinched range about zero, over the largest force or displacement.
constexpr std::array kPinched = {0.1, 0.2, 0.35};
/// Plays, over the largest half range.
constexpr std::array kPlays = {0.02, 0.04, 0.07, 0.1, 0.15, 0.2, 0.3};
/// Contacts that close, over the largest displacement on each side.
constexpr std::array kContacts = {0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85};
/// Contacts that yield: places where they close at first, over the largest displacement on each
/// side, and stretches at which they yield, over that, too.
constexpr std::array kYieldingPlaces = {0.05, 0.1, 0.15, 0.2, 0.25, 0.35, 0.5};
constexpr std::array kYields = {0.02, 0.05, 0.1, 0.3};
/// Contacts that slip once they are closed: half the play between their two sides, and stretches at
/// which they slip, over the largest displacement.
constexpr std::array kSlippingPlays = {0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
constexpr std::array kSlips = {0.05, 0.1, 0.2, 0.4};
/// Drifts of the displacement at the end of a record, over the largest half range, and their powers
/// of the time; small ones are in columns.
constexpr std::array kDrifts = {-0.15, -0.06, 0.06, 0.15};
constexpr std::array kDriftPowers = {1.0, 2.0};
/// Limits and places that are chosen count as so many coefficients.
constexpr double kContactFreedom = 4.0;
constexpr double kYieldingFreedom = 6.0;
/// Powers of a smooth hysteretic link, and springs beside it over the chord to the largest force.
constexpr std::array kPowers = {1.0, 1.5, 2.0};
constexpr std::array kSprings = {0.0, 0.1, 0.2, 0.35, 0.5, 0.7};

MatrixXd side_by_side(const std::vector<VectorXd>& columns) {
  MatrixXd all(columns.front().size(), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) all.col(static_cast<Index>(j)) = columns[j];
  return all;
}

void add_free(Forms& forms, const std::vector<VectorXd>& columns, double further = 0.0) {
  forms.push_back(
      {.free = side_by_side(columns), .freedom = static_cast<double>(columns.size()) + further});
}

/// c u̇ with c ≥ 0, as nothing that is passive has less force at a higher velocity of the same
/// motion; or c < 0, of a force that was recorded later than the displacement.
Forms rate_forms(const RecordSignals& of) {
  return {{.limited = of.velocity, .freedom = 1.0}, {.limited = -of.velocity, .freedom = 2.0}};
}

/// What is left the same by a change of the sign of displacement and force. Of the joint's force:
/// on a path to one side the noise of the measured one would explain itself.
Forms asymmetry_forms(const RecordSignals& of) {
  Forms forms;
  const VectorXd force = of.found.cwiseAbs();
  const VectorXd force_square = of.found.cwiseAbs2();
  add_free(forms, {force, force_square});
  const double middle = 0.5 * (of.displacement.maxCoeff() + of.displacement.minCoeff());
  for (const double centre : {0.0, middle}) {
    const VectorXd u = (of.displacement.array() - centre).matrix();
    const std::vector<VectorXd> of_place = {u.cwiseAbs(), u.cwiseAbs2(),
                                            of.direction.cwiseProduct(u)};
    add_free(forms, of_place);
    add_free(forms, {of_place[0], of_place[1], of_place[2], force, force_square});
  }
  return forms;
}

/// A force that is missing about zero: the joint's, measured F or place u within a width.
void add_pinching(const RecordSignals& of, Forms& forms) {
  const ArrayXd g = of.found.array();
  const ArrayXd f = of.measured.array();
  const ArrayXd u = of.displacement.array() / of.displacement.cwiseAbs().maxCoeff();
  for (const double width : kPinched) {
    const VectorXd step = -(g / width).tanh().matrix();
    const VectorXd bell = (of.direction.array() * (-(g / width).square()).exp()).matrix();
    forms.push_back({.limited = step, .freedom = 2.0});
    forms.push_back({.limited = step, .free = bell, .freedom = 3.0});
    forms.push_back({.limited = (-f * (-(f / width).square()).exp()).matrix(), .freedom = 2.0});
    forms.push_back({.limited = (-f * (-(u / width).square()).exp()).matrix(), .freedom = 2.0});
  }
}

/// Stretch of a contact that closes at a displacement and yields: it closes farther out each time.
VectorXd yielding_contact(const ArrayXd& displacement, double place, double yield) {
  VectorXd stretch(displacement.size());
  for (Index i = 0; i < stretch.size(); ++i) {
    place = std::max(place, displacement(i) - yield);
    stretch(i) = std::max(0.0, displacement(i) - place);
  }
  return stretch;
}

/// Stretch of a spring that slips at a limit, in series with a play of both directions.
VectorXd slipping_contact(const ArrayXd& displacement, double play, double limit) {
  VectorXd stretches(displacement.size());
  double before = 0.0;
  double gap = 0.0;
  double stretch = 0.0;
  for (Index i = 0; i < stretches.size(); ++i) {
    double step = displacement(i) - before;
    before = displacement(i);
    if (stretch * step < 0.0) {
      const double released = std::min(std::abs(step), std::abs(stretch));
      stretch += std::copysign(released, step);
      step -= std::copysign(released, step);
    }
    const double moved = std::clamp(gap + step, -play, play);
    stretch = std::clamp(stretch + step - (moved - gap), -limit, limit);
    gap = moved;
    stretches(i) = stretch;
  }
  return stretches;
}

/// Contacts on either side that close at some displacement, where the force stiffens: elastic ones,
/// others that open at another one, those that slip, and those of a hole or a brace that yields.
void add_contacts(const RecordSignals& of, Forms& forms) {
  const double middle = 0.5 * (of.displacement.maxCoeff() + of.displacement.minCoeff());
  for (const double centre : {0.0, middle}) {
    const ArrayXd u = of.displacement.array() - centre;
    const double reach = u.abs().maxCoeff();
    std::vector<VectorXd> contacts;
    for (const double place : kContacts) {
      contacts.emplace_back((u - place * reach).max(0.0).matrix());
      contacts.emplace_back((u + place * reach).min(0.0).matrix());
    }
    forms.push_back({.limited = side_by_side(contacts), .freedom = kContactFreedom});
    const ArrayXd outwards = (of.direction.array() * u > 0.0).cast<double>();
    std::vector<VectorXd> either;
    for (const VectorXd& contact : contacts) {
      either.emplace_back((outwards * contact.array()).matrix());
      either.emplace_back(((1.0 - outwards) * contact.array()).matrix());
    }
    forms.push_back({.limited = side_by_side(either), .freedom = kYieldingFreedom});
    std::vector<VectorXd> slipping = contacts;
    for (const double play : kSlippingPlays) {
      for (const double slip : kSlips) {
        slipping.push_back(slipping_contact(u, play * reach, slip * reach));
      }
    }
    forms.push_back({.limited = side_by_side(slipping), .freedom = kYieldingFreedom});
    for (const double place : kYieldingPlaces) {
      for (const double yield : kYields) {
        contacts.push_back(yielding_contact(u, place * reach, yield * reach));
        contacts.emplace_back(-yielding_contact(-u, place * reach, yield * reach));
      }
    }
    forms.push_back({.limited = side_by_side(contacts), .freedom = kYieldingFreedom});
  }
}

/// A joint in series with a play, alone and beside a force that is missing about zero.
void add_plays(const RecordSignals& of, Forms& forms) {
  const ArrayXd f = of.measured.array();
  const VectorXd pinched = (-f * (-(f / kPinched[1]).square()).exp()).matrix();
  for (const double play : kPlays) {
    forms.push_back({.moved = of.behind_play(play), .freedom = 2.0});
    forms.push_back({.limited = pinched, .moved = forms.back().moved, .freedom = 3.0});
  }
}

/// A changing load is in slip forces and, by some laws, in stiffnesses. The force is the joint's:
/// noise of the measured one, times the square of the time, would explain itself.
Forms drift_forms(const RecordSignals& of) {
  Forms forms;
  const VectorXd by_time = of.time.cwiseProduct(of.found);
  const VectorXd slip_by_time = of.time.cwiseProduct(of.slipped);
  add_free(forms, {by_time, of.work.cwiseProduct(of.found)});
  add_free(forms, {by_time, slip_by_time});
  add_free(forms, {by_time, of.time.cwiseProduct(by_time), slip_by_time});
  return forms;
}

Forms offset_forms(const RecordSignals& of) {
  Forms forms;
  add_free(forms, {of.time, of.time.cwiseAbs2()});
  return forms;
}

/// Small drifts in columns, others in the path of the joint with such columns beside.
Forms displacement_drift_forms(const RecordSignals& of) {
  const MatrixXd columns = of.displacement_drift();
  Forms forms{{.free = columns, .freedom = 2.0}};
  for (const double power : kDriftPowers) {
    for (const double drift : kDrifts) {
      forms.push_back({.free = columns, .moved = of.without_drift(drift, power), .freedom = 3.0});
    }
  }
  return forms;
}

/// Branches that are narrower or wider than twice the virgin curve, or of a shape that changes with
/// their range, and smooth hysteretic links.
Forms range_forms(const RecordSignals& of) {
  Forms forms;
  const auto wider = [&](double h, double a) {
    return a > 0.0 ? of.virgin(h) - of.virgin(a) * std::min(1.0, h / a) : 0.0;
  };
  const VectorXd width = of.along_branches(wider);
  const VectorXd growing = of.along_branches([&](double h, double a) { return a * wider(h, a); });
  add_free(forms, {width});
  add_free(forms, {width, growing});
  const auto wave = [&](double number, double power) {
    return of.along_branches([&](double h, double a) {
      return a > 0.0
                 ? std::pow(a, power) * std::sin(number * std::numbers::pi * std::min(1.0, h / a))
                 : 0.0;
    });
  };
  add_free(forms, {wave(1.0, 1.0), wave(2.0, 1.0), wave(1.0, 2.0)});
  for (const double spring : kSprings) {
    for (const double power : kPowers) {
      forms.push_back({.free = of.hysteretic(power, spring), .freedom = spring > 0.0 ? 3.0 : 2.0});
    }
  }
  return forms;
}

}  // namespace

std::vector<DepartureColumns> forms_of(RecordDeparture departure, const RecordSignals& signals) {
  switch (departure) {
    case RecordDeparture::kRate:
      return rate_forms(signals);
    case RecordDeparture::kAsymmetry:
      return asymmetry_forms(signals);
    case RecordDeparture::kDeadZone: {
      Forms forms;
      add_pinching(signals, forms);
      add_contacts(signals, forms);
      add_plays(signals, forms);
      return forms;
    }
    case RecordDeparture::kDrift:
      return drift_forms(signals);
    case RecordDeparture::kOffset:
      return offset_forms(signals);
    case RecordDeparture::kRange:
      return range_forms(signals);
    case RecordDeparture::kDisplacementDrift:
      return displacement_drift_forms(signals);
    case RecordDeparture::kOther:  // no form: it is judged by the other records
      break;
  }
  return {};
}

}  // namespace microslip
