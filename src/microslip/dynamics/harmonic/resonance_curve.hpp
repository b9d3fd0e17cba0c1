// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/dynamics/harmonic/resonance_tracer.hpp"

namespace microslip {

/// HarmonicBalance::resonances(): the pieces of the curve of phase resonance of a mode. Internal to
/// dynamics.
///
/// The curve begins where all joints stick. With a force at a point it may end: where the other
/// modes move the response point more than this one, the lag does not reach π/2, and resonance and
/// antiresonance meet in a fold. Then, and where it does not even begin, the nonlinear mode (modal
/// forcing), which has no such end, leads to where phase resonance would be: Newton's method and a
/// curve over the frequency at constant response decide whether there is one.
class ResonanceCurve {
 public:
  ResonanceCurve(const JointedStructure& structure, const ResponsePoint& response,
                 const HarmonicBalanceOptions& options, std::size_t mode, double stuck_frequency);

  /// @param responses  rising.
  ResponseCurve at(std::span<const double> responses, const Progress& progress);

 private:
  using Place = ResonanceTracer::Place;
  using Piece = ResonanceTracer::Piece;

  /// Resonance of the nonlinear mode.
  struct Mode {
    SteadyVibration vibration;
    double frequency;  ///< rad/s
    double damping;    ///< ζ
  };

  /// A response at which no phase resonance was found, with the evidence.
  struct InVain {
    double response;
    std::string evidence;
  };

  void begin(double lowest);
  [[nodiscard]] bool is_resonance(const Place& place, double frequency, double damping);
  [[nodiscard]] std::optional<Mode> mode_at(double response);
  [[nodiscard]] std::optional<Place> find(double response, std::string& evidence);
  [[nodiscard]] std::optional<Place> from_mode(const Mode& mode, double response);
  [[nodiscard]] std::optional<Place> sweep(const Mode& mode, double response,
                                           std::string& evidence);
  void find_more(std::span<const double> responses);
  void trace_from(const Place& place, double lowest);
  void conclude(std::span<const double> responses, ResponseCurve& curve);
  [[nodiscard]] std::string why_not() const;
  [[nodiscard]] const Piece* piece_with(double response) const;
  [[nodiscard]] std::string what_there_is() const;
  [[nodiscard]] std::string text_of(double response) const;
  [[nodiscard]] std::string at_response(double response) const;
  [[nodiscard]] Progress ticking() const;

  const JointedStructure& structure_;
  ResponsePoint response_;
  HarmonicBalanceOptions options_;
  std::size_t mode_;
  double stuck_frequency_;
  ResonanceTracer tracer_;
  std::optional<ResonanceTracer> guide_;  ///< of the nonlinear mode
  Piece guide_piece_;
  std::vector<Piece> pieces_;
  double reached_ = 0.0;  ///< the highest response of the pieces and of those without a resonance
  std::vector<InVain> in_vain_;
  bool judged_ = true;    ///< whether all curves that were to show that reached their end
  double highest_ = 0.0;  ///< of the requested responses
  Progress progress_;
  std::size_t count_ = 0;
};

}  // namespace microslip
