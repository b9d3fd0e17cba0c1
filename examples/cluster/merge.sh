#!/bin/bash
#SBATCH --job-name=microslip-merge
#SBATCH --cpus-per-task=8
#SBATCH --time=01:00:00
# Takes the journals of all shares, does what they lack, and writes result.h5 and result.csv.
set -euo pipefail
microslip ensemble plan.toml --out result.h5 --threads "${SLURM_CPUS_PER_TASK:-1}"
