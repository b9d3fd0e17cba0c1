// SPDX-License-Identifier: MIT
#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <string>
#include <vector>

#include "microslip/ensemble/team.hpp"

namespace microslip::app {

/// The ranks of a communicator. Rank 0 deals blocks, receives what they gave, and does blocks
/// itself meanwhile: between its jobs it answers. Another rank has a block in reserve while many
/// are left, so that it need not wait for the answer; towards the end it has none, so that all end
/// at once. Waiting sleeps, where MPI would keep a core busy.
class MpiTeam : public Team {
 public:
  /// Of MPI_COMM_WORLD, after MPI_Init().
  MpiTeam();

  bool coordinates() const override { return rank_ == 0; }
  void agree(const std::string& text, const std::string& failure) override;
  void deal(const std::vector<std::uint64_t>& blocks, const Work& work,
            const Receive& receive) override;

 private:
  class Dealer;
  class Worker;

  int rank_ = 0;
  int size_ = 1;
};

}  // namespace microslip::app
