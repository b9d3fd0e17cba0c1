#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2): scipy.signal.correlate of recordings of 16-bit integers.
#
# Guess: the sums of products are kept in a type that holds them, as the other functions of scipy.signal do: decimate,
#   resample, sosfilt and detrend give floating-point numbers. The maximum is at the delay.
# Instead: the result has 16 bits, too, and the sums wrap around. A delay of 37 samples between two recordings, one a
#   copy of the other, is found as -1597, since the peak is an arbitrary number; by the method "direct" without a word.
# Why it matters: the delay of a second recorder, or of a wave, is found by this call on what
#   scipy.io.wavfile.read returns, and that is int16 for a WAV file of 16 bits. Any lag is plausible.
# A way to live with it: recordings.astype(float) first.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2

cat >delay.py <<'END'
import io
import warnings

import numpy as np
from scipy import signal
from scipy.io import wavfile

warnings.simplefilter("ignore")
first = (3000 * np.random.default_rng(3).standard_normal(6000)).astype("int16")
recordings = np.column_stack([first, np.roll(first, 37)])
file = io.BytesIO()
wavfile.write(file, 48000, recordings)
_, recordings = wavfile.read(file)


def lag_of(first, second, method):
    sums = signal.correlate(second, first, method=method)
    lags = signal.correlation_lags(second.size, first.size)
    return int(lags[np.argmax(sums)]), sums.dtype.name


def lags_of(recordings):
    return [lag_of(recordings[:, 0], recordings[:, 1], method) for method in ("auto", "direct", "fft")]


print(f"delay 37: int16 {lags_of(recordings)}, float {lags_of(recordings.astype(float))}")
assert all(lag == 37 for lag, _ in lags_of(recordings.astype(float)))
assert all(lag != 37 and name == "int16" for lag, name in lags_of(recordings))
END
python3 delay.py >delay.txt || fail "integers are correlated otherwise: $(cat delay.txt)"
seen "$(cat delay.txt)"
