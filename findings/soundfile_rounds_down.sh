#!/usr/bin/env bash
# python3-soundfile 0.12.1-1 with libsndfile1 1.2.0: a recording of floating-point numbers is written as PCM_24 into
# WAV and into FLAC.
#
# Guess: both round to the nearest step of 24 bits, so that the two files hold the same numbers.
# Instead: WAV rounds down. Its samples are half a step lower in the mean, -1e-9 becomes a whole step, and silence with
#   noise far below a step is a square wave; FLAC of the same array is rounded to nearest.
# Why it matters: the same record has another mean by container, and an offset of half a step integrates to a drift of
#   velocity and displacement; null tests of two files of one recording fail.
# A way to live with it: subtype FLOAT, or rounding before the call: numpy.rint(x * 2**23) / 2**23.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-soundfile=0.12.1-1 python3-numpy=1:1.24.2-1+deb12u1

cat >write.py <<'END'
import numpy as np
import soundfile as sf

step = 2.0**-23
x = np.random.default_rng(3).uniform(-0.5, 0.5, 100_000)
x[:2] = -1e-9, 1e-9
means, smallest = [], []
for name in ("a.wav", "a.flac"):
    sf.write(name, x, 8000, subtype="PCM_24")
    read = sf.read(name)[0]
    means.append(np.mean(read - x) / step)
    smallest.append(read[0] / step)
print(*means, *smallest)
END
read -r wav flac low_wav low_flac < <(/usr/bin/python3 write.py)
holds "$wav < -0.48 && $wav > -0.52" "WAV is $wav steps off in the mean"
holds "$flac < 0.02 && $flac > -0.02" "FLAC is $flac steps off in the mean"
holds "$low_wav == -1 && $low_flac == 0" "-1e-9 became $low_wav steps in WAV and $low_flac in FLAC"
seen "WAV is $wav steps of 24 bits off in the mean, FLAC $flac; -1e-9 became $low_wav and $low_flac steps"
