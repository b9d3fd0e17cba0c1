#!/bin/bash
#SBATCH --job-name=microslip
#SBATCH --array=1-20
#SBATCH --cpus-per-task=1
#SBATCH --time=04:00:00
# One of 20 shares of a plan. A job keeps its progress in its journal: submitted again, it resumes.
set -euo pipefail
microslip ensemble plan.toml --out result.h5 --threads 1 --quiet \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
