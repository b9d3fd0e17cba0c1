// SPDX-License-Identifier: MIT

#include <benchmark/benchmark.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "microslip/documents/levels/levels_file.hpp"
#include "microslip/documents/study/journal_file.hpp"
#include "microslip/ensemble/ensemble_jobs.hpp"
#include "microslip/ensemble/team.hpp"
#include "microslip/io/output/output_files.hpp"
#include "support/densities.hpp"

namespace microslip::bench {
namespace {

/// A folder that goes with it.
class Folder {
 public:
  Folder() { std::filesystem::create_directories(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() / "microslip-bench-ensemble";
};

/// Bootstrap identifications of the 90 levels of identify_90_levels, one after the other.
void ensemble_bootstrap(benchmark::State& state) {
  const Folder folder;
  write_file(folder.file("levels.csv"),
             levels_table(testing::noisy_levels(testing::reference_joint(), 2)).str());
  const std::unique_ptr<const EnsembleJobs> jobs = make_ensemble_jobs(parse_ensemble_plan(
      "schema = \"microslip.ensemble/1\"\nkind = \"bootstrap\"\n[bootstrap]\nlevels = "
      "\"levels.csv\"\nstiffness_N_per_m = 1.7e5\ncount = 1000000\nresample = \"residuals\"\n",
      folder.file("plan.toml")));
  std::uint64_t job = 0;
  for (auto _ : state) {
    const JobResult result = jobs->run(0, job++);
    benchmark::DoNotOptimize(result.values.data());
  }
  state.counters["identifications"] =
      benchmark::Counter(static_cast<double>(job), benchmark::Counter::kIsRate);
}
BENCHMARK(ensemble_bootstrap)->Unit(benchmark::kMillisecond);

/// Overhead of a job: a thousand blocks of 256 jobs of 6 values, which take no time, dealt and
/// written to a journal.
void ensemble_overhead(benchmark::State& state) {
  const Folder folder;
  constexpr std::size_t kBlocks = 1000;
  constexpr std::size_t kJobs = 256;
  std::vector<std::uint64_t> blocks(kBlocks);
  std::iota(blocks.begin(), blocks.end(), 0);
  std::size_t jobs = 0;
  for (auto _ : state) {
    state.PauseTiming();
    std::filesystem::remove(folder.file("r.journal"));
    state.ResumeTiming();
    JournalWriter journal(folder.file("r.journal"), "of a benchmark\n");
    LocalTeam team(Execution::serial());
    team.deal(
        blocks,
        [](std::uint64_t, const std::function<void()>&) { return std::string(kJobs * 49, 'x'); },
        [&](std::uint64_t block, const std::string& done) {
          journal.append(block, done);
          return true;
        });
    jobs += kBlocks * kJobs;
  }
  state.counters["jobs"] =
      benchmark::Counter(static_cast<double>(jobs), benchmark::Counter::kIsRate);
}
BENCHMARK(ensemble_overhead)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace microslip::bench
