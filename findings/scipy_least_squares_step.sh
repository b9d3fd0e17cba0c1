#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): scipy.optimize.least_squares of a softening spring in SI, with 2 % noise and
# x_scale="jac".
#
# Guess: derivatives are taken with relative steps; the documentation has "x * diff_step", diff_step by default a power
#   of the machine's accuracy. A length of 1e-9 m gets a step of 1.5e-17 m, and the result is that of other units.
# Instead: by default the step is 1.5e-8 for every parameter that is smaller than 1, whatever x_scale says: 15 times the
#   length itself. The fit ends with success at twice the sum of squares, 5 % off; from another start it is right, with
#   a Jacobian that makes the standard deviation of the length 22 times what it is. At 5e-9 m the value is right and the
#   deviation 3 times too large. With diff_step=1.5e-8, the default in the documented formula, both are right.
# Why it matters: lengths over which joints slip are 1e-9 to 1e-6 m. x_scale is what the documentation advises for
#   parameters of several units, and it does not reach the steps.
# A way to live with it: diff_step=1.5e-8; or parameters near 1; or their logarithms; or method="lm" for the values.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >fit.py <<'END'
import numpy as np
from scipy.optimize import least_squares


def force(parameters, displacement):
    stiffness, length = parameters
    return stiffness * displacement / length / (1 + (displacement / length)**1.3) * 1e-9


def fit(length, start, **options):
    """Length and its standard deviation as parts of the length, sum of squares, and the second point it looks at."""
    truth = np.array([5e7, length])
    displacements = np.linspace(0.1, 6, 60) * length
    forces = force(truth, displacements)
    deviation = 0.02 * np.max(forces)
    forces = forces + deviation * np.random.default_rng(1).standard_normal(forces.size)
    points = []

    def residuals(parameters):
        points.append(parameters[1] / length)
        return (force(parameters, displacements) - forces) / deviation

    result = least_squares(residuals, truth * [1, start], x_scale="jac", **options)
    assert result.success
    scaled = result.jac * truth
    return (result.x[1] / length, np.sqrt(np.linalg.inv(scaled.T @ scaled)[1, 1]), 2 * result.cost,
            max(abs(point - start) for point in points[1:3]))


results = {(length, start, step): fit(length, start, **({"diff_step": 1.5e-8} if step else {}))
           for length in (1e-9, 5e-9) for start in (0.7, 1.4) for step in (False, True)}
print("; ".join(f"{length:g} m from {start} of it, {'relative' if step else 'default'} step {values[3]:.2g}:"
                f" {values[0]:.3f} +- {values[1]:.3f}, sum {values[2]:.1f}"
                for (length, start, step), values in results.items() if start < 1))
for (length, start, step), (value, deviation, total, first_step) in results.items():
    right = results[length, start, True]
    if step:
        assert abs(value - 1) < 0.02 and 0.01 < deviation < 0.02 and first_step < 1e-6, (length, start)
    else:
        assert abs(first_step * length / 1.49e-8 - 1) < 0.01, (length, start)
        assert deviation > (15 if length < 2e-9 else 2.5) * right[1], (length, start)
assert results[1e-9, 0.7, False][2] > 1.5 * results[1e-9, 0.7, True][2]
END
python3 fit.py >fit.txt 2>fit.log || fail "the steps are others: $(cat fit.txt; tail -n 1 fit.log)"
seen "$(cat fit.txt)"
