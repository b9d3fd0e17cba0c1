// SPDX-License-Identifier: MIT
#include <mpi.h>

#include <array>
#include <cstdio>
#include <cstdlib>
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

/// A number that a launcher has put into the environment; 0 where there is none.
long number_of(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? 0 : std::strtol(value, nullptr, 10);
}

/// Launchers, by what they tell the processes that they start.
struct Launcher {
  const char* size;
  const char* rank;
};
constexpr std::array<Launcher, 3> kLaunchers{{{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                              {"PMI_SIZE", "PMI_RANK"},
                                              {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}}};

/// "Open MPI v4.1.4": the first words of what the library tells of itself.
std::string mpi_name() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING + 1> text{};
  int size = 0;
  MPI_Get_library_version(text.data(), &size);
  const std::string all(text.data());
  return all.substr(0, all.find_first_of(",\n"));
}

/// Whether a launcher has started several processes, each of which is alone to this library: that
/// of another MPI. All would do the same work. The first says so.
bool are_strangers() {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (ranks > 1) return false;
  for (const Launcher& launcher : kLaunchers) {
    const long started = number_of(launcher.size);
    if (started <= 1) continue;
    if (number_of(launcher.rank) == 0) {
      const std::string mpi = mpi_name();
      std::fprintf(
          stderr,
          "microslip-mpi: %s = %ld; the processes that were started do not know of each "
          "other: this program is built with %s, and the launcher is of another MPI, or it was "
          "started without one. Start it with the mpirun of %s, or with srun --mpi=pmix.\n",
          launcher.size, started, mpi.c_str(), mpi.c_str());
    }
    return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  if (are_strangers()) {
    MPI_Finalize();
    return microslip::app::kInputAtFault;
  }
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
