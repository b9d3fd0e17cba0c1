// SPDX-License-Identifier: MIT
#include "microslip/workflow/compare/recordings_verification.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "microslip/documents/joint/joint_file.hpp"
#include "microslip/documents/levels/test_file.hpp"
#include "microslip/documents/response/verification_file.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/cells/csv_writer.hpp"
#include "microslip/io/kinds/file_kind.hpp"
#include "microslip/workflow/compare/verification_text.hpp"
#include "microslip/workflow/predict/model_text.hpp"
#include "microslip/workflow/reduce/named_recordings.hpp"
#include "microslip/workflow/text/distinct_files.hpp"
#include "microslip/workflow/text/named_rig.hpp"

namespace microslip {
namespace {

struct VerificationOutput {
  std::string path;
  std::string_view kind;
  CsvWriter (*make)(std::span<const Verification>);
};

std::vector<VerificationOutput> outputs_of(const VerificationTables& tables) {
  std::vector<VerificationOutput> all{{tables.table, kVerificationKind, verification_table},
                                      {tables.harmonics, kHarmonicsKind, harmonics_table},
                                      {tables.histories, kHistoriesKind, histories_table}};
  std::erase_if(all, [](const VerificationOutput& one) { return one.path.empty(); });
  return all;
}

std::string comment_of(const VerifiedRecordings& verified, const std::string& command) {
  const VerificationBatch& batch = verified.batch;
  check_any_left("verified", verified.files, batch.records.size(), batch.rejected);
  std::string comment = provenance_of(command, verified.inputs);
  const std::string damping = damping_text(verified.verifier.options().linear_damping);
  if (!damping.empty()) comment += "\nlinear damping of the joint: " + damping;
  std::vector<std::vector<Warning>> warnings = verified.warnings;
  warnings.push_back(verification_warnings(batch));
  if (verified.spread) warnings.push_back(verified.spread->warnings);
  return with_warnings(std::move(comment), joined_warnings(warnings));
}

}  // namespace

VerifiedRecordings verify_recordings(const RecordingsVerification& options) {
  check_distinct_files(options.recordings);
  std::vector<NamedInput> inputs{{options.rig, read_text(options.rig)},
                                 {options.joint, read_text(options.joint)}};
  const Rig rig = parse_rig(inputs[0]);
  const JointFile joint = parse_joint(inputs[1].text, input_name(options.joint));
  VerificationOptions verification = options.verification;
  verification.covered_to = covered_to(joint);
  verification.linear_damping = identified_damping(joint).value_or(0.0);
  Verifier verifier = of_rig(inputs[0], [&] { return Verifier(rig, joint.joint, verification); });
  const std::size_t count = options.recordings.size();
  VerifiedRecordings verified{std::move(inputs), count, std::move(verifier), {}, {}};
  verified.warnings.resize(count);
  const auto read = [&](std::size_t i) {
    const TestFile file = open_test(options.recordings[i], Hashed::kNo);
    if (file.content == TestContent::kSteppedSine) {
      throw InputError(
          file.path, "a stepped-sine table", "must be a steady record in time",
          "verify compares such tables with a model.toml; reduce makes levels of them.");
    }
    return named_recordings(read_recordings(file, options.reading), file.path,
                            verified.warnings[i]);
  };
  // Read before the records, which take longer.
  JointDraws draws;
  if (options.draws && !options.draws->samples.empty()) {
    draws = joint_draws_of(
        samples_for(options.draws->samples, joint.joint.stiffness(), "the joint"), false);
  }
  verified.batch = verify_batch(verified.verifier, count, read,
                                {.skip_faulty = options.skip_faulty, .progress = options.progress});
  if (options.draws && verified.batch.converged() && !verified.batch.records.empty()) {
    verified.spread = verification_spread(
        verified.verifier, verified.batch.records, std::move(draws), options.draws->rig,
        options.draws->options, options.draws->execution, options.draws->progress);
  }
  return verified;
}

std::vector<PlannedOutput> planned(const VerificationTables& tables) {
  std::vector<PlannedOutput> outputs;
  for (const auto& [path, kind, make] : outputs_of(tables)) outputs.push_back({path, kind});
  return outputs;
}

void add_tables(const VerifiedRecordings& verified, const VerificationTables& tables,
                const std::string& command, OutputFiles& files) {
  const std::string comment = comment_of(verified, command);
  for (const auto& [path, kind, make] : outputs_of(tables)) {
    CsvWriter table = make(verified.batch.records);
    table.add_comment(comment);
    if (verified.spread) table.add_comment(checked_comment(*verified.spread));
    if (verified.spread && kind == kVerificationKind) {
      add_checked(*verified.spread, verified.batch.records, table);
    }
    files.add(path, table.str());
  }
}

}  // namespace microslip
