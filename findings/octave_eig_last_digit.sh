#!/usr/bin/env bash
# GNU Octave 7.3.0 (octave 7.3.0-2): eig(K, M) of a stiffness that is symmetric but for the last digit of one number.
#
# Guess: modes change by rounding errors.
# Instead: the other algorithm is taken. Frequencies are no longer in ascending order, and shapes are no longer
#   normalised to the mass: V' * M * V is 3.7 instead of 1 for three masses of 2 kg, and differs from mode to mode where
#   masses differ. No message. A K that is summed in another order than its transpose, or reduced by T' * K * T, is
#   enough.
# Why it matters: modal models take mass-normalised shapes for granted. All frequencies stay right, so
#   nothing looks wrong, and responses and losses of joints are off by the modal masses.
# A way to live with it: K = (K + K') / 2 and the same of M; and V' * M * V after each eig.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian octave=7.3.0-2

cat >modes.m <<'END'
K = [2 -1 0; -1 2 -1; 0 -1 1];
M = 2 * eye(3);
for factor = [1 1 + eps]
  K(1, 2) = -factor;
  [V, D] = eig(K, M);
  d = diag(D);
  printf("%d %.6f %.6f\n", issorted(d), min(diag(V' * M * V)), min(d));
end
END
mapfile -t lines < <(octave modes.m)
((${#lines[@]} == 2)) || fail "Octave does not run it: $(cat octave.log)"
[[ "${lines[0]}" == "1 1.000000 0.099031" ]] || fail "symmetric: sorted, modal mass, lowest are ${lines[0]}"
read -r sorted mass lowest <<<"${lines[1]}"
[[ "$lowest" == 0.099031 ]] || fail "the lowest eigenvalue is $lowest"
[[ "$sorted" == 0 ]] || fail "the eigenvalues are in ascending order"
holds "$mass > 2 && $mass < 5" "the modal mass is $mass"
seen "one last digit: the order is no longer ascending, the modal mass is $mass instead of 1"
