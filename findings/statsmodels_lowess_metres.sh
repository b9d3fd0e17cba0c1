#!/usr/bin/env bash
# statsmodels 0.13.5 (python3-statsmodels 0.13.5+dfsg-7): lowess of a frequency that falls with the amplitude, in Hz
#   over metres.
#
# Guess: as in millimetres. Weights depend on distances relative to the farthest neighbour, and lines through points
#   on no unit.
# Instead: the same to rounding for amplitudes up to 0.1 mm and more, and another curve for 10 um. Up to 1 um no lines
#   are fitted, but weighted means taken: of a straight fall by 25 Hz, without noise, 2.2 Hz are missing at the small
#   end. R's lowess depends on no unit. No message.
# Why it matters: it is how backbones are smoothed before softening is read off them, and slips are micrometres. What is
#   missing at the small end is the frequency of the joint that does not slip.
# A way to live with it: amplitudes divided by the largest one.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-statsmodels=0.13.5+dfsg-7 r-base-core=4.2.2.20221110-2

cat >backbone.py <<'END'
import numpy as np
from statsmodels.nonparametric.smoothers_lowess import lowess

relative = np.linspace(0.01, 1, 100)
frequency = 1000 - 25 * relative


def smoothed(unit):
    return lowess(frequency, unit * relative, frac=0.3, it=0, return_sorted=False)


errors = {unit: smoothed(unit) - frequency for unit in (1.0, 1e-3, 1e-4, 1e-5, 1e-6)}
for unit in (1.0, 1e-3, 1e-4):
    assert np.max(np.abs(errors[unit])) < 1e-9, f"an error of {np.max(np.abs(errors[unit]))} at {unit}"
near = relative[:30] - relative[0]
weights = (1 - (near / near[-1])**3)**3
mean = np.average(frequency[:30], weights=weights) - frequency[0]
print(f"errors at the smallest of amplitudes up to 0.1 mm: {errors[1e-4][0]:.0e} Hz, up to 10 um"
      f" {errors[1e-5][0]:.2f} Hz, up to 1 um {errors[1e-6][0]:.2f} Hz, by a weighted mean {mean:.2f} Hz")
assert errors[1e-5][0] < -1 and abs(errors[1e-6][0] / mean - 1) < 0.05
END
cat >backbone.R <<'END'
relative <- seq(0.01, 1, length.out = 100)
frequency <- 1000 - 25 * relative
cat(max(abs(lowess(1e-6 * relative, frequency, f = 0.3, iter = 0, delta = 0)$y - frequency)), "\n")
END
python3 backbone.py >backbone.txt 2>backbone.log || fail "it is another: $(cat backbone.txt; tail -n 1 backbone.log)"
read -r other < <(r backbone.R) || fail "R does not run it: $(cat r.log)"
holds "$other < 1e-9" "R's lowess has an error of $other Hz"
seen "$(cat backbone.txt), by R's lowess $other Hz at most"
