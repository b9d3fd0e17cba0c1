// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "microslip/algebra/core.hpp"
#include "microslip/base/progress.hpp"
#include "microslip/dynamics/harmonic/balance_equations.hpp"
#include "microslip/dynamics/harmonic/continuation.hpp"
#include "microslip/dynamics/harmonic/harmonic_balance_options.hpp"
#include "microslip/dynamics/harmonic/newton.hpp"

namespace microslip {

/// Follows the curve of phase resonance over the response, round its folds. Internal to dynamics.
class ResonanceTracer {
 public:
  ResonanceTracer(const JointedStructure& structure, const ResponsePoint& response,
                  const HarmonicBalanceOptions& options, Forcing forcing);

  /// A solution of the equations and its response.
  struct Place {
    Eigen::VectorXd z;
    double response;
  };

  /// A part of the curve; between two consecutive places the response is monotone, and folds are
  /// places.
  struct Piece {
    std::vector<Place> places;
    bool complete = false;  ///< reached where it was to go
    bool returned = false;  ///< turned back to the response it came from: cut where it turned
    bool begins_at_fold = false;
    bool from_rest = false;  ///< begins where the joints hardly slip
    std::string reason;      ///< why it ended
  };

  /// Rows at responses on a piece, folds among them.
  struct Rows {
    std::vector<SteadyVibration> points;
    std::vector<std::size_t> folds;  ///< which are those
    std::vector<double> missed;  ///< responses that the piece has, but Newton's method did not find
  };

  /// At a level at which the joints hardly slip, but not above `most`; none where Newton's method
  /// does not converge.
  [[nodiscard]] std::optional<Place> at_rest(double stuck_frequency, double most);

  /// From z, near it, exactly to this response.
  [[nodiscard]] std::optional<Place> near(const Eigen::VectorXd& z, double response);

  /// From a place to a response above or below it.
  [[nodiscard]] Piece follow(const Place& from, double to, const Progress& progress);

  /// In the order of the curve. @param responses  rising.
  [[nodiscard]] Rows rows(const Piece& piece, std::span<const double> responses,
                          const Progress& progress);

  /// Where the piece first has this response.
  [[nodiscard]] std::optional<Place> first_at(const Piece& piece, double response);

  [[nodiscard]] BalanceEquations& equations() { return equations_; }
  [[nodiscard]] const ContinuationOptions& options() const { return options_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] double residual() const { return residual_; }

 private:
  bool correct(const Place& from, const Place& to, double share, Place& place);
  void locate_folds(Piece& piece);
  void cut_return(Piece& piece) const;
  [[nodiscard]] std::optional<Place> between(const Place& from, const Place& to, double response);
  [[nodiscard]] std::optional<Place> bisected(const Place& from, const Place& to, double response);
  void count(const NewtonResult& result);

  BalanceEquations equations_;
  ContinuationOptions options_;
  int iterations_ = 0;
  double residual_ = 0.0;
};

}  // namespace microslip
