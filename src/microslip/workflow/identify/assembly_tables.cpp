// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/assembly_tables.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"
#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/identify/posterior/spread_prior.hpp"
#include "microslip/io/config/named_value_access.hpp"

namespace microslip {
namespace {

constexpr std::string_view kAssembliesMethod = "assemblies";

std::string_view origin_of_stiffness(AssemblyStiffness from) {
  switch (from) {
    case AssemblyStiffness::kGiven:
      return "given";
    case AssemblyStiffness::kSought:
      return "secant_stiffness";
    case AssemblyStiffness::kCommon:
      break;
  }
  return "common";
}

void add_assembly_spread(const std::string& name, const Spread& spread, NamedValues& record) {
  record.emplace_back(name, spread.median);
  record.emplace_back("band_" + name, std::vector<double>{spread.lower, spread.upper});
}

void add_assembly_band(const AssembliesResult& found, const BandedDensity& density,
                       double covered_to, NamedValues& record) {
  std::vector<double> slip_force;
  std::vector<double> lower;
  std::vector<double> upper;
  for (std::size_t i = 0; i < found.slip_force.size() && found.slip_force[i] <= covered_to; ++i) {
    slip_force.push_back(found.slip_force[i]);
    lower.push_back(density.lower[i]);
    upper.push_back(density.upper[i]);
  }
  record.emplace_back("band_samples", static_cast<double>(found.draws.size()));
  record.emplace_back("band_confidence", found.confidence);
  record.emplace_back("band_slip_force_N", std::move(slip_force));
  record.emplace_back("band_lower_per_N", std::move(lower));
  record.emplace_back("band_upper_per_N", std::move(upper));
}

template <typename Read>
std::vector<double> of_assembly_fits(const AssembliesResult& found, const Read& read) {
  std::vector<double> values;
  for (const AssemblyFit& fit : found.assemblies) values.push_back(read(fit));
  return values;
}

void add_assembly_estimates(const AssembliesResult& found, const std::string& name,
                            const Dimension& dimension, Estimate AssemblyFit::*estimate,
                            CsvWriter& table) {
  const auto add = [&](const std::string& column, double Estimate::*part) {
    table.add_numbers(column, dimension, of_assembly_fits(found, [&](const AssemblyFit& fit) {
                        return fit.*estimate.*part;
                      }));
  };
  add(name, &Estimate::value);
  add(name + "_lower", &Estimate::lower);
  add(name + "_upper", &Estimate::upper);
}

/// Columns of densities.csv.
struct AssemblyDensityColumns {
  std::vector<std::string> assembly;
  std::vector<double> slip_force;
  std::vector<double> density;
  std::vector<double> lower;
  std::vector<double> upper;

  void add(const std::string& name, const std::vector<double>& at, const BandedDensity& values,
           double to) {
    for (std::size_t i = 0; i < at.size() && at[i] <= to; ++i) {
      assembly.push_back(name);
      slip_force.push_back(at[i]);
      density.push_back(values.density[i]);
      lower.push_back(values.lower[i]);
      upper.push_back(values.upper[i]);
    }
  }
};

}  // namespace

NamedValues record_of_assemblies(const AssembliesResult& found) {
  NamedValues record;
  record.emplace_back("status", std::string(found.summary.status()));
  record.emplace_back("method", std::string(kAssembliesMethod));
  std::vector<std::string> names;
  for (const AssemblyFit& fit : found.assemblies) names.push_back(fit.name);
  record.emplace_back("assembly", list_of_texts(names));
  record.emplace_back("stiffness_from", std::string(origin_of_stiffness(found.stiffness_from)));
  if (found.stiffness_spread)
    add_assembly_spread("stiffness_spread", *found.stiffness_spread, record);
  add_assembly_spread("slip_force_spread", found.slip_force_spread, record);
  add_assembly_spread("shape_spread", found.shape_spread, record);
  record.emplace_back("spread_prior_from", SpreadPrior::kNone);
  record.emplace_back("spread_prior_to", SpreadPrior::kUsual);
  record.emplace_back("effective_draws", found.effective_draws);
  record.emplace_back("scatter", found.scatter);
  record.emplace_back("scatter_of", found.scatter_is_relative ? "dissipation" : "dissipation_std");
  record.emplace_back("covered_from_N", found.covered_from);
  record.emplace_back("covered_to_N", found.covered_to);
  add_assembly_band(found, found.common, found.covered_to, record);
  add_warnings(found.warnings, record);
  return record;
}

NamedValues record_of_assembly(const AssembliesResult& found, std::size_t assembly) {
  const AssemblyFit& fit = found.assemblies.at(assembly);
  NamedValues record;
  const auto add = [&](const std::string& name, const Estimate& value) {
    record.emplace_back(name, value.value);
    record.emplace_back("band_" + name, std::vector<double>{value.lower, value.upper});
  };
  record.emplace_back("status", std::string(found.summary.status()));
  record.emplace_back("method", std::string(kAssembliesMethod));
  record.emplace_back("assembly", fit.name);
  record.emplace_back("stiffness_from", std::string(origin_of_stiffness(found.stiffness_from)));
  add("stiffness_N_per_m", fit.stiffness);
  add("slip_force_scale", fit.slip_force_scale);
  add("shape", fit.shape);
  record.emplace_back("covered_from_N", fit.covered_from);
  record.emplace_back("covered_to_N", fit.covered_to);
  add_assembly_band(found, fit.density, fit.covered_to, record);
  add_warnings(found.warnings, record);
  return record;
}

CsvWriter assemblies_table(const AssembliesResult& found, const AssemblyLevels& read) {
  CsvWriter table;
  std::vector<std::string> names;
  for (const AssemblyFit& fit : found.assemblies) names.push_back(fit.name);
  table.add_text("assembly", names);
  table.add_numbers("levels", kDimensionless,
                    std::vector<double>(read.count.begin(), read.count.end()));
  add_assembly_estimates(found, "stiffness", kStiffness, &AssemblyFit::stiffness, table);
  add_assembly_estimates(found, "slip_force_scale", kDimensionless, &AssemblyFit::slip_force_scale,
                         table);
  add_assembly_estimates(found, "shape", kDimensionless, &AssemblyFit::shape, table);
  table.add_numbers("covered_from", kForce, of_assembly_fits(found, [](const AssemblyFit& fit) {
                      return fit.covered_from;
                    }));
  table.add_numbers("covered_to", kForce,
                    of_assembly_fits(found, [](const AssemblyFit& fit) { return fit.covered_to; }));
  return table;
}

CsvWriter densities_table(const AssembliesResult& found) {
  AssemblyDensityColumns all;
  all.add(std::string(kCommonDensity), found.slip_force, found.common, found.covered_to);
  all.add(std::string(kNextAssembly), found.slip_force, found.next, found.slip_force.back());
  for (const AssemblyFit& fit : found.assemblies) {
    all.add(fit.name, found.slip_force, fit.density, fit.covered_to);
  }
  CsvWriter table;
  table.add_text("assembly", all.assembly);
  table.add_numbers("slip_force", kForce, all.slip_force);
  table.add_numbers("density", kPerForce, all.density);
  table.add_numbers("lower", kPerForce, all.lower);
  table.add_numbers("upper", kPerForce, all.upper);
  return table;
}

JointSamples samples_of_next(const AssembliesResult& found, const Provenance& provenance) {
  JointSamples samples;
  samples.method = "the next of several assemblies";
  samples.seed = provenance.seed.value_or(0);
  samples.provenance = provenance;
  samples.slip_displacement = found.slip_displacement;
  for (const AssemblyJoint& draw : found.draws) {
    samples.stiffness.push_back(draw.stiffness);
    samples.stiffness_density.insert(samples.stiffness_density.end(), draw.density.begin(),
                                     draw.density.end());
  }
  return samples;
}

}  // namespace microslip
