#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): scipy.optimize.curve_fit of losses in joule, with and without bounds.
#
# Guess: bounds that are far from the solution change nothing; the fit does not depend on the unit of the losses.
# Instead: with bounds curve_fit changes from MINPACK to another method, which ends where the gradient of the sum of
#   squares is below 1e-8 in whatever unit the data have. For losses of some microjoule that is so at the start: one
#   evaluation, success, and the start is returned as the result, with standard deviations. Without bounds, or in
#   microjoule, the fit is right.
# Why it matters: losses of a joint are 1e-9 to 1e-3 J and its displacements micrometres, both in SI; bounds such as
#   "a power between 2 and 3" are what one adds at the end. The result looks like a fit.
# A way to live with it: give sigma, which makes the residuals numbers of standard deviations; or scale the data; or
#   gtol=None. That nfev is 1 (full_output) gives it away.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >fit.py <<'END'
import numpy as np
from scipy.optimize import curve_fit

amplitudes = np.geomspace(1e-7, 5e-6, 20)
noise = 1 + 0.02 * np.random.default_rng(1).standard_normal(amplitudes.size)


def loss(amplitude, at_one_micrometre, power):
    return at_one_micrometre * (amplitude / 1e-6) ** power


def power_of(unit, **options):
    losses = loss(amplitudes, 1e-6 / unit, 2.4) * noise
    start = (losses[-1] / 25, 2.0)
    found, _, info, _, status = curve_fit(loss, amplitudes, losses, start, full_output=True, **options)
    return found[1], info["nfev"], status


bounds = ([0, 1], [np.inf, 4])
free, in_joule, in_microjoule = power_of(1), power_of(1, bounds=bounds), power_of(1e-6, bounds=bounds)
print(f"power 2.4: free {free[0]:.3f}, with bounds {in_joule[0]:.3f} (nfev {in_joule[1]}, status {in_joule[2]}),"
      f" in microjoule {in_microjoule[0]:.3f}")
assert abs(free[0] - 2.4) < 0.05 and abs(in_microjoule[0] - free[0]) < 1e-3
assert in_joule == (2.0, 1, 1)
END
python3 fit.py >fit.txt || fail "bounds change the fit in another way: $(cat fit.txt)"
seen "$(cat fit.txt)"
