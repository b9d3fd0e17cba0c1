#!/usr/bin/env bash
# Scilab 6.1.1 (scilab-cli 6.1.1+dfsg2-6): csim of an oscillator with a recorded shock as its input.
#
# Guess: an input that is given at its samples is interpolated between them, and the response is that of MATLAB's lsim
#   to some digits.
# Instead: where some samples of 0 come before a half-sine of 10 ms (record of 0.5 s at 1 kHz, oscillator of 50 Hz and
#   2 % damping) the response is 0 at each sample, without a message. A shock at the first sample is right, and so is
#   the late one once noise of 1e-9 of it is in the record.
# Why it matters: a shock record has a pre-trigger of zeros, and a synthetic one exactly so; the shock response of all
#   oscillators is then 0, or that of some of them.
# A way to live with it: dscr() and flts(), which are exact for a held input; or begin at the shock.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian scilab-cli=6.1.1+dfsg2-6

cat >shock.sce <<'END'
omega = 2 * %pi * 50;
oscillator = syslin("c", [0 1; -omega^2 -2 * 0.02 * omega], [0; 1], [1 0]);
held = dscr(oscillator, 1e-3);
t = 0:1e-3:0.5;
rand("seed", 1);
noise = 1e-9 * rand(t, "normal");
for start = [0 0.005 0.1]
  shock = zeros(t);
  on = find(t >= start - 1e-9 & t <= start + 0.0101);
  shock(on) = sin(%pi * (t(on) - start) / 0.01);
  mprintf("seen %.4e %.4e %.4e\n", max(abs(csim(shock, t, oscillator))), max(abs(csim(shock + noise, t, oscillator))), ..
          max(abs(flts(shock, held))));
end
exit
END
mapfile -t lines < <(scilab shock.sce)
((${#lines[@]} == 3)) || fail "Scilab does not run it: $(tail -n 3 scilab.log)"
! grep -q -i warning scilab.log || fail "there is a warning: $(grep -i warning scilab.log)"
for i in 0 1 2; do
  read -r clean noisy exact <<<"${lines[i]}"
  holds "($noisy / $exact - 1)^2 < 0.01" "with noise the peak is $noisy, held $exact"
  if ((i == 0)); then
    holds "($clean / $exact - 1)^2 < 0.01" "of a shock at the first sample the peak is $clean"
  else
    holds "$clean == 0" "of a shock after zeros the peak is $clean"
  fi
done
seen "peaks of a shock after 100 ms: csim $clean, with noise of 1e-9 $noisy, flts $exact"
