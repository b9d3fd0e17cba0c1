// SPDX-License-Identifier: MIT
#include "microslip/documents/response/response_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <complex>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "microslip/base/error.hpp"
#include "microslip/io/cells/warning_comment.hpp"

namespace microslip {
namespace {

/// Where no energy comes or goes the balance of it holds.
double imbalance(const SteadyVibration& point) {
  const bool has_input = point.input_energy != 0.0;
  return has_input || std::isfinite(point.energy_imbalance) ? point.energy_imbalance : 0.0;
}

bool is_finite(const SteadyVibration& point) {
  const auto fine = [](double value) { return std::isfinite(value); };
  return fine(point.angular_frequency) && fine(point.force_amplitude) && fine(point.response) &&
         fine(point.phase_lag) && fine(point.linear_dissipation) && fine(imbalance(point)) &&
         fine(point.damping_ratio()) &&
         std::ranges::all_of(point.joints, [&](const JointCycle& joint) {
           return fine(joint.amplitude) && fine(joint.dissipation) &&
                  fine(joint.linear_dissipation);
         });
}

constexpr std::size_t kMostMarks = 100;  // of a kind, as comments

/// "… and 12 more" where a list of comments was cut.
void add_rest(std::size_t count, std::string_view what, CsvWriter& table) {
  if (count <= kMostMarks) return;
  table.add_comment(fmt::format("{}: and {} more", what, count - kMostMarks));
}

/// The last point of a curve that did not converge may be NaN.
std::vector<SteadyVibration> writable(const ResponseCurve& curve) {
  std::vector<SteadyVibration> points;
  std::ranges::copy_if(curve.points, std::back_inserter(points), is_finite);
  if (!points.empty()) return points;
  throw InputError("points of the curve", static_cast<double>(curve.points.size()),
                   "must be 1 or more, with finite values, in a table to be written");
}

double joint_dissipation(const SteadyVibration& point) {
  double sum = 0.0;
  for (const JointCycle& joint : point.joints) sum += joint.dissipation;
  return sum;
}

/// ω/(2π), Hz, to 15 digits: 2π times a frequency over 2π is off it by up to two of the last binary
/// digits, some 4e-16, so that a row at a frequency that was asked for, of 15 digits at most, would
/// not be found by its number.
double frequency_as_asked(const SteadyVibration& point) {
  const double frequency = point.frequency();
  const std::string text = fmt::format("{:.14e}", frequency);
  double rounded = frequency;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

/// |w_1| at the response point, m, of a response of any kind.
double displacement_of(const HarmonicBalance& balance, const SteadyVibration& point) {
  switch (balance.response().kind) {
    case ResponseKind::kVelocity:
      return point.response / point.angular_frequency;
    case ResponseKind::kAcceleration:
      return point.response / (point.angular_frequency * point.angular_frequency);
    case ResponseKind::kDisplacement:
      break;
  }
  return point.response;
}

class Columns {
 public:
  Columns(const HarmonicBalance& balance, const std::vector<SteadyVibration>& points,
          CsvWriter& table)
      : balance_(balance), points_(points), table_(table) {}

  template <typename Value>
  void add(std::string_view name, const Dimension& dimension, Value value) {
    std::vector<double> values;
    values.reserve(points_.size());
    for (const SteadyVibration& point : points_) values.push_back(value(point));
    table_.add_numbers(name, dimension, values);
  }

  void add_drive() {
    const CurveHeight drive = drive_column(balance_);
    add(drive.name, drive.dimension, [](const auto& point) { return point.force_amplitude; });
  }
  void add_displacement() {
    add("displacement", kLength, [&](const auto& p) { return displacement_of(balance_, p); });
  }

  void add_derivatives() {
    add("velocity", kVelocity,
        [&](const auto& p) { return p.angular_frequency * displacement_of(balance_, p); });
    add("acceleration", kAcceleration, [&](const auto& p) {
      return p.angular_frequency * p.angular_frequency * displacement_of(balance_, p);
    });
  }

  /// With what the base carries the response point along with.
  void add_absolute() {
    if (!balance_.structure().base_driven()) return;
    const auto displacement = [&](const SteadyVibration& p) {
      return std::abs(
          p.absolute_displacement(balance_.structure(), balance_.response().point).at(1));
    };
    const auto acceleration = [&](const SteadyVibration& p) {
      return p.angular_frequency * p.angular_frequency * displacement(p);
    };
    add("absolute_displacement", kLength, displacement);
    add("absolute_acceleration", kAcceleration, acceleration);
    const double carried = carried_by_bases();
    if (carried == 0.0) return;
    add("transmissibility", kDimensionless,
        [&](const auto& p) { return acceleration(p) / (carried * p.force_amplitude); });
  }

  void add_damping_ratio() {
    add("damping_ratio", kDimensionless, [](const auto& point) { return point.damping_ratio(); });
  }

  /// Those that both tables end with.
  void add_energies() {
    add("dissipation", kEnergy, joint_dissipation);
    add("linear_dissipation", kEnergy, [](const auto& point) { return point.linear_dissipation; });
    for (std::size_t j = 0; j < points_.front().joints.size(); ++j) {
      const std::string& name = points_.front().joints[j].name;
      add("amplitude_" + name, kLength, [j](const auto& p) { return p.joints[j].amplitude; });
      add("dissipation_" + name, kEnergy, [j](const auto& p) { return p.joints[j].dissipation; });
      add("reversals_" + name, kDimensionless,
          [j](const auto& p) { return static_cast<double>(p.joints[j].reversals); });
      add_linear_dissipation(j);
    }
    add("energy_imbalance", kDimensionless, imbalance);
    add_means();
  }

 private:
  /// |Σ_b r(b) s_1| of the response point: what its acceleration would be, were all rigid, over A.
  [[nodiscard]] double carried_by_bases() const {
    const ModalModel& linear = balance_.structure().linear();
    std::complex<double> sum = 0.0;
    for (const Excitation& excitation : balance_.structure().excitations()) {
      sum +=
          linear.carried(balance_.response().point, excitation.point) * excitation.harmonics.at(0);
    }
    return std::abs(sum);
  }

  /// About which it vibrates, where loads always act.
  void add_means() {
    if (balance_.structure().static_loads().empty()) return;
    const ModalModel& linear = balance_.structure().linear();
    add("mean_displacement", kLength, [&](const auto& p) {
      return p.displacement(linear, balance_.response().point).at(0).real();
    });
    for (std::size_t j = 0; j < points_.front().joints.size(); ++j) {
      add("mean_" + points_.front().joints[j].name, kLength,
          [j](const auto& p) { return p.joints[j].displacement.at(0).real(); });
    }
  }

  /// The part of a joint's D that is no slip, where it has one.
  void add_linear_dissipation(std::size_t j) {
    const auto value = [j](const SteadyVibration& p) { return p.joints[j].linear_dissipation; };
    if (std::ranges::none_of(points_, [&](const auto& p) { return value(p) > 0.0; })) return;
    add("linear_dissipation_" + points_.front().joints[j].name, kEnergy, value);
  }

  const HarmonicBalance& balance_;
  const std::vector<SteadyVibration>& points_;
  CsvWriter& table_;
};

/// "force 0.1 N", "base_acceleration 9.81 m/s^2".
std::string drive_text(const HarmonicBalance& balance, const SteadyVibration& point) {
  const CurveHeight drive = drive_column(balance);
  return fmt::format("{} {:.9g} {}", drive.name, point.force_amplitude, si_unit(drive.dimension));
}

void add_ending(const Summary& summary, CsvWriter& table) {
  table.add_comment(fmt::format("{}: {}: {}", summary.method,
                                summary.converged() ? "converged" : "NOT CONVERGED",
                                summary.reason));
}

void add_turning_points(const HarmonicBalance& balance, const ResponseCurve& curve,
                        CsvWriter& table) {
  for (const std::size_t i :
       std::span(curve.turning_points).first(std::min(curve.turning_points.size(), kMostMarks))) {
    if (i >= curve.points.size()) continue;
    const SteadyVibration& point = curve.points[i];
    table.add_comment(fmt::format("turns back: frequency {:.9g} Hz, {}, displacement {:.9g} m",
                                  point.frequency(), drive_text(balance, point),
                                  displacement_of(balance, point)));
  }
  add_rest(curve.turning_points.size(), "turns back", table);
}

void add_marks(const HarmonicBalance& balance, const ResponseCurve& curve, CsvWriter& table) {
  for (const SteadyVibration& peak :
       std::span(curve.peaks).first(std::min(curve.peaks.size(), kMostMarks))) {
    table.add_comment(
        fmt::format("peak: frequency {:.9g} Hz, {}, displacement {:.9g} m, phase {:.6g} rad, "
                    "damping_ratio {:.6g}",
                    peak.frequency(), drive_text(balance, peak), displacement_of(balance, peak),
                    peak.phase_lag, peak.damping_ratio()));
  }
  add_rest(curve.peaks.size(), "peak", table);
  add_turning_points(balance, curve, table);
}

/// 1 in the rows of peaks. What is not finite has no row.
std::vector<double> peak_marks(const ResponseCurve& curve) {
  std::vector<double> marks;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (!is_finite(curve.points[i])) continue;
    const bool is_peak = std::ranges::find(curve.peak_points, i) != curve.peak_points.end();
    marks.push_back(is_peak ? 1.0 : 0.0);
  }
  return marks;
}

/// The rows that writable() leaves of one value per point.
std::vector<double> written(const ResponseCurve& curve, const std::vector<double>& values,
                            const BandColumns& band) {
  if (values.size() != curve.points.size()) {
    throw InputError(fmt::format("values of the band {}", band.name),
                     static_cast<double>(values.size()),
                     fmt::format("must be {}, one per point", curve.points.size()));
  }
  std::vector<double> rows;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_finite(curve.points[i])) rows.push_back(values[i]);
  }
  return rows;
}

void add_bands(const ResponseCurve& curve, std::span<const BandColumns> bands, CsvWriter& table) {
  for (const BandColumns& band : bands) {
    const std::string prefix = band.name.empty() ? "" : band.name + "_";
    table.add_numbers(prefix + "lower", band.dimension, written(curve, band.lower, band));
    table.add_numbers(prefix + "upper", band.dimension, written(curve, band.upper, band));
  }
}

CsvWriter begin(const ResponseCurve& curve, std::string_view heading) {
  CsvWriter table;
  if (!heading.empty()) table.add_comment(heading);
  add_ending(curve.summary, table);
  for (const Warning& warning : curve.warnings) table.add_comment(warning_comment(warning));
  return table;
}

}  // namespace

CurveHeight drive_of(const JointedStructure& structure) {
  if (structure.base_driven()) return {"base_acceleration", kAcceleration, true};
  return {"force", kForce, true};
}

CurveHeight drive_column(const HarmonicBalance& balance) {
  const bool modal = balance.options().forcing == Forcing::kModal;
  return modal ? CurveHeight{"force", kForce, true} : drive_of(balance.structure());
}

CurveHeight displacement_height() { return {"displacement", kLength}; }

bool has_rows(const ResponseCurve& curve) { return std::ranges::any_of(curve.points, is_finite); }

CsvWriter response_table(const HarmonicBalance& balance, const ResponseCurve& curve,
                         std::string_view heading, std::span<const BandColumns> bands) {
  const std::vector<SteadyVibration> points = writable(curve);
  CsvWriter table = begin(curve, heading);
  add_marks(balance, curve, table);
  Columns columns(balance, points, table);
  columns.add("frequency", kFrequency, frequency_as_asked);
  columns.add_drive();
  columns.add_displacement();
  columns.add("phase", kAngle, [](const auto& point) { return point.phase_lag; });
  columns.add_derivatives();
  columns.add_absolute();
  columns.add_energies();
  table.add_numbers("peak", kDimensionless, peak_marks(curve));
  add_bands(curve, bands, table);
  return table;
}

CsvWriter backbone_table(const HarmonicBalance& balance, const ResponseCurve& curve,
                         std::string_view heading, std::span<const BandColumns> bands) {
  const std::vector<SteadyVibration> points = writable(curve);
  CsvWriter table = begin(curve, heading);
  add_turning_points(balance, curve, table);
  Columns columns(balance, points, table);
  columns.add_displacement();
  columns.add_drive();
  columns.add("frequency", kFrequency, [](const auto& point) { return point.frequency(); });
  columns.add_damping_ratio();
  columns.add_energies();
  add_bands(curve, bands, table);
  return table;
}

}  // namespace microslip
