// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "demo/demo_beam.hpp"
#include "demo/demo_folder.hpp"
#include "demo/demo_rig.hpp"
#include "demo/demo_rig_report.hpp"
#include "microslip/base/error.hpp"
#include "microslip/workflow/identify/identification_text.hpp"

namespace microslip::app {
namespace {

constexpr std::string_view kBeamHeading =
    "BRAKE-REUSS BEAM: eight measured levels of a real bolted joint\n"
    "Amplitude and dissipation are those of the drive point, so the joint below is an equivalent "
    "one\n"
    "between drive point and ground, with linear damping in parallel. k is the stiffness of the "
    "first "
    "bending\n"
    "mode at the drive point: modal mass 1.99 kg times (2 pi 80.38 Hz)^2, the mass from the slope "
    "of\n"
    "Re(force/displacement) over frequency squared in the lowest sweep. Another k scales slip "
    "forces\n"
    "with k and the density with 1/k^2 (examples/brake_reuss_beam/README.md).\n\n";

constexpr std::string_view kRigHeading =
    "REFERENCE RIG: the whole chain with a known joint\n"
    "A virtual test at {} levels from 30 mg to 4 g, with shaker, force control and noise; its "
    "records "
    "reduced\n"
    "to levels; the joint identified from them; the records predicted by that joint.\n\n";

struct DemoOptions {
  std::string out = "microslip-demo";
};

int run(const DemoOptions& options, const Call& call) {
  if (options.out.empty() || options.out == "-") {
    throw InputError("--out", "'" + options.out + "'", "must be a folder",
                     "Some hundred files are written to it.");
  }
  DemoFolder folder(options.out, call);
  const Identification beam = demonstrate_beam(folder);
  const RigDemonstration rig = demonstrate_rig(folder);
  const std::vector<std::string> pictures = folder.commit();
  if (!call.quiet) {
    print_text(stdout, fmt::format("{}{}\n", kBeamHeading,
                                   describe_identification(
                                       beam, beam.inversion()->fitted_dissipation.size())));
    print_text(stdout, fmt::format(kRigHeading, rig.test.levels.size()));
    print_text(stdout, fmt::format("{}\n{}\n",
                                   describe_identification(
                                       rig.found, rig.found.inversion()->fitted_dissipation.size()),
                                   describe_rig(rig)));
    print_text(
        stdout,
        fmt::format(
            "Written to {}: recordings, levels, truth, verification and densities (csv), joints "
            "(json), "
            "the\nrig (toml), pictures (svg, png):\n",
            options.out));
    for (const std::string& name : pictures) print_text(stdout, fmt::format("  {}.svg\n", name));
    // The rig comes last, and first for the reader.
    std::vector<std::string> reports = folder.report_paths();
    std::ranges::reverse(reports);
    print_text(stdout, "\nReports, each one file to open in a browser:\n");
    for (const std::string& path : reports) print_text(stdout, fmt::format("  {}\n", path));
  }
  return beam.summary.converged() && rig.converged() ? kDone : kNotConverged;
}

}  // namespace

void add_demo(CLI::App& program, Call& call) {
  auto options = std::make_shared<DemoOptions>();
  CLI::App* command = program.add_subcommand(
      "demo",
      "The whole chain on a rig whose joint is known and on a measured bolted beam, with pictures");
  command->add_option("--out", options->out, "Folder for the results; created if missing")
      ->type_name(kFolderValue)
      ->capture_default_str();
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip demo --out demo"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
