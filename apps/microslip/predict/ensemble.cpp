// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "arguments/command.hpp"
#include "arguments/option_names.hpp"
#include "arguments/printed_text.hpp"
#include "arguments/progress_bar.hpp"
#include "arguments/recording_arguments.hpp"
#include "microslip/base/error.hpp"
#include "microslip/ensemble/ensemble_run.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/quantity_text.hpp"

namespace microslip::app {
namespace {

constexpr std::uint64_t kMostThreads = 4096;

struct EnsembleArguments {
  std::string plan;
  std::string out;
  std::string table;
  std::string shard;
  std::string threads;
  bool merge = false;
  bool keep_journals = false;
};

/// "result.csv" of "result.h5".
std::string table_beside(const std::string& out) {
  return std::filesystem::path(out).replace_extension(".csv").string();
}

EnsembleRun run_of(const EnsembleArguments& arguments, const Call& call) {
  if (arguments.out == "-") {
    throw InputError("--out", "'-'", "must be a file: HDF5 has no stream");
  }
  EnsembleRun run{.plan = arguments.plan,
                  .out = arguments.out,
                  .table = arguments.table.empty() ? table_beside(arguments.out) : arguments.table,
                  .merge = arguments.merge,
                  .keep_journals = arguments.keep_journals,
                  .command = call.command_line,
                  .progress = progress_bar("jobs", call.quiet)};
  if (!call.quiet) run.warned = [](const Warning& warning) { show_warnings({warning}); };
  if (arguments.shard.empty()) return run;
  try {
    run.shard = EnsembleShard::parse(arguments.shard);
  } catch (const InputError& error) {
    throw error.renamed("--shard");
  }
  return run;
}

int run(const EnsembleArguments& arguments, const Call& call) {
  const EnsembleRun run = run_of(arguments, call);
  const std::size_t threads =
      arguments.threads.empty()
          ? 0
          : parse_whole_number("--threads", arguments.threads, 1, kMostThreads);
  const std::unique_ptr<Team> team = call.make_team(threads);
  const std::optional<FinishedEnsemble> done = run_ensemble(run, *team);
  if (done && !call.quiet) {
    print_text(stdout, with_option_names(describe_ensemble(run, *done)) +
                           describe_warnings(done->warnings));
  }
  return kDone;
}

}  // namespace

void add_ensemble(CLI::App& program, Call& call) {
  auto arguments = std::make_shared<EnsembleArguments>();
  CLI::App* command = program.add_subcommand(
      "ensemble",
      "Any number of predictions, identifications or virtual tests of a plan, on all processors");
  command
      ->add_option("plan", arguments->plan,
                   "Plan of the jobs, plan.toml: kind predict, bootstrap, design or sweep")
      ->required()
      ->type_name(kTomlValue);
  command
      ->add_option("--out", arguments->out,
                   "HDF5 to write: count, mean, std, minimum, lower, median, upper, maximum of "
                   "each output, and values that the plan keeps. Until it is complete, finished "
                   "jobs are kept in journals next to it, from which a new run continues")
      ->required()
      ->type_name(kHdf5Value);
  command
      ->add_option("--table", arguments->table,
                   "CSV to write: the same statistics; for a sweep its values. Default: the name "
                   "of --out with .csv")
      ->type_name(kCsvValue);
  CLI::Option* shard = command->add_option("--shard", arguments->shard,
                                           "NUMBER/COUNT: run only this share of the jobs, without "
                                           "the result, for job arrays; then --merge");
  command
      ->add_flag("--merge", arguments->merge,
                 "Write the result from the finished shards; an error if jobs are missing")
      ->excludes(shard);
  command->add_option("--threads", arguments->threads,
                      "Maximum number of threads; default: all processors, 1 per MPI rank");
  command->add_flag("--keep-journals", arguments->keep_journals,
                    "Keep the journals: other values or another confidence can then be written "
                    "without repeating jobs");
  command->add_flag("--quiet", call.quiet, "No summary, no progress");
  add_examples(*command,
               {"microslip ensemble plan.toml --out result.h5",
                "microslip ensemble plan.toml --out result.h5 --shard 3/20   # each of 20 jobs",
                "microslip ensemble plan.toml --out result.h5 --merge        # then",
                "mpirun -n 64 microslip-mpi ensemble plan.toml --out result.h5"});
  command->callback(
      [arguments, &call] { call.run = [arguments, &call] { return run(*arguments, call); }; });
}

}  // namespace microslip::app
