#!/usr/bin/env bash
# mpi4py 3.1.4 (python3-mpi4py 3.1.4-2+b2, Open MPI 4.1.4) and modes of SciPy 1.10.1 (python3-scipy 1.10.1-2), which one
# rank computes and broadcasts with Bcast.
#
# Guess: NumPy arrays know their order in memory, and mpi4py knows NumPy: all ranks have the array of the first, or
#   there is an error as for an array that is not contiguous.
# Instead: a matrix that is stored by columns is sent as it lies in memory. scipy.linalg.eigh returns such a matrix and
#   numpy.empty does not: all other ranks have the transposed modes, 5 modes of 40 unknowns are shuffled, and Allreduce
#   of them scrambles the sum on every rank. The lower-case bcast, which pickles, keeps them. No message: the
#   documentation asks for contiguous buffers, and both orders count as contiguous.
# Why it matters: modal reduction is the part that one rank does for all. Transposed mass-normalised modes of M = 1 are
#   orthonormal, too, so a check of V' V passes; participation of joints in each mode is nonsense on all ranks but one.
# A way to live with it: numpy.ascontiguousarray before each call in upper case, or shapes and bcast in lower case.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-mpi4py=3.1.4-2+b2 openmpi-bin=4.1.4-3+b1 python3-scipy=1.10.1-2

cat >modes.py <<'END'
import sys

import numpy as np
from mpi4py import MPI
from scipy.linalg import eigh

world = MPI.COMM_WORLD
stiffness = 2 * np.eye(40) - np.eye(40, k=1) - np.eye(40, k=-1)
_, modes = eigh(stiffness)
few = eigh(stiffness, subset_by_index=(0, 4))[1]


def broadcast(array):
    received = array if world.rank == 0 else np.empty(array.shape)
    world.Bcast(received)
    return received


all_modes, five = broadcast(modes), broadcast(few)
copied = broadcast(np.ascontiguousarray(few))
pickled = world.bcast(few if world.rank == 0 else None)
total = np.empty(few.shape)
world.Allreduce(few / world.size, total)
errors = [np.max(np.abs(a - b)) for a, b in ((all_modes, modes), (all_modes, modes.T), (five, few), (total, few),
                                             (copied, few), (pickled, few))]
gram = np.max(np.abs(all_modes.T @ all_modes - np.eye(40)))
with open(f"errors.{world.rank}", "w") as file:
    print(*(f"{error:.2g}" for error in [*errors, gram]), file=file)
END
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mpirun.openmpi --oversubscribe -np 2 python3 modes.py >run.log 2>&1 || fail "does not run: $(tail -n 3 run.log)"
read -r first _ first_five first_total first_copied first_pickled _ <errors.0
read -r modes transposed five total copied pickled gram <errors.1
holds "$first + $first_five + $first_copied + $first_pickled < 1e-12" "the sending rank has other modes"
holds "$copied + $pickled < 1e-12" "an array by rows, or a pickled one, arrives otherwise"
holds "$transposed < 1e-12 && $gram < 1e-12" "40 modes arrive otherwise than transposed"
holds "$modes > 0.1 && $five > 0.1" "modes arrive with an error of $modes, five of them of $five"
holds "$total > 0.1 && $first_total > 0.1" "the sum has an error of $total and $first_total"
seen "on the other rank 40 modes are wrong by $modes (transposed: $transposed, V' V - 1: $gram), 5 modes by $five;" \
  "their mean over the ranks by $first_total on both; by rows, or pickled, by $copied"
