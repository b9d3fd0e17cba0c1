#!/usr/bin/env bash
# scikit-learn 1.2.1 (python3-sklearn 1.2.1+dfsg-1): IsotonicRegression of the loss per cycle over the amplitude, 40
#   amplitudes from 0.05 to 1 um in metres, as 32-bit numbers.
#
# Guess: the loss at every amplitude, since losses without noise ascend: the same as of 64-bit numbers within 1e-6.
# Instead: one loss for all 40 amplitudes, their mean, 500 times the loss at the smallest. In 64 bits all are right, and
#   in 32 bits in um. In 32 bits amplitudes less than 1e-6 apart are one, in whatever unit; of 40 up to 10 um three are
#   merged. No message.
# Why it matters: losses ascend with amplitude whatever the joint is, so isotonic regression is a fit that assumes no
#   model. Recorders store 32 bits, and a slip is below 1 um in metres. What comes out is a joint whose loss does not
#   depend on the amplitude.
# A way to live with it: 64 bits, or amplitudes divided by the largest one.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-sklearn=1.2.1+dfsg-1

cat >losses.py <<'END'
import numpy as np
from sklearn.isotonic import IsotonicRegression

relative = np.linspace(0.05, 1, 40)
loss = relative**2.5


def fitted(scale, kind):
    """The largest error in parts of the largest loss, and how many losses there are."""
    amplitude = (scale * relative).astype(kind)
    found = IsotonicRegression().fit_transform(amplitude, loss.astype(kind))
    return np.max(np.abs(found - loss)), len(np.unique(found)), found


double, count_double, _ = fitted(1e-6, "f8")
single, count, found = fitted(1e-6, "f4")
larger, count_larger, _ = fitted(1e-5, "f4")
micrometres, count_micrometres, _ = fitted(1.0, "f4")
smallest = found[0] / loss[0]
print(f"losses at 40 amplitudes up to 1 um: {count_double} in 64 bits, {count} in 32 bits with an error of"
      f" {single:.2f} and {smallest:.0f} times the smallest; up to 10 um {count_larger}; in um"
      f" {count_micrometres} with an error of {micrometres:.0e}")
assert double < 1e-12 and count_double == 40
assert single > 0.6 and count == 1 and smallest > 500
assert count_larger == 37
assert micrometres < 1e-6 and count_micrometres == 40
END
python3 losses.py >losses.txt 2>losses.log || fail "losses are others: $(cat losses.txt; tail -n 1 losses.log)"
seen "$(cat losses.txt)"
