#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): scipy.sparse.linalg.minres of a chain of springs with a stiff one to ground.
#
# Guess: with info = 0 the residual is below tol times the load, as its text says ("terminates when the relative
#   residual is below tol") and as `cg` beside it keeps; a penalty spring costs iterations.
# Instead: a chain of 400 springs of 1e3 N/m from a wall, held at its middle by one of 1e6 or 1e9 N/m, 1 N on each
#   mass, tol 1e-8: info is 0 and the residual 37 % and 96 % of the load; the free end moves by 47 % and 0.3 % of what
#   is right. `cg` with the same tol is right. The residual is compared with the norm of the matrix times that of the solution, to which the
#   stiffest spring of all sets the scale.
# Why it matters: minres is what is taken for shifted or constrained stiffnesses, which are indefinite; ground springs,
#   bolts and penalties are orders stiffer than what they hold, and info is all that a solver says.
# A way to live with it: compute the residual; or scale the matrix by its diagonal and look at it even so; or a direct
#   solver.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >solve.py <<'END'
import numpy as np
from scipy.sparse import diags
from scipy.sparse.linalg import cg, minres, spsolve

count = 400
stiffness = diags([-1e3, 2e3, -1e3], [-1, 0, 1], shape=(count, count)).tolil()
stiffness[-1, -1] = 1e3
force = np.ones(count)


def tried(solve, ground):
    matrix = stiffness.copy()
    matrix[count // 2, count // 2] += ground
    matrix = matrix.tocsr()
    right = spsolve(matrix.tocsc(), force)[-1]
    found, info = solve(matrix, force, tol=1e-8, maxiter=100000)
    assert info == 0
    return np.linalg.norm(force - matrix @ found) / np.linalg.norm(force), found[-1] / right


for ground in (1e6, 1e9):
    of_minres, of_cg = tried(minres, ground), tried(cg, ground)
    print(f"{ground:.0e} N/m: minres, info 0: residual {of_minres[0]:.2g}, end {of_minres[1]:.3g} of its place;"
          f" cg: {of_cg[0]:.1e}, {of_cg[1]:.6f}", end=". ")
    assert of_minres[0] > 0.3 and of_minres[1] < 0.5
    assert of_cg[0] < 2e-8 and abs(of_cg[1] - 1) < 1e-4
END
python3 solve.py >solve.txt || fail "minres and cg differ otherwise: $(cat solve.txt)"
seen "$(cat solve.txt)"
