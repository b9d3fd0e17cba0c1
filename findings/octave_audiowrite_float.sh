#!/usr/bin/env bash
# GNU Octave 7.3.0 (octave 7.3.0-2): audiowrite of a recording in m/s^2 with 32 bits per sample.
#
# Guess: 32 bits of doubles are a WAV file of floating-point numbers, which keeps any value.
# Instead: the file has floating-point samples, and all of them are within 1: audiowrite clips at full scale, as for
#   integers, without a message. An acceleration of 5 m/s^2 is a flat top at 1. A file of the same form by another
#   program is read by audioread with its 5.
# Why it matters: WAV files of floating-point numbers are how recorders hand on engineering units. A clipped one
#   looks like an overloaded sensor, and its harmonics look like a joint that slips.
# A way to live with it: divide by the largest value and keep that in a file beside it; or a MAT file.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian octave=7.3.0-2 python3-scipy=1.10.1-2

cat >write.py <<'END'
import numpy as np
from scipy.io import wavfile

wavfile.write("other.wav", 1000, (5 * np.sin(2 * np.pi * np.arange(1000) / 40)).astype("float32"))
END
python3 write.py || fail "SciPy does not write"
cat >write.m <<'END'
audiowrite("record.wav", 5 * sin(2 * pi * (0:999)' / 40), 1000, "BitsPerSample", 32);
printf("%g %g\n", max(audioread("record.wav")), max(audioread("other.wav")));
END
read -r largest other < <(octave write.m) || fail "Octave does not run it: $(cat octave.log)"
! grep -q -i warning octave.log || fail "there is a warning: $(cat octave.log)"
code="$(od -A n -t u2 -j 20 -N 2 record.wav | tr -d ' ')"
[[ "$code" == 3 ]] || fail "the code of the format is $code, not 3 of floating-point numbers"
[[ "$other" == 5 ]] || fail "audioread clips, too"
[[ "$largest" == 1 ]] || fail "the largest sample is $largest"
seen "a sine of amplitude 5 in a WAV file of floating-point numbers has a largest sample of $largest"
