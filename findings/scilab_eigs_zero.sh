#!/usr/bin/env bash
# Scilab 6.1.1 (scilab-cli 6.1.1+dfsg2-6): eigs(K, M, k, 0), the lowest modes of a chain.
#
# Guess: the lowest modes. The help has "SM", the smallest in magnitude, as the same as 0.
# Instead: the k largest, as if nothing had been given, in ascending order, normalised to the mass, and with residuals
#   of rounding errors. 1e-9 and "SM" give the lowest.
# Why it matters: scripts for MATLAB and Octave say 0, and get the lowest modes there. What comes back here passes every
#   check of modes, and is the upper end of the mesh: a reduced model without any mode of the test.
# A way to live with it: "SM", or a small shift that is not 0.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian scilab-cli=6.1.1+dfsg2-6

cat >modes.sce <<'END'
n = 40;
K = toeplitz([2 -1 zeros(1, n - 2)]);
M = diag(2 + (1:n) / n);
values = gsort(real(spec(K, M)), "g", "i");
sigmas = list(0, 1e-9, "SM");
for i = 1:3
  [d, v] = eigs(sparse(K), sparse(M), 4, sigmas(i));
  mprintf("seen %.3e %.3e %.1e %.1e\n", norm(diag(d) - values(1:4)) / norm(values(1:4)), ..
          norm(gsort(diag(d), "g", "i") - values($-3:$)) / norm(values($-3:$)), norm(K * v - M * v * d), ..
          norm(v' * M * v - eye(4, 4)));
end
exit
END
mapfile -t lines < <(scilab modes.sce)
((${#lines[@]} == 3)) || fail "Scilab does not run it: $(tail -n 3 scilab.log)"
read -r lowest largest residual mass <<<"${lines[0]}"
read -r near _ <<<"${lines[1]}"
read -r smallest _ <<<"${lines[2]}"
! grep -q -i warning scilab.log || fail "there is a warning: $(grep -i warning scilab.log)"
holds "$near < 1e-8 && $smallest < 1e-8" "with 1e-9 and SM the lowest are wrong by $near and $smallest"
holds "$residual < 1e-10 && $mass < 1e-10" "the residual is $residual, the modal mass off by $mass"
holds "$lowest > 10 && $largest < 1e-10" "with 0 the distance to the lowest is $lowest, to the largest $largest"
seen "with 0 the relative distance to the 4 lowest is $lowest, to the 4 largest $largest; with 1e-9 and SM to the" \
  "lowest $near and $smallest"
