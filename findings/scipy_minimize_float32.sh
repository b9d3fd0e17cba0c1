#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): scipy.optimize.minimize of the misfit to a recording of 32-bit numbers.
#
# Guess: the fit is right to some 6 digits, as least_squares and curve_fit of the same recording are.
# Instead: the start is returned, "Optimization terminated successfully": BFGS, L-BFGS-B and SLSQP take a step of 1.5e-8
#   for their derivative, whatever the type, and residuals of 32 bits do not change by it. The gradient is exactly 0,
#   also if they are summed in 64 bits. Nelder-Mead finds frequency and damping. least_squares looks at the type for
#   its step, minimize does not; the pages of its methods give the step, and nothing of types.
# Why it matters: WAV, TDMS and HDF5 files of recorders are 32-bit, and NumPy keeps 32 bits when only they and Python's
#   own numbers meet. A frequency and a damping that were typed in as a start are reported as identified.
# A way to live with it: recording.astype(float) first, and the same for the times. nit of the result, 0 or 1, gives it
#   away.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >fit.py <<'END'
import numpy as np
from scipy.optimize import least_squares, minimize

times = (np.arange(4000) / 4000).astype("float32")
recording = (np.exp(-3 * times) * np.sin(2 * np.pi * 30 * times)).astype("float32")
start = [4.0, 30.1]


def residuals(parameters, times, recording):
    decay, frequency = parameters
    return np.exp(-decay * times) * np.sin(2 * np.pi * frequency * times) - recording


def fit(method, *data):
    return minimize(lambda parameters: np.sum(residuals(parameters, *data)**2), start, method=method)


assert residuals(start, times, recording).dtype == np.float32
results = {method: fit(method, times, recording) for method in ("BFGS", "L-BFGS-B", "SLSQP", "Nelder-Mead")}
double = fit("BFGS", times.astype(float), recording.astype(float))
squares = least_squares(residuals, start, args=(times, recording))
print("decay 3/s and 30 Hz:", *(f"{method} {r.x[0]:.4f} and {r.x[1]:.4f}," for method, r in results.items()),
      f"least_squares {squares.x[0]:.4f} and {squares.x[1]:.4f}; in 64 bits BFGS {double.x[0]:.4f} and"
      f" {double.x[1]:.4f}")
for method in ("BFGS", "L-BFGS-B", "SLSQP"):
    assert results[method].success and np.all(results[method].x == start) and results[method].nit < 2, method
for right in (results["Nelder-Mead"], squares, double):
    assert np.allclose(right.x, [3, 30], atol=1e-3)
END
python3 fit.py >fit.txt 2>fit.log || fail "32-bit numbers are fitted otherwise: $(cat fit.txt; tail -n 1 fit.log)"
seen "$(cat fit.txt)"
