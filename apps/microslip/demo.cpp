// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "command.hpp"
#include "demo_data.hpp"
#include "demo_figures.hpp"
#include "demo_recordings.hpp"
#include "identification_report.hpp"
#include "microslip/base/error.hpp"
#include "microslip/base/random.hpp"
#include "microslip/base/version.hpp"
#include "microslip/identify/identification.hpp"
#include "microslip/io/density_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/levels_file.hpp"
#include "microslip/io/output_files.hpp"
#include "microslip/io/reduction_file.hpp"
#include "microslip/io/sha256.hpp"
#include "microslip/joint/dissipation.hpp"
#include "microslip/report/gnuplot.hpp"
#include "microslip/rig/reduction.hpp"
#include "microslip/rig/reduction_batch.hpp"
#include "progress_bar.hpp"
#include "reduction_report.hpp"

namespace microslip::app {
namespace {

// Modal stiffness of the Brake-Reuss beam at its drive point; how it was found stands in
// examples/brake_reuss_beam/README.md.
constexpr double kBrakeReussStiffness = 5.08e5;  // N/m
constexpr std::size_t kBandSamples = 1000;
constexpr std::uint64_t kSeed = 1;
constexpr double kNoise = 0.01;  // relative, of each D

constexpr std::string_view kBeamHeading =
    "BRAKE-REUSS BEAM: eight measured levels of a real bolted joint\n"
    "Amplitude and dissipation are those of the drive point, so the joint below is an equivalent "
    "one\n"
    "between drive point and ground, linear damping beside it. k is the stiffness of the first "
    "bending\n"
    "mode at the drive point: modal mass 1.99 kg times (2 pi 80.38 Hz)^2, the mass from the slope "
    "of\n"
    "Re(force/displacement) over frequency squared in the lowest sweep. Another k scales slip "
    "forces\n"
    "with k and the density with 1/k^2 (examples/brake_reuss_beam/README.md).\n\n";

constexpr std::string_view kReferenceHeading =
    "REFERENCE JOINT: 90 levels with 1 % noise from a joint whose density is known\n\n";

constexpr std::string_view kRigHeading =
    "REFERENCE RIG: recordings of force, acceleration and joint displacement at 12 levels\n\n";

void print_error(double error) {
  fmt::print("  {:<20} {:.1f} % (relative L2 over 5 to 95 % of the range)\n\n", "density error",
             100.0 * error);
}

struct DemoOptions {
  std::string out = "microslip-demo";
};

/// Everything that goes into the folder, written at once at the end.
class DemoFolder {
 public:
  DemoFolder(std::string path, const Call& call) : path_(std::move(path)), call_(call) {}

  void add(const std::string& name, std::string content) {
    files_.emplace_back(name, std::move(content));
  }

  void add_identification(const std::string& prefix, const Identification& found,
                          const std::string& input_name, std::string_view input) {
    Provenance provenance;
    provenance.version = kVersion;
    provenance.command = call_.command_line;
    provenance.inputs.push_back({input_name, sha256(input)});
    provenance.seed = kSeed;
    add(prefix + "_joint.json", format_joint({found.joint, provenance, record_of(found)}));
    add(prefix + "_density.csv", density_table(density_table_of(found)).str());
  }

  template <typename Picture>
  void draw_both(const std::string& name, const Picture& picture, PictureSize size) {
    add(name + ".svg", draw(picture, PictureFormat::kSvg, size));
    add(name + ".png", draw(picture, PictureFormat::kPng, size));
    pictures_.push_back(name);
  }

  /// @return the names of the pictures, without ending.
  std::vector<std::string> commit() {
    std::error_code error;
    std::filesystem::create_directories(path_, error);
    if (error) throw FileError(path_, error.message(), "Choose another folder with --out.");
    OutputFiles outputs;
    for (const auto& [name, content] : files_) outputs.add(path_ + "/" + name, content);
    outputs.commit();
    return pictures_;
  }

 private:
  std::string path_;
  const Call& call_;
  std::vector<std::pair<std::string, std::string>> files_;  // name and content
  std::vector<std::string> pictures_;
};

IdentificationOptions with_bands(double stiffness, bool quiet) {
  IdentificationOptions options;
  options.inversion.stiffness = stiffness;
  options.bands =
      BandOptions{.samples = kBandSamples, .seed = kSeed, .progress = progress_bar("bands", quiet)};
  return options;
}

/// A measured joint: eight levels of a bolted beam, with the linear damping still in them.
Identification brake_reuss_beam(DemoFolder& folder, const Call& call) {
  const LevelsFile file =
      parse_levels(std::string(kBrakeReussLevels), "examples/brake_reuss_beam/levels.csv");
  IdentificationOptions options = with_bands(kBrakeReussStiffness, call.quiet);
  options.inversion.linear_damping = true;
  Identification found = identify(file.levels, options);
  folder.add_identification("brake_reuss_beam", found, file.file, kBrakeReussLevels);
  folder.draw_both("brake_reuss_beam_dissipation",
                   dissipation_figure("Brake–Reuß beam: dissipation", file.levels, found), {});
  folder.draw_both("brake_reuss_beam_density",
                   density_figure("Brake–Reuß beam: slip-force density", found, nullptr), {});
  return found;
}

/// 90 levels as in the published experiment, with noise on each D.
Levels noisy_levels(const Joint& truth) {
  constexpr std::size_t kLevels = 90;
  constexpr double kLowest = 2.13e-6;  // m, at 30 mg
  constexpr double kHighest = 3.0e-4;  // m, at 4 g
  RandomStream random(kSeed, 0);
  Levels levels;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kLevels - 1);
    const double amplitude = kLowest + (kHighest - kLowest) * share;
    levels.amplitude.push_back(amplitude);
    levels.dissipation.push_back(dissipation(truth, amplitude) * (1.0 + kNoise * random.normal()));
  }
  return levels;
}

/// ‖φ − truth‖/‖truth‖ over 5 to 95 % of the range.
double density_error(const Identification& found, const Joint& truth) {
  double difference = 0.0;
  double size = 0.0;
  for (double share = 0.05; share <= 0.95; share += 0.0005) {
    const double f = share * found.covered_to;
    const double expected = truth.density().density(f);
    difference += std::pow(found.joint.density().density(f) - expected, 2);
    size += expected * expected;
  }
  return std::sqrt(difference / size);
}

/// Spline densities over a range of smoothing factors around that of cross-validation, and the
/// density of the inversion. [AR14 Fig. 10]
std::vector<NamedJoint> regenerated_joints(const Levels& levels, double stiffness,
                                           const Joint& by_inversion) {
  constexpr double kMillimetre = 1e-3;
  std::vector<NamedJoint> joints;
  for (const double p : {0.9999, 0.99999, 0.999999}) {
    IdentificationOptions options;
    options.method = IdentificationMethod::kSpline;
    options.inversion.stiffness = stiffness;
    options.spline_smoothing = MatlabP{p, kMillimetre};
    joints.push_back({fmt::format("spline, p = {}", p), identify(levels, options).joint});
  }
  joints.push_back({"inversion", by_inversion});
  return joints;
}

/// What the demonstration says of a joint whose density is known.
struct ReferenceOutcome {
  Identification found;
  double error;
};

/// The same chain where the truth is known.
ReferenceOutcome reference_joint(DemoFolder& folder, const Call& call) {
  const Joint truth = parse_joint(kReferenceJoint, "examples/reference_joint/joint.json").joint;
  const Levels levels = noisy_levels(truth);
  const std::string levels_text = levels_table(levels).str();
  folder.add("reference_joint_levels.csv", levels_text);
  Identification found = identify(levels, with_bands(truth.stiffness(), call.quiet));
  folder.add_identification("reference_joint", found, "reference_joint_levels.csv", levels_text);
  folder.draw_both("reference_joint_dissipation",
                   dissipation_figure("Reference joint: dissipation, 1 % noise", levels, found),
                   {});
  folder.draw_both("reference_joint_density",
                   density_figure("Reference joint: slip-force density", found, &truth), {});
  const FigureGrid loops = loops_figure(
      "Loops for several smoothing factors p of the spline (A in mm), and by the inversion",
      levels.amplitude.back(), {"truth", truth},
      regenerated_joints(levels, truth.stiffness(), found.joint));
  folder.draw_both("reference_joint_loops", loops, {1100, 480});
  const double error = density_error(found, truth);
  return {std::move(found), error};
}

struct RigOutcome {
  ReductionBatch batch;
  Identification found;
  double error;
};

/// From recordings of a test whose joint is known to its density: the joint displacement is that of
/// the vibrometer, the levels' standard deviations are those of the cycles.
RigOutcome reference_rig(DemoFolder& folder, const Reducer& reducer, const Call& call) {
  const Joint truth = parse_joint(kReferenceJoint, "examples/reference_joint/joint.json").joint;
  const std::vector<Recording> recordings = demo_recordings(reducer.rig());
  ReductionBatch batch = reduce_batch(reducer, recordings.size(), [&](std::size_t i) {
    return std::vector<Recording>{recordings[i]};
  });
  const std::string levels_text = reduction_table(batch.levels).str();
  folder.add("reference_rig_levels.csv", levels_text);
  const LevelsFile file = parse_levels(levels_text, "reference_rig_levels.csv");
  Identification found = identify(file.levels, with_bands(truth.stiffness(), call.quiet));
  folder.add_identification("reference_rig", found, file.file, levels_text);
  folder.draw_both(
      "reference_rig_dissipation",
      dissipation_figure("Reference rig: dissipation from recordings", file.levels, found), {});
  folder.draw_both(
      "reference_rig_density",
      density_figure("Reference rig: slip-force density from recordings", found, &truth), {});
  const double error = density_error(found, truth);
  return {std::move(batch), std::move(found), error};
}

int run(const DemoOptions& options, const Call& call) {
  if (options.out.empty() || options.out == "-") {
    throw InputError("--out", "'" + options.out + "'", "must be a folder",
                     "It gets some twenty files.");
  }
  DemoFolder folder(options.out, call);
  const Identification beam = brake_reuss_beam(folder, call);
  const ReferenceOutcome reference = reference_joint(folder, call);
  const Reducer reducer(demo_rig());
  const RigOutcome rig = reference_rig(folder, reducer, call);
  const std::vector<std::string> pictures = folder.commit();
  if (!call.quiet) {
    fmt::print("{}{}\n", kBeamHeading, describe(beam, beam.inversion->levels.size()));
    fmt::print("{}{}", kReferenceHeading,
               describe(reference.found, reference.found.inversion->levels.size()));
    print_error(reference.error);
    fmt::print("{}{}\n{}", kRigHeading, describe_reduction(reducer, rig.batch),
               describe(rig.found, rig.found.inversion->levels.size()));
    print_error(rig.error);
    fmt::print("Written to {}: joints (json), levels and densities (csv), pictures (svg, png):\n",
               options.out);
    for (const std::string& name : pictures) fmt::print("  {}.svg\n", name);
  }
  const bool converged = beam.summary.converged() && reference.found.summary.converged() &&
                         rig.found.summary.converged();
  return converged ? kDone : kNotConverged;
}

}  // namespace

void add_demo(CLI::App& program, Call& call) {
  auto options = std::make_shared<DemoOptions>();
  CLI::App* command = program.add_subcommand(
      "demo",
      "From levels and recordings to joints: a measured bolt and known joints, with pictures");
  command->add_option("--out", options->out, "Folder for the results; made if it is not there")
      ->capture_default_str();
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command, {"microslip demo --out demo"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
