// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/file_kind.hpp"
#include "microslip/io/input_file.hpp"
#include "microslip/io/joint_file.hpp"
#include "microslip/io/joint_samples_file.hpp"
#include "microslip/io/model_writer.hpp"
#include "microslip/io/recording_file.hpp"
#include "microslip/io/rig_file.hpp"
#include "microslip/io/stepped_sine_file.hpp"
#include "microslip/io/text.hpp"
#include "microslip/rig/stick_state.hpp"
#include "microslip/workflow/campaign_tables.hpp"
#include "microslip/workflow/campaign_test_kinds.hpp"
#include "microslip/workflow/comparison_table.hpp"
#include "microslip/workflow/distinct_files.hpp"
#include "microslip/workflow/identification_text.hpp"
#include "microslip/workflow/joint_draws.hpp"
#include "microslip/workflow/level_table.hpp"
#include "microslip/workflow/loops_comparison.hpp"
#include "microslip/workflow/model_draws.hpp"
#include "microslip/workflow/model_text.hpp"
#include "microslip/workflow/named_rig.hpp"
#include "microslip/workflow/record_entries.hpp"
#include "microslip/workflow/recordings_provenance.hpp"
#include "microslip/workflow/rig_model.hpp"
#include "microslip/workflow/smoothing_text.hpp"
#include "microslip/workflow/summary_text.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJointName = "joint.json";
constexpr const char* kSamplesName = "joint_samples.h5";

// ---- The plan and its files. ----

std::string in_folder(const CampaignRun& run, const std::string& name) {
  return (fs::path(run.out) / name).string();
}

CampaignFile read_plan(const CampaignRun& run) {
  if (run.campaign == "-") {
    throw InputError("campaign", "standard input", "must be a file: its folder has the tests");
  }
  return parse_campaign(read_file(run.campaign), input_name(run.campaign));
}

void check_structure(const CampaignFile& plan) {
  const std::string kind = file_kind(read_kind_head(plan.structure));
  if (kind == kRigKind) return;
  throw InputError(
      "structure", in_quotes(plan.structure), "must be a rig.toml: a campaign has one joint",
      kind == kModelKind
          ? "The subcommand calibrate finds the joints of a model.toml from levels of its "
            "modes, and verify predicts tests by it."
          : "A structure known by its modes has [modes] there.");
}

/// In the words of campaign.toml: only the inversion has draws, and p is of another method.
void check_smoothing(const CampaignRun& run, const CampaignFile& plan) {
  const std::string place = fmt::format("{}: identification.smoothing", printable(run.campaign));
  IdentificationOptions none;
  try {
    if (!plan.smoothing.starts_with("p=")) return set_smoothing(plan.smoothing, std::nullopt, none);
  } catch (const InputError& error) {
    throw error.renamed(place);
  }
  throw InputError(place, in_quotes(plan.smoothing), "must be gcv or lambda=X",
                   "p is of the method spline of identify, which has no draws.");
}

void check_campaign(const CampaignRun& run, const CampaignFile& plan) {
  check_structure(plan);
  check_smoothing(run, plan);
  std::vector<std::string> files;
  for (const CampaignTest& test : plan.tests) files.push_back(test.file);
  check_distinct_files(files);
  for (const CampaignTest& test : plan.tests) check_campaign_test(test);
}

/// Conditions of tests that are predicted alone are columns, no more.
bool has_conditions(const CampaignFile& plan) {
  return std::ranges::any_of(plan.tests, [](const CampaignTest& test) {
    return test.identifies() && !test.conditions.empty();
  });
}

/// The sessions, but for the first with levels, whose predicted tests have a model of their own.
std::vector<std::string> sessions_with_model(const CampaignFile& plan) {
  std::vector<std::string> names;
  if (!plan.session_offsets) return names;
  const std::string first = plan.sessions().front();
  for (const CampaignTest& test : plan.tests) {
    if (!test.predicted() || test.session == first) continue;
    if (std::ranges::count(names, test.session) == 0) names.push_back(test.session);
  }
  return names;
}

std::string model_name(const std::string& session) { return fmt::format("model_{}.toml", session); }

std::vector<ResultFile> files_of(const CampaignRun& run, const CampaignFile& plan) {
  std::vector<ResultFile> files;
  const auto add = [&](const std::string& name, std::string_view kind) {
    files.push_back({in_folder(run, name), kind});
  };
  for (const CampaignTest& test : plan.tests) {
    if (test.identifies() && !is_levels_table(test.file)) {
      files.push_back({levels_path(run.out, test), kLevelsKind});
    }
  }
  add("levels.csv", kLevelsKind);
  add(kJointName, kJointKind);
  if (plan.draws > 0) add(kSamplesName, kSamplesKind);
  add("model.toml", kModelKind);
  for (const std::string& session : sessions_with_model(plan)) add(model_name(session), kModelKind);
  if (std::ranges::any_of(plan.tests, &CampaignTest::predicted)) {
    add("comparison.csv", kComparisonKind);
  }
  add("campaign.csv", kCampaignTableKind);
  add("sessions.csv", kSessionsKind);
  if (has_conditions(plan)) add("conditions.csv", kConditionsKind);
  if (plan.leave_out != LeaveOut::kNothing) add("leave_one_out.csv", kLeftOutKind);
  return files;
}

void check_not_replaced(const CampaignRun& run, const CampaignFile& plan,
                        const std::vector<ResultFile>& files) {
  std::vector<std::string> inputs{run.campaign, plan.structure};
  for (const CampaignTest& test : plan.tests) inputs.push_back(part_of_file(test.file).file);
  for (const ResultFile& file : files) {
    for (const std::string& input : inputs) {
      std::error_code none;
      if (!fs::equivalent(file.path, input, none)) continue;
      throw InputError("out", in_quotes(run.out),
                       fmt::format("must not be the folder of {}, which would be replaced", input),
                       "Choose another folder.");
    }
  }
}

// ---- Parts of the work. ----

/// Progress of stage n of some, as a share of all.
Progress stage(const CampaignRun& run, std::size_t n, std::size_t stages) {
  if (!run.progress) return {};
  return [&run, n, stages](std::size_t done, std::size_t total) {
    return run.progress(n * total + done, stages * total);
  };
}

LevelsIdentification identification_of(const CampaignRun& run, const CampaignFile& plan) {
  LevelsIdentification all;
  all.stiffness = plan.stiffness;
  all.use_inner_reversals = plan.use_inner_reversals;
  all.texts.smoothing = plan.smoothing;
  all.texts.inner_reversals = plan.use_inner_reversals ? "use" : "leave-out";
  all.texts.common_errors = {.dissipation_gain_std = plan.dissipation_gain_std,
                             .amplitude_gain_std = plan.amplitude_gain_std};
  all.options.inversion.linear_damping = plan.linear_damping;
  all.options.inversion.edges = plan.edges;
  all.options.inversion.atom = plan.atom;
  set_smoothing(plan.smoothing, std::nullopt, all.options);
  if (plan.draws == 0) return all;
  all.texts.samples_out = kSamplesName;
  BandOptions bands;
  bands.samples = plan.draws;
  bands.seed = plan.seed;
  bands.execution = run.execution;
  all.options.bands = bands;
  return all;
}

/// Its work, and what all parts of it share.
class CampaignWork {
 public:
  explicit CampaignWork(const CampaignRun& run)
      : run_(run),
        plan_(read_plan(run)),
        inputs_{{run.campaign, read_file(run.campaign)},
                {plan_.structure, read_file(plan_.structure)}},
        identification_(identification_of(run, plan_)),
        state_(of_rig(inputs_[1],
                      [&] { return stick_state(parse_rig(inputs_[1]), kModesOfCampaign); })) {
    stages_ =
        1 + static_cast<std::size_t>(plan_.leave_out != LeaveOut::kNothing) +
        static_cast<std::size_t>(std::ranges::count_if(plan_.tests, &CampaignTest::predicted));
  }

  [[nodiscard]] DoneCampaign done() {
    comment_ = provenance_of(run_.command, inputs_);
    for (const CampaignTest& test : plan_.tests) {
      comment_ += fmt::format("\n{}: sha256 {}", printable(test.file), digest_of(test.file));
    }
    CampaignLevels levels = campaign_levels(plan_, run_.out, run_.command, {});
    check_leave_out(plan_, levels);
    SessionEffects effects = effects_by_first_joint(levels);
    IdentifiedLevels identified = identify_pooled(levels, effects);
    effects = effects_by(levels, identified.found);
    DoneCampaign all{.plan = plan_,
                     .levels = std::move(levels),
                     .identified = std::move(identified),
                     .sessions = std::move(effects)};
    joint_ = identified_joint(all.identified.found, identification_.options, {all.identified.input},
                              run_.command, identification_.texts);
    all.conditions = condition_effects(plan_, all.levels, all.sessions);
    collect_warnings(all);
    leave_out(all);
    const RigModel model = model_of_rig(inputs_[1], joint_, kJointName, kModesOfCampaign);
    std::ranges::copy(model.warnings, std::back_inserter(all.warnings));
    warn_of_sessions(all);
    predict(model.file, all);
    tell_joint(all.warnings);
    compose(model.file, all);
    return all;
  }

 private:
  [[nodiscard]] SessionEffects effects_by(const CampaignLevels& levels,
                                          const Identification& found) const {
    return session_effects(plan_, levels, state_, found.joint, found.linear_damping.value_or(0.0));
  }

  /// Frequencies are no data of the joint, but its warnings tell of them: offsets are taken off
  /// before.
  [[nodiscard]] SessionEffects effects_by_first_joint(const CampaignLevels& levels) const {
    LevelsIdentification first = identification_;
    first.options.bands.reset();
    first.texts.common_errors = {};
    const std::vector<double> none(levels.size(), 0.0);
    return effects_by(levels, identify_table(pooled(levels, none), first).found);
  }

  [[nodiscard]] LevelTable pooled(const CampaignLevels& levels,
                                  const std::vector<double>& offsets) const {
    // Those with inner reversals are left out already where they are to be.
    return level_table_of(
        {in_folder(run_, "levels.csv"),
         pooled_levels_text(levels, plan_, offsets, with_warnings(comment_, levels.warnings))},
        {.use_inner_reversals = true, .assemblies = AssemblyColumn::kIgnored});
  }

  [[nodiscard]] IdentifiedLevels identify_pooled(const CampaignLevels& levels,
                                                 const SessionEffects& effects) const {
    LevelsIdentification options = identification_;
    if (options.options.bands) options.options.bands->progress = stage(run_, 0, stages_);
    return identify_table(pooled(levels, offsets_of_levels(effects, plan_, levels)), options);
  }

  void collect_warnings(DoneCampaign& all) const {
    std::ranges::copy(all.levels.warnings, std::back_inserter(all.warnings));
    std::ranges::copy(all.identified.found.warnings, std::back_inserter(all.warnings));
    add_joint_warnings(kJointName, joint_, all.warnings);
  }

  /// What is known of the tests together belongs to the joint, beside what its levels tell.
  void tell_joint(const std::vector<Warning>& warnings) {
    NamedValues& record = joint_.identification;
    std::erase_if(record, [](const auto& entry) {
      return entry.first == "warnings" || entry.first == "warning_texts";
    });
    add_warnings(warnings, record);
  }

  void leave_out(DoneCampaign& all) const {
    if (plan_.leave_out == LeaveOut::kNothing) return;
    all.left_out = leave_one_out(plan_, all.levels,
                                 {.stiffness = plan_.stiffness,
                                  .identification = identification_.options,
                                  .errors = identification_.texts.common_errors,
                                  .execution = run_.execution,
                                  .progress = stage(run_, 1, stages_)});
    for (const LeftOut& part : all.left_out) {
      if (!part.converged) {
        all.warnings.push_back(
            {"left_out_not_converged",
             fmt::format("the identification without {} did not converge.", part.name)});
      }
      if (!part.contradicts()) continue;
      all.warnings.push_back(
          {"left_out_contradicts",
           fmt::format("{} contradicts the others: {} of its {} levels lie in the band that they "
                       "predict, D by {:+.3g} % on the mean; {:.2g} % of the draws have so few.",
                       part.name, part.curve.inside(), part.curve.compared(),
                       100.0 * std::expm1(part.mean_deviation()), 100.0 * part.curve.chance)});
    }
  }

  void warn_of_sessions(DoneCampaign& all) const {
    constexpr double kDeviations = 3.0;
    constexpr double kLeast = 1e-4;  // that a resonance is read to
    for (const SessionEffect& session : all.sessions.sessions) {
      if (plan_.session_offsets) break;
      const double apart = std::abs(session.frequency_difference);
      if (!(apart > kLeast && apart > kDeviations * session.frequency_difference_std)) continue;
      all.warnings.push_back(
          {"sessions_differ",
           fmt::format("the frequencies of session {} are {:+.2g} % off those of session {}: "
                       "session_offsets = true takes such an offset off.",
                       session.name, 100.0 * session.frequency_difference,
                       all.sessions.sessions.front().name)});
    }
    std::ranges::copy(condition_warnings(plan_, all.conditions), std::back_inserter(all.warnings));
    warn_of_leaning(all);
    for (const std::string& session : sessions_with_model(plan_)) {
      if (all.sessions.find(session) != nullptr) continue;
      all.warnings.push_back(
          {"session_unknown",
           fmt::format("no test to identify from is of session {}: its offset of the frequency is "
                       "not known, and that of the others counts as uncertainty.",
                       session)});
    }
  }

  /// Offsets of sessions whose amplitudes no level compares.
  void warn_of_leaning(DoneCampaign& all) const {
    if (!plan_.session_offsets) return;
    for (const SessionEffect& session : all.sessions.sessions) {
      if (!session.apart) continue;
      all.warnings.push_back(
          {"offset_leans_on_joint",
           fmt::format(
               "the amplitudes of session {} do not overlap those of session {}: its offset "
               "of the frequency, {:+.2g} %, is what is left of the {:+.2g} % that they "
               "differ by when the joint is given {:+.2g} %, by its dissipation alone. What "
               "the joint is wrong by there is in the offset, and not in its standard "
               "deviation.",
               session.name, all.sessions.sessions.front().name, 100.0 * session.frequency_offset,
               100.0 * (session.frequency_offset + session.softening), 100.0 * session.softening)});
    }
  }

  // ---- Predictions. ----

  /// σ of the frequency of a test of a session.
  [[nodiscard]] double frequency_std(const SessionEffects& effects,
                                     const std::string& session) const {
    const double scatter = plan_.frequency_std.value_or(effects.frequency_std);
    if (!plan_.session_offsets) return scatter;
    const SessionEffect* effect = effects.find(session);
    return std::hypot(
        scatter, effect != nullptr ? effect->frequency_offset_std : effects.between_frequencies);
  }

  [[nodiscard]] ModelFile model_of(const ModelFile& nominal, const SessionEffects& effects,
                                   const std::string& session) const {
    const SessionEffect* effect = effects.find(session);
    const double factor = std::exp(effect != nullptr ? effect->frequency_offset : 0.0);
    const JointedStructure& structure = nominal.structure;
    std::vector<Mode> modes(structure.linear().modes().begin(), structure.linear().modes().end());
    for (Mode& mode : modes) mode.angular_frequency *= factor;
    ModelFile model = nominal;
    try {
      model.structure = JointedStructure(
          structure.linear().with_modes(modes),
          {structure.joints().begin(), structure.joints().end()},
          {structure.excitations().begin(), structure.excitations().end()}, structure.damping());
    } catch (const InputError& error) {
      throw InputError(fmt::format("session {}: {}", session, error.name()),
                       fmt::format("a frequency {:+.3g} % off", 100.0 * (factor - 1.0)),
                       "must leave the structure some stiffness without the joint",
                       "Give a stiffness_N_per_m that is not all of the stiffness there is.");
    }
    if (plan_.draws == 0) return model;
    model.joint_samples = {kSamplesName};
    model.damping_said = {false};
    const double sigma = frequency_std(effects, session);
    if (sigma > 0.0) model.spread.frequency.assign(modes.size(), sigma);
    if (plan_.force_gain_std > 0.0) model.spread.force_gain = {plan_.force_gain_std};
    return model;
  }

  [[nodiscard]] std::optional<StructureDraws> draws_by(const ModelFile& model,
                                                       const DoneCampaign& all) const {
    if (plan_.draws == 0) return std::nullopt;
    return draws_of(model.structure, model.spread,
                    {joint_samples(all.identified.found, *joint_.provenance)}, model.damping_said,
                    draw_options(), "model.toml");
  }

  [[nodiscard]] DrawOptions draw_options() const {
    return {.count = plan_.draws, .seed = plan_.seed};
  }

  void predict(const ModelFile& nominal, DoneCampaign& all) const {
    std::size_t n = stages_ - static_cast<std::size_t>(
                                  std::ranges::count_if(plan_.tests, &CampaignTest::predicted));
    for (std::size_t t = 0; t < plan_.tests.size(); ++t) {
      if (!plan_.tests[t].predicted()) continue;
      const ModelFile model = model_of(nominal, all.sessions, plan_.tests[t].session);
      const ReadTest read = of_campaign_test(plan_.tests[t], [&] {
        return read_test(plan_.tests[t].file, &model, "model.toml",
                         campaign_reading(plan_.tests[t]));
      });
      for (const Warning& warning : read.warnings) {
        all.warnings.push_back(
            {warning.code, fmt::format("{}: {}", plan_.tests[t].name, warning.text)});
      }
      all.verified.followed = all.verified.followed && read.converged;
      std::optional<TestDraws> draws;
      if (plan_.draws > 0) {
        draws = TestDraws{draw_options(), run_.execution, stage(run_, n, stages_)};
      }
      for (ComparedTest& test : compare_test(read, model, {}, draws_by(model, all), draws)) {
        all.verified.tests.push_back(std::move(test));
        all.test_of.push_back(t);
      }
      if (plan_.draws > 0) all.verified.uncertain = uncertain_text(model);
      ++n;
    }
    all.verified.heading = comment_;
    all.verified.warnings = all.warnings;
  }

  // ---- Files. ----

  void compose(const ModelFile& nominal, DoneCampaign& all) const {
    all.files = files_of(run_, plan_);
    const std::string comment = with_warnings(comment_, all.warnings);
    const auto put = [&](const std::string& name, const auto& text) {
      const auto file = std::ranges::find(all.files, in_folder(run_, name), &ResultFile::path);
      if (file != all.files.end()) file->content = text();
    };
    for (const ResultFile& table : all.levels.tables) {
      put(fs::path(table.path).filename().string(), [&] { return table.content; });
    }
    put("levels.csv", [&] { return all.identified.input.text; });
    put(kJointName, [&] { return format_joint(joint_); });
    put(kSamplesName, [&] {
      return samples_bytes(all.identified.found, identification_.options, all.identified.input,
                           run_.command, identification_.texts, in_folder(run_, kSamplesName));
    });
    put("model.toml", [&] {
      return format_model(model_of(nominal, all.sessions, plan_.sessions().front()), comment);
    });
    for (const std::string& session : sessions_with_model(plan_)) {
      put(model_name(session),
          [&] { return format_model(model_of(nominal, all.sessions, session), comment); });
    }
    put("comparison.csv", [&] { return comparison_table(all.verified); });
    put("campaign.csv", [&] { return campaign_table(all, comment); });
    put("sessions.csv", [&] { return sessions_table(all, comment); });
    put("conditions.csv", [&] { return conditions_table(all, comment); });
    put("leave_one_out.csv", [&] { return left_out_table(all, comment); });
  }

  const CampaignRun& run_;
  CampaignFile plan_;
  std::vector<NamedInput> inputs_;
  LevelsIdentification identification_;
  StickState state_;
  std::size_t stages_ = 1;
  std::string comment_;  // of each file, without warnings
  JointFile joint_{Joint(1.0, {}), {}, {}};
};

// ---- The summary. ----

std::string describe_sessions(const SessionEffects& effects) {
  std::string text;
  for (const SessionEffect& session : effects.sessions) {
    std::string facts =
        fmt::format("{} of {}, D {:+.2g} % off the joint", counted(session.levels, "level"),
                    counted(session.tests, "test"), 100.0 * session.dissipation_offset);
    if (session.frequency_offset_std > 0.0) {
      facts += fmt::format(", frequency offset {:+.3f} ± {:.2g} %",
                           100.0 * session.frequency_offset, 100.0 * session.frequency_offset_std);
    } else if (std::isfinite(session.frequency_difference) && &session != &effects.sessions[0]) {
      facts += fmt::format(", frequency {:+.3f} % off, not taken off",
                           100.0 * session.frequency_difference);
    }
    text += line("session " + session.name, facts);
  }
  if (effects.frequency_std > 0.0) {
    text += line("frequencies",
                 fmt::format("{:.2g} % rms off those of the model", 100.0 * effects.frequency_std));
  }
  const std::string repeats = repeatability_text(effects);
  return repeats.empty() ? text : text + line("repeatability", "of D: " + repeats);
}

/// Before the density, which is of no use then.
std::string describe_departures(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) {
    if (warning.code == kTestNotOfThisKind) text += line("NOT A JOINT", warning.text);
  }
  return text;
}

std::string describe_conditions(const std::vector<ConditionEffect>& conditions) {
  std::string text;
  for (const ConditionEffect& condition : conditions) {
    const std::string trend = trend_text(condition);
    if (!trend.empty()) text += line("trend", trend);
  }
  return text;
}

std::string describe_left_out(const std::vector<LeftOut>& parts) {
  std::string text;
  std::size_t compared = 0;
  std::size_t named = 0;
  for (const LeftOut& part : parts) {
    const std::string facts =
        part.curve.compared() == 0
            ? "beyond the others, which predict nothing there"
            : fmt::format("D {:+.2g} % off what the others predict, {} of {} inside{}",
                          100.0 * std::expm1(part.mean_deviation()), part.curve.inside(),
                          part.curve.compared(), part.contradicts() ? ": CONTRADICTS THEM" : "");
    text += line(&part == parts.data() ? "left out" : "", part.name + ": " + facts);
    compared += part.curve.compared() > 0 ? 1 : 0;
    named += part.contradicts() ? 1 : 0;
  }
  if (parts.empty()) return text;
  const double chance = 1.0 - parts.front().taken.options.confidence;
  return text + line("", fmt::format("{} of {} contradict the others, {:.2g} do by chance", named,
                                     compared, chance * static_cast<double>(compared)));
}

}  // namespace

bool DoneCampaign::converged() const {
  return identified.found.summary.converged() && levels.converged && verified.converged() &&
         std::ranges::all_of(left_out, &LeftOut::converged);
}

std::vector<ResultFile> planned_files(const CampaignRun& run) {
  if (run.out.empty() || run.out == "-") {
    throw InputError("out", in_quotes(run.out), "must be a folder", "Name it.");
  }
  const CampaignFile plan = read_plan(run);
  check_campaign(run, plan);
  std::vector<ResultFile> files = files_of(run, plan);
  check_not_replaced(run, plan, files);
  return files;
}

DoneCampaign run_campaign(const CampaignRun& run) {
  check_campaign(run, read_plan(run));
  return CampaignWork(run).done();
}

std::string describe_campaign(const DoneCampaign& done) {
  Identification found = done.identified.found;  // whose warnings are among those of all
  found.warnings.clear();
  std::string text = done.plan.title.empty() ? "" : printable(done.plan.title) + "\n";
  text += describe_departures(done.levels.warnings);
  text += describe_identification(found, done.identified.count) + describe_sessions(done.sessions) +
          describe_conditions(done.conditions) + describe_left_out(done.left_out);
  VerifiedTests verified = done.verified;
  verified.warnings = done.warnings;
  return text +
         (verified.tests.empty() ? describe_warnings(done.warnings) : describe_tests(verified));
}

}  // namespace microslip
