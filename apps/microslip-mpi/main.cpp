// SPDX-License-Identifier: MIT
#include <mpi.h>

#include <cstdio>
#include <memory>
#include <string>

#include "arguments/command.hpp"
#include "microslip/base/error.hpp"
#include "mpi_team.hpp"

namespace {

std::unique_ptr<microslip::Team> make_mpi_team(std::size_t threads) {
  if (threads > 1) {
    throw microslip::InputError("--threads", static_cast<double>(threads),
                                "must be 1 of an MPI rank", "Start more ranks.");
  }
  return std::make_unique<microslip::app::MpiTeam>();
}

/// All ranks would report a wrong call; only rank 0 does.
void be_silent() {
  const bool silent = std::freopen("/dev/null", "w", stdout) != nullptr &&
                      std::freopen("/dev/null", "w", stderr) != nullptr;
  if (!silent) std::fputs("microslip-mpi: /dev/null cannot be opened\n", stderr);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) be_silent();
  microslip::app::Call call;
  call.make_team = make_mpi_team;
  const int status =
      microslip::app::run_program(argc, argv, call, microslip::app::make_cluster_program);
  MPI_Finalize();
  return status;
}
