// SPDX-License-Identifier: MIT
#include "microslip/workflow/predict/march_draws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include "microslip/documents/response/march_file.hpp"
#include "microslip/identify/posterior/quantiles.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

constexpr std::size_t kOfPoint = 3;  // w, ẇ, ẅ

std::vector<MarchedSignal> marched_signals(const JointedStructure& structure,
                                           const LoadHistory& loads) {
  std::vector<MarchedSignal> signals;
  for (const TableColumn& column : march_columns(structure, loads)) {
    signals.push_back({column.name, column.dimension});
  }
  return signals;
}

/// One a signal: w, ẇ, ẅ as they are read, u_j and F_j, and the absolute motion as it is read.
std::vector<double> values_in(const MarchRow& row, double response_gain) {
  std::vector<double> values{response_gain * row.displacement[0], response_gain * row.velocity[0],
                             response_gain * row.acceleration[0]};
  for (std::size_t j = 0; j < row.joint_displacement.size(); ++j) {
    values.push_back(row.joint_displacement[j]);
    values.push_back(row.joint_force[j]);
  }
  if (row.absolute_displacement.empty()) return values;
  for (const auto& motion :
       {row.absolute_displacement, row.absolute_velocity, row.absolute_acceleration}) {
    values.push_back(response_gain * motion[0]);
  }
  return values;
}

/// The rows of a march that are recorded.
class KeptRows {
 public:
  KeptRows(std::size_t last, std::size_t every, double gain)
      : last_(last), every_(every), gain_(gain) {}

  void add(const MarchRow& row) {
    if (row.index % every_ != 0 && row.index != last_) return;
    const std::vector<double> now = values_in(row, gain_);
    times.push_back(row.index);
    rows.insert(rows.end(), now.begin(), now.end());
  }

 private:
  std::size_t last_;
  std::size_t every_;
  double gain_;

 public:
  std::vector<std::size_t> times;
  std::vector<double> rows;
};

/// Peak or rms of each signal, those of the point as they are read.
std::vector<double> sizes_of(const MarchResult& march, double SignalSize::*which, double gain) {
  const std::size_t joints_end = kOfPoint + 2 * march.energy.joints.size();
  std::vector<double> values;
  for (const SignalSize& size : march.sizes) {
    const bool of_point = values.size() < kOfPoint || values.size() >= joints_end;
    values.push_back(size.*which * (of_point ? gain : 1.0));
  }
  return values;
}

std::size_t recorded_rows(const LoadHistory& loads, std::size_t every) {
  const std::size_t last = loads.time.size() - 1;
  return last / every + 1 + (last % every == 0 ? 0 : 1);
}

using PerDraw = std::vector<std::vector<double>>;  // empty where the draw failed

/// Between which values the draws lie, of each signal.
void add_spread(const PerDraw& values, double confidence, StatisticSpread MarchedSignal::*which,
                std::vector<MarchedSignal>& signals) {
  const Band band = band_of(values, confidence);
  for (std::size_t s = 0; s < signals.size(); ++s) {
    (signals[s].*which).lower = band.lower[s];
    (signals[s].*which).upper = band.upper[s];
  }
}

void take_marches(const LoadHistory& loads, const MarchOptions& options, std::size_t every,
                  const StructureDraws& draws, const DrawOptions& drawn, const Execution& execution,
                  const Progress& progress, DrawnMarch& result) {
  PerDraw rows(drawn.count);
  PerDraw peaks(drawn.count);
  PerDraw rms(drawn.count);
  const auto take = [&](std::size_t i) -> std::string {
    const StructureDraw draw = draws.draw(i);
    KeptRows kept(loads.time.size() - 1, every, draw.response_gain);
    const MarchResult found = march_rows(draw.structure, loads_over_gains(loads, draw), options,
                                         [&](const MarchRow& row) { kept.add(row); });
    if (!found.summary.converged()) return found.summary.reason;
    peaks[i] = sizes_of(found, &SignalSize::peak, draw.response_gain);
    rms[i] = sizes_of(found, &SignalSize::rms, draw.response_gain);
    rows[i] = std::move(kept.rows);
    return "";
  };
  result.taken = take_draws(drawn, take, execution, progress);
  result.band = band_of(rows, drawn.confidence);
  add_spread(peaks, drawn.confidence, &MarchedSignal::peak, result.signals);
  add_spread(rms, drawn.confidence, &MarchedSignal::rms, result.signals);
}

std::string spread_text(const StatisticSpread& spread, const std::string& unit) {
  return fmt::format("{:.6g} {}, {:.6g} to {:.6g} {}", spread.value, unit, spread.lower,
                     spread.upper, unit);
}

}  // namespace

LoadHistory loads_over_gains(const LoadHistory& read, const StructureDraw& drawn) {
  LoadHistory loads = read;
  for (PointForce& at : loads.forces) {
    for (std::size_t d = 0; d < drawn.force_gain.size(); ++d) {
      if (drawn.structure.excitations()[d].point != at.point) continue;
      for (double& force : at.force) force /= drawn.force_gain[d];
    }
  }
  return loads;
}

std::vector<Warning> gain_warnings(const ModelFile& model, const LoadHistory& loads) {
  std::vector<Warning> warnings;
  for (std::size_t d = 0; d < model.spread.force_gain.size(); ++d) {
    const std::string& point = model.structure.excitations()[d].point;
    const bool acts =
        std::ranges::find(loads.forces, point, &PointForce::point) != loads.forces.end();
    if (acts || model.spread.force_gain[d] == 0.0) continue;
    warnings.push_back(
        {"gain_unused",
         fmt::format("gain_std of the excitation at '{}' is not used by any draw: no force of the "
                     "file acts there. Forces at other points have no uncertainty.",
                     point)});
  }
  return warnings;
}

DrawnMarch drawn_march(const ModelFile& model, const LoadHistory& loads, MarchOptions options,
                       const StructureDraws& draws, const DrawOptions& drawn,
                       const Execution& execution, const Progress& marching,
                       const Progress& drawing) {
  drawn.check();
  DrawnMarch result;
  result.signals = marched_signals(model.structure, loads);
  const std::size_t every = std::exchange(options.every, 1);
  drawn.check_size(result.signals.size() * recorded_rows(loads, every),
                   "Write fewer times with `every`, or use fewer draws.");
  KeptRows kept(loads.time.size() - 1, every, 1.0);
  result.march = march_rows(
      model.structure, loads, options, [&](const MarchRow& row) { kept.add(row); }, marching);
  for (std::size_t s = 0; s < result.signals.size(); ++s) {
    result.signals[s].peak.value = result.march.sizes[s].peak;
    result.signals[s].rms.value = result.march.sizes[s].rms;
  }
  result.times = std::move(kept.times);
  result.rows = std::move(kept.rows);
  std::vector<Warning>& warnings = result.march.warnings;
  std::ranges::move(march_warnings(model, result.march.reach), std::back_inserter(warnings));
  if (!result.march.summary.converged()) return result;
  options.estimate_error = false;
  take_marches(loads, options, every, draws, drawn, execution, drawing, result);
  std::ranges::move(draw_warnings(result.taken), std::back_inserter(warnings));
  std::ranges::move(gain_warnings(model, loads), std::back_inserter(warnings));
  return result;
}

std::string march_peaks_comment(const DrawnMarch& march) {
  std::string text;
  for (const MarchedSignal& signal : march.signals) {
    const std::string unit(si_unit(signal.dimension));
    text += fmt::format("{}of draws: {}: peak {}; rms {}", text.empty() ? "" : "\n", signal.name,
                        spread_text(signal.peak, unit), spread_text(signal.rms, unit));
  }
  return text;
}

std::string march_peaks_table(const DrawnMarch& march, const std::string& heading) {
  CsvWriter table;
  if (!heading.empty()) table.add_comment(heading);
  table.add_text("statistic", std::vector<std::string>{"peak", "rms"});
  for (const MarchedSignal& signal : march.signals) {
    const auto add = [&](const std::string& ending, double StatisticSpread::*which) {
      table.add_numbers(signal.name + ending, signal.dimension,
                        std::vector<double>{signal.peak.*which, signal.rms.*which});
    };
    add("", &StatisticSpread::value);
    add("_lower", &StatisticSpread::lower);
    add("_upper", &StatisticSpread::upper);
  }
  const auto draws = static_cast<double>(march.taken.options.count - march.taken.failed());
  table.add_numbers("draws", kDimensionless, std::vector<double>{draws, draws});
  return table.str();
}

std::string describe_march_spread(const DrawnMarch& march) {
  std::string text;
  for (const MarchedSignal& signal : march.signals) {
    const std::string unit(si_unit(signal.dimension));
    text += line("peak of draws", fmt::format("{}: {:.5g} to {:.5g} {}, rms {:.5g} to {:.5g} {}",
                                              signal.name, signal.peak.lower, signal.peak.upper,
                                              unit, signal.rms.lower, signal.rms.upper, unit));
  }
  return text;
}

void write_drawn_march(const std::string& path, const ModelFile& model, const LoadHistory& loads,
                       const std::string& heading, const DrawnMarch& march) {
  MarchTable table(path, model.structure, loads, heading, march.has_band());
  const std::size_t columns = march.signals.size();
  std::vector<double> displacement(model.structure.joints().size());
  std::vector<double> force(displacement.size());
  std::vector<double> edges;
  for (std::size_t r = 0; r < march.times.size(); ++r) {
    const std::span<const double> row = std::span(march.rows).subspan(r * columns, columns);
    for (std::size_t j = 0; j < force.size(); ++j) {
      displacement[j] = row[kOfPoint + 2 * j];
      force[j] = row[kOfPoint + 2 * j + 1];
    }
    edges.clear();
    for (std::size_t s = r * columns; march.has_band() && s < (r + 1) * columns; ++s) {
      edges.push_back(march.band.lower[s]);
      edges.push_back(march.band.upper[s]);
    }
    MarchRow marched{.index = march.times[r],
                     .time = loads.time[march.times[r]],
                     .displacement = row.subspan(0, 1),
                     .velocity = row.subspan(1, 1),
                     .acceleration = row.subspan(2, 1),
                     .joint_displacement = displacement,
                     .joint_force = force};
    const std::size_t joints_end = kOfPoint + 2 * force.size();
    if (columns > joints_end) {
      marched.absolute_displacement = row.subspan(joints_end, 1);
      marched.absolute_velocity = row.subspan(joints_end + 1, 1);
      marched.absolute_acceleration = row.subspan(joints_end + 2, 1);
    }
    table.add(marched, edges);
  }
  table.finish(march.march);
}

}  // namespace microslip
