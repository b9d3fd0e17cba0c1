// SPDX-License-Identifier: MIT
#include "microslip/ensemble/ensemble_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/base/stopwatch.hpp"
#include "microslip/base/version.hpp"
#include "microslip/ensemble/block_layout.hpp"
#include "microslip/ensemble/column_statistics.hpp"
#include "microslip/ensemble/ensemble_jobs.hpp"
#include "microslip/ensemble/ensemble_journals.hpp"
#include "microslip/ensemble/ensemble_tables.hpp"
#include "microslip/ensemble/grid_effects.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/io/output/output_files.hpp"
#include "microslip/workflow/text/nothing_found.hpp"
#include "microslip/workflow/text/summary_text.hpp"

namespace microslip {
namespace {

/// Between two of these a power cut may cost what was appended.
constexpr double kSecondsBetweenSyncs = 10.0;

/// The inputs of the jobs, one per line.
/// The inputs of the jobs, by paths relative to the plan: the working directory does not matter.
std::vector<InputHash> inputs_of(const EnsemblePlan& plan, const EnsembleJobs& jobs) {
  const std::string folder = plan.file.substr(0, plan.file.rfind('/') + 1);
  std::vector<InputHash> inputs = jobs.inputs();
  for (InputHash& input : inputs) {
    if (input.file.starts_with(folder)) input.file.erase(0, folder.size());
  }
  return inputs;
}

std::vector<std::string> fingerprint_of(const EnsemblePlan& plan, const EnsembleJobs& jobs,
                                        const std::vector<InputHash>& inputs, std::uint64_t block) {
  std::vector<std::string> lines{fmt::format("version = {}", kVersion)};
  lines.insert(lines.end(), plan.settings.begin(), plan.settings.end());
  lines.push_back(fmt::format("jobs of a block = {}", block));
  for (const EnsembleGroup& group : jobs.groups()) {
    lines.push_back(fmt::format("values of {} = {}", group.name, group.width()));
  }
  for (const InputHash& input : inputs) {
    lines.push_back(fmt::format("sha256 of {} = {}", input.file, input.sha256));
  }
  return lines;
}

/// A prepared plan, the same in each process.
struct Prepared {
  EnsemblePlan plan;
  std::unique_ptr<const EnsembleJobs> jobs;
  std::vector<InputHash> inputs;
  std::vector<std::string> fingerprint;
  std::optional<BlockLayout> layout;

  [[nodiscard]] std::string heading() const {
    return fmt::format("{}\n", fmt::join(fingerprint, "\n"));
  }
};

/// A block is dealt as one message.
void check_block(const EnsemblePlan& plan, const EnsembleJobs& jobs, std::uint64_t block) {
  constexpr double kLargestBlock = 1e9;  // bytes
  constexpr double kMostBlocks = 1e7;    // some 40 bytes of memory each
  double jobs_of_all = 0.0;
  for (const EnsembleGroup& group : jobs.groups()) jobs_of_all += static_cast<double>(group.jobs);
  if (jobs_of_all > kMostBlocks * static_cast<double>(block)) {
    throw InputError(fmt::format("{}: block", plan.file), static_cast<double>(block),
                     fmt::format("must be {:g} or more for {:g} jobs",
                                 std::ceil(jobs_of_all / kMostBlocks), jobs_of_all));
  }
  for (const EnsembleGroup& group : jobs.groups()) {
    const double size = 8.0 * static_cast<double>(group.width()) * static_cast<double>(block);
    if (size <= kLargestBlock) continue;
    throw InputError(
        fmt::format("{}: block", plan.file), static_cast<double>(block),
        fmt::format("must be small enough for the values of a block of '{}' to fit in {:g} "
                    "bytes",
                    group.name, kLargestBlock));
  }
}

Prepared prepare(const std::string& path) {
  Prepared prepared;
  prepared.plan = read_ensemble_plan(path);
  prepared.jobs = make_ensemble_jobs(prepared.plan);
  const std::uint64_t block = prepared.plan.block.value_or(usual_block(prepared.jobs->groups()));
  check_block(prepared.plan, *prepared.jobs, block);
  prepared.layout.emplace(prepared.jobs->groups(), block);
  prepared.inputs = inputs_of(prepared.plan, *prepared.jobs);
  prepared.fingerprint = fingerprint_of(prepared.plan, *prepared.jobs, prepared.inputs, block);
  return prepared;
}

/// All processes prepare, or all stop.
Prepared prepare_together(const std::string& path, Team& team) {
  std::optional<Prepared> prepared;
  std::string failure;
  std::exception_ptr thrown;
  try {
    prepared = prepare(path);
  } catch (const Error& error) {
    failure = error.what();
    thrown = std::current_exception();
  }
  team.agree(prepared ? prepared->heading() : "", failure);
  if (thrown) std::rethrow_exception(thrown);
  return *std::move(prepared);
}

std::string work_on(const Prepared& prepared, std::uint64_t block,
                    const std::function<void()>& between_jobs) {
  const JobRange range = prepared.layout->jobs_of(block);
  std::vector<JobResult> results;
  results.reserve(range.count);
  for (std::uint64_t i = 0; i < range.count; ++i) {
    results.push_back(prepared.jobs->run(range.group, range.first + i));
    between_jobs();
  }
  return block_bytes(results);
}

std::uint64_t failures_in(const std::vector<JobResult>& results) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(results, [](const JobResult& r) { return !r.failure.empty(); }));
}

void add_failure(FailedJobs& failed, const std::string& reason, std::uint64_t job) {
  ++failed.count;
  if (failed.jobs.size() < FailedJobs::kMostListed) failed.jobs.push_back(job);
  const auto same = std::ranges::find(failed.reasons, reason, &FailedJobs::Reason::text);
  if (same != failed.reasons.end()) {
    ++same->count;
  } else if (failed.reasons.size() + 1 < FailedJobs::kMostReasons) {
    failed.reasons.push_back({reason, 1, job});
  } else if (failed.reasons.size() + 1 == FailedJobs::kMostReasons) {
    failed.reasons.push_back({"others", 1, job});
  } else {
    ++failed.reasons.back().count;
  }
}

/// The part of the process that writes.
class Coordinator {
 public:
  Coordinator(const EnsembleRun& run, const Prepared& prepared)
      : run_(run), prepared_(prepared), layout_(*prepared.layout) {
    check_outputs(planned_outputs());
    for (const EnsembleGroup& group : prepared.jobs->groups()) done_.jobs += group.jobs;
    take_stock();
    if (too_many_failed()) to_do_.clear();  // further jobs are useless then
  }

  /// Blocks that this run has to do.
  [[nodiscard]] const std::vector<std::uint64_t>& to_do() const { return to_do_; }

  bool receive(std::uint64_t block, const std::string& bytes) {
    const JobRange range = layout_.jobs_of(block);
    const auto results =
        block_results(bytes, range.count, prepared_.jobs->groups()[range.group].width());
    if (!results) throw Error(fmt::format("block {} came back damaged", block));
    writer_->append(block, bytes);
    if (since_sync_.seconds() > kSecondsBetweenSyncs) {
      writer_->sync();
      since_sync_ = Stopwatch();
    }
    done_.done_now += range.count;
    done_.failed += failures_in(*results);
    if (run_.progress && !run_.progress(done_.done_before + done_.done_now, jobs_of_run_)) {
      cancelled_ = true;
    }
    return !cancelled_ && !too_many_failed();
  }

  void begin() {
    if (to_do_.empty()) return;
    writer_ = std::make_unique<JournalWriter>(own_journal(), prepared_.heading());
    if (!writer_->is_locked() && run_.warned) {
      run_.warned({"journal_not_locked",
                   fmt::format("{}: the file system has no locks (Lustre: mount it with flock), so "
                               "that nothing keeps another run from the same journal: start no two "
                               "at once.",
                               own_journal())});
    }
    if (run_.progress) (void)run_.progress(done_.done_before, jobs_of_run_);
  }

  FinishedEnsemble finish() {
    done_.wall_seconds = watch_.seconds();
    if (writer_) writer_->sync();  // kept open: no process continues a journal to be removed
    if (cancelled_) throw Cancelled();
    if (too_many_failed()) fail_by_failures();
    if (run_.shard) {
      done_.journal = own_journal();
    } else {
      write_result();
    }
    return std::move(done_);
  }

 private:
  [[nodiscard]] std::vector<PlannedOutput> planned_outputs() const {
    if (run_.shard) return {{run_.out, kEnsembleKind}};
    return {{run_.out, kEnsembleKind}, {run_.table, kEnsembleTableKind}};
  }

  [[nodiscard]] std::string own_journal() const {
    return journal_path(run_.out,
                        run_.shard ? fmt::format("{}-of-{}", run_.shard->number, run_.shard->count)
                                   : std::string());
  }

  [[nodiscard]] EnsembleJournals journals() const {
    return {run_.out, prepared_.heading(), prepared_.jobs->groups(), layout_};
  }

  /// Determines the finished and the remaining blocks.
  void take_stock() {
    const EnsembleJournals found = journals();
    std::uint64_t missing = 0;
    for (std::uint64_t block = 0; block < layout_.size(); ++block) {
      const std::uint64_t jobs = layout_.jobs_of(block).count;
      const bool mine = !run_.shard || block % run_.shard->count + 1 == run_.shard->number;
      if (!mine) continue;
      jobs_of_run_ += jobs;
      if (found.has(block)) {
        done_.done_before += jobs;
        done_.failed += failures_in(found.results(block));
      } else {
        missing += jobs;
        to_do_.push_back(block);
      }
    }
    if (!run_.merge || missing == 0) return;
    throw InputError(fmt::format("{}: jobs in journals", run_.out),
                     fmt::format("{} of {}", done_.jobs - missing, done_.jobs),
                     fmt::format("must be all for a merge; {} journal{} found",
                                 found.paths().size(), found.paths().size() == 1 ? "" : "s"),
                     "Run the missing shards, or run without `merge` to do the rest.");
  }

  [[nodiscard]] bool too_many_failed() const {
    return static_cast<double>(done_.failed) >
           prepared_.plan.most_failed * static_cast<double>(done_.jobs);
  }

  /// Failures in the blocks that are done, from one to before another.
  FailedJobs failures_of(const EnsembleJournals& found, std::uint64_t first,
                         std::uint64_t end) const {
    FailedJobs failed;
    for (std::uint64_t block = first; block < end; ++block) {
      if (!found.has(block)) continue;
      const JobRange range = layout_.jobs_of(block);
      const std::vector<JobResult> results = found.results(block);
      for (std::uint64_t i = 0; i < results.size(); ++i) {
        if (!results[i].failure.empty()) add_failure(failed, results[i].failure, range.first + i);
      }
    }
    return failed;
  }

  [[noreturn]] void fail_by_failures() const {
    FailedJobs failed = failures_of(journals(), 0, layout_.size());
    std::ranges::stable_sort(failed.reasons, std::ranges::greater(), &FailedJobs::Reason::count);
    throw NothingFound(fmt::format(
        "{}: not converged: {} of {} jobs failed, more than most_failed = {:g} of all; most often: "
        "{} ({} jobs, first number {}). {} keeps the finished jobs: change most_failed and run "
        "again "
        "to continue",
        prepared_.plan.file, done_.failed, done_.jobs, prepared_.plan.most_failed,
        failed.reasons.front().text, failed.reasons.front().count, failed.reasons.front().first,
        own_journal()));
  }

  GroupResult result_of(const EnsembleJournals& found, std::size_t group) const {
    GroupResult result{prepared_.jobs->groups()[group], {}};
    const auto [first, end] = layout_.blocks_of(group);
    result.failed = failures_of(found, first, end);
    result.values =
        column_statistics(found.rows_of(group), result.group.width(), prepared_.plan.confidence);
    return result;
  }

  void write_result() {
    const EnsembleJournals found = journals();
    EnsembleResult& result = done_.result;
    result = {.kind = prepared_.plan.kind,
              .seed = prepared_.plan.seed,
              .confidence = prepared_.plan.confidence,
              .plan = prepared_.plan.text,
              .fingerprint = prepared_.fingerprint,
              .inputs = prepared_.inputs,
              .notes = prepared_.jobs->notes(),
              .warnings = {},
              .raw = prepared_.plan.raw,
              .groups = {}};
    if (prepared_.plan.kind == "sweep" && result.raw.empty()) result.raw = {"*"};
    for (std::size_t g = 0; g < prepared_.jobs->groups().size(); ++g) {
      result.groups.push_back(result_of(found, g));
    }
    const auto rows = [&](std::size_t group) { return found.rows_of(group); };
    done_.warnings = prepared_.jobs->warnings();
    std::ranges::move(ensemble_warnings(result), std::back_inserter(done_.warnings));
    std::ranges::move(grid_warnings(result, rows), std::back_inserter(done_.warnings));
    result.warnings = done_.warnings;
    OutputFiles outputs;
    add_ensemble_result(result, rows, run_.out, outputs);
    add_ensemble_table(result, rows, run_.command, run_.table, outputs);
    outputs.commit();
    if (run_.keep_journals) return;
    for (const std::string& path : found.paths()) remove_journal(path);
  }

  const EnsembleRun& run_;
  const Prepared& prepared_;
  const BlockLayout& layout_;
  FinishedEnsemble done_;
  std::vector<std::uint64_t> to_do_;
  std::uint64_t jobs_of_run_ = 0;
  std::unique_ptr<JournalWriter> writer_;
  Stopwatch since_sync_;
  Stopwatch watch_;
  bool cancelled_ = false;
};

}  // namespace

EnsembleShard EnsembleShard::parse(const std::string& text) {
  EnsembleShard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.number);
  const bool divided = first == std::errc() && slash != end && *slash == '/';
  const auto [rest, second] =
      divided ? std::from_chars(slash + 1, end, shard.count) : std::from_chars_result{slash, first};
  constexpr std::uint64_t kMostShards = 1'000'000;
  if (divided && second == std::errc() && rest == end && shard.number >= 1 &&
      shard.number <= shard.count && shard.count <= kMostShards) {
    return shard;
  }
  throw InputError("shard", in_quotes(text),
                   "must be NUMBER/COUNT, the number from 1 to the count, as 3/20");
}

std::optional<FinishedEnsemble> run_ensemble(const EnsembleRun& run, Team& team) {
  const Prepared prepared = prepare_together(run.plan, team);
  std::unique_ptr<Coordinator> coordinator;
  std::string failure;
  std::exception_ptr thrown;
  if (team.coordinates()) {
    try {
      coordinator = std::make_unique<Coordinator>(run, prepared);
      coordinator->begin();
    } catch (const Error& error) {
      failure = error.what();
      thrown = std::current_exception();
    }
  }
  team.agree("ready", failure);
  if (thrown) std::rethrow_exception(thrown);
  const std::vector<std::uint64_t> none;
  team.deal(
      coordinator ? coordinator->to_do() : none,
      [&](std::uint64_t block, const std::function<void()>& between_jobs) {
        return work_on(prepared, block, between_jobs);
      },
      [&](std::uint64_t block, const std::string& done) {
        return coordinator->receive(block, done);
      });
  if (!coordinator) return std::nullopt;
  return coordinator->finish();
}

std::string describe_ensemble(const EnsembleRun& run, const FinishedEnsemble& done) {
  std::string text = line("jobs", fmt::format("{}", done.jobs));
  if (done.done_before > 0) {
    text += line("done before", fmt::format("{}, from journals", done.done_before));
  }
  text +=
      line("done now",
           done.done_now == 0
               ? std::string("0")
               : fmt::format("{} in {:.3g} s, {:.4g} a second", done.done_now, done.wall_seconds,
                             static_cast<double>(done.done_now) / done.wall_seconds));
  text += line("failed", fmt::format("{}", done.failed));
  if (!done.journal.empty()) {
    text += line("journal", done.journal);
    return text + line("next", "`merge` when all shards are done");
  }
  for (const GroupResult& group : done.result.groups) {
    std::size_t at = 0;
    for (const EnsembleOutput& output : group.group.outputs) {
      const ColumnStatistics& s = group.values[at];
      at += output.size();
      if (output.size() != 1 || !group.group.grid.empty()) continue;
      text += line(group.group.name,
                   fmt::format("{} {:.5g}, {:.5g} to {:.5g} {}", output.name, s.median, s.lower,
                               s.upper, si_unit(output.dimension)));
    }
  }
  text += line("result", run.out);
  return text + line("table", run.table);
}

}  // namespace microslip
