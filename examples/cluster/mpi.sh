#!/bin/bash
#SBATCH --job-name=microslip
#SBATCH --ntasks=64
#SBATCH --time=04:00:00
# Rank 0 deals blocks to the ranks as they get free. Submitted again, with any number of ranks, it goes on.
set -euo pipefail
mpirun -n "${SLURM_NTASKS:-2}" microslip-mpi ensemble plan.toml --out result.h5
