// SPDX-License-Identifier: MIT
#include "microslip/workflow/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "microslip/base/error.hpp"
#include "microslip/documents/structure/model_writer.hpp"
#include "microslip/dynamics/structure/modal_offsets.hpp"
#include "microslip/io/bytes/sha256.hpp"
#include "microslip/workflow/campaign/campaign_joints.hpp"
#include "microslip/workflow/campaign/campaign_outliers.hpp"
#include "microslip/workflow/campaign/campaign_plan.hpp"
#include "microslip/workflow/campaign/campaign_statistics.hpp"
#include "microslip/workflow/campaign/campaign_tables.hpp"
#include "microslip/workflow/campaign/campaign_test_kinds.hpp"
#include "microslip/workflow/compare/comparison_table.hpp"
#include "microslip/workflow/compare/loops_comparison.hpp"
#include "microslip/workflow/predict/model_draws.hpp"
#include "microslip/workflow/predict/model_rules.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/text/distinct_files.hpp"

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// Progress of stage n of some, as a share of all.
Progress stage(const CampaignRun& run, std::size_t n, std::size_t stages) {
  if (!run.progress) return {};
  return [&run, n, stages](std::size_t done, std::size_t total) {
    return run.progress(n * total + done, stages * total);
  };
}

/// Campaign, structure and tests.
CampaignComment comment_of(const CampaignRun& run, const OpenedCampaign& opened) {
  const std::vector<NamedInput> inputs{opened.campaign, opened.structure};
  CampaignComment comment{.text = provenance_of(run.command, inputs)};
  for (const NamedInput& input : inputs) {
    comment.inputs.push_back({input.path, sha256(input.text)});
  }
  for (const TestFile& test : opened.tests) {
    comment.inputs.push_back({test.path, test.sha256});
    comment.text += '\n' + hash_comment(test.path, test.sha256);
  }
  return comment;
}

std::vector<Warning> copies_of_tests(const OpenedCampaign& opened) {
  std::vector<InputHash> files;
  for (const TestFile& test : opened.tests) files.push_back({test.path, test.sha256});
  return same_content_warnings(files, "the test");
}

/// Standard deviations of losses that were found too small count so much more.
std::string widen_deviations(double scatter, ModalLevels& levels) {
  if (!(scatter > 1.0)) return {};
  bool widened = false;
  for (const auto std : {&ModalLevels::dissipation_std, &ModalLevels::damping_ratio_std}) {
    for (double& deviation : levels.*std) deviation *= scatter;
    widened = widened || !(levels.*std).empty();
  }
  if (!widened) return {};
  return fmt::format(
      "its losses are assumed to scatter by {:.3g} times their standard deviations, as those "
      "of the levels used for identification",
      scatter);
}

/// Gives levels of modes without standard deviations of their losses those of a relative scatter.
/// @return what was done, in words; empty where nothing was.
std::string assume_scatter(const FoundAtLevels& found, ReadTest& test) {
  auto* levels = std::get_if<ModalLevels>(&test.content);
  if (levels == nullptr) return {};
  const double scatter = found.loss_scatter;
  if (!(scatter > 0.0)) return widen_deviations(found.deviation_scatter, *levels);
  bool assumed = false;
  for (const auto& [values, std] :
       {std::pair{&ModalLevels::dissipation, &ModalLevels::dissipation_std},
        std::pair{&ModalLevels::damping_ratio, &ModalLevels::damping_ratio_std}}) {
    if ((levels->*values).empty() || !(levels->*std).empty()) continue;
    for (const double value : levels->*values) (levels->*std).push_back(scatter * value);
    assumed = true;
  }
  if (!assumed) return {};
  return fmt::format(
      "its losses have no standard deviation and are assumed to scatter by {:.2g} %, as those "
      "of the levels used for identification",
      100.0 * scatter);
}

/// Its work, and what all parts of it share.
class CampaignWork {
 public:
  CampaignWork(const CampaignRun& run, const OpenedCampaign& opened)
      : run_(run), opened_(opened), plan_(opened.plan), comment_(comment_of(run, opened)) {
    joints_ = plan_.of_model() ? joints_of_model(run_, opened_, comment_)
                               : joints_of_rig(run_, opened_, comment_);
    stages_ =
        1 + static_cast<std::size_t>(plan_.leave_out != LeaveOut::kNothing) +
        static_cast<std::size_t>(std::ranges::count_if(plan_.tests, &CampaignTest::predicted));
  }

  [[nodiscard]] DoneCampaign done() {
    DoneCampaign all{.plan = plan_};
    joints_->identify(stage(run_, 0, stages_), all);
    all.warnings = with_outliers_by_test(plan_, all.levels, all.sessions.dissipation, all.outliers,
                                         std::move(all.warnings));
    std::ranges::move(copies_of_tests(opened_), std::back_inserter(all.warnings));
    all.conditions = condition_effects(plan_, all.levels, all.sessions);
    leave_out(all);
    DoneCampaign others = without_wrong_tests(all);
    const DoneCampaign& predicting = sound_ ? others : all;
    const ModelFile nominal = joints_->model(predicting, all.warnings);
    const ModelsOfSessions models = models_of_sessions(nominal, predicting);
    warn_of_sessions(all);
    predict(models, all);
    others.warnings = all.warnings;
    compose(models, predicting, all);
    return all;
  }

 private:
  using ModelsOfSessions = std::map<std::string, ModelFile>;

  void leave_out(DoneCampaign& all) const {
    if (plan_.leave_out == LeaveOut::kNothing) return;
    all.left_out = joints_->leave_out(all, stage(run_, 1, stages_));
    for (const LeftOut& part : all.left_out) {
      if (!part.converged) {
        all.warnings.push_back(
            {"left_out_not_converged",
             part.failure.empty()
                 ? fmt::format("the identification without {} did not converge.", part.name)
                 : fmt::format("without {} nothing was found: {}", part.name, part.failure)});
      }
      if (!part.not_judged.empty()) {
        all.warnings.push_back(
            {"left_out_not_judged",
             fmt::format("{} is not assessed: without it, {}", part.name, part.not_judged)});
      }
      if (!part.contradicts()) continue;
      all.warnings.push_back(
          {"left_out_contradicts",
           fmt::format("{} contradicts the others: {} of {} levels compared lie in the band "
                       "predicted from them, D differs by {:+.3g} % on average; p-value {:.2g} %.",
                       part.name, part.curve.inside(), part.curve.compared(),
                       100.0 * std::expm1(part.mean_deviation()), 100.0 * part.curve.chance)});
    }
  }

  /// Tests that contradict the others, where they are fewer than half of three and more: of two
  /// each does.
  [[nodiscard]] std::set<std::size_t> wrong_tests(const DoneCampaign& all) const {
    std::set<std::size_t> wrong;
    if (plan_.leave_out != LeaveOut::kTests) return wrong;
    for (const LeftOut& part : all.left_out) {
      if (part.contradicts()) wrong.insert(all.levels.test[part.levels.front()]);
    }
    const auto count =
        static_cast<std::size_t>(std::ranges::count_if(plan_.tests, &CampaignTest::identifies));
    return 2 * wrong.size() < count ? wrong : std::set<std::size_t>{};
  }

  /// A test that is wrong would be in the predictions of the others: the joints that predict are
  /// found without it.
  /// @return what was found without; `sound_` says whether anything was.
  [[nodiscard]] DoneCampaign without_wrong_tests(DoneCampaign& all) {
    const std::set<std::size_t> wrong = wrong_tests(all);
    DoneCampaign others{.plan = plan_};
    if (wrong.empty()) return others;
    OpenedCampaign rest = opened_;
    for (const std::size_t t : wrong) rest.plan.tests[t].use = CampaignUse::kPredict;
    sound_ = std::move(rest);
    others.plan = sound_->plan;
    joints_ = plan_.of_model() ? joints_of_model(run_, *sound_, comment_)
                               : joints_of_rig(run_, *sound_, comment_);
    joints_->identify({}, others);
    for (const std::size_t t : wrong) {
      all.warnings.push_back(
          {"test_not_pooled",
           fmt::format("{} is wrong, or another joint: joints and predictions are those of the "
                       "other tests.",
                       plan_.tests[t].name)});
    }
    return others;
  }

  void warn_of_sessions(DoneCampaign& all) const {
    for (const SessionEffect& session : all.sessions.sessions) {
      if (plan_.session_offsets) break;
      const double apart = std::abs(session.frequency_difference);
      if (!(apart > kLeastDifference && apart > kSignificant * session.frequency_difference_std))
        continue;
      all.warnings.push_back(
          {"sessions_differ",
           fmt::format("the frequencies of session {}{} differ by {:+.2g} % from those of session "
                       "{}: session_offsets = true corrects such an offset.",
                       session.name, mode_text(session), 100.0 * session.frequency_difference,
                       first_session(all, session))});
    }
    warn_of_tests(all);
    std::ranges::copy(condition_warnings(plan_, all.conditions), std::back_inserter(all.warnings));
    warn_of_leaning(all);
    for (const std::string& session : sessions_with_model(plan_)) {
      if (all.sessions.has(session)) continue;
      all.warnings.push_back(
          {"session_unknown",
           fmt::format("no test to identify from belongs to session {}: its frequency offset is "
                       "unknown, and the offsets of the others count as uncertainty.",
                       session)});
    }
  }

  void warn_of_tests(DoneCampaign& all) const {
    for (const TestDifference& one : differing_tests(plan_, all.levels, all.sessions)) {
      const CampaignTest& test = plan_.tests[one.test];
      all.warnings.push_back(
          {"test_frequencies_differ",
           fmt::format("the frequencies of {}{} differ by {:+.2g} ± {:.1g} % from those of the "
                       "other tests of session {}: give it a session of its own, with "
                       "session_offsets = true, to correct such an offset.",
                       test.name, plan_.of_model() ? fmt::format(", mode {}", one.mode) : "",
                       100.0 * one.difference, 100.0 * one.sigma, test.session)});
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
               "the amplitudes of session {}{} do not overlap those of session {}: its frequency "
               "offset, {:+.2g} %, is their difference of {:+.2g} % less {:+.2g} % for the "
               "softening of the joint, inferred from its dissipation alone. Errors of the joint "
               "there enter the offset, but not its standard deviation.",
               session.name, mode_text(session), first_session(all, session),
               100.0 * session.frequency_offset,
               100.0 * (session.frequency_offset + session.softening), 100.0 * session.softening)});
    }
  }

  /// ", mode 2" of a model.
  [[nodiscard]] std::string mode_text(const SessionEffect& session) const {
    return plan_.of_model() ? fmt::format(", mode {}", session.mode) : "";
  }

  /// That which differences of the mode are against.
  [[nodiscard]] static const std::string& first_session(const DoneCampaign& all,
                                                        const SessionEffect& session) {
    return std::ranges::find(all.sessions.sessions, session.mode, &SessionEffect::mode)->name;
  }

  // ---- Predictions. ----

  /// σ of what modes of the structure are known to by themselves, one per mode: as the plan or the
  /// model says, or 0 where what frequencies of the levels scatter by counts in its place.
  [[nodiscard]] std::vector<double> said_deviations(const ModelFile& model) const {
    std::vector<double> said = model.spread.frequency;
    said.resize(model.structure.linear().size(), 0.0);
    if (plan_.frequency_std) std::ranges::fill(said, *plan_.frequency_std);
    return said;
  }

  [[nodiscard]] SessionModes modes_of(const ModelFile& nominal, const DoneCampaign& all,
                                      const std::string& session) const {
    const std::vector<double> said = said_deviations(nominal);
    std::vector<double> scatter;
    for (std::size_t i = 0; i < said.size(); ++i) {
      const bool counts = said[i] == 0.0 && !plan_.frequency_std;
      scatter.push_back(counts ? all.sessions.frequency_std_of(i + 1) : 0.0);
    }
    SessionModes modes = joints_->modes_in(session, nominal, all, scatter);
    for (std::size_t i = 0; i < said.size(); ++i) {
      modes.deviation[i] = std::hypot(modes.deviation[i], said[i]);
    }
    return modes;
  }

  [[nodiscard]] ModelFile model_of(const ModelFile& nominal, const DoneCampaign& all,
                                   const std::string& session) const {
    SessionModes modes = modes_of(nominal, all, session);
    ModelFile model = nominal;
    try {
      model.structure = with_modal_offsets(nominal.structure, modes.offset);
    } catch (const InputError& error) {
      const double largest =
          std::ranges::max(modes.offset, {}, [](double offset) { return std::abs(offset); });
      throw InputError(fmt::format("session {}: {}", session, error.name()),
                       fmt::format("a frequency offset of {:+.3g} %", 100.0 * std::expm1(largest)),
                       "must leave the structure some stiffness without the joint",
                       "Give a stiffness_N_per_m below the total stiffness.");
    }
    if (plan_.draws > 0) set_spread(std::move(modes.deviation), model);
    return model;
  }

  /// Of the first session and of those of predicted tests.
  [[nodiscard]] ModelsOfSessions models_of_sessions(const ModelFile& nominal,
                                                    const DoneCampaign& all) const {
    std::set<std::string> sessions{plan_.sessions().front()};
    for (const CampaignTest& test : plan_.tests) {
      if (test.predicted()) sessions.insert(test.session);
    }
    ModelsOfSessions models;
    for (const std::string& session : sessions) {
      models.emplace(session, model_of(nominal, all, session));
    }
    return models;
  }

  void set_spread(std::vector<double> deviation, ModelFile& model) const {
    std::vector<double>& frequency = model.spread.frequency;
    frequency = std::move(deviation);
    if (std::ranges::all_of(frequency, [](double sigma) { return sigma == 0.0; })) frequency = {};
    if (plan_.force_gain_std > 0.0) {
      model.spread.force_gain.assign(model.structure.excitations().size(), plan_.force_gain_std);
    }
  }

  [[nodiscard]] std::optional<StructureDraws> draws_by(const ModelFile& model) const {
    if (plan_.draws == 0) return std::nullopt;
    return draws_of(model.structure, model.spread, joints_->samples(), model.damping_said,
                    draw_options(), "model.toml");
  }

  /// Harmonics and forcing of a model are those that its joints are found with.
  [[nodiscard]] HarmonicBalanceOptions balance() const {
    HarmonicBalanceOptions options;
    if (plan_.of_model()) options.harmonics = plan_.harmonics;
    return options;
  }

  /// Nothing drives a decay, whatever its levels are in.
  [[nodiscard]] Forcing forcing_of(const CampaignTest& test) const {
    const bool decay = test.kind == CampaignKind::kRingDown;
    const bool driven = plan_.of_model() && !plan_.modal_forcing && !decay;
    return driven ? Forcing::kExcitation : Forcing::kModal;
  }

  [[nodiscard]] DrawOptions draw_options() const {
    return {.count = plan_.draws, .seed = plan_.seed};
  }

  void predict(const ModelsOfSessions& models, DoneCampaign& all) const {
    std::size_t n = stages_ - static_cast<std::size_t>(
                                  std::ranges::count_if(plan_.tests, &CampaignTest::predicted));
    for (std::size_t t = 0; t < plan_.tests.size(); ++t) {
      if (!plan_.tests[t].predicted()) continue;
      const ModelFile& model = models.at(plan_.tests[t].session);
      ReadTest read = of_campaign_test(plan_.tests[t], [&] {
        return read_test(opened_.tests[t], &model, "model.toml", campaign_reading(plan_.tests[t]));
      });
      if (std::holds_alternative<std::vector<SteppedSine>>(read.content)) {
        require_driven_by_forces(model, plan_.structure, "campaign");
      }
      const std::string note = assume_scatter(all.found, read);
      for (const Warning& warning : read.warnings) {
        all.warnings.push_back(
            {warning.code, fmt::format("{}: {}", plan_.tests[t].name, warning.text)});
      }
      all.verified.followed = all.verified.followed && read.converged;
      std::optional<TestDraws> draws;
      if (plan_.draws > 0) {
        draws = TestDraws{draw_options(), run_.execution, stage(run_, n, stages_)};
      }
      for (ComparedTest& test : compare_test(read, model, balance(), draws_by(model), draws, {},
                                             forcing_of(plan_.tests[t]))) {
        if (!note.empty()) test.note += (test.note.empty() ? "" : "; ") + note;
        all.verified.tests.push_back(std::move(test));
        all.test_of.push_back(t);
      }
      if (plan_.draws > 0) all.verified.uncertain = uncertain_text(model);
      ++n;
    }
    all.verified.heading = comment_.text;
    all.verified.warnings = all.warnings;
  }

  // ---- Files. ----

  /// @param predicting  with the joints that predict.
  void compose(const ModelsOfSessions& models, const DoneCampaign& predicting,
               DoneCampaign& all) const {
    all.files = files_of(run_, opened_);
    const std::string comment = with_warnings(comment_.text, all.warnings);
    const auto put = [&](const std::string& name, const auto& text) {
      const auto file = std::ranges::find(all.files, in_folder(run_, name), &ResultFile::path);
      if (file != all.files.end()) file->content = text();
    };
    std::vector<ResultFile> own = joints_->files(predicting);
    std::ranges::copy(all.levels.tables, std::back_inserter(own));
    for (const ResultFile& file : own) {
      put(fs::path(file.path).filename().string(), [&] { return file.content; });
    }
    put("model.toml", [&] { return format_model(models.at(plan_.sessions().front()), comment); });
    for (const std::string& session : sessions_with_model(plan_)) {
      put(model_name(session), [&] { return format_model(models.at(session), comment); });
    }
    put("comparison.csv", [&] { return comparison_table(all.verified); });
    put("campaign.csv", [&] { return campaign_table(all, comment); });
    put("sessions.csv", [&] { return sessions_table(all, comment); });
    put("conditions.csv", [&] { return conditions_table(all, comment); });
    put("leave_one_out.csv", [&] { return left_out_table(all, comment); });
  }

  const CampaignRun& run_;
  const OpenedCampaign& opened_;
  const CampaignFile& plan_;
  CampaignComment comment_;              // of each file
  std::optional<OpenedCampaign> sound_;  // without tests that are wrong, where there are some
  std::unique_ptr<CampaignJoints> joints_;
  std::size_t stages_ = 1;
};

std::vector<std::string> inputs_of(const CampaignRun& run, const OpenedCampaign& opened) {
  std::vector<std::string> inputs{run.campaign, opened.plan.structure};
  for (const TestFile& test : opened.tests) inputs.push_back(test.part.file);
  return inputs;
}

}  // namespace

bool DoneCampaign::converged() const {
  return found.converged && levels.converged && verified.converged() &&
         std::ranges::all_of(left_out, &LeftOut::converged);
}

std::vector<ResultFile> planned_files(const CampaignRun& run) {
  require_result_folder(run.out);
  return planned_files(run, open_campaign(run));
}

std::vector<ResultFile> planned_files(const CampaignRun& run, const OpenedCampaign& opened) {
  require_result_folder(run.out);
  std::vector<ResultFile> files = files_of(run, opened);
  check_inputs_kept(run.out, files, inputs_of(run, opened));
  return files;
}

DoneCampaign run_campaign(const CampaignRun& run) { return run_campaign(run, open_campaign(run)); }

DoneCampaign run_campaign(const CampaignRun& run, const OpenedCampaign& opened) {
  return CampaignWork(run, opened).done();
}

}  // namespace microslip
