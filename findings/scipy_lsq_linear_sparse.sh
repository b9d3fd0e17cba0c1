#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): scipy.optimize.lsq_linear of a sparse matrix with columns in several units.
#
# Guess: a matrix in sparse storage gives what it gives in dense storage, or a status that says it has not converged.
# Instead: 200 equations in 50 unknowns, the columns between 1 and 1e4 and else well conditioned: dense, the solution
#   is exact; sparse, it is wrong by more than itself, with success and "The unconstrained solution is optimal". The
#   inner solver LSMR has stopped at its limit of as many iterations as there are unknowns, which nobody looks at.
# Why it matters: matrices of modal identification and of forces at joints mix displacements with rotations and
#   frequencies with losses, are sparse, and the answer must not be negative, so this is the function. A cost that is
#   not small is taken for noise.
# A way to live with it: divide each column by its norm; or a dense matrix; or lsmr_tol and lsmr_maxiter.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >solve.py <<'END'
import numpy as np
from scipy.optimize import lsq_linear
from scipy.sparse import csr_matrix

random = np.random.default_rng(0)
units = np.geomspace(1, 1e4, 50)
matrix = random.standard_normal((200, 50)) * units
truth = random.uniform(0.5, 1.5, 50) / units
known = matrix @ truth


def error_of(matrix, units=1.0):
    result = lsq_linear(matrix, known, bounds=(0, 100))
    assert result.success, result.message
    return np.max(np.abs(result.x / units / truth - 1)), result.message


dense, sparse, scaled = error_of(matrix), error_of(csr_matrix(matrix)), error_of(csr_matrix(matrix / units), units)
print(f"relative error: dense {dense[0]:.1e}, sparse {sparse[0]:.1e} ({sparse[1]}),"
      f" sparse with scaled columns {scaled[0]:.1e}")
assert dense[0] < 1e-8 and scaled[0] < 1e-3
assert sparse[0] > 0.5
END
python3 solve.py >solve.txt || fail "sparse and dense differ otherwise: $(cat solve.txt)"
seen "$(cat solve.txt)"
