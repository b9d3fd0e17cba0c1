// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "microslip/base/execution.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/base/summary.hpp"
#include "microslip/documents/joint/joint_samples_file.hpp"
#include "microslip/documents/structure/model_file.hpp"
#include "microslip/dynamics/draws/structure_draws.hpp"

/// @file
/// Draws of a model, and what became of predictions by them.

namespace microslip {

// g++ 12 says that scoped enumerators hide names of other types, which they do not.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"

/// How draws of several joints go together.
enum class Correlation {
  kAuto,         ///< together where one calibration drew them, else each by itself
  kTogether,     ///< draws of the same number belong together
  kIndependent,  ///< each by itself
};

#pragma GCC diagnostic pop

/// Number and options of draws.
struct DrawOptions {
  std::size_t count = 0;                         ///< N; 0: none
  double confidence = 0.95;                      ///< P, share of the draws between the quantiles
  std::uint64_t seed = 1;                        ///< s
  Correlation correlation = Correlation::kAuto;  ///< of several joints

  /// @throws InputError  for P outside of (0, 1) or so few draws that none lies beyond a quantile,
  ///                     N < 2/(1 − P); for more than kMostDraws.
  void check() const;

  /// ⌈2/(1 − P)⌉. @param confidence  P, in (0, 1).
  [[nodiscard]] static std::size_t fewest(double confidence);

  /// That all draws together, kept for their quantiles, are not too many numbers.
  /// @param values  of one draw.
  /// @param remedy  what the user can do beside fewer draws, a sentence.
  /// @throws InputError  as check_memory().
  void check_size(std::size_t values, const std::string& remedy) const;

  /// More are a mistake.
  static constexpr std::size_t kMostDraws = 1'000'000;
};

/// Draws of a model file: the samples of its joints, which are read, and its spread.
/// @throws FileError, FormatError, InputError  as read_joint_samples(); naming the joint, where its
///     samples are of a joint of another stiffness; where nothing of the model is uncertain.
[[nodiscard]] StructureDraws draws_of(const ModelFile& model, const std::string& file,
                                      const DrawOptions& options);

/// Draws of a structure without a file, as above.
/// @param structure     as it is thought to be.
/// @param spread        of its numbers.
/// @param samples       of each joint, nothing where it has none; or none.
/// @param damping_said  of each joint: see joint_draws_of(); fewer: not given.
/// @param options       which draws.
/// @param name          of the structure in messages.
/// @throws InputError   as StructureDraws; where nothing is uncertain.
[[nodiscard]] StructureDraws draws_of(const JointedStructure& structure,
                                      const StructureSpread& spread,
                                      std::vector<std::optional<JointSamples>> samples,
                                      const std::vector<bool>& damping_said,
                                      const DrawOptions& options, const std::string& name);

/// The draws of a file, for a joint of this stiffness.
/// @param path       of the file.
/// @param stiffness  k of the joint, N/m.
/// @param name       of it in messages.
/// @throws FileError, FormatError, InputError  as draws_of().
[[nodiscard]] JointSamples samples_for(const std::string& path, double stiffness,
                                       const std::string& name);

/// Samples as draws of a joint.
/// @param samples       of it.
/// @param damping_said  the model gives its linear damping: that of the draws is not used.
[[nodiscard]] JointDraws joint_draws_of(JointSamples samples, bool damping_said);

/// Outcome of the draws of a prediction.
struct DrawsTaken {
  /// Draws that failed for one reason.
  struct Failure {
    std::string reason;       ///< in words
    std::size_t count = 0;    ///< how many
    std::size_t example = 0;  ///< the number of the first
  };

  DrawOptions options;            ///< as asked for
  std::vector<Failure> failures;  ///< the most frequent first

  /// How many failed: they are in no quantile.
  [[nodiscard]] std::size_t failed() const;
  /// Whether more than kMostFailed did: what is left may be another population.
  [[nodiscard]] bool too_many_failed() const;

  /// Share of the draws that may fail.
  static constexpr double kMostFailed = 0.1;
};

/// Does work(i) for each draw, in parallel.
/// @param options    which draws.
/// @param work       gives why the draw failed, nothing where it did not; an InputError of it
///                   counts as the reason. Called for several draws at once.
/// @param execution  of the draws.
/// @param progress   reports the number done; may cancel.
/// @return what became of them.
/// @throws Cancelled  as progress says.
[[nodiscard]] DrawsTaken take_draws(const DrawOptions& options,
                                    const std::function<std::string(std::size_t i)>& work,
                                    const Execution& execution, const Progress& progress);

/// Quantiles of what draws gave, one per row.
struct Band {
  std::vector<double> lower;  ///< (1 − P)/2 of them below
  std::vector<double> upper;  ///< and above
};

/// The band of values of draws that did not fail.
/// @param lower       of each draw, one per row; empty where it failed.
/// @param upper       the same where a draw has one value.
/// @param confidence  P.
/// @throws InputError  where all failed.
[[nodiscard]] Band band_of(const std::vector<std::vector<double>>& lower,
                           const std::vector<std::vector<double>>& upper, double confidence);

/// Quantiles of draws with one value each.
/// @param values      of each draw, one per row; empty where it failed.
/// @param confidence  P.
[[nodiscard]] Band band_of(const std::vector<std::vector<double>>& values, double confidence);

// Keys of comments, see comment_entry.hpp.
inline constexpr std::string_view kDrawsKey = "draws";               ///< number, seed, quantiles
inline constexpr std::string_view kDrawsFailedKey = "draws_failed";  ///< of how many
inline constexpr std::string_view kFailureKey = "failure";           ///< why, each cause

/// Comments of a table: how many draws, of which seed, between which quantiles, and what failed.
/// @param taken  what became of them.
/// @param what   is uncertain, as uncertain_text().
[[nodiscard]] std::string draws_comment(const DrawsTaken& taken, const std::string& what);

/// "samples of 'lap'; frequency_std; normal_load_std of 'lap'": what draws of a model vary.
[[nodiscard]] std::string uncertain_text(const ModelFile& model);

/// The lines of a summary on draws.
[[nodiscard]] std::string describe_draws(const DrawsTaken& taken, const std::string& what);

/// Warnings on the band.
[[nodiscard]] std::vector<Warning> draw_warnings(const DrawsTaken& taken);

}  // namespace microslip
