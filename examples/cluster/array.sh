#!/bin/bash
#SBATCH --job-name=microslip
#SBATCH --array=1-20
#SBATCH --cpus-per-task=1
#SBATCH --time=04:00:00
# One of 20 shares of a plan. A job keeps its progress in its journal: submitted again, it resumes; some of them by
# sbatch --array=3,7 array.sh. The number of shares is that of --array above, and stays so then: the COUNT of Slurm is
# that of the jobs that are submitted together.
set -euo pipefail
shares=20
microslip ensemble plan.toml --out result.h5 --threads 1 --quiet --shard "$SLURM_ARRAY_TASK_ID/$shares"
