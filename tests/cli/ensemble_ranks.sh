#!/usr/bin/env bash
# The ranks of MPI give the bytes that one process gives, however many they are and whichever of them is killed.
# Usage: ensemble_ranks.sh MICROSLIP MICROSLIP-MPI EXAMPLES [KILLS]
set -euo pipefail
program="$1" ranks="$2" examples="$3"
counts=(1 2 3 7) some=4
[[ -n "${MICROSLIP_STUDIES:-}" ]] || counts=(1 3) some=2 # all of them in scripts/test_studies
kills="${4:-${MICROSLIP_RANK_KILLS:-$some}}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none # sandboxes forbid it, and Open MPI says so
export OMPI_MCA_btl=self,vader OMPI_MCA_plm_rsh_agent=sh

# Without pgrep, which a small system lacks.
processes_of_ranks() {
  local folder
  for folder in /proc/[0-9]*; do
    if tr '\0' ' ' 2>/dev/null <"$folder/cmdline" | grep -q "^$ranks ensemble plan.toml --out r.h5"; then
      echo "${folder#/proc/}"
    fi
  done
}

fail() {
  echo "ensemble_ranks: $*" >&2
  exit 1
}

cp "$examples/one_mass/joint.json" .
sed 's/^damping_ratio/frequency_std = [0.01]\n&/' "$examples/one_mass/model.toml" >model.toml
cat >plan.toml <<'END'
schema = "microslip.ensemble/1"
kind = "predict"
raw = ["*"]
[predict]
model = "model.toml"
draws = 300
[[case]]
kind = "frf"
force_N = 0.05
frequency_Hz = [0.12, 0.18]
END

"$program" ensemble plan.toml --out whole.h5 --threads 1 --quiet
for n in "${counts[@]}"; do
  mpirun -n "$n" "$ranks" ensemble plan.toml --out r.h5 --quiet
  cmp r.h5 whole.h5 || fail "$n ranks gave other bytes"
  rm r.h5
done

# A launcher of another MPI starts several, each of which would be alone and do all of the work.
for launcher in "PMI_SIZE=3 PMI_RANK" "OMPI_COMM_WORLD_SIZE=3 OMPI_COMM_WORLD_RANK" "SLURM_STEP_NUM_TASKS=3 SLURM_PROCID"; do
  for rank in 0 1; do
    # shellcheck disable=SC2086 # two variables
    env $launcher=$rank "$ranks" ensemble plan.toml --out stranger.h5 2>said && fail "$launcher=$rank was not refused"
    [[ "$rank" == 1 ]] || grep -q "SIZE = 3.* do not know of each other.*built with\|TASKS = 3.* built with" said ||
      fail "$launcher: $(cat said)"
    [[ "$rank" == 0 || ! -s said ]] || fail "rank 1 of $launcher says the same again: $(cat said)"
  done
done
[[ ! -e stranger.h5 && ! -e stranger.h5.journal ]] || fail "strangers have begun to work"

# Any rank is killed at any moment; then another number of ranks goes on.
RANDOM=1
for ((i = 0; i < kills; ++i)); do
  mpirun -n 3 "$ranks" ensemble plan.toml --out r.h5 --quiet >killed.log 2>&1 &
  mpi=$!
  sleep "0.$((RANDOM % 5))$((RANDOM % 10))"
  mapfile -t processes < <(processes_of_ranks)
  if ((${#processes[@]} > 0)); then
    kill -9 "${processes[RANDOM % ${#processes[@]}]}" 2>/dev/null || true
  fi
  wait "$mpi" || true
  while [[ -n "$(processes_of_ranks)" ]]; do sleep 0.05; done
  mpirun -n $((1 + RANDOM % 4)) "$ranks" ensemble plan.toml --out r.h5 --quiet
  cmp r.h5 whole.h5 || fail "after kill $i other bytes"
  [[ ! -e r.h5.journal ]] || fail "after kill $i a journal is left"
  rm r.h5
done

# A wrong call is reported once, by rank 0, and ends all of them.
status=0
mpirun -n 3 "$ranks" ensemble nothing.toml --out r.h5 >errors.log 2>&1 || status=$?
[[ $status -eq 2 ]] || fail "a missing plan: status $status"
[[ $(grep -c '^microslip: nothing.toml' errors.log) -eq 1 ]] || fail "not reported once: $(cat errors.log)"

# A rank that reads other inputs is named. Each rank has a folder of its own here.
for r in 0 1; do
  mkdir "rank$r"
  cp plan.toml model.toml joint.json "rank$r"
done
sed -i 's/frequency_std = \[0.01\]/frequency_std = [0.02]/' rank1/model.toml
status=0
mpirun -n 2 sh -c "cd rank\$OMPI_COMM_WORLD_RANK && exec $ranks ensemble plan.toml --out r.h5" \
  >errors.log 2>&1 || status=$?
[[ $status -eq 2 ]] || fail "other inputs: status $status: $(cat errors.log)"
grep -q 'rank 1 on .*sha256 of model.toml' errors.log || fail "not named: $(cat errors.log)"
echo "ensemble_ranks: ${counts[*]} ranks and $kills kills gave the same bytes"
