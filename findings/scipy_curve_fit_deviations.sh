#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): the standard deviations that scipy.optimize.curve_fit reports of a stiffness in
# N/m and a slip in m, with bounds.
#
# Guess: those of any unit, and those without bounds, 1.5 % of the stiffness and 1.7 % of the slip for forces with 2 %
#   noise, as repeated fits scatter. The documentation has a pseudo-inverse for Jacobians without full rank; the rank of
#   this one is full.
# Instead: the stiffness has a standard deviation of 2e-32 of itself, and the slip a fifth of its own. The columns of
#   the Jacobian differ by the units, 5e7 / 1e-7, so the pseudo-inverse takes the smaller one for rounding and drops it,
#   and with it the correlation. No warning. So it is with method="trf" without bounds, and with x_scale.
# Why it matters: stiffness and slip of a joint in SI are 14 powers of ten apart, and "not negative" is the bound that
#   everyone gives. Joints that are equal come out as different by many standard deviations.
# A way to live with it: micrometres; or the logarithms of the parameters; or no bounds. A standard deviation of nearly
#   0 gives it away; that of the other parameter does not.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >fit.py <<'END'
import warnings

import numpy as np
from scipy.optimize import curve_fit

warnings.simplefilter("error")
stiffness, slip = 5e7, 1e-7
displacements = np.linspace(0.1, 6, 60) * slip
random = np.random.default_rng(1)


def force(displacement, stiffness, slip):
    return stiffness * slip * (1 - np.exp(-displacement / slip))


deviation = 0.02 * stiffness * slip


def fits(unit, **options):
    """Scatter and reported standard deviations of 100 fits, in the units given, as parts of the parameters."""
    truth = np.array([stiffness * unit, slip / unit])
    found = []
    for _ in range(100):
        forces = force(displacements, stiffness, slip) + deviation * random.standard_normal(displacements.size)
        values, covariance = curve_fit(force, displacements / unit, forces, truth * [1.1, 0.9], absolute_sigma=True,
                                       sigma=np.full(forces.size, deviation), **options)
        found.append([values / truth, np.sqrt(np.diag(covariance)) / truth])
    values, reported = np.swapaxes(found, 0, 1)
    return np.std(values, axis=0), np.median(reported, axis=0)


bounds = {"bounds": (0, np.inf)}
cases = {"free": fits(1), "bounds": fits(1, **bounds), "x_scale": fits(1, x_scale=(5e7, 1e-7), **bounds),
         "micrometres": fits(1e-6, **bounds)}
print("; ".join(f"{name}: scatter {scatter[0]:.3f} and {scatter[1]:.3f}, reported {reported[0]:.2g} and"
                f" {reported[1]:.2g}" for name, (scatter, reported) in cases.items()))
for name, (scatter, reported) in cases.items():
    ratios = reported / scatter
    if name in ("bounds", "x_scale"):
        assert ratios[0] < 1e-6 and ratios[1] < 0.3, name
    else:
        assert np.all((ratios > 0.8) & (ratios < 1.25)), name
END
python3 fit.py >fit.txt 2>fit.log || fail "the standard deviations are others: $(cat fit.txt; tail -n 1 fit.log)"
seen "$(cat fit.txt)"
