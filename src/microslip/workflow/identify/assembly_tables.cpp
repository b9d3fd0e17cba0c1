// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/assembly_tables.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "microslip/base/units.hpp"

namespace microslip {
namespace {

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
