#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): cov_beta and sd_beta of scipy.odr, a fit of losses to amplitudes that both have
# known standard deviations.
#
# Guess: the documentation has "standard deviations" and "covariance matrix of the estimated parameters", so sd_beta is
#   the root of the diagonal of cov_beta.
# Instead: sd_beta has the factor sqrt(res_var), cov_beta has not. They agree only where residuals are as large as was
#   said; with standard deviations that were taken 4 times too large, the one is a quarter of the other. So one of them
#   believes the standard deviations that were given, and the other, like curve_fit by default, their ratios only.
# Why it matters: amplitudes as well as losses of joints are measured, which is what ODR is for. cov_beta is needed for
#   bands of a prediction or ratios of parameters; errors that are printed are sd_beta. They contradict each other.
# A way to live with it: cov_beta where the standard deviations are known; cov_beta * res_var where they are not; never
#   sd_beta in one table with cov_beta.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >fit.py <<'END'
import numpy as np
from scipy import odr

random = np.random.default_rng(0)
amplitudes = np.linspace(1, 5, 200)
losses = 2 * amplitudes**2.4


def fit(stated):
    """Roots of the diagonal of cov_beta, and sd_beta, of noise of 1 % in both and standard deviations as stated."""
    noisy = amplitudes * (1 + 0.01 * random.standard_normal(200)), losses * (1 + 0.01 * random.standard_normal(200))
    data = odr.RealData(*noisy, sx=stated * amplitudes, sy=stated * losses)
    result = odr.ODR(data, odr.Model(lambda b, x: b[0] * x**b[1]), beta0=[1, 2]).run()
    assert result.info < 4 and abs(result.beta[1] - 2.4) < 0.02
    return np.sqrt(np.diag(result.cov_beta)), result.sd_beta, result.res_var


exact, fourfold = fit(0.01), fit(0.04)
print(f"power: from cov_beta {exact[0][1]:.4f}, sd_beta {exact[1][1]:.4f}; with standard deviations 4 times as large"
      f" {fourfold[0][1]:.4f} and {fourfold[1][1]:.4f}")
assert np.allclose(exact[0] / exact[1], 1, atol=0.15)
for covariance, deviation, variance in (exact, fourfold):
    assert np.allclose(deviation / covariance, np.sqrt(variance), rtol=1e-6)
assert np.all(fourfold[0] / fourfold[1] > 3.4)
END
python3 fit.py >fit.txt 2>fit.log || fail "sd_beta and cov_beta agree: $(cat fit.txt; tail -n 1 fit.log)"
seen "$(cat fit.txt)"
