#!/usr/bin/env bash
# xarray 2023.01.0 (python3-xarray 2023.01.0-1.1): the difference of two recordings, whose times are n * dt in one and
# n / rate in the other.
#
# Guess: arrays of the same length are subtracted sample by sample; or there is an error, since the times differ.
# Instead: samples whose times differ in the last digit are left out of the result, without a message: of 5000 samples
#   4340 are left at 51.2 kHz, 3914 at 48 kHz and 3376 at 10 kHz, with steps of 1 to 5 sampling intervals; at 8192 Hz,
#   where 1 / rate is exact, all are. The documentation has arithmetic align by labels with an inner join; it does not
#   say what that does to numbers that were computed in two ways.
# Why it matters: residuals, differences to a reference and products for power (force times velocity) are formed this
#   way, as are spectra of them, for which the samples that are left look evenly spaced. Energies lose a third.
# A way to live with it: xarray.set_options(arithmetic_join="exact"), which raises an error instead; or one time axis
#   for all channels.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-xarray=2023.01.0-1.1

cat >power.py <<'END'
import warnings

import numpy as np
import xarray as xr

warnings.simplefilter("error", RuntimeWarning)
index = np.arange(5000)


def kept(rate):
    step = 1 / rate
    force = xr.DataArray(np.ones(index.size), dims="time", coords={"time": index * step})
    velocity = xr.DataArray(np.ones(index.size), dims="time", coords={"time": index / rate})
    assert np.max(np.abs(force.time.values - velocity.time.values)) < 1e-15
    power = force * velocity
    try:
        with xr.set_options(arithmetic_join="exact"):
            force * velocity
        exact = True
    except ValueError:
        exact = False
    return power.size, int(np.round(np.max(np.diff(power.time)) * rate)), exact


results = {rate: kept(rate) for rate in (8192, 10000, 48000, 51200)}
print("; ".join(f"at {rate} Hz {size} of 5000 samples, steps up to {gap}"
                for rate, (size, gap, _) in results.items()))
assert results[8192] == (5000, 1, True)
assert all(3000 < results[rate][0] < 4500 and results[rate][1] > 2 and not results[rate][2]
           for rate in (10000, 48000, 51200))
END
python3 power.py >power.txt 2>power.log || fail "other samples are kept: $(cat power.txt power.log)"
seen "$(cat power.txt)"
