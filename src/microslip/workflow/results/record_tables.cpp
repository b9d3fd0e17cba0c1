// SPDX-License-Identifier: MIT
#include "microslip/workflow/results/record_tables.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "microslip/base/units.hpp"

namespace microslip {
namespace {

/// The name without `ending`; nothing where it has none.
std::optional<std::string> stem(const std::string& name, const std::string& ending) {
  const std::string tail = "_" + ending;
  if (!name.ends_with(tail) || name.size() == tail.size()) return std::nullopt;
  return name.substr(0, name.size() - tail.size());
}

/// A pair of columns of a table.
struct PairOfColumns {
  std::string name;
  std::string unit;
  std::vector<double> recorded;
  std::vector<double> other;
  std::vector<double> recorded_std;  // empty where there is no such column
};

std::vector<PairOfColumns> pairs_of(const CsvTable& table, const std::string& recorded,
                                    const std::string& other) {
  std::vector<PairOfColumns> pairs;
  for (const CsvColumn& column : table.columns()) {
    const std::optional<std::string> name = stem(column.name, recorded);
    const std::optional<Unit> unit = find_unit(column.unit.value_or(""));
    if (!name || !unit) continue;
    pairs.push_back({*name, si_unit(unit->dimension), table.numbers(column.name, unit->dimension),
                     table.numbers(*name + "_" + other, unit->dimension),
                     table.numbers_if_present(column.name + "_std", unit->dimension)});
  }
  return pairs;
}

LevelRecord& record_of(std::vector<LevelRecord>& records, const std::string& source) {
  const auto found = std::ranges::find(records, source, &LevelRecord::source);
  if (found != records.end()) return *found;
  return records.emplace_back(LevelRecord{source, {}, {}});
}

}  // namespace

std::vector<LevelRecord> histories_of(const CsvTable& table, const std::string& recorded,
                                      const std::string& other) {
  const std::vector<std::string> source = table.text("source");
  const std::vector<double> time = table.numbers("time", kTime);
  std::vector<LevelRecord> records;
  for (const PairOfColumns& pair : pairs_of(table, recorded, other)) {
    double start = 0.0;
    for (std::size_t i = 0; i < source.size(); ++i) {
      std::vector<SignalPair>& signals = record_of(records, source[i]).signals;
      if (signals.empty() || signals.back().name != pair.name) {
        signals.push_back({pair.name, pair.unit, {}, {}, {}, {}});
      }
      SignalPair& signal = signals.back();
      if (signal.time.empty()) start = time[i];
      signal.time.push_back(time[i] - start);
      signal.other_time.push_back(time[i] - start);
      signal.recorded.push_back(pair.recorded[i]);
      signal.other.push_back(pair.other[i]);
    }
  }
  return records;
}

void add_harmonics(const CsvTable& table, const std::string& recorded, const std::string& other,
                   std::vector<LevelRecord>& records) {
  const std::vector<std::string> source = table.text("source");
  const std::vector<double> harmonic = table.numbers("harmonic", kDimensionless);
  for (const PairOfColumns& pair : pairs_of(table, recorded, other)) {
    for (std::size_t i = 0; i < source.size(); ++i) {
      if (harmonic[i] < 1.0) continue;
      std::vector<HarmonicsPair>& list = record_of(records, source[i]).harmonics;
      if (list.empty() || list.back().name != pair.name) {
        list.push_back({pair.name, pair.unit, {}, {}});
      }
      list.back().recorded.push_back(pair.recorded[i]);
      list.back().other.push_back(pair.other[i]);
      if (!pair.recorded_std.empty()) list.back().recorded_std.push_back(pair.recorded_std[i]);
    }
  }
}

}  // namespace microslip
