// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "microslip/base/execution.hpp"

/// @file
/// Teams that do the blocks of an ensemble: the threads of this process, or the ranks of a cluster.

namespace microslip {

/// One process or several that share work. All of them call the same functions in the same order.
class Team {
 public:
  /// Does a block; a function of its number alone. Called for several at once. It calls the second
  /// between its jobs, so that a process can answer others meanwhile, and passes on exceptions of
  /// that.
  using Work =
      std::function<std::string(std::uint64_t block, const std::function<void()>& between_jobs)>;
  /// Takes what a block gave, one at a time, where coordinates() is true. False: no more is dealt.
  using Receive = std::function<bool(std::uint64_t block, const std::string& done)>;

  virtual ~Team() = default;

  /// Whether this process receives results, writes and reports.
  [[nodiscard]] virtual bool coordinates() const = 0;

  /// Comes to the same everywhere, before anything is dealt.
  /// @param text     that all must have alike: a fingerprint.
  /// @param failure  why this process cannot take part; empty where it can.
  /// @throws InputError  at the coordinator, naming a process that has another text, and the first
  ///     line that differs; or one that failed, and why.
  /// @throws StoppedElsewhere  at the others.
  virtual void agree(const std::string& text, const std::string& failure) = 0;

  /// Distributes blocks, and returns in all processes when all are done or none is left.
  /// @param blocks   their numbers; those of the coordinator count.
  /// @param work     run by each process for a block.
  /// @param receive  called by the coordinator with the results.
  /// @throws  at the coordinator what work throws anywhere, and what receive throws.
  /// @throws StoppedElsewhere  at the others where that is.
  virtual void deal(const std::vector<std::uint64_t>& blocks, const Work& work,
                    const Receive& receive) = 0;
};

/// Ends a process where another one reports the reason.
class StoppedElsewhere : public std::exception {
 public:
  /// A text nevertheless.
  [[nodiscard]] const char* what() const noexcept override { return "stopped by another process"; }
};

/// This process alone, on its threads.
class LocalTeam : public Team {
 public:
  /// @param execution  of the blocks.
  explicit LocalTeam(Execution execution = Execution::threads());

  bool coordinates() const override { return true; }
  void agree(const std::string& text, const std::string& failure) override;
  void deal(const std::vector<std::uint64_t>& blocks, const Work& work,
            const Receive& receive) override;

 private:
  Execution execution_;
};

}  // namespace microslip
