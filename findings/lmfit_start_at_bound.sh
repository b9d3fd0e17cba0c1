#!/usr/bin/env bash
# lmfit 1.1.0 (python3-lmfit 1.1.0-1): a parameter that starts at its bound.
#
# Guess: a coefficient of friction that must not be negative (min=0) and starts at 0 grows as the data ask; a bound is
#   something that a search stays within.
# Instead: it stays at 0, the others take up what they can, and the result is "Fit succeeded": a bounded parameter is a
#   function of a free one whose derivative is 0 at the bound, so the residuals do not depend on it there. So it is with
#   leastsq, which is the default, L-BFGS-B, BFGS and SLSQP. With both bounds, and the start at the upper one, the
#   other parameter does not move, either, and both have standard deviations of 1e-10. From 1e-6 the fit is right. The
#   page on bounds has the functions, and a warning of uncertainties near bounds, but nothing of starts.
# Why it matters: "start without friction and let the data add it" is the natural start, and a friction of exactly 0 is
#   reported as what the data say. The stiffness beside it is wrong by a factor of 2.
# A way to live with it: start within the bounds, by a thousandth of the expected value; method="least_squares", which
#   has bounds of its own; and look for values that equal their start.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-lmfit=1.1.0-1

cat >fit.py <<'END'
import warnings

warnings.simplefilter("ignore")

import lmfit
import numpy as np

amplitudes = np.linspace(0, 5, 100)
losses = 3 * amplitudes + 0.8 * amplitudes**2 + 0.01 * np.random.default_rng(0).standard_normal(amplitudes.size)


def fit(start, upper=np.inf, method="leastsq"):
    parameters = lmfit.Parameters()
    parameters.add("viscous", 1.0)
    parameters.add("friction", start, min=0, max=upper)
    result = lmfit.minimize(lambda p: p["viscous"] * amplitudes + p["friction"] * amplitudes**2 - losses, parameters,
                            method=method)
    assert result.success
    return result.params["viscous"].value, result.params["friction"].value, result.params["friction"].stderr


stuck = {method: fit(0.0, method=method) for method in ("leastsq", "lbfgsb", "bfgs", "slsqp")}
within, other, upper = fit(1e-6), fit(0.0, method="least_squares"), fit(1.0, upper=1.0)
print("viscous 3 and friction 0.8: from 0", *(f"{method} {v:.3g} and {f:.3g}," for method, (v, f, _) in stuck.items()),
      f"from 1e-6 {within[0]:.3f} and {within[1]:.3f}; from 1 with max=1 {upper[0]:.3g} and {upper[1]:.3g}"
      f" +- {upper[2]:.0e}")
assert all(f < 1e-9 and v > 5 for v, f, _ in stuck.values())
assert all(abs(v - 3) < 0.01 and abs(f - 0.8) < 0.01 for v, f, _ in (within, other))
assert upper[:2] == (1.0, 1.0) and upper[2] < 1e-6
END
python3 fit.py >fit.txt 2>fit.log || fail "a start at the bound gives something else: $(cat fit.txt; tail -n 1 fit.log)"
seen "$(cat fit.txt)"
