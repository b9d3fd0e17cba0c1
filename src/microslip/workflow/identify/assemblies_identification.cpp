// SPDX-License-Identifier: MIT
#include "microslip/workflow/identify/assemblies_identification.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/percent.hpp"
#include "microslip/base/version.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/workflow/identify/assembly_tables.hpp"
#include "microslip/workflow/identify/found_joint.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

std::string assemblies_file(const AssembliesIdentification& options, const std::string& name) {
  return (std::filesystem::path(options.out) / name).string();
}

/// In the order in which compose_assemblies() fills them.
std::vector<ResultFile> assemblies_files(const AssembliesIdentification& options,
                                         const std::vector<Assembly>& assemblies) {
  std::vector<ResultFile> files{{assemblies_file(options, "joint.json"), kJointKind},
                                {assemblies_file(options, "joint_samples.h5"), kSamplesKind},
                                {assemblies_file(options, "assemblies.csv"), kAssembliesKind},
                                {assemblies_file(options, "densities.csv"), kDensitiesKind}};
  for (const Assembly& one : assemblies) {
    files.push_back({assemblies_file(options, "assembly_" + one.name + ".json"), kJointKind});
  }
  return files;
}

void check_assemblies_folder(const AssembliesIdentification& options,
                             const std::vector<ResultFile>& files) {
  if (options.out.empty() || options.out == "-") {
    throw InputError("out", in_quotes(options.out), "must be a folder with several assemblies",
                     "Name it.");
  }
  check_inputs_kept(options.out, files, options.levels);
}

Provenance assemblies_provenance(const AssembliesIdentification& options,
                                 const IdentifiedAssemblies& done) {
  Provenance provenance;
  provenance.version = kVersion;
  provenance.command = options.command;
  provenance.inputs = done.read.inputs;
  provenance.options.emplace_back("assemblies",
                                  options.by == AssembliesBy::kFiles ? "files" : "column");
  provenance.options.emplace_back("samples", static_cast<double>(options.options.draws));
  provenance.options.emplace_back("inner_reversals",
                                  options.use_inner_reversals ? "use" : "leave-out");
  provenance.seed = options.options.seed;
  return provenance;
}

std::string assemblies_comment(const AssembliesIdentification& options,
                               const IdentifiedAssemblies& done) {
  std::string comment = heading_of(options.command);
  for (const InputHash& input : done.read.inputs) {
    comment += '\n' + hash_comment(input.file, input.sha256);
  }
  return with_warnings(std::move(comment), done.found.warnings);
}

std::string commented_assembly_table(CsvWriter table, const std::string& comment) {
  table.add_comment(comment);
  return table.str();
}

void compose_assemblies(const AssembliesIdentification& options, IdentifiedAssemblies& done) {
  const Provenance provenance = assemblies_provenance(options, done);
  const std::string comment = assemblies_comment(options, done);
  auto file = done.files.begin();
  (file++)->content = format_joint(joint_file_of(found_joint(done.found), provenance));
  file->content = joint_samples_bytes(samples_of_next(done.found, provenance), file->path);
  ++file;
  (file++)->content = commented_assembly_table(assemblies_table(done.found, done.read), comment);
  (file++)->content = commented_assembly_table(densities_table(done.found), comment);
  for (std::size_t j = 0; j < done.found.assemblies.size(); ++j) {
    (file++)->content = format_joint(joint_file_of(found_joint(done.found, j), provenance));
  }
}

std::string assembly_spread_line(std::string_view name, const Spread& spread) {
  return line(name, fmt::format("{}, from {} to {}", percent_text(spread.median),
                                percent_text(spread.lower), percent_text(spread.upper)));
}

std::string describe_assembly(const AssemblyFit& fit, std::size_t count) {
  return line("assembly", shortened(fit.name, 56)) +
         line("", fmt::format("{}, k {:.5g} N/m, slip forces times {:.3g} ({:.3g} to {:.3g}), "
                              "shape {}",
                              counted(count, "level"), fit.stiffness.value,
                              fit.slip_force_scale.value, fit.slip_force_scale.lower,
                              fit.slip_force_scale.upper, percent_text(fit.shape.value)));
}

}  // namespace

IdentifiedAssemblies read_assemblies(const AssembliesIdentification& options) {
  IdentifiedAssemblies done;
  done.read = read_assembly_levels(options.levels, options.by, options.use_inner_reversals);
  check_assemblies(done.read.assemblies, options.stiffness);
  done.files = assemblies_files(options, done.read.assemblies);
  check_assemblies_folder(options, done.files);
  return done;
}

void identify_read_assemblies(const AssembliesIdentification& options, IdentifiedAssemblies& done) {
  done.found = identify_assemblies(done.read.assemblies, options.stiffness, options.options);
  done.found.warnings.insert(done.found.warnings.begin(), done.read.warnings.begin(),
                             done.read.warnings.end());
  compose_assemblies(options, done);
}

std::string describe_assemblies(const AssembliesIdentification& options,
                                const IdentifiedAssemblies& done) {
  const AssembliesResult& found = done.found;
  std::string text = describe_ending(found.summary);
  for (std::size_t j = 0; j < found.assemblies.size(); ++j) {
    text += describe_assembly(found.assemblies[j], done.read.count[j]);
  }
  text += line("mean assembly",
               fmt::format("k {:.5g} N/m, slipping fraction {} up to {:.3g} N", found.stiffness,
                           percent_text(1.0 - found.joint().density().elastic_remainder()),
                           found.covered_to));
  if (found.stiffness_spread) text += assembly_spread_line("spread of k", *found.stiffness_spread);
  text += assembly_spread_line("spread of slip force", found.slip_force_spread) +
          assembly_spread_line("spread of shape", found.shape_spread) +
          line("next assembly", fmt::format("{} in {}", counted(found.draws.size(), "draw"),
                                            assemblies_file(options, "joint_samples.h5")));
  text += line("", found.scatter_is_relative
                       ? fmt::format("D scatters by {}", percent_text(found.scatter))
                       : fmt::format("D scatters by {:.2f} times the given standard deviations",
                                     found.scatter));
  return text + describe_warnings(found.warnings);
}

}  // namespace microslip
