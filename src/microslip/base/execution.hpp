// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include "microslip/base/progress.hpp"

namespace microslip {

/// How independent pieces of work are executed: one after the other, on the threads of this
/// machine, or by a function of the caller. Results never depend on it: a piece is a function of
/// its number alone. A value; copies do the same.
class Execution {
 public:
  /// A piece of work, by its number. Called for several numbers at once.
  using Work = std::function<void(std::size_t index)>;
  /// Calls work(i) once for each i below `count`, in any order, and returns when all are done.
  /// Where pieces throw, one of the exceptions is thrown on, and pieces that have not begun may be
  /// left out.
  using ForEach = std::function<void(std::size_t count, const Work& work)>;

  /// One after the other in the calling thread, in their order.
  [[nodiscard]] static Execution serial();

  /// On threads, the calling one among them.
  /// @param most  the largest number of threads, limited to the number of processors; 0: one per
  ///              processor.
  [[nodiscard]] static Execution threads(std::size_t most = 0);

  /// By a function of the caller: on the processes of a cluster, in the pool of another library.
  /// @throws InputError  for an empty function.
  explicit Execution(ForEach for_each);

  /// Does all pieces. See ForEach for what they throw.
  void for_each(std::size_t count, const Work& work) const;

  /// Does all pieces and reports the number done, one call at a time. The listener does no parallel
  /// work itself.
  /// @throws Cancelled  when progress returns false; pieces that have not begun are left out.
  void for_each(std::size_t count, const Work& work, const Progress& progress) const;

 private:
  ForEach for_each_;
};

}  // namespace microslip
