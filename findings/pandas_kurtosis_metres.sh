#!/usr/bin/env bash
# pandas 1.5.3 (python3-pandas 1.5.3+dfsg-2): kurtosis and skewness of a displacement in metres, noise of 0.1 um or 10
#   nm with an impact every 500 samples.
#
# Guess: Series.kurt, Series.skew and their rolling forms are the same in m, in mm and in um, as is everything else
#   about these two numbers.
# Instead: a kurtosis of 26 is 0 at 10 nm, and a skewness of 2.5 is 0 at 0.1 um; the rolling ones are NaN at 10 nm.
#   Sums of powers below 1e-14 are taken for 0, and so is the result, which is the kurtosis of Gaussian noise. The
#   number of samples decides as well: of 10 000 samples of 0.1 um the kurtosis is 26, and of the first 1000 it is 0. No
#   message.
# Why it matters: kurtosis is how rattle and loss of preload are found in a recording, and displacements by laser are in
#   metres. The joint that rattles looks like noise, and one channel does while another, larger one, does not.
# A way to live with it: divide by the standard deviation first; or scipy.stats.kurtosis and skew.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-pandas=1.5.3+dfsg-2 python3-scipy=1.10.1-2

cat >rattle.py <<'END'
import numpy as np
import pandas as pd
from scipy import stats

rattle = np.random.default_rng(0).standard_normal(10000)
rattle[::500] += 12


def numbers(unit):
    """Kurtosis of all and of 1000 samples, skewness, rolling kurtosis: by pandas, and the first and third by SciPy."""
    series = pd.Series(unit * rattle)
    found = [series.kurt(), series[:1000].kurt(), series.skew(), series.rolling(1000).kurt().iloc[-1]]
    return found, [stats.kurtosis(unit * rattle, bias=False), stats.skew(unit * rattle, bias=False)]


right, other = numbers(1.0)
assert abs(right[0] / other[0] - 1) < 1e-9 and abs(right[2] / other[1] - 1) < 1e-9
assert right[0] > 25 and right[1] > 20 and right[2] > 2 and right[3] > 20
for unit in (1e-7, 1e-8):
    assert np.allclose(numbers(unit)[1], other, rtol=1e-9, atol=0), "SciPy depends on the unit"
(whole, short, skewed, rolling), (least, _, least_skewed, least_rolling) = numbers(1e-7)[0], numbers(1e-8)[0]
print(f"kurtosis {right[0]:.1f} is {whole:.1f} at 0.1 um and {least:.1f} at 10 nm, of 1000 samples {right[1]:.1f} is"
      f" {short:.1f} at 0.1 um; skewness {right[2]:.2f} is {skewed:.2f} and {least_skewed:.2f}; rolling kurtosis"
      f" {right[3]:.1f} is {rolling:.1f} and {least_rolling}")
assert abs(whole / right[0] - 1) < 1e-9 and least == 0 and short == 0
assert skewed == 0 and least_skewed == 0 and np.isnan(least_rolling)
END
python3 rattle.py >rattle.txt 2>rattle.log || fail "they are others: $(cat rattle.txt; tail -n 1 rattle.log)"
seen "$(cat rattle.txt)"
