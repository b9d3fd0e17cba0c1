// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "arguments/command.hpp"
#include "arguments/printed_text.hpp"
#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/io/output/provenance.hpp"
#include "microslip/io/tables/csv.hpp"
#include "microslip/signal/shock/response_spectrum.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

struct SpectrumOptions {
  std::string table;
  std::string out;
  std::string column = "absolute_acceleration";
  std::string frequency;
  std::string damping_ratio = "0.05";
};

int run(const SpectrumOptions& options, const Call& call) {
  check_output(options.out, kSpectrumKind);
  const std::vector<double> frequency = parse_range("--frequency", options.frequency, kFrequency);
  const double damping = parse_quantity("--damping-ratio", options.damping_ratio, kDimensionless);
  const CsvTable table(read_text(options.table), input_name(options.table));
  const std::vector<double> time = table.numbers("time", kTime);
  const std::vector<double> acceleration = table.numbers(options.column, kAcceleration);
  const ResponseSpectrum spectrum = response_spectrum(time, acceleration, frequency, damping);
  CsvWriter out;
  out.add_comment(heading_of(call.command_line));
  out.add_comment(fmt::format("shock response spectrum of '{}', damping ratio {:g} (Q {:.4g})",
                              options.column, damping, 0.5 / damping));
  out.add_numbers("frequency", kFrequency, spectrum.frequency);
  out.add_numbers("maximax", kAcceleration, spectrum.maximax());
  out.add_numbers("positive", kAcceleration, spectrum.positive);
  out.add_numbers("negative", kAcceleration, spectrum.negative);
  out.add_numbers("relative_displacement", kLength, spectrum.displacement);
  write_file(options.out, out.str());
  if (call.quiet) return kDone;
  const std::vector<double> maximax = spectrum.maximax();
  const auto most = std::ranges::max_element(maximax);
  print_text(
      options.out == "-" ? stderr : stdout,
      fmt::format(
          "Shock response spectrum of '{}'\n  largest              {:.5g} m/s^2 at {:.5g} Hz\n",
          options.column, *most,
          spectrum.frequency[static_cast<std::size_t>(most - maximax.begin())]));
  return kDone;
}

}  // namespace

void add_spectrum(CLI::App& program, Call& call) {
  auto options = std::make_shared<SpectrumOptions>();
  CLI::App* command =
      program.add_subcommand("spectrum", "Shock response spectrum of an acceleration history");
  command
      ->add_option("table", options->table,
                   "Table of march or load: time [s] and an acceleration; - is standard input")
      ->required()
      ->type_name(kCsvValue);
  command
      ->add_option(
          "--column", options->column,
          "Column of the acceleration, for instance acceleration, or 'acceleration of table'")
      ->capture_default_str();
  command
      ->add_option("--frequency", options->frequency,
                   "Natural frequencies, FROM:TO:COUNT[:log], in Hz or with units; :log for equal "
                   "ratios")
      ->required();
  command
      ->add_option("--damping-ratio", options->damping_ratio,
                   "Damping ratio of the oscillators: 1/(2Q)")
      ->capture_default_str();
  command
      ->add_option("--out", options->out,
                   "CSV to write: frequency [Hz], maximax [m/s^2], positive [m/s^2], negative "
                   "[m/s^2], relative_displacement [m]; - is standard output")
      ->required()
      ->type_name(kCsvValue);
  command->add_flag("--quiet", call.quiet, "No summary");
  add_examples(*command,
               {"microslip spectrum march.csv --frequency 10:2000:200:log --out srs.csv",
                "microslip spectrum shock.csv --column 'acceleration of table' \\",
                "          --frequency 10:2000:200:log --damping-ratio 0.02 --out srs.csv"});
  command->callback(
      [options, &call] { call.run = [options, &call] { return run(*options, call); }; });
}

}  // namespace microslip::app
