// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "microslip/base/units.hpp"

/// @file
/// Results of predictions, as curves.

namespace microslip {

class CsvTable;

/// Between which values the draws of a curve lie, one per point; empty without draws.
struct CurveBand {
  std::vector<double> lower = {};  ///< in the unit of the curve
  std::vector<double> upper = {};  ///< as above
};

/// Steady vibrations over frequency; one length.
struct PredictedResponse {
  std::vector<double> frequency;     ///< Hz, in the order of the curve
  std::vector<double> force;         ///< amplitude, N; > 0
  std::vector<double> displacement;  ///< amplitude of the first harmonic, m
  std::vector<double> phase;         ///< lag behind the force, rad
  CurveBand band = {};               ///< of the displacement or, where that is kept, of the force
  /// Whether a base is shaken: `force` is its acceleration, m/s², the displacement relative to it.
  bool shaken = false;
};

/// Vibrations in phase resonance; one length.
struct PredictedBackbone {
  std::vector<double> displacement;   ///< amplitude, m
  std::vector<double> frequency;      ///< Hz
  std::vector<double> damping_ratio;  ///< 1
  CurveBand frequency_band = {};      ///< Hz
  CurveBand damping_band = {};        ///< 1
};

/// Response of oscillators to a shock; one length.
struct ShockSpectrum {
  std::vector<double> frequency;  ///< natural, Hz
  std::vector<double> maximax;    ///< of the absolute acceleration, in either direction, m/s²
  std::vector<double> positive;   ///< in positive direction, m/s²
  std::vector<double> negative;   ///< in negative direction, as a value above 0, m/s²
};

/// Dissipation, secant stiffness and loss factor of a joint; one length.
struct DissipationCurve {
  std::vector<double> amplitude;         ///< m
  std::vector<double> dissipation;       ///< J
  std::vector<double> secant_stiffness;  ///< N/m
  std::vector<double> loss_factor;       ///< 1
  CurveBand dissipation_band = {};       ///< J
  CurveBand secant_band = {};            ///< N/m
  CurveBand loss_band = {};              ///< 1
};

/// A signal over time.
struct HistorySignal {
  std::string name;            ///< in the legend
  std::string quantity;        ///< labels the axis: "joint force"; empty for that of the unit
  std::string unit;            ///< SI; "" where it is not known
  std::vector<double> time;    ///< s
  std::vector<double> values;  ///< one a time, in that unit
  CurveBand band = {};         ///< of `values`
};

/// Statistics of many jobs for a quantity, at one place or along an axis; one length.
struct EnsembleCurve {
  std::string group;                ///< of the jobs
  std::string output;               ///< its name
  std::string unit;                 ///< SI, of its values
  std::string axis = {};            ///< name of the axis; empty of a number
  std::string axis_unit = {};       ///< SI, of the axis
  std::vector<double> at = {};      ///< places on the axis; one NaN of a number
  std::vector<double> median = {};  ///< NaN where no job has a value, as in the band
  CurveBand band = {};              ///< lower and upper
  std::vector<double> count = {};   ///< jobs that have a value
};

/// Curves of predictions that lie beside a test.
struct PredictedCurves {
  std::optional<PredictedResponse> response = {};  ///< of frf
  std::optional<PredictedBackbone> backbone = {};  ///< of backbone
  std::optional<DissipationCurve> joint = {};      ///< of dissipation
  std::vector<HistorySignal> march = {};           ///< of march
  std::vector<EnsembleCurve> ensemble = {};        ///< of ensemble

  /// Whether there is one.
  [[nodiscard]] bool any() const {
    return response || backbone || joint || !march.empty() || !ensemble.empty();
  }
};

/// Whether a force is kept: its values differ by what a solver leaves, 1e-6 of them.
[[nodiscard]] bool is_same_all_along(const std::vector<double>& values);

/// frf.csv, and those below their tables; with their bands where draws made them.
/// @throws FormatError  where a column is missing or a cell is wrong.
[[nodiscard]] PredictedResponse predicted_response(const CsvTable& table);
[[nodiscard]] PredictedBackbone predicted_backbone(const CsvTable& table);  ///< backbone.csv
[[nodiscard]] ShockSpectrum shock_spectrum(const CsvTable& table);          ///< CSV of spectrum
[[nodiscard]] DissipationCurve dissipation_curve(const CsvTable& table);    ///< curve.csv
[[nodiscard]] std::vector<HistorySignal> marched_histories(const CsvTable& table);  ///< march.csv
/// Of ensemble, each output of each group; none of a sweep, whose values are no draws. NAME_lower
/// and NAME_upper, which an frf has, become one: NAME.
[[nodiscard]] std::vector<EnsembleCurve> ensemble_curves(const CsvTable& table);

/// The columns NAME_lower and NAME_upper, or lower and upper; none without draws.
/// @param table      with both or none.
/// @param name       of the curve; empty: lower and upper.
/// @param dimension  of both.
/// @throws FormatError  where one of the two is missing.
[[nodiscard]] CurveBand band_columns(const CsvTable& table, const std::string& name,
                                     const Dimension& dimension);

}  // namespace microslip
